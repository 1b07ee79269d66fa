#include "base/output_lock.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/names.h"

namespace calotype {
namespace {

namespace fs = std::filesystem;

/// What the holder wrote: "process 1234 on machine7".
std::string readHolder(int descriptor) {
    std::array<char, 200> text{};
    const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
    return size > 0 ? printable({text.data(), static_cast<size_t>(size)}) : "another process";
}

void writeHolder(int descriptor) {
    std::array<char, 128> machine{};
    ::gethostname(machine.data(), machine.size() - 1);
    const std::string text = "process " + std::to_string(::getpid()) + " on " + machine.data();
    // For messages only: the lock is held also where the disk has no room for the text.
    if (::ftruncate(descriptor, 0) == 0)
        (void)!::pwrite(descriptor, text.data(), text.size(), 0);
}

bool isFileAt(const fs::path& path, const struct stat& opened) {
    struct stat there {};
    return ::stat(path.c_str(), &there) == 0 && there.st_dev == opened.st_dev &&
           there.st_ino == opened.st_ino;
}

struct OpenedFile {
    int descriptor; ///< -1: it cannot be opened
    bool isNew;
};

OpenedFile openOrMake(const fs::path& path) {
    constexpr int kFlags = O_CLOEXEC | O_NOFOLLOW;
    for (;;) {
        int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | kFlags, 0666);
        if (descriptor >= 0 || errno != EEXIST)
            return {descriptor, true};
        descriptor = ::open(path.c_str(), O_RDWR | kFlags);
        if (descriptor < 0 && errno == EACCES) // made by another user
            descriptor = ::open(path.c_str(), O_RDONLY | kFlags);
        if (descriptor >= 0 || errno != ENOENT) // else it was removed in between
            return {descriptor, false};
    }
}

/// A descriptor that has the lock, or -1 if the folder has no locks.
int lockFile(const fs::path& file, const fs::path& target, const std::string& path) {
    for (;;) {
        const auto [descriptor, isNew] = openOrMake(file);
        if (descriptor < 0)
            return -1;
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const bool isHeld = errno == EWOULDBLOCK;
            const std::string holder = isHeld ? readHolder(descriptor) : "";
            ::close(descriptor);
            if (!isHeld && isNew)
                ::unlink(file.c_str());
            if (!isHeld)
                return -1;
            throw OutputBusyError("'" + path + "' is being written by " + holder +
                                  "; wait until that has ended, or name another file");
        }
        struct stat opened {};
        if (::fstat(descriptor, &opened) == 0 && isFileAt(file, opened)) {
            if (!isNew) // a process that ended by itself would have removed the file
                removeLeftovers(target);
            return descriptor;
        }
        ::close(descriptor); // its holder removed it before this process had the lock
    }
}

/// The files of the locks that are held, for signal handlers. A command has a few; those of more
/// than these stay behind where a handler ends the process.
std::array<std::atomic<const char*>, 64> heldFiles{};
static_assert(std::atomic<const char*>::is_always_lock_free);

void addHeld(const char* name) {
    for (auto& file : heldFiles)
        if (const char* none = nullptr; file.compare_exchange_strong(none, name))
            return;
}

void removeHeld(const char* name) {
    for (auto& file : heldFiles)
        if (file == name)
            file = nullptr;
}

} // namespace

OutputLock::OutputLock(const fs::path& target, const std::string& path)
    : file_(std::make_unique<const std::string>(fileBeside(target, "lock").string())) {
    std::error_code ignored;
    if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored))
        return;
    descriptor_ = lockFile(*file_, target, path);
    if (descriptor_ < 0)
        return;
    addHeld(file_->c_str());
    writeHolder(descriptor_);
}

OutputLock::OutputLock(OutputLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputLock& OutputLock::operator=(OutputLock&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

OutputLock::~OutputLock() {
    if (descriptor_ < 0)
        return;
    removeHeld(file_->c_str());
    ::unlink(file_->c_str()); // before the lock ends, so that nobody locks a file that is gone
    ::close(descriptor_);
}

void removeLockFiles() noexcept {
    for (const auto& file : heldFiles)
        if (const char* name = file.load())
            ::unlink(name);
}

} // namespace calotype
