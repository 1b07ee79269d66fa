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

/// A number. If `texture` is not null, it may be a texture; then the number is 1.
struct NumberParameter {
    double Material::*number;
    uint32_t Material::*texture;
    Range range;
};

/// A colour whose channels are in `channel`; or a texture, as above.
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

/// A parameter of materials of one kind: a key of scene files.
struct MaterialParameter {
    std::string name;
    std::variant<NumberParameter, ColorParameter, FlagParameter, ChoiceParameter> value;
    /// The value if the key is absent; nullopt: the key is required. For a colour a grey, for a
    /// flag 0 or 1, for a choice the index of a name.
    std::optional<double> otherwise;
    std::string description;
    std::string unit = {};
};

/// All facts about one kind of material, except in the reference tracer.
struct MaterialKind {
    std::string name; ///< "type" in scene files
    std::string description;
    std::vector<MaterialParameter> parameters;
    /// Opaque kinds may emit light, and the alpha of their colour's texture makes holes.
    bool isOpaque;

    /// Sets the packed material's `lobes`, those numbers that have a special meaning for them, and
    /// those that only this kind has. The others are packed before.
    void (*pack)(const Material& material, shared::Material& packed);

    /// The largest share of the light from one direction that the material can reflect, if it is
    /// above 1; else nullopt. nullptr if that never happens for this kind.
    std::optional<double> (*excessAlbedo)(const Material& material, TextureRanges& textures);
    /// The warning about such a share.
    std::string (*excessWarning)(const Material& material, double albedo);
};

/// In the order of MaterialType.
std::span<const MaterialKind> materialKinds();

const MaterialKind& kindOf(const Material& material);

} // namespace calotype
