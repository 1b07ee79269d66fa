// A public collection of odd and broken OBJ files, where ../shared/data has it: each loads as a
// model or is refused with a sentence, in bounded time and memory.

#include <algorithm>
#include <filesystem>

#include "support/paths.h"
#include "unit/memory_use.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

TEST(ObjCorporaTest, EdgeCasesLoadOrAreRefused) {
    const fs::path root = fs::path(kProjectFolder) / "../shared/data/obj-edge-cases";
    if (!fs::exists(root))
        GTEST_SKIP() << "../shared/data is not there";
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (entry.path().extension() == ".obj")
            paths.push_back(entry.path());
    LoadOptions warn;
    warn.missingTextures = MissingTextures::Warn;
    size_t loaded = 0;
    for (const fs::path& path : paths) {
        SCOPED_TRACE(path.filename());
        const MemoryGauge memory;
        const double seconds = processorSeconds([&] {
            for (const LoadOptions& options : {LoadOptions(), warn}) {
                try {
                    const Scene scene = loadScene(path.string(), options);
                    EXPECT_FALSE(std::get<Mesh>(scene.shapes.at(0).geometry).triangles.empty());
                    ++loaded;
                } catch (const SceneError& error) {
                    EXPECT_FALSE(error.where().empty());
                }
            }
        });
        EXPECT_LT(seconds, 20.0); // a tenth of one by itself; more under sanitizers
        // One by itself, of files of up to 140 KB.
        EXPECT_LT(memory.peak(), (int64_t{64} << 20) + kSanitizerMemory);
    }
    EXPECT_GT(loaded, paths.size());
}

} // namespace
} // namespace calotype::test
