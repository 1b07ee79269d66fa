#include "study/page.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/number_text.h"
#include "film/display_transform.h"
#include "image/difference_picture.h"
#include "image/false_color.h"
#include "study/advice.h"
#include "study/markup.h"
#include "study/plot.h"

namespace calotype {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #222; --faint: #6b7280; --line: #8884; }
@media (prefers-color-scheme: dark) { :root { --paper: #16181c; --ink: #ddd; --faint: #9aa3ad; } }
body { margin: 0 auto; padding: 1rem; max-width: 62rem; background: var(--paper);
  color: var(--ink); font: 1rem/1.5 system-ui, sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.5rem; line-height: 1.2; } h2 { font-size: 1.15rem; margin-top: 2.2rem; }
p, li { max-width: 44rem; } .faint { color: var(--faint); font-size: 0.9rem; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 0.92rem; }
th, td { text-align: left; padding: 0.3rem 0.9rem 0.3rem 0; border-bottom: 1px solid var(--line);
  vertical-align: top; } th { font-weight: 600; }
code { font: 0.88em ui-monospace, monospace; }
dt code, td code { white-space: nowrap; }
svg { width: 100%; max-width: 40rem; height: auto; display: block; }
dl { margin: 0; } dt { font-weight: 600; margin-top: 0.9rem; } dd { margin: 0; max-width: 44rem; }
.swatch { display: inline-block; width: 0.8em; height: 0.8em; border-radius: 2px;
  margin-right: 0.45em; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(9.5rem, 1fr));
  gap: 0.9rem; }
figure { margin: 0; } figure img { width: 100%; display: block; image-rendering: pixelated; }
figure img + img { margin-top: 2px; }
figcaption { font-size: 0.82rem; line-height: 1.35; margin-top: 0.3rem; }
.scale { display: flex; margin-bottom: 0.6rem; flex-wrap: wrap;
  gap: 0.2rem 0.9rem; font-size: 0.85rem; }
)";

/// timingNoise above this value is reported at the top of the page.
constexpr double kRough = 0.3;

std::string tag(const std::string& name, const std::string& contents) {
    return "<" + name + ">" + contents + "</" + name + ">\n";
}

std::string faint(const std::string& contents) {
    return "<p class=\"faint\">" + contents + "</p>\n";
}

std::string swatch(const std::string& color) {
    return "<span class=\"swatch\" style=\"background:" + color + "\"></span>";
}

std::string hexColor(glm::u8vec3 color) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", color.r, color.g, color.b);
    return text;
}

std::string display(const Image& image) {
    return dataUri(toDisplay(image, {0.0f, ToneMap::Neutral}));
}

std::string code(const std::string& text) { return "<code>" + escaped(text) + "</code>"; }

/// Options of the command line; a line break may come only between two options.
std::string optionCode(const std::string& options) {
    std::string html;
    for (size_t begin = 0; begin < options.size();) {
        const size_t next = options.find(" --", begin);
        if (!html.empty())
            html += ' ';
        html += code(options.substr(begin, next - begin));
        begin = next == std::string::npos ? options.size() : next + 1;
    }
    return html;
}

/// Replaces the space between a number and its unit by a no-break space.
std::string withFixedUnits(std::string html) {
    for (const std::string unit : {" %", " s"})
        for (size_t at = html.find(unit); at != std::string::npos; at = html.find(unit, at + 1)) {
            const bool isUnit =
                at > 0 && std::isdigit(static_cast<unsigned char>(html[at - 1])) &&
                (at + 2 == html.size() || !std::isalpha(static_cast<unsigned char>(html[at + 2])));
            if (isUnit)
                html.replace(at, 1, "\u00a0");
        }
    return html;
}

std::string errorText(const std::optional<double>& error) {
    return error ? "error " + percentText(*error)
                 : "error too small to measure against the ground truth";
}

std::string figure(const std::string& pictures, const std::string& caption) {
    return "<figure>" + pictures + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string image(const std::string& uri, const std::string& words) {
    return "<img src=\"" + uri + "\" alt=\"" + escaped(words) + "\">";
}

/// Builds the page.
class Page {
public:
    Page(const Study& study, const StudyOrigin& origin)
        : study_(study), origin_(origin), groundTruthPart_(middleOf(study.groundTruth->picture)) {}

    std::string text() const {
        const std::string title = "Render settings compared: " + escaped(origin_.scene);
        return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
               tag("title", title) + tag("style", kStyle) + "</head>\n<body>\n" + tag("h1", title) +
               facts() + choices() + denoisedErrors() + plot() + sentences() + equalTime() +
               equalError() + "</body>\n</html>\n";
    }

private:
    const Measurement& usual() const { return study_.measurements.front(); }

    std::string facts() const {
        const GroundTruth& truth = *study_.groundTruth;
        const RenderSettings& render = study_.usual;
        std::string words = "Rendered by " + escaped(origin_.device) + " at " +
                            std::to_string(render.width) + " x " + std::to_string(render.height) +
                            " pixels, " + std::to_string(render.maxBounces) +
                            " bounces. Errors are relative, at 95 % confidence, measured against a "
                            "ground truth of " +
                            std::to_string(truth.samples) +
                            " samples per pixel, whose own error is " + percentText(truth.error) +
                            ".";
        if (study_.ending == StudyEnding::Stopped)
            words += " The study was stopped before its end.";
        if (study_.ending == StudyEnding::OutOfTime)
            words += " The time budget was too short for all settings.";
        std::string html = tag("p", words);
        if (!truth.isTrusted)
            html += tag("p", "<strong>The ground truth is not reliable</strong>: most of its light "
                             "comes from a few bright samples, or it has too few samples. Some "
                             "light may be missing from it, and the numbers below do not show "
                             "that. Use a longer budget.");
        if (study_.timingNoise() > kRough)
            html +=
                tag("p",
                    "<strong>The times are imprecise</strong>: the speed of the machine varied "
                    "by " +
                        percentText(study_.paceSpread) + " during the study. Use a longer budget.");
        for (const auto* list : {&study_.failures, &study_.omitted})
            for (const FailedVariant& variant : *list)
                html += tag("p", "Not measured: " + escaped(variant.name) + ": " +
                                     escaped(variant.reason));
        return html;
    }

    std::string choices() const {
        const std::vector<Choice> denoised = denoisedChoicesOf(study_);
        std::string rows = "<tr><th>target error</th><th>settings</th><th>time</th>"
                           "<th>time with the default settings</th>";
        std::string commands;
        rows += isSmaller() ? "<th>time at the scene's own size</th></tr>\n" : "</tr>\n";
        for (const Choice& choice : choicesOf(study_))
            rows += rowOf(choice, "", commands);
        for (const Choice& choice : denoised)
            rows += rowOf(choice, " after denoising", commands);
        return tag("h2", "Recommended settings") + "<div class=\"wide\"><table>" + rows +
               "</table></div>\n" + (commands.empty() ? "" : tag("ul", commands)) +
               faint(
                   "Time of sampling until the picture has this error. Beyond the longest render "
                   "that was measured it is extrapolated: the error falls with the square root of "
                   "the time. The commands end when the error is reached.") +
               (denoised.empty()
                    ? ""
                    : faint("After denoising: the error of the denoised picture, with what the "
                            "denoiser blurs or invents. The time includes denoising once, and is "
                            "not extrapolated. Such a command ends when the upper bound of the "
                            "stated error is at the target, so somewhat later."));
    }

    bool isSmaller() const { return study_.scale > 1.0; }

    /// Of the recommended settings; adds the command, if there is one. `which`: of the error.
    std::string rowOf(const Choice& choice, const std::string& which, std::string& commands) const {
        std::string row = tag("td", targetText(choice.target) + which);
        if (choice.measurement) {
            row += tag("td", choice.options.empty() ? "the default" : optionCode(choice.options)) +
                   tag("td", durationText(choice.seconds) +
                                 (choice.isExtrapolated ? ", extrapolated" : "")) +
                   tag("td", choice.usual ? durationText(*choice.usual) : "never");
            if (isSmaller())
                row += tag("td", durationText(choice.seconds * study_.scale));
            commands += tag("li", code(commandOf(choice, origin_.command)));
        } else {
            row += std::string("<td colspan=\"") + (isSmaller() ? "4" : "3") + "\">" +
                   whyNone(choice) + "</td>";
        }
        return tag("tr", row);
    }

    /// Nothing where no variant with a denoiser was measured.
    std::string denoisedErrors() const {
        std::string rows;
        for (const Measurement& measurement : study_.measurements)
            for (const CurvePoint& point : measurement.curve) {
                if (!measurement.variant.isDenoised)
                    continue;
                const auto percent = [](const std::optional<double>& error, const char* otherwise) {
                    return tag("td", error ? percentText(*error) : otherwise);
                };
                const std::string ratio =
                    point.error && point.stated ? shortNumber(*point.stated / *point.error, 3) : "";
                rows += tag("tr", tag("td", escaped(measurement.variant.name)) +
                                      tag("td", std::to_string(std::lround(point.samples))) +
                                      tag("td", durationText(point.seconds)) +
                                      percent(point.error, "too small to measure") +
                                      percent(point.stated, "not stated") +
                                      percent(point.bound, "") + tag("td", ratio));
            }
        if (rows.empty())
            return "";
        return tag("h2", "Denoised pictures: stated and true error") +
               "<div class=\"wide\"><table>" +
               tag("tr", "<th>settings</th><th>samples per pixel</th><th>time</th>"
                         "<th>true error</th><th>stated error</th><th>stated bound</th>"
                         "<th>stated / true</th>") +
               rows + "</table></div>\n" +
               faint("The true error is measured against the ground truth; the stated one is what "
                     "the render itself finds by cross-validation. That is the error with seven "
                     "eighths of the samples, so up to 1.07 of the true one in the mean, and each "
                     "has its own noise. The bound is above the true error in 95 % of pictures.");
    }

    std::string plot() const {
        return tag("h2", "Error against time") + toSvg(study_, origin_.scene) +
               faint("Dashed lines: settings that lose light, so that their error stays above a "
                     "limit. Dotted lines: denoised pictures, whose error includes what the "
                     "denoiser blurs or invents. A line ends where the error is too small to "
                     "measure against the ground truth.");
    }

    std::string sentences() const {
        std::string list;
        for (size_t i = 0; i < study_.measurements.size(); ++i) {
            const Measurement& measurement = study_.measurements[i];
            const std::string& options = measurement.variant.options;
            std::string term = swatch(variantColor(i)) + escaped(measurement.variant.name);
            if (!options.empty())
                term.append(" ").append(optionCode(options));
            list += tag("dt", term);
            list += tag("dd", i == 0 ? defaultSentence()
                                     : sentenceOf(measurement, usual(), study_.timingNoise()));
        }
        return tag("h2", "Effect of each setting") + "<dl>" + list + "</dl>\n" +
               faint("Each setting was rendered once. Differences in time below " +
                     percentText(study_.timingNoise()) +
                     " are within the measurement noise. Ratios are relative to the default "
                     "settings, which were rendered again between the others in order to correct "
                     "all times for changes in the machine's speed.");
    }

    std::string defaultSentence() const {
        const CurvePoint& last = usual().last();
        return std::to_string(std::lround(last.samples)) + " samples per pixel in " +
               durationText(last.seconds) + ": " + errorText(last.error) +
               (last.stated ? "; the render's own estimate was " + percentText(*last.stated) +
                                  (usual().isTrusted ? "" : ", which is not reliable")
                            : "") +
               ".";
    }

    std::string picturesOf(const CurvePoint& point, const std::string& name) const {
        return image(display(point.part), name) +
               image(dataUri(differencePicture(point.part, groundTruthPart_)),
                     "errors of " + name + " in false colours");
    }

    std::string scale() const {
        std::string html;
        for (const auto& [label, value] :
             {std::pair{"0.1 %", 1e-3}, {"1 %", 1e-2}, {"10 %", 0.1}, {"100 %", 1.0}}) {
            const double place = std::log(value / DifferenceScale::kLeast) /
                                 std::log(DifferenceScale::kMost / DifferenceScale::kLeast);
            html += "<span>" + swatch(hexColor(falseColor(place))) + label + "</span>";
        }
        return "<div class=\"scale\">" + html + "</div>\n";
    }

    std::string equalTime() const {
        std::string figures = figure(image(display(groundTruthPart_), "the ground truth"),
                                     "<strong>the ground truth</strong><br>" +
                                         durationText(study_.groundTruth->seconds) + ", error " +
                                         percentText(study_.groundTruth->error));
        double shortest = usual().last().seconds;
        for (const Measurement& measurement : study_.measurements)
            shortest = std::min(shortest, measurement.last().seconds);
        for (const Measurement& measurement : study_.measurements) {
            const CurvePoint& point = *nearest(measurement.curve, [&](const CurvePoint& one) {
                return std::abs(std::log(one.seconds / shortest));
            });
            figures +=
                figure(picturesOf(point, measurement.variant.name), caption(measurement, point));
        }
        return tag("h2", "Pictures at equal time") +
               tag("p", "Each picture after about " + durationText(shortest) +
                            " of sampling. Below it: the relative difference of each pixel from "
                            "the ground truth.") +
               scale() + "<div class=\"pictures\">" + figures + "</div>\n";
    }

    /// The point of the curve with the smallest distance.
    template <typename Distance>
    static const CurvePoint* nearest(const std::vector<CurvePoint>& curve,
                                     const Distance& distance) {
        return &*std::ranges::min_element(curve, {}, distance);
    }

    /// An error that every variant that loses no light has reached.
    std::optional<double> commonError() const {
        std::optional<double> error;
        for (const Measurement& measurement : study_.measurements)
            if (!measurement.variant.losesLight && measurement.last().error)
                error = std::max(error.value_or(0.0), *measurement.last().error);
        return error;
    }

    std::string equalError() const {
        const auto wanted = commonError();
        if (!wanted)
            return "";
        std::string figures;
        for (const Measurement& measurement : study_.measurements) {
            const CurvePoint* point = nearest(measurement.curve, [&](const CurvePoint& one) {
                return one.error ? std::abs(std::log(*one.error / *wanted))
                                 : std::numeric_limits<double>::infinity();
            });
            if (point->error)
                figures += figure(picturesOf(*point, measurement.variant.name),
                                  caption(measurement, *point));
        }
        return tag("h2", "Pictures at equal error") +
               tag("p", "For each setting, the picture whose error is nearest to " +
                            percentText(*wanted) + ", with its time and its samples.") +
               scale() + "<div class=\"pictures\">" + figures + "</div>\n";
    }

    static std::string caption(const Measurement& measurement, const CurvePoint& point) {
        return "<strong>" + escaped(measurement.variant.name) + "</strong><br>" +
               durationText(point.seconds) + ", " + std::to_string(std::lround(point.samples)) +
               " samples<br>" + errorText(point.error);
    }

    const Study& study_;
    const StudyOrigin& origin_;
    Image groundTruthPart_;
};

} // namespace

std::string toHtml(const Study& study, const StudyOrigin& origin) {
    return withFixedUnits(Page(study, origin).text());
}

} // namespace calotype
