// Work goes on where the system gives no further thread, as at its limit of processes.
#include "base/add_thread.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <pthread.h>

#include "base/fork_join.h"
#include "base/parallel_for.h"
#include "base/task_pool.h"

namespace calotype {
namespace {

/// While it exists no thread can be made: the stack of each would exceed the address space.
class NoThreads {
public:
    NoThreads() {
        pthread_getattr_default_np(&usual_);
        pthread_attr_t none = usual_;
        pthread_attr_setstacksize(&none, size_t{1} << 60);
        pthread_setattr_default_np(&none);
    }
    ~NoThreads() {
        pthread_setattr_default_np(&usual_);
        pthread_attr_destroy(&usual_);
    }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

private:
    pthread_attr_t usual_;
};

TEST(AddThreadTest, SaysWhetherThereIsAThread) {
    std::vector<std::jthread> threads;
    {
        const NoThreads none;
        ASSERT_FALSE(addThread(threads, [] {}));
    }
    EXPECT_TRUE(addThread(threads, [] {}));
    EXPECT_EQ(threads.size(), 1u);
}

TEST(AddThreadTest, APoolGoesOnWithTheThreadsThatItHas) {
    TaskPool pool(4);
    const auto first = pool.add(1, [](const OnProgress&) { return 1; });
    const NoThreads none;
    const auto second = pool.add(2, [](const OnProgress&) { return 2; });
    const auto third = pool.add(3, [](const OnProgress&) { return 3; });
    EXPECT_EQ(pool.finish(*third), 3);
    EXPECT_EQ(pool.finish(*first), 1);
    EXPECT_EQ(pool.finish(*second), 2);
    TaskPool alone(4);
    const auto task = alone.add(1, [](const OnProgress&) { return 7; });
    EXPECT_EQ(alone.finish(*task), 7);
}

TEST(AddThreadTest, LoopsGoOnWithTheThreadsThatTheyHave) {
    const NoThreads none;
    std::vector<int> calls(100);
    parallelFor(0, calls.size(), 4, [&](uint64_t i, uint32_t) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(100, 1));
    int both = 0;
    forkJoin(
        true, [&] { both += 1; }, [&] { both += 2; });
    EXPECT_EQ(both, 3);
}

// On either thread, after both have ended.
TEST(ForkJoinTest, ThrowsWhatTheFunctionsThrow) {
    for (const bool parallel : {false, true}) {
        std::atomic<bool> hasRun = false;
        const auto fail = [] { throw std::runtime_error("no result"); };
        EXPECT_THROW(forkJoin(parallel, fail, [&] { hasRun = true; }), std::runtime_error);
        EXPECT_TRUE(hasRun);
        hasRun = false;
        EXPECT_THROW(forkJoin(
                         parallel, [&] { hasRun = true; }, fail),
                     std::runtime_error);
        EXPECT_TRUE(hasRun);
    }
}

} // namespace
} // namespace calotype
