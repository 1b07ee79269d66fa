#include "read/json/displacement.h"

#include "read/json/texture_slots.h"

namespace calotype {

Displacement readDisplacement(const JsonValue& value, const LoadContext& context) {
    const JsonObject object(value, {"texture", "scale", "mid", "subdivide"});
    Displacement displacement;
    displacement.texture = readTextureName(object.required("texture"), context);
    displacement.scale = object.required("scale").number();
    displacement.mid = object.number("mid", displacement.mid);
    displacement.subdivide =
        object.wholeNumber("subdivide", 0, Displacement::kMostSubdivisions, displacement.subdivide);
    if (context.scene.textures[displacement.texture].isMissing) {
        displacement.scale = 0.0;
    }
    displacement.place = value.child("subdivide").where();
    return displacement;
}

} // namespace calotype
