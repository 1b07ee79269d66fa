#include "pack/gpu_scene.h"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "base/check.h"
#include "base/error.h"
#include "base/parallel_chunks.h"
#include "pack/filter_table.h"
#include "pack/pack_camera.h"
#include "pack/pack_light_tree.h"
#include "pack/pack_lights.h"
#include "pack/pack_material.h"
#include "pack/pack_node.h"
#include "pack/pack_shapes.h"
#include "pack/place_nodes.h"
#include "shared/limits.h"

namespace calotype {
namespace {

/// Throws if there are more than names and places have bits for.
void requireAddressable(size_t count, size_t most, const char* what) {
    if (count > most)
        throw GpuError("the scene has " + std::to_string(count) + " " + what +
                       ", and the kernels can address " + std::to_string(most));
}

class ScenePacker {
public:
    ScenePacker(const Scene& scene, std::span<const Primitive> primitives, const Bvh& bvh,
                const glm::dvec3& origin, const PackOptions& options)
        : scene_(scene), primitives_(primitives), bvh_(bvh), options_(options),
          textures_(scene.textures, options.textureFilter),
          lights_(scene, packed_.features, options.lightChoice) {
        packed_.origin = origin;
        packed_.primitiveCount = primitives.size();
        packed_.materials.resize(scene.materials.size());
        isPacked_.resize(scene.materials.size());
    }

    GpuScene pack(double aspectRatio) {
        requireAddressable(primitives_.size(), shared::kMostPrimitives, "primitives");
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
    /// Packs triangles and quadrics, each in the order of the leaves, so that a leaf is a range of
    /// one of the arrays.
    void packPrimitives() {
        const bool smooth = anyTriangleHasNormals();
        enable(shared::kFeatureSmoothNormals, smooth);
        packMaterials();
        const bool textured =
            options_.allUvs ||
            std::any_of(std::begin(kTextureSlots), std::end(kTextureSlots),
                        [&](uint32_t slot) { return packed_.features.enabled[slot]; });
        nameInOrder();
        const size_t triangles = names_.size() - quadricCount_;
        enable(shared::kFeatureTriangles, triangles > 0);
        enable(shared::kFeatureManyQuadrics,
               triangles > 0 && quadricCount_ > 0 && hasManyQuadrics());
        packed_.quadrics.resize(quadricCount_);
        packed_.triangles.resize(triangles);
        packed_.triangleNormals.resize(smooth || options_.allNormals ? triangles : 0);
        packed_.triangleUvs.resize(textured ? triangles : 0);
        parallelChunks(names_.size(), allCores(), [&](uint64_t first, uint64_t last) {
            for (uint64_t place = first; place < last; ++place) {
                prefetch(place, last);
                packPrimitive(bvh_.order[place], names_[place]);
            }
        });
        for (const shared::Quadric& quadric : packed_.quadrics)
            enable(shared::kFeatureSpheres + quadric.kind, true);
        for (const uint32_t place : placesOfLights())
            addLight(bvh_.order[place], names_[place]);
    }

    /// Whether quadrics are tested with triangles, without waiting. On lavapipe, 786 k triangles
    /// with spheres and cylinders that are 6, 18, 33 and 60 % of the visited primitives: waiting
    /// gives 1.03, 1.01, 0.98 and 0.94 times the paths a second.
    bool hasManyQuadrics() const {
        constexpr double kMany = 0.25; // of the primitives that a ray visits
        const BvhStatistics statistics = bvhStatistics(bvh_);
        return statistics.quadricsVisited > kMany * statistics.primitivesVisited;
    }

    /// Gives each primitive its name (shared::kQuadricBit), in the order of the leaves.
    void nameInOrder() {
        names_.resize(bvh_.order.size());
        std::iota(names_.begin(), names_.end(), 0u);
        const auto isMesh = [](const Shape& shape) {
            return std::holds_alternative<Mesh>(shape.geometry);
        };
        if (std::ranges::all_of(scene_.shapes, isMesh))
            return;
        uint32_t triangles = 0;
        for (size_t place = 0; place < names_.size(); ++place)
            names_[place] = primitives_[bvh_.order[place]].kind == PrimitiveKind::Quadric
                                ? quadricCount_++ | shared::kQuadricBit
                                : triangles++;
    }

    uint32_t materialOf(uint32_t name) const {
        const uint32_t index = name & ~shared::kQuadricBit;
        return ~shared::kTransparentBit & (name == index ? packed_.triangles[index].material
                                                         : packed_.quadrics[index].material);
    }

    /// The places, in the order of the leaves, of primitives that may be lights.
    std::vector<uint32_t> placesOfLights() const {
        std::mutex mutex;
        std::vector<uint32_t> places;
        parallelChunks(names_.size(), allCores(), [&](uint64_t first, uint64_t last) {
            std::vector<uint32_t> found;
            for (auto place = static_cast<uint32_t>(first); place < last; ++place)
                if (lights_.isLight(materialOf(names_[place])))
                    found.push_back(place);
            const std::lock_guard lock(mutex);
            places.insert(places.end(), found.begin(), found.end());
        });
        std::ranges::sort(places);
        return places;
    }

    /// Leaves are ordered by space, but primitives and triangles by the scene file, so packing
    /// would wait for memory half of its time. Always inlined: otherwise GCC 12 removes this
    /// function as without effect.
    [[gnu::always_inline]] void prefetch(uint64_t place, uint64_t last) const {
        constexpr uint64_t kAhead = 16; // primitives: microseconds of work; 8 and 32 are as fast
        if (place + 2 * kAhead < last)
            __builtin_prefetch(&primitives_[bvh_.order[place + 2 * kAhead]].shape);
        if (place + kAhead >= last)
            return;
        const Primitive& next = primitives_[bvh_.order[place + kAhead]];
        if (const Mesh* mesh = std::get_if<Mesh>(&scene_.shapes[next.shape].geometry))
            __builtin_prefetch(&mesh->triangles[next.triangle]);
    }

    /// Called by several threads at a time: each primitive has its own place.
    void packPrimitive(uint32_t number, uint32_t name) {
        const Shape& shape = scene_.shapes[primitives_[number].shape];
        const auto* mesh = std::get_if<Mesh>(&shape.geometry);
        if (!mesh) {
            shared::Quadric& quadric = packed_.quadrics[name & ~shared::kQuadricBit];
            quadric = packQuadric(shape, packed_.origin, number);
            quadric.material |= transparentBit(quadric.material);
            return;
        }
        const uint32_t index = primitives_[number].triangle;
        shared::Triangle& triangle = packed_.triangles[name];
        triangle = packTriangle(*mesh, index, packed_.origin, number);
        triangle.material |= transparentBit(triangle.material);
        if (!packed_.triangleNormals.empty())
            packed_.triangleNormals[name] = packTriangleNormals(*mesh, index);
        if (!packed_.triangleUvs.empty())
            packed_.triangleUvs[name] = packTriangleUvs(*mesh, index);
    }

    void addLight(uint32_t number, uint32_t name) {
        if ((name & shared::kQuadricBit) != 0) {
            const shared::Quadric& quadric = packed_.quadrics[name & ~shared::kQuadricBit];
            lights_.add(shared::kLightSphere + quadric.kind, materialOf(name), name, number,
                        areaOf(quadric));
        } else {
            lights_.add(shared::kLightTriangle, materialOf(name), name, number,
                        areaOf(packed_.triangles[name]));
        }
    }

    bool anyTriangleHasNormals() const {
        return std::ranges::any_of(scene_.shapes, [](const Shape& shape) {
            const Mesh* mesh = std::get_if<Mesh>(&shape.geometry);
            return mesh && !mesh->normals.empty() &&
                   std::ranges::any_of(mesh->triangles, [](const Mesh::Triangle& triangle) {
                       return triangle.normal[0] != Mesh::kNoNormal;
                   });
        });
    }

    /// Links each emitting primitive, and rays that hit nothing, to their light.
    void packLights() {
        packed_.lights = lights_.take();
        packed_.maxRadiance = lights_.maxRadiance();
        packed_.lightCount = static_cast<uint32_t>(packed_.lights.size());
        for (uint32_t i = 0; i < packed_.lightCount; ++i) {
            const uint32_t name = packed_.lights[i].primitive;
            if (shared::sortOfLight(packed_.lights[i].kind) == shared::kSortInfinite) {
                CALOTYPE_CHECK_EQ(packed_.infiniteLight, shared::kNone); // there is one at most
                packed_.infiniteLight = i;
            }
            if (name == shared::kNone)
                continue;
            if ((name & shared::kQuadricBit) != 0)
                packed_.quadrics[name & ~shared::kQuadricBit].light = i;
            else
                packed_.triangles[name].light = i;
        }
        if (options_.lightChoice == LightChoice::Tree)
            addLightTree(scene_, packed_);
    }

    void packNodes() {
        std::vector<FirstPrimitives> first(bvh_.nodes.size());
        for (size_t i = 1; i < first.size(); ++i) {
            first[i] = first[i - 1];
            for (const Bvh::Slot& slot : bvh_.nodes[i - 1].slots)
                (slot.kind == Bvh::SlotKind::Quadrics ? first[i].quadric : first[i].triangle) +=
                    slot.count;
        }
        const NodePlaces places = placeNodes(bvh_);
        requireAddressable(places.end, shared::kMostNodes, "nodes of its tree");
        packed_.nodes.resize(places.end);
        parallelChunks(first.size(), allCores(), [&](uint64_t begin, uint64_t end) {
            for (uint64_t i = begin; i < end; ++i)
                packed_.nodes[places.ofNode[i]] =
                    packNode(bvh_.nodes[i], first[i], places.baseOfChildren[i]);
        });
    }

    /// Packs the materials that primitives use. Others must not add features to the kernel.
    void packMaterials() {
        for (const Shape& shape : scene_.shapes) {
            if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry))
                for (const Mesh::Triangle& triangle : mesh->triangles)
                    packMaterialOnce(triangle.material);
            else
                packMaterialOnce(shape.material);
        }
    }

    void packMaterialOnce(uint32_t index) {
        if (isPacked_[index])
            return;
        isPacked_[index] = true;
        packed_.materials[index] =
            packMaterial(scene_.materials[index], scene_.textures, textures_, packed_.features);
    }

    uint32_t transparentBit(uint32_t material) const {
        return isTransparent(scene_.materials[material]) ? shared::kTransparentBit : 0;
    }

    void packView(double aspectRatio) {
        const Camera& camera = scene_.camera;
        const FilmFilter filter = scene_.film.filter;
        packed_.camera = packCamera(camera, filter, packed_.origin, aspectRatio);
        if (filter != FilmFilter::Box)
            packed_.filterSteps = filterSteps(filter);
        enable(shared::kFeatureFilter, filter != FilmFilter::Box);
        enable(shared::kFeatureLens, camera.lensRadius > 0.0);
        enable(shared::kFeatureOrthographic, camera.projection == Projection::Orthographic);
    }

    /// A buffer cannot be empty. An empty scene is one triangle without area, which no ray hits.
    void fillEmptyArrays() {
        if (packed_.nodes.empty()) {
            packed_.nodes.emplace_back();
            enable(shared::kFeatureTriangles, true);
        }
        const auto fill = [](auto& array) {
            if (array.empty())
                array.emplace_back();
        };
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people) SCENE_ROWS(id, shared::type, member, people)
#define SCENE_ROWS(id, type, member, people) fill(packed_.member);
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"
    }

    void enable(uint32_t feature, bool needed) {
        packed_.features.enabled[feature] = packed_.features.enabled[feature] || needed;
    }

    static constexpr uint32_t kTextureSlots[] = {
        shared::kFeatureColorTextures, shared::kFeatureRoughnessTextures,
        shared::kFeatureSpecularTextures, shared::kFeatureNormalMaps, shared::kFeatureAlpha};

    const Scene& scene_;
    std::span<const Primitive> primitives_;
    const Bvh& bvh_;
    PackOptions options_;
    TexturePacker textures_;
    GpuScene packed_;
    LightPacker lights_;
    std::vector<bool> isPacked_;  ///< by material
    std::vector<uint32_t> names_; ///< of the primitives, in the order of the leaves
    uint32_t quadricCount_ = 0;
};

template <typename T>
size_t bytesOf(const std::vector<T>& array) {
    return array.size() * sizeof(T);
}

size_t bytesOf(const std::vector<TexelRows>& images) { return rowCount(images) * kBytesOfTexelRow; }

} // namespace

size_t GpuScene::bytes() const {
    size_t bytes = sizeof(camera);
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people) SCENE_ROWS(id, shared::type, member, people)
#define SCENE_ROWS(id, type, member, people) bytes += bytesOf(member);
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"
    return bytes;
}

size_t GpuScene::largestBytes() const {
    size_t bytes = 0;
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people) SCENE_ROWS(id, shared::type, member, people)
#define SCENE_ROWS(id, type, member, people) bytes = std::max(bytes, bytesOf(member));
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"
    return bytes;
}

GpuScene packScene(const Scene& scene, std::span<const Primitive> primitives, const Bvh& bvh,
                   const glm::dvec3& origin, double aspectRatio, const PackOptions& options) {
    static_assert(shared::kFeatureDisks - shared::kFeatureSpheres ==
                  shared::kDisk - shared::kSphere);
    static_assert(shared::kLightDisk - shared::kLightSphere == shared::kDisk - shared::kSphere);
    CALOTYPE_CHECK_EQ(bvh.order.size(), primitives.size());
    return ScenePacker(scene, primitives, bvh, origin, options).pack(aspectRatio);
}

} // namespace calotype
