#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "base/range.h"
#include "scene/scene.h"
#include "scene/texture_ranges.h"
#include "shared/scene_structs.h"

namespace calotype {

/// A number. Where `texture` is not null, a texture may stand in its place, beside which it is 1.
struct NumberParameter {
    double Material::*number;
    uint32_t Material::*texture;
    Range range;
};

/// A colour whose channels lie in `channel`, or a texture as above.
struct ColorParameter {
    glm::dvec3 Material::*color;
    uint32_t Material::*texture;
    Range channel;
};

struct FlagParameter {
    bool Material::*flag;
};

/// One of several names.
struct ChoiceParameter {
    std::span<const std::string> names;
    void (*set)(Material&, size_t index);
};

/// What an author may say about a material of one kind: a key of scene files.
struct MaterialParameter {
    std::string name;
    std::variant<NumberParameter, ColorParameter, FlagParameter, ChoiceParameter> value;
    /// In place of an absent key, which is an error where this is nullopt. A colour's is grey, a
    /// flag's 0 or 1, a choice's the index of a name.
    std::optional<double> otherwise;
    std::string description;
    std::string unit = {};
};

/// All that the host knows of one kind of material, apart from the reference tracer.
struct MaterialKind {
    std::string name; ///< "type" in scene files
    std::string description;
    std::vector<MaterialParameter> parameters;
    /// Opaque kinds may emit light, and the alpha of their colour's texture cuts holes.
    bool isOpaque;

    /// Sets the packed material's `lobes`, and numbers that they read in a sense of their own. All
    /// other numbers are packed already.
    void (*pack)(const Material& material, shared::Material& packed);

    /// The share of the light from one direction that the material can reflect, where that is more
    /// than all of it; nullptr where a kind never exceeds it.
    std::optional<double> (*excessAlbedo)(const Material& material, TextureRanges& textures);
    /// What to say of such a share.
    std::string (*excessWarning)(const Material& material, double albedo);
};

/// In the order of MaterialType.
std::span<const MaterialKind> materialKinds();

const MaterialKind& kindOf(const Material& material);

} // namespace calotype
