#include "panels/words/text_panel.h"

#include <algorithm>
#include <array>

#include "draw/formula/words.h"
#include "panels/layout.h"
#include "panels/registry.h"
#include "scene/limits.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"
#include "util/formula/formula.h"

namespace carom {
namespace {

constexpr std::array steps{2.0, 1.7, 1.45, 1.2, 1.0};  // units
constexpr double line_height_in_sizes = 1.4, paragraph_gap = 0.5;
constexpr double title_height = 2.4;  // units
constexpr std::size_t most_lines = 1000;

TextStyle style_of(const SetWords& set) {
    return {.size = set.size, .weight = 400, .color = {}, .tabular = false, .fonts = set.fonts};
}

std::vector<std::string> paragraphs(const std::string& words) {
    std::vector<std::string> found;
    std::size_t begin = 0;
    while (begin <= words.size()) {
        const std::size_t end = std::min(words.find('\n', begin), words.size());
        found.push_back(words.substr(begin, end - begin));
        begin = end + 1;
    }
    return found;
}

// Replaces line breaks within formulae by spaces; positions in the text do not change.
std::string with_whole_formulas(std::string words) {
    for (const formula::Span& span : formula::spans_of(words)) {
        const auto begin = words.begin() + static_cast<std::ptrdiff_t>(span.at);
        if (span.is_formula) std::replace(begin, begin + std::ssize(span.text), '\n', ' ');
    }
    return words;
}

SetWords set_at(const std::string& words, double width, SetWords set) {
    TextStyle style = style_of(set);
    style.max_width = width;
    for (const std::string& paragraph : paragraphs(words)) {
        if (paragraph.empty()) set.lines.emplace_back();
        for (std::string& line : wrapped_words(paragraph, style, most_lines))
            set.lines.push_back(std::move(line));
    }
    return set;
}

bool fits(const SetWords& set, double width, double height) {
    return height_of(set) <= height && std::ranges::all_of(set.lines, [&](const std::string& line) {
               return measure_words(line, style_of(set)).width <= width;
           });
}

LineHeight line_height(const std::string& line, const SetWords& set) {
    if (line.empty()) return {0.0, paragraph_gap * set.size};
    return line_height_of(line, style_of(set), line_height_in_sizes);
}

// Whether a line ends where the words have no space.
bool breaks_a_word(const std::string& words, const SetWords& set) {
    std::size_t at = 0;
    for (const std::string& line : set.lines) {
        at += line.size();
        if (at < words.size() && words[at] != ' ' && words[at] != '\n') return true;
        while (at < words.size() && words[at] == ' ') ++at;
        if (at < words.size() && words[at] == '\n') ++at;
    }
    return false;
}

Rect below_title(const Rect& area, double unit, bool has_title) {
    const double taken = has_title ? title_height * unit : 0.0;
    return {area.x, area.y + taken, area.width, area.height - taken};
}

class TextPanel : public Panel {
  public:
    explicit TextPanel(const PanelSpec& spec) : spec_(spec) {}

    std::shared_ptr<const PanelState> state(const FrameInput&) override {
        return std::make_shared<PanelState>();
    }

    void draw_ground(Canvas& canvas, const DrawContext& dc) const override {
        if (spec_.title) draw_panel_title(canvas, dc, escape_markup(*spec_.title));
        const Rect area = below_title(dc.area, dc.unit, spec_.title.has_value());
        const auto set = set_words(spec_.options.as<TextOptions>().words, area.width, area.height,
                                   dc.unit, dc.theme.fonts);
        if (!set) return;  // problem_of_words() has seen to it
        TextStyle style = style_of(*set);
        style.color = dc.theme.ink;
        double top = area.y;
        for (const std::string& line : set->lines) {
            const LineHeight height = line_height(line, *set);
            style.align = is_formula_alone(line) ? Align::center : Align::left;
            const double x = is_formula_alone(line) ? area.x + 0.5 * area.width : area.x;
            if (!line.empty()) draw_words(canvas, {x, top + height.above}, line, style);
            top += height.all;
        }
    }

    void archive(Archive&) override {}
    void archive_progress(Archive&) override {}
    void draw(Canvas&, const DrawContext&, const PanelState&) const override {}
    Table table(const PanelState&, const Theme&) const override { return {}; }

  private:
    PanelSpec spec_;
};

}  // namespace

double height_of(const SetWords& set) {
    double height = 0.0;
    for (const std::string& line : set.lines) height += line_height(line, set).all;
    return height;
}

// A smaller size is preferred to breaking a word, except in scripts without spaces between words.
std::optional<SetWords> set_words(const std::string& text, double width, double height, double unit,
                                  const FontFamilies* fonts) {
    const std::string words = with_whole_formulas(text);
    for (const bool whole : {true, false})
        for (const double step : steps) {
            SetWords set = set_at(words, width, {{}, step * unit, fonts});
            if (whole && breaks_a_word(words, set)) continue;
            if (fits(set, width, height)) return set;
        }
    return std::nullopt;
}

std::optional<Diagnostic> problem_of_words(const PanelSpec& spec, const Rect& place, double unit,
                                           const FontFamilies* fonts) {
    const auto* text = spec.options.find<TextOptions>();
    if (text == nullptr) return std::nullopt;
    const Rect area = below_title(place, unit, spec.title.has_value());
    if (set_words(text->words, area.width, area.height, unit, fonts)) return std::nullopt;
    Diagnostic problem = spec.place;
    problem.message = "these `words` do not fit into the panel's place at any size";
    return problem;
}

void refuse_long_words(const Scene& scene, const std::vector<Slot>& places) {
    const Grid grid(scene.film);
    std::vector<Diagnostic> errors;
    for (std::size_t i = 0; i < std::min(places.size(), scene.film.panels.size()); ++i) {
        const PanelSpec& spec = scene.film.panels[i];
        auto problem =
            problem_of_words(spec, grid.place(places[i]), grid.unit(), theme_of(scene.film).fonts);
        if (!problem) continue;
        problem->hint =
            "write fewer or shorter words, show fewer panels, or take a template with larger "
            "places";
        errors.push_back(std::move(*problem));
    }
    if (!errors.empty()) throw SceneError(std::move(errors));
}

void refuse_long_words(const Scene& scene) {
    const LayoutSpec& layout = scene.film.layout;
    std::vector<Slot> places = shared_slots(layout.panels, scene.film.panels.size());
    const Grid grid(scene.film, layout);
    for (Slot& place : places) place = on_plate(place, layout, grid);
    refuse_long_words(scene, places);
}

namespace {

std::vector<Binding<TextOptions>> text_keys() {
    return {
        bind_key("words", &TextOptions::words, with_formulas(lines(1, most_words_letters)),
                 "The text of the panel; an empty line separates paragraphs. Formulae are written "
                 "between `$` signs; one that is a paragraph of its own is large.")
            .default_text("required for a text")};
}

void check_text(PanelSpec&, const Node& node, Reading& reading) {
    if (!node.is_mapping() || find(node, "words") == nullptr)
        reading.errors.add(node, "a panel of kind `text` needs `words`",
                           "for instance {kind: text, words: \"Watch the red disk.\"}");
}

std::unique_ptr<Panel> make_text(const PanelContext&, const PanelSpec& spec) {
    return std::make_unique<TextPanel>(spec);
}

}  // namespace

PanelKind text_kind() {
    return {.name = "text",
            .words = Phrase{"text"},
            .shows = "Your own text, with formulae.",
            .make = make_text,
            .keys = option_keys(text_keys()),
            .rule = check_text,
            .text = [](const PanelSpec& panel) { return panel.options.as<TextOptions>().words; },
            .set_text =
                [](PanelSpec& panel, std::string words) {
                    panel.options.change<TextOptions>().words = std::move(words);
                },
            .shows_run = false,
            .has_plot = false};
}

}  // namespace carom
