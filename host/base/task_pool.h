#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <queue>
#include <thread>
#include <utility>
#include <vector>

#include "base/progress.h"

namespace calotype {

/// Work that a TaskPool does.
class Task {
public:
    explicit Task(uint64_t cost) : cost_(cost) {}
    virtual ~Task() = default;

private:
    friend class TaskPool;
    enum class State : uint8_t { Waiting, Running, Done };

    /// Keeps the result, or what was thrown.
    virtual void run(const OnProgress& onProgress) noexcept = 0;

    uint64_t cost_;
    State state_ = State::Waiting;   ///< guarded by the pool's mutex
    std::atomic<double> done_ = 0.0; ///< share
};

/// Work that gives a result.
template <typename Result>
class TaskOf : public Task {
public:
    using Work = std::function<Result(const OnProgress&)>;

    TaskOf(uint64_t cost, Work work) : Task(cost), work_(std::move(work)) {}

private:
    friend class TaskPool;

    void run(const OnProgress& onProgress) noexcept override {
        try {
            result_.emplace(work_(onProgress));
        } catch (...) {
            failure_ = std::current_exception();
        }
        work_ = nullptr; // frees what it holds
    }

    Result take() {
        if (failure_)
            std::rethrow_exception(failure_);
        return std::move(*result_);
    }

    Work work_;
    std::optional<Result> result_;
    std::exception_ptr failure_;
};

/// Does tasks on other threads before their results are needed: the one of the largest cost first,
/// so that the threads end at about the same time. The thread that asks for a result does the task
/// itself if no other has begun it. Tasks must not use data that changes meanwhile. One thread
/// uses a pool.
class TaskPool {
public:
    /// `threads` >= 1 are used, including that of the caller; fewer if the system gives fewer.
    explicit TaskPool(uint32_t threads) : threads_(threads) {}
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    /// Adds a task. `work` gets a function to call with its progress, which throws if the result is
    /// no longer needed. `cost` is compared with that of others.
    template <typename Work>
    auto add(uint64_t cost, Work work) {
        using Result = std::invoke_result_t<Work, const OnProgress&>;
        const auto task = std::make_shared<TaskOf<Result>>(cost, std::move(work));
        enqueue(task);
        return task;
    }

    /// The result of the task, to be called once for each. Throws what the work has thrown, and
    /// what `onProgress` throws, which is called on this thread only.
    template <typename Result>
    Result finish(TaskOf<Result>& task, const OnProgress& onProgress = {}) {
        complete(task, onProgress);
        return task.take();
    }

private:
    struct IsCheaper {
        bool operator()(const std::shared_ptr<Task>& a, const std::shared_ptr<Task>& b) const {
            return a->cost_ < b->cost_;
        }
    };

    void enqueue(std::shared_ptr<Task> task);
    void complete(Task& task, const OnProgress& onProgress);
    std::shared_ptr<Task> nextWaiting();
    void work();

    uint32_t threads_;
    std::mutex mutex_;
    std::condition_variable isAdded_;
    std::condition_variable isDone_;
    std::priority_queue<std::shared_ptr<Task>, std::vector<std::shared_ptr<Task>>, IsCheaper>
        tasks_; ///< some may be running, or done
    std::atomic<bool> isStopped_ = false;
    std::vector<std::jthread> others_;
};

} // namespace calotype
