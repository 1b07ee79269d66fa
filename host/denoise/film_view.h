#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "denoise/cross_validation.h"
#include "film/adaptive_film.h"
#include "film/error_estimate.h"
#include "film/film.h"
#include "image/image.h"

namespace calotype {

/// A film of either kind, as denoisers need it. Keeps a reference.
class FilmView {
public:
    FilmView(const Film& film) : film_(&film) {}
    FilmView(const AdaptiveFilm& film) : film_(&film) {}

    /// Of all pixels together.
    uint64_t samples() const;
    /// Of an adaptive film the mean, rounded down.
    uint64_t samplesPerPixel() const;
    Image picture() const;
    std::optional<ErrorEstimate> error() const;

    /// The number of replicas that have samples in every pixel.
    uint32_t replicaCount() const;
    /// Whether there are kLeastReplicas of each group: then `denoise` accepts them.
    bool hasEnoughReplicas() const;
    /// Samples per pixel from which on that is so.
    uint64_t leastSamples() const;

    /// Those that have samples in every pixel. The halves of an adaptive film are groups. Needs
    /// ReplicaDetail::Color.
    std::vector<ReplicaPicture> replicas() const;

private:
    std::variant<const Film*, const AdaptiveFilm*> film_;
};

} // namespace calotype
