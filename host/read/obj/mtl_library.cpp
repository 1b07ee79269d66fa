#include "read/obj/mtl_library.h"

#include <set>

#include "base/error.h"
#include "base/find_file.h"
#include "base/names.h"
#include "base/read_file.h"
#include "read/obj/mtl_material.h"

namespace calotype {
namespace {

/// The names in a "mtllib" statement, separated by blanks; a backslash escapes the next character.
std::vector<std::string> splitNames(const std::string& text) {
    std::vector<std::string> names(1);
    for (size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\\' && i + 1 < text.size())
            names.back() += text[++i];
        else if (text[i] == ' ' || text[i] == '\t')
            names.emplace_back();
        else
            names.back() += text[i];
    std::erase(names, std::string());
    return names;
}

/// All MTL files of an OBJ together; the first definition of a name is used.
class MtlLibrary {
public:
    MtlLibrary(const ObjFile& obj, const std::filesystem::path& directory, ReadContext& context) {
        for (const std::string& library : obj.libraries) {
            // Many exporters do not escape blanks in names.
            if (const auto path = findFile(directory, library)) {
                read(*path, context);
                continue;
            }
            for (const std::string& name : splitNames(library))
                if (const auto path = findFile(directory, name))
                    read(*path, context);
                else
                    missing_.push_back(name);
        }
    }

    /// nullptr if the material is not defined.
    const MtlMaterial* find(const std::string& name) const {
        const auto found = materials_.find(name);
        return found != materials_.end() ? &found->second : nullptr;
    }

    [[noreturn]] void failUndefined(const std::string& name, const std::string& where) const {
        std::vector<std::string> known;
        for (const auto& [knownName, unused] : materials_)
            known.push_back(knownName);
        throw SceneError(where, "the material " + inQuotes(name) + " is not defined" +
                                    (missing_.empty() ? suggestion(name, known)
                                                      : "; cannot read " + listInQuotes(missing_)) +
                                    "; name materials of the scene with \"material\" or "
                                    "\"materials\" instead");
    }

    void warnOfMissing(const std::string& where, ReadContext& context) const {
        if (!missing_.empty())
            context.warn(where, "cannot read " + listInQuotes(missing_), "missing MTL files");
    }

private:
    void read(const std::filesystem::path& path, ReadContext& context) {
        const std::string text = readFile(path.string(), path.string());
        context.hash.add(text);
        materials_.merge(parseMtl(text, path.string()));
    }

    std::map<std::string, MtlMaterial> materials_;
    std::vector<std::string> missing_;
};

/// Statements, and options of textures, that have no effect.
struct Ignored {
    std::set<std::string> statements;
    std::set<std::string> options;

    void add(const MtlMaterial& mtl) {
        statements.insert(mtl.unsupported.begin(), mtl.unsupported.end());
        for (const auto* map : {&mtl.diffuseMap, &mtl.alphaMap, &mtl.bumpMap, &mtl.normalMap,
                                &mtl.roughnessMap, &mtl.emissionMap}) {
            if (*map)
                options.insert((*map)->ignored.begin(), (*map)->ignored.end());
        }
    }

    void warn(const std::string& where, ReadContext& context) const {
        const auto warnOf = [&](const char* what, const std::set<std::string>& names) {
            if (!names.empty()) {
                const std::vector<std::string> list(names.begin(), names.end());
                const std::string kind =
                    std::string("these MTL ") + what + " are not supported yet and were ignored: ";
                context.warn(where, kind + listInQuotes(list), kind);
            }
        };
        warnOf("statements", statements);
        warnOf("texture options", options);
    }
};

} // namespace

std::vector<uint32_t> materialsFromMtl(const ObjFile& obj, const std::string& objPath,
                                       UndefinedMaterials undefined, ObjCache& cache,
                                       ReadContext& context) {
    std::vector<uint32_t>& result = cache.mtlMaterials[objPath];
    if (!result.empty())
        return result;
    const std::filesystem::path path(objPath);
    const std::string prefix = path.filename().string() + ":";
    Material plain;
    plain.name = prefix;
    plain.place = objPath;
    plain.color = glm::dvec3(kUnstatedColor);

    MtlNotes notes;
    Ignored ignored;
    if (!obj.materialNames.empty()) {
        const MtlLibrary library(obj, path.parent_path(), context);
        MtlMaps maps(context);
        for (size_t i = 0; i < obj.materialNames.size(); ++i) {
            const std::string& name = obj.materialNames[i];
            const MtlMaterial* mtl = library.find(name);
            Material material = plain;
            if (mtl != nullptr) {
                material = materialFromMtl(*mtl, name, maps, notes);
                ignored.add(*mtl);
            } else if (undefined == UndefinedMaterials::Grey) {
                notes.add("a neutral grey stands for the undefined material", name);
            } else {
                library.failUndefined(name, objPath + ":" + std::to_string(obj.materialLines[i]));
            }
            material.name = prefix + name;
            material.place = objPath;
            result.push_back(context.addMaterial(material));
        }
        if (undefined == UndefinedMaterials::Grey)
            library.warnOfMissing(objPath, context);
    }
    result.push_back(obj.hasFacesWithoutMaterial ? context.addMaterial(plain) : 0);
    notes.warn(objPath, context);
    ignored.warn(objPath, context);
    return result;
}

} // namespace calotype
