#include "validation/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "util/files/atomic_file.h"

namespace carom::validation {

namespace {

/// The value to two digits of its error; exact numbers with all digits that they need.
std::string number(double value, double error) {
    if (!(error > 0.0)) {
        if (value == std::round(value) && std::abs(value) < 1e12)
            return fmt::format("{:.0f}", value);
        return fmt::format("{:.8g}", value);
    }
    const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(error))));
    return fmt::format("{:.{}f}", value, decimals);
}

std::string cell_of_z(const Row& row, double bound) {
    if (row.truth->rounding > 0.0) return row.z == 0.0 ? "exact" : "**off**";
    const std::string z = fmt::format("{:+.1f}", row.z);
    return std::abs(row.z) > bound ? "**" + z + "**" : z;
}

constexpr const char* introduction =
    R"(Exact and published values for gases of hard particles, beside those that carom measures. `./dev validate` makes this page again: it runs every row, writes the page, and fails if a row is outside of its error.

- **known**: the published or exact value, ± its standard error where it has one. Corrections for finite numbers and finite disks that are known exactly are included, and the source says so.
- **carom**: the mean over independent runs with seeds 1, 2, …, their number in the column *runs*, with the standard error of this mean from their scatter. No error is assumed.
- ***z***: the distance in standard errors; for few runs the normal deviate that is as unlikely as Student’s *t*. *exact* where there is no chance, and each run agrees to its rounding error.

)";

void write_tables(std::string& page, const std::vector<Measured>& studies, double bound) {
    std::string field, notes;
    const auto end_field = [&] {
        if (!notes.empty()) page += "\n" + notes;
        notes.clear();
    };
    int number = 0;
    for (const Measured& one : studies) {
        if (one.study.field != field) {
            end_field();
            field = one.study.field;
            page += fmt::format(
                "\n## {}\n\n| | what | known | carom | runs | *z* | source of the value |\n| ---: "
                "| "
                "--- | ---: | ---: | ---: | ---: | --- |\n",
                field);
        }
        for (const Row& row : one.rows)
            page += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", ++number, row.truth->what,
                                known_of(*row.truth, row), measured_of(row), row.runs,
                                cell_of_z(row, bound), row.truth->source);
        if (!one.study.how.empty()) notes += one.study.how + "\n\n";
    }
    end_field();
}

void write_summary(std::string& page, const std::vector<Measured>& studies, const Effort& effort) {
    std::vector<double> z;
    std::size_t rows = 0;
    for (const Measured& one : studies)
        for (const Row& row : one.rows) {
            ++rows;
            if (row.truth->rounding == 0.0) z.push_back(row.z);
        }
    double squares = 0.0;
    for (const double one : z) squares += one * one;
    page += fmt::format(
        "{} rows, {} of them exact. If all is right, the largest |*z*| exceeds {:.2f} by chance "
        "with a probability of 1 %; the mean of *z*² is {:.2f}, where 1 ± {:.2f} is expected. It "
        "took {:.0f} s on {} threads, {:.0f} s of processor time.\n",
        rows, rows - z.size(), effort.bound, squares / static_cast<double>(z.size()),
        std::sqrt(2.0 / static_cast<double>(z.size())), effort.seconds, effort.threads,
        effort.processor_seconds);
}

void write_figures(std::string& page, const std::string& figures) {
    if (figures.empty()) return;
    std::ifstream file(figures);
    if (!file) throw std::runtime_error("cannot read " + figures);
    page += "\n## In pictures\n\nDrawn by `carom figures scenes/sets/validation.yaml`.\n";
    const auto all = nlohmann::json::parse(file);
    for (const auto& figure : all.at("figures"))
        page += fmt::format(
            "\n![{}](validation/{}.svg)\n\n{}\n", figure.at("alt").get<std::string>(),
            figure.at("name").get<std::string>(), figure.at("caption").get<std::string>());
}

}  // namespace

void Measured::find_rows() {
    for (std::size_t k = 0; k < study.truths.size(); ++k) {
        std::vector<double> of_truth;
        for (const std::vector<double>& run : values) of_truth.push_back(run.at(k));
        rows.push_back(row_of(study.truths[k], of_truth));
    }
}

std::string known_of(const Truth& truth, const Row& row) {
    if (truth.error > 0.0)
        return number(truth.value, truth.error) + " ± " + number(truth.error, truth.error);
    return number(truth.value, 0.1 * row.measured.error);
}

std::string measured_of(const Row& row) {
    if (row.truth->rounding > 0.0) return number(row.measured.mean, 0.0);
    return number(row.measured.mean, row.measured.error) + " ± " +
           number(row.measured.error, row.measured.error);
}

void write_page(const std::string& path, const std::string& figures,
                const std::vector<Measured>& studies, const Effort& effort) {
    std::string page = "# Validation\n\n";
    page += introduction;
    write_summary(page, studies, effort);
    write_tables(page, studies, effort.bound);
    write_figures(page, figures);
    AtomicFile file(path);
    file.write(page);
    file.commit();
}

}  // namespace carom::validation
