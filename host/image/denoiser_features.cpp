#include "image/denoiser_features.h"

#include <cstring>

#include <glm/common.hpp>

#include "base/check.h"

namespace calotype {
namespace {

/// Of the bytes: negative, 0 or positive.
int compare(const Image& a, const Image& b) {
    CALOTYPE_CHECK_EQ(a.pixels.size(), b.pixels.size());
    return std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(glm::vec3));
}

} // namespace

DenoiserFeatures denoiserFeatures(const FeatureImage& features) {
    DenoiserFeatures result{Image(features.width, features.height),
                            Image(features.width, features.height)};
    for (size_t i = 0; i < features.pixels.size(); ++i) {
        result.albedo.pixels[i] = glm::clamp(features.pixels[i].meanAlbedo, 0.0f, 1.0f);
        result.normal.pixels[i] = features.pixels[i].meanNormal;
    }
    return result;
}

bool isBefore(const DenoiserFeatures& a, const DenoiserFeatures& b) {
    const int ofAlbedo = compare(a.albedo, b.albedo);
    return ofAlbedo < 0 || (ofAlbedo == 0 && compare(a.normal, b.normal) < 0);
}

} // namespace calotype
