#include "cli/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/number_text.h"
#include "base/stopwatch.h"
#include "cli/terminal.h"

namespace calotype {
namespace {

constexpr std::chrono::milliseconds kBarInterval(100);
constexpr std::chrono::seconds kLineInterval(10);
constexpr std::chrono::seconds kQuietStart(1); ///< before loading and building are shown
constexpr size_t kLongestLine = 1000;          ///< where there is no terminal

/// Which parts of a line a narrow terminal lacks first.
enum Rank : int { kPercent, kSamples, kBar, kLeft, kError, kElapsed, kSampleRate, kRayRate };

std::string bar(double done) {
    constexpr int kWidth = 12;
    const int filled = static_cast<int>(std::floor(kWidth * std::clamp(done, 0.0, 1.0)));
    return '[' + std::string(filled, '#') + std::string(kWidth - filled, '.') + ']';
}

std::string percentDone(double done) {
    std::string percent = std::to_string(static_cast<int>(100.0 * std::clamp(done, 0.0, 1.0)));
    return std::string(3 - percent.size(), ' ') + percent + " %";
}

} // namespace

Progress::Progress(bool quiet, const RenderPlan& plan)
    : quiet_(quiet), redraws_(canRedrawLines()), plan_(plan) {}

Progress::~Progress() { clear(); }

bool Progress::isDue() {
    const Clock::time_point now = Clock::now();
    if (quiet_ || now - lastShown_ < (redraws_ ? Clock::duration(kBarInterval) : kLineInterval))
        return false;
    lastShown_ = now;
    return true;
}

void Progress::show(double done, std::vector<LinePart> parts) {
    parts.insert(parts.begin(), {percentDone(done), kPercent});
    if (redraws_) {
        parts.insert(parts.begin(), {bar(done), kBar});
        // The last column stays free: some terminals begin the next line there.
        const size_t columns = std::max<size_t>(terminalColumns(), 2) - 1;
        std::fprintf(stderr, "\r\033[K%s", fittedLine(std::move(parts), columns).c_str());
    } else {
        std::fprintf(stderr, "%s\n", fittedLine(std::move(parts), kLongestLine).c_str());
    }
    std::fflush(stderr);
    barShown_ = redraws_;
}

void Progress::step(const std::string& what, double done) {
    if (Clock::now() - start_ > kQuietStart && isDue())
        show(done, {{what, kSamples}});
}

void Progress::rendering(const RenderTotals& totals) {
    if (!isDue())
        return;
    const double elapsed = secondsSince(start_);
    const auto paths = static_cast<double>(totals.paths);
    const double done = shareDone(plan_, totals, elapsed);
    std::string samples = std::to_string(totals.samplesPerPixel);
    if (plan_.samplesPerPixel)
        samples.append("/").append(std::to_string(*plan_.samplesPerPixel));
    std::string error;
    if (totals.error)
        error = "error " + percentText(totals.error->relative) +
                (totals.error->doubt && !totals.error->isTrusted() ? " (doubtful)" : "");
    show(done,
         {{samples + " spp", kSamples},
          {error, kError},
          {withPrefix(paths / totals.seconds) + " samples/s", kSampleRate},
          {withPrefix(static_cast<double>(totals.rays) / totals.seconds) + " rays/s", kRayRate},
          {durationText(elapsed) + " elapsed", kElapsed},
          {done > 0.0 ? durationText(elapsed * (1.0 - done) / done) + " left" : "", kLeft}});
}

void Progress::clear() {
    if (barShown_)
        std::fprintf(stderr, "\r\033[K");
    barShown_ = false;
}

} // namespace calotype
