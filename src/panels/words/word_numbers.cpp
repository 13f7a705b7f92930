#include "panels/words/word_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "panels/registry.h"
#include "physics/units/unit_table.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"
#include "util/text.h"

namespace carom {
namespace {

/// Words, and the time at which they appear.
using WordsTaker = std::function<void(std::string& words, double at)>;

void for_all_words(Scene& scene, const WordsTaker& take) {
    for (Caption& caption : scene.captions) take(caption.words, caption.at);
    for (Callout& callout : scene.film.callouts) take(callout.words, callout.at);
    take(scene.film.end_card, scene.run.until);
    for (PanelSpec& panel : scene.film.panels) {
        const PanelKind& kind = kind_of(panel);
        if (!kind.text) continue;
        std::string words = kind.text(panel);
        take(words, panel.show.from);
        if (words != kind.text(panel)) kind.set_text(panel, std::move(words));
    }
}

void add_requests(const Scene& scene, const std::string& words, double at,
                  std::vector<WordRequest>& requests) {
    for (const std::size_t k : numbers_in(words)) {
        const NumberInWords& number = scene.numbers.at(k);
        if (number.reader) requests.push_back({k, number.at.value_or(at)});
    }
}

// Requests that the same instrument serves share it.
std::vector<PanelSpec> specs_of(const Scene& scene, const std::vector<WordRequest>& requests,
                                std::vector<std::size_t>& instrument) {
    std::vector<PanelSpec> specs;
    std::vector<std::string> names;
    for (const WordRequest& request : requests) {
        const NumberInWords& number = scene.numbers.at(request.number);
        const auto known = std::ranges::find(names, number.name);
        instrument.push_back(static_cast<std::size_t>(known - names.begin()));
        if (known != names.end()) continue;
        names.push_back(number.name);
        specs.push_back(number.reader->instrument);
    }
    return specs;
}

std::string with_digits(double value, int decimals) {
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), std::max(0, decimals));
    const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
    return value < 0.0 && !is_zero ? "\u2212" + digits : digits;
}

}  // namespace

std::vector<WordRequest> requests_of_film(const Scene& scene) {
    std::vector<WordRequest> requests;
    if (scene.numbers.empty()) return requests;
    Scene copy = scene;
    for_all_words(copy, [&](const std::string& words, double at) {
        add_requests(scene, words, at, requests);
    });
    return requests;
}

std::vector<WordRequest> requests_of_figure(const Scene& scene, const FigureSpec& figure) {
    std::vector<WordRequest> requests;
    for (const auto& words : {figure.caption, figure.alt})
        if (words && !figure.times.empty())
            add_requests(scene, *words, figure.times.back(), requests);
    return requests;
}

WordNumbers::WordNumbers(const PanelContext& context, std::vector<WordRequest> requests)
    : scene_(context.scene),
      requests_(std::move(requests)),
      specs_(specs_of(scene_, requests_, instrument_)),
      values_(requests_.size()),
      instruments_(context, specs_) {}

void WordNumbers::see(const FrameInput& input) {
    instruments_.see(input);
    for (std::size_t k = 0; k < requests_.size(); ++k) {
        constexpr double rounding = 1e-12;
        if (values_[k] || input.tick.time < requests_[k].at * (1.0 - rounding)) continue;
        const NumberReader& reader = scene_.numbers.at(requests_[k].number).reader.value();
        values_[k] = instruments_.value(instrument_[k], reader.line, reader.is_result);
    }
}

std::vector<std::string> WordNumbers::texts() const {
    std::vector<std::string> texts(scene_.numbers.size());
    std::vector<Diagnostic> errors;
    for (std::size_t k = 0; k < requests_.size(); ++k) {
        const NumberInWords& number = scene_.numbers.at(requests_[k].number);
        const double value = values_[k].value_or(NAN);
        if (!std::isfinite(value)) {
            Diagnostic& error = errors.emplace_back(number.place);
            error.message =
                fmt::format("`{{{}}}` has no value at time {:g}", number.name, requests_[k].at);
            error.hint =
                "ask for another time, or for another number; a figure of it says why it has none";
        }
        texts[requests_[k].number] =
            number_words(wording_of(scene_), number,
                         instruments_.quantity(instrument_[k], number.reader->is_result), value);
    }
    if (!errors.empty()) throw SceneError(std::move(errors));
    return texts;
}

Scene with_numbers(Scene scene, const std::vector<std::string>& texts) {
    if (texts.empty()) return scene;
    for_all_words(scene, [&](std::string& words, double) {
        words = filled(words, [&](std::size_t number) { return texts.at(number); });
    });
    return scene;
}

Scene with_usual_numbers(Scene scene) {
    if (scene.numbers.empty()) return scene;
    for_all_words(scene, [](std::string& words, double) { words = with_usual_numbers(words); });
    return scene;
}

std::string number_words(const Wording& wording, const NumberInWords& number,
                         const Quantity& quantity, double value) {
    constexpr int usual_digits = 3;
    const Language language = wording.language;
    if (const std::string unit = unit_after_number(wording.units, quantity, value); !unit.empty()) {
        const double factor = shown_unit(quantity, wording.units, value).factor;
        return number_words({language}, number, quantities::number, factor * value) + unit;
    }
    if (number.are_decimals) return localised(language, with_digits(value, number.digits));
    if (quantity.kind == Quantity::Kind::count && value == std::floor(value) &&
        std::abs(value) < 1e15)
        return grouped(static_cast<std::int64_t>(value));
    if (number.digits == usual_digits || !std::isfinite(value) || value == 0.0)
        return three_digits(language, value);
    const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return localised(language, with_digits(value, number.digits - before));
}

}  // namespace carom
