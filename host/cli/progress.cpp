#include "cli/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "base/stopwatch.h"
#include "cli/terminal.h"
#include "cli/trust_text.h"
#include "engine/json_document.h"
#include "engine/statistics.h"

namespace calotype {
namespace {

using Json = nlohmann::ordered_json;

using Duration = std::chrono::steady_clock::duration;

constexpr Duration kBarInterval = std::chrono::milliseconds(100);
constexpr Duration kJsonInterval = std::chrono::milliseconds(500);
constexpr Duration kLineInterval = std::chrono::seconds(10);
constexpr const char* kRendering = "rendering";
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

Progress::Progress(ProgressStyle style, const RenderPlan& plan)
    : style_(style), redraws_(style == ProgressStyle::Text && canRedrawLines()), plan_(plan) {}

Progress::~Progress() { clear(); }

bool Progress::isDue() {
    const Clock::time_point now = Clock::now();
    const Clock::duration interval = style_ == ProgressStyle::Json ? kJsonInterval
                                     : redraws_                    ? kBarInterval
                                                                   : kLineInterval;
    if (style_ == ProgressStyle::Quiet || now - lastShown_ < interval)
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

void Progress::showJson(const std::string& stage, double done) {
    const double seconds = secondsSince(start_);
    stage_ = stage;
    Json json;
    json["stage"] = stage;
    json["done"] = done;
    json["spp"] = totals_ ? Json(totals_->samplesPerPixel) : Json();
    json["error"] = totals_ ? describeError(totals_->error) : Json();
    json["seconds"] = seconds;
    const bool isKnown = stage == kRendering && done > 0.0;
    json["seconds_left"] = isKnown ? Json(seconds * (1.0 - done) / done) : Json();
    std::fputs(jsonText(json, -1).c_str(), stderr);
    std::fflush(stderr);
}

void Progress::step(const std::string& what, double done) {
    if (style_ == ProgressStyle::Json) {
        if (what != stage_ || isDue())
            showJson(what, done);
    } else if (Clock::now() - start_ > kQuietStart && (isDue() || (redraws_ && what != stage_))) {
        stage_ = what;
        show(done, {{what, kSamples}});
    }
}

void Progress::finished(const RenderTotals& totals) {
    totals_ = totals;
    if (style_ == ProgressStyle::Json)
        showJson("finished", 1.0);
}

void Progress::rendering(const RenderTotals& totals) {
    totals_ = totals;
    if (!isDue())
        return;
    const double elapsed = secondsSince(start_);
    const auto paths = static_cast<double>(totals.paths);
    const double done = shareDone(plan_, totals, elapsed);
    if (style_ == ProgressStyle::Json)
        return showJson(kRendering, done);
    std::string samples = std::to_string(totals.samplesPerPixel);
    if (plan_.samplesPerPixel)
        samples.append("/").append(std::to_string(*plan_.samplesPerPixel));
    std::string error;
    if (totals.error)
        error = "error " + percentText(totals.error->relative) + trustText(*totals.error);
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
