#include "scene/mtl_library.h"

#include <set>

#include <glm/common.hpp>

#include "base/error.h"
#include "scene/mtl_file.h"
#include "scene/names.h"
#include "scene/read_file.h"

namespace calotype {
namespace {

constexpr double kColorWithoutMaterial = 0.5;

/// The names in a "mtllib" statement: blanks separate, a backslash keeps the next character.
std::vector<std::string> splitNames(const std::string& text) {
    std::vector<std::string> names(1);
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size()) {
            names.back() += text[++i];
        } else if (text[i] == ' ' || text[i] == '\t') {
            names.emplace_back();
        } else {
            names.back() += text[i];
        }
    }
    std::erase(names, std::string());
    return names;
}

/// All MTL files of an OBJ together; the first definition of a name counts.
class MtlLibrary {
public:
    MtlLibrary(const ObjFile& obj, const std::filesystem::path& directory, LoadContext& context) {
        for (const std::string& library : obj.libraries) {
            // Many exporters write names with blanks as they are.
            if (isReadableFile(directory / library)) {
                read(directory / library, context);
                continue;
            }
            for (const std::string& name : splitNames(library)) {
                if (isReadableFile(directory / name)) {
                    read(directory / name, context);
                } else {
                    missing_.push_back(name);
                }
            }
        }
    }

    const MtlMaterial& find(const std::string& name, const std::string& where) const {
        const auto found = materials_.find(name);
        if (found != materials_.end()) {
            return found->second;
        }
        std::vector<std::string> known;
        for (const auto& [knownName, unused] : materials_) {
            known.push_back(knownName);
        }
        throw SceneError(where, "the material " + inQuotes(name) + " is not defined" +
                                    (missing_.empty() ? suggestion(name, known)
                                                      : "; cannot read " + listInQuotes(missing_)) +
                                    "; name materials of the scene with \"material\" or "
                                    "\"materials\" instead");
    }

private:
    void read(const std::filesystem::path& path, LoadContext& context) {
        const std::string text = readFile(path.string(), path.string());
        context.hash.add(text);
        materials_.merge(parseMtl(text, path.string()));
    }

    std::map<std::string, MtlMaterial> materials_;
    std::vector<std::string> missing_;
};

} // namespace

std::vector<uint32_t> materialsFromMtl(const ObjFile& obj, const std::string& objPath,
                                       LoadContext& context) {
    std::vector<uint32_t>& result = context.mtlMaterials[objPath];
    if (!result.empty()) {
        return result;
    }
    const std::filesystem::path path(objPath);
    const std::string prefix = path.filename().string() + ":";
    std::set<std::string> unsupported;
    std::vector<std::string> clamped;
    if (!obj.materialNames.empty()) {
        const MtlLibrary library(obj, path.parent_path(), context);
        for (size_t i = 0; i < obj.materialNames.size(); ++i) {
            const std::string& name = obj.materialNames[i];
            const MtlMaterial& mtl =
                library.find(name, objPath + ":" + std::to_string(obj.materialLines[i]));
            Material material;
            material.name = prefix + name;
            material.color = glm::min(mtl.color, glm::dvec3(1.0));
            material.emission = mtl.emission;
            if (material.color != mtl.color) {
                clamped.push_back(name);
            }
            unsupported.insert(mtl.unsupported.begin(), mtl.unsupported.end());
            result.push_back(context.addMaterial(material));
        }
    }
    Material plain;
    plain.name = prefix;
    plain.color = glm::dvec3(kColorWithoutMaterial);
    result.push_back(obj.hasFacesWithoutMaterial ? context.addMaterial(plain) : 0);

    if (!clamped.empty()) {
        context.warn(objPath, "Kd above 1 was lowered to 1 in " + listInQuotes(clamped));
    }
    if (!unsupported.empty()) {
        const std::vector<std::string> names(unsupported.begin(), unsupported.end());
        context.warn(objPath, "these MTL statements are not supported yet and were ignored: " +
                                  listInQuotes(names));
    }
    return result;
}

} // namespace calotype
