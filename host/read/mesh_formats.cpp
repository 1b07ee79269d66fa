#include "read/mesh_formats.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/error.h"
#include "base/file_kind.h"
#include "base/lowercase.h"

namespace calotype {
namespace {

constexpr std::array<MeshFormat, 1> kMeshFormats = {{
    {".obj", parseObj},
}};

/// Without blank lines and comments at the start.
std::string_view fromFirstStatement(std::string_view text) {
    while (text.starts_with('#') || text.starts_with('\r') || text.starts_with('\n'))
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text;
}

std::string_view kindOf(std::string_view text) {
    if (const std::string_view kind = fileKind(text); !kind.empty())
        return kind;
    const std::string_view statements = fromFirstStatement(text);
    if (statements.starts_with('{'))
        return "a JSON file (a glTF or a scene)";
    return statements.empty() ? std::string_view() : fileKind(statements);
}

/// Whether some line is a vertex of an OBJ, whatever the first line looks like.
bool hasVertices(std::string_view text) {
    return text.starts_with("v ") || text.find("\nv ") != text.npos;
}

} // namespace

const MeshFormat& meshFormatOf(const std::string& path) {
    const std::string extension = lowercase(std::filesystem::path(path).extension().string());
    const auto found = std::ranges::find(kMeshFormats, extension, &MeshFormat::extension);
    return found == kMeshFormats.end() ? kMeshFormats.front() : *found;
}

void refuseOtherKinds(std::string_view text, const std::string& path) {
    const std::string_view kind = kindOf(text);
    if (!kind.empty() && !hasVertices(text))
        throw SceneError(path, "is " + std::string(kind) +
                                   ", which cannot be read; a mesh must be a Wavefront "
                                   "OBJ, a text in UTF-8");
}

} // namespace calotype
