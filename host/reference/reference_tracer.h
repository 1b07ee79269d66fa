#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "image/features.h"
#include "image/first_hit.h"
#include "reference/geometry.h"
#include "reference/lights.h"
#include "reference/path.h"
#include "reference/random.h"
#include "scene/scene.h"
#include "settings/texture_filter.h"
#include "settings/transport.h"

namespace calotype::reference {

/// A path tracer in double precision, directly from the scene, to test the device's results. It
/// uses the device's random numbers for the same purposes, so that single paths can be compared;
/// everything else is implemented independently.
class ReferenceTracer {
public:
    /// Keeps a reference to the scene. `filter` replaces that of each texture, if there is one.
    /// `imageSize` is that of the whole film.
    ReferenceTracer(const Scene& scene, const glm::uvec2& imageSize, uint32_t maxBounces,
                    const TransportSettings& transport = {},
                    const std::optional<TextureFilter>& filter = {});
    ReferenceTracer(const Scene&&, const glm::uvec2&, uint32_t, const TransportSettings& = {},
                    const std::optional<TextureFilter>& = {}) = delete;

    /// Largest emitted radiance of any channel, W/(m^2 sr).
    double maxRadiance() const { return lights_.maxRadiance(); }

    /// One sample of one pixel. May be called from several threads.
    PathSample trace(const SampleId& id) const;

    /// What one ray of one pixel shows.
    RayFeatures features(const SampleId& id) const;

    /// The first hit of the ray through the centres of the pixel and of the lens.
    FirstHit firstHit(const glm::uvec2& pixel) const { return firstHitAt(glm::dvec2(pixel) + 0.5); }

    /// The same through any position on the film, in pixels from its top left corner.
    FirstHit firstHitAt(const glm::dvec2& filmPosition) const;

private:
    PathSetup setup() const;

    const Scene& scene_;
    std::vector<Texture> textures_; ///< of the scene, with the filter; images are shared
    glm::uvec2 imageSize_;
    uint32_t maxBounces_;
    TransportSettings transport_;
    Geometry geometry_;
    Lights lights_;
};

} // namespace calotype::reference
