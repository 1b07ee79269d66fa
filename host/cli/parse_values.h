#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "settings/bvh_builder.h"
#include "settings/light_choice.h"
#include "settings/sampler.h"

namespace calotype {

/// Each reads one value of the command line, and throws UsageError naming the option, the value and
/// what is expected.
PictureSize parseSize(const std::string& text);                ///< --size "640x480"
Crop parseCrop(const std::string& text);                       ///< --crop "X,Y,W,H"
PreviewInterval parsePreviewInterval(const std::string& text); ///< --preview-every "16" or "10s"
SceneOverride parseOverride(const std::string& text);          ///< --set "/pointer=value"
MissingTextures parseMissingTextures(const std::string& text); ///< --missing-textures
ToneMap parseToneMap(const std::string& text);                 ///< --tonemap
float parseExposure(const std::string& text);                  ///< --exposure "-1.5", in stops
std::optional<BvhBuilder> parseBvh(const std::string& text);   ///< --bvh
Sampler parseSampler(const std::string& text);                 ///< --sampler
LightChoice parseLightChoice(const std::string& text);         ///< --light-choice
std::optional<TextureFilter> parseTextureFilter(const std::string& text); ///< --texture-filter
float parseIndirectClamp(const std::string& text);                        ///< --clamp-indirect
/// "on" or "off". `option` is named in the message.
bool parseSwitch(const std::string& option, const std::string& text);
double parseMaxRelativeMse(const std::string& text); ///< --max-relmse "1e-3"

LayerList parseLayers(const std::string& text);    ///< --aov "albedo,normal,error"
SampleRange parseSamples(const std::string& text); ///< --samples "0:64"
double parseTargetError(const std::string& text);  ///< --target-error "0.02"
/// "30s", "1.5m", "2h", or a number of seconds; above 0. `option` is named in the message.
double parseDuration(const std::string& option, const std::string& text);

} // namespace calotype
