#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "math/rigid_transform.h"

/// What the user wrote, checked and resolved: metres, radians, linear Rec. 709, double precision,
/// every transform applied. Nothing here knows of a device.
namespace calotype {

/// Perspective pinhole camera. The three directions are orthonormal.
struct Camera {
    glm::dvec3 position{0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};
    double verticalFov = 0.7; ///< radians, in (0, pi)
};

struct FilmSettings {
    uint32_t width = 640;
    uint32_t height = 480;
};

struct RenderDefaults {
    static constexpr uint32_t kMostSamplesPerPixel = 1u << 26;
    static constexpr uint32_t kMostBounces = 1u << 20;

    uint32_t samplesPerPixel = 64;
    uint32_t maxBounces = 4; ///< scattering events along a path; 0 shows emitters only
    uint32_t seed = 0;
};

/// A diffuse reflector (report eq. 1.21) that may also emit.
struct Material {
    std::string name;
    glm::dvec3 color{0.0};    ///< reflectance in [0, 1]
    glm::dvec3 emission{0.0}; ///< radiance, W/(m^2 sr)
    bool emitsFromFrontOnly = false;
    bool visibleToCamera = true; ///< false: camera rays pass through (lights only)
};

/// Centre at the object's origin.
struct Sphere {
    RigidTransform worldFromObject;
    double radius = 1.0;
};

/// Axis +Y through the object's origin, closed by caps at y = +-height / 2 (eq. 1.5, 1.6).
struct Cylinder {
    RigidTransform worldFromObject;
    double radius = 1.0;
    double height = 1.0;
};

/// Apex at the object's origin, base at y = `height` (of either sign), radius `slope * |y|`
/// (eq. 1.10 to 1.12).
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

/// Triangles in world space. A front face runs counter-clockwise.
struct Mesh {
    static constexpr uint32_t kNoNormal = ~0u;

    struct Triangle {
        uint32_t position[3]; ///< indices into `positions`
        uint32_t normal[3];   ///< indices into `normals`, or kNoNormal in all three
        uint32_t material;    ///< index into Scene::materials
    };
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals; ///< unit length
    std::vector<Triangle> triangles;
};

struct Shape {
    std::variant<Sphere, Cylinder, Cone, Disk, Mesh> geometry;
    uint32_t material = 0; ///< index into Scene::materials; meshes carry theirs per triangle
    std::string place;     ///< file and JSON pointer, for messages
};

/// A light of the file is a shape with a black, emitting material: it is seen, reflected, sampled
/// and occludes like any other.
struct Scene {
    Camera camera;
    FilmSettings film;
    RenderDefaults render;
    std::vector<Material> materials;
    std::vector<Shape> shapes;

    uint64_t hash = 0;                 ///< of the scene's text (after --set) and all files it names
    uint64_t droppedTriangles = 0;     ///< of zero area
    std::vector<std::string> warnings; ///< complete sentences, in the order they arose
};

} // namespace calotype
