// Measures the mean squared displacement over all starting times, with what its diffusion
// coefficient and the error of that take: the numbers of diffusion.h. The particles are those
// chosen at the start.
#pragma once

#include <cmath>
#include <vector>

#include "panels/correlations/diffusion.h"
#include "panels/correlations/lag_meter.h"

namespace carom {

/// The scatter of at least so many particles gives the error of their mean: momentum that is
/// conserved correlates fewer too much.
inline constexpr std::size_t fewest_scattered = 8;

/// Counts collisions of each particle with particles and obstacles in a time, each by how much of
/// the velocity it makes forget: 1 with an equal mass, less with a lighter one as in the initial
/// slope of the velocity autocorrelation.
class PartnerCounts {
  public:
    PartnerCounts(const Box& box, const Particles& particles, double from, double until)
        : sides_(box.surfaces.first_partition()),
          inverse_mass_(particles.inverse_mass),
          from_(from),
          until_(until),
          counts_(Eigen::ArrayXd::Zero(particles.count())) {}

    void see(const FrameInput& input) {
        for (const Collision& collision : input.advanced.collisions) {
            if (collision.time < from_ || collision.time > until_) continue;
            const bool is_pair = collision.second.is_particle();
            if (!is_pair && collision.second.surface() < sides_) continue;
            add(collision.first, is_pair ? inverse_mass_[collision.second.particle()] : 0.0);
            if (is_pair) add(collision.second.particle(), inverse_mass_[collision.first]);
        }
    }

    double mean(const std::vector<Eigen::Index>& list) const { return counts_(list).mean(); }
    void archive(Archive& archive) { archive(counts_); }

  private:
    void add(Eigen::Index particle, double others_inverse_mass) {
        const double own = inverse_mass_[particle];
        if (own > 0.0) counts_[particle] += 2.0 * own / (own + others_inverse_mass);
    }

    std::int32_t sides_;  ///< number of the box's sides, which count for nothing
    Eigen::ArrayXd inverse_mass_;
    double from_, until_;
    Eigen::ArrayXd counts_;
};

/// Measures displacements of many particles in groups, and those of few in parts of the run: the
/// scatter of groups or parts gives the error of the fit. Parts are as long as two of the longest
/// lags, so that they are independent of each other.
class DisplacementMeter : public LagMeter {
  public:
    /// The line is fitted from the lag `fit_from` to the longest, `lags`.
    DisplacementMeter(const PanelContext& context,
                      const std::vector<std::vector<Eigen::Index>>& lists, double from, double lags,
                      double fit_from);

    void see(const FrameInput& input) override;
    Measured measured() const override;
    void archive(Archive& archive) override;

  private:
    double end_of_part(std::size_t part) const;
    std::vector<Eigen::ArrayXXd> means_of_parts() const;
    double coefficient(const Eigen::ArrayXd& squares, double from, double until) const;
    std::vector<MeanError> numbers_from(const Eigen::ArrayXd& mean,
                                        const std::vector<Eigen::ArrayXd>& pieces) const;

    std::vector<std::vector<Eigen::Index>> lists_, groups_;
    LagAverages speeds_;
    std::vector<LagAverages> parts_;  ///< of the run, with the lists of few particles
    PartnerCounts collisions_;
    double from_, fit_from_, lags_, time_;
    int dimension_;
};

}  // namespace carom
