#include "study/study.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/stopwatch.h"
#include "engine/make_session.h"
#include "settings/limits.h"
#include "study/denoised_curve.h"

namespace calotype {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGroundTruthShare = 0.4;
/// Samples per pixel that the ground truth should get, if the size of the picture is free.
constexpr double kGroundTruthSamples = 4096.0;
constexpr double kLeastPixels = 48.0 * 48.0;
/// A variant is an improvement if it saves this share of the time to the same error.
constexpr double kBetter = 0.15;
/// Share of a variant's time that is used to measure the machine's pace.
constexpr double kYardstickShare = 0.15;
/// A variant samples for at least this part of its share of the time, however long its preparation.
constexpr double kLeastShare = 0.2;

double pixelsOf(const RenderSettings& settings) {
    return static_cast<double>(settings.width) * settings.height;
}

std::unique_ptr<Session> makeSession(const PreparedTracer& prepared,
                                     const RenderSettings& settings) {
    return calotype::makeSession(*prepared.tracer, settings, prepared.maxRadiance);
}

class StudyRun {
public:
    StudyRun(const StudyPlan& plan, const PrepareTracer& prepare, const StudyObserver& observer)
        : plan_(plan), prepare_(prepare), observer_(observer) {
        study_.usual = plan.usual;
        study_.usual.denoiser = DenoiserKind::Off;
        study_.needsDenoiseOff = plan.usual.denoiser != DenoiserKind::Off;
        study_.omitted = plan.omitted;
        study_.usual.samplesPerPixel = kMostSamplesPerPixel;
    }

    Study run() {
        try {
            if (!plan_.keepsSize)
                chooseSize();
            if (!isStopped_)
                renderGroundTruth();
            if (!isStopped_)
                sweep();
        } catch (const StudyStopped&) {
            isStopped_ = true;
        }
        study_.ending = isStopped_     ? StudyEnding::Stopped
                        : isOutOfTime_ ? StudyEnding::OutOfTime
                                       : StudyEnding::Whole;
        correctForPace();
        return std::move(study_);
    }

private:
    double secondsLeft() const { return plan_.seconds - secondsSince(start_); }

    /// Samples until `isOver`. False if the user stopped it.
    bool sample(Session& session, const std::function<bool()>& isOver, const std::string& what,
                const std::function<void()>& onPass) {
        RenderObserver observer;
        observer.shouldStop = [&] {
            isStopped_ = observer_.shouldStop();
            observer_.onProgress(what);
            return isStopped_ || isOver();
        };
        observer.onPass = [&](const RenderTotals&) { onPass(); };
        session.run(observer);
        return !isStopped_;
    }

    bool sample(Session& session, double seconds, const std::string& what,
                const std::function<void()>& onPass) {
        return sample(
            session, [&] { return session.totals().seconds >= seconds; }, what, onPass);
    }

    /// Chooses a picture so small that the ground truth gets kGroundTruthSamples.
    void chooseSize() {
        RenderSettings small = study_.usual;
        const double whole = pixelsOf(small);
        resize(small, std::min(whole, kLeastPixels));
        const PreparedTracer prepared = prepare_(small);
        const auto session = makeSession(prepared, small);
        if (!sample(*session, 0.02 * plan_.seconds, "measuring the speed", [] {}))
            return;
        const double rate =
            static_cast<double>(session->totals().paths) / session->totals().seconds;
        const double pixels = rate * kGroundTruthShare * plan_.seconds / kGroundTruthSamples;
        resize(study_.usual, std::clamp(pixels, std::min(whole, kLeastPixels), whole));
        study_.scale = whole / pixelsOf(study_.usual);
    }

    /// Keeps the aspect ratio.
    static void resize(RenderSettings& settings, double pixels) {
        const double shrink = std::sqrt(pixels / pixelsOf(settings));
        const auto scaled = [&](uint32_t side) {
            return std::max(1u, static_cast<uint32_t>(std::lround(side * std::min(1.0, shrink))));
        };
        settings.width = scaled(settings.width);
        settings.height = scaled(settings.height);
        settings.crop = {0, 0, settings.width, settings.height};
    }

    void renderGroundTruth() {
        RenderSettings settings = study_.usual;
        settings.seed += 1; // no random numbers in common with the variants
        const Clock::time_point before = Clock::now();
        const PreparedTracer prepared = prepare_(settings);
        prepareSeconds_ = secondsSince(before);
        const auto session = makeSession(prepared, settings);
        const double seconds = kGroundTruthShare * secondsLeft();
        if (sample(*session, seconds, "rendering the ground truth", [] {}))
            study_.groundTruth.emplace(*session);
    }

    void sweep() {
        const GroundTruth& truth = *study_.groundTruth;
        constexpr uint64_t kLeastSamples = 32; // of two replicas
        if (truth.mean <= 0.0 && truth.samples >= kLeastSamples)
            throw Error("the picture is black, so there is no error to study");
        if (!std::isfinite(truth.error))
            throw Error("the time budget is too short: the ground truth has " +
                        std::to_string(truth.samples) + " samples per pixel and needs " +
                        std::to_string(kLeastSamples) +
                        "; use a longer --budget or a smaller --size");
        std::vector<Variant> variants = variantsOf(study_.usual, truth.mean, plan_.isReference);
        for (const DenoiserKind denoiser : plan_.denoisers)
            variants.push_back(denoisedVariant(study_.usual, denoiser));
        size_t left = variants.size() + 1; // and the improvements together
        share_ = secondsLeft() / static_cast<double>(left);
        yardstick_.emplace(*this);
        yardstick_->measure();
        for (const Variant& variant : variants)
            take(variant, left--);
        std::vector<Variant> better;
        for (const Measurement& measurement : study_.measurements)
            if (measurement.variant.isOneChange && isImprovement(measurement))
                better.push_back(measurement.variant);
        if (better.size() > 1)
            take(together(study_.usual, better), left);
    }

    /// Measures a variant; all get the same time. `left`: variants to come, including this one.
    void take(const Variant& variant, size_t left) {
        const double share = std::min(share_, secondsLeft() / static_cast<double>(left));
        isOutOfTime_ = isOutOfTime_ || share <= 0.0;
        if (isOutOfTime_ && study_.measurements.empty())
            throw Error("the time budget is too short: no time is left for the default settings");
        if (isStopped_ || isOutOfTime_)
            return;
        const double seconds =
            std::max(kLeastShare * share_, (1.0 - kYardstickShare) * share - prepareSeconds_);
        try {
            std::optional<Measurement> measurement = measure(variant, seconds);
            if (!measurement)
                return;
            yardstick_->measure();
            study_.paceSpread = yardstick_->spread();
            // The usual settings measure the pace themselves.
            measurement->pace =
                study_.measurements.empty() ? paceOf(measurement->last()) : yardstick_->lastPace();
            study_.measurements.push_back(std::move(*measurement));
        } catch (const std::exception& error) {
            if (study_.measurements.empty())
                throw;
            study_.failures.push_back({variant.name, error.what()});
        }
    }

    void correctForPace() {
        if (!yardstick_)
            return;
        for (Measurement& measurement : study_.measurements) {
            measurement.pace /= yardstick_->usualPace();
            for (CurvePoint& point : measurement.curve)
                point.seconds *= measurement.pace;
        }
    }

    /// Samples a second.
    double paceOf(const CurvePoint& point) const {
        return pixelsOf(study_.usual) * point.samples / point.seconds;
    }

    /// Renders a little with the usual settings between the variants, to measure the pace.
    class Yardstick {
    public:
        explicit Yardstick(StudyRun& run)
            : run_(run), prepared_(run.prepare_(run.study_.usual)),
              session_(makeSession(prepared_, run.study_.usual)) {}

        void measure() {
            const RenderTotals& totals = session_->totals();
            const uint64_t paths = totals.paths;
            const double before = totals.seconds;
            run_.sample(*session_, before + kYardstickShare * run_.share_, "measuring the pace",
                        [] {});
            if (totals.seconds > before)
                paces_.push_back(static_cast<double>(totals.paths - paths) /
                                 (totals.seconds - before));
        }

        /// Samples a second between the last two measurements.
        double lastPace() const {
            return 0.5 * (paces_.back() + paces_[std::max<size_t>(paces_.size(), 2) - 2]);
        }

        /// Their median.
        double usualPace() const {
            std::vector<double> paces = paces_;
            std::ranges::sort(paces);
            return paces[paces.size() / 2];
        }

        /// Study::paceSpread.
        double spread() const {
            double squares = 0.0;
            for (size_t i = 1; i < paces_.size(); ++i)
                squares += 0.5 * std::pow(std::log(paces_[i] / paces_[i - 1]), 2.0);
            return paces_.size() < 2 ? 0.0
                                     : std::sqrt(squares / static_cast<double>(paces_.size() - 1));
        }

    private:
        StudyRun& run_;
        PreparedTracer prepared_;
        std::unique_ptr<Session> session_;
        std::vector<double> paces_;
    };

    bool isImprovement(const Measurement& measurement) const {
        const Measurement& usual = study_.measurements.front();
        if (measurement.variant.losesLight || measurement.variant.options.empty() ||
            !measurement.last().error || !usual.last().error)
            return false;
        const auto cost = [](const Measurement& one) {
            return one.pace * one.last().seconds * *one.last().error * *one.last().error;
        };
        return cost(measurement) < (1.0 - std::max(kBetter, study_.timingNoise())) * cost(usual);
    }

    /// None if the user stopped it: incomplete measurements do not count.
    std::optional<Measurement> measure(const Variant& variant, double seconds) {
        const RenderSettings settings = variant.settings(study_.usual);
        const PreparedTracer prepared = prepare_(settings);
        const auto session = makeSession(prepared, settings);
        Measurement measurement;
        measurement.variant = variant;
        measurement.buildSeconds = prepared.buildSeconds;
        measurement.compileSeconds = prepared.compileSeconds;
        const std::optional<Image> picture =
            variant.isDenoised ? measureDenoised(prepared, *session, seconds, measurement)
                               : measureSamples(*session, seconds, measurement);
        if (!picture)
            return std::nullopt;
        const MeanLuminance mean = meanLuminance(*picture, session->pixelErrors());
        measurement.brighter = mean.mean / study_.groundTruth->mean - 1.0;
        measurement.brighterError = std::hypot(mean.standardError, study_.groundTruth->meanError) /
                                    study_.groundTruth->mean;
        if (prepared.finish)
            prepared.finish();
        measurement.isTrusted = session->error() && session->error()->isTrusted();
        return measurement;
    }

    /// Records the curve. Returns the last picture; none if the user stopped it.
    std::optional<Image> measureSamples(Session& session, double seconds,
                                        Measurement& measurement) {
        const auto record = [&] {
            const Image picture = session.picture();
            const auto& estimate = session.error();
            measurement.curve.push_back(
                {static_cast<double>(session.totals().paths) / pixelsOf(study_.usual),
                 session.totals().seconds, study_.groundTruth->errorOf(picture),
                 estimate ? std::optional(estimate->relative) : std::nullopt, middleOf(picture)});
        };
        uint64_t next = 1;
        const bool isWhole = sample(session, seconds, measurement.variant.name, [&] {
            const uint64_t samples = session.totals().samplesPerPixel;
            if (samples < next)
                return;
            record();
            next = std::bit_ceil(samples + 1);
        });
        if (!isWhole)
            return std::nullopt;
        record();
        return session.picture();
    }

    /// Likewise. None also if the time was too short for one picture: then the study says so.
    std::optional<Image> measureDenoised(const PreparedTracer& prepared, Session& session,
                                         double seconds, Measurement& measurement) {
        const std::string& name = measurement.variant.name;
        const std::function<void()> onProgress = [&] {
            if (observer_.shouldStop())
                throw StudyStopped();
            observer_.onProgress(name);
        };
        DenoisedCurve curve(prepared, session, *study_.groundTruth, seconds, onProgress);
        if (!sample(
                session, [&] { return curve.isOver(); }, name, [&] { curve.onPass(); }))
            return std::nullopt;
        curve.finish();
        measurement.curve = curve.points();
        if (measurement.curve.empty())
            study_.omitted.push_back(
                {name, "the time budget was too short for 128 samples per pixel and denoising"});
        return curve.picture();
    }

    const StudyPlan& plan_;
    const PrepareTracer& prepare_;
    const StudyObserver& observer_;
    const Clock::time_point start_ = Clock::now();
    bool isStopped_ = false;
    bool isOutOfTime_ = false;
    double prepareSeconds_ = 0.0;
    double share_ = 0.0; ///< of the time, for each variant
    Study study_;
    std::optional<Yardstick> yardstick_;
};

} // namespace

double Study::timingNoise() const {
    constexpr double kLeast = 0.1;
    return std::max(kLeast, 2.0 * paceSpread);
}

Study runStudy(const StudyPlan& plan, const PrepareTracer& prepare, const StudyObserver& observer) {
    return StudyRun(plan, prepare, observer).run();
}

} // namespace calotype
