#pragma once

#include <nlohmann/json_fwd.hpp>

#include "film/film_file.h"

namespace calotype {

/// What a film holds, as a JSON document (docs/json.md).
nlohmann::ordered_json filmJson(const KeptFilm& kept);

} // namespace calotype
