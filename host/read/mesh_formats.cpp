#include "read/mesh_formats.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/lowercase.h"

namespace calotype {
namespace {

constexpr std::array<MeshFormat, 1> kMeshFormats = {{
    {".obj", parseObj},
}};

} // namespace

const MeshFormat& meshFormatOf(const std::string& path) {
    const std::string extension = lowercase(std::filesystem::path(path).extension().string());
    const auto found = std::ranges::find(kMeshFormats, extension, &MeshFormat::extension);
    return found == kMeshFormats.end() ? kMeshFormats.front() : *found;
}

} // namespace calotype
