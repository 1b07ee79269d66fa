#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/output_lock.h"

namespace calotype {

/// The files that a command reads and writes. No file that is read is written, by whatever path or
/// link; each output must be writable before the work starts; and no other process may write it as
/// long as this object exists.
class OutputClaims {
public:
    /// Files that are read and must not be written. Empty paths are ignored. Throws UsageError if
    /// one of them is an output already.
    void reserve(const std::string& path);
    void reserve(std::span<const std::string> paths);

    /// Each throws UsageError if the file is reserved, claimed before, or of a wrong kind,
    /// OutputError if it cannot be written, and OutputBusyError if another process writes it.
    void claim(const std::string& path);
    void claimPicture(const std::string& path);
    void claimFilm(const std::string& path); ///< an existing file must be a film, or empty

private:
    struct Output {
        std::string path; ///< as the user gave it
        std::filesystem::path target;
        OutputLock lock;
    };

    std::vector<std::string> inputs_;
    std::vector<Output> outputs_;
};

/// Whether both paths lead to one existing file, also by links.
bool isSameFile(const std::string& a, const std::string& b);

} // namespace calotype
