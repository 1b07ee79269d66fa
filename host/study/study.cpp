#include "study/study.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/stopwatch.h"
#include "render/adaptive_session.h"
#include "render/render_session.h"

namespace calotype {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kReferenceShare = 0.4;
/// Samples that a reference should get, where the size of the picture is free.
constexpr double kReferenceSamples = 4096.0;
constexpr double kLeastPixels = 48.0 * 48.0;
constexpr uint32_t kLargestPart = 256; ///< pixels on a side
/// A change is for the better where it takes less than so much of the time to the same error.
constexpr double kBetter = 0.9;

double pixelsOf(const StudySettings& settings) {
    return static_cast<double>(settings.render.width) * settings.render.height;
}

std::unique_ptr<Session> makeSession(const PreparedTracer& prepared,
                                     const StudySettings& settings) {
    if (settings.adapts)
        return std::make_unique<AdaptiveSession>(*prepared.tracer, settings.render,
                                                 prepared.maxRadiance);
    return std::make_unique<RenderSession>(*prepared.tracer, settings.render, prepared.maxRadiance);
}

class StudyRun {
public:
    StudyRun(const StudyPlan& plan, const PrepareTracer& prepare, const StudyObserver& observer)
        : plan_(plan), prepare_(prepare), observer_(observer) {
        study_.usual = plan.usual;
        study_.usual.render.samplesPerPixel = RenderDefaults::kMostSamplesPerPixel;
    }

    Study run() {
        if (!plan_.keepsSize)
            chooseSize();
        renderReference();
        if (!isStopped_)
            sweep();
        study_.isWhole = !isStopped_;
        return std::move(study_);
    }

private:
    double secondsLeft() const { return plan_.seconds - secondsSince(start_); }

    /// Samples for so long. False where the user stopped it.
    bool sample(Session& session, double seconds, const std::string& what,
                const std::function<void()>& onPass) {
        RenderObserver observer;
        observer.shouldStop = [&] {
            isStopped_ = observer_.shouldStop();
            observer_.onProgress(what);
            return isStopped_ || session.totals().seconds >= seconds;
        };
        observer.onPass = [&](const RenderTotals&) { onPass(); };
        session.run(observer);
        return !isStopped_;
    }

    /// Makes the picture so small that the reference becomes a good one.
    void chooseSize() {
        StudySettings small = study_.usual;
        const double whole = pixelsOf(small);
        resize(small, std::min(whole, kLeastPixels));
        const PreparedTracer prepared = prepare_(small);
        const auto session = makeSession(prepared, small);
        if (!sample(*session, 0.02 * plan_.seconds, "measuring the speed", [] {}))
            return;
        const double rate =
            static_cast<double>(session->totals().paths) / session->totals().seconds;
        const double pixels = rate * kReferenceShare * plan_.seconds / kReferenceSamples;
        resize(study_.usual, std::clamp(pixels, std::min(whole, kLeastPixels), whole));
        study_.scale = whole / pixelsOf(study_.usual);
    }

    /// Keeps the shape.
    static void resize(StudySettings& settings, double pixels) {
        RenderSettings& render = settings.render;
        const double shrink = std::sqrt(pixels / pixelsOf(settings));
        const auto scaled = [&](uint32_t side) {
            return std::max(1u, static_cast<uint32_t>(std::lround(side * std::min(1.0, shrink))));
        };
        render.width = scaled(render.width);
        render.height = scaled(render.height);
        render.crop = {0, 0, render.width, render.height};
    }

    void renderReference() {
        StudySettings settings = study_.usual;
        settings.render.seed += 1; // so that it shares nothing with what it judges
        const PreparedTracer prepared = prepare_(settings);
        const auto session = makeSession(prepared, settings);
        const double seconds = kReferenceShare * secondsLeft();
        if (sample(*session, seconds, "rendering the reference", [] {}))
            study_.reference.emplace(*session);
        prepareSeconds_ = prepared.buildSeconds + prepared.compileSeconds;
    }

    void sweep() {
        if (study_.reference->mean <= 0.0)
            throw Error("the picture is black, so there is no error to study");
        if (!std::isfinite(study_.reference->error))
            throw Error("the budget is too short: the reference has " +
                        std::to_string(study_.reference->samples) +
                        " samples per pixel, and needs 32; give it more, or a smaller --size");
        const std::vector<Variant> variants = variantsOf(study_.usual, study_.reference->mean);
        const auto count = static_cast<double>(variants.size()) + 1.0; // and some together
        // As long for each, so that they can be compared.
        const double share = secondsLeft() / count;
        const double seconds = std::max(0.2 * share, share - prepareSeconds_);
        for (const Variant& variant : variants)
            if (!isStopped_)
                measure(variant, seconds);
        std::vector<Variant> better;
        for (const Measurement& measurement : study_.measurements)
            if (isForTheBetter(measurement))
                better.push_back(measurement.variant);
        if (!isStopped_ && better.size() > 1)
            measure(together(better), seconds);
    }

    bool isForTheBetter(const Measurement& measurement) const {
        const Measurement& usual = study_.measurements.front();
        if (measurement.variant.losesLight || measurement.variant.options.empty() ||
            !measurement.last().error || !usual.last().error)
            return false;
        const auto cost = [](const CurvePoint& point) {
            return point.seconds * *point.error * *point.error;
        };
        return cost(measurement.last()) < kBetter * cost(usual.last());
    }

    /// What is not whole does not count.
    void measure(const Variant& variant, double seconds) {
        const StudySettings settings = variant.settings(study_.usual);
        const PreparedTracer prepared = prepare_(settings);
        const auto session = makeSession(prepared, settings);
        Measurement measurement{variant, {}, prepared.buildSeconds, prepared.compileSeconds};
        const auto record = [&] {
            const Image picture = session->picture();
            const auto& estimate = session->error();
            measurement.curve.push_back(
                {session->totals().samplesPerPixel, session->totals().seconds,
                 study_.reference->errorOf(picture),
                 estimate ? std::optional(estimate->relative) : std::nullopt, middleOf(picture)});
        };
        uint64_t next = 1;
        const bool isWhole = sample(*session, seconds, variant.name, [&] {
            const uint64_t samples = session->totals().samplesPerPixel;
            if (samples < next)
                return;
            record();
            next = std::bit_ceil(samples + 1);
        });
        if (!isWhole)
            return;
        record();
        const MeanLuminance mean = meanLuminance(session->picture(), session->pixelErrors());
        measurement.brighter = mean.mean / study_.reference->mean - 1.0;
        measurement.brighterError =
            std::hypot(mean.standardError, study_.reference->meanError) / study_.reference->mean;
        measurement.isTrusted = session->error() && session->error()->isTrusted();
        study_.measurements.push_back(std::move(measurement));
    }

    const StudyPlan& plan_;
    const PrepareTracer& prepare_;
    const StudyObserver& observer_;
    const Clock::time_point start_ = Clock::now();
    bool isStopped_ = false;
    double prepareSeconds_ = 0.0;
    Study study_;
};

} // namespace

Image middleOf(const Image& image) {
    Image part(std::min(image.width, kLargestPart), std::min(image.height, kLargestPart));
    for (uint32_t y = 0; y < part.height; ++y)
        for (uint32_t x = 0; x < part.width; ++x)
            part.at(x, y) =
                image.at(x + (image.width - part.width) / 2, y + (image.height - part.height) / 2);
    return part;
}

Study runStudy(const StudyPlan& plan, const PrepareTracer& prepare, const StudyObserver& observer) {
    return StudyRun(plan, prepare, observer).run();
}

} // namespace calotype
