// The words around the bars of a histogram: its titles, and what its bars count.
#include <fmt/format.h>

#include <algorithm>

#include "panels/chosen.h"
#include "panels/means/runs_record.h"
#include "panels/plots/histogram_panel.h"
#include "util/text.h"

namespace carom {
namespace {

using plot::named, plot::Note, plot::Role, plot::Text, plot::text_of;

// Parts of titles.
constexpr Phrase apart{"{}: {}"}, aside{"{}, {}"};

}  // namespace

// The name in the picture: that of a run, or of a choice of particles.
std::string HistogramPanel::name_of_series(std::size_t k) const {
    if (compares()) return axes_.series[k].name;
    return parts_ ? parts_->names(context_.language())[k]
                  : name_of(context_.scene, choices_[k].chosen);
}

plot::Role HistogramPanel::role_of_choice(std::size_t k) const {
    return parts_ ? surface_role(k, choices_.size()) : choice_role(context_, choices_[k].chosen, k);
}

plot::Text HistogramPanel::names_of_choices(Joint joint) const {
    if (count() == 1) return escape_markup(name_of_series(0));
    std::vector<Text> names;
    for (std::size_t k = 0; k < count(); ++k)
        names.push_back(named(name_of_series(k), roles_[k].bar, plot::Swatch::line, k));
    return joined(context_.language(), names, joint);
}

// Whether marks of means have the names of choices.
bool HistogramPanel::marks_name_choices() const { return marks_mean_now() && !options().fit; }

// The note on what a short title omits: the names of choices, and that the curves are those of
// equilibrium.
plot::Note HistogramPanel::note_of_short_title() const {
    Note note{.wraps = true, .of_last_titles = spec_.title && count() > 1 ? 2U : 1U};
    if (count() > 1 && !compares() && !(spec_.title && marks_name_choices()))
        for (std::size_t k = 0; k < count(); ++k)
            note.entries.push_back(
                {*layers_[k].bars.edge, {named(name_of_series(k), roles_[k].bar)}});
    if (!axes_.has_curves() || count() == 1) return note;
    const Language language = context_.language();
    note.entries.push_back({{},
                            {compares() ? say(language, "thin lines: equilibrium")
                                        : say(language, "lines: equilibrium")}});
    return note;
}

// Whether bars show something else than the present of a film.
bool HistogramPanel::tells_time() const { return window() != 0.0 || spec_.at || axes_.runs > 1; }

// What the words say of the time and of the equilibrium curves. A title of the scene's own is never
// left out: what it has no room for stands below it, see note_of_short_title(). Gives what the last
// of such titles leaves out besides.
plot::Text HistogramPanel::add_titles() {
    const Language language = context_.language();
    const auto both = [&](Phrase phrase, const Text& first, const Text& second) {
        return text_of(language, phrase, {first, second});
    };
    if (compares()) return add_titles_of_runs();
    Text quantity = capitalised(say(language, subject_.quantity.word));
    Text words = escape_markup(spec_.title.value_or(say(language, subject_.title)));
    if (!spec_.title && !spec_.of.empty())
        words = both(Phrase{"{} of {}"}, words, names_of_choices(Joint::last_by_and));
    if (!spec_.title && parts_ && count() == 1)
        for (Text* one : {&words, &quantity}) *one = both(apart, *one, names_of_choices({}));
    Text time = axes_.time;
    if (axes_.runs > 1)
        time = both(aside, time, words_of_mean(language, static_cast<int>(axes_.runs)));
    else if (count() == 1)
        time = named(axes_.time, {Role::Of::bar});
    const auto at_time = [&](const Text& what) { return both(apart, what, time); };
    const auto with_curves = [&](const Text& what, const Text& when) {
        const Text timed = both(apart, what, when);
        return axes_.has_curves() ? both(aside, timed, say(language, "lines: equilibrium")) : timed;
    };
    if (count() == 1 && spec_.title) {
        whole_.titles = titles_with_asides(words, words);
        whole_.y.title = {};
        return tells_time() ? time : Text{};
    }
    if (spec_.title) {
        if (marks_name_choices()) whole_.titles = {with_curves(words, time)};
        whole_.titles.push_back(at_time(words));
        whole_.titles.push_back(words);
        return time;
    }
    if (count() > 1) {
        const Text names = both(aside, names_of_choices(Joint::commas), time);
        const bool says_names = !spec_.of.empty();  // of parts, words do not
        whole_.titles = {with_curves(words, says_names ? time : names),
                         with_curves(quantity, names), at_time(quantity)};
    } else {
        whole_.titles = titles_with_asides(words, quantity);
        whole_.y.title = {};
    }
    return {};
}

// The time, unless it is the present of a film and said at a mean, and what a bar counts, in
// smaller letters.
std::vector<plot::Text> HistogramPanel::titles_with_asides(const plot::Text& words,
                                                           const plot::Text& quantity) const {
    const Language language = context_.language();
    const auto aside_of = [&](const std::vector<Text>& parts) {
        Text all{"\u2002"};
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (i > 0) all += ", ";
            all += parts[i];
        }
        for (Text::Piece& piece : all.pieces) {
            piece.markup = "<span size=\"85%\" weight=\"400\">" + piece.markup + "</span>";
            piece.role = Role{Role::Of::muted};
        }
        return all;
    };
    std::vector<Text> time;
    if (tells_time() || count() > 1) time.emplace_back(axes_.time);
    if (axes_.runs > 1) time.emplace_back(words_of_mean(language, static_cast<int>(axes_.runs)));
    std::vector<Text> time_and_height = time;
    time_and_height.emplace_back(height_name());
    std::vector<Text> titles{words + aside_of(time_and_height),
                             quantity + aside_of(time_and_height)};
    if (!time.empty()) titles.push_back(quantity + aside_of(time));
    titles.push_back(quantity);
    return titles;
}

plot::Text HistogramPanel::add_titles_of_runs() {
    const Language language = context_.language();
    const auto both = [&](Phrase phrase, const Text& first, const Text& second) {
        return text_of(language, phrase, {first, second});
    };
    Text words = escape_markup(spec_.title.value_or(say(language, subject_.title)));
    if (!spec_.title && !spec_.of.empty())
        words = both(Phrase{"{} of {}"}, words,
                     escape_markup(name_of(context_.scene, choices_.front().chosen)));
    if (!spec_.title && parts_)
        words = both(apart, words, escape_markup(parts_->names(language).front()));
    const auto ended = [&](Text title) {
        if (axes_.counts_per_cent()) title = both(aside, title, say(language, "per cent"));
        return axes_.time.empty() ? title : both(apart, title, axes_.time);
    };
    const Text quantity = ended(capitalised(say(language, subject_.quantity.word)));
    const Text whole = ended(words), thin = say(language, "thin: equilibrium");
    if (axes_.has_curves())
        whole_.titles = {both(aside, whole, say(language, "thin lines: equilibrium")),
                         both(aside, whole, thin)};
    if (axes_.has_curves() && !spec_.title) whole_.titles.push_back(both(aside, quantity, thin));
    if (!axes_.has_curves() || spec_.title) whole_.titles.push_back(whole);
    whole_.titles.push_back(spec_.title ? words : quantity);
    if (!spec_.title || axes_.time.empty()) return {};
    return axes_.counts_per_cent() ? both(aside, say(language, "per cent"), axes_.time)
                                   : Text(axes_.time);
}

// What a bar counts, with the width of its bin, without which its height has no meaning.
std::string HistogramPanel::height_name() const {
    const bool is_of_one = std::ranges::all_of(
        axes_.series, [](const HistogramSeries& series) { return series.values_each == 1.0; });
    const Language language = context_.language();
    const double width = axes_.bins.width();
    const bool is_plain = width >= 1e-3 && width < 1e5;
    const std::string per = context_.wording().units == UnitSystem::real
                                ? three_digits(context_.wording(), subject_.quantity, width)
                            : is_plain ? localised(language, fmt::format("{:.3g}", width))
                                       : three_digits(language, width);
    if (axes_.counts_per_cent()) return say(language, "% per {}", per);
    return is_of_one ? say(language, "particles per {}", per) : say(language, "values per {}", per);
}

}  // namespace carom
