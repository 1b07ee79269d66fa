#include "study/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/number_text.h"
#include "study/markup.h"

namespace calotype {
namespace {

constexpr double kWidth = 480.0;
constexpr double kLeft = 58.0;
constexpr double kRight = 12.0;
constexpr double kTop = 40.0;
constexpr double kPlotHeight = 330.0;
constexpr double kLegendTop = kTop + kPlotHeight + 62.0;
constexpr double kLegendLine = 20.0;

/// One axis of a logarithmic plot.
class LogAxis {
public:
    LogAxis(double from, double to) : from_(from), to_(to) {}

    /// Widens the range so that it contains `value`.
    void take(double value) {
        least_ = std::min(least_, value);
        most_ = std::max(most_, value);
    }

    bool isEmpty() const { return least_ > most_; }

    double at(double value) const {
        const double low = std::log(least_ / kMargin);
        const double high = std::log(most_ * kMargin);
        return from_ + (to_ - from_) * (std::log(value) - low) / (high - low);
    }

    /// 1, 2 and 5 times powers of ten; only the powers of ten where that gives more than eight.
    std::vector<double> ticks() const {
        std::vector<double> all;
        std::vector<double> powers;
        for (int exponent = -9; exponent <= 9; ++exponent)
            for (const double step : {1.0, 2.0, 5.0}) {
                const double value = step * std::pow(10.0, exponent);
                if (value < least_ / kMargin || value > most_ * kMargin)
                    continue;
                all.push_back(value);
                if (step == 1.0)
                    powers.push_back(value);
            }
        return all.size() > 8 ? powers : all;
    }

private:
    static constexpr double kMargin = 1.12;

    double from_;
    double to_;
    double least_ = std::numeric_limits<double>::infinity();
    double most_ = 0.0;
};

std::string text(double x, double y, const std::string& anchor, const std::string& words,
                 const std::string& more = "") {
    return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" text-anchor=\"" + anchor +
           "\"" + more + ">" + escaped(words) + "</text>\n";
}

std::string line(double x0, double y0, double x1, double y1) {
    return "<path class=\"grid\" d=\"M" + coordinate(x0) + " " + coordinate(y0) + "L" +
           coordinate(x1) + " " + coordinate(y1) + "\"/>\n";
}

std::string grid(const LogAxis& x, const LogAxis& y) {
    std::string svg;
    const double bottom = kTop + kPlotHeight;
    for (const double seconds : x.ticks()) {
        svg += line(x.at(seconds), kTop, x.at(seconds), bottom);
        svg += text(x.at(seconds), bottom + 18.0, "middle", shortNumber(seconds));
    }
    for (const double error : y.ticks()) {
        svg += line(kLeft, y.at(error), kWidth - kRight, y.at(error));
        svg += text(kLeft - 6.0, y.at(error) + 5.0, "end", targetText(error));
    }
    svg += text(0.5 * (kLeft + kWidth - kRight), bottom + 38.0, "middle",
                "seconds of sampling, and of denoising where that is named");
    return svg;
}

std::string path(const std::vector<FrontPoint>& points, const LogAxis& x, const LogAxis& y,
                 const std::string& attributes) {
    std::string data;
    for (const FrontPoint& point : points) {
        data += data.empty() ? 'M' : 'L';
        data += coordinate(x.at(point.seconds)) + ' ' + coordinate(y.at(point.error));
    }
    // "h0" ends the path with an empty line, so that round caps draw a single point as a dot.
    return data.empty() ? "" : "<path " + attributes + " d=\"" + data + "h0\"/>\n";
}

std::string strokeOf(const Measurement& measurement, size_t index) {
    std::string attributes = "fill=\"none\" stroke-linecap=\"round\" stroke=\"" +
                             variantColor(index) + "\" stroke-width=\"";
    attributes += index == 0 ? "3\"" : "1.6\"";
    if (measurement.variant.losesLight)
        attributes += " stroke-dasharray=\"5 3\"";
    if (measurement.variant.isDenoised)
        attributes += " stroke-dasharray=\"1 4\"";
    return attributes;
}

} // namespace

std::string variantColor(size_t index) {
    // Different hues, with a lightness that is visible on white and on black.
    constexpr std::array<const char*, 18> kColors = {
        "#1b7fd6", "#e0762c", "#35a35a", "#c94fb0", "#8a6fe8", "#b8912a",
        "#2fa7a7", "#d6455d", "#7d8a99", "#6aa52d", "#a46a4a", "#4f79c9",
        "#d18ac0", "#5f9f86", "#e04f8f", "#9a7bb0", "#c4622d", "#4a9fc0"};
    return kColors[index % kColors.size()];
}

std::string toSvg(const Study& study, const std::string& title) {
    LogAxis x(kLeft, kWidth - kRight);
    LogAxis y(kTop + kPlotHeight, kTop);
    for (const Measurement& measurement : study.measurements)
        for (const FrontPoint& point : knownPoints(measurement)) {
            x.take(point.seconds);
            y.take(point.error);
        }
    const auto rows = static_cast<double>(study.measurements.size() + 1); // and the front
    const std::string height = coordinate(kLegendTop + kLegendLine * rows);
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + coordinate(kWidth) + " " +
        height +
        "\" role=\"img\" aria-label=\"error against time\">\n"
        "<style>\n"
        "text { font: 13px system-ui, sans-serif; fill: #222; }\n"
        ".grid { stroke: #888; stroke-opacity: 0.25; }\n"
        ".front { fill: none; stroke: #888; stroke-opacity: 0.4; stroke-width: 8; "
        "stroke-linejoin: round; stroke-linecap: round; }\n"
        ".paper { fill: #fff; }\n"
        "@media (prefers-color-scheme: dark) { text { fill: #ddd; } .paper { fill: #16181c; } }\n"
        "</style>\n"
        "<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n";
    svg += text(kLeft, 20.0, "start", title, " font-weight=\"600\"");
    if (x.isEmpty())
        return svg +
               text(kLeft, 60.0, "start", "no error was measured: the time budget was too short") +
               "</svg>\n";
    svg += grid(x, y);
    svg += path(paretoFront(study.measurements), x, y, "class=\"front\"");
    for (size_t i = study.measurements.size(); i-- > 0;) // the default on top
        svg += path(knownPoints(study.measurements[i]), x, y, strokeOf(study.measurements[i], i));
    const auto legend = [&](size_t row, const std::string& attributes, const std::string& words) {
        const double middle = kLegendTop + kLegendLine * static_cast<double>(row) - 5.0;
        svg += "<path " + attributes + " d=\"M" + coordinate(kLeft) + " " + coordinate(middle) +
               "h28\"/>\n" + text(kLeft + 38.0, middle + 5.0, "start", words);
    };
    for (size_t i = 0; i < study.measurements.size(); ++i)
        legend(i, strokeOf(study.measurements[i], i), study.measurements[i].variant.name);
    legend(study.measurements.size(), "class=\"front\"", "the Pareto front");
    return svg + "</svg>\n";
}

} // namespace calotype
