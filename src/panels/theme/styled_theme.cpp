// The themes of pictures: carom's own, and those that styles make of them.
#include <algorithm>
#include <array>
#include <list>
#include <mutex>
#include <utility>

#include "draw/palette.h"
#include "panels/panel.h"
#include "scene/film.h"
#include "scene/style/style.h"

namespace carom {
namespace {

ThemeKind theme_kind(ThemeName name) {
    if (name == ThemeName::light) return ThemeKind::light;
    return name == ThemeName::print ? ThemeKind::print : ThemeKind::dark;
}

// A theme of a style or with colours of runs, and all that it refers to. It is not moved.
struct StyledTheme {
    ThemeName name;
    bool has_colors;
    StyleFonts written_fonts;
    StyleColors written_colors;
    RunColors written_runs;
    FontFamilies fonts = {};
    std::vector<Color> series = {}, ramp = {};
    std::vector<std::optional<Color>> runs = {};
    Theme theme = {};

    bool is_of(ThemeName other, bool with_colors, const Style& style, const RunColors& of) const {
        return name == other && has_colors == with_colors && written_fonts == style.fonts &&
               written_runs == of && (!has_colors || written_colors == style.colors);
    }
};

const std::vector<std::pair<const char*, Color Theme::*>>& theme_roles() {
    static const std::vector<std::pair<const char*, Color Theme::*>> all{
        {"page", &Theme::page},
        {"ground", &Theme::ground},
        {"ink", &Theme::ink},
        {"second", &Theme::second},
        {"muted", &Theme::muted},
        {"grid", &Theme::grid},
        {"theory", &Theme::accent},
        {"bar", &Theme::bar},
        {"wall", &Theme::wall},
        {"trail", &Theme::trail},
        {"highlight", &Theme::highlight}};
    return all;
}

// A series that is shorter than that of the palette is continued by those of its colours that are
// farthest from all others.
std::vector<Color> whole_series(std::vector<Color> series, const Theme& base) {
    constexpr std::size_t enough = 6;
    for (const Color color : kind_colors_beside(std::vector(series), base)) {
        if (series.size() >= enough) break;
        series.push_back(color);
    }
    return series;
}

void set_colors(StyledTheme& styled) {
    const StyleColors& written = styled.written_colors;
    const auto given = [&](const char* key) {
        const auto found = written.of.find(key);
        return found == written.of.end() ? std::optional<Color>{} : parse_color(found->second);
    };
    Theme& theme = styled.theme;
    // What is not given follows what is nearest to it.
    if (const auto page = given("page")) theme.ground = *page;
    if (const auto ink = given("ink")) {
        theme.second = mix(*ink, given("page").value_or(theme.page), 0.15);
        theme.muted = theme.wall = mix(*ink, given("page").value_or(theme.page), 0.3);
        theme.bar = mix(*ink, given("page").value_or(theme.page), 0.4);
    }
    if (const auto muted = given("muted")) theme.trail = *muted;
    for (const auto& [key, role] : theme_roles())
        if (const auto color = given(key)) theme.*role = *color;
    std::vector<Color> series;
    for (const std::string& hex : written.series) series.push_back(parse_color(hex).value());
    if (!series.empty()) styled.series = whole_series(std::move(series), theme);
    if (const auto slow = given("slow"), fast = given("fast"); slow && fast)
        styled.ramp = {*slow, *fast};
    theme.series = styled.series;
    theme.ramp = styled.ramp;
}

void set_fonts(StyledTheme& styled) {
    const auto& [text, numbers, formulas] = styled.written_fonts;
    if (text.empty() && numbers.empty() && formulas.empty()) return;
    styled.fonts = {text, numbers.empty() ? text : numbers, formulas.empty() ? text : formulas};
    styled.theme.fonts = &styled.fonts;
}

void set_runs(StyledTheme& styled) {
    for (const std::optional<std::string>& hex : styled.written_runs)
        styled.runs.push_back(hex ? parse_color(*hex) : std::nullopt);
    styled.theme.runs = styled.runs;
}

const Theme& styled_theme(ThemeName name, const Style& style, const RunColors& runs) {
    static std::mutex mutex;
    static std::list<StyledTheme>& all = *new std::list<StyledTheme>;
    const std::scoped_lock lock(mutex);
    const bool has_colors = name == style.base;
    for (const StyledTheme& one : all)
        if (one.is_of(name, has_colors, style, runs)) return one.theme;
    StyledTheme& made =
        all.emplace_back(StyledTheme{name, has_colors, style.fonts, style.colors, runs});
    made.theme = theme(theme_kind(name));
    if (has_colors) set_colors(made);
    set_fonts(made);
    set_runs(made);
    return made.theme;
}

}  // namespace

const Theme& theme_of(ThemeName name, const Style* style, const RunColors& runs) {
    const bool has_runs =
        std::ranges::any_of(runs, [](const auto& one) { return one.has_value(); });
    if (style == nullptr && !has_runs) return theme(theme_kind(name));
    return styled_theme(name, style != nullptr ? *style : Style{}, has_runs ? runs : RunColors{});
}

const Theme& theme_of(const Film& film, ThemeName name) {
    return theme_of(name, film.style.get(), film.runs.colors());
}

const Theme& theme_of(const Film& film) { return theme_of(film, film.theme); }

const Theme& theme_of(const FigureSpec& figure) {
    RunColors colors;
    for (const ComparedRun& run : figure.compare) colors.push_back(run.color);
    return theme_of(figure.theme, figure.style.get(), colors);
}

std::array<const Theme*, 3> themes_of(const Film& film) {
    return {&theme_of(film, ThemeName::light), &theme_of(film, ThemeName::dark),
            &theme_of(film, ThemeName::print)};
}

}  // namespace carom
