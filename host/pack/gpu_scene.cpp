#include "pack/gpu_scene.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "pack/filter_table.h"
#include "pack/pack_camera.h"
#include "pack/pack_lights.h"
#include "pack/pack_material.h"
#include "pack/pack_node.h"
#include "pack/pack_shapes.h"

namespace calotype {
namespace {

/// Names and rows of nodes and primitives have to fit into their bits.
void requireIndexable(size_t nodes, size_t primitives) {
    constexpr size_t kMost = size_t{1} << 28;
    if (std::max(nodes, primitives) > kMost)
        throw GpuError("the scene has " + std::to_string(primitives) +
                       " primitives, and the kernels can address " + std::to_string(kMost));
}

class ScenePacker {
public:
    ScenePacker(const Scene& scene, std::span<const Primitive> primitives, const Bvh& bvh,
                const glm::dvec3& origin, PackedUvs uvs)
        : scene_(scene), primitives_(primitives), bvh_(bvh), uvs_(uvs), textures_(scene.textures),
          lights_(scene, packed_.features) {
        packed_.origin = origin;
        packed_.materials.resize(scene.materials.size());
        isPacked_.resize(scene.materials.size());
    }

    GpuScene pack(double aspectRatio) {
        requireIndexable(bvh_.nodes.size(), primitives_.size());
        packPrimitives();
        packLights();
        packNodes();
        packed_.textures = textures_.takePacked();
        packed_.texelRows = textures_.takeTexelRows();
        packView(aspectRatio);
        fillEmptyArrays();
        return std::move(packed_);
    }

private:
    /// Triangles and quadrics, each in the order of the leaves, so that a leaf is a range of one of
    /// the arrays.
    void packPrimitives() {
        const bool smooth = anyTriangleHasNormals();
        enable(gpu::kFeatureSmoothNormals, smooth);
        packMaterials();
        const bool textured =
            uvs_ == PackedUvs::All ||
            std::any_of(std::begin(kTextureSlots), std::end(kTextureSlots),
                        [&](uint32_t slot) { return packed_.features.enabled[slot]; });
        for (const uint32_t number : bvh_.order) {
            const Primitive& primitive = primitives_[number];
            const Shape& shape = scene_.shapes[primitive.shape];
            if (primitive.kind == PrimitiveKind::Quadric)
                addQuadric(shape, number);
            else
                addTriangle(std::get<Mesh>(shape.geometry), primitive.triangle, number, smooth,
                            textured);
        }
    }

    bool anyTriangleHasNormals() const {
        return std::any_of(primitives_.begin(), primitives_.end(), [&](const Primitive& primitive) {
            const Mesh* mesh = std::get_if<Mesh>(&scene_.shapes[primitive.shape].geometry);
            return mesh && mesh->triangles[primitive.triangle].normal[0] != Mesh::kNoNormal;
        });
    }

    void addTriangle(const Mesh& mesh, uint32_t index, uint32_t number, bool smooth,
                     bool textured) {
        const auto name = static_cast<uint32_t>(packed_.triangles.size());
        gpu::Triangle triangle = packTriangle(mesh, index, packed_.origin, number);
        const bool shines = lights_.add(triangle.material, name, number, areaOf(triangle));
        triangle.material |= transparentBit(triangle.material);
        enable(gpu::kFeatureTriangles, true);
        enable(gpu::kFeatureTriangleLights, shines);
        packed_.triangles.push_back(triangle);
        if (smooth)
            packed_.triangleNormals.push_back(packTriangleNormals(mesh, index));
        if (textured)
            packed_.triangleUvs.push_back(packTriangleUvs(mesh, index));
    }

    void addQuadric(const Shape& shape, uint32_t number) {
        const auto name = static_cast<uint32_t>(packed_.quadrics.size()) | gpu::kQuadricBit;
        gpu::Quadric quadric = packQuadric(shape, packed_.origin, number);
        const bool shines = lights_.add(quadric.material, name, number, areaOf(quadric));
        quadric.material |= transparentBit(quadric.material);
        enable(gpu::kFeatureSpheres + quadric.kind, true);
        enable(gpu::kFeatureSphereLights + quadric.kind, shines);
        packed_.quadrics.push_back(quadric);
    }

    /// Tells each shining primitive its light.
    void packLights() {
        packed_.lights = lights_.take();
        packed_.maxRadiance = lights_.maxRadiance();
        packed_.lightCount = static_cast<uint32_t>(packed_.lights.size());
        for (uint32_t i = 0; i < packed_.lightCount; ++i) {
            const uint32_t name = packed_.lights[i].primitive;
            if (name == gpu::kBackground)
                continue;
            if ((name & gpu::kQuadricBit) != 0)
                packed_.quadrics[name & ~gpu::kQuadricBit].light = i;
            else
                packed_.triangles[name].light = i;
        }
    }

    void packNodes() {
        packed_.nodes.reserve(bvh_.nodes.size());
        FirstPrimitives first;
        for (const Bvh::Node& node : bvh_.nodes) {
            packed_.nodes.push_back(packNode(node, first));
            for (const Bvh::Slot& slot : node.slots)
                (slot.kind == Bvh::SlotKind::Quadrics ? first.quadric : first.triangle) +=
                    slot.count;
        }
    }

    /// Materials that something bears. What others would need of the kernel is left out.
    void packMaterials() {
        for (const Primitive& primitive : primitives_) {
            const Shape& shape = scene_.shapes[primitive.shape];
            const Mesh* mesh = std::get_if<Mesh>(&shape.geometry);
            const uint32_t index =
                mesh ? mesh->triangles[primitive.triangle].material : shape.material;
            if (isPacked_[index])
                continue;
            isPacked_[index] = true;
            packed_.materials[index] =
                packMaterial(scene_.materials[index], scene_.textures, textures_, packed_.features);
        }
    }

    uint32_t transparentBit(uint32_t material) const {
        return isTransparent(scene_.materials[material]) ? gpu::kTransparentBit : 0;
    }

    void packView(double aspectRatio) {
        const Camera& camera = scene_.camera;
        const FilmFilter filter = scene_.film.filter;
        packed_.camera = packCamera(camera, filter, packed_.origin, aspectRatio);
        packed_.filterQuantiles = filterQuantiles(filter);
        enable(gpu::kFeatureFilter, filter != FilmFilter::Box);
        enable(gpu::kFeatureLens, camera.lensRadius > 0.0);
        enable(gpu::kFeatureOrthographic, camera.projection == Projection::Orthographic);
    }

    /// Buffers of no size do not exist. An empty scene is one triangle without area, which no ray
    /// meets.
    void fillEmptyArrays() {
        if (packed_.nodes.empty()) {
            packed_.nodes.emplace_back();
            enable(gpu::kFeatureTriangles, true);
        }
        const auto fill = [](auto& array) {
            if (array.empty())
                array.emplace_back();
        };
        fill(packed_.triangles);
        fill(packed_.triangleNormals);
        fill(packed_.triangleUvs);
        fill(packed_.quadrics);
        fill(packed_.materials);
        fill(packed_.textures);
        fill(packed_.texelRows);
        fill(packed_.lights);
    }

    void enable(uint32_t feature, bool needed) {
        packed_.features.enabled[feature] = packed_.features.enabled[feature] || needed;
    }

    static constexpr uint32_t kTextureSlots[] = {gpu::kFeatureColorTextures,
                                                 gpu::kFeatureScalarTextures,
                                                 gpu::kFeatureNormalMaps, gpu::kFeatureAlpha};

    const Scene& scene_;
    std::span<const Primitive> primitives_;
    const Bvh& bvh_;
    PackedUvs uvs_;
    TexturePacker textures_;
    GpuScene packed_;
    LightPacker lights_;
    std::vector<bool> isPacked_;  ///< by material
};

template <typename T>
size_t bytesOf(const std::vector<T>& array) {
    return array.size() * sizeof(T);
}

} // namespace

size_t GpuScene::bytes() const {
    return bytesOf(nodes) + bytesOf(triangles) + bytesOf(triangleNormals) + bytesOf(triangleUvs) +
           bytesOf(quadrics) + bytesOf(materials) + bytesOf(textures) + bytesOf(texelRows) +
           bytesOf(lights) + bytesOf(filterQuantiles) + sizeof(camera);
}

GpuScene packScene(const Scene& scene, std::span<const Primitive> primitives, const Bvh& bvh,
                   const glm::dvec3& origin, double aspectRatio, PackedUvs uvs) {
    static_assert(gpu::kFeatureDisks - gpu::kFeatureSpheres == gpu::kDisk - gpu::kSphere);
    static_assert(gpu::kFeatureDiskLights - gpu::kFeatureSphereLights == gpu::kDisk - gpu::kSphere);
    CALOTYPE_CHECK_EQ(bvh.order.size(), primitives.size());
    return ScenePacker(scene, primitives, bvh, origin, uvs).pack(aspectRatio);
}

} // namespace calotype
