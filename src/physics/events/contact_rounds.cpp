#include "physics/events/contact_rounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "physics/collision/contact_rule.h"
#include "physics/multiprecision/multiprecision.h"

namespace carom {
namespace {

constexpr int most_rounds = 1000;

template <typename Scalar>
double magnitude_of(const Scalar& number) {
    return std::abs(static_cast<double>(number));
}

// Solves A x = b for a symmetric matrix without negative eigenvalues, by a Cholesky factorisation
// that takes the largest pivot first. The equations may depend on each other if they are
// consistent: what is left then counts as 0. `tolerance`: of a pivot, relative to the largest.
template <typename Scalar>
std::vector<Scalar> solve_semidefinite(std::vector<std::vector<Scalar>> a, std::vector<Scalar> b,
                                       double tolerance) {
    using std::sqrt;
    const std::size_t n = b.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    double largest = 0.0;
    std::size_t rank = 0;
    for (; rank < n; ++rank) {
        const auto best =
            std::max_element(order.begin() + static_cast<std::ptrdiff_t>(rank), order.end(),
                             [&](std::size_t i, std::size_t j) { return a[i][i] < a[j][j]; });
        std::swap(order[rank], *best);
        const std::size_t p = order[rank];
        const auto pivot = static_cast<double>(a[p][p]);
        largest = std::max(largest, pivot);
        if (!(pivot > tolerance * largest)) break;
        for (std::size_t k = rank + 1; k < n; ++k) {  // elimination
            const std::size_t i = order[k];
            const Scalar factor = a[i][p] / a[p][p];
            for (std::size_t l = rank + 1; l < n; ++l) a[i][order[l]] -= factor * a[p][order[l]];
            b[i] -= factor * b[p];
        }
    }
    std::vector<Scalar> x(n, as_precise_as(a[0][0], 0.0));
    for (std::size_t k = rank; k-- > 0;) {
        const std::size_t p = order[k];
        Scalar rest = b[p];
        for (std::size_t l = k + 1; l < rank; ++l) rest -= a[p][order[l]] * x[order[l]];
        x[p] = rest / a[p][p];
    }
    return x;
}

template <typename Scalar>
Scalar scalar_product(const std::vector<Scalar>& a, const std::vector<Scalar>& b) {
    Scalar sum = a[0] * b[0];
    for (std::size_t k = 1; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

template <typename Scalar>
Scalar square_of(const std::vector<Scalar>& a) {
    return scalar_product(a, a);
}

// The velocity of the second of two participants relative to the first, along a normal.
template <typename Scalar, std::size_t axes>
Scalar opening_along(const std::array<Scalar, axes>& normal, const std::array<Scalar, axes>& first,
                     const std::array<Scalar, axes>& second) {
    Scalar speed = normal[0] * (second[0] - first[0]);
    for (std::size_t k = 1; k < axes; ++k) speed += normal[k] * (second[k] - first[k]);
    return speed;
}

}  // namespace

template <typename Scalar, std::size_t axes>
ContactRounds<Scalar, axes>::ContactRounds(std::vector<Participant> participants,
                                           std::vector<Contact> contacts, int bits)
    : participants_(std::move(participants)), contacts_(std::move(contacts)), bits_(bits) {
    for (const Participant& participant : participants_)
        for (const Scalar& v : participant.v) fastest_ = std::max(fastest_, magnitude_of(v));
}

template <typename Scalar, std::size_t axes>
Scalar ContactRounds<Scalar, axes>::opening_speed(std::size_t contact) const {
    const Contact& c = contacts_[contact];
    const Vector &a = participants_[c.first].v, &b = participants_[c.second].v;
    return opening_along(c.normal, a, b);
}

// Velocities have the rounding errors of all that have been exchanged at this instant.
template <typename Scalar, std::size_t axes>
double ContactRounds<Scalar, axes>::round_off(std::size_t contact) const {
    const Contact& c = contacts_[contact];
    double sum = fastest_;
    for (std::size_t k = 0; k < axes; ++k)
        sum += magnitude_of(c.normal[k]) * (magnitude_of(participants_[c.first].v[k]) +
                                            magnitude_of(participants_[c.second].v[k]));
    return std::ldexp(sum, 3 - bits_);
}

template <typename Scalar, std::size_t axes>
bool ContactRounds<Scalar, axes>::approaches(std::size_t contact) const {
    return static_cast<double>(opening_speed(contact)) < -round_off(contact);
}

template <typename Scalar, std::size_t axes>
bool ContactRounds<Scalar, axes>::recedes(std::size_t contact) const {
    return static_cast<double>(opening_speed(contact)) > round_off(contact);
}

// The sets of approaching contacts that are connected by participants that can be pushed.
template <typename Scalar, std::size_t axes>
std::vector<std::vector<std::size_t>> ContactRounds<Scalar, axes>::connected_sets() const {
    std::vector<std::size_t> root(participants_.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    std::vector<std::size_t> approaching;
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
        if (!approaches(c)) continue;
        approaching.push_back(c);
        const auto [first, second, normal] = contacts_[c];
        if (participants_[first].can_be_pushed() && participants_[second].can_be_pushed())
            root[find(first)] = find(second);
    }
    std::map<std::size_t, std::vector<std::size_t>> sets;
    for (const std::size_t c : approaching) {
        const auto [first, second, normal] = contacts_[c];
        sets[find(participants_[first].can_be_pushed() ? first : second)].push_back(c);
    }
    std::vector<std::vector<std::size_t>> all;
    for (auto& [unused, set] : sets) all.push_back(std::move(set));
    return all;
}

// How much an impulse at contact b changes the opening speed of contact a: the scalar product of
// their normals in the mass metric.
template <typename Scalar, std::size_t axes>
Scalar ContactRounds<Scalar, axes>::coupling(std::size_t a, std::size_t b) const {
    const Contact &p = contacts_[a], &q = contacts_[b];
    Scalar sum = as_precise_as(p.normal[0], 0.0);
    const auto add = [&](std::size_t i, std::size_t j, double sign) {
        if (i != j) return;
        for (std::size_t k = 0; k < axes; ++k)
            sum += sign * participants_[i].inverse_mass[k] * p.normal[k] * q.normal[k];
    };
    add(p.first, q.first, 1.0);
    add(p.second, q.second, 1.0);
    add(p.first, q.second, -1.0);
    add(p.second, q.first, -1.0);
    return sum;
}

// Whether the angle between the reflections is pi / n. Angles come from places in doubles.
template <typename Scalar, std::size_t axes>
bool ContactRounds<Scalar, axes>::is_free_of_order(std::size_t a, std::size_t b) const {
    constexpr double tolerance = 1e-12;
    constexpr double most = 1000.0;
    const double cosine =
        -static_cast<double>(coupling(a, b)) /
        std::sqrt(static_cast<double>(coupling(a, a)) * static_cast<double>(coupling(b, b)));
    if (cosine < -1.0 + tolerance) return true;  // the same contact twice
    if (cosine < -tolerance) return false;
    const double n = std::round(std::numbers::pi / std::acos(std::min(cosine, 1.0)));
    return n <= most && std::abs(cosine - std::cos(std::numbers::pi / n)) < tolerance;
}

template <typename Scalar, std::size_t axes>
bool ContactRounds<Scalar, axes>::is_free_of_order(const std::vector<std::size_t>& set) const {
    const auto share = [&](std::size_t a, std::size_t b) {
        const Contact &p = contacts_[a], &q = contacts_[b];
        return p.first == q.first || p.first == q.second || p.second == q.first ||
               p.second == q.second;
    };
    for (std::size_t k = 0; k < set.size(); ++k)
        for (std::size_t l = k + 1; l < set.size(); ++l)
            if (share(set[k], set[l]) && !is_free_of_order(set[k], set[l])) return false;
    return true;
}

template <typename Scalar, std::size_t axes>
void ContactRounds<Scalar, axes>::push(std::size_t contact, const Scalar& impulse) {
    const Contact& c = contacts_[contact];
    Participant &a = participants_[c.first], &b = participants_[c.second];
    Hit hit{contact, {a.v, b.v}, {}, impulse};
    for (std::size_t k = 0; k < axes; ++k) {
        const Scalar change = impulse * c.normal[k];
        if (a.inverse_mass[k] > 0.0) a.v[k] -= a.inverse_mass[k] * change;
        if (b.inverse_mass[k] > 0.0) b.v[k] += b.inverse_mass[k] * change;
    }
    hit.after = {a.v, b.v};
    hits_.push_back(std::move(hit));
}

// Equal masses that meet along an axis exchange their velocities to the last bit.
template <typename Scalar, std::size_t axes>
void ContactRounds<Scalar, axes>::reflect(std::size_t contact) {
    const Contact& c = contacts_[contact];
    const Scalar impulse =
        -ContactRule::change(opening_speed(contact)) / coupling(contact, contact);
    push(contact, impulse);
    Participant &a = participants_[c.first], &b = participants_[c.second];
    for (std::size_t k = 0; k < axes; ++k) {
        bool is_along = true;
        for (std::size_t other = 0; other < axes; ++other)
            is_along = is_along && (other == k || c.normal[other] == 0.0);
        if (!is_along || a.inverse_mass[k] != b.inverse_mass[k]) continue;
        Hit& hit = hits_.back();
        a.v[k] = hit.before[1][k];
        b.v[k] = hit.before[0][k];
        hit.after = {a.v, b.v};
    }
}

template <typename Scalar, std::size_t axes>
void ContactRounds<Scalar, axes>::reflect_together(const std::vector<std::size_t>& set) {
    constexpr std::size_t most_in_matrix = 100;
    std::vector<Scalar> right;
    for (const std::size_t contact : set)
        right.push_back(-ContactRule::change(opening_speed(contact)));
    const std::vector<Scalar> impulses = set.size() <= most_in_matrix
                                             ? impulses_by_matrix(set, std::move(right))
                                             : impulses_by_gradients(set, std::move(right));
    for (std::size_t k = 0; k < set.size(); ++k) push(set[k], impulses[k]);
}

// The impulses that change the opening speeds of a set of contacts by `right`.
template <typename Scalar, std::size_t axes>
std::vector<Scalar> ContactRounds<Scalar, axes>::impulses_by_matrix(
    const std::vector<std::size_t>& set, std::vector<Scalar> right) const {
    std::vector<std::vector<Scalar>> matrix(set.size());
    for (std::size_t k = 0; k < set.size(); ++k)
        for (const std::size_t other : set) matrix[k].push_back(coupling(set[k], other));
    return solve_semidefinite(std::move(matrix), std::move(right), std::ldexp(1.0, 16 - bits_));
}

// The same by conjugate gradients, which need no matrix: for sets of many thousand contacts.
template <typename Scalar, std::size_t axes>
std::vector<Scalar> ContactRounds<Scalar, axes>::impulses_by_gradients(
    const std::vector<std::size_t>& set, std::vector<Scalar> right) {
    std::vector<Scalar> impulses(set.size(), as_precise_as(right[0], 0.0));
    std::vector<Scalar> direction = right;
    Scalar rest = square_of(right);
    const double enough = std::ldexp(static_cast<double>(rest), 2 * (6 - bits_));
    for (std::size_t step = 0; step < 10 * set.size(); ++step) {
        if (!(static_cast<double>(rest) > enough)) break;
        const std::vector<Scalar> changes = changes_by(set, direction);
        const Scalar length = rest / scalar_product(direction, changes);
        for (std::size_t k = 0; k < set.size(); ++k) {
            impulses[k] += length * direction[k];
            right[k] -= length * changes[k];
        }
        const Scalar before = rest;
        rest = square_of(right);
        const Scalar share = rest / before;
        for (std::size_t k = 0; k < set.size(); ++k) direction[k] = right[k] + share * direction[k];
    }
    return impulses;
}

// How much impulses at a set of contacts change their opening speeds.
template <typename Scalar, std::size_t axes>
std::vector<Scalar> ContactRounds<Scalar, axes>::changes_by(
    const std::vector<std::size_t>& set, const std::vector<Scalar>& impulses) const {
    const Scalar zero = as_precise_as(impulses[0], 0.0);
    Vector nothing;
    nothing.fill(zero);
    std::vector<Vector> pushed(participants_.size(), nothing);
    for (std::size_t k = 0; k < set.size(); ++k) {
        const Contact& c = contacts_[set[k]];
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const Scalar part = impulses[k] * c.normal[axis];
            pushed[c.first][axis] -= participants_[c.first].inverse_mass[axis] * part;
            pushed[c.second][axis] += participants_[c.second].inverse_mass[axis] * part;
        }
    }
    std::vector<Scalar> changes;
    for (const std::size_t contact : set) {
        const Contact& c = contacts_[contact];
        const Vector &a = pushed[c.first], &b = pushed[c.second];
        changes.push_back(opening_along(c.normal, a, b));
    }
    return changes;
}

template <typename Scalar, std::size_t axes>
bool ContactRounds<Scalar, axes>::run() {
    for (int round = 0; round < most_rounds; ++round) {
        const auto sets = connected_sets();
        if (sets.empty()) return true;
        for (const std::vector<std::size_t>& set : sets) {
            if (set.size() > 1 && !is_free_of_order(set)) {
                reflect_together(set);
                continue;
            }
            for (const std::size_t contact : set)
                if (approaches(contact)) reflect(contact);
        }
    }
    return false;
}

template <typename Scalar, std::size_t axes>
bool ContactRounds<Scalar, axes>::lead_back_to(const std::vector<Participant>& start) const {
    constexpr double tolerance = 1e-6;
    ContactRounds back = *this;
    double fastest = 0.0;
    for (Participant& participant : back.participants_)
        for (Scalar& v : participant.v) {
            fastest = std::max(fastest, magnitude_of(v));
            v = -v;
        }
    if (!back.run()) return false;
    for (std::size_t i = 0; i < start.size(); ++i)
        for (std::size_t k = 0; k < axes; ++k)
            if (magnitude_of(Scalar(back.participants_[i].v[k] + start[i].v[k])) >
                tolerance * fastest)
                return false;
    return true;
}

template class ContactRounds<double, 2>;
template class ContactRounds<double, 3>;
template class ContactRounds<Real, 2>;
template class ContactRounds<Real, 3>;

}  // namespace carom
