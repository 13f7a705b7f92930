// What contacts of one instant do to the velocities of those that take part. They are carried out
// in rounds. A round takes each connected set of contacts that approach. Where every two contacts
// that share a participant are at an angle of pi / n in the mass metric, the order does not matter,
// and they are carried out one after another; otherwise the velocities are reflected at all of them
// at once, in the mass metric. Rounds repeat until no contact approaches. Energy and momentum are
// conserved, and the result does not depend on the order of the contacts.
//
// For doubles and for multiprecision, in the plane (and on a line) and in space. Independent of
// positions, box and clock.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace carom {

/// `axes`: number of components of velocities and normals.
template <typename Scalar, std::size_t axes>
class ContactRounds {
  public:
    using Vector = std::array<Scalar, axes>;

    /// A particle, or a surface.
    struct Participant {
        Vector v;
        std::array<double, axes> inverse_mass;  ///< along each axis; 0 if it is not pushed along it
        bool can_be_pushed() const {
            double sum = 0.0;
            for (const double w : inverse_mass) sum += w;
            return sum > 0.0;
        }
    };
    /// Two participants that touch; `normal` has the length 1 and points from the first to the
    /// second.
    struct Contact {
        std::size_t first, second;
        Vector normal;
    };
    /// A contact that has been carried out. The hits of one participant follow each other: the
    /// velocity after one is that before the next.
    struct Hit {
        std::size_t contact;
        std::array<Vector, 2> before, after;
        Scalar impulse;  ///< along the normal
    };

    /// `bits`: precision of the scalar. At least one participant of each contact can be pushed.
    ContactRounds(std::vector<Participant> participants, std::vector<Contact> contacts, int bits);

    /// Carries out rounds until no contact approaches. Returns false if a thousand do not suffice.
    bool run();

    const std::vector<Participant>& participants() const { return participants_; }
    const std::vector<Contact>& contacts() const { return contacts_; }
    const std::vector<Hit>& hits() const { return hits_; }

    /// The velocity of the second participant relative to the first, along the normal.
    Scalar opening_speed(std::size_t contact) const;
    /// Whether that is below 0, or above 0, by more than its rounding error.
    bool approaches(std::size_t contact) const;
    bool recedes(std::size_t contact) const;

    /// Whether the same contacts lead back from the present velocities, reversed, to those of
    /// `start`, reversed.
    bool lead_back_to(const std::vector<Participant>& start) const;

  private:
    double round_off(std::size_t contact) const;
    std::vector<std::vector<std::size_t>> connected_sets() const;
    Scalar coupling(std::size_t a, std::size_t b) const;
    bool is_free_of_order(const std::vector<std::size_t>& set) const;
    bool is_free_of_order(std::size_t a, std::size_t b) const;
    void push(std::size_t contact, const Scalar& impulse);
    void reflect(std::size_t contact);
    void reflect_together(const std::vector<std::size_t>& set);
    std::vector<Scalar> impulses_by_matrix(const std::vector<std::size_t>& set,
                                           std::vector<Scalar> right) const;
    std::vector<Scalar> impulses_by_gradients(const std::vector<std::size_t>& set,
                                              std::vector<Scalar> right);
    std::vector<Scalar> changes_by(const std::vector<std::size_t>& set,
                                   const std::vector<Scalar>& impulses) const;

    std::vector<Participant> participants_;
    std::vector<Contact> contacts_;
    std::vector<Hit> hits_;
    int bits_;
    double fastest_ = 0.0;  ///< largest component of a velocity at the start
};

}  // namespace carom
