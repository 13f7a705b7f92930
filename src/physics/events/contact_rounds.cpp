#include "physics/events/contact_rounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "physics/multiprecision/multiprecision.h"

namespace carom {
namespace {

constexpr int most_rounds = 1000;

template <typename Scalar>
double size_of(const Scalar& number) {
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
    std::vector<Scalar> x(n, Scalar(0.0));
    for (std::size_t k = rank; k-- > 0;) {
        const std::size_t p = order[k];
        Scalar rest = b[p];
        for (std::size_t l = k + 1; l < rank; ++l) rest -= a[p][order[l]] * x[order[l]];
        x[p] = rest / a[p][p];
    }
    return x;
}

}  // namespace

template <typename Scalar>
Scalar ContactRounds<Scalar>::opening_speed(std::size_t contact) const {
    const Contact& c = contacts_[contact];
    const Vector &a = participants_[c.first].v, &b = participants_[c.second].v;
    return c.normal[0] * (b[0] - a[0]) + c.normal[1] * (b[1] - a[1]);
}

template <typename Scalar>
double ContactRounds<Scalar>::round_off(std::size_t contact) const {
    const Contact& c = contacts_[contact];
    double sum = 0.0;
    for (std::size_t k = 0; k < 2; ++k)
        sum += size_of(c.normal[k]) *
               (size_of(participants_[c.first].v[k]) + size_of(participants_[c.second].v[k]));
    return std::ldexp(sum, 3 - bits_);
}

template <typename Scalar>
bool ContactRounds<Scalar>::approaches(std::size_t contact) const {
    return static_cast<double>(opening_speed(contact)) < -round_off(contact);
}

template <typename Scalar>
bool ContactRounds<Scalar>::recedes(std::size_t contact) const {
    return static_cast<double>(opening_speed(contact)) > round_off(contact);
}

// The sets of approaching contacts that are connected by participants that can be pushed.
template <typename Scalar>
std::vector<std::vector<std::size_t>> ContactRounds<Scalar>::connected_sets() const {
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
        const Contact& its = contacts_[c];
        sets[find(participants_[its.first].can_be_pushed() ? its.first : its.second)].push_back(c);
    }
    std::vector<std::vector<std::size_t>> all;
    for (auto& [unused, set] : sets) all.push_back(std::move(set));
    return all;
}

// How much an impulse at contact b changes the opening speed of contact a: the scalar product of
// their normals in the mass metric.
template <typename Scalar>
Scalar ContactRounds<Scalar>::coupling(std::size_t a, std::size_t b) const {
    const Contact &p = contacts_[a], &q = contacts_[b];
    Scalar sum = as_precise_as(p.normal[0], 0.0);
    const auto add = [&](std::size_t i, std::size_t j, double sign) {
        if (i != j) return;
        for (std::size_t k = 0; k < 2; ++k)
            sum += sign * participants_[i].inverse_mass[k] * p.normal[k] * q.normal[k];
    };
    add(p.first, q.first, 1.0);
    add(p.second, q.second, 1.0);
    add(p.first, q.second, -1.0);
    add(p.second, q.first, -1.0);
    return sum;
}

// Whether the angle between the reflections is pi / n. Angles come from places in doubles.
template <typename Scalar>
bool ContactRounds<Scalar>::is_free_of_order(std::size_t a, std::size_t b) const {
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

template <typename Scalar>
bool ContactRounds<Scalar>::is_free_of_order(const std::vector<std::size_t>& set) const {
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

template <typename Scalar>
void ContactRounds<Scalar>::push(std::size_t contact, const Scalar& impulse) {
    const Contact& c = contacts_[contact];
    Participant &a = participants_[c.first], &b = participants_[c.second];
    Hit hit{contact, {a.v, b.v}, {}, impulse};
    for (std::size_t k = 0; k < 2; ++k) {
        const Scalar change = impulse * c.normal[k];
        if (a.inverse_mass[k] > 0.0) a.v[k] -= a.inverse_mass[k] * change;
        if (b.inverse_mass[k] > 0.0) b.v[k] += b.inverse_mass[k] * change;
    }
    hit.after = {a.v, b.v};
    hits_.push_back(std::move(hit));
}

// Equal masses that meet along an axis exchange their velocities to the last bit.
template <typename Scalar>
void ContactRounds<Scalar>::reflect(std::size_t contact) {
    const Contact& c = contacts_[contact];
    const Scalar impulse = -2.0 * opening_speed(contact) / coupling(contact, contact);
    push(contact, impulse);
    Participant &a = participants_[c.first], &b = participants_[c.second];
    for (std::size_t k = 0; k < 2; ++k) {
        if (c.normal[1 - k] != 0.0 || a.inverse_mass[k] != b.inverse_mass[k]) continue;
        Hit& hit = hits_.back();
        a.v[k] = hit.before[1][k];
        b.v[k] = hit.before[0][k];
        hit.after = {a.v, b.v};
    }
}

template <typename Scalar>
void ContactRounds<Scalar>::reflect_together(const std::vector<std::size_t>& set) {
    std::vector<std::vector<Scalar>> matrix(set.size());
    std::vector<Scalar> right;
    for (std::size_t k = 0; k < set.size(); ++k) {
        for (std::size_t l = 0; l < set.size(); ++l) matrix[k].push_back(coupling(set[k], set[l]));
        right.push_back(-2.0 * opening_speed(set[k]));
    }
    const std::vector<Scalar> impulses =
        solve_semidefinite(std::move(matrix), std::move(right), std::ldexp(1.0, 16 - bits_));
    for (std::size_t k = 0; k < set.size(); ++k) push(set[k], impulses[k]);
}

template <typename Scalar>
bool ContactRounds<Scalar>::run() {
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

template <typename Scalar>
bool ContactRounds<Scalar>::lead_back_to(const std::vector<Participant>& start) const {
    constexpr double tolerance = 1e-6;
    ContactRounds back = *this;
    double fastest = 0.0;
    for (Participant& participant : back.participants_)
        for (Scalar& v : participant.v) {
            fastest = std::max(fastest, size_of(v));
            v = -v;
        }
    if (!back.run()) return false;
    for (std::size_t i = 0; i < start.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k)
            if (size_of(Scalar(back.participants_[i].v[k] + start[i].v[k])) > tolerance * fastest)
                return false;
    return true;
}

template class ContactRounds<double>;
template class ContactRounds<Real>;

}  // namespace carom
