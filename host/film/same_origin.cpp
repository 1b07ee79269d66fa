#include "film/same_origin.h"

#include <string>

#include "base/error.h"

namespace calotype {
namespace {

/// The end of the message that a film has another value of a setting, where an option gives it.
std::string adviceFor(const std::string& name, const std::string& ofFilm) {
    if (name == "light_choice")
        return "; give --light-choice to go on with it";
    if (name == kAlphaSetting)
        return std::string(ofFilm == "on" ? "; give" : "; leave out") +
               " --transparent to go on with it";
    return "";
}

} // namespace

void requireSameOrigin(const std::filesystem::path& path, const KeptFilm& film,
                       const FilmLabel& label, uint32_t width, uint32_t height, double unit,
                       ReplicaDetail detail) {
    const auto fail = [&](const std::string& difference) {
        throw SceneError(path.string(), "the film cannot be joined: " + difference);
    };
    if (film.label.sceneHash != label.sceneHash)
        fail("it is of another scene, or the scene's files have changed since");
    for (const FilmLabel* owner : {&label, &film.label})
        for (const auto& [name, value] : owner->settings)
            if (film.label.setting(name) != label.setting(name))
                fail("its setting " + name + " is " + film.label.setting(name) + ", not " +
                     label.setting(name) + adviceFor(name, film.label.setting(name)));
    if (film.film.unit() != unit)
        fail("it is of lights of another strength");
    if (film.film.width() != width || film.film.height() != height)
        fail("it is of another size");
    if (film.film.detail() != detail)
        fail(detail == ReplicaDetail::Color
                 ? "it is of a render without --denoise, and lacks the colours of replicas that "
                   "denoising needs; render it with --denoise from the start, or go on without"
                 : "it is of a render for denoising, and not one without --denoise");
}

} // namespace calotype
