#include "study/csv.h"

#include <cmath>
#include <optional>

#include "base/number_text.h"

namespace calotype {
namespace {

/// Empty if the value is unknown.
std::string number(double value) { return std::isfinite(value) ? shortNumber(value) : ""; }

std::string number(const std::optional<double>& value) { return value ? number(*value) : ""; }

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

} // namespace

std::string toCsv(const Study& study) {
    std::string csv = "variant,options,samples_per_pixel,seconds,pace,error,stated_error,"
                      "stated_bound,build_seconds,compile_seconds,brighter,"
                      "brighter_standard_error\n";
    for (const Measurement& measurement : study.measurements)
        for (const CurvePoint& point : measurement.curve)
            csv += quoted(measurement.variant.name) + ',' + quoted(measurement.variant.options) +
                   ',' + number(point.samples) + ',' + number(point.seconds) + ',' +
                   number(measurement.pace) + ',' + number(point.error) + ',' +
                   number(point.stated) + ',' + number(point.bound) + ',' +
                   number(measurement.buildSeconds) + ',' + number(measurement.compileSeconds) +
                   ',' + number(measurement.brighter) + ',' + number(measurement.brighterError) +
                   '\n';
    return csv;
}

} // namespace calotype
