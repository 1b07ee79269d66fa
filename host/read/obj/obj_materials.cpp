#include "read/obj/obj_materials.h"

#include <filesystem>
#include <set>

#include "base/names.h"
#include "read/obj/mtl_material.h"
#include "read/texture_file.h"

namespace calotype {
namespace {

/// Statements, and options of textures, that have no effect.
struct Ignored {
    std::set<std::string> statements;
    std::set<std::string> options;

    void add(const MtlMaterial& mtl) {
        for (const auto& [keyword, written] : mtl.unsupported)
            if (mattersIn(mtl, keyword))
                statements.insert(written);
        for (const auto* map : {&mtl.diffuseMap, &mtl.alphaMap, &mtl.bumpMap, &mtl.normalMap,
                                &mtl.roughnessMap, &mtl.metallicMap, &mtl.emissionMap,
                                &mtl.exponentMap, &mtl.specularMap, &mtl.reflectionMap}) {
            if (*map)
                options.insert((*map)->ignored.begin(), (*map)->ignored.end());
        }
    }

    void warn(const std::string& where, ReadContext& context) const {
        const auto warnOf = [&](const char* what, const std::set<std::string>& names) {
            if (!names.empty()) {
                const std::vector<std::string> list(names.begin(), names.end());
                const std::string kind =
                    std::string("these MTL ") + what + " are not supported and were ignored: ";
                context.warn(where, kind + listInQuotes(list), kind);
            }
        };
        warnOf("statements", statements);
        warnOf("texture options", options);
    }

private:
    /// Pcr has no effect without Pc, nor anisor without aniso.
    static bool mattersIn(const MtlMaterial& mtl, const std::string& keyword) {
        const auto has = [&](const char* other) { return mtl.unsupported.contains(other); };
        return (keyword != "pcr" || has("pc") || has("map_pc")) &&
               (keyword != "anisor" || has("aniso") || has("map_aniso"));
    }
};

/// Makes the materials of one OBJ.
class Maker {
public:
    Maker(const ObjFile& obj, const std::string& objPath, ObjCache& cache, ReadContext& context)
        : obj_(obj), path_(objPath), context_(context), maps_(cache.maps, context) {
        ObjCache::Materials& materials = cache.materials[objPath];
        indices_ = &materials.indices;
        indices_->resize(obj.materialNames.size() + 1);
        if (!materials.library && !obj.materialNames.empty()) {
            materials.library = std::make_unique<MtlLibrary>(
                obj.libraries, std::filesystem::path(objPath).parent_path(), cache.mtlFiles,
                context);
            if (!materials.library->missing().empty())
                context.warn(objPath, "cannot read " + listInQuotes(materials.library->missing()),
                             "missing MTL files");
        }
        library_ = materials.library.get();
    }

    /// Checks by the headers of the image files that there is memory for them, and starts to read
    /// them.
    void requireMemoryForTextures(const NeededMaterials& needed) {
        for (size_t i = 0; i < obj_.materialNames.size(); ++i)
            if (const MtlMaterial* mtl = library_->find(obj_.materialNames[i]).material;
                mtl && needed[i] && !(*indices_)[i]) // else they are counted already
                countTextures(*mtl);
        startTextures(context_);
    }

    /// `i` is an index into ObjFile::materialNames, or their number for faces without a material.
    uint32_t indexOf(size_t i) {
        std::optional<uint32_t>& index = (*indices_)[i];
        if (!index)
            index = i < obj_.materialNames.size() ? addMaterial(i) : addPlain("");
        return *index;
    }

    void warn() const {
        notes_.warn(path_, context_);
        ignored_.warn(path_, context_);
        if (undefined_.empty())
            return;
        const std::string nearest = library_->missing().empty()
                                        ? nearestName(undefined_.front(), library_->names())
                                        : std::string();
        context_.warn(path_,
                      "a neutral grey stands for the undefined material in " +
                          listInQuotes(undefined_) + " (used from line " +
                          std::to_string(undefinedLine_) + " on)" +
                          (nearest.empty() ? "" : "; did you mean " + inQuotes(nearest) + "?"),
                      "undefined materials");
    }

private:
    void countTextures(const MtlMaterial& mtl) {
        visitImagesOf(mtl, [&](const MtlTexture& map, bool isUploaded) {
            countTexture(map.file, mtl.directory, isUploaded, context_);
        });
    }

    uint32_t addMaterial(size_t i) {
        const auto [name, mtl] = library_->find(obj_.materialNames[i]);
        const std::string text(name);
        if (mtl == nullptr && !text.empty()) {
            if (undefined_.empty())
                undefinedLine_ = obj_.materialLines[i];
            undefined_.push_back(text);
        }
        if (mtl == nullptr)
            return addPlain(text);
        ignored_.add(*mtl);
        return add(materialFromMtl(*mtl, text, maps_, notes_), text);
    }

    uint32_t addPlain(const std::string& name) {
        Material plain;
        plain.color = glm::dvec3(kUnstatedColor);
        return add(plain, name);
    }

    uint32_t add(Material material, const std::string& name) {
        material.name = std::filesystem::path(path_).filename().string() + ":" + name;
        material.place = path_;
        return context_.addMaterial(std::move(material));
    }

    const ObjFile& obj_;
    const std::string& path_;
    ReadContext& context_;
    MtlMaps maps_;
    const MtlLibrary* library_ = nullptr;
    std::vector<std::optional<uint32_t>>* indices_ = nullptr;
    MtlNotes notes_;
    Ignored ignored_;
    std::vector<std::string> undefined_;
    size_t undefinedLine_ = 0;
};

} // namespace

NeededMaterials allMaterials(const ObjFile& obj) {
    NeededMaterials needed(obj.materialNames.size() + 1, true);
    needed.back() = obj.hasFacesWithoutMaterial;
    return needed;
}

std::vector<uint32_t> materialsFromMtl(const ObjFile& obj, const std::string& objPath,
                                       const NeededMaterials& needed, ObjCache& cache,
                                       ReadContext& context) {
    Maker maker(obj, objPath, cache, context);
    maker.requireMemoryForTextures(needed);
    std::vector<uint32_t> result;
    for (size_t i = 0; i < needed.size(); ++i)
        result.push_back(needed[i] ? maker.indexOf(i) : 0);
    maker.warn();
    return result;
}

} // namespace calotype
