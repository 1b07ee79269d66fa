#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "image/texel_values.h"

namespace calotype {

/// A texture statement of an MTL file: its options and the file's name, as written.
struct MtlTexture {
    std::string file;
    std::string place;                   ///< "PATH:LINE" of the statement
    glm::dvec2 scale{1.0};               ///< -s
    glm::dvec2 offset{0.0};              ///< -o
    bool clamps = false;                 ///< -clamp on
    double bumpMultiplier = 1.0;         ///< -bm
    bool isLinear = false;               ///< -colorspace linear
    std::optional<TexelChannel> channel; ///< -imfchan
    std::vector<std::string> ignored;    ///< ignored options that should have an effect
    bool isLimited = false;              ///< some number was out of range and replaced by its end
};

/// Reads the text after a texture statement's keyword, without a comment: options, then a file
/// name, which may contain blanks, then possibly more options. -s and -o are limited to
/// ranges::kTextureCoordinate, and -bm to +-1e6. nullopt if there is no name. Throws SceneError at
/// `place` for an option whose argument is missing or invalid.
std::optional<MtlTexture> parseMtlTexture(std::string_view text, const std::string& place);

} // namespace calotype
