#pragma once

#include <string>

#include "read/json/type.h"

namespace calotype {

/// The schema as text: a value is on one line if it fits into 100 columns.
std::string schemaText(const SchemaJson& schema);

} // namespace calotype
