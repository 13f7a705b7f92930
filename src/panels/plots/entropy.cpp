// The entropy of the velocities against time, Boltzmann's -H for each particle: -sum p ln p, where
// p is the share of a species' particles in a cell of velocity. It is 0 when all of a kind move
// alike and rises to what the same count gives in equilibrium.
#include <algorithm>
#include <cmath>
#include <map>

#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "stats/mechanics.h"
#include "util/random.h"

namespace carom {
namespace {

// Cells of equal size in velocities measured in thermal ones, sqrt(T/m), of the start; those beyond
// four of them belong to the outermost cells.
class VelocityCells {
  public:
    VelocityCells(const PanelContext& context, double temperature)
        : context_(context), counts_(context.scene.gas.species.size()) {
        const Eigen::ArrayXd& inverse = context.particles.inverse_mass;
        scale_ = (inverse > 0.0).select(1.0 / (inverse * temperature), 0.0).sqrt();
        for (Eigen::Index i = 0; i < inverse.size(); ++i)
            counts_[static_cast<std::size_t>(context.particles.species[i])] += inverse[i] > 0.0;
        const auto most = static_cast<double>(std::ranges::max(counts_));
        per_axis_ = static_cast<int>(std::clamp(std::round(2.0 * std::cbrt(most)), 6.0, 24.0));
    }

    /// -sum p ln p, averaged over the particles of finite mass; velocities N x d.
    double entropy(const Eigen::ArrayXXd& velocity) const {
        std::map<std::pair<int, int>, double> shares;  // species and cell
        double all = 0.0;
        for (Eigen::Index i = 0; i < velocity.rows(); ++i) {
            if (scale_[i] == 0.0) continue;
            int cell = 0;
            for (Eigen::Index a = 0; a < velocity.cols(); ++a)
                cell = per_axis_ * cell + cell_of(velocity(i, a) * scale_[i]);
            shares[{context_.particles.species[i], cell}] += 1.0;
            all += 1.0;
        }
        double sum = 0.0;
        for (const auto& [place, count] : shares)
            sum -= count * std::log(count / double(counts_[static_cast<std::size_t>(place.first)]));
        return all > 0.0 ? sum / all : 0.0;
    }

    /// The mean of the same for velocities spread evenly over the energy sphere, with as many
    /// particles: what counting leaves of equilibrium's.
    double in_equilibrium() const {
        Random random(1, "entropy in equilibrium");
        const Eigen::Index count = scale_.size();
        const int samples = static_cast<int>(std::clamp<Eigen::Index>(200'000 / count, 4, 100));
        double sum = 0.0;
        for (int s = 0; s < samples; ++s) {
            Eigen::ArrayXXd velocity(count, context_.scene.gas.box.dimension);
            for (double& one : velocity.reshaped()) one = random.normal();
            const auto moves = (scale_ > 0.0).cast<double>();
            const double square = (velocity.square().rowwise().sum() * moves).sum();
            velocity *= std::sqrt(moves.sum() * static_cast<double>(velocity.cols()) / square);
            velocity.colwise() *= (scale_ > 0.0).select(1.0 / scale_, 0.0);
            sum += entropy(velocity);
        }
        return sum / samples;
    }

  private:
    int cell_of(double u) const {
        constexpr double reach = 4.0;
        const double place = (u + reach) / (2.0 * reach) * per_axis_;
        return static_cast<int>(std::clamp(std::floor(place), 0.0, per_axis_ - 1.0));
    }

    PanelContext context_;
    std::vector<std::int64_t> counts_;  // of finite mass, by species
    Eigen::ArrayXd scale_;              // 1 / thermal velocity; 0 for infinite masses
    int per_axis_ = 6;
};

}  // namespace

std::unique_ptr<Panel> make_entropy(const PanelContext& context, const PanelSpec& spec) {
    const auto cells = std::make_shared<std::optional<VelocityCells>>();
    SeriesSubject subject{
        .measure = [context, cells](const FrameInput& o) -> std::vector<double> {
            const Box& box = context.scene.gas.box;
            const double start = temperature(box, context.particles,
                                             thermal_energy(box, context.particles, o.sample));
            if (!*cells && start > 0.0) cells->emplace(context, start);
            return {*cells ? (*cells)->entropy(o.sample.velocity) : 0.0};
        },
        .color = [](std::size_t, const Theme& theme) { return theme.bar; },
        .title =
            [spec](const Theme&) {
                return spec.title ? escape_markup(*spec.title)
                                  : std::string("Entropy of the velocities, −<i>H</i>");
            },
        .notes = {"−Σ <i>p</i> ln <i>p</i> over cells of velocity; 0 if all move alike",
                  "−Σ <i>p</i> ln <i>p</i> over cells of velocity"},
        .column = "entropy (1)",
        .names = {"all"}};
    if (context.equilibrium)
        subject.reference = [cells]() -> std::optional<ReferenceLevel> {
            if (!*cells) return std::nullopt;
            return ReferenceLevel{"equilibrium", (*cells)->in_equilibrium()};
        };
    return std::make_unique<SeriesPanel>(context, std::move(subject));
}

}  // namespace carom
