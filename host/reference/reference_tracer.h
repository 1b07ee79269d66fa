#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "image/first_hit.h"
#include "reference/geometry.h"
#include "reference/lights.h"
#include "reference/path.h"
#include "reference/random.h"
#include "scene/scene.h"
#include "settings/transport.h"

namespace calotype::reference {

/// A path tracer in double precision, straight from the scene: what the device's is judged by. It
/// draws the device's random numbers and puts them to the device's use, so that single paths can be
/// compared; all else is written anew.
class ReferenceTracer {
public:
    /// Keeps a reference to the scene. `imageSize` is that of the whole film.
    ReferenceTracer(const Scene& scene, const glm::uvec2& imageSize, uint32_t maxBounces,
                    const TransportSettings& transport = {});
    ReferenceTracer(const Scene&&, const glm::uvec2&, uint32_t,
                    const TransportSettings& = {}) = delete;

    /// Largest emitted radiance of any channel, W/(m^2 sr).
    double maxRadiance() const { return lights_.maxRadiance(); }

    /// One sample of one pixel. May be called from several threads.
    PathSample trace(const SampleId& id) const;

    /// What the ray through the pixel's centre and the lens's meets first.
    FirstHit firstHit(const glm::uvec2& pixel) const { return firstHitAt(glm::dvec2(pixel) + 0.5); }

    /// Likewise through any position on the film, in pixels from its top left corner.
    FirstHit firstHitAt(const glm::dvec2& filmPosition) const;

private:
    const Scene& scene_;
    glm::uvec2 imageSize_;
    uint32_t maxBounces_;
    TransportSettings transport_;
    Geometry geometry_;
    Lights lights_;
};

} // namespace calotype::reference
