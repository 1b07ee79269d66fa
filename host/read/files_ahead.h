#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "base/error.h"
#include "base/find_file.h"
#include "base/task_pool.h"

namespace calotype {

/// Files of one kind that are read and decoded on other threads, before the scene's reader comes to
/// them.
template <typename Contents>
class FilesAhead {
public:
    struct File {
        std::string bytes;
        std::shared_ptr<const Contents> contents;
    };

    /// Starts to read the file at `path` by `File read(onProgress)`, once for all spellings; leaves
    /// out what is no regular file, because pipes may block. `read` must use no data that changes
    /// or is destroyed meanwhile.
    template <typename Read>
    void start(const std::string& path, TaskPool& tasks, const Read& read) {
        std::error_code unknown;
        const bool isRegular = std::filesystem::is_regular_file(path, unknown);
        const uint64_t bytes = isRegular ? std::filesystem::file_size(path, unknown) : 0;
        if (!isRegular || unknown)
            return;
        Reading& reading = readings_[truePath(path)];
        if (reading)
            return;
        reading = tasks.add(bytes, [read](const OnProgress& onProgress) -> std::optional<File> {
            try {
                return read(onProgress);
            } catch (const SceneError&) {
                return std::nullopt; // it is read again in its turn, where the error belongs
            }
        });
    }

    /// The file, the first time that it is asked for. Nothing if it was not started, or if it
    /// cannot be read or decoded.
    std::optional<File> take(const std::string& path, TaskPool& tasks,
                             const OnProgress& onProgress = {}) {
        const auto found = readings_.find(truePath(path));
        if (found == readings_.end())
            return std::nullopt;
        const Reading reading = std::move(found->second);
        readings_.erase(found);
        return tasks.finish(*reading, onProgress);
    }

private:
    using Reading = std::shared_ptr<TaskOf<std::optional<File>>>;

    std::map<std::string, Reading> readings_; ///< by true path
};

} // namespace calotype
