#include "denoise/film_view.h"

#include <algorithm>
#include <array>

#include "shared/limits.h"

namespace calotype {
namespace {

using shared::kReplicas;

constexpr uint32_t groupsOf(const Film&) { return 1; }
constexpr uint32_t groupsOf(const AdaptiveFilm&) { return AdaptiveFilm::kHalves; }

uint64_t samplesOf(const Film& film) { return film.samplesPerPixel() * film.pixelCount(); }
uint64_t samplesOf(const AdaptiveFilm& film) { return film.samples(); }

/// One number for all pixels, or one for each.
std::vector<uint32_t> samplesOfReplica(const Film& film, uint32_t replica) {
    return {static_cast<uint32_t>(film.samplesOfReplica(replica))};
}

std::vector<uint32_t> samplesOfReplica(const AdaptiveFilm& film, uint32_t replica) {
    std::vector<uint32_t> samples(film.pixelCount());
    for (size_t pixel = 0; pixel < samples.size(); ++pixel)
        samples[pixel] = static_cast<uint32_t>(film.samplesOfReplica(replica, pixel));
    return samples;
}

/// Whether every pixel has samples of the replica.
template <typename AnyFilm>
bool isWhole(const AnyFilm& film, uint32_t replica) {
    return std::ranges::count(samplesOfReplica(film, replica), 0u) == 0;
}

} // namespace

uint64_t FilmView::samples() const {
    return std::visit([](const auto* film) { return samplesOf(*film); }, film_);
}

uint64_t FilmView::samplesPerPixel() const {
    return std::visit([](const auto* film) { return samplesOf(*film) / film->pixelCount(); },
                      film_);
}

Image FilmView::picture() const {
    return std::visit([](const auto* film) { return film->picture(); }, film_);
}

std::optional<ErrorEstimate> FilmView::error() const {
    return std::visit([](const auto* film) { return estimateError(*film); }, film_);
}

uint32_t FilmView::replicaCount() const {
    return std::visit(
        [](const auto* film) {
            uint32_t count = 0;
            for (uint32_t replica = 0; replica < kReplicas; ++replica)
                count += isWhole(*film, replica) ? 1 : 0;
            return count;
        },
        film_);
}

bool FilmView::hasEnoughReplicas() const {
    return std::visit(
        [](const auto* film) {
            const uint32_t groups = groupsOf(*film);
            std::array<size_t, AdaptiveFilm::kHalves> counts{};
            for (uint32_t replica = 0; replica < kReplicas; ++replica)
                counts[replica % groups] += isWhole(*film, replica) ? 1 : 0;
            return *std::min_element(counts.begin(), counts.begin() + groups) >= kLeastReplicas;
        },
        film_);
}

uint64_t FilmView::leastSamples() const {
    return std::visit(
        [](const auto* film) {
            return uint64_t{kLeastReplicas} * groupsOf(*film) * shared::kSamplesPerBlock;
        },
        film_);
}

std::vector<ReplicaPicture> FilmView::replicas() const {
    return std::visit(
        [](const auto* film) {
            std::vector<ReplicaPicture> replicas;
            for (uint32_t i = 0; i < kReplicas; ++i)
                if (isWhole(*film, i))
                    replicas.push_back(
                        {film->replicaPicture(i), samplesOfReplica(*film, i), i % groupsOf(*film)});
            return replicas;
        },
        film_);
}

} // namespace calotype
