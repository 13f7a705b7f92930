// What happens when two particles touch, or a particle and a surface: the rule, which says how the
// velocity along the line of centres changes and what becomes of the two, and the impulse that
// follows from it. For any scalar, as pair_collision.h; each geometry has the arithmetic that loses
// least. Independent of particles, box and clock. All functions may be called from any thread.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "physics/collision/pair_collision.h"

namespace carom {

/// Elastic contacts of smooth particles: the velocity along the line of centres is reversed, that
/// across it stays, and both particles stay what they are.
struct ContactRule {
    /// Whether particles keep their species; loops whose bodies have none assert it.
    static constexpr bool keeps_species = true;

    /// How much of the velocity along the line of centres, given in any unit, a contact takes away.
    template <typename Scalar>
    [[gnu::always_inline]] static Scalar change(const Scalar& approach) {
        return 2.0 * approach;
    }

    /// The impulse factor J = 2 r . v / (r^2 (w1 + w2)) of two bodies with separation r and inverse
    /// masses w1, w2, at least one of them positive: v1 += w1 J r, v2 -= w2 J r.
    ///
    /// Only r . v and, in product_of(), w J are rounded. If the divisor were rounded as well, its
    /// error would be nearly the same at each collision of the same two disks. Moreover, quotients
    /// by a number close to a power of 2 and products with one close to a simple fraction are
    /// rounded up more often than down, or the reverse. The energy would therefore drift: for equal
    /// disks of diameter 1 and mass 1 it rose by 4e-18 of a disk's energy at each collision.
    template <typename Scalar, std::size_t Dimension>
    [[gnu::always_inline]] static Unrounded<Scalar> impulse(
        const RelativeMotion<Scalar, Dimension>& m, const Scalar& first_inverse_mass,
        const Scalar& second_inverse_mass) {
        using std::fma;
        const Unrounded<Scalar> square = square_of_distance(m);
        const Unrounded<Scalar> sum = unrounded_sum(first_inverse_mass, second_inverse_mass);
        const Scalar product = square.value * sum.value;
        const Scalar error = fma(square.value, sum.value, -product) +
                             (square.value * sum.error + square.error * sum.value);
        return quotient_of<Scalar>(change<Scalar>(scalar_product(m.r, m.v)), {product, error});
    }

    /// The same for numbers with so many bits that plain arithmetic suffices: changes the
    /// velocities of two bodies in place. `approach` = r . v and `square` = r^2 are overwritten;
    /// `factor` and `part` are scratch.
    template <typename Scalar, std::size_t Dimension>
    static void push(std::array<Scalar, Dimension>& first_v,
                     std::array<Scalar, Dimension>& second_v,
                     const std::array<Scalar, Dimension>& r, double first_inverse_mass,
                     double second_inverse_mass, Scalar& approach, Scalar& square, Scalar& factor,
                     Scalar& part) {
        approach = change(approach);
        if (first_inverse_mass == second_inverse_mass) {  // these are half of their sum
            factor.set_quotient(approach, square);
            factor.scale_by_power_of_two(-1);
            for (std::size_t k = 0; k < Dimension; ++k) {
                part.set_product(factor, r[k]);
                first_v[k].set_sum(first_v[k], part);
                second_v[k].set_difference(second_v[k], part);
            }
            return;
        }
        factor.set(first_inverse_mass);
        factor.set_sum(factor, second_inverse_mass);
        square.set_product(square, factor);
        factor.set_quotient(approach, square);
        for (std::size_t k = 0; k < Dimension; ++k) {
            part.set_product(factor, r[k]);
            square.set_product(part, first_inverse_mass);
            first_v[k].set_sum(first_v[k], square);
            square.set_product(part, second_inverse_mass);
            second_v[k].set_difference(second_v[k], square);
        }
    }

    /// Changes the velocities of two beads on a line, at least one of finite mass. `first_share`,
    /// `second_share`: as shares_on_line() gives them, in the precision of the velocities. Equal
    /// masses exchange their velocities to the last bit.
    template <typename Scalar>
    static void push_on_line(Scalar& first_v, Scalar& second_v, const Scalar& first_share,
                             const Scalar& second_share) {
        if (first_share == second_share) {
            using std::swap;
            swap(first_v, second_v);
            return;
        }
        const Unrounded<Scalar> whole = unrounded_sum(first_share, second_share),
                                gain = unrounded_sum<Scalar>(change(second_v), -change(first_v));
        first_v = sum_with_product(first_v, quotient_of(first_share, whole), gain);
        second_v = sum_with_product(second_v, quotient_of<Scalar>(-second_share, whole), gain);
    }

    /// The ratio in which the velocities of two beads change: that of their inverse masses.
    /// Expressed by the masses where these are finite, because for example 1 / 3 is not a double:
    /// for masses in a simple ratio half of all new velocities lie midway between two numbers, and
    /// such an error would round all of them in the same direction.
    static std::array<double, 2> shares_on_line(double first_inverse_mass,
                                                double second_inverse_mass) {
        if (first_inverse_mass == second_inverse_mass) return {1.0, 1.0};
        const double first = 1.0 / first_inverse_mass, second = 1.0 / second_inverse_mass;
        if (std::isfinite(first) && std::isfinite(second)) return {second, first};
        return {first_inverse_mass, second_inverse_mass};
    }

    /// Reflects the velocity normal to a wall at rest.
    template <typename Scalar>
    [[gnu::always_inline]] static void reflect(Scalar& velocity) {
        velocity -= change(velocity);
    }

    /// Reflection at a surface: the changes of the velocities of the particle and of the surface,
    /// in units of the normal, which may have any length. `approach`: scalar product of the normal
    /// and the velocity of the particle relative to the surface; `square`: of the normal's length.
    /// Of a surface that no particle can push, `surface_w` is 0, and the particle's mass is not
    /// used.
    template <typename Scalar>
    struct Reflection {
        Scalar of_particle, of_surface;
    };
    template <typename Scalar>
    static Reflection<Scalar> reflection(const Scalar& approach, const Scalar& square,
                                         const Scalar& particle_w, const Scalar& surface_w) {
        const Scalar whole = -change(approach) / square;
        if (!(surface_w > 0.0)) return {whole, surface_w};
        // The same factor is used for both: two factors with different rounding errors would make
        // the energy drift.
        const Unrounded<Scalar> factor = quotient_of(whole, unrounded_sum(particle_w, surface_w));
        return {product_of(particle_w, factor), -product_of(surface_w, factor)};
    }

  private:
    // v + a b with one rounding.
    template <typename Scalar>
    static Scalar sum_with_product(const Scalar& v, const Unrounded<Scalar>& a,
                                   const Unrounded<Scalar>& b) {
        using std::fma;
        const Scalar product = a.value * b.value;
        const Unrounded<Scalar> sum = unrounded_sum(v, product);
        return sum.value + (sum.error + (fma(a.value, b.value, -product) +
                                         (a.value * b.error + a.error * b.value)));
    }
};

}  // namespace carom
