#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"

namespace calotype {

/// Each reads one value of the command line. Throws UsageError with the option, the value and what
/// is expected.
PreviewInterval parsePreviewInterval(const std::string& text); ///< --preview-every "16" or "10s"
SceneOverride parseOverride(const std::string& text);          ///< --set "/pointer=value"
MissingTextures parseMissingTextures(const std::string& text); ///< --missing-textures
/// --from "1,2,3" and others. Messages name `option`.
glm::dvec3 parsePoint(const std::string& option, const std::string& text);
glm::dvec3 parseUp(const std::string& text);      ///< --up "0,1,0", not zero
double parseFieldOfView(const std::string& text); ///< --fov, in degrees
ToneMap parseToneMap(const std::string& text);    ///< --tonemap
/// --exposure "-1.5", in stops; none: "auto"
std::optional<float> parseExposure(const std::string& text);
double parseMaxRelativeMse(const std::string& text);  ///< --max-relmse "1e-3"
BlockRange parseSampleRange(const std::string& text); ///< --require "0:1024"

ProgressStyle parseProgressStyle(const std::string& text); ///< --progress "text" or "json"
LayerList parseLayers(const std::string& text);            ///< --aov "albedo,normal,error"
/// "30s", "1.5m", "2h", or a number of seconds; above 0. Messages name `option`.
double parseDuration(const std::string& option, const std::string& text);

} // namespace calotype
