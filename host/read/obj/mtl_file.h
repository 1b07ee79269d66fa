#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "read/obj/mtl_texture.h"

namespace calotype {

/// One material of an MTL file, as written: numbers are finite, but may be out of range.
struct MtlMaterial {
    std::filesystem::path directory;    ///< of the MTL file: textures are relative to it
    std::optional<glm::dvec3> diffuse;  ///< Kd
    std::optional<glm::dvec3> emission; ///< Ke
    glm::dvec3 specular{0.0};           ///< Ks
    glm::dvec3 filter{1.0};             ///< Tf
    std::optional<double> exponent;     ///< Ns
    std::optional<double> dissolve;     ///< d
    std::optional<double> transparency; ///< Tr
    std::optional<double> ior;          ///< Ni
    std::optional<double> roughness;    ///< Pr
    std::optional<double> metallic;     ///< Pm
    double illumination = 2.0;          ///< illum, which should be a whole number
    std::optional<MtlTexture> diffuseMap;
    std::optional<MtlTexture> alphaMap;
    std::optional<MtlTexture> bumpMap;   ///< map_Bump, bump
    std::optional<MtlTexture> normalMap; ///< norm
    std::optional<MtlTexture> roughnessMap;
    std::optional<MtlTexture> emissionMap;
    std::set<std::string> unsupported; ///< statements whose effect is not rendered
};

/// Reads the text of the MTL file at `path` (also the name for messages), ignoring the case of
/// keywords. Throws SceneError at "PATH:LINE" for colours that are not one or three numbers of 0 or
/// greater, for other numbers that are missing or not finite, and for options of a texture that are
/// invalid or out of range (see parseMtlTexture).
std::map<std::string, MtlMaterial> parseMtl(std::string_view text, const std::string& path);

} // namespace calotype
