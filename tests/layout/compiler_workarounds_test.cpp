// Compilers drop or change what the code says in some places, and the code works around that. Each
// workaround has a test that fails without it. The other ones:
// -fno-tree-slp-vectorize (CMakeLists.txt):
// PackSceneTest.SpheresKeepWhatRoundingTakesFromTheirCentres.
#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "support/paths.h"

namespace calotype::test {
namespace {

/// What a shell command prints; the test fails where the command does.
std::string outputOf(const std::string& command) {
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe)
        throw std::runtime_error("cannot run " + command);
    std::string output;
    std::array<char, 4096> buffer;
    while (const size_t count = fread(buffer.data(), 1, buffer.size(), pipe))
        output.append(buffer.data(), count);
    EXPECT_EQ(pclose(pipe), 0) << command;
    return output;
}

// GCC 12 drops a function that does nothing but prefetch, unless it is inlined: pack/gpu_scene.cpp
// forces that. Without its prefetches, packing waits for memory half of its time.
TEST(CompilerWorkaroundsTest, PackingKeepsItsPrefetches) {
    const std::string count = outputOf(std::string("objdump -d --no-show-raw-insn '") + kProgram +
                                       "' | grep -cE '\\b(prefetch|prfm)'");
    EXPECT_GE(std::stoi(count), 2) << "primitives and triangles";
}

} // namespace
} // namespace calotype::test
