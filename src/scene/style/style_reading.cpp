#include "scene/style/style_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "physics/gas.h"
#include "physics/run.h"
#include "scene/figure_spec.h"
#include "scene/keys/check.h"
#include "scene/reading/figure_reading.h"
#include "scene/reading/panel_reading.h"
#include "scene/yaml/file_text.h"
#include "scene/yaml/yaml.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr Range text_of_film{0.5, {2.0}}, dots_to_the_inch{36.0, {1200.0}};
constexpr Range text_of_figure{4.0, {72.0}};  // points

struct FigureSizes {
    std::optional<double> width;
    std::optional<double> text;
};

struct FilmSizes {
    double text = 1.0;
};

struct Sizes {
    FigureSizes figure;
    FilmSizes film;
};

Notation<Sizes> sizes_notation() {
    const KeyTable<FigureSizes> figure{
        .name = "`figure` of a style's sizes",
        .keys = {bind_key("width", &FigureSizes::width, width_notation(),
                          "The width of figures without `size` or `width`.")
                     .default_text("that of a text column, 8.9 cm"),
                 bind_key("text", &FigureSizes::text, length(text_of_figure, LengthUnit::pt),
                          "The size of the smallest text of figures on paper; all else that is no "
                          "data grows with it.")
                     .default_text("6.9 pt")}};
    const KeyTable<FilmSizes> film{
        .name = "`film` of a style's sizes",
        .keys = {bind_key("text", &FilmSizes::text, number(text_of_film),
                          "The size of the text of films and of figures on slides, relative to the "
                          "usual one. The places of a layout stay as they are.")}};
    return mapping(KeyTable<Sizes>{
        .name = "`sizes` of a style",
        .keys = {bind_key("figure", &Sizes::figure, mapping(figure), "Those of figures.")
                     .default_text("the usual ones"),
                 bind_key("film", &Sizes::film, mapping(film), "Those of films.")
                     .default_text("the usual ones")}});
}

Binding<Style> color_key(const std::string& name, const std::string& meaning) {
    const auto fill = [name](Style& style, const Placed<std::string>& hex) {
        style.colors.of[name] = hex.value;
        style.places[name] = place_of(*hex.node);
    };
    return bind_with<Style>(name, fill, placed(color()), meaning);
}

Binding<Style> series_key() {
    const auto fill = [](Style& style, const std::vector<Placed<std::string>>& all) {
        for (const auto& [hex, node] : all) {
            style.places[fmt::format("series.{}", style.colors.series.size())] = place_of(*node);
            style.colors.series.push_back(hex);
        }
    };
    constexpr Limit most{12, "colours of a series"};
    return bind_with<Style>(
               "series", fill, list_of(placed(color()), 1, most, "a list of colours"),
               "The colours of species, of choices of particles and of compared runs, "
               "in this order; a list of fewer than six is continued by colours of the "
               "base.")
        .default_text("the base's");
}

void check_ramp(Style& style, const Node& node, Reading& reading) {
    for (const auto& [one, other] : {std::pair{"slow", "fast"}, {"fast", "slow"}})
        if (style.colors.of.contains(one) && find(node, other) == nullptr)
            reading.errors.add(
                *find(node, one),
                fmt::format("`{}` needs `{}`, the other end of the scale", one, other),
                "give both");
}

Notation<Style> colors_notation() {
    const std::vector<std::pair<const char*, const char*>> roles{
        {"page", "Behind everything."},
        {"ground", "Inside the box."},
        {"ink", "Titles, numbers, the ring of a chosen particle."},
        {"second", "Numbers at axes."},
        {"muted", "Subtitles, labels and axes."},
        {"grid", "Thin lines across plots."},
        {"theory", "The curves and levels of theory."},
        {"bar", "Bars of histograms, and single lines."},
        {"wall", "The line around the gas."},
        {"trail", "Trails, before they fade."},
        {"highlight", "What the viewer should look at: flashes, a reversal, slow motion."},
        {"slow", "The colour of slow disks, in scenes that name no `palette`."},
        {"fast", "That of fast disks; those between are mixed of both."}};
    const std::map<std::string, std::string> defaults{
        {"ground", "`page`, if it is given, or the base's"},
        {"second", "`ink`, a little paler, if it is given, or the base's"},
        {"muted", "`ink`, paler, if it is given, or the base's"},
        {"wall", "`ink`, paler, if it is given, or the base's"},
        {"bar", "`ink`, paler, if it is given, or the base's"},
        {"trail", "`muted`, if it is given, or the base's"}};
    KeyTable<Style> table{.name = "`colors` of a style", .keys = {}, .rule = check_ramp};
    for (const auto& [name, meaning] : roles) {
        const auto found = defaults.find(name);
        table.keys.push_back(
            color_key(name, meaning)
                .default_text(found == defaults.end() ? "the base's" : found->second));
        if (std::string_view(name) == "highlight") table.keys.push_back(series_key());
    }
    const auto find_key = [&](std::string_view name) -> Key& {
        return std::ranges::find(table.keys, name,
                                 [](const auto& one) -> const std::string& { return one.key.name; })
            ->key;
    };
    find_key("page").tried = {"background", "paper", "canvas"};
    find_key("ink").tried = {"text", "foreground", "font"};
    find_key("theory").tried = {"accent", "curve"};
    find_key("series").tried = {"palette", "species", "colors", "cycle"};
    return mapping(std::move(table));
}

struct FigureKeys {
    std::vector<std::string> formats;
    std::optional<ThemeName> theme;
    std::optional<double> dots;
};

Notation<FigureKeys> figure_keys_notation() {
    return mapping(KeyTable<FigureKeys>{
        .name = "`figures` of a style",
        .keys = {bind_key("format", &FigureKeys::formats, figure_formats_notation(),
                          "The file formats of figures.")
                     .tried_as({"formats"})
                     .default_text("all"),
                 bind_key("theme", &FigureKeys::theme, theme_notation(),
                          "The theme of figures; where it is not the base, only fonts and sizes "
                          "are the style's.")
                     .default_text("the base"),
                 bind_key("dpi", &FigureKeys::dots, number(dots_to_the_inch),
                          "The resolution of figures that are pixels, in dots to the inch.")
                     .tried_as({"resolution", "dots"})
                     .default_text("300, on slides 144")}});
}

Binding<Style> font_key(const std::string& name, std::string StyleFonts::*font,
                        const std::string& meaning, const std::string& usual) {
    const auto fill = [name, font](Style& style, const Placed<std::string>& family) {
        style.fonts.*font = family.value;
        style.places[name] = place_of(*family.node);
    };
    return bind_with<Style>(name, fill, placed(text(1, most_title_letters)), meaning)
        .default_text(usual);
}

KeyTable<Style> new_table() {
    const auto sizes = [](Style& style, const Sizes& read) {
        style.figure_width = read.figure.width;
        style.figure_text = read.figure.text;
        style.film_text = read.film.text;
    };
    const auto colors = [](Style& style, const Style& read) {
        style.colors = read.colors;
        style.places.insert(read.places.begin(), read.places.end());
    };
    const auto figures = [](Style& style, const FigureKeys& keys) {
        style.figure_formats = keys.formats;
        style.figure_theme = keys.theme;
        style.dots = keys.dots;
    };
    return {
        .name = "a style",
        .keys = {
            bind_key("base", &Style::base, theme_notation(),
                     "The theme whose colours it changes. Pictures of the scene that give no "
                     "other have this theme."),
            font_key("font", &StyleFonts::text,
                     "The family of fonts of all text, as `fc-list : family` names it.", "Inter")
                .tried_as({"fonts", "family", "font_family", "typeface"}),
            font_key("numbers", &StyleFonts::numbers,
                     "The family of numbers: at axes, on dials and monitors.", "that of `font`"),
            font_key("formulas", &StyleFonts::formulas, "The family of formulae.",
                     "that of `font`"),
            bind_with<Style>("sizes", sizes, sizes_notation(), "Sizes of text and of figures.")
                .default_text("the usual ones"),
            bind_with<Style>("colors", colors, colors_notation(), "Colours by what they mean.")
                .tried_as({"colours", "palette"})
                .default_text("the base's"),
            bind_with<Style>("figures", figures, figure_keys_notation(), "Defaults of figures.")
                .default_text("those of figures without a style")}};
}

// Debian packages of families that shipped styles name.
const std::map<std::string, std::string>& packages() {
    static const std::map<std::string, std::string> all{{"Inter", "fonts-inter"},
                                                        {"Latin Modern Roman", "fonts-lmodern"},
                                                        {"Latin Modern Sans", "fonts-lmodern"}};
    return all;
}

// The name of the family as the machine has it.
std::optional<std::string> installed(const std::string& family,
                                     const std::vector<std::string>& families) {
    const auto found = std::ranges::find_if(
        families, [&](const std::string& one) { return upper_case(one) == upper_case(family); });
    return found == families.end() ? std::nullopt : std::optional(*found);
}

std::string hint_for_font(const std::string& family, const std::vector<std::string>& families) {
    if (const auto found = packages().find(family); found != packages().end())
        return fmt::format("install the Debian package {}", found->second);
    if (const auto near = nearest_spelling(family, families))
        return fmt::format("did you mean `{}`?", *near);
    // Of those that share the first word, or else the usual one.
    const std::string first = upper_case(family.substr(0, family.find(' ')));
    const auto like = std::ranges::find_if(families, [&](const std::string& one) {
        return upper_case(one.substr(0, one.find(' '))) == first;
    });
    return fmt::format("the nearest that is there is `{}`; `fc-list : family` lists all",
                       like != families.end() ? *like : "Inter");
}

void check_fonts(const Node& root, const std::vector<std::string>& families, Style& style,
                 Errors& errors) {
    for (const auto& [key, font] : {std::pair{"font", &StyleFonts::text},
                                    {"numbers", &StyleFonts::numbers},
                                    {"formulas", &StyleFonts::formulas}}) {
        std::string& family = style.fonts.*font;
        if (family.empty()) continue;
        if (const auto found = installed(family, families))
            family = *found;
        else
            errors.add(*given(root, key),
                       fmt::format("this machine has no font {}", in_quotes(family)),
                       hint_for_font(family, families));
    }
}

}  // namespace

const FixedTable<Style>& style_table() {
    static const auto& table = *new FixedTable<Style>(new_table());
    return table;
}

bool is_style(const std::filesystem::path& path) {
    Errors errors;
    Source source{.name = path.string()};
    const auto text = file_text(path, source, errors);
    // Searching for a key of scenes is much faster than parsing the file as YAML.
    if (!text || text->find("gas") != text->npos) return false;
    source.text = *text;
    const auto root = read_yaml(source, errors);
    const Section& section = style_table().section();
    return root && root->is_mapping() && !root->keys.empty() &&
           std::ranges::all_of(root->keys, [&](const Node& key) {
               return section.index(key.text) < section.keys.size();
           });
}

std::shared_ptr<const Style> read_style(Node& root, const std::string& path,
                                        const std::function<std::vector<std::string>()>& families,
                                        Errors& errors) {
    if (!root.is_mapping()) {
        errors.add(root,
                   "expected a style (a mapping with `colors` or `font`), found " + described(root),
                   "see templates/styles/ of carom");
        return nullptr;
    }
    check_mapping(root, style_table().section(), errors);
    const auto style = std::make_shared<Style>();
    const Gas no_gas;
    const Run no_run;
    std::vector<NumberInWords> no_numbers;
    Reading reading{errors, no_gas, no_run, no_numbers};
    style_table().read(root, *style, reading);
    if (style->fonts != StyleFonts{} && families) check_fonts(root, families(), *style, errors);
    style->path = path;
    return style;
}

void take_style(FigureSpec& figure, const Node& mapping,
                const std::shared_ptr<const Style>& style) {
    if (style == nullptr) return;
    figure.style = style;
    if (find(mapping, "theme") == nullptr) figure.theme = style->figure_theme.value_or(style->base);
    const bool has_size = find(mapping, "size") != nullptr || find(mapping, "width") != nullptr;
    if (!has_size && style->figure_width) figure.width = *style->figure_width;
}

}  // namespace carom
