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

} // namespace

std::string truePath(const fs::path& path) {
    std::error_code error;
    const fs::path result = fs::canonical(path, error);
    return error ? path.string() : result.string();
}

const FileFinder::Listing& FileFinder::listingOf(const fs::path& folder) {
    const auto [entry, isNew] = listings_.try_emplace(folder.string());
    Listing& listing = entry->second;
    if (!isNew)
        return listing;
    std::error_code stop;
    for (fs::directory_iterator at(folder.empty() ? "." : folder, stop), end; !stop && at != end;
         at.increment(stop)) {
        listing.names.push_back(at->path().filename().string());
    }
    std::ranges::sort(listing.names);
    for (const std::string& name : listing.names)
        listing.byLowercase[lowercase(name)].push_back(name);
    return listing;
}

/// Follows the parts of a path from `next` on, starting in `folder`, ignoring case.
std::optional<fs::path> FileFinder::findInAnyCase(const fs::path& folder,
                                                  fs::path::const_iterator next,
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
    const auto& byLowercase = listingOf(folder).byLowercase;
    const auto same = byLowercase.find(lowercase(part));
    if (same == byLowercase.end())
        return std::nullopt;
    for (const std::string& entry : same->second) {
        if (entry != part) {
            if (const auto found = findInAnyCase(folder / entry, next, end))
                return found;
        }
    }
    return std::nullopt;
}

std::optional<fs::path> FileFinder::findInAnyCase(const fs::path& directory,
                                                  const std::string& name) {
    const fs::path relative = fs::path(name).lexically_normal();
    return findInAnyCase(directory, relative.begin(), relative.end());
}

std::optional<fs::path> FileFinder::find(const fs::path& directory, const std::string& name) {
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

std::string FileFinder::nearest(const fs::path& directory, const std::string& name) {
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
        const std::vector<std::string>& entries = listingOf(directory / folder).names;
        const std::string nearest =
            entries.size() > kMostSuggestions ? std::string() : nearestName(part.string(), entries);
        return nearest.empty() ? nearest : (folder / nearest).string();
    }
    return {};
}

} // namespace calotype
