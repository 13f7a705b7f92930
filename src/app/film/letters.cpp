#include "app/film/letters.h"

#include <fmt/format.h>

#include <vector>

#include "draw/text.h"
#include "util/diagnostics.h"
#include "util/formula/formula.h"

namespace carom {
namespace {

// Without formulae, whose letters there are.
std::string plain(const std::string& text) {
    std::string words;
    for (const formula::Span& span : formula::spans_of(text))
        if (!span.is_formula) words += span.text;
    return words;
}

// All words that are drawn as they are written in the scene.
std::string words_of(const Scene& scene) {
    std::string words = scene.title + scene.subtitle;
    for (const Species& species : scene.gas.species) words += species.name;
    for (const SpeciesLook& look : scene.looks) words += look.label;
    for (const PanelSpec& panel : scene.film.panels)
        words += panel.title.value_or("") + plain(panel.words);
    for (const Callout& callout : scene.film.callouts) words += plain(callout.words);
    for (const Caption& caption : scene.captions) words += plain(caption.words);
    words += plain(scene.film.end_card);
    if (scene.film.beside) words += scene.film.beside->own_label + scene.film.beside->label;
    for (const FigureSpec& figure : scene.figures) {
        words += figure.panel.title.value_or("") + plain(figure.panel.words);
        for (const ComparedRun& run : figure.compare) words += run.label;
    }
    std::erase(words, '\n');  // parts paragraphs, and is no letter
    return words;
}

}  // namespace

void require_letters(const Scene& scene) {
    require_font();
    std::vector<std::string> missing = missing_letters(words_of(scene));
    if (missing.empty()) return;
    constexpr std::size_t most = 12;
    const bool more = missing.size() > most;
    if (more) missing.resize(most);
    throw SystemError(fmt::format(
        "{}: no font on this machine has {}{}: install one (fonts-noto-cjk has the letters of "
        "Chinese, Japanese and Korean, fonts-noto-core those of most other scripts)",
        scene.source.path, fmt::join(missing, " "), more ? " and more letters" : ""));
}

}  // namespace carom
