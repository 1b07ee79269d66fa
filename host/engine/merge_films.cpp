#include "engine/merge_films.h"

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
    joined.label.devices.insert(next.label.devices.begin(), next.label.devices.end());
}

} // namespace

KeptFilm mergeFilms(const std::vector<std::string>& paths) {
    if (paths.empty())
        throw UsageError("there is no film to merge");
    KeptFilm joined = readLabelledFilm(paths.front());
    for (size_t i = 1; i < paths.size(); ++i)
        join(joined, paths[i]);
    return joined;
}

} // namespace calotype
