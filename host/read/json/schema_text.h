#pragma once

#include <string>

#include "read/json/type.h"

namespace calotype {

/// The schema as text: what fits into a line of 100 columns stands on one.
std::string schemaText(const SchemaJson& schema);

} // namespace calotype
