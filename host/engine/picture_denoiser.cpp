#include "engine/picture_denoiser.h"

#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "denoise/oidn_denoiser.h"
#include "denoise/statistical_denoiser.h"
#include "engine/devices.h"
#include "render/statistical_pass.h"
#include "shared/limits.h"

namespace calotype {
namespace {

/// Why the error of a denoised film is not stated; empty if it is.
std::string whyUnstatedFor(const FilmView& film, const std::optional<DenoisedError>& error) {
    const auto ofSamples = film.error(); // none for a black film, too
    const bool hasAll = film.samplesPerPixel() >= shared::kReplicas * shared::kSamplesPerBlock;
    const Trust otherwise = hasAll ? Trust::RareLight : Trust::TooFewSamples;
    switch (ofSamples ? ofSamples->trust() : otherwise) {
    case Trust::TooFewSamples:
        return "too few samples to tell";
    case Trust::RareLight:
        return "that of the samples is not to be trusted";
    case Trust::Trusted:
        break;
    }
    return error ? "" : "the picture is too small to tell";
}

} // namespace

PictureDenoiser::PictureDenoiser(DenoiserKind kind, const std::string& library,
                                 DeviceKeeper* device)
    : kind_(kind), device_(device) {
    if (kind != DenoiserKind::Oidn)
        return;
    library_.emplace(library);
    try { // now, not after the render
        OidnDenoiser(*library_, nullptr, Image(1, 1), 1);
    } catch (const Error& error) {
        throw SettingError("denoise", std::string("cannot be used here: ") + error.what());
    }
}

std::string PictureDenoiser::whyTooFewSamples(const FilmView& film) const {
    if (!needsReplicas() || film.hasEnoughReplicas())
        return "";
    return "the statistical denoiser needs at least " + std::to_string(film.leastSamples()) +
           " samples per pixel";
}

CleanPicture PictureDenoiser::run(const FilmView& film, const Image& noisy,
                                  const std::optional<DenoiserFeatures>& features, uint32_t threads,
                                  const OnProgress& onProgress) const {
    if (!whyTooFewSamples(film).empty())
        return {noisy, "", {}, whyUnstatedFor(film, {})};
    if (!film.hasEnoughReplicas()) {
        CleanPicture picture = run(noisy, features, threads);
        picture.whyUnstated = whyUnstatedFor(film, {});
        return picture;
    }
    const auto denoiser = denoiserFor(features, film.picture(), threads);
    DenoisedPicture picture = denoise(film.replicas(), *denoiser, threads, onProgress);
    std::string whyUnstated = whyUnstatedFor(film, picture.error);
    const bool isStated = whyUnstated.empty();
    return {std::move(picture.color), denoiser->name(), isStated ? picture.error : std::nullopt,
            std::move(whyUnstated)};
}

CleanPicture PictureDenoiser::run(const Image& noisy,
                                  const std::optional<DenoiserFeatures>& features,
                                  uint32_t threads) const {
    CALOTYPE_CHECK_EQ(needsReplicas(), false);
    const auto denoiser = denoiserFor(features, noisy, threads);
    return {denoiser->run({noisy, {}, 0}), denoiser->name(), {}, ""};
}

std::unique_ptr<Denoiser>
PictureDenoiser::denoiserFor(const std::optional<DenoiserFeatures>& features, const Image& typical,
                             uint32_t threads) const {
    if (kind_ == DenoiserKind::Oidn)
        return std::make_unique<OidnDenoiser>(*library_, features ? &*features : nullptr, typical,
                                              threads);
    const Image black(typical.width, typical.height);
    DenoiserFeatures known = features.value_or(DenoiserFeatures{black, black});
    if (!device_ || isReference(device_->options()))
        return std::make_unique<StatisticalDenoiser>(std::move(known), threads);
    return std::make_unique<StatisticalPass>(device_->session()->device(), std::move(known),
                                             threads);
}

} // namespace calotype
