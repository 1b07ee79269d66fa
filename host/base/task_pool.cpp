#include "base/task_pool.h"

#include <chrono>

#include "base/add_thread.h"

namespace calotype {
namespace {

/// Ends a task whose result is no longer needed.
struct Stopped {};

} // namespace

TaskPool::~TaskPool() {
    {
        const std::lock_guard lock(mutex_);
        isStopped_ = true;
    }
    isAdded_.notify_all();
    others_.clear(); // joins them
}

void TaskPool::enqueue(std::shared_ptr<Task> task) {
    if (threads_ == 1)
        return; // each task is done when its result is needed
    {
        const std::lock_guard lock(mutex_);
        tasks_.push(std::move(task));
    }
    if (others_.size() + 1 < threads_ && !addThread(others_, [this] { work(); }))
        threads_ = static_cast<uint32_t>(others_.size()) + 1;
    isAdded_.notify_one();
}

void TaskPool::complete(Task& task, const OnProgress& onProgress) {
    constexpr auto kInterval = std::chrono::milliseconds(50);
    if (onProgress)
        onProgress(0.0);
    std::unique_lock lock(mutex_);
    if (task.state_ == Task::State::Waiting) {
        task.state_ = Task::State::Running;
        lock.unlock();
        task.run(onProgress);
        return;
    }
    while (!isDone_.wait_for(lock, kInterval, [&] { return task.state_ == Task::State::Done; })) {
        lock.unlock();
        if (onProgress)
            onProgress(task.done_);
        lock.lock();
    }
}

/// Null if there is none.
std::shared_ptr<Task> TaskPool::nextWaiting() {
    while (!tasks_.empty()) {
        std::shared_ptr<Task> task = tasks_.top();
        tasks_.pop();
        if (task->state_ == Task::State::Waiting)
            return task;
    }
    return nullptr;
}

void TaskPool::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        std::shared_ptr<Task> task;
        isAdded_.wait(lock, [&] { return isStopped_ || (task = nextWaiting()) != nullptr; });
        if (isStopped_)
            return;
        task->state_ = Task::State::Running;
        lock.unlock();
        task->run([&](double done) {
            if (isStopped_)
                throw Stopped();
            task->done_ = done;
        });
        lock.lock();
        task->state_ = Task::State::Done;
        isDone_.notify_all();
    }
}

} // namespace calotype
