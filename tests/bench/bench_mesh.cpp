// Writes the triangles of the generated bench scene's balls as an OBJ file, for other renderers.
// usage: bench_mesh OUT.obj
#include <cstdio>
#include <variant>

#include "engine/bench_scene.h"

namespace {

using calotype::Mesh;

/// The balls are the meshes of more than two triangles.
bool isBall(const Mesh& mesh) { return mesh.triangles.size() > 2; }

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: bench_mesh OUT.obj\n");
        return 2;
    }
    const calotype::Scene scene = calotype::makeBenchScene();
    std::FILE* file = std::fopen(argv[1], "w");
    if (!file)
        return 1;
    uint32_t before = 1; // indices count from 1
    for (const calotype::Shape& shape : scene.shapes) {
        const auto& mesh = std::get<Mesh>(shape.geometry);
        if (!isBall(mesh))
            continue;
        for (const glm::dvec3& p : mesh.positions)
            std::fprintf(file, "v %.9g %.9g %.9g\n", p.x, p.y, p.z);
        for (const Mesh::Triangle& triangle : mesh.triangles)
            std::fprintf(file, "f %u %u %u\n", before + triangle.position[0],
                         before + triangle.position[1], before + triangle.position[2]);
        before += static_cast<uint32_t>(mesh.positions.size());
    }
    return std::fclose(file) == 0 ? 0 : 1;
}
