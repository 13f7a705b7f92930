// What a sample says of its particles: which species each belongs to, whether it is present, and
// whether this has changed since the sample before.
#pragma once

#include <memory>
#include <utility>

#include "physics/particles.h"

namespace carom {

/// The species of all particles of a membership, N: index into Gas::species; null: the membership
/// at the start. `particles` and the membership must outlive the reference.
inline const Eigen::ArrayXi& species_in(const Membership* membership, const Particles& particles) {
    return membership ? membership->species : particles.species;
}

/// The same at the time of a sample, which must outlive the reference, too.
inline const Eigen::ArrayXi& species_at(const Sample& sample, const Particles& particles) {
    return species_in(sample.membership.get(), particles);
}

/// Whether a particle is present in a membership, null: that of the start; or in a sample.
inline bool is_present(const Membership* membership, Eigen::Index particle) {
    return !membership || membership->is_present[particle];
}
inline bool is_present(const Sample& sample, Eigen::Index particle) {
    return is_present(sample.membership.get(), particle);
}

/// Follows the membership through the samples of a run.
class MembershipWatch {
  public:
    /// Takes the next sample, in order of time. Returns whether its membership differs from that of
    /// the sample before; the first sample is compared with the start of the run. It looks at the
    /// particles only where two samples do not share their membership.
    bool see(const Sample& sample, const Particles& particles) {
        if (sample.membership == last_) return false;
        const std::shared_ptr<const Membership> before = std::exchange(last_, sample.membership);
        return !are_same(before.get(), last_.get(), particles);
    }

    /// The membership of the last sample seen; null for that of the start.
    const std::shared_ptr<const Membership>& last() const { return last_; }

    /// Writes or reads the membership of the last sample. Needs physics/archived.h.
    void archive(auto& archive, const Particles& particles) {
        bool is_start = archive.is_reading() || are_same(last_.get(), nullptr, particles);
        archive(is_start);
        if (is_start && archive.is_reading()) last_ = nullptr;
        if (is_start) return;
        Membership its = archive.is_reading() ? Membership{} : *last_;
        archive(its);
        if (!archive.is_reading()) return;
        if (its.species.size() != particles.count() || its.is_present.size() != particles.count())
            archive.refuse("its membership is not that of the particles");
        last_ = std::make_shared<const Membership>(std::move(its));
    }

  private:
    /// Null: that of the start.
    static bool are_same(const Membership* a, const Membership* b, const Particles& particles) {
        if ((species_in(a, particles) != species_in(b, particles)).any()) return false;
        if (a != nullptr && b != nullptr) return (a->is_present == b->is_present).all();
        return (a == nullptr || a->is_present.all()) && (b == nullptr || b->is_present.all());
    }

    std::shared_ptr<const Membership> last_;
};

}  // namespace carom
