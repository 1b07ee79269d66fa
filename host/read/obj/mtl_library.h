#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "read/obj/mtl_file.h"
#include "read/read_context.h"

namespace calotype {

/// A material and its name, as in its MTL file.
struct NamedMtl {
    std::string_view name;
    const MtlMaterial* material = nullptr;
};

/// The materials of some MTL files by name. The first definition of a name is used.
struct MtlIndex {
    using Names = std::unordered_map<std::string_view, NamedMtl>;

    Names byName;
    Names byReading; ///< by the other readings of names, see readingsOf
};

/// MTL files that have been read, for all OBJ files together.
struct MtlFiles {
    std::map<std::string, std::shared_ptr<const MtlFile>> byPath; ///< true paths
    std::map<std::vector<const MtlFile*>, std::shared_ptr<const MtlIndex>> indices;
};

/// The MTL files of an OBJ together.
class MtlLibrary {
public:
    /// `statements` are what follows each "mtllib" of an OBJ in `directory`. Each file is read,
    /// hashed and remarked on once for all libraries with the same `files`, which must live longer.
    MtlLibrary(std::span<const std::string> statements, const std::filesystem::path& directory,
               MtlFiles& files, ReadContext& context);

    /// The material that `text`, the end of a "usemtl", means (see readingsOf); its `material` is
    /// nullptr if it is not defined.
    NamedMtl find(std::string_view text) const;

    /// All names, as written.
    std::vector<std::string> names() const;

    /// Names of files that do not exist or cannot be read.
    const std::vector<std::string>& missing() const { return missing_; }

private:
    std::vector<std::string> missing_;
    std::shared_ptr<const MtlIndex> index_;
};

} // namespace calotype
