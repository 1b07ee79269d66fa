#include "base/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "base/content_hash.h"
#include "base/error.h"
#include "base/hexadecimal.h"

namespace calotype {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOurMark = ".calotype-";
constexpr const char* kTemporaryEnd = ".tmp";
/// Of a file, so that what is added fits into the 255 bytes of Linux.
constexpr size_t kLongestName = 200;

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

/// As many links as Linux follows.
constexpr int kMostLinks = 40;

/// The target of `path` after symbolic links, so that replacing the file keeps the link. The target
/// need not exist.
fs::path followLinks(const fs::path& path) {
    std::error_code ignored;
    if (fs::path target = fs::canonical(path, ignored); !ignored)
        return target;
    if (fs::exists(path, ignored)) // such as /dev/stdout, where that is a pipe
        return path;
    fs::path target = path;
    for (int links = 0; links < kMostLinks && fs::is_symlink(target, ignored); ++links)
        target = folderOf(target) / fs::read_symlink(target, ignored);
    return target;
}

/// What is copied from the file that is replaced. Only root may give a file to another owner, so
/// each of these may fail, and then the new file keeps what it has.
void keepOwnerAndMode(const struct stat& replaced, int descriptor) {
    struct stat made {};
    if (fstat(descriptor, &made) != 0)
        return;
    const bool isSameOwner = made.st_uid == replaced.st_uid && made.st_gid == replaced.st_gid;
    const bool hasGroup = isSameOwner ||
                          fchown(descriptor, replaced.st_uid, replaced.st_gid) == 0 ||
                          fchown(descriptor, static_cast<uid_t>(-1), replaced.st_gid) == 0;
    // The rights of one group are not those of another.
    const mode_t rights = hasGroup ? 07777 : 07707;
    (void)fchmod(descriptor, replaced.st_mode & rights);
}

/// Such as access control lists.
void keepAttributes(const fs::path& replaced, int descriptor) {
    std::string names(1 << 16, '\0'); // the most that Linux lists
    const ssize_t listed = listxattr(replaced.c_str(), names.data(), names.size());
    names.resize(listed > 0 ? static_cast<size_t>(listed) : 0);
    std::string value(1 << 16, '\0'); // the most that Linux keeps
    for (size_t at = 0; at < names.size(); at += std::strlen(&names[at]) + 1) {
        const ssize_t size = getxattr(replaced.c_str(), &names[at], value.data(), value.size());
        if (size >= 0)
            (void)fsetxattr(descriptor, &names[at], value.data(), static_cast<size_t>(size), 0);
    }
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

    int number() const { return descriptor_; }

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
        : path_(path), isReplacing_(stat(path.c_str(), &replaced_) == 0), output_(path, create()) {
        if (!isReplacing_)
            return;
        keepOwnerAndMode(replaced_, output_.number());
        keepAttributes(path, output_.number());
    }
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
        // Until it has the rights of the file that it replaces, nobody else reads it.
        const mode_t mode = isReplacing_ ? 0600 : 0666;
        for (;;) {
            name_ = fileBeside(path_, std::to_string(::getpid()) + "-" + std::to_string(counter++) +
                                          kTemporaryEnd);
            const int descriptor =
                ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
            if (descriptor >= 0)
                return descriptor;
            if (errno != EEXIST)
                fail(path_, "no file can be made in '" + folderOf(path_).string() + "'", errno,
                     "check the folder's permissions or write elsewhere");
        }
    }

    const fs::path& path_;
    struct stat replaced_ {};
    bool isReplacing_;
    fs::path name_;
    OutputDescriptor output_;
    bool renamed_ = false;
};

void writeToDeviceOrPipe(const fs::path& path, std::span<const std::string_view> pieces) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0)
        fail(path, "it cannot be opened", errno, "write elsewhere");
    OutputDescriptor output(path, descriptor);
    for (const std::string_view piece : pieces)
        output.write(piece);
    output.close();
}

} // namespace

fs::path outputTarget(const fs::path& path) {
    std::error_code unresolved; // then it cannot be written either
    const fs::path target = followLinks(path);
    const fs::path whole = fs::weakly_canonical(fs::absolute(target, unresolved), unresolved);
    return unresolved ? target : whole;
}

fs::path fileBeside(const fs::path& target, const std::string& ending) {
    std::string name = target.filename().string();
    if (name.size() > kLongestName) {
        ContentHash hash;
        hash.add(name);
        name = hexadecimal(hash.value());
    }
    return folderOf(target) / ("." + name + kOurMark + ending);
}

void removeLeftovers(const fs::path& target) {
    const std::string start = fileBeside(target, "").filename().string();
    std::error_code stop;
    for (fs::directory_iterator entry(folderOf(target), stop), end; !stop && entry != end;
         entry.increment(stop)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(start) && name.ends_with(kTemporaryEnd))
            ::unlink(entry->path().c_str());
    }
}

void writeFileAtomically(const fs::path& path, std::string_view bytes) {
    writeFileAtomically(path, std::span(&bytes, 1));
}

void writeFileAtomically(const fs::path& path, std::span<const std::string_view> pieces) {
    const fs::path target = followLinks(path);
    if (inspectTarget(target) == Target::DeviceOrPipe)
        return writeToDeviceOrPipe(target, pieces);
    TemporaryFile file(target);
    for (const std::string_view piece : pieces)
        file.write(piece);
    file.replaceTarget();
}

void checkWritable(const fs::path& path) {
    const fs::path target = followLinks(path);
    if (inspectTarget(target) == Target::File)
        TemporaryFile{target};
}

} // namespace calotype
