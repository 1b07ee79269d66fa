// Tasks on other threads, and what becomes of their results, errors and progress.

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/task_pool.h"

namespace calotype {
namespace {

/// Occupies the pool's other thread until `end` is ready.
auto occupy(TaskPool& pool, const std::shared_future<void>& end) {
    auto begun = std::make_shared<std::promise<void>>();
    std::future<void> hasBegun = begun->get_future();
    const auto task = pool.add(0, [begun, end](const OnProgress&) {
        begun->set_value();
        end.wait();
        return std::this_thread::get_id();
    });
    hasBegun.wait();
    return task;
}

TEST(TaskPoolTest, GivesResultsInAnyOrderOnAnyNumberOfThreads) {
    for (const uint32_t threads : {1u, 2u, 5u}) {
        TaskPool pool(threads);
        std::vector<std::shared_ptr<TaskOf<int>>> tasks;
        for (int i = 0; i < 100; ++i)
            tasks.push_back(pool.add(i % 7, [i](const OnProgress&) { return i * i; }));
        for (int i = 99; i >= 0; --i)
            EXPECT_EQ(pool.finish(*tasks[i]), i * i) << threads;
    }
}

TEST(TaskPoolTest, TheCallerDoesWhatNoOtherThreadHasBegun) {
    TaskPool pool(2);
    std::promise<void> end;
    const auto occupied = occupy(pool, end.get_future().share());
    const auto mine = pool.add(1, [](const OnProgress&) { return std::this_thread::get_id(); });
    EXPECT_EQ(pool.finish(*mine), std::this_thread::get_id());
    end.set_value();
    EXPECT_NE(pool.finish(*occupied), std::this_thread::get_id());
}

TEST(TaskPoolTest, TheLargestCostComesFirst) {
    std::atomic<int> order = 0;
    std::vector<int> placeOf(3);
    std::vector<std::shared_ptr<TaskOf<std::thread::id>>> tasks;
    std::promise<void> end;
    {
        TaskPool pool(2);
        tasks.push_back(occupy(pool, end.get_future().share()));
        for (const int i : {1, 0, 2})
            tasks.push_back(pool.add(i, [&, i](const OnProgress&) {
                placeOf[i] = order++;
                return std::this_thread::get_id();
            }));
        end.set_value();
        while (order < 3)
            std::this_thread::yield();
    }
    EXPECT_EQ(placeOf, (std::vector<int>{2, 1, 0}));
}

TEST(TaskPoolTest, WhatATaskThrowsIsThrownWhereItsResultIsNeeded) {
    for (const uint32_t threads : {1u, 2u}) {
        TaskPool pool(threads);
        const auto bad =
            pool.add(0, [](const OnProgress&) -> int { throw std::runtime_error("no result"); });
        const auto good = pool.add(0, [](const OnProgress&) { return 3; });
        EXPECT_EQ(pool.finish(*good), 3);
        EXPECT_THROW(pool.finish(*bad), std::runtime_error);
    }
}

TEST(TaskPoolTest, WaitingEndsWithWhatTheProgressThrows) {
    TaskPool pool(2);
    std::promise<void> end;
    const auto task = occupy(pool, end.get_future().share());
    int calls = 0;
    EXPECT_THROW(pool.finish(*task,
                             [&](double) {
                                 if (++calls == 3)
                                     throw std::runtime_error("stopped");
                             }),
                 std::runtime_error);
    end.set_value();
}

// The task below ends only by its own progress, which throws when the pool is destroyed.
TEST(TaskPoolTest, ADestroyedPoolEndsItsTasks) {
    std::atomic<bool> hasRun = false;
    std::atomic<bool> hasEnded = false;
    {
        TaskPool pool(2);
        std::promise<void> begun;
        pool.add(1, [&](const OnProgress& onProgress) -> int {
            begun.set_value();
            try {
                while (true)
                    onProgress(0.5);
            } catch (...) {
                hasEnded = true;
                throw;
            }
        });
        begun.get_future().wait();
        pool.add(0, [&](const OnProgress&) {
            hasRun = true;
            return 0;
        });
    }
    EXPECT_TRUE(hasEnded);
    EXPECT_FALSE(hasRun);
}

} // namespace
} // namespace calotype
