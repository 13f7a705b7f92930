// Multiprecision numbers based on MPFR; this is the only file that uses it. Each number has its own
// precision. A number made from a double has 53 bits unless more are requested; the result of an
// operation has the precision of its more precise operand and is rounded to nearest. There is no
// global state, so runs of different precisions may proceed side by side.
//
// The operators are for convenience: each creates a new number, which costs as much memory traffic
// as arithmetic. Where speed matters, the set_ functions work in place.
//
// Boost.Multiprecision is not used because in version 1.74, that of Debian 12, the precision of new
// numbers is a single setting of the whole process, in decimal digits.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace carom {

class Real {
  public:
    Real() : Real(0.0) {}

    // Not explicit, because arithmetic written for any scalar contains constants.
    Real(double value, int bits = std::numeric_limits<double>::digits) {
        mpfr_init2(value_, bits);
        mpfr_set_d(value_, value, MPFR_RNDN);
    }
    Real(const Real& other) {
        mpfr_init2(value_, mpfr_get_prec(other.value_));
        mpfr_set(value_, other.value_, MPFR_RNDN);
    }
    Real(Real&& other) noexcept {
        *value_ = *other.value_;
        other.value_->_mpfr_d = nullptr;
    }
    /// Copies the value and the precision.
    Real& operator=(const Real& other) {
        if (this == &other) return *this;
        if (value_->_mpfr_d == nullptr)
            mpfr_init2(value_, mpfr_get_prec(other.value_));
        else if (bits() != other.bits())
            mpfr_set_prec(value_, mpfr_get_prec(other.value_));
        mpfr_set(value_, other.value_, MPFR_RNDN);
        return *this;
    }
    Real& operator=(Real&& other) noexcept {
        mpfr_swap(value_, other.value_);
        return *this;
    }
    ~Real() {
        if (value_->_mpfr_d != nullptr) mpfr_clear(value_);
    }

    /// Converts a decimal number to the nearest number with this many bits; an empty text is 0.
    static Real from_text(const std::string& decimal, int bits) {
        Real number(0.0, bits);
        if (!decimal.empty()) mpfr_set_str(number.value_, decimal.c_str(), 10, MPFR_RNDN);
        return number;
    }

    int bits() const { return static_cast<int>(mpfr_get_prec(value_)); }
    bool is_finite() const { return mpfr_number_p(value_) != 0; }
    int sign() const { return mpfr_sgn(value_); }

    /// The nearest double.
    explicit operator double() const { return mpfr_get_d(value_, MPFR_RNDN); }
    /// The nearest doubles that are not larger, and not smaller, than this number.
    double rounded_down() const { return mpfr_get_d(value_, MPFR_RNDD); }
    double rounded_up() const { return mpfr_get_d(value_, MPFR_RNDU); }

    // In place; the number keeps its precision.
    void set(const Real& a) { mpfr_set(value_, a.value_, MPFR_RNDN); }
    void set(double a) { mpfr_set_d(value_, a, MPFR_RNDN); }
    void set_sum(const Real& a, const Real& b) { mpfr_add(value_, a.value_, b.value_, MPFR_RNDN); }
    void set_sum(const Real& a, double b) { mpfr_add_d(value_, a.value_, b, MPFR_RNDN); }
    void set_difference(const Real& a, const Real& b) {
        mpfr_sub(value_, a.value_, b.value_, MPFR_RNDN);
    }
    void set_difference(const Real& a, double b) { mpfr_sub_d(value_, a.value_, b, MPFR_RNDN); }
    void set_difference(double a, const Real& b) { mpfr_d_sub(value_, a, b.value_, MPFR_RNDN); }
    void set_product(const Real& a, const Real& b) {
        mpfr_mul(value_, a.value_, b.value_, MPFR_RNDN);
    }
    void set_product(const Real& a, double b) { mpfr_mul_d(value_, a.value_, b, MPFR_RNDN); }
    void set_square(const Real& a) { mpfr_sqr(value_, a.value_, MPFR_RNDN); }
    void set_quotient(const Real& a, const Real& b) {
        mpfr_div(value_, a.value_, b.value_, MPFR_RNDN);
    }
    void set_root(const Real& a) { mpfr_sqrt(value_, a.value_, MPFR_RNDN); }
    void negate() { mpfr_neg(value_, value_, MPFR_RNDN); }
    void scale_by_power_of_two(int exponent) { mpfr_mul_2si(value_, value_, exponent, MPFR_RNDN); }

    Real& operator+=(const Real& b) {
        if (bits() < b.bits()) return *this = *this + b;
        set_sum(*this, b);
        return *this;
    }
    Real& operator-=(const Real& b) {
        if (bits() < b.bits()) return *this = *this - b;
        set_difference(*this, b);
        return *this;
    }

    friend Real operator-(Real a) {
        a.negate();
        return a;
    }
    friend Real operator+(const Real& a, const Real& b) {
        Real result = room_for(a, b);
        result.set_sum(a, b);
        return result;
    }
    friend Real operator-(const Real& a, const Real& b) {
        Real result = room_for(a, b);
        result.set_difference(a, b);
        return result;
    }
    friend Real operator*(const Real& a, const Real& b) {
        Real result = room_for(a, b);
        result.set_product(a, b);
        return result;
    }
    friend Real operator/(const Real& a, const Real& b) {
        Real result = room_for(a, b);
        result.set_quotient(a, b);
        return result;
    }
    friend bool operator==(const Real& a, const Real& b) {
        return mpfr_equal_p(a.value_, b.value_) != 0;
    }
    friend bool operator==(const Real& a, double b) { return mpfr_cmp_d(a.value_, b) == 0; }
    friend std::strong_ordering operator<=>(const Real& a, const Real& b) {
        return mpfr_cmp(a.value_, b.value_) <=> 0;
    }
    friend std::strong_ordering operator<=>(const Real& a, double b) {
        return mpfr_cmp_d(a.value_, b) <=> 0;
    }

    friend Real sqrt(Real a) {
        mpfr_sqrt(a.value_, a.value_, MPFR_RNDN);
        return a;
    }
    friend Real abs(Real a) {
        mpfr_abs(a.value_, a.value_, MPFR_RNDN);
        return a;
    }
    /// a b + c, rounded once.
    friend Real fma(const Real& a, const Real& b, const Real& c) {
        Real result(Unset{}, std::max({a.bits(), b.bits(), c.bits()}));
        mpfr_fma(result.value_, a.value_, b.value_, c.value_, MPFR_RNDN);
        return result;
    }
    /// Decimal logarithm of a nonnegative number, also where no double is so small or so large;
    /// -infinity for 0.
    friend double log10(const Real& a) {
        long exponent = 0;
        const double digits = mpfr_get_d_2exp(&exponent, a.value_, MPFR_RNDN);
        return std::log10(digits) + static_cast<double>(exponent) * std::log10(2.0);
    }

    /// Writes or reads the precision and all bits, as hexadecimal digits.
    template <class Archive>
    void archive(Archive& archive) {
        std::int64_t its_bits = value_->_mpfr_d != nullptr ? bits() : 0;
        std::string text = its_bits > 0 ? hexadecimal() : std::string();
        archive(its_bits, text);
        if (!set_hexadecimal(its_bits, text)) archive.refuse("it holds what is no number");
    }

  private:
    // In the format that mpfr_set_str() reads: an integer in hexadecimal digits, followed by @ and
    // an exponent of 16.
    std::string hexadecimal() const {
        mpfr_exp_t exponent = 0;
        char* const written = mpfr_get_str(nullptr, &exponent, 16, 0, value_, MPFR_RNDN);
        std::string text = written;
        mpfr_free_str(written);
        if (!is_finite()) return text;
        const auto digits = static_cast<mpfr_exp_t>(text.size() - (text[0] == '-' ? 1 : 0));
        return text + "@" + std::to_string(exponent - digits);
    }
    // Returns false if `text` is not a number with this many bits. With 0 bits the number becomes
    // as one that has been moved from.
    bool set_hexadecimal(std::int64_t bits, const std::string& text) {
        constexpr std::int64_t most = 1 << 20;  // far more than a run has
        if (bits < 0 || bits > most) return false;
        if (value_->_mpfr_d != nullptr) mpfr_clear(value_);
        value_->_mpfr_d = nullptr;
        if (bits == 0) return text.empty();
        mpfr_init2(value_, static_cast<mpfr_prec_t>(bits));
        return mpfr_set_str(value_, text.c_str(), 16, MPFR_RNDN) == 0;
    }

    struct Unset {};
    Real(Unset, mpfr_prec_t bits) { mpfr_init2(value_, bits); }
    static Real room_for(const Real& a, const Real& b) {
        return {Unset{}, std::max(mpfr_get_prec(a.value_), mpfr_get_prec(b.value_))};
    }

    mpfr_t value_;  // without digits when it has been moved from
};

/// A double with the precision of another number, for arithmetic written for any scalar.
inline double as_precise_as(double, double value) { return value; }
inline Real as_precise_as(const Real& other, double value) { return {value, other.bits()}; }

/// The nearest double that is not larger, or not smaller, for arithmetic written for any scalar.
inline double rounded_down(double value) { return value; }
inline double rounded_down(const Real& value) { return value.rounded_down(); }
inline double rounded_up(double value) { return value; }
inline double rounded_up(const Real& value) { return value.rounded_up(); }

}  // namespace carom
