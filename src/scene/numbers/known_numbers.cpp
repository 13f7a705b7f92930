#include "scene/numbers/known_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "scene/keys/binding.h"
#include "scene/reading/panel_reading.h"
#include "scene/scene.h"
#include "scene/yaml/scalar.h"
#include "scene/yaml/yaml.h"
#include "util/text.h"

namespace carom {
namespace {

/// The name of a number: a quantity, of particles or of a surface if it says so. "light.speed" and
/// "speed.light" are the same.
struct NumberName {
    std::string quantity, of;
};

std::vector<NumberName> names_in(const std::string& name) {
    std::vector<NumberName> all{{name, ""}};
    if (const std::size_t last = name.rfind('.'); last != std::string::npos)
        all.push_back({name.substr(last + 1), name.substr(0, last)});
    if (const std::size_t first = name.find('.'); first != std::string::npos)
        all.push_back({name.substr(0, first), name.substr(first + 1)});
    return all;
}

std::string in_yaml(std::string_view text) {
    std::string all = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') all += '\\';
        all += letter;
    }
    return all + '"';
}

bool has_key(const PanelKind& kind, std::string_view name) {
    return std::ranges::any_of(kind.keys, [&](const auto& key) { return key.key.name == name; });
}

bool is_species(const Scene& scene, const std::string& name) {
    return std::ranges::find(scene.gas.species, name, &Species::name) != scene.gas.species.end();
}

bool is_surface(const Scene& scene, const std::string& name) {
    const std::vector<std::string> names = scene.gas.box.surfaces.names();
    const auto found = std::ranges::find(names, name);
    return found != names.end() &&
           scene.gas.box.has_surface(static_cast<std::size_t>(found - names.begin()));
}

// The options of an instrument that reads a number of these particles or this surface, as in a
// scene; none if it reads no such number.
std::optional<std::string> options_for(const Scene& scene, const PanelKind& kind,
                                       const AskedNumber& asked, const std::string& of) {
    const std::string options = asked.options.empty() ? "" : ", " + asked.options;
    const bool is_one_of_lines = asked.is_by_line && is_species(scene, of);
    if (is_one_of_lines || (of.empty() && !asked.is_by_line)) return options;
    if (has_key(kind, "surfaces") && is_surface(scene, of))
        return fmt::format("{}, surfaces: [{}]", options, in_yaml(of));
    const bool are_particles = is_species(scene, of) || parse_number(of);
    if (kind.can(Ability::of) && are_particles)
        return fmt::format("{}, of: {}", options, is_species(scene, of) ? in_yaml(of) : of);
    return std::nullopt;
}

/// What reads a number, or why nothing does.
struct Found {
    std::optional<NumberReader> reader = {};
    std::string problem = {};
};

Found instrument_of(const Scene& scene, PanelKinds kinds, const PanelKind& kind,
                    const AskedNumber& asked, const std::string& of) {
    const auto options = options_for(scene, kind, asked, of);
    if (!options) return {};
    const Source source{.name = "", .text = fmt::format("[{{kind: {}{}}}]", kind.name, *options)};
    Errors errors;
    std::vector<NumberInWords> none;
    Reading reading{errors, scene.gas, scene.run, none, scene.units};
    const auto node = read_yaml(source, errors);
    std::optional<std::vector<PanelSpec>> specs;
    if (node) specs = measure_notation(kinds).read(*node, reading);
    try {
        errors.throw_if_any();
    } catch (const SceneError& error) {
        return {{}, error.diagnostics().front().message};
    }
    return {NumberReader{specs->front(), asked.is_result, asked.is_by_line ? of : ""}};
}

Found reader_of(const Scene& scene, PanelKinds kinds, const std::string& name) {
    for (const PanelSpec& spec : scene.measure)
        if (spec.title == name) return {NumberReader{spec}};
    Found last;
    for (const auto& [quantity, of] : names_in(name))
        for (const PanelKind& kind : kinds)
            for (const AskedNumber& asked : kind.asked) {
                if (asked.name != quantity) continue;
                Found found = instrument_of(scene, kinds, kind, asked, of);
                if (found.reader) return found;
                if (!found.problem.empty()) last = std::move(found);
            }
    return last;
}

// Whether the words of a figure mean what it shows itself.
bool is_of_figure(const FigureSpec& figure, PanelKinds kinds, const std::string& name) {
    const PanelKind* kind = kind_of(kinds, figure.panel.kind);
    return kind != nullptr && std::ranges::any_of(kind->numbers, [&](const std::string& own) {
               return name == own || name.ends_with("." + own);
           });
}

bool shows_several_runs(const FigureSpec& figure) {
    return !figure.compare.empty() || figure.panel.seeds > 1 || sweep_of(figure) != nullptr;
}

// What is wrong with a number in the words of a figure; empty: nothing.
std::string problem_in_figure(const FigureSpec& figure, const NumberInWords& number, bool is_own) {
    if (shows_several_runs(figure) && !is_own)
        return "this figure shows several runs, and each has numbers of its own";
    if (!figure.compare.empty() && is_own)
        return "this figure compares runs, and each has numbers of its own";
    if (is_own && number.at) return "what a figure shows itself has no `at`: it is of its time";
    return "";
}

Diagnostic error_at(const NumberInWords& number, std::string message, std::string hint) {
    Diagnostic error = number.place;
    error.message = std::move(message);
    error.hint = std::move(hint);
    return error;
}

std::vector<std::string> names_of(const std::vector<KnownNumber>& numbers) {
    std::vector<std::string> names;
    for (const KnownNumber& number : numbers) names.push_back(number.name);
    return names;
}

}  // namespace

std::vector<Diagnostic> find_instruments(Scene& scene, PanelKinds kinds) {
    std::vector<Diagnostic> errors;
    std::vector<bool> is_done(scene.numbers.size(), false);
    for (const FigureSpec& figure : scene.figures) {
        const PanelKind* kind = kind_of(kinds, figure.panel.kind);
        for (const std::size_t k : numbers_in(kind->text ? kind->text(figure.panel) : "")) {
            is_done[k] = true;
            errors.push_back(error_at(scene.numbers[k],
                                      fmt::format("`{{{}}}`: the text that a figure draws has no "
                                                  "numbers",
                                                  scene.numbers[k].name),
                                      "put it into its `caption`"));
        }
        for (const auto& words : {figure.caption, figure.alt})
            for (const std::size_t k : numbers_in(words.value_or(""))) {
                const NumberInWords& number = scene.numbers.at(k);
                is_done[k] = is_of_figure(figure, kinds, number.name);
                const std::string problem = problem_in_figure(figure, number, is_done[k]);
                if (problem.empty()) continue;
                is_done[k] = true;
                errors.push_back(error_at(number, fmt::format("`{{{}}}`: {}", number.name, problem),
                                          "leave it out"));
            }
    }
    for (std::size_t k = 0; k < scene.numbers.size(); ++k) {
        NumberInWords& number = scene.numbers[k];
        if (is_done[k]) continue;
        if (number.at && (*number.at < 0.0 || *number.at > scene.run.until))
            errors.push_back(
                error_at(number,
                         fmt::format("`{{{} at {:g}}}` asks for a time outside of the run",
                                     number.name, *number.at),
                         fmt::format("give a time from 0 to {:g}", scene.run.until)));
        Found found = reader_of(scene, kinds, number.name);
        if (found.reader) {
            number.reader = std::move(found.reader);
            continue;
        }
        const std::string why = found.problem.empty() ? "" : ": " + found.problem;
        errors.push_back(error_at(
            number, fmt::format("there is no number `{}`{}", number.name, why),
            spelling_hint(number.name, names_of(known_numbers(scene, kinds)),
                          "`carom check --numbers` lists those of a scene; a brace as it is, is "
                          "written twice: `{{`")));
    }
    return errors;
}

std::vector<KnownNumber> known_numbers(const Scene& scene, PanelKinds kinds) {
    std::vector<KnownNumber> all;
    std::vector<std::string> owners{""};
    for (const Species& species : scene.gas.species)
        if (scene.gas.species.size() > 1) owners.push_back(species.name);
    const std::vector<std::string> surfaces = scene.gas.box.surfaces.names();
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        if (scene.gas.box.has_surface(k)) owners.push_back(surfaces[k]);
    for (const PanelSpec& spec : scene.measure)
        if (spec.title)
            all.push_back({*spec.title, fmt::format("the instrument of kind `{}`", spec.kind)});
    const auto number_of = [&](const AskedNumber& asked, const std::string& owner) -> KnownNumber {
        if (owner.empty()) return {asked.name, asked.meaning};
        if (is_species(scene, owner))
            return {owner + "." + asked.name, asked.meaning + ", of " + owner};
        return {asked.name + "." + owner, asked.meaning + ", at " + owner};
    };
    for (const std::string& owner : owners)
        for (const PanelKind& kind : kinds)
            for (const AskedNumber& asked : kind.asked)
                if (instrument_of(scene, kinds, kind, asked, owner).reader)
                    all.push_back(number_of(asked, owner));
    return all;
}

std::vector<KnownNumber> known_numbers(const FigureSpec& figure, PanelKinds kinds) {
    std::vector<KnownNumber> all;
    const PanelKind* kind = kind_of(kinds, figure.panel.kind);
    if (kind == nullptr || !figure.compare.empty()) return all;
    for (const std::string& name : kind->numbers)
        all.push_back({name, fmt::format("what the figure `{}` shows", figure.name)});
    return all;
}

}  // namespace carom
