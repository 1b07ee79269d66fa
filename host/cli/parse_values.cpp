#include "cli/parse_values.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/names.h"
#include "image/image.h"
#include "scene/scene.h"
#include "settings/limits.h"
#include "shared/limits.h"

namespace calotype {
namespace {

template <typename T>
std::optional<T> parseNumber(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// Whole numbers between separators, or nothing unless there are exactly `count`.
std::optional<std::vector<uint32_t>> parseList(std::string_view text, char separator,
                                               size_t count) {
    std::vector<uint32_t> numbers;
    while (true) {
        const size_t end = text.find(separator);
        const auto number = parseNumber<uint32_t>(text.substr(0, end));
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        if (end == std::string_view::npos)
            break;
        text.remove_prefix(end + 1);
    }
    if (numbers.size() != count)
        return std::nullopt;
    return numbers;
}

const Layer* parseLayer(std::string_view name) {
    if (const Layer* layer = findLayer(name))
        return layer;
    std::vector<std::string> names;
    for (const Layer* layer : allLayers())
        names.push_back(layer->name);
    throw UsageError("--aov has no layer " + inQuotes(name) + suggestion(name, names));
}

/// "30s", "1.5m", "2h" or a number of seconds; nothing unless above 0 and below thirty years.
std::optional<double> secondsIn(std::string_view text) {
    constexpr std::pair<char, double> kUnits[] = {{'s', 1.0}, {'m', 60.0}, {'h', 3600.0}};
    constexpr double kLongest = 1e9;
    double unit = 1.0;
    for (const auto& [letter, seconds] : kUnits)
        if (text.ends_with(letter)) {
            text.remove_suffix(1);
            unit = seconds;
            break;
        }
    const double seconds = parseNumber<double>(text).value_or(0.0) * unit;
    return seconds > 0.0 && seconds <= kLongest ? std::optional(seconds) : std::nullopt;
}

[[noreturn]] void fail(const std::string& option, const std::string& text,
                       const std::string& expected) {
    throw UsageError(option + " '" + text + "' is not " + expected);
}

} // namespace

PictureSize parseSize(const std::string& text) {
    static_assert(kLargestPictureSide == 65535, "as the message says");
    const auto sides = parseList(text, 'x', 2);
    if (!sides || (*sides)[0] < 1 || (*sides)[1] < 1 || (*sides)[0] > kLargestPictureSide ||
        (*sides)[1] > kLargestPictureSide)
        fail("--size", text, "WIDTHxHEIGHT in pixels from 1 to 65535, such as 640x480");
    return {(*sides)[0], (*sides)[1]};
}

Crop parseCrop(const std::string& text) {
    const auto numbers = parseList(text, ',', 4);
    if (!numbers || (*numbers)[2] < 1 || (*numbers)[3] < 1)
        fail("--crop", text, "X,Y,WIDTH,HEIGHT in pixels from the top left, such as 100,50,64,64");
    return {(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
}

PreviewInterval parsePreviewInterval(const std::string& text) {
    const auto samples = parseNumber<uint32_t>(text);
    if (samples && *samples > 0)
        return {*samples, 0.0};
    const bool hasUnit =
        !text.empty() && std::isalpha(static_cast<unsigned char>(text.back())) != 0;
    if (const auto seconds = secondsIn(text); hasUnit && seconds)
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

std::optional<BvhBuilder> parseBvh(const std::string& text) {
    if (text == "auto")
        return std::nullopt;
    if (text != "median" && text != "sah")
        fail("--bvh", text, "auto, median or sah");
    return text == "median" ? BvhBuilder::Median : BvhBuilder::Sah;
}

Sampler parseSampler(const std::string& text) {
    if (text != "independent" && text != "sobol")
        fail("--sampler", text, "independent or sobol");
    return text == "sobol" ? Sampler::Sobol : Sampler::Independent;
}

LightChoice parseLightChoice(const std::string& text) {
    for (const LightChoice choice : {LightChoice::Power, LightChoice::Uniform, LightChoice::All})
        if (text == nameOf(choice))
            return choice;
    fail("--light-choice", text, "power, uniform or all");
}

std::optional<TextureFilter> parseTextureFilter(const std::string& text) {
    if (text == "scene")
        return std::nullopt;
    if (text != "bilinear" && text != "nearest")
        fail("--texture-filter", text, "scene, bilinear or nearest");
    return text == "nearest" ? TextureFilter::Nearest : TextureFilter::Bilinear;
}

float parseIndirectClamp(const std::string& text) {
    if (text == "off")
        return TransportSettings().indirectClamp;
    const auto limit = parseNumber<float>(text);
    if (!limit || !(*limit > 0.0f) || !std::isfinite(*limit))
        fail("--clamp-indirect", text, "a radiance above 0, such as 10, or off");
    return *limit;
}

bool parseSwitch(const std::string& option, const std::string& text) {
    if (text != "on" && text != "off")
        fail(option, text, "on or off");
    return text == "on";
}

ToneMap parseToneMap(const std::string& text) {
    const auto toneMap = toneMapFromName(text);
    if (!toneMap)
        fail("--tonemap", text, std::string(kToneMapNames));
    return *toneMap;
}

float parseExposure(const std::string& text) {
    constexpr float kMaxStops = 100.0f;
    const auto stops = parseNumber<float>(text);
    if (!stops || !(std::abs(*stops) <= kMaxStops))
        fail("--exposure", text, "a number of stops from -100 to 100");
    return *stops;
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

SampleRange parseSamples(const std::string& text) {
    static_assert(shared::kSamplesPerBlock == 16 && kMostSamplesPerPixel == 67'108'864,
                  "as the message says");
    const auto numbers = parseList(text, ':', 2);
    const auto isBorder = [](uint32_t n) {
        return n % shared::kSamplesPerBlock == 0 && n <= kMostSamplesPerPixel;
    };
    if (!numbers || !isBorder((*numbers)[0]) || !isBorder((*numbers)[1]) ||
        (*numbers)[0] >= (*numbers)[1])
        fail("--samples", text,
             "FIRST:END with FIRST below END, both multiples of 16 up to 67108864, such as 64:128");
    return {(*numbers)[0], (*numbers)[1]};
}

double parseTargetError(const std::string& text) {
    const auto error = parseNumber<double>(text);
    if (!error || !(*error > 0.0) || !(*error < 1.0))
        fail("--target-error", text, "a relative error between 0 and 1, such as 0.02 for 2 %");
    return *error;
}

double parseDuration(const std::string& option, const std::string& text) {
    const auto seconds = secondsIn(text);
    if (!seconds)
        fail(option, text, "a time above 0, such as 30s, 5m or 2h");
    return *seconds;
}

double parseMaxRelativeMse(const std::string& text) {
    const auto limit = parseNumber<double>(text);
    if (!limit || !(*limit >= 0.0) || !std::isfinite(*limit))
        fail("--max-relmse", text, "a number of at least 0, such as 1e-3");
    return *limit;
}

} // namespace calotype
