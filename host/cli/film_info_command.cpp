#include <cstdio>
#include <string>

#include <nlohmann/json.hpp>

#include "base/hexadecimal.h"
#include "base/number_text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/trust_text.h"
#include "engine/film_json.h"
#include "engine/json_document.h"
#include "film/error_estimate.h"
#include "film/film_file.h"

namespace calotype {
namespace {

/// Names and drivers of all devices that rendered the film.
std::string devicesOf(const FilmLabel& label) {
    std::string names;
    for (const std::string& device : label.devices)
        names += (names.empty() ? "" : "; ") + device;
    return names;
}

void print(const KeptFilm& kept) {
    const Film& film = kept.film;
    std::printf("film           %u x %u pixels\n", film.width(), film.height());
    std::printf("samples        %llu per pixel",
                static_cast<unsigned long long>(film.samplesPerPixel()));
    if (!film.blocks().empty())
        std::printf(": %s", sampleText(film.blocks()).c_str());
    std::printf("\n");
    if (const BlockRanges gaps = film.blocks().gaps(); !gaps.empty())
        std::printf("missing        %s\n", sampleText(gaps).c_str());
    if (const auto error = estimateError(film))
        std::printf("error          %s%s\n", percentText(error->relative).c_str(),
                    trustText(*error).c_str());
    std::printf("denoising      %s\n", film.detail() == ReplicaDetail::Color
                                           ? "possible"
                                           : "not possible: rendered without --denoise");
    std::printf("scene          %s\n", hexadecimal(kept.label.sceneHash).c_str());
    std::printf("device         %s\n", devicesOf(kept.label).c_str());
    for (const auto& [name, value] : kept.label.settings)
        std::printf("%-14s %s\n", name.c_str(), value.c_str());
    std::printf(
        "lost           %llu samples not finite, %llu paths cut short, %llu blocks of pixels\n",
        static_cast<unsigned long long>(film.losses().nonFiniteSamples),
        static_cast<unsigned long long>(film.losses().cutPaths),
        static_cast<unsigned long long>(film.losses().lostPixels()));
}

} // namespace

int filmInfoCommand(const InfoOptions& options) {
    const KeptFilm kept = readFilm(options.scene.path);
    if (options.asJson)
        std::fputs(jsonText(filmJson(kept)).c_str(), stdout);
    else
        print(kept);
    return kExitDone;
}

} // namespace calotype
