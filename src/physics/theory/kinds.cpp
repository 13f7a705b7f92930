#include "physics/theory/kinds.h"

#include <map>
#include <utility>

namespace carom {

Kinds kinds_of(const Particles& particles) {
    const auto properties = [&](Eigen::Index i) {
        return std::pair{particles.inverse_mass[i], particles.radius[i]};
    };
    std::map<std::pair<double, double>, int> equals;
    for (Eigen::Index i = 0; i < particles.count(); ++i) ++equals[properties(i)];

    Kinds kinds{Eigen::ArrayXi(particles.count()), {}};
    constexpr int none = -1;
    int of_singles = none;
    std::map<std::pair<double, double>, int> of_equals;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const bool single = equals.at(properties(i)) == 1 && particles.inverse_mass[i] > 0.0;
        int& kind = single ? of_singles : of_equals.try_emplace(properties(i), none).first->second;
        if (kind == none) {
            kind = static_cast<int>(kinds.members.size());
            kinds.members.push_back(0);
        }
        kinds.of[i] = kind;
        ++kinds.members[static_cast<std::size_t>(kind)];
    }
    return kinds;
}

}  // namespace carom
