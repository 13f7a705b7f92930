#include "stats/means/measured.h"

namespace carom {
namespace {

// The mean and the standard error of one number over runs.
template <class Number>
MeanError over_runs(std::span<const Measured* const> runs, const Number& number) {
    std::vector<double> of_each;
    for (const Measured* run : runs) of_each.push_back(number(*run));
    return mean_error(of_each);
}

}  // namespace

void Measured::add(double moment, const std::vector<double>& readings) {
    x.push_back(moment);
    y.resize(readings.size());
    for (std::size_t line = 0; line < readings.size(); ++line) y[line].push_back(readings[line]);
}

std::size_t Measured::bytes() const {
    std::size_t count = x.size();
    for (const NumberRows* rows : {&y, &error})
        for (const std::vector<double>& row : *rows) count += row.size();
    for (const std::vector<MeanError>& row : numbers) count += 2 * row.size();
    return count * sizeof(double);
}

Measured mean_of(std::span<const Measured* const> runs) {
    Measured mean = *runs.front();
    mean.error = mean.y;
    for (std::size_t line = 0; line < mean.y.size(); ++line)
        for (std::size_t k = 0; k < mean.y[line].size(); ++k) {
            const MeanError all =
                over_runs(runs, [&](const Measured& run) { return run.y.at(line).at(k); });
            mean.y[line][k] = all.mean;
            mean.error[line][k] = all.error;
        }
    for (std::size_t line = 0; line < mean.numbers.size(); ++line)
        for (std::size_t k = 0; k < mean.numbers[line].size(); ++k)
            mean.numbers[line][k] = over_runs(
                runs, [&](const Measured& run) { return run.numbers.at(line).at(k).mean; });
    return mean;
}

}  // namespace carom
