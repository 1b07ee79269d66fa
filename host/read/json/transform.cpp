#include "read/json/transform.h"

#include <nlohmann/json.hpp>

#include "math/rotation.h"

namespace calotype {
namespace {

const JsonObjectType& transformType() {
    static const JsonObjectType type = {
        {
            JsonKey("translate", vectorType(), "The last step.")
                .in("metres")
                .orElseJson("[0, 0, 0]"),
            JsonKey("rotate", vectorType(), "Angles about X, then Y, then Z: the second step.")
                .in("degrees")
                .orElseJson("[0, 0, 0]"),
            JsonKey("scale", scaleType(),
                    "The first step: one factor, or one each for x, y and z. Negative factors "
                    "mirror.")
                .orElse(1.0),
            JsonKey("matrix", matrixType(), "worldFromObject, in place of the three steps."),
        },
        {exclude("matrix", "translate"), exclude("matrix", "rotate"), exclude("matrix", "scale")},
        "worldFromObject: scale, then rotate, then translate; or a matrix. Quadrics and disks "
        "accept uniform scale only."};
    return type;
}

glm::dvec3 readScale(const JsonValue& value) {
    return value.json().is_number() ? glm::dvec3(value.number()) : value.vector();
}

AffineTransform readParts(const JsonObject& object) {
    const glm::dmat3 rotation = rotationFromDegrees(object.vector("rotate", glm::dvec3(0.0)));
    const auto scaleValue = object.optional("scale");
    const glm::dvec3 scale = scaleValue ? readScale(*scaleValue) : glm::dvec3(1.0);
    return {{rotation[0] * scale.x, rotation[1] * scale.y, rotation[2] * scale.z},
            object.vector("translate", glm::dvec3(0.0))};
}

} // namespace

JsonKey transformKey() {
    return {"transform", transformType().asType("transform"), "worldFromObject."};
}

AffineTransform readMatrix(const JsonValue& value) {
    const std::vector<JsonValue> entries = value.array(16);
    AffineTransform transform;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            transform.linear[column][row] = entries[4 * row + column].number();
        transform.translation[row] = entries[4 * row + 3].number();
    }
    for (int column = 0; column < 4; ++column)
        if (entries[12 + column].number() != (column == 3 ? 1.0 : 0.0))
            value.fail("the last row must be 0 0 0 1 (the matrix is row-major and affine)");
    if (isSingular(transform.linear))
        value.fail("the matrix flattens space (it cannot be inverted)");
    return transform;
}

AffineTransform readTransform(const JsonObject& shape) {
    const auto value = shape.optional("transform");
    if (!value)
        return {};
    const JsonObject object(*value, transformType());
    if (const auto matrix = object.optional("matrix"))
        return readMatrix(*matrix);
    const AffineTransform transform = readParts(object);
    if (isSingular(transform.linear)) {
        value->child("scale").fail("flattens the shape: it must not be 0, nor 1e100 times "
                                   "as large along one axis as along another");
    }
    return transform;
}

SimilarityTransform readSimilarity(const JsonObject& shape) {
    const auto similarity = asSimilarity(readTransform(shape));
    if (!similarity) {
        shape.required("transform")
            .fail("this shape accepts rotation, translation and uniform scale only; use a mesh for "
                  "anything else");
    }
    return *similarity;
}

} // namespace calotype
