#include "read/obj/obj_file.h"

#include <algorithm>
#include <istream>
#include <span>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include "base/check.h"
#include "base/error.h"
#include "mesh/smooth_normals.h"
#include "mesh/triangulate.h"
#include "read/obj/face_check.h"
#include "read/obj/lines.h"
#include "read/obj/memory_buffer.h"
#include "read/obj/tinyobj_text.h"

namespace calotype {
namespace {

/// Receives tinyobjloader's events and triangulates each polygon.
class Receiver {
public:
    Receiver(ObjFile& file, const ObjOutline& outline) : file_(file), outline_(outline) {
        file_.positions.reserve(outline.counts[kObjPosition]);
        file_.normals.reserve(outline.counts[kObjNormal]);
        file_.uvs.reserve(outline.counts[kObjTexcoord]);
        polygons_.reserve(outline.polygons);
        corners_.reserve(outline.corners);
    }

    void parse(std::string_view text, const OnProgress& onProgress) {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, double x, double y, double z, double) {
            static_cast<Receiver*>(self)->file_.positions.emplace_back(x, y, z);
        };
        callbacks.normal_cb = [](void* self, double x, double y, double z) {
            static_cast<Receiver*>(self)->file_.normals.emplace_back(x, y, z);
        };
        callbacks.texcoord_cb = [](void* self, double u, double v, double) {
            static_cast<Receiver*>(self)->file_.uvs.emplace_back(u, v);
        };
        callbacks.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
            static_cast<Receiver*>(self)->addPolygon({indices, static_cast<size_t>(count)});
        };
        MemoryBuffer buffer(text, onProgress);
        std::istream stream(&buffer);
        tinyobj::LoadObjWithCallback(stream, callbacks, this);
        buffer.rethrow();
        // What the outline says of vertex data and polygons holds only if both read the same.
        CALOTYPE_CHECK_EQ(file_.positions.size(), outline_.counts[kObjPosition]);
        CALOTYPE_CHECK_EQ(file_.normals.size(), outline_.counts[kObjNormal]);
        CALOTYPE_CHECK_EQ(file_.uvs.size(), outline_.counts[kObjTexcoord]);
        CALOTYPE_CHECK_EQ(polygons_.size(), outline_.polygons);
        CALOTYPE_CHECK_EQ(corners_.size(), outline_.corners);
    }

    /// Called when all vertices are known, because faces may refer to later ones.
    void triangulate(const OnProgress& onProgress) {
        file_.triangles.reserve(outline_.corners - 2 * outline_.polygons);
        auto material = outline_.materialRuns.begin();
        auto smoothing = outline_.smoothingRuns.begin();
        size_t start = 0;
        for (size_t i = 0; i < polygons_.size(); ++i) {
            reportStep(onProgress, i, polygons_.size());
            for (; material != outline_.materialRuns.end() && material->firstPolygon <= i;
                 ++material)
                material_ = material->material;
            for (; smoothing != outline_.smoothingRuns.end() && smoothing->firstPolygon <= i;
                 ++smoothing)
                smoothingGroup_ = smoothing->group;
            cutPolygon({corners_.data() + start, polygons_[i]});
            start += polygons_[i];
        }
    }

    /// Makes the normals of faces that belong to a smoothing group and are given none.
    void smooth() {
        if (!outline_.smoothingRuns.empty())
            smoothNormals(file_.positions, file_.triangles, file_.normals, smoothing_);
    }

private:
    struct Corner {
        uint32_t position;
        uint32_t normal;
        uint32_t uv;
    };
    static_assert(Mesh::kNoNormal == kNoObjData && Mesh::kNoUv == kNoObjData);

    /// For tinyobjloader, 0 is an index that is not given.
    static uint32_t resolve(int index, size_t count) {
        return index == 0 ? kNoObjData : resolveObjIndex(index, count);
    }

    void addPolygon(std::span<const tinyobj::index_t> indices) {
        for (const tinyobj::index_t& index : indices) {
            corners_.push_back({resolve(index.vertex_index, file_.positions.size()),
                                resolve(index.normal_index, file_.normals.size()),
                                resolve(index.texcoord_index, file_.uvs.size())});
        }
        polygons_.push_back(static_cast<uint32_t>(indices.size()));
    }

    bool areUsable(std::span<const Corner> polygon, ObjData kind, uint32_t Corner::*index) const {
        return std::ranges::all_of(polygon, [&](const Corner& corner) {
            return outline_.stateOf(kind, corner.*index) == ObjOutline::DataState::Usable;
        });
    }

    void cutPolygon(std::span<const Corner> polygon) {
        if (!areUsable(polygon, kObjPosition, &Corner::position))
            return;
        const bool hasNormals = areUsable(polygon, kObjNormal, &Corner::normal);
        const bool hasUvs = areUsable(polygon, kObjTexcoord, &Corner::uv);
        const bool lacksNormals = std::ranges::any_of(
            polygon, [](const Corner& corner) { return corner.normal == kNoObjData; });
        polygon_.clear();
        for (const Corner& corner : polygon)
            polygon_.push_back(file_.positions[corner.position]);
        for (const auto& cut : triangulator_.triangulate(polygon_)) {
            Mesh::Triangle triangle{};
            triangle.material = material_;
            for (int k = 0; k < 3; ++k) {
                triangle.position[k] = polygon[cut[k]].position;
                triangle.normal[k] = hasNormals ? polygon[cut[k]].normal : kNoObjData;
                triangle.uv[k] = hasUvs ? polygon[cut[k]].uv : kNoObjData;
            }
            file_.triangles.push_back(triangle);
            if (!outline_.smoothingRuns.empty())
                smoothing_.push_back({smoothingGroup_, lacksNormals});
        }
        file_.crossingPolygons += triangulator_.sound() ? 0 : 1;
        file_.hasFacesWithoutMaterial =
            file_.hasFacesWithoutMaterial || material_ == ObjFile::kNoMaterial;
    }

    ObjFile& file_;
    const ObjOutline& outline_;
    std::vector<Corner> corners_;
    std::vector<uint32_t> polygons_; ///< number of corners of each
    uint32_t material_ = ObjFile::kNoMaterial;
    uint32_t smoothingGroup_ = 0;
    std::vector<Smoothing> smoothing_; ///< of each triangle, if there are smoothing groups
    std::vector<glm::dvec3> polygon_;
    Triangulator triangulator_;
};

void requireFaces(const ObjFile& file, const ObjOutline& outline, const std::string& path) {
    if (outline.counts[kObjPosition] == 0)
        throw SceneError(path, "the file has no vertices; is it a Wavefront OBJ?");
    if (!file.triangles.empty())
        return;
    if (outline.polygons == 0 && outline.smallFaces.count() == 0 &&
        outline.unreadableFaces.count() == 0) {
        throw SceneError(path,
                         "the file has no faces; points, lines and curves cannot be rendered");
    }
    throw SceneError(path, "no face can be rendered: " + file.notes.front().message);
}

} // namespace

ObjFile parseObj(std::string_view text, const std::string& path, const OnProgress& onProgress) {
    text = withoutByteOrderMark(text);
    const ObjOutline outline = outlineOfObj(text, partOf(onProgress, 0.0, 0.3));
    ObjFile file;
    file.notes = notesOn(outline, outline.needsFaceCheck()
                                      ? checkFaces(text, outline, partOf(onProgress, 0.3, 0.5))
                                      : FaceFaults());
    std::string rewritten;
    if (outline.needsRewriting || text.find('\\') != std::string_view::npos) {
        rewritten = textForTinyobj(text, partOf(onProgress, 0.5, 0.6));
        text = rewritten;
    }
    Receiver receiver(file, outline);
    receiver.parse(text, partOf(onProgress, 0.6, 0.9));
    receiver.triangulate(partOf(onProgress, 0.9, 1.0));
    requireFaces(file, outline, path);
    receiver.smooth();
    if (file.crossingPolygons > 0)
        file.notes.push_back(noteOfCrossingPolygons(file.crossingPolygons));
    file.materialNames = outline.materialNames;
    file.materialLines = outline.materialLines;
    file.libraries = outline.libraries;
    return file;
}

} // namespace calotype
