# Toolchain of the preset clang: the newest Clang on this machine whose C++20 is complete enough (16 or
# later).
find_program(CALOTYPE_CLANG NAMES clang++-21 clang++-20 clang++-19 clang++-18 clang++-17 clang++-16
             REQUIRED)
string(REPLACE "clang++" "clang" CALOTYPE_CLANG_C "${CALOTYPE_CLANG}")
set(CMAKE_CXX_COMPILER "${CALOTYPE_CLANG}")
set(CMAKE_C_COMPILER "${CALOTYPE_CLANG_C}")
