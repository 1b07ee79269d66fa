#include "engine/preview_denoiser.h"

#include "engine/stage_seconds.h"

namespace calotype {
namespace {

constexpr double kMostShare = 0.1; ///< of the interval

} // namespace

std::optional<CleanPicture> PreviewDenoiser::run(const Image& picture, double interval) {
    if (!denoiser_ || denoiser_->needsReplicas() || (seconds_ && *seconds_ > kMostShare * interval))
        return std::nullopt;
    return timed(seconds_.emplace(), [&] { return denoiser_->run(picture, features_, threads_); });
}

} // namespace calotype
