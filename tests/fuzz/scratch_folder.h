#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace calotype::fuzz {

/// A folder in memory for the files of one fuzzer, removed when it ends of itself.
class ScratchFolder {
public:
    ScratchFolder() {
        const char* const shared = "/dev/shm";
        const std::filesystem::path parent =
            std::filesystem::is_directory(shared) ? shared : std::filesystem::temp_directory_path();
        std::string name = (parent / "calotype-fuzz-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("no scratch folder can be made in " + parent.string());
        path_ = name;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    /// The path of the file, for readers.
    std::string write(const std::string& name, std::string_view bytes) const {
        const std::filesystem::path path = path_ / name;
        std::ofstream file(path, std::ios::binary);
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        if (!file.flush())
            throw std::runtime_error("cannot write " + path.string());
        return path.string();
    }

private:
    std::filesystem::path path_;
};

} // namespace calotype::fuzz
