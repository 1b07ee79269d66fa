# Toolchain of the preset clang and of the fuzzers: the oldest Clang on this machine whose C++20 is
# complete enough, as that is the one which finds what others do not compile.
find_program(CALOTYPE_CLANG NAMES clang++-16 clang++-17 clang++-18 clang++-19 clang++-20 clang++-21
             REQUIRED)
string(REPLACE "clang++" "clang" CALOTYPE_CLANG_C "${CALOTYPE_CLANG}")
set(CMAKE_CXX_COMPILER "${CALOTYPE_CLANG}")
set(CMAKE_C_COMPILER "${CALOTYPE_CLANG_C}")
