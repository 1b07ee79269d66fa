#include "engine/picture_denoiser.h"

#include <algorithm>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "denoise/oidn_denoiser.h"
#include "film/error_estimate.h"
#include "shared/limits.h"

namespace calotype {
namespace {

DenoiserFeatures guidesOf(const FeatureImage& features) {
    DenoiserFeatures guides{Image(features.width, features.height),
                            Image(features.width, features.height)};
    for (size_t i = 0; i < features.pixels.size(); ++i) {
        guides.albedo.pixels[i] = glm::clamp(features.pixels[i].meanAlbedo, 0.0f, 1.0f);
        guides.normal.pixels[i] = features.pixels[i].meanNormal;
    }
    return guides;
}

std::vector<ReplicaPicture> replicasOf(const Film& film) {
    std::vector<ReplicaPicture> replicas;
    for (uint32_t i = 0; i < shared::kReplicas; ++i)
        if (const uint64_t samples = film.samplesOfReplica(i))
            replicas.push_back({film.replicaPicture(i), static_cast<double>(samples)});
    return replicas;
}

} // namespace

PictureDenoiser::PictureDenoiser(DenoiserKind kind, const std::string& library)
    : library_(library) {
    CALOTYPE_CHECK_EQ(kind == DenoiserKind::Oidn, true);
    try { // now, not after the render
        OidnDenoiser(library_, {Image(1, 1), Image(1, 1)}, Image(1, 1), 1);
    } catch (const Error& error) {
        throw SettingError("denoise", std::string("cannot be used here: ") + error.what());
    }
}

CleanPicture PictureDenoiser::run(const Film& film, const Image& noisy,
                                  const FeatureImage& features, uint32_t threads) const {
    OidnDenoiser denoiser(library_, guidesOf(features), noisy, threads);
    const std::vector<ReplicaPicture> replicas = replicasOf(film);
    if (replicas.size() < kLeastReplicas)
        return {denoiser.run(noisy), denoiser.name(), {}};
    DenoisedPicture picture = denoise(replicas, denoiser);
    const auto own = estimateError(film);
    const bool isTrusted = own && own->isTrusted();
    return {std::move(picture.color), denoiser.name(), isTrusted ? picture.error : std::nullopt};
}

} // namespace calotype
