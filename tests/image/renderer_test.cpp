// The library's facade: the picture is the program's, and what is wrong is thrown.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "engine/renderer.h"
#include "settings/limits.h"
#include "support/gpu_test.h"
#include "support/paths.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"
#include "support/scratch_folder.h"

namespace calotype::test {
namespace {

constexpr double kRadiance = 2.5;

/// All that the camera sees is a light.
Scene brightWall() {
    SceneBuilder builder;
    builder.rectangle({-9, -9, -1}, {18, 0, 0}, {0, 18, 0}, builder.material(0.0, kRadiance));
    return builder.scene();
}

class RendererTest : public testing::Test {
protected:
    DeviceOptions device_ = [] {
        DeviceOptions options;
        options.validates = true;
        return options;
    }();
};

TEST_F(RendererTest, ReadsPixelsOfASceneMadeInMemory) {
    Renderer renderer(brightWall(), device_);
    RenderSettings settings = renderer.defaultSettings();
    EXPECT_EQ(settings.width, 16u);
    settings.crop = {2, 3, 8, 4};
    settings.samplesPerPixel = 4;
    std::vector<double> shares;
    RenderCallbacks callbacks;
    callbacks.onProgress = [&](const std::string& what, double done) {
        if (what == "rendering")
            shares.push_back(done);
    };
    const RenderResult result = renderer.render(settings, callbacks);
    EXPECT_EQ(result.width, 8u);
    EXPECT_EQ(result.height, 4u);
    EXPECT_EQ(result.ending, RenderEnding::AllSamples);
    EXPECT_EQ(result.totals.samplesPerPixel, 4u);
    EXPECT_EQ(result.pixels, std::vector<float>(3 * 8 * 4, static_cast<float>(kRadiance)));
    ASSERT_FALSE(shares.empty());
    EXPECT_EQ(shares.back(), 1.0);
}

TEST_F(RendererTest, RendersTheWholePictureInAnySize) {
    Renderer renderer(brightWall(), device_);
    RenderSettings settings = renderer.defaultSettings();
    settings.width = 40;
    settings.height = 24;
    settings.samplesPerPixel = 1;
    const RenderResult result = renderer.render(settings);
    EXPECT_EQ(result.width, 40u);
    EXPECT_EQ(result.height, 24u);
    EXPECT_EQ(result.pixels.size(), 3u * 40u * 24u);
}

// Rows run from the top, and the samples are those of the sessions below.
TEST_F(RendererTest, GivesThePictureOfASession) {
    const Scene scene = projectScene("scenes/cornell-box.json");
    RenderWish wish;
    wish.width = wish.height = 32;
    wish.samplesPerPixel = 32;
    wish.sampler = Sampler::Sobol;
    const RenderedScene rendered = renderScene(scene, wish);
    Renderer renderer(scene, device_);
    RenderSettings settings = renderer.defaultSettings();
    settings.width = settings.height = 32;
    settings.crop = {0, 0, 32, 32};
    settings.samplesPerPixel = 32;
    settings.bvh = BvhBuilder::Sah;
    const RenderResult result = renderer.render(settings);
    ASSERT_EQ(result.pixels.size(), 3u * 32 * 32);
    for (size_t i = 0; i < rendered.image.pixels.size(); ++i) {
        ASSERT_EQ(result.pixels[3 * i], rendered.image.pixels[i].r) << i;
        ASSERT_EQ(result.pixels[3 * i + 1], rendered.image.pixels[i].g) << i;
        ASSERT_EQ(result.pixels[3 * i + 2], rendered.image.pixels[i].b) << i;
    }
    ASSERT_TRUE(result.totals.error);
    EXPECT_GT(result.totals.error->relative, 0.0);
}

/// The camera sees an enlarged image of 2 x 2 texels.
Scene enlargedTexels() {
    SceneBuilder builder;
    const TexelImage image{2,  2,    {0, 0, 0, 255, 255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255},
                           {}, true, false};
    Material material;
    material.color = glm::dvec3(1.0);
    material.colorTexture =
        builder.texture({"texels", ImageTexture{std::make_shared<const TexelImage>(image)}});
    builder.rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.material(material));
    builder.lookAtPlaneZ(2.0);
    builder.scene().background = glm::dvec3(1.0);
    builder.scene().render.maxBounces = 1;
    return builder.scene();
}

// The setting gives the picture of a scene whose textures say so, and leaves the scene alone.
TEST_F(RendererTest, FiltersTexturesAsTheSettingSays) {
    Scene nearest = enlargedTexels();
    std::get<ImageTexture>(nearest.textures[0].source).filter = TextureFilter::Nearest;
    DeviceOptions reference;
    reference.device = "reference";
    for (const DeviceOptions& device : {device_, reference}) {
        SCOPED_TRACE(device.device);
        Renderer renderer(enlargedTexels(), device);
        RenderSettings settings = renderer.defaultSettings();
        const std::vector<float> bilinear = renderer.render(settings).pixels;
        settings.textureFilter = TextureFilter::Nearest;
        RenderCallbacks callbacks;
        callbacks.onSamples = [&](const RenderPlan&, const RenderTotals&) {
            EXPECT_EQ(std::get<ImageTexture>(renderer.scene().textures[0].source).filter,
                      TextureFilter::Bilinear);
        };
        const std::vector<float> pixels = renderer.render(settings, callbacks).pixels;
        EXPECT_NE(pixels, bilinear);
        Renderer other(nearest, device);
        EXPECT_EQ(other.render(other.defaultSettings()).pixels, pixels);
    }
}

struct Mistake {
    std::string message; ///< a part of it
    std::function<void(Scene&)> make;
};

Mesh& firstMesh(Scene& scene) {
    for (Shape& shape : scene.shapes)
        if (auto* mesh = std::get_if<Mesh>(&shape.geometry))
            return *mesh;
    throw std::logic_error("the scene has no mesh");
}

// A scene that was correct when it was loaded may have been changed.
TEST_F(RendererTest, ChecksWhateverCanHaveBeenChanged) {
    const std::vector<Mistake> mistakes = {
        {"uses material 99", [](Scene& s) { firstMesh(s).triangles[0].material = 99; }},
        {"uses material 99",
         [](Scene& s) {
             s.shapes.push_back({Sphere{}, 99, ""});
         }},
        {"names texture 7", [](Scene& s) { s.materials[0].colorTexture = 7; }},
        {"has no triangles", [](Scene& s) { firstMesh(s).triangles.clear(); }},
        {"a vertex that does not exist",
         [](Scene& s) { firstMesh(s).triangles[0].position[1] = 1u << 20; }},
        {"has a position that is not finite", [](Scene& s) { firstMesh(s).positions[0].y = NAN; }},
    };
    const Scene loaded = loadScene(std::string(kProjectFolder) + "/scenes/cornell-box.json");
    EXPECT_NE(loaded.hash, 0u);
    for (Scene scene : {loaded, brightWall()})
        for (const Mistake& mistake : mistakes) {
            Scene wrong = scene;
            mistake.make(wrong);
            try {
                const Renderer renderer(std::move(wrong), device_);
                ADD_FAILURE() << mistake.message;
            } catch (const SceneError& error) {
                EXPECT_NE(std::string(error.what()).find(mistake.message), std::string::npos)
                    << error.what();
            }
        }
}

TEST_F(RendererTest, WarnsOnceOfWhatIsNotWrong) {
    const auto load = [] {
        LoadOptions options;
        options.overrides = {{"/lights", "[]"}};
        return loadScene(std::string(kProjectFolder) + "/scenes/cornell-box.json", options);
    };
    const std::vector<std::string> warnings = load()->warnings;
    ASSERT_EQ(warnings.size(), 1u); // that nothing emits light
    EXPECT_EQ(Renderer(load()).scene().warnings, warnings);
    Scene scene = load();
    EXPECT_EQ(Renderer(scene).scene().warnings, warnings);
    scene.warnings.clear();
    EXPECT_EQ(Renderer(scene).scene().warnings, warnings);
}

TEST_F(RendererTest, RendersByTheReferenceTracerToo) {
    DeviceOptions options;
    options.device = "reference";
    Renderer renderer(brightWall(), options);
    const RenderResult result = renderer.render(renderer.defaultSettings());
    EXPECT_EQ(result.pixels, std::vector<float>(3 * 16 * 16, static_cast<float>(kRadiance)));
}

/// Sets an environment variable for one test.
class ScopedVariable {
public:
    ScopedVariable(std::string name, const std::string& value) : name_(std::move(name)) {
        if (const char* former = std::getenv(name_.c_str()))
            former_ = former;
        setenv(name_.c_str(), value.c_str(), 1);
    }
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;
    ~ScopedVariable() {
        if (former_)
            setenv(name_.c_str(), former_->c_str(), 1);
        else
            unsetenv(name_.c_str());
    }

private:
    std::string name_;
    std::optional<std::string> former_;
};

TEST_F(RendererTest, StoresKernelsInTheFolderThatIsGiven) {
    const ScratchFolder usual;
    const ScratchFolder folder;
    const ScopedVariable cache("XDG_CACHE_HOME", usual.path());
    device_.cacheFolder = folder / "made/kernels";
    Renderer renderer(brightWall(), device_);
    renderer.render(renderer.defaultSettings());
    const std::filesystem::directory_iterator files(device_.cacheFolder);
    EXPECT_EQ(std::distance(files, {}), 1);
    EXPECT_FALSE(std::filesystem::exists(usual / "calotype"));
    device_.cacheFolder.clear();
    renderer = Renderer(brightWall(), device_);
    renderer.render(renderer.defaultSettings());
    EXPECT_TRUE(std::filesystem::exists(usual / "calotype"));
}

// A kernel that is compiled is also stored on disk, so a folder that was removed shows it.
TEST_F(RendererTest, KeepsItsDeviceUntilItFails) {
    const ScratchFolder folder;
    device_.cacheFolder = folder / "kernels";
    Renderer renderer(brightWall(), device_);
    const RenderSettings settings = renderer.defaultSettings();
    const auto compiles = [&] {
        std::filesystem::remove_all(device_.cacheFolder);
        const std::vector<float> pixels = renderer.render(settings).pixels;
        EXPECT_EQ(pixels, std::vector<float>(3 * 16 * 16, static_cast<float>(kRadiance)));
        return std::filesystem::exists(device_.cacheFolder);
    };
    EXPECT_TRUE(compiles());
    EXPECT_FALSE(compiles());
    RenderCallbacks callbacks;
    callbacks.onProgress = [](const std::string&, double) { throw GpuError("the device is lost"); };
    EXPECT_THROW(renderer.render(settings, callbacks), GpuError);
    EXPECT_TRUE(compiles());
}

TEST_F(RendererTest, StopsWhenItIsTold) {
    Renderer renderer(brightWall(), device_);
    RenderSettings settings = renderer.defaultSettings();
    settings.samplesPerPixel = 1u << 20;
    bool hasRendered = false;
    RenderCallbacks callbacks;
    callbacks.onProgress = [&](const std::string& what, double) {
        hasRendered = hasRendered || what == "rendering";
    };
    callbacks.shouldStop = [&] { return hasRendered; };
    const RenderResult result = renderer.render(settings, callbacks);
    EXPECT_EQ(result.ending, RenderEnding::Stopped);
    EXPECT_LT(result.totals.samplesPerPixel, settings.samplesPerPixel);
    callbacks.shouldStop = [] { return true; };
    EXPECT_THROW(renderer.render(settings, callbacks), Interrupted);
}

TEST_F(RendererTest, ThrowsForSettingsThatMakeNoSense) {
    Renderer renderer(brightWall(), device_);
    const auto expectError = [&](const std::string& setting, auto change) {
        RenderSettings settings = renderer.defaultSettings();
        change(settings);
        try {
            renderer.render(settings);
            ADD_FAILURE() << setting;
        } catch (const SettingError& error) {
            EXPECT_EQ(error.setting(), setting);
        }
    };
    expectError("size", [](RenderSettings& s) { s.width = 0; });
    expectError("crop", [](RenderSettings& s) { s.crop = {0, 0, 17, 1}; }); // 16 pixels wide
    expectError("crop", [](RenderSettings& s) { s.crop = {0, 0, 0, 8}; });
    expectError("crop", [](RenderSettings& s) { s.crop = {5, 3, 0, 0}; });
    expectError("spp", [](RenderSettings& s) { s.samplesPerPixel = 0; });
    expectError("samples", [](RenderSettings& s) { s.firstSample = 8; });
    expectError("spp", [](RenderSettings& s) { s.samplesPerPixel = kMostSamplesPerPixel + 1; });
    expectError("spp", [](RenderSettings& s) { s.samplesPerPixel = ~0u; });
    expectError("samples", [](RenderSettings& s) { s.firstSample = kMostSamplesPerPixel; });
    expectError("adaptive", [](RenderSettings& s) {
        s.isAdaptive = true;
        s.firstSample = 16;
    });
    expectError("max_bounces", [](RenderSettings& s) { s.maxBounces = 1u << 21; });
    expectError("clamp_indirect", [](RenderSettings& s) { s.transport.indirectClamp = 0.0f; });
    expectError("target_error", [](RenderSettings& s) { s.targetError = 1.5; });
    for (const double seconds : {-1.0, 0.0, 1.1e9, 1e300, double(INFINITY), double(NAN)})
        expectError("time", [&](RenderSettings& s) { s.seconds = seconds; });
    expectError("light_choice",
                [](RenderSettings& s) { s.transport.lightChoice = LightChoice::All; });
    DeviceOptions unknown;
    unknown.device = "voodoo";
    Renderer nowhere(brightWall(), unknown);
    EXPECT_THROW(nowhere.render(nowhere.defaultSettings()), GpuError);
}

} // namespace
} // namespace calotype::test
