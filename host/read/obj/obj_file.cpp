#include "read/obj/obj_file.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <span>
#include <streambuf>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include "base/check.h"
#include "base/error.h"
#include "mesh/triangulate.h"
#include "read/obj/lines.h"
#include "read/obj/tinyobj_text.h"

namespace calotype {
namespace {

/// A stream that reads from memory without copying.
class MemoryBuffer : public std::streambuf {
public:
    explicit MemoryBuffer(std::string_view text) {
        char* start = const_cast<char*>(text.data()); // read only: there is no put area
        setg(start, start, start + text.size());
    }
};

/// Receives tinyobjloader's events and triangulates each polygon.
class Receiver {
public:
    Receiver(ObjFile& file, const ObjOutline& outline) : file_(file), outline_(outline) {
        file_.positions.reserve(outline.positions);
        file_.normals.reserve(outline.normals);
        file_.uvs.reserve(outline.uvs);
        polygons_.reserve(outline.polygons);
        corners_.reserve(outline.corners);
    }

    void parse(std::istream& stream) {
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
        tinyobj::LoadObjWithCallback(stream, callbacks, this);
        // The outline has checked every index; that holds only if both read the same data.
        CALOTYPE_CHECK_EQ(file_.positions.size(), outline_.positions);
        CALOTYPE_CHECK_EQ(file_.normals.size(), outline_.normals);
        CALOTYPE_CHECK_EQ(file_.uvs.size(), outline_.uvs);
        CALOTYPE_CHECK_EQ(polygons_.size(), outline_.polygons);
        CALOTYPE_CHECK_EQ(corners_.size(), outline_.corners);
    }

    /// Called when all vertices are known, because faces may refer to later ones.
    void triangulate() {
        for (const size_t index : outline_.nonFiniteNormals)
            file_.normals[index] = glm::dvec3(0.0);
        file_.triangles.reserve(outline_.corners - 2 * outline_.polygons);
        size_t run = 0;
        uint32_t material = ObjFile::kNoMaterial;
        size_t start = 0;
        for (size_t i = 0; i < polygons_.size(); ++i) {
            while (run < outline_.materialRuns.size() &&
                   outline_.materialRuns[run].firstPolygon <= i) {
                material = outline_.materialRuns[run++].material;
            }
            cutPolygon({corners_.data() + start, polygons_[i]}, material);
            start += polygons_[i];
        }
    }

private:
    struct Corner {
        uint32_t position;
        uint32_t normal;
        uint32_t uv;
    };
    static constexpr uint32_t kNone = ~0u;
    static_assert(Mesh::kNoNormal == kNone && Mesh::kNoUv == kNone);

    /// Converts an OBJ index (from 1; negative counts from the end; 0 is none).
    static uint32_t resolve(int index, size_t count) {
        if (index == 0)
            return kNone;
        return static_cast<uint32_t>(index > 0 ? index - 1 : static_cast<int64_t>(count) + index);
    }

    void addPolygon(std::span<const tinyobj::index_t> indices) {
        for (const tinyobj::index_t& index : indices) {
            corners_.push_back({resolve(index.vertex_index, file_.positions.size()),
                                resolve(index.normal_index, file_.normals.size()),
                                resolve(index.texcoord_index, file_.uvs.size())});
        }
        polygons_.push_back(static_cast<uint32_t>(indices.size()));
    }

    bool hasNormal(const Corner& corner) const {
        return corner.normal != Mesh::kNoNormal && file_.normals[corner.normal] != glm::dvec3(0.0);
    }

    void cutPolygon(std::span<const Corner> polygon, uint32_t material) {
        polygon_.clear();
        bool allNormals = true;
        bool allUvs = true;
        for (const Corner& corner : polygon) {
            polygon_.push_back(file_.positions[corner.position]);
            allNormals = allNormals && hasNormal(corner);
            allUvs = allUvs && corner.uv != kNone;
        }
        for (const auto& cut : triangulator_.triangulate(polygon_)) {
            Mesh::Triangle triangle{};
            triangle.material = material;
            for (int k = 0; k < 3; ++k) {
                triangle.position[k] = polygon[cut[k]].position;
                triangle.normal[k] = allNormals ? polygon[cut[k]].normal : kNone;
                triangle.uv[k] = allUvs ? polygon[cut[k]].uv : kNone;
            }
            file_.triangles.push_back(triangle);
        }
        file_.crossingPolygons += triangulator_.sound() ? 0 : 1;
        file_.hasFacesWithoutMaterial =
            file_.hasFacesWithoutMaterial || material == ObjFile::kNoMaterial;
    }

    ObjFile& file_;
    const ObjOutline& outline_;
    std::vector<Corner> corners_;
    std::vector<uint32_t> polygons_; ///< number of corners of each
    std::vector<glm::dvec3> polygon_;
    Triangulator triangulator_;
};

} // namespace

ObjFile parseObj(std::string_view text, const std::string& path) {
    text = withoutByteOrderMark(text);
    const ObjOutline outline = checkObj(text, path);
    if (outline.positions == 0)
        throw SceneError(path, "the file has no vertices; is it a Wavefront OBJ?");
    if (outline.polygons == 0) {
        throw SceneError(path,
                         "the file has no faces; points, lines and curves cannot be rendered");
    }
    std::string rewritten;
    if (outline.needsRewriting || text.find('\\') != std::string_view::npos) {
        rewritten = textForTinyobj(text);
        text = rewritten;
    }
    ObjFile file;
    Receiver receiver(file, outline);
    MemoryBuffer buffer(text);
    std::istream stream(&buffer);
    receiver.parse(stream);
    receiver.triangulate();
    file.materialNames = outline.materialNames;
    file.materialLines = outline.materialLines;
    file.libraries = outline.libraries;
    return file;
}

} // namespace calotype
