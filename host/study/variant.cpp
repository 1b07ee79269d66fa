#include "study/variant.h"

#include <cstdlib>

#include "base/number_text.h"

namespace calotype {
namespace {

constexpr uint32_t kBouncesOfBasicPathTracing = 4;

Variant fewerBounces(uint32_t bounces) {
    return {std::to_string(bounces) + (bounces == 1 ? " bounce" : " bounces"),
            "--max-bounces " + std::to_string(bounces), true,
            [bounces](StudySettings& settings) { settings.render.maxBounces = bounces; }};
}

/// The radiance is rounded to two digits, so that users can type it.
Variant clampAt(double radiance) {
    const std::string text = shortNumber(radiance, 2);
    const float typed = std::strtof(text.c_str(), nullptr);
    return {"indirect light clamped at " + text, "--clamp-indirect " + text, true,
            [typed](StudySettings& settings) { settings.render.transport.indirectClamp = typed; }};
}

} // namespace

std::vector<Variant> variantsOf(const StudySettings& usual, double mean, bool isReference) {
    std::vector<Variant> variants = {
        {"the default", "", false, {}},
        {"adaptive sampling", "--adaptive", false,
         [](StudySettings& settings) { settings.adapts = true; }},
        {"independent samples", "--sampler independent", false,
         [](StudySettings& settings) { settings.render.sampler = Sampler::Independent; }},
        {"no Russian roulette", "--roulette off", false,
         [](StudySettings& settings) { settings.render.transport.usesRoulette = false; }},
        {"light sampling only", "--mis off", false,
         [](StudySettings& settings) { settings.render.transport.usesMis = false; }},
        {"lights chosen uniformly", "--light-choice uniform", false,
         [](StudySettings& settings) { settings.lightChoice = LightChoice::Uniform; }}};
    if (!isReference) {
        variants.push_back({"BVH by median splits", "--bvh median", false,
                            [](StudySettings& settings) { settings.bvh = BvhBuilder::Median; }});
        variants.push_back({"kernel with all features", "", false,
                            [](StudySettings& settings) { settings.compilesEverything = true; }});
    }
    const uint32_t bounces = usual.render.maxBounces;
    if (bounces >= 2)
        variants.push_back(fewerBounces(bounces / 2));
    if (bounces >= 4)
        variants.push_back(fewerBounces(bounces / 4));
    if (mean > 0.0) {
        variants.push_back(clampAt(10.0 * mean));
        variants.push_back(clampAt(mean));
    }
    variants.push_back({"basic path tracing",
                        "--sampler independent --roulette off --mis off --max-bounces " +
                            std::to_string(std::min(bounces, kBouncesOfBasicPathTracing)),
                        bounces > kBouncesOfBasicPathTracing,
                        [](StudySettings& settings) {
                            RenderSettings& render = settings.render;
                            render.sampler = Sampler::Independent;
                            render.transport.usesRoulette = false;
                            render.transport.usesMis = false;
                            render.maxBounces =
                                std::min(render.maxBounces, kBouncesOfBasicPathTracing);
                        },
                        false});
    return variants;
}

Variant together(const std::vector<Variant>& variants) {
    Variant all{"all improvements together", "", false, [variants](StudySettings& settings) {
                    for (const Variant& variant : variants)
                        variant.change(settings);
                }};
    for (const Variant& variant : variants) {
        if (!variant.options.empty())
            all.options += (all.options.empty() ? "" : " ") + variant.options;
        all.losesLight = all.losesLight || variant.losesLight;
    }
    return all;
}

} // namespace calotype
