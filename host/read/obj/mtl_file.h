#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "read/obj/mtl_texture.h"
#include "read/obj/occurrences.h"

namespace calotype {

/// One material of an MTL file, as written: numbers are finite, but may be out of range.
struct MtlMaterial {
    std::filesystem::path directory; ///< of the MTL file: textures are relative to it
    bool isFromBlender = false;      ///< see mtl_blender.h

    std::optional<glm::dvec3> ambient;  ///< Ka
    std::optional<glm::dvec3> diffuse;  ///< Kd
    std::optional<glm::dvec3> specular; ///< Ks
    std::optional<glm::dvec3> emission; ///< Ke
    std::optional<glm::dvec3> filter;   ///< Tf
    std::optional<double> exponent;     ///< Ns
    std::optional<double> dissolve;     ///< d
    std::optional<double> transparency; ///< Tr
    std::optional<double> ior;          ///< Ni
    std::optional<double> roughness;    ///< Pr
    std::optional<double> metallic;     ///< Pm
    std::optional<double> illumination; ///< illum, which should be a whole number
    double transmission = 0.0;          ///< a weight, see mtl_blender.h; not a statement

    std::optional<MtlTexture> diffuseMap;
    std::optional<MtlTexture> alphaMap;
    std::optional<MtlTexture> bumpMap;   ///< map_Bump, bump
    std::optional<MtlTexture> normalMap; ///< norm
    std::optional<MtlTexture> roughnessMap;
    std::optional<MtlTexture> metallicMap;
    std::optional<MtlTexture> emissionMap;
    std::optional<MtlTexture> exponentMap;   ///< map_Ns; from Blender only, as the next two
    std::optional<MtlTexture> specularMap;   ///< map_Ks
    std::optional<MtlTexture> reflectionMap; ///< map_refl, refl before 3.1

    /// Statements whose effect is not rendered: in lower case, and as written.
    std::map<std::string, std::string> unsupported;
};

struct MtlFile {
    std::map<std::string, MtlMaterial> materials; ///< by what follows "newmtl"
    /// Statements that were ignored or changed, by a sentence about them that a number completes.
    std::map<std::string, Occurrences> remarks;
};

/// Whether there is a file of this name, relative to the MTL file.
using FileExists = std::function<bool(const std::string& name)>;

/// Reads the text of the MTL file at `path` (also the name for messages), ignoring the case of
/// keywords. A colour of one number is grey; numbers after the third are passed over. Statements
/// that cannot be read are left out, with a remark. `exists` decides whether a '#' in the name of a
/// texture starts a comment.
MtlFile parseMtl(std::string_view text, const std::string& path, const FileExists& exists);

} // namespace calotype
