// Sobol's points give the picture that independent numbers give, with less noise.
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

class SamplerTest : public GpuTest {
protected:
    /// Pictures of 16 samples from random numbers that are independent of each other: a block of
    /// each replica, which is scrambled on its own, from one kernel for each seed.
    static std::vector<Image> pictures(const Scene& scene, Sampler sampler, uint32_t count) {
        std::vector<Image> images;
        for (uint32_t seed = 100; images.size() < count; ++seed) {
            RenderSettings settings = squareSettings(scene, 48, seed);
            settings.maxBounces = 3;
            settings.sampler = sampler;
            settings.samplesPerPixel = shared::kSamplesPerBlock;
            DeviceTracer device(scene, settings);
            for (uint32_t block = 0; block < shared::kReplicas; ++block) {
                settings.firstSample = block * shared::kSamplesPerBlock;
                RenderSession session(device.tracer(), settings, device.packed().maxRadiance);
                session.run({});
                images.push_back(session.picture());
            }
        }
        return images;
    }

    static double greyOf(const glm::dvec3& color) { return (color.x + color.y + color.z) / 3.0; }

    /// Mean over the pixels of the variance between pictures.
    static double varianceOf(const std::vector<Image>& images) {
        const auto n = static_cast<double>(images.size());
        double sum = 0.0;
        for (size_t i = 0; i < images[0].pixels.size(); ++i) {
            double mean = 0.0;
            double square = 0.0;
            for (const Image& image : images) {
                const double value = greyOf(glm::dvec3(image.pixels[i]));
                mean += value / n;
                square += value * value / n;
            }
            sum += (square - mean * mean) * n / (n - 1.0);
        }
        return sum / static_cast<double>(images[0].pixels.size());
    }

    struct Mean {
        double value;
        double standardError;
    };

    /// Of whole pictures, over seeds.
    static Mean meanOf(const std::vector<Image>& images) {
        const auto n = static_cast<double>(images.size());
        double mean = 0.0;
        double square = 0.0;
        for (const Image& image : images) {
            const double value = greyOf(imageMean(image));
            mean += value / n;
            square += value * value / n;
        }
        return {mean, std::sqrt((square - mean * mean) / (n - 1.0))};
    }
};

TEST_F(SamplerTest, SobolHasTheSameMeanAndLessNoise) {
    for (const char* path : {"scenes/cornell-box.json", "scenes/sphere.json", "scenes/mesh.json"}) {
        SCOPED_TRACE(path);
        const Scene scene = projectScene(path);
        const auto independent = pictures(scene, Sampler::Independent, 16);
        const auto sobol = pictures(scene, Sampler::Sobol, 16);
        const Mean a = meanOf(independent);
        const Mean b = meanOf(sobol);
        EXPECT_GT(a.value, 0.01);
        // Student's t of 15 degrees of freedom, which Welch's are at least, leaves 5 once in 6000.
        EXPECT_NEAR(a.value, b.value, 5.0 * std::hypot(a.standardError, b.standardError));
        const double ratio = varianceOf(sobol) / varianceOf(independent);
        RecordProperty(path, std::to_string(ratio));
        EXPECT_LT(ratio, 0.4); // 0.07, 0.25 and 0.22 were seen
    }
}

// Indices are absolute: where passes end, the points do not begin anew.
TEST_F(SamplerTest, PassesDoNotMatter) {
    const Scene scene = projectScene("scenes/cornell-box.json");
    RenderWish wish;
    wish.width = 40;
    wish.height = 32;
    wish.samplesPerPixel = 40;
    wish.sampler = Sampler::Sobol;
    const Image whole = renderScene(scene, wish).image;
    wish.passSamples = 3;
    const Image inPasses = renderScene(scene, wish).image;
    EXPECT_EQ(whole.pixels, inPasses.pixels);
}

} // namespace
} // namespace calotype::test
