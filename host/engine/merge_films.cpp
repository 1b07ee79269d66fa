#include "engine/merge_films.h"

#include <optional>

#include "base/error.h"
#include "engine/film_label.h"

namespace calotype {
namespace {

/// Adds a film to those joined so far. Throws SceneError if it does not fit them.
void join(KeptFilm& joined, const std::string& path) {
    const KeptFilm next = readLabelledFilm(path);
    requireSameOrigin(path, next, joined.label, joined.film.width(), joined.film.height(),
                      joined.film.unit(), joined.film.channels());
    if (const BlockRange both = joined.film.blocks().firstOverlap(next.film.blocks()); both.end > 0)
        throw SceneError(path, "the film cannot be joined: the samples " + sampleText(both) +
                                   " are in a film before it too");
    joined.film.add(next.film);
    if (joined.label.camera.empty())
        joined.label.camera = next.label.camera;
    joined.label.devices.insert(next.label.devices.begin(), next.label.devices.end());
}

} // namespace

void requireNoLess(const std::string& path, const KeptFilm& joined) {
    constexpr const char* kAdvice = "; name another file, or replace it with --overwrite";
    if (!isFilm(path))
        return;
    std::optional<KeptFilm> existing;
    try {
        existing = readLabelledFilm(path);
        requireSameOrigin(path, *existing, joined.label, joined.film.width(), joined.film.height(),
                          joined.film.unit(), joined.film.channels());
    } catch (const SceneError& error) {
        const std::string sentence = error.what();
        throw SceneError(path, sentence.substr(error.where().size() + 2) + kAdvice);
    }
    const BlockRanges missing = joined.film.blocks().missingFrom(existing->film.blocks());
    if (!missing.empty())
        throw SceneError(path,
                         "the film exists already, and holds samples that these films lack: " +
                             sampleText(missing) + kAdvice);
}

KeptFilm mergeFilms(const std::vector<std::string>& paths,
                    const std::function<void()>& beforeEach) {
    if (paths.empty())
        throw UsageError("there is no film to merge");
    KeptFilm joined = readLabelledFilm(paths.front());
    for (size_t i = 1; i < paths.size(); ++i) {
        if (beforeEach)
            beforeEach();
        join(joined, paths[i]);
    }
    return joined;
}

} // namespace calotype
