#pragma once

#include <string_view>

#include <gtest/gtest.h>

namespace calotype::test {

/// True in the tests that have the label slow: their suite or case is named Slow...
inline bool isSlowRun() {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    const auto isSlow = [](std::string_view name) { return name.find("Slow") != name.npos; };
    return isSlow(test.test_suite_name()) || isSlow(test.name());
}

/// How many samples, seeds or scenes a test takes: few where it runs with all others, and all of
/// them where it has the label slow.
template <typename Number>
Number quickOrFull(Number quick, Number full) {
    return isSlowRun() ? full : quick;
}

} // namespace calotype::test

/// After TEST_F(SUITE, CASE) { ... }: the same test a second time as SlowSUITE.CASE, with the label
/// slow and thus the full counts.
#define ALSO_SLOW(SUITE, CASE) CALOTYPE_ALSO_SLOW(SUITE, SUITE, CASE)

/// The same after TEST.
#define ALSO_SLOW_TEST(SUITE, CASE) CALOTYPE_ALSO_SLOW(testing::Test, SUITE, CASE)

#define CALOTYPE_ALSO_SLOW(FIXTURE, SUITE, CASE)                                                   \
    [[maybe_unused]] const testing::TestInfo* const slow##SUITE##CASE =                            \
        testing::RegisterTest("Slow" #SUITE, #CASE, nullptr, nullptr, __FILE__, __LINE__,          \
                              []() -> FIXTURE* { return new SUITE##_##CASE##_Test; })
