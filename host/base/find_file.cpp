#include "base/find_file.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "base/lowercase.h"
#include "base/names.h"
#include "base/read_file.h"

namespace calotype {
namespace {

namespace fs = std::filesystem;

/// Folders with more entries are not searched for a suggestion.
constexpr size_t kMostSuggestions = 10'000;
/// Longer paths cannot be opened on any supported system.
constexpr size_t kLongestPath = 4096;

/// Replaces backslashes by single slashes, also doubled ones from escaping.
std::string withSlashes(std::string name) {
    std::ranges::replace(name, '\\', '/');
    const auto isDouble = [](char a, char b) { return a == '/' && b == '/'; };
    name.erase(std::unique(name.begin(), name.end(), isDouble), name.end());
    return name;
}

/// "C:/textures" or "/textures".
bool isAbsolute(const std::string& name) {
    return name.starts_with('/') ||
           (name.size() > 1 && std::isalpha(static_cast<unsigned char>(name[0])) && name[1] == ':');
}

std::vector<std::string> entriesOf(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code stop;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, stop), end;
         !stop && entry != end; entry.increment(stop)) {
        names.push_back(entry->path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

/// Follows the parts of a path from `next` on, starting in `folder`, ignoring case.
std::optional<fs::path> findInAnyCase(const fs::path& folder, fs::path::const_iterator next,
                                      const fs::path::const_iterator& end) {
    if (next == end)
        return isReadableFile(folder.string()) ? std::optional(folder) : std::nullopt;
    const std::string part = next->string();
    ++next;
    std::error_code ignored;
    if (fs::exists(folder / part, ignored)) {
        if (const auto found = findInAnyCase(folder / part, next, end))
            return found;
    }
    for (const std::string& entry : entriesOf(folder)) {
        if (entry != part && lowercase(entry) == lowercase(part)) {
            if (const auto found = findInAnyCase(folder / entry, next, end))
                return found;
        }
    }
    return std::nullopt;
}

std::optional<fs::path> findInAnyCase(const fs::path& directory, const std::string& name) {
    const fs::path relative = fs::path(name).lexically_normal();
    return findInAnyCase(directory, relative.begin(), relative.end());
}

} // namespace

std::optional<fs::path> findFile(const fs::path& directory, const std::string& name) {
    if (name.size() > kLongestPath)
        return std::nullopt;
    if (isReadableFile((directory / name).string()))
        return directory / name;
    std::string rest = withSlashes(name);
    if (!isAbsolute(rest))
        return findInAnyCase(directory, rest);
    if (isReadableFile(rest))
        return rest;
    for (size_t slash = rest.find('/'); slash != std::string::npos; slash = rest.find('/')) {
        rest.erase(0, slash + 1);
        if (const auto found = findInAnyCase(directory, rest))
            return found;
    }
    return std::nullopt;
}

std::string nearestFile(const fs::path& directory, const std::string& name) {
    std::string path = withSlashes(name);
    if (isAbsolute(path))
        path.erase(0, path.find_last_of("/:") + 1);
    fs::path folder;
    for (const fs::path& part : fs::path(path)) {
        std::error_code ignored;
        if (fs::is_directory(directory / folder / part, ignored)) {
            folder /= part;
            continue;
        }
        const std::vector<std::string> entries = entriesOf(directory / folder);
        const std::string nearest =
            entries.size() > kMostSuggestions ? std::string() : nearestName(part.string(), entries);
        return nearest.empty() ? nearest : (folder / nearest).string();
    }
    return {};
}

} // namespace calotype
