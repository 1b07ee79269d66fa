#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "math/rigid_transform.h"
#include "scene/texture.h"
#include "settings/denoiser_kind.h"

/// The scene of the user, checked and resolved: metres, radians, linear Rec. 709, double precision,
/// all transforms applied. Independent of devices.
namespace calotype {

enum class Projection : uint8_t { Perspective, Orthographic };

/// A pinhole or a thin lens. The three directions are orthonormal.
struct Camera {
    Projection projection = Projection::Perspective;
    glm::dvec3 position{0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};
    double verticalFov = 0.7;   ///< perspective: radians, in (0, pi)
    double viewHeight = 1.0;    ///< orthographic: metres from the picture's bottom to its top
    double lensRadius = 0.0;    ///< metres; 0 is a pinhole
    double focusDistance = 1.0; ///< metres along `forward` to the plane of focus
};

/// Reconstruction filter of the film: box 1 pixel wide; tent of radius 1; Gaussian of sigma 0.5 cut
/// off at 1.5; Blackman-Harris window of radius 1.5. All except the box overlap other pixels.
enum class FilmFilter : uint8_t { Box, Tent, Gaussian, BlackmanHarris };

struct FilmSettings {
    uint32_t width = 640;
    uint32_t height = 480;
    FilmFilter filter = FilmFilter::Box;
};

struct RenderDefaults {
    uint32_t samplesPerPixel = 64;
    uint32_t maxBounces = 4; ///< scattering events along a path; 0 shows emitters only
    uint32_t seed = 0;
    DenoiserKind denoiser = DenoiserKind::Off;
    bool hidesBackground = false; ///< as TransportSettings::hidesBackground
};

enum class MaterialType : uint8_t { Diffuse, Metal, Nonmetal, BlinnPhong, Dielectric };

/// Shadowing and masking of the GGX lobe (docs/models.md, "GGX masking").
enum class Masking : uint8_t { Schlick, Smith };

/// How a surface scatters light; docs/models.md has the equations. A field that does not belong to
/// the material's type is not used. A texture multiplies the number of the same name.
struct Material {
    static constexpr uint32_t kNoTexture = ~0u;
    static constexpr double kHighestExponent = 1e7;

    std::string name;
    std::string place; ///< file and JSON pointer, for messages; for an MTL material its OBJ file
    MaterialType type = MaterialType::Diffuse;
    glm::dvec3 color{0.0}; ///< reflectance, a metal's F0, or a dielectric's tint for each crossing
    uint32_t colorTexture = kNoTexture; ///< index into Scene::textures, like all below
    double roughness = 0.0;             ///< metal, nonmetal: in [0, 1]; alpha is its square
    uint32_t roughnessTexture = kNoTexture;
    double specular = 0.04; ///< nonmetal: F0
    uint32_t specularTexture = kNoTexture;
    Masking masking = Masking::Schlick; ///< metal, nonmetal
    double kd = 1.0;                    ///< blinn_phong: weight of the diffuse lobe
    double ks = 0.0;                    ///< blinn_phong: weight of the specular lobe
    double exponent = 0.0;              ///< blinn_phong: up to kHighestExponent
    bool normalize = false;             ///< blinn_phong: the energy-conserving form
    double ior = 1.5;                   ///< dielectric: of the inside
    double exteriorIor = 1.0;           ///< dielectric: of the outside
    uint32_t normalMap = kNoTexture;
    uint32_t alphaTexture = kNoTexture; ///< its alpha lets light through
    double opacity = 1.0;               ///< share of the light that meets the surface, in [0, 1]
    glm::dvec3 emission{0.0};           ///< radiance, W/(m^2 sr)
    bool emitsFromFrontOnly = false;
    bool visibleToCamera = true; ///< false: camera rays pass through (lights only)
};

/// Centre at the object's origin.
struct Sphere {
    RigidTransform worldFromObject;
    double radius = 1.0;
};

/// Axis +Y through the object's origin, closed by caps at y = +-height / 2.
struct Cylinder {
    RigidTransform worldFromObject;
    double radius = 1.0;
    double height = 1.0;
};

/// Apex at the object's origin, closed by its base at y = `height` (of either sign). The radius is
/// `slope * |y|`.
struct Cone {
    RigidTransform worldFromObject;
    double height = 1.0;
    double slope = 1.0;
};

/// Centre at the object's origin, front along +Y.
struct Disk {
    RigidTransform worldFromObject;
    double radius = 1.0;
};

/// Triangles in world space. The corners are counter-clockwise, seen from the front.
struct Mesh {
    static constexpr uint32_t kNoNormal = ~0u;
    static constexpr uint32_t kNoUv = ~0u;

    struct Triangle {
        uint32_t position[3]; ///< indices into `positions`
        uint32_t normal[3];   ///< indices into `normals`, or kNoNormal in all three
        uint32_t material;    ///< index into Scene::materials
        uint32_t uv[3] = {kNoUv, kNoUv, kNoUv}; ///< indices into `uvs`, or kNoUv in all three
    };
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals; ///< unit length
    std::vector<glm::dvec2> uvs;
    std::vector<Triangle> triangles;
};

struct Shape {
    std::variant<Sphere, Cylinder, Cone, Disk, Mesh> geometry;
    uint32_t material = 0; ///< index into Scene::materials; meshes carry theirs per triangle
    std::string place;     ///< file and JSON pointer, for messages
    std::string file = {}; ///< that a mesh was read from, for messages; else empty
    std::string name = {}; ///< of the object; shapes of one name are one object. Empty: a default
};

/// A light of the file is a shape with a black, emitting material: it is seen, reflected, sampled,
/// and it occludes, like any other shape.
struct Scene {
    std::string place = "scene"; ///< its file, for messages
    Camera camera;
    FilmSettings film;
    RenderDefaults render;
    glm::dvec3 background{0.0}; ///< from all directions, W/(m^2 sr)
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Shape> shapes;

    uint64_t hash = 0;                 ///< of the scene's text (after --set) and all files it names
    uint64_t droppedTriangles = 0;     ///< of zero area
    std::vector<std::string> warnings; ///< complete sentences, in the order they arose
};

} // namespace calotype
