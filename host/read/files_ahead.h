#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/find_file.h"
#include "base/task_pool.h"

namespace calotype {

/// The most bytes of files of one kind that are kept ahead on any machine.
inline constexpr uint64_t kMostBytesAhead = uint64_t{1} << 30;

/// The most on this machine: less than kMostBytesAhead where little memory is available.
uint64_t bytesAhead();

/// Files of one kind that are read and decoded on other threads, before the scene's reader comes to
/// them. Those that are not taken yet hold at most `mostBytes`: further files wait until some are
/// taken.
template <typename Contents>
class FilesAhead {
public:
    struct File {
        std::string bytes;
        std::shared_ptr<const Contents> contents;
    };

    FilesAhead() : FilesAhead(bytesAhead()) {}
    explicit FilesAhead(uint64_t mostBytes) : mostBytes_(mostBytes) {}

    /// Starts to read the file at `path` by `File read(onProgress)`, once for all spellings; leaves
    /// out what is no regular file, because pipes may block, and files of more than `mostBytes`.
    /// `read` must use no data that changes or is destroyed meanwhile.
    template <typename Read>
    void start(const std::string& path, TaskPool& tasks, const Read& read) {
        std::error_code unknown;
        const bool isRegular = std::filesystem::is_regular_file(path, unknown);
        const uint64_t bytes = isRegular ? std::filesystem::file_size(path, unknown) : 0;
        if (!isRegular || unknown || bytes > mostBytes_)
            return;
        const std::string key = truePath(path);
        const auto work = [read](const OnProgress& onProgress) -> std::optional<File> {
            try {
                return read(onProgress);
            } catch (const SceneError&) {
                return std::nullopt; // it is read again in its turn, where the error belongs
            }
        };
        if (readings_.try_emplace(key, Reading{bytes, work, nullptr}).second)
            waiting_.push(key);
        startWaiting(tasks);
    }

    /// The file, the first time that it is asked for. Nothing if it was not started, or if it
    /// cannot be read or decoded.
    std::optional<File> take(const std::string& path, TaskPool& tasks,
                             const OnProgress& onProgress = {}) {
        const auto found = readings_.find(truePath(path));
        if (found == readings_.end() || found->second.isTaken)
            return std::nullopt;
        Reading& reading = found->second;
        reading.isTaken = true;
        if (!reading.task)
            return std::nullopt;
        const auto task = std::exchange(reading.task, nullptr);
        std::optional<File> file = tasks.finish(*task, onProgress);
        heldBytes_ -= reading.bytes;
        startWaiting(tasks);
        return file;
    }

private:
    using Work = std::function<std::optional<File>(const OnProgress&)>;

    struct Reading {
        uint64_t bytes;
        Work work;
        std::shared_ptr<TaskOf<std::optional<File>>> task; ///< null while it waits
        bool isTaken = false;
    };

    /// Starts those that wait, in their order, as far as their bytes fit.
    void startWaiting(TaskPool& tasks) {
        for (; !waiting_.empty(); waiting_.pop()) {
            Reading& reading = readings_.at(waiting_.front());
            if (reading.isTaken)
                continue;
            if (heldBytes_ + reading.bytes > mostBytes_)
                return;
            heldBytes_ += reading.bytes;
            reading.task = tasks.add(reading.bytes, std::exchange(reading.work, nullptr));
        }
    }

    uint64_t mostBytes_;
    uint64_t heldBytes_ = 0;                  ///< of those that are started and not taken
    std::map<std::string, Reading> readings_; ///< by true path
    std::queue<std::string> waiting_;         ///< their true paths
};

} // namespace calotype
