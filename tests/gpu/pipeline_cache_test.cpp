// Compiled kernels on disk.
#include <cstdlib>
#include <fstream>

#include "gpu/pipeline_cache.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"
#include "support/scratch_folder.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

/// A folder for the cache of this test alone.
class PipelineCacheTest : public GpuTest {
protected:
    PipelineCacheTest() {
        if (const char* folder = std::getenv("XDG_CACHE_HOME"))
            former_ = folder;
        setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
    }
    ~PipelineCacheTest() override {
        if (former_)
            setenv("XDG_CACHE_HOME", former_->c_str(), 1);
        else
            unsetenv("XDG_CACHE_HOME");
    }

    /// Opens a device, which reads the cache, and stores what it holds.
    static void openAndStore() {
        const Instance instance(true);
        const Device device(instance, std::to_string(testDevice().info().index));
        device.pipelineCache().store();
        EXPECT_TRUE(instance.validationMessages().empty());
    }

    std::vector<fs::path> files() const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / "calotype"))
            if (entry.is_regular_file())
                files.push_back(entry.path());
        return files;
    }

    ScratchFolder folder_;

private:
    std::optional<std::string> former_;
};

TEST_F(PipelineCacheTest, IsOneFileThatStaysAsItIs) {
    openAndStore();
    ASSERT_EQ(files().size(), 1u);
    const std::string first = readBytes(files()[0]);
    EXPECT_GE(first.size(), 8u + 32u); // a hash, and Vulkan's own header
    openAndStore();
    ASSERT_EQ(files().size(), 1u);
    EXPECT_EQ(readBytes(files()[0]), first);
}

TEST_F(PipelineCacheTest, DamagedFilesAreReplaced) {
    openAndStore();
    ASSERT_EQ(files().size(), 1u);
    const std::string whole = readBytes(files()[0]);
    std::string flipped = whole;
    flipped.back() = static_cast<char>(flipped.back() ^ 1);
    for (const std::string& damaged :
         {std::string(), whole.substr(0, 5), whole.substr(0, whole.size() - 1), flipped}) {
        writeBytes(files()[0], damaged);
        openAndStore();
        EXPECT_EQ(readBytes(files()[0]), whole);
    }
}

TEST_F(PipelineCacheTest, WithoutAFolderKernelsAreCompiledAllTheSame) {
    writeBytes(folder_ / "file", "");
    setenv("XDG_CACHE_HOME", (folder_ / "file").c_str(), 1);
    openAndStore();
    EXPECT_FALSE(fs::exists(folder_ / "calotype"));
}

} // namespace
} // namespace calotype::test
