#include "read/obj/mtl_library.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/file_kind.h"
#include "base/find_file.h"
#include "base/lowercase.h"
#include "base/text_cursor.h"
#include "read/obj/readings.h"

namespace calotype {
namespace {

constexpr std::string_view kExtension = ".mtl";

/// Names separated by blanks, which quotes may surround; a backslash escapes the next character.
std::vector<std::string> splitAtBlanks(std::string_view text) {
    std::vector<std::string> names(1);
    bool quoted = false;
    for (size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\\' && i + 1 < text.size())
            names.back() += text[++i];
        else if (text[i] == '"')
            quoted = !quoted;
        else if (isBlank(text[i]) && !quoted)
            names.emplace_back();
        else
            names.back() += text[i];
    std::erase(names, std::string());
    return names;
}

/// Cuts a text behind each ".mtl", with a quote or not, that a blank follows.
std::vector<std::string_view> splitAtExtensions(std::string_view text) {
    std::vector<std::string_view> names;
    const std::string lower = lowercase(text);
    size_t start = 0;
    for (size_t at = lower.find(kExtension); at != lower.npos; at = lower.find(kExtension, at)) {
        at += kExtension.size();
        const size_t end = at + (at < text.size() && text[at] == '"' ? 1 : 0);
        if (end < text.size() && isBlank(text[end])) {
            names.push_back(trimmed(text.substr(start, end - start)));
            start = end;
        }
    }
    names.push_back(trimmed(text.substr(start)));
    return names;
}

std::shared_ptr<const MtlFile> readMtl(const std::filesystem::path& path, ReadContext& context) {
    context.progress(path, 0.0);
    const std::string text = context.read(path.string(), path.string());
    const auto exists = [&](const std::string& name) {
        return context.finder.find(path.parent_path(), name).has_value();
    };
    auto file = std::make_shared<const MtlFile>(parseMtl(text, path.string(), exists));
    if (const auto kind = fileKind(text); file->materials.empty() && !text.empty() && !kind.empty())
        context.warn(path.string(), "is " + std::string(kind) +
                                        ", which has no materials; an MTL file is a text in UTF-8");
    for (const auto& [remark, occurrences] : file->remarks)
        context.warn(path.string(), remark + ": " + occurrences.text(), remark);
    return file;
}

/// Finds and reads the files that "mtllib" statements name.
class LibraryReader {
public:
    LibraryReader(const std::filesystem::path& directory, MtlFiles& files, ReadContext& context)
        : directory_(directory), files_(files), context_(context) {}

    /// Most exporters do not escape blanks in names: the whole may be one name, or each part up to
    /// an extension.
    void readStatement(std::string_view statement) {
        for (const std::string_view reading : readingsOf(statement))
            if (read(std::string(reading)))
                return;
        for (const std::string_view part : splitAtExtensions(withoutComment(statement))) {
            if (read(std::string(withoutQuotes(part))))
                continue;
            for (const std::string& name : splitAtBlanks(part))
                if (!read(name))
                    missing_.push_back(name);
        }
    }

    /// Those that were read, in the order of their first mention.
    std::vector<const MtlFile*> takeRead() { return std::move(read_); }
    std::vector<std::string> takeMissing() { return std::move(missing_); }

private:
    bool read(const std::string& name) {
        const auto path = name.empty() ? std::nullopt : context_.finder.find(directory_, name);
        if (!path)
            return false;
        std::shared_ptr<const MtlFile>& file = files_.byPath[truePath(*path)];
        try {
            if (!file)
                file = readMtl(*path, context_);
        } catch (const SceneError&) {
            return false;
        }
        if (known_.insert(file.get()).second)
            read_.push_back(file.get());
        return true;
    }

    const std::filesystem::path& directory_;
    MtlFiles& files_;
    ReadContext& context_;
    std::vector<const MtlFile*> read_;
    std::set<const MtlFile*> known_;
    std::vector<std::string> missing_;
};

std::shared_ptr<const MtlIndex> makeIndex(const std::vector<const MtlFile*>& files) {
    auto index = std::make_shared<MtlIndex>();
    for (const MtlFile* file : files)
        for (const auto& [name, material] : file->materials)
            for (const std::string_view reading : readingsOf(name))
                if (!reading.empty())
                    (reading == name ? index->byName : index->byReading)
                        .try_emplace(reading, NamedMtl{name, &material});
    return index;
}

} // namespace

MtlLibrary::MtlLibrary(std::span<const std::string> statements,
                       const std::filesystem::path& directory, MtlFiles& files,
                       ReadContext& context) {
    LibraryReader reader(directory, files, context);
    std::set<std::string_view> seen;
    for (const std::string& statement : statements)
        if (seen.insert(statement).second)
            reader.readStatement(statement);
    missing_ = reader.takeMissing();
    const std::vector<const MtlFile*> read = reader.takeRead();
    std::shared_ptr<const MtlIndex>& index = files.indices[read];
    if (!index)
        index = makeIndex(read);
    index_ = index;
}

NamedMtl MtlLibrary::find(std::string_view text) const {
    const std::vector<std::string_view> readings = readingsOf(text);
    for (const MtlIndex::Names* names : {&index_->byName, &index_->byReading})
        for (const std::string_view reading : readings)
            if (const auto found = names->find(reading); found != names->end())
                return found->second;
    return {withoutQuotes(withoutComment(text)), nullptr};
}

std::vector<std::string> MtlLibrary::names() const {
    std::vector<std::string> names;
    for (const auto& [name, unused] : index_->byName)
        names.emplace_back(name);
    std::ranges::sort(names);
    return names;
}

} // namespace calotype
