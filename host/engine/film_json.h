#pragma once

#include <nlohmann/json_fwd.hpp>

#include "film/film_file.h"

namespace calotype {

/// What a film holds, as a JSON document (docs/json.md).
nlohmann::ordered_json filmJson(const KeptFilm& kept);

/// Names and drivers of all devices that rendered the film, separated by "; ".
std::string devicesOf(const FilmLabel& label);

} // namespace calotype
