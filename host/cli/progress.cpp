#include "cli/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

#include "base/number_text.h"
#include "base/stopwatch.h"

namespace calotype {
namespace {

constexpr std::chrono::milliseconds kBarInterval(100);
constexpr std::chrono::seconds kLineInterval(10);
constexpr std::chrono::seconds kQuietStart(1); ///< before loading and building are shown

std::string bar(double done) {
    constexpr int kWidth = 24;
    const int filled = static_cast<int>(std::floor(kWidth * std::clamp(done, 0.0, 1.0)));
    return '[' + std::string(filled, '#') + std::string(kWidth - filled, '.') + ']';
}

} // namespace

Progress::Progress(bool quiet, const RenderPlan& plan)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), plan_(plan) {}

Progress::~Progress() { clear(); }

bool Progress::isDue() {
    const Clock::time_point now = Clock::now();
    if (quiet_ || now - lastShown_ < (terminal_ ? Clock::duration(kBarInterval) : kLineInterval))
        return false;
    lastShown_ = now;
    return true;
}

void Progress::show(double done, const std::string& text) {
    const int percent = static_cast<int>(100.0 * std::clamp(done, 0.0, 1.0));
    if (terminal_)
        std::fprintf(stderr, "\r\033[K%s %3d %%  %s", bar(done).c_str(), percent, text.c_str());
    else
        std::fprintf(stderr, "%3d %%  %s\n", percent, text.c_str());
    std::fflush(stderr);
    barShown_ = terminal_;
}

void Progress::step(const std::string& what, double done) {
    if (Clock::now() - start_ > kQuietStart && isDue())
        show(done, what);
}

void Progress::rendering(const RenderTotals& totals) {
    if (!isDue())
        return;
    const double elapsed = secondsSince(start_);
    const auto paths = static_cast<double>(totals.paths);
    const double done = shareDone(plan_, totals, elapsed);
    std::string text = std::to_string(totals.samplesPerPixel);
    if (plan_.samplesPerPixel)
        text.append("/").append(std::to_string(*plan_.samplesPerPixel));
    text += " spp  ";
    if (totals.error)
        text += "error " + percentText(totals.error->relative) +
                (totals.error->doubt && !totals.error->isTrusted() ? " (doubtful)  " : "  ");
    text += withPrefix(paths / totals.seconds) + " samples/s  " +
            withPrefix(static_cast<double>(totals.rays) / totals.seconds) + " rays/s  " +
            durationText(elapsed) + " elapsed";
    if (done > 0.0)
        text += ", " + durationText(elapsed * (1.0 - done) / done) + " left";
    show(done, text);
}

void Progress::clear() {
    if (barShown_)
        std::fprintf(stderr, "\r\033[K");
    barShown_ = false;
}

} // namespace calotype
