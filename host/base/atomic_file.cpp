#include "base/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace calotype {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& problem, int error,
                       const std::string& advice) {
    throw OutputError("cannot write '" + path.string() + "': " + problem + " (" +
                      std::generic_category().message(error) + "); " + advice);
}

[[noreturn]] void failWriting(const fs::path& path, int error) {
    fail(path, "writing failed", error, "check the free space and the file system");
}

fs::path folderOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The target of `path` after symbolic links, so that replacing the file keeps the link.
fs::path followLinks(const fs::path& path) {
    std::error_code missing;
    fs::path target = fs::canonical(path, missing);
    return missing ? path : target;
}

enum class Target { File, DeviceOrPipe };

/// Checks everything about the target that needs no opened file.
Target inspectTarget(const fs::path& path) {
    if (path.empty())
        fail(path, "the path is empty", ENOENT, "name a file");
    struct stat status {};
    const fs::path folder = folderOf(path);
    if (stat(folder.c_str(), &status) != 0)
        fail(path, "its folder '" + folder.string() + "' cannot be opened", errno,
             "create it first or write elsewhere");
    if (stat(path.c_str(), &status) != 0) {
        if (errno != ENOENT)
            fail(path, "the path cannot be used", errno, "choose another name");
        return Target::File;
    }
    if (S_ISDIR(status.st_mode))
        fail(path, "it is a folder", EISDIR, "name a file in it");
    if (access(path.c_str(), W_OK) != 0)
        fail(path, "it is write-protected", errno, "change its permissions or write elsewhere");
    return S_ISREG(status.st_mode) ? Target::File : Target::DeviceOrPipe;
}

/// A file open for writing. Errors name `path`, which is the path that the user gave.
class OutputDescriptor {
public:
    OutputDescriptor(const fs::path& path, int descriptor) : path_(path), descriptor_(descriptor) {}
    OutputDescriptor(const OutputDescriptor&) = delete;
    OutputDescriptor& operator=(const OutputDescriptor&) = delete;
    ~OutputDescriptor() {
        if (descriptor_ >= 0)
            ::close(descriptor_);
    }

    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR)
                failWriting(path_, errno);
            if (written > 0)
                bytes.remove_prefix(static_cast<size_t>(written));
        }
    }

    /// Writes the bytes to the disk before the rename, in case of a power failure.
    void flush() {
        if (::fsync(descriptor_) == 0)
            return;
        const bool notOfferedHere = errno == EINVAL || errno == ENOTSUP;
        if (!notOfferedHere)
            failWriting(path_, errno);
    }

    /// Network file systems report a full disk only here.
    void close() {
        const int result = ::close(descriptor_);
        descriptor_ = -1;
        if (result != 0 && errno != EINTR)
            failWriting(path_, errno);
    }

private:
    const fs::path& path_;
    int descriptor_;
};

/// A new, empty file in the folder of `path`. The destructor removes it, unless it replaced `path`.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& path)
        : path_(path), name_(folderOf(path)), output_(path, create()) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!renamed_)
            ::unlink(name_.c_str());
    }

    void write(std::string_view bytes) { output_.write(bytes); }

    void replaceTarget() {
        output_.flush();
        output_.close();
        if (std::rename(name_.c_str(), path_.c_str()) != 0)
            fail(path_, "the finished file cannot be put there", errno, "write elsewhere");
        renamed_ = true;
    }

private:
    int create() {
        static std::atomic<unsigned> counter = 0;
        const fs::path folder = name_;
        for (;;) {
            name_ = folder / (".calotype-" + std::to_string(::getpid()) + "-" +
                              std::to_string(counter++) + ".tmp");
            const int descriptor =
                ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor >= 0)
                return descriptor;
            if (errno != EEXIST)
                fail(path_, "no file can be made in '" + folder.string() + "'", errno,
                     "check the folder's permissions or write elsewhere");
        }
    }

    const fs::path& path_;
    fs::path name_;
    OutputDescriptor output_;
    bool renamed_ = false;
};

void writeToDeviceOrPipe(const fs::path& path, std::string_view bytes) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0)
        fail(path, "it cannot be opened", errno, "write elsewhere");
    OutputDescriptor output(path, descriptor);
    output.write(bytes);
    output.close();
}

} // namespace

void writeFileAtomically(const fs::path& path, std::string_view bytes) {
    const fs::path target = followLinks(path);
    if (inspectTarget(target) == Target::DeviceOrPipe)
        return writeToDeviceOrPipe(target, bytes);
    TemporaryFile file(target);
    file.write(bytes);
    file.replaceTarget();
}

void checkWritable(const fs::path& path) {
    const fs::path target = followLinks(path);
    if (inspectTarget(target) == Target::File)
        TemporaryFile{target};
}

} // namespace calotype
