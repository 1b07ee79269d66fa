#include "study/variant.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "base/number_text.h"
#include "settings/settings_table.h"

namespace calotype {
namespace {

constexpr uint32_t kBouncesOfBasicPathTracing = 4;

Variant fewerBounces(uint32_t bounces) {
    return {std::to_string(bounces) + (bounces == 1 ? " bounce" : " bounces"), "", true,
            [bounces](RenderSettings& settings) { settings.maxBounces = bounces; }};
}

/// The radiance is rounded to two digits, so that users can type it.
Variant clampAt(double radiance) {
    const std::string text = shortNumber(radiance, 2);
    const float typed = std::strtof(text.c_str(), nullptr);
    return {"indirect light clamped at " + text, "", true,
            [typed](RenderSettings& settings) { settings.transport.indirectClamp = typed; }};
}

Variant basicPathTracing(const RenderSettings& usual) {
    return {"basic path tracing", "", usual.maxBounces > kBouncesOfBasicPathTracing,
            [](RenderSettings& settings) {
                settings.sampler = Sampler::Independent;
                settings.transport.usesRoulette = false;
                settings.transport.usesMis = false;
                settings.maxBounces = std::min(settings.maxBounces, kBouncesOfBasicPathTracing);
            },
            false};
}

} // namespace

std::vector<Variant> variantsOf(const RenderSettings& usual, double mean, bool isReference) {
    std::vector<Variant> variants = {
        {"the default", "", false, {}},
        {"adaptive sampling", "", false,
         [](RenderSettings& settings) { settings.isAdaptive = true; }},
        {"independent samples", "", false,
         [](RenderSettings& settings) { settings.sampler = Sampler::Independent; }},
        {"no Russian roulette", "", false,
         [](RenderSettings& settings) { settings.transport.usesRoulette = false; }},
        {"light sampling only", "", false,
         [](RenderSettings& settings) { settings.transport.usesMis = false; }},
        {"lights chosen uniformly", "", false,
         [](RenderSettings& settings) { settings.transport.lightChoice = LightChoice::Uniform; }}};
    if (usual.transport.lightChoice != LightChoice::Power)
        variants.push_back({"lights chosen by power", "", false, [](RenderSettings& settings) {
                                settings.transport.lightChoice = LightChoice::Power;
                            }});
    if (!isReference) {
        variants.push_back({"BVH by median splits", "", false,
                            [](RenderSettings& settings) { settings.bvh = BvhBuilder::Median; }});
        variants.push_back({"kernel with all features", "", false,
                            [](RenderSettings& settings) { settings.compilesEverything = true; }});
    }
    const uint32_t bounces = usual.maxBounces;
    if (bounces >= 2)
        variants.push_back(fewerBounces(bounces / 2));
    if (bounces >= 4)
        variants.push_back(fewerBounces(bounces / 4));
    if (mean > 0.0) {
        variants.push_back(clampAt(10.0 * mean));
        variants.push_back(clampAt(mean));
    }
    variants.push_back(basicPathTracing(usual));
    for (Variant& variant : variants)
        variant.options = optionsBetween(usual, variant.settings(usual));
    return variants;
}

Variant denoisedVariant(const RenderSettings& usual, DenoiserKind denoiser) {
    Variant variant{std::string("denoised by ") + nameOf(denoiser),
                    "",
                    false,
                    [denoiser](RenderSettings& settings) { settings.denoiser = denoiser; },
                    false,
                    true};
    variant.options = optionsBetween(usual, variant.settings(usual));
    return variant;
}

Variant together(const RenderSettings& usual, const std::vector<Variant>& variants) {
    Variant all{"all improvements together", "", false, [variants](RenderSettings& settings) {
                    for (const Variant& variant : variants)
                        variant.change(settings);
                }};
    all.options = optionsBetween(usual, all.settings(usual));
    all.losesLight = std::ranges::any_of(variants, &Variant::losesLight);
    return all;
}

} // namespace calotype
