#include "engine/merge_films.h"

#include <optional>
#include <utility>

#include "base/error.h"
#include "engine/film_label.h"
#include "film/same_origin.h"

namespace calotype {
namespace {

/// Adds a film to those joined so far. Throws SceneError if it does not fit them.
void join(KeptFilm& joined, const std::string& path) {
    KeptFilm next = readLabelledFilm(path);
    requireSameOrigin(path, next, joined.label, joined.film.width(), joined.film.height(),
                      joined.film.unit(), joined.film.detail());
    if (const BlockRange both = joined.film.blocks().firstOverlap(next.film.blocks()); both.end > 0)
        throw SceneError(path, "the film cannot be joined: the samples " + sampleText(both) +
                                   " are in a film before it too");
    joined.film.add(next.film);
    if (joined.label.camera.empty())
        joined.label.camera = next.label.camera;
    joined.label.devices.insert(next.label.devices.begin(), next.label.devices.end());
    if (next.features && (!joined.features || isBefore(*next.features, *joined.features)))
        joined.features = std::move(next.features);
}

bool hasSameOrigin(const std::string& path, const KeptFilm& a, const KeptFilm& b) {
    try {
        requireSameOrigin(path, a, b.label, b.film.width(), b.film.height(), b.film.unit(),
                          a.film.detail()); // which may differ
        return true;
    } catch (const SceneError&) {
        return false;
    }
}

/// Nothing where there is no film, or a damaged one.
std::optional<KeptFilm> readIfWhole(const std::string& path) {
    try {
        return isFilm(path) ? std::optional(readLabelledFilm(path)) : std::nullopt;
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

} // namespace

void requireNoLess(const std::string& path, const KeptFilm& joined) {
    const std::optional<KeptFilm> existing = readIfWhole(path);
    if (!existing || !hasSameOrigin(path, *existing, joined))
        return;
    if (existing->film.detail() == ReplicaDetail::Color &&
        joined.film.detail() != ReplicaDetail::Color)
        throw SceneError(path, "the film exists already, and can be denoised, which these films "
                               "cannot; name another file, or replace it with --overwrite");
    const BlockRanges missing = joined.film.blocks().missingFrom(existing->film.blocks());
    if (!missing.empty())
        throw SceneError(
            path, "the film exists already, and holds samples that these films lack: " +
                      sampleText(missing) + "; name another file, or replace it with --overwrite");
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
