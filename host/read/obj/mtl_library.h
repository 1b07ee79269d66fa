#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "read/obj/mtl_file.h"
#include "read/read_context.h"

namespace calotype {

/// MTL files that have been read, by their true paths.
using MtlFiles = std::map<std::string, std::shared_ptr<const MtlFile>>;

/// The MTL files of an OBJ together; the first definition of a name is used.
class MtlLibrary {
public:
    struct Found {
        std::string_view name; ///< as in its MTL file
        const MtlMaterial* material;
    };

    /// `statements` are what follows each "mtllib" of an OBJ in `directory`. Each file is read,
    /// hashed and remarked on once for all libraries with the same `files`.
    MtlLibrary(std::span<const std::string> statements, const std::filesystem::path& directory,
               MtlFiles& files, ReadContext& context);

    /// The material that `text`, the end of a "usemtl", means (see readingsOf); its `material` is
    /// nullptr if it is not defined.
    Found find(std::string_view text) const;

    /// All names, as written.
    std::vector<std::string> names() const;

    /// Names of files that do not exist or cannot be read.
    const std::vector<std::string>& missing() const { return missing_; }

private:
    bool read(const std::string& name, const std::filesystem::path& directory, MtlFiles& files,
              ReadContext& context);
    void readAll(std::string_view statement, const std::filesystem::path& directory,
                 MtlFiles& files, ReadContext& context);
    void add(const MtlFile& file);

    using Index = std::unordered_map<std::string_view, Found>;

    std::set<std::shared_ptr<const MtlFile>> files_;
    Index byName_;
    Index byReading_; ///< by the other readings of names
    std::vector<std::string> missing_;
};

} // namespace calotype
