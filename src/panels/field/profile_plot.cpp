#include <algorithm>
#include <cmath>
#include <limits>

#include "panels/field/profile.h"
#include "physics/vec.h"
#include "scene/scene.h"
#include "util/text.h"

namespace carom {

std::vector<plot::Text> ProfilePanel::titles() const {
    if (spec_.title) return {escape_markup(*spec_.title)};
    const Language language = context_.language();
    std::string name =
        capitalised(name_of_quantity(language, context_.scene, options().quantity, {}));
    if (context_.box().dimension > 1)
        name = axis_ == 0   ? say(language, "{} along x", name)
               : axis_ == 1 ? say(language, "{} along y", name)
                            : say(language, "{} along z", name);
    if (spec_.of.empty()) return {name};
    const plot::Text names = names_of(context_, choices_, plot::Swatch::line);
    return {name + ": " + names, names};
}

plot::Polyline ProfilePanel::curve(std::size_t run, std::size_t choice, const char* part,
                                   std::vector<double> along, std::vector<double> up) const {
    plot::Polyline line;
    line.part = part;
    line.of = column_name_of(context_.scene, choices_[choice]);
    if (record_.compares()) line.run = run;
    line.x = plot::column(whole_.columns[1], is_up() ? up : along);
    line.y = plot::column(whole_.columns[2], is_up() ? along : up);
    line.is_thinned = false;
    return line;
}

// A horizontal piece for each slab; the line is broken at slabs without a value.
plot::Polyline ProfilePanel::line_of(const Measured& its, std::size_t run,
                                     std::size_t choice) const {
    const std::vector<double>& values = its.y[choice];
    std::vector<double> along, up;
    std::vector<int> piece;
    int pieces = 0;
    for (std::size_t slab = 0; slab < values.size(); ++slab) {
        if (std::isnan(values[slab])) {
            ++pieces;
            continue;
        }
        for (const std::size_t end : {slab, slab + 1}) {
            along.push_back(its.x[end]);
            up.push_back(values[slab]);
            piece.push_back(pieces);
        }
    }
    plot::Polyline line = curve(run, choice, "profile", std::move(along), std::move(up));
    line.piece = std::make_shared<const std::vector<int>>(std::move(piece));
    line.piece_column = whole_.columns[0];
    return line;
}

// Thin if runs are compared, since each run has its own line.
plot::Stroke ProfilePanel::stroke_of_law() const {
    if (record_.compares()) return {.role = {.of = plot::Role::Of::muted}, .width = 0.07};
    if (choices_.size() == 1) return {.role = {.of = plot::Role::Of::accent}};
    return {.role = {.of = plot::Role::Of::muted}, .dashes = {0.5}};
}

// The law as a line through the middles of the slabs.
plot::Polyline ProfilePanel::law_of(std::size_t run, std::size_t choice) const {
    const std::vector<double>& densities = record_.runs[run].laws.y[choice];
    const double width = record_.runs[run].length / static_cast<double>(densities.size());
    std::vector<double> along;
    for (std::size_t slab = 0; slab < densities.size(); ++slab)
        along.push_back((static_cast<double>(slab) + 0.5) * width);
    plot::Polyline law = curve(run, choice, "law", std::move(along), densities);
    law.still = true;
    law.depth = 1;
    law.stroke = stroke_of_law();
    if (record_.compares())
        law.stroke.role = plot::stroke_of_run(run).role;
    else if (choices_.size() > 1)
        law.stroke.role = role_among(context_, choices_, choice);
    return law;
}

plot::Note ProfilePanel::note() const {
    const Language language = context_.language();
    plot::Note note{.wraps = true};
    note.entries.push_back(
        {.words = {plot::Text(words_of_moments(context_.wording(), spec_, over_))}});
    const auto is_known = [](double value) { return std::isfinite(value); };
    const auto has_law = [&](const ProfileRun& run) {
        return std::ranges::any_of(
            run.laws.y, [&](const auto& law) { return std::ranges::any_of(law, is_known); });
    };
    if (std::ranges::any_of(record_.runs, has_law))
        note.entries.push_back({.swatch = stroke_of_law(), .words = {say(language, "ideal gas")}});
    if (record_.runs_in_mean > 1)
        note.entries.push_back(
            {.words = {plot::Text(words_of_mean(language, record_.runs_in_mean))}});
    if (record_.has_errors()) {  // of one run, not in every frame
        note.entries.push_back({.words = {say(language, "band: one standard error")}});
        note.changes = true;
    }
    return note;
}

void ProfilePanel::make_axes() {
    const Scene& scene = context_.scene;
    const Language language = context_.language();
    const Quantity quantity = quantity_of_field(scene, options().quantity);
    const std::string place = scene.gas.box.dimension == 1 ? "position" : name_of_axis(axis_);
    const double most = std::ranges::max_element(record_.runs, {}, &ProfileRun::most)->most;
    const double top = round_up_for_axis(1.02 * most);
    const double low = options().quantity == FieldOf::flow ? -top : 0.0;
    plot::Axis places{
        .title = scene.gas.box.dimension == 1 ? say(language, "position") : place,
        .low = 0.0,
        .high = std::ranges::max_element(record_.runs, {}, &ProfileRun::length)->length,
        .quantity = quantities::length};
    const plot::Axis values = plot::axis_of(language, quantity, low, top);
    const Heading of_place{place, quantities::length}, of_value(quantity);
    whole_ = {.titles = titles(),
              .x = is_up() ? values : places,
              .y = is_up() ? places : values,
              .columns = {{"piece", quantities::ordinal},
                          is_up() ? of_value : of_place,
                          is_up() ? of_place : of_value}};
    if (record_.has_errors()) whole_.columns.push_back(standard_error_of(of_value));
    whole_.language = language;
    if (record_.compares()) plot::name_runs(whole_, record_.names());
    whole_.notes.push_back(note());
    for (std::size_t run = 0; run < record_.runs.size(); ++run)
        for (std::size_t k = 0; k < record_.runs[run].laws.y.size(); ++k)
            whole_.layers.emplace_back(law_of(run, k));
}

// At both ends of each slab that has a value, as in line_of().
plot::Column ProfilePanel::column_of_errors(const Measured& its, std::size_t choice) const {
    std::vector<double> known;
    for (std::size_t slab = 0; slab < its.y[choice].size(); ++slab)
        if (!std::isnan(its.y[choice][slab])) known.insert(known.end(), 2, its.error[choice][slab]);
    return plot::column(whole_.columns[3], std::move(known));
}

// A step for each slab, broken where the value or its error is unknown.
plot::Band ProfilePanel::band_of(const plot::Polyline& line, const Measured& its,
                                 std::size_t choice) const {
    const std::vector<double>& values = its.y[choice];
    std::vector<double> along, up, errors;
    for (std::size_t slab = 0; slab < values.size(); ++slab)
        for (const std::size_t end : {slab, slab + 1}) {
            along.push_back(its.x[end]);
            up.push_back(values[slab]);
            errors.push_back(std::isnan(values[slab]) ? values[slab] : its.error[choice][slab]);
        }
    plot::Band band;
    band.x = plot::column(whole_.columns[1], is_up() ? up : along);
    band.y = plot::column(whole_.columns[2], is_up() ? along : up);
    band.error = plot::column(whole_.columns[3], std::move(errors));
    band.is_along_x = is_up();
    band.role = line.stroke.role;
    band.alpha = 0.5;
    band.depth = 2;  // under the law
    return band;
}

// "between 0.02 and 0.11", of all particles or of some.
std::string ProfilePanel::account_of(const std::vector<double>& of_slabs,
                                     std::size_t choice) const {
    const Language language = context_.language();
    const Eigen::Map<const Eigen::ArrayXd> values(of_slabs.data(), std::ssize(of_slabs));
    const auto known = !values.isNaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const std::string low = three_digits(language, known.select(values, infinite).minCoeff());
    const std::string high = three_digits(language, known.select(values, -infinite).maxCoeff());
    if (record_.compares())
        return known.any() ? say(language, "between {} and {}", low, high)
                           : say(language, "unknown");
    if (!known.any()) return "";
    const std::string what = name_of_quantity(language, context_.scene, options().quantity, {});
    const std::string axis = name_of_axis(axis_),
                      time = words_of_moments(context_.wording(), spec_, over_);
    if (spec_.of.empty())
        return say(language, "{} along {}, {}: between {} and {}.", what, axis, time, low, high);
    return say(language, "{} of {} along {}, {}: between {} and {}.", what,
               name_of(context_.scene, choices_[choice]), axis, time, low, high);
}

plot::Plot ProfilePanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    bool has_band = false;
    if (state == nullptr) return now;
    const auto& shown = static_cast<const ProfileState&>(*state);
    for (std::size_t run = 0; run < shown.runs.size(); ++run)
        for (std::size_t k = 0; k < shown.runs[run].y.size(); ++k) {
            const Measured& its = shown.runs[run];
            plot::Polyline line = line_of(its, run, k);
            line.stroke =
                record_.compares()
                    ? plot::stroke_of_run(run, 0.22)
                    : plot::Stroke{.role = role_among(context_, choices_, k),
                                   .width = record_.has_errors() ? 0.16 : 0.22,
                                   .print_dashes = plot::dashes_in_print(k, choices_.size()),
                                   .shade = plot::Shade::legible};
            if (record_.has_errors() && !its.error[k].empty()) {
                now.layers.emplace_back(band_of(line, its, k));
                line.more = {column_of_errors(its, k)};
                has_band = true;
            }
            now.layers.emplace_back(std::move(line));
            const std::string words = account_of(its.y[k], k);
            if (record_.compares())
                now.accounts_of_runs.push_back(words);
            else if (!words.empty())
                now.account += (now.account.empty() ? "" : " ") + capitalised(words);
        }
    if (!record_.has_errors()) return now;
    if (has_band)
        now.account +=
            " " + capitalised(say(context_.language(), "band: one standard error")) + ".";
    else
        now.notes.back().entries.back().is_hidden = true;
    return now;
}

}  // namespace carom
