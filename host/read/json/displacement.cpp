#include "read/json/displacement.h"

#include "read/json/textures.h"

namespace calotype {
namespace {

const JsonObjectType& displacementType() {
    static const JsonObjectType type = {
        {
            JsonKey("texture", textureNameType(),
                    "The texture of heights; its first channel is read.")
                .required(),
            JsonKey("scale", numberType(ranges::kAnyNumber),
                    "The way, in object space, that a value of 1 above mid moves a position.")
                .in("metres")
                .required(),
            JsonKey("mid", numberType(ranges::kAnyNumber), "The value that moves nothing.")
                .orElse(Displacement().mid),
            JsonKey("subdivide", wholeNumberType({0, Displacement::kMostSubdivisions}),
                    "Times that each triangle becomes four. A mesh may become 16,777,216 "
                    "triangles at most.")
                .orElse(0.0),
        },
        {},
        "Moves a mesh's positions along their normals by scale * (value - mid). A mesh's own is "
        "used in place of its materials'; where those differ in subdivide, the largest is used for "
        "the whole mesh, which stays watertight."};
    return type;
}

} // namespace

JsonKey displacementKey() {
    return {"displacement", displacementType().asType("displacement"),
            "Moves the positions of meshes along their normals."};
}

Displacement readDisplacement(const JsonValue& value, const JsonContext& context) {
    const JsonObject object(value, displacementType());
    Displacement displacement;
    displacement.texture = findTexture(object.required("texture"), context);
    displacement.scale = object.required("scale").number();
    displacement.mid = object.number("mid", displacement.mid);
    if (const auto subdivide = object.optional("subdivide"))
        displacement.subdivide = static_cast<uint32_t>(subdivide->number());
    if (context.scene.textures[displacement.texture].isMissing)
        displacement.scale = 0.0;
    displacement.place = value.child("subdivide").where();
    return displacement;
}

} // namespace calotype
