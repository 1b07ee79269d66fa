#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/error.h"

namespace calotype {

/// Another process writes the output.
class OutputBusyError : public OutputError {
public:
    using OutputError::OutputError;
};

/// Keeps other processes from writing an output, on this machine and on others that share the
/// folder. It is a lock of the system on a hidden file beside the output: it ends with the process,
/// however that ends, and the destructor removes the file.
class OutputLock {
public:
    /// `target` is the result of outputTarget for `path`, which messages name. Throws
    /// OutputBusyError, with the process where it is known, if another one has the lock. Removes
    /// what a killed process left beside the target. Devices, pipes, and folders whose file system
    /// has no locks are not locked.
    OutputLock(const std::filesystem::path& target, const std::string& path);
    OutputLock(OutputLock&& other) noexcept;
    OutputLock& operator=(OutputLock&& other) noexcept;
    ~OutputLock();

private:
    std::unique_ptr<const std::string> file_; ///< whose text stays where it is
    int descriptor_ = -1;                     ///< -1: nothing is locked
};

/// Removes the files of the locks that this process holds. For a signal handler that ends the
/// process: it may be called while any other code runs.
void removeLockFiles() noexcept;

} // namespace calotype
