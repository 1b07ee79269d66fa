#include "cli/commands.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/names.h"
#include "base/number_text.h"
#include "base/output_failures.h"
#include "cli/check_outputs.h"
#include "cli/denoiser_library.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/interrupt_deadline.h"
#include "cli/picture_text.h"
#include "cli/progress.h"
#include "cli/read_scene.h"
#include "engine/film_label.h"
#include "engine/film_picture.h"
#include "engine/json_document.h"
#include "engine/noisy_picture.h"
#include "engine/stage_seconds.h"
#include "engine/statistics.h"
#include "film/error_estimate.h"
#include "film/write_picture.h"

namespace calotype {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNothingWritten = "interrupted; nothing was written";

PictureDenoiser loadDenoiser(const GivenSettings& given) {
    RenderSettings settings;
    settings.denoiser = DenoiserKind::Oidn;
    given.applyTo(settings);
    try {
        return PictureDenoiser(settings.denoiser, denoiserLibrary());
    } catch (const SettingError& error) { // the command needs no --denoise
        throw UsageError("calotype denoise " + error.problem());
    }
}

/// What the statistics say of the input.
struct DenoiserInput {
    std::optional<uint64_t> samplesPerPixel; ///< none: unknown
    std::optional<ErrorEstimate> error;      ///< of the samples
    const char* features = nullptr;          ///< "means" or "first hits"; null: none
};

const char* nameOf(const std::optional<DenoiserFeatures>& features) {
    return !features ? nullptr : features->areMeans ? "means" : "first hits";
}

/// As the file of the picture says; none if it does not.
std::optional<uint64_t> samplesOf(const Picture& picture) {
    const auto spp = std::ranges::find(picture.metadata, "spp", &Attribute::name);
    const auto* samples =
        spp == picture.metadata.end() ? nullptr : std::get_if<int32_t>(&spp->value);
    return samples && *samples > 0 ? std::optional<uint64_t>(*samples) : std::nullopt;
}

/// One `calotype denoise`.
class DenoiseRun {
public:
    explicit DenoiseRun(const DenoiseOptions& options)
        : options_(options), progress_(options.quiet ? ProgressStyle::Quiet : ProgressStyle::Text) {
    }

    int run() {
        const OutputClaims claims = checkOutputs(options_);
        std::optional<InterruptDeadline> deadline(kNothingWritten);
        const PictureDenoiser denoiser = loadDenoiser(options_.settings);
        const Picture picture = isFilm(options_.input) ? ofFilm(denoiser) : ofPicture(denoiser);
        progress_.clear();
        throwIfInterrupted(kNothingWritten);
        deadline.reset();
        const DisplayTransform display = withExposureOf(picture.color, options_.display);
        write(picture, display);
        if (!options_.quiet)
            printSummary(display);
        return kExitDone;
    }

private:
    Picture ofFilm(const PictureDenoiser& denoiser) {
        const std::string& path = options_.input;
        const KeptFilm kept = timed(seconds_.load, [&] { return readLabelledFilm(path); });
        warn(featureWarning(path, kept));
        const auto onProgress = [&](double done) {
            throwIfInterrupted(kNothingWritten);
            progress_.step("denoising", done);
        };
        clean_ = timed(seconds_.denoise, [&] {
            return denoiseFilm(denoiser, path, kept, options_.threads, onProgress);
        });
        input_ = {kept.film.samplesPerPixel(), estimateError(kept.film), nameOf(kept.features)};
        return pictureOf(kept, {}, clean_);
    }

    Picture ofPicture(const PictureDenoiser& denoiser) {
        NoisyPicture noisy = timed(seconds_.load, [&] { return readNoisyPicture(options_.input); });
        if (denoiser.needsReplicas())
            throw UsageError("--denoise statistical is for films: an EXR file has no replicas of "
                             "the samples; use oidn");
        warn(noisy.warning);
        clean_ = timed(seconds_.denoise, [&] {
            return denoiser.run(noisy.picture.color, noisy.features, options_.threads);
        });
        clean_.whyUnstated = "an EXR file has no replicas of the samples, and a film has";
        input_ = {samplesOf(noisy.picture), {}, nameOf(noisy.features)};
        return pictureOf(std::move(noisy), clean_);
    }

    /// If it is not empty.
    void warn(const std::string& warning) {
        progress_.clear();
        if (!warning.empty())
            printWarning(warning);
    }

    void write(const Picture& picture, const DisplayTransform& display) {
        OutputFailures failures;
        timed(seconds_.write, [&] {
            for (const std::string& path : options_.outputs)
                failures.attempt([&] { writePicture(path, picture, display); });
            return 0;
        });
        if (!options_.statsFile.empty())
            failures.attempt(
                [&] { writeFileAtomically(options_.statsFile, statisticsOf(picture.color)); });
        failures.throwIfAny();
    }

    void printSummary(const DisplayTransform& display) const {
        std::fprintf(stderr, "%s: denoised by %s in %s, %s\n", listed(options_.outputs).c_str(),
                     clean_.denoiser.c_str(), durationText(seconds_.denoise).c_str(),
                     errorText(clean_).c_str());
        printExposure(options_.outputs, chosenExposure(options_.display, display));
    }

    std::string statisticsOf(const Image& image) const {
        Json json = newJsonDocument();
        json["input"] = options_.input;
        json["resolution"] = {image.width, image.height};
        json["spp"] = input_.samplesPerPixel ? Json(*input_.samplesPerPixel) : Json();
        json["error"] = describeError(input_.error);
        json["denoiser"] = clean_.denoiser;
        json["denoiser_features"] = input_.features ? Json(input_.features) : Json();
        describeDenoisedError(clean_.error, json);
        json["why_unstated"] = clean_.error ? Json() : Json(clean_.whyUnstated);
        json["seconds"] = {
            {"load", seconds_.load}, {"denoise", seconds_.denoise}, {"write", seconds_.write}};
        json["peak_memory_bytes"] = peakMemoryBytes();
        return jsonText(json);
    }

    const DenoiseOptions& options_;
    Progress progress_;
    StageSeconds seconds_;
    DenoiserInput input_;
    CleanPicture clean_;
};

} // namespace

int denoiseCommand(const DenoiseOptions& options) {
    catchInterrupts();
    return DenoiseRun(options).run();
}

} // namespace calotype
