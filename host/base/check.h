#pragma once

#include <cstdlib>
#include <iostream>

namespace calotype {

/// Ends the program: for mistakes of the programmer, never of the user.
template <typename A, typename B>
[[noreturn]] void failCheck(const char* expression, const A& a, const B& b, const char* file,
                            int line) {
    std::cerr << file << ":" << line << ": check failed: " << expression << " (" << a << " and "
              << b << ")\n";
    std::abort();
}

} // namespace calotype

/// Aborts with both values unless `a op b` holds. Active in every build type.
#define CALOTYPE_CHECK_OP(a, op, b)                                                                \
    do {                                                                                           \
        const auto& checkA = (a);                                                                  \
        const auto& checkB = (b);                                                                  \
        if (!(checkA op checkB))                                                                   \
            ::calotype::failCheck(#a " " #op " " #b, checkA, checkB, __FILE__, __LINE__);          \
    } while (false)

#define CALOTYPE_CHECK_EQ(a, b) CALOTYPE_CHECK_OP(a, ==, b)
#define CALOTYPE_CHECK_LT(a, b) CALOTYPE_CHECK_OP(a, <, b)
#define CALOTYPE_CHECK_LE(a, b) CALOTYPE_CHECK_OP(a, <=, b)
