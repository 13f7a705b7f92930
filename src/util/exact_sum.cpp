#include "util/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

// Rounds the number with these three digits, the first of which is not 0; `is_more`: lower digits
// are not all 0. The number has 65 bits or more, so that its lowest bit may stand for everything
// below it (a sticky bit).
double rounded(std::uint64_t first, std::uint64_t second, std::uint64_t third, bool is_more) {
    __extension__ using Wide = unsigned __int128;
    constexpr int digit_bits = 32;
    const Wide all = (Wide{first} << (2 * digit_bits)) | (Wide{second} << digit_bits) | third;
    return static_cast<double>(all | (is_more ? 1U : 0U));
}

}  // namespace

// Normalises all digits to [0, 2^32), except the last, which has the sign.
void ExactSum::carry() {
    for (std::size_t k = 0; k + 1 < digits; ++k) {
        const std::int64_t over = digits_[k] >> digit_bits;
        digits_[k] -= over * (std::int64_t{1} << digit_bits);
        digits_[k + 1] += over;
    }
    terms_ = 0;
}

void ExactSum::put_infinite(double term, std::int64_t sign) {
    if (std::isnan(term))
        not_numbers_ += sign;
    else
        (term > 0.0 ? infinite_ : minus_infinite_) += sign;
}

void ExactSum::add(const ExactSum& other) {
    ExactSum more = other;
    carry();
    more.carry();
    for (std::size_t k = 0; k < digits; ++k) digits_[k] += more.digits_[k];
    terms_ = 1;
    infinite_ += more.infinite_;
    minus_infinite_ += more.minus_infinite_;
    not_numbers_ += more.not_numbers_;
}

double ExactSum::value() const {
    if (not_numbers_ != 0 || (infinite_ != 0 && minus_infinite_ != 0))
        return std::numeric_limits<double>::quiet_NaN();
    if (infinite_ != 0) return std::numeric_limits<double>::infinity();
    if (minus_infinite_ != 0) return -std::numeric_limits<double>::infinity();
    return finite_value();
}

double ExactSum::finite_value() const {
    ExactSum sum = *this;
    sum.carry();
    const bool is_negative = sum.digits_.back() < 0;
    if (is_negative) {
        for (std::int64_t& digit : sum.digits_) digit = -digit;
        sum.carry();
    }
    std::size_t top = digits - 1;
    while (top > 0 && sum.digits_[top] == 0) --top;
    const auto digit = [&](std::size_t below) {
        return below > top ? 0 : static_cast<std::uint64_t>(sum.digits_[top - below]);
    };
    const std::size_t looked_at = std::min<std::size_t>(top, 2);
    const bool is_more = std::any_of(
        sum.digits_.begin(), sum.digits_.begin() + static_cast<std::ptrdiff_t>(top - looked_at),
        [](std::int64_t one) { return one != 0; });
    constexpr int least_exponent = -1075;
    const double size = std::ldexp(rounded(digit(0), digit(1), digit(2), is_more),
                                   digit_bits * (static_cast<int>(top) - 2) + least_exponent);
    return is_negative ? -size : size;
}

}  // namespace carom
