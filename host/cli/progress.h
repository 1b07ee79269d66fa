#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/terminal_text.h"
#include "engine/render_plan.h"
#include "render/render_totals.h"

namespace calotype {

enum class ProgressStyle : uint8_t {
    Quiet,
    Text, ///< a bar on a terminal that can redraw it, in one line of its width; else a line at
          ///< times
    Json, ///< a line of JSON for each update (docs/json.md)
};

/// Shows the progress on standard error.
class Progress {
public:
    explicit Progress(ProgressStyle style, const RenderPlan& plan = {});
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Anything but rendering: `done` in [0, 1]. The text is shown only a second after the start.
    void step(const std::string& what, double done);

    void rendering(const RenderTotals& totals);

    /// The end of the render: the last line of JSON.
    void finished(const RenderTotals& totals);

    /// Removes the bar before a message.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    /// True if it is time for the next update.
    bool isDue();
    void show(double done, std::vector<LinePart> parts);
    void showJson(const std::string& stage, double done);

    ProgressStyle style_;
    bool redraws_;
    bool barShown_ = false;
    RenderPlan plan_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point lastShown_ = Clock::now();
    std::string stage_;                  ///< of the last line of JSON, or the last step
    std::optional<RenderTotals> totals_; ///< the last that were given
};

} // namespace calotype
