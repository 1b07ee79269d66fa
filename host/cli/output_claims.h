#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace calotype {

/// The files that a command reads and will write: none may be two things at once, and each must be
/// writable before the work begins.
class OutputClaims {
public:
    /// A file that is read, and may not be written. An empty path is none.
    void reserve(const std::string& path);

    /// Each throws UsageError where the path is reserved, claimed before, or of no fitting kind,
    /// and OutputError where it cannot be written.
    void claim(const std::string& path);
    void claimPicture(const std::string& path);
    void claimFilm(const std::string& path); ///< an existing file has to be a film, or empty

private:
    std::set<std::filesystem::path> taken_;
};

} // namespace calotype
