#pragma once

#include "read/load_context.h"

namespace calotype {

/// One element of the scene file's "shapes".
Shape readShape(const JsonValue& value, LoadContext& context);

} // namespace calotype
