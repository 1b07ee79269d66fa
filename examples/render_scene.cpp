// Renders a scene with progress, ends early on Ctrl-C, and prints the mean of the picture's pixels.
// usage: render_scene SCENE.json
#include <csignal>
#include <cstdio>
#include <exception>
#include <numeric>
#include <string>

#include <calotype/engine/renderer.h>

static volatile std::sig_atomic_t isStopped = 0;

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::fprintf(stderr, "usage: render_scene SCENE.json\n");
        return 2;
    }
    std::signal(SIGINT, [](int) { isStopped = 1; });
    calotype::Renderer renderer(calotype::loadScene(argv[1]));
    calotype::RenderSettings settings = renderer.defaultSettings();
    settings.samplesPerPixel = 32;
    calotype::RenderCallbacks callbacks;
    callbacks.onProgress = [](const std::string& what, double done) {
        std::fprintf(stderr, "%s: %.0f %%\n", what.c_str(), 100.0 * done);
    };
    callbacks.shouldStop = [] { return isStopped != 0; };
    const calotype::RenderResult result = renderer.render(settings, callbacks);

    const auto& pixels = result.pixels; // red, green, blue; row by row from the top left
    const double sum = std::accumulate(pixels.begin(), pixels.end(), 0.0);
    std::printf("%u x %u pixels, mean radiance %g W/(m^2 sr)\n", result.width, result.height,
                sum / static_cast<double>(pixels.size()));
    if (result.totals.error)
        std::printf("relative error %.1f %%\n", 100.0 * result.totals.error->relative);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
