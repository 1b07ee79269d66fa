// The library's facade with files: they hold what the pixels in memory do.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "engine/render_job.h"
#include "engine/renderer.h"
#include "image/read_image.h"
#include "settings/limits.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"
#include "support/scratch_folder.h"

namespace calotype::test {
namespace {

class RenderJobTest : public testing::Test {
protected:
    DeviceOptions device_ = [] {
        DeviceOptions options;
        options.validates = true;
        return options;
    }();
    ScratchFolder folder_;
};

RenderJob smallJob(const Renderer& renderer) {
    RenderJob job;
    job.settings = renderer.defaultSettings();
    job.settings.width = job.settings.height = 16;
    job.settings.crop = {0, 0, 16, 16};
    job.settings.samplesPerPixel = 32;
    return job;
}

std::vector<float> floatsIn(const std::filesystem::path& path) {
    std::vector<float> floats;
    for (const glm::vec3& pixel : readImage(path).pixels)
        floats.insert(floats.end(), {pixel.r, pixel.g, pixel.b});
    return floats;
}

TEST_F(RenderJobTest, WritesThePixelsItReturns) {
    Renderer renderer(projectScene("scenes/cornell-box.json"), device_);
    RenderJob job = smallJob(renderer);
    job.output.pictures = {folder_ / "box.exr"};
    job.output.statsFile = folder_ / "box.json";
    const RenderResult result = renderer.render(job);
    EXPECT_EQ(result.pixels.size(), 3u * 16 * 16);
    EXPECT_EQ(floatsIn(folder_ / "box.exr"), result.pixels);
    EXPECT_EQ(renderer.render(job.settings).pixels, result.pixels);
    EXPECT_NE(readBytes(folder_ / "box.json").find("\"spp\": 32"), std::string::npos);
}

TEST_F(RenderJobTest, GoesOnWithAFilm) {
    Renderer renderer(projectScene("scenes/cornell-box.json"), device_);
    RenderJob job = smallJob(renderer);
    job.settings.bvh = BvhBuilder::Sah;
    const RenderResult whole = renderer.render(job.settings);
    job.settings.samplesPerPixel = 16;
    job.film.film = folder_ / "box.film";
    job.returnsPixels = false;
    EXPECT_TRUE(renderer.render(job).pixels.empty());
    job.film = {};
    job.film.resume = folder_ / "box.film";
    job.settings.samplesPerPixel = 32;
    job.returnsPixels = true;
    const RenderResult second = renderer.render(job);
    EXPECT_EQ(second.plan.samplesBefore, 16u);
    EXPECT_EQ(second.totals.paths, 16u * 16 * 16);
    EXPECT_EQ(second.pixels, whole.pixels);
    // The film holds all samples: the picture is made of them.
    job.film = {};
    job.film.film = folder_ / "box.film";
    const RenderResult third = renderer.render(job);
    EXPECT_EQ(third.totals.paths, 0u);
    EXPECT_EQ(third.pixels, whole.pixels);
}

TEST_F(RenderJobTest, WarnsWhereItArisesAndInTheResult) {
    Renderer renderer(projectScene("scenes/cornell-box.json"), device_);
    RenderJob job = smallJob(renderer);
    job.output.previewInterval.samples = job.settings.samplesPerPixel;
    job.output.previewFile = folder_ / "none/preview.png";
    std::vector<std::string> warnings;
    std::vector<uint64_t> samples;
    RenderCallbacks callbacks;
    callbacks.onWarning = [&](const std::string& warning) { warnings.push_back(warning); };
    callbacks.onSamples = [&](const RenderPlan& plan, const RenderTotals& totals) {
        EXPECT_EQ(plan.samplesPerPixel, 32u);
        samples.push_back(totals.samplesPerPixel);
    };
    const RenderResult result = renderer.render(job, callbacks);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("none/preview.png"), std::string::npos) << warnings[0];
    EXPECT_EQ(result.warnings, warnings);
    ASSERT_GE(samples.size(), 2u);
    EXPECT_EQ(samples.front(), 0u);
    EXPECT_TRUE(std::ranges::is_sorted(samples));
}

// Whether there are files or not, a goal that cannot be reached is refused.
TEST_F(RenderJobTest, RefusesAnErrorToReachWithoutLight) {
    SceneBuilder builder;
    builder.rectangle({-9, -9, -1}, {18, 0, 0}, {0, 18, 0}, builder.material(0.5, 0.0));
    Renderer renderer(builder.scene(), device_);
    RenderJob job = smallJob(renderer);
    job.settings.targetError = 0.1;
    job.output.pictures = {folder_ / "dark.exr"};
    EXPECT_THROW(renderer.render(job), SettingError);
    EXPECT_THROW(renderer.render(job.settings), SettingError);
}

TEST_F(RenderJobTest, RefusesFilesThatDoNotGoTogether) {
    Renderer renderer(projectScene("scenes/cornell-box.json"), device_);
    RenderJob job = smallJob(renderer);
    job.settings.isAdaptive = true;
    job.film.film = folder_ / "box.film";
    EXPECT_THROW(renderer.render(job), UsageError);
    job.film = {};
    job.film.resume = folder_ / "box.film";
    EXPECT_THROW(renderer.render(job), UsageError);
    job = smallJob(renderer);
    job.output.previewInterval.samples = 16;
    EXPECT_THROW(renderer.render(job), UsageError);
    job.output.previewInterval = {0, 1.0};
    EXPECT_THROW(renderer.render(job), UsageError);
    EXPECT_EQ(folder_.entries(), 0u);
}

// A time that is as long as can be asked for is not over at once.
TEST_F(RenderJobTest, RendersForAsLongAsItMay) {
    Renderer renderer(projectScene("scenes/cornell-box.json"), device_);
    RenderSettings settings = smallJob(renderer).settings;
    settings.seconds = kMostSeconds;
    EXPECT_EQ(renderer.render(settings).ending, RenderEnding::AllSamples);
}

} // namespace
} // namespace calotype::test
