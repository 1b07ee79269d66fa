#include "support/direction_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "support/chi_square.h"

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Cells of half vectors: rings in q, where the half vector's angle to the normal is
/// width (e^q - 1), so that a narrow lobe and a diffuse one beside it both spread over the rings.
class HalfVectorCells {
public:
    static constexpr int kRings = 14;
    static constexpr int kSectors = 8;
    static constexpr int kCells = kRings * kSectors;

    /// Integrals take `steps` steps across each side of a cell.
    HalfVectorCells(const glm::dvec3& wo, double lobeWidth, int steps)
        : wo_(wo), width_(lobeWidth), qEnd_(std::log1p(0.5 * kPi / lobeWidth)), steps_(steps) {}

    int cellOf(const glm::dvec3& wi) const {
        const glm::dvec3 h = wo_ + wi;
        const double q = std::log1p(std::atan2(std::hypot(h.x, h.y), h.z) / width_);
        const double turns = std::atan2(h.y, h.x) / (2.0 * kPi) + 0.5;
        return std::min(static_cast<int>(q / qEnd_ * kRings), kRings - 1) * kSectors +
               std::min(static_cast<int>(turns * kSectors), kSectors - 1);
    }

    struct Integrals {
        std::vector<double> cells;
        std::vector<bool> isCut; ///< the cell reaches below the horizon, where the density jumps
    };

    /// The integral over each cell of a density of directions, which becomes one of half vectors
    /// by the Jacobian 4 wo.h.
    Integrals integrate(const std::function<double(const glm::dvec3&)>& pdf) const {
        Integrals result{std::vector<double>(kCells), std::vector<bool>(kCells)};
        for (int i = 0; i < kRings * steps_; ++i)
            for (int j = 0; j < kSectors * steps_; ++j) {
                const int cell = i / steps_ * kSectors + j / steps_;
                const double q = (i + 0.5) / (kRings * steps_) * qEnd_;
                const double phi = ((j + 0.5) / (kSectors * steps_) - 0.5) * 2.0 * kPi;
                const double theta = width_ * std::expm1(q);
                const glm::dvec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                   std::cos(theta));
                const double woh = glm::dot(wo_, h);
                const glm::dvec3 wi = 2.0 * woh * h - wo_;
                if (woh <= 0.0 || wi.z <= 0.0) {
                    result.isCut[cell] = true;
                    continue;
                }
                const double dq = qEnd_ / (kRings * steps_);
                const double dPhi = 2.0 * kPi / (kSectors * steps_);
                const double solidAngle = std::sin(theta) * width_ * std::exp(q) * dq * dPhi;
                result.cells[cell] += pdf(wi) * 4.0 * woh * solidAngle;
            }
        return result;
    }

private:
    glm::dvec3 wo_;
    double width_;
    double qEnd_;
    int steps_;
};

/// Cells too rare for the statistic are counted together.
void poolRareCells(std::vector<uint64_t>& counts, std::vector<double>& chances, double rare) {
    std::vector<uint64_t> keptCounts(1);
    std::vector<double> keptChances(1);
    for (size_t i = 0; i < counts.size(); ++i) {
        if (chances[i] < rare) {
            keptCounts[0] += counts[i];
            keptChances[0] += chances[i];
        } else {
            keptCounts.push_back(counts[i]);
            keptChances.push_back(chances[i]);
        }
    }
    if (keptChances[0] < rare) { // still rare: with the first
        keptCounts[1] += keptCounts[0];
        keptChances[1] += keptChances[0];
        keptCounts.erase(keptCounts.begin());
        keptChances.erase(keptChances.begin());
    }
    counts = std::move(keptCounts);
    chances = std::move(keptChances);
}

} // namespace

DirectionFit fitDirections(const std::vector<glm::dvec3>& wi, size_t draws, const glm::dvec3& wo,
                           double lobeWidth, const std::function<double(const glm::dvec3&)>& pdf) {
    // Half as many steps have four times the error, and a quarter of the draws twice the noise.
    const HalfVectorCells cells(wo, lobeWidth, draws < 30'000 ? 20 : 40);
    const HalfVectorCells::Integrals integrals = cells.integrate(pdf);
    std::vector<uint64_t> counts(HalfVectorCells::kCells + 1); // the last: of no direction
    for (const glm::dvec3& direction : wi)
        ++counts[cells.cellOf(direction)];
    counts.back() = draws - wi.size();
    // A cell cut by the horizon is counted with what falls below it.
    std::vector<double> chances = integrals.cells;
    chances.push_back(1.0);
    for (size_t cell = 0; cell < integrals.cells.size(); ++cell) {
        if (integrals.isCut[cell]) {
            counts.back() += std::exchange(counts[cell], 0);
            chances[cell] = 0.0;
        }
        chances.back() -= chances[cell];
    }
    chances.back() = std::max(chances.back(), 0.0);
    poolRareCells(counts, chances, 20.0 / static_cast<double>(draws));
    DirectionFit fit;
    fit.integral = std::accumulate(integrals.cells.begin(), integrals.cells.end(), 0.0);
    fit.accepted = static_cast<double>(wi.size()) / static_cast<double>(draws);
    fit.tolerance = 1.95 / std::sqrt(static_cast<double>(draws));
    fit.chiSquare = chiSquare(counts, chances);
    fit.limit = chiSquareLimit(counts.size() - 1);
    return fit;
}

} // namespace calotype::test
