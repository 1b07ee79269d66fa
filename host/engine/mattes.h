#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "image/coverage.h"
#include "image/layer.h"
#include "image/picture.h"
#include "scene/matte_names.h"
#include "scene/scene.h"

namespace calotype {

/// The mattes of a picture: Cryptomatte layers.
class Mattes {
public:
    Mattes() = default;

    /// For those of the layers whose source is Mattes, in a picture of `pixels` pixels.
    Mattes(const Scene& scene, const LayerList& layers, size_t pixels);

    bool areWanted() const { return !mattes_.empty(); }

    /// Adds what a ray of each pixel shows, as OnPrimitives has it.
    void addRay(std::span<const uint32_t> primitives);

    /// Of a layer of the constructor.
    std::vector<Channel> channelsOf(const Layer& layer) const;

    /// Adds the attributes of all layers.
    void describe(Picture& picture) const;

private:
    struct Matte {
        MatteNames names;
        Coverage coverage;
    };
    std::map<const Layer*, Matte> mattes_;
};

} // namespace calotype
