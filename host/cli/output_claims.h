#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace calotype {

/// The files that a command reads and writes. No file may have two uses, and each output must be
/// writable before the work starts.
class OutputClaims {
public:
    /// A file that is read and must not be written. An empty path is ignored.
    void reserve(const std::string& path);

    /// Each throws UsageError if the path is reserved, claimed before, or of a wrong kind, and
    /// OutputError if it cannot be written.
    void claim(const std::string& path);
    void claimPicture(const std::string& path);
    void claimFilm(const std::string& path); ///< an existing file must be a film, or empty

private:
    std::set<std::filesystem::path> taken_;
};

} // namespace calotype
