#include "cli/parse_values.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/names.h"
#include "settings/settings_table.h"
#include "settings/value_text.h"
#include "shared/limits.h"

namespace calotype {
namespace {

const Layer* parseLayer(std::string_view name) {
    if (const Layer* layer = findLayer(name))
        return layer;
    std::vector<std::string> names;
    for (const Layer* layer : allLayers())
        names.push_back(layer->name);
    throw UsageError("--aov has no layer " + inQuotes(name) + suggestion(name, names));
}

[[noreturn]] void fail(const std::string& option, const std::string& text,
                       const std::string& expected) {
    throw UsageError(option + " '" + text + "' is not " + expected);
}

} // namespace

PreviewInterval parsePreviewInterval(const std::string& text) {
    const auto samples = parseNumber<uint32_t>(text);
    if (samples && *samples > 0)
        return {*samples, 0.0};
    const bool hasUnit =
        !text.empty() && std::isalpha(static_cast<unsigned char>(text.back())) != 0;
    if (const auto seconds = parseSeconds(text); hasUnit && seconds)
        return {0, *seconds};
    fail("--preview-every", text, "a number of samples such as 16, or of seconds such as 10s");
}

SceneOverride parseOverride(const std::string& text) {
    const size_t equals = text.find('=');
    if (text.empty() || text.front() != '/' || equals == std::string::npos)
        fail("--set", text, "/POINTER=VALUE, such as /render/max_bounces=8");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

MissingTextures parseMissingTextures(const std::string& text) {
    if (text != "fail" && text != "warn")
        fail("--missing-textures", text, "fail or warn");
    return text == "warn" ? MissingTextures::Warn : MissingTextures::Fail;
}

glm::dvec3 parsePoint(const std::string& option, const std::string& text) {
    glm::dvec3 point(0.0);
    std::string_view rest = text;
    for (int axis = 0; axis < 3; ++axis) {
        const size_t comma = axis < 2 ? rest.find(',') : rest.size();
        const auto number = parseNumber<double>(rest.substr(0, comma));
        if (comma == std::string_view::npos || !number || !std::isfinite(*number))
            fail(option, text, "X,Y,Z in metres, such as 0,1.5,4");
        point[axis] = *number;
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    return point;
}

glm::dvec3 parseUp(const std::string& text) {
    const glm::dvec3 up = parsePoint("--up", text);
    if (up == glm::dvec3(0.0))
        fail("--up", text, "a direction, such as 0,1,0");
    return up;
}

double parseFieldOfView(const std::string& text) {
    const auto degrees = parseNumber<double>(text);
    if (!degrees || !(*degrees > 0.0 && *degrees < 180.0))
        fail("--fov", text, "an angle between 0 and 180 degrees, such as 40");
    return *degrees;
}

ToneMap parseToneMap(const std::string& text) {
    const auto toneMap = toneMapFromName(text);
    if (!toneMap)
        fail("--tonemap", text, std::string(kToneMapNames));
    return *toneMap;
}

std::optional<float> parseExposure(const std::string& text) {
    constexpr float kMaxStops = 100.0f;
    if (text == "auto")
        return std::nullopt;
    const auto stops = parseNumber<float>(text);
    if (!stops || !(std::abs(*stops) <= kMaxStops))
        fail("--exposure", text, "a number of stops from -100 to 100, or auto");
    return stops;
}

ProgressStyle parseProgressStyle(const std::string& text) {
    if (text != "text" && text != "json")
        fail("--progress", text, "text or json");
    return text == "json" ? ProgressStyle::Json : ProgressStyle::Text;
}

LayerList parseLayers(const std::string& text) {
    LayerList layers;
    for (std::string_view rest = text;;) {
        const size_t end = rest.find(',');
        const std::string_view name = rest.substr(0, end);
        const Layer* layer = parseLayer(name);
        if (std::ranges::find(layers, layer) != layers.end())
            throw UsageError("--aov '" + text + "' names " + inQuotes(name) + " twice");
        layers.push_back(layer);
        if (end == std::string_view::npos)
            return layers;
        rest.remove_prefix(end + 1);
    }
}

double parseDuration(const std::string& option, const std::string& text) {
    const auto seconds = parseSeconds(text);
    if (!seconds)
        fail(option, text, "a time above 0, such as 30s, 5m or 2h");
    return *seconds;
}

BlockRange parseSampleRange(const std::string& text) {
    const Setting& samples = *findSetting("samples");
    RenderSettings settings;
    if (!samples.read(text, settings))
        fail("--require", text, samples.expected);
    const uint32_t end = settings.firstSample + settings.samplesPerPixel;
    return {settings.firstSample / shared::kSamplesPerBlock, end / shared::kSamplesPerBlock};
}

double parseMaxRelativeMse(const std::string& text) {
    const auto limit = parseNumber<double>(text);
    if (!limit || !(*limit >= 0.0) || !std::isfinite(*limit))
        fail("--max-relmse", text, "a number of at least 0, such as 1e-3");
    return *limit;
}

} // namespace calotype
