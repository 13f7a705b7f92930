#include "physics/cells/body_state.h"

namespace carom {

BodyProperties::BodyProperties(const Particles& particles) {
    const auto count = static_cast<std::size_t>(particles.count());
    if (count == 0) return;
    const bool same = particles.are_equal();
    alike_ = same && particles.radius[0] > 0.0 && particles.inverse_mass[0] > 0.0;
    mask_ = same ? 0 : ~std::size_t{0};
    each_.resize(same ? 1 : count);
    for (std::size_t i = 0; i < each_.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        each_[i] = {particles.radius[k], particles.inverse_mass[k]};
    }
}

void BodyProperties::renumber(const std::vector<std::int32_t>& before) {
    if (mask_ == 0) return;
    LargeVector<Properties> each(each_.size());
    for (std::size_t k = 0; k < before.size(); ++k) each[k] = (*this)[before[k]];
    each_.swap(each);
}

}  // namespace carom
