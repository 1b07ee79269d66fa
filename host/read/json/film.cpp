#include "read/json/film.h"

#include <array>
#include <cstdint>
#include <string>

namespace calotype {
namespace {

/// In the order of FilmFilter.
const std::array<std::string, 4> kFilters = {"box", "tent", "gaussian", "blackman-harris"};

/// In the order of DenoiserKind.
const std::array<std::string, 3> kDenoisers = {
    nameOf(DenoiserKind::Off), nameOf(DenoiserKind::Oidn), nameOf(DenoiserKind::Statistical)};

JsonKey wholeKey(const char* name, const ranges::WholeRange& range, uint32_t otherwise,
                 const char* description) {
    return JsonKey(name, wholeNumberType(range), description)
        .orElse(static_cast<double>(otherwise));
}

const JsonObjectType& filmObject() {
    static const FilmSettings otherwise;
    static const JsonObjectType type = {
        {
            wholeKey("width", ranges::kPictureSide, otherwise.width, "The picture's width.")
                .in("pixels"),
            wholeKey("height", ranges::kPictureSide, otherwise.height, "The picture's height.")
                .in("pixels"),
            JsonKey(
                "filter", choiceType(kFilters),
                "Reconstruction filter: box 1 pixel wide, tent radius 1, gaussian sigma 0.5 and "
                "radius 1.5, blackman-harris radius 1.5.")
                .orElseJson("\"box\""),
        },
        {},
        "The picture. Pixel (0, 0) is top left."};
    return type;
}

const JsonObjectType& renderObject() {
    static const RenderDefaults otherwise;
    static const JsonObjectType type = {
        {
            wholeKey("spp", ranges::kSamplesPerPixel, otherwise.samplesPerPixel,
                     "Samples per pixel."),
            wholeKey("max_bounces", ranges::kMaxBounces, otherwise.maxBounces,
                     "Scattering events allowed along a path: 0 shows emitters only, 1 is direct "
                     "light. Mitsuba's max_depth is this plus one."),
            wholeKey("seed", ranges::kSeed, otherwise.seed, "Chooses the random numbers."),
            JsonKey("denoise", choiceType(kDenoisers),
                    "What removes the noise of the finished picture: oidn is Open Image Denoise 2, "
                    "statistical mixes only pixels whose difference may be noise.")
                .orElseJson("\"off\""),
            JsonKey("transparent", booleanType(),
                    "Hides the background from the camera, and gives the picture an alpha channel. "
                    "The background still lights the scene.")
                .orElseJson("false"),
        },
        {},
        "Defaults of options of the command line."};
    return type;
}

uint32_t wholeNumber(const JsonObject& object, const char* key, uint32_t otherwise) {
    return static_cast<uint32_t>(object.number(key, otherwise));
}

} // namespace

JsonType filmType() { return filmObject().asType("film"); }

JsonType renderType() { return renderObject().asType("render"); }

FilmSettings readFilm(const JsonValue& value) {
    const JsonObject object(value, filmObject());
    FilmSettings film;
    film.width = wholeNumber(object, "width", film.width);
    film.height = wholeNumber(object, "height", film.height);
    film.filter = static_cast<FilmFilter>(object.choice("filter", kFilters, 0));
    return film;
}

RenderDefaults readRender(const JsonValue& value) {
    const JsonObject object(value, renderObject());
    RenderDefaults render;
    render.samplesPerPixel = wholeNumber(object, "spp", render.samplesPerPixel);
    render.maxBounces = wholeNumber(object, "max_bounces", render.maxBounces);
    render.seed = wholeNumber(object, "seed", render.seed);
    render.denoiser = static_cast<DenoiserKind>(object.choice("denoise", kDenoisers, 0));
    render.hidesBackground = object.boolean("transparent", false);
    return render;
}

} // namespace calotype
