#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/range.h"
#include "read/json/value.h"
#include "scene/ranges.h"

namespace calotype {

using SchemaJson = nlohmann::ordered_json;

/// A type of values in a scene file.
struct JsonType {
    /// Throws SceneError if the value has another type. Empty for objects and types that contain
    /// them: JsonObject checks these when they are read.
    std::function<void(const JsonValue&)> check;

    /// The type as JSON Schema (draft 07). Adds its named parts to `definitions`.
    std::function<SchemaJson(SchemaJson& definitions)> schema;
};

JsonType numberType(const Range& range);
JsonType nonZeroNumberType();
JsonType wholeNumberType(const ranges::WholeRange& range);
JsonType booleanType();
JsonType textType();
/// Exactly this text. The schema shows the description.
JsonType constantType(const std::string& text, const std::string& description);
/// One of `names`, which must outlive the type.
JsonType choiceType(std::span<const std::string> names);

JsonType vectorType();
/// A vector that is not zero.
JsonType directionType();
/// 16 numbers, row-major, of an affine transform.
JsonType matrixType();
/// One factor, or three for x, y and z; not 0.
JsonType scaleType();

/// An array of exactly `count` values of one type.
JsonType arrayType(const JsonType& element, size_t count);
/// An array of any length.
JsonType arrayType(const JsonType& element);
/// An object whose keys are names that the author chooses.
JsonType mapType(const JsonType& value);

/// A colour whose channels are in ranges::kShare.
JsonType reflectanceType();
/// A colour whose channels are in ranges::kRadiance.
JsonType radianceType();
JsonType textureNameType();
JsonType materialNameType();
JsonType reflectanceOrTextureType();
/// A number in `range`, or the name of a texture whose first channel is read.
JsonType numberOrTextureType(const Range& range);

/// `type`, which the schema defines once under `name`, and refers to elsewhere.
JsonType namedType(const std::string& name, const JsonType& type);

} // namespace calotype
