#include "app/check/check_facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/check/cut_distributions.h"
#include "app/check/figure_facts.h"
#include "app/check/theory_facts.h"
#include "app/command.h"
#include "physics/placement/draws.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/law.h"
#include "physics/units/gas_table.h"
#include "physics/vec.h"
#include "runs/number_json.h"
#include "scene/describe.h"
#include "scene/words.h"
#include "util/fingerprint.h"
#include "util/joined.h"
#include "util/overloaded.h"
#include "util/text.h"
#include "works/source_fingerprint.h"

namespace carom {
namespace {

std::string_view side_word(const Box& box, std::size_t side) {
    using Word = std::string_view;
    const Word plain = word_of(box.walls[side / 2]);
    return std::visit(
        Overloaded{
            [&](const Reflecting&) { return plain; }, [](const Bath&) { return Word("bath"); },
            [](const Driven&) { return Word("driven"); },
            [](const Piston&) { return Word("piston"); }, [&](const Membrane&) { return plain; },
            [](const Diffuse&) { return Word("diffuse"); }},  // only partitions are membranes
        box.surfaces.sides[side]);
}

Fact box_fact(const Box& box, UnitSystem units) {
    const bool across = box.is_periodic(0), up = box.is_periodic(1);
    const auto length = [&](int axis) { return Amount{box.size[axis], quantities::length, units}; };
    const auto words_of_length = [&](int axis) {
        return number_words(units, quantities::length, box.size[axis]);
    };
    Json walls{{"left", side_word(box, 0)}, {"right", side_word(box, 1)}};
    if (box.dimension == 1)
        return {"box", Json{{"length", length(0)}, {"walls", walls}}, "box",
                fmt::format("{}, length {}, {}", words_of_dimension(1), words_of_length(0),
                            across ? "ends joined" : "between walls")};
    walls["bottom"] = side_word(box, 2);
    walls["top"] = side_word(box, 3);
    const bool walls_act = !box.surfaces.sides_reflect();
    if (box.dimension == 3) {
        walls["back"] = side_word(box, 4);
        walls["front"] = side_word(box, 5);
        std::vector<std::string> periodic;
        for (int axis = 0; axis < 3; ++axis)
            if (box.is_periodic(axis)) periodic.emplace_back(name_of_axis(axis));
        const std::string words = periodic.size() == 3 ? "periodic"
                                  : !periodic.empty()  ? "periodic along " + listed(periodic)
                                  : walls_act          ? "walls that act"
                                                       : "solid walls";
        return {"box",
                Json{{"size", Json::array({length(0), length(1), length(2)})}, {"walls", walls}},
                "box",
                fmt::format("{}, {} by {} by {}, {}", words_of_dimension(3), words_of_length(0),
                            words_of_length(1), words_of_length(2), words)};
    }
    std::string words = across ? "periodic" : walls_act ? "walls that act" : "solid walls";
    if (across != up)
        words = across ? "periodic across, solid below and above"
                       : "periodic up and down, solid left and right";
    return {"box", Json{{"size", Json::array({length(0), length(1)})}, {"walls", walls}}, "box",
            fmt::format("{}, {} by {}, {}", words_of_dimension(2), words_of_length(0),
                        words_of_length(1), words)};
}

std::string species_words(const Gas& gas, std::int64_t particles) {
    constexpr std::size_t most_shown = 8;
    std::vector<std::string> words;
    for (const Species& one : gas.species) {
        if (words.size() == most_shown) {
            words.push_back(fmt::format("{} more", gas.species.size() - most_shown));
            break;
        }
        words.push_back(fmt::format("{} {}", grouped(one.count), one.name));
    }
    std::string text = fmt::format("{}", fmt::join(words, ", "));
    if (gas.species.size() > 1) text += fmt::format("; {} in all", grouped(particles));
    return text;
}

Fact species(const Gas& gas, std::int64_t particles) {
    Json list = Json::array();
    for (const Species& one : gas.species)
        list.push_back(Json{{"name", one.name}, {"count", one.count}});
    return {"species", std::move(list), "species", species_words(gas, particles)};
}

// Expected between particles up to the end of the run.
Fact collisions(const Scene& scene, const Law& rate, double expected, std::int64_t particles) {
    if (rate.none)
        return {"expected_collisions", nullptr, "collisions",
                "no estimate: " + to_text(Language::english, *rate.none, scene.gas.species)};
    return {"expected_collisions", Amount{expected, quantities::count}, "collisions",
            fmt::format("{} between particles, {} for each (kinetic theory, in equilibrium)",
                        (expected < 0.01 ? "" : "about ") + about(expected),
                        about(2.0 * expected / std::max(1.0, static_cast<double>(particles))))};
}

std::string run_words(const Run& run, UnitSystem units) {
    const auto time = [&](double value) { return number_words(units, quantities::time, value); };
    std::string text = fmt::format("time 0 to {}", time(run.until));
    if (run.equilibrate > 0.0) text += fmt::format(", after {} not shown", time(run.equilibrate));
    if (!run.events.empty())
        text += ", " + counted(static_cast<long long>(run.events.size()), "event");
    return text;
}

// Whether nothing ever moves, which is hardly meant.
Facts rest_rows(const BoxedGas& gas) {
    const Law motion = law(gas, LawOf::displacement);
    if (!motion.none || motion.none->why != NoLaw::Why::at_rest) return {{"at_rest", false}};
    return {{"at_rest", true, "warning",
             "all particles are at rest, and nothing moves them: give `temperature` or `speed`"}};
}

// The numbers that a scene in reduced units needs for the same run.
Facts unit_rows(const Scene& scene) {
    if (scene.units != UnitSystem::real) return {};
    std::vector<std::string> lengths;
    for (int axis = 0; axis < scene.gas.box.dimension; ++axis)
        lengths.push_back(fmt::format("{}", scene.gas.box.size[axis]));
    std::vector<std::string> lines{fmt::format("box {}", fmt::join(lengths, ", "))};
    for (const Species& one : scene.gas.species) {
        const auto add = [&](const char* key, const auto* value) {
            if (value != nullptr) lines.push_back(fmt::format("{}: {} {}", one.name, key, *value));
        };
        add("radius", std::get_if<double>(&one.radius));
        if (const auto* mass = std::get_if<ValueRule>(&one.mass))
            add("mass", std::get_if<double>(mass));
        if (const auto* temperature = std::get_if<Temperature>(&one.velocity))
            add("temperature", &temperature->value);
        if (const auto* speed = std::get_if<Speed>(&one.velocity))
            add("speed", std::get_if<double>(&speed->value));
    }
    lines.push_back(fmt::format("until {}", scene.run.until));
    Facts rows = rows_of("reduced", "in nm, u, ps", lines);
    rows.insert(rows.begin(), {"units", std::string(words_of(UnitSystem::si))});
    return rows;
}

// The pressure for which the box has its size.
Facts pressure_rows(const Scene& scene) {
    if (!scene.asked_pressure) return {};
    const Quantity quantity = quantities::pressure(scene.gas.box.dimension);
    return {{"asked_pressure", Amount{*scene.asked_pressure, quantity, scene.units}, "sized",
             "for a pressure of " + number_words(scene.units, quantity, *scene.asked_pressure)}};
}

// What the names of gases stand for.
Facts gas_rows(const Scene& scene) {
    std::vector<ListItem> rows;
    for (std::size_t k = 0; k < scene.named_gases.size(); ++k) {
        const NamedGas* gas = scene.named_gases[k];
        if (gas == nullptr) continue;
        const Amount mass{gas->mass, quantities::mass, scene.units},
            diameter{gas->diameter, quantities::length, scene.units};
        rows.push_back(
            {fmt::format("{} ({}): {:.7g} u, diameter {:g} nm from its viscosity at {:g} K{}",
                         scene.gas.species[k].name, gas->symbol, gas->mass, gas->diameter,
                         temperature_of_viscosities,
                         gas->is_monatomic ? "" : "; molecules as spheres"),
             Json{{"species", scene.gas.species[k].name},
                  {"gas", std::string(gas->name.english)},
                  {"symbol", plain_symbol(*gas)},
                  {"mass", mass},
                  {"diameter", diameter},
                  {"is_monatomic", gas->is_monatomic}}});
    }
    return rows_of("gases", "gases", std::move(rows));
}

Facts event_rows(const Scene& scene) {
    std::vector<std::string> lines;
    for (const Happening& one : happenings({Language::english, scene.units}, scene.run, scene.gas))
        lines.push_back(one.when + ": " + one.words);
    return rows_of("events", "events", lines);
}

Facts note_rows(const Scene& scene) {
    std::vector<ListItem> notes;
    for (const Diagnostic& note : scene.notes)
        notes.push_back({note_text(note), error_value(note)});
    return rows_of("notes", "note", std::move(notes));
}

Fact name_of(const CheckedFile& checked) {
    const std::string errors = counted(static_cast<long long>(checked.errors.size()), "error");
    return {checked.is_set ? "set" : "scene", checked.path, "",
            fmt::format("{}: {}\n", printable(checked.path),
                        checked.facts ? "valid" : "not valid, " + errors)};
}

// For people. Without lists of JSON, whose destructor takes memory, which may be what is missing.
Facts rows_for_people(const CheckedFile& checked) {
    Facts facts;
    facts.push_back(name_of(checked));
    if (checked.facts) facts.insert(facts.end(), checked.facts->begin(), checked.facts->end());
    return facts;
}

Facts facts_of(const CheckedFile& checked) {
    const auto list = [](const std::vector<Diagnostic>& found) {
        Json values = Json::array();
        for (const Diagnostic& one : found) values.push_back(error_value(one));
        return values;
    };
    Facts facts = joined<Fact>({{name_of(checked), {"valid", checked.facts.has_value()}},
                                checked.facts.value_or(Facts{}),
                                {{"errors", list(checked.errors)}}});
    if (checked.barriers) facts.push_back({"barriers", list(*checked.barriers)});
    return facts;
}

// What pictures and films of a scene depend on, in one word.
std::string made_from(const SceneSource& source) {
    std::string all = source_fingerprint;
    const auto add = [&](const std::string& text) {
        all += fmt::format(" {}:{}", text.size(), text);
    };
    for (const std::string& text : {source.text, source.template_text}) add(text);
    for (const std::string& one : source.overrides) add(one);
    for (const auto& [path, text] : source.files) {
        add(path);
        add(text);
    }
    return fingerprint(all);
}

}  // namespace

Facts facts_of(const Scene& scene, const std::optional<CheckedFilm>& film, const RunCounts& counts,
               const NamedWork& works, const std::vector<CommandsRefused>& refused) {
    const Box& box = scene.gas.box;
    const Run& run = scene.run;
    const auto gas = draw_gas(scene.gas);
    const Particles& drawn = gas.first;
    const Sample& sample = gas.second;
    const std::int64_t particles = drawn.count();
    const double packing = packing_fraction(box, drawn);
    const BoxedGas boxed(box, run.events, drawn, sample);
    const Law of_each = law(boxed, LawOf::collision_rate);
    const double rate = 0.5 * static_cast<double>(particles) * (of_each ? of_each.value : 0.0);
    return joined<Fact>(
        {{{"title", scene.title, "title", scene.title},
          {"description", scene.description},
          {"language", word_of(scene.film.language)},
          {"made_from", made_from(scene.source)},
          {"seed", scene.seed}},
         unit_rows(scene),
         {{"dimension", box.dimension}, box_fact(box, scene.units)},
         pressure_rows(scene),
         rows_of("surfaces", "surfaces",
                 words_of_surfaces({Language::english, scene.units}, scene.gas)),
         {{"particles", particles}, species(scene.gas, particles)},
         gas_rows(scene),
         rows_of("cut_distributions", "drawn", cut_distributions(scene.gas, scene.units)),
         {{"packing_fraction", Amount{packing, quantities::share}, "packing",
           fmt::format("{:.4g} of the {}", packing,
                       std::array{"length", "area", "volume"}.at(
                           static_cast<std::size_t>(box.dimension - 1)))},
          {"time", Amount{run.until, quantities::time, scene.units}, "run",
           run_words(run, scene.units)}},
         event_rows(scene),
         {{"equilibrate", Amount{run.equilibrate, quantities::time, scene.units}},
          collisions(scene, of_each, rate * run.until, particles),
          ties_fact(counts.ties, counts.is_cut)},
         rest_rows(boxed),
         rows_of("no_theory", "no theory", missing_theory(scene, boxed)),
         film ? film_facts(scene, *film, drawn, sample, rate * run.until)
              : Facts{{"film", nullptr, "film", "none: for `carom run` and figures only"}},
         note_rows(scene),
         work_rows(works),
         refused_rows(refused)});
}

Facts facts_of(const FigureSet& set, const NamedWork& works,
               const std::vector<CommandsRefused>& refused) {
    Json sections = Json::array();
    std::size_t figures = 0;
    for (const SetPart& part : set.parts) {
        sections.push_back(section_value(part));
        figures += part.figures.size();
    }
    std::vector<std::string> pages;
    for (const PageTemplate& page : set.pages) pages.push_back(set.stem + page.ending);
    return joined<Fact>(
        {{{"title", set.title, "title", set.title}, {"sections", std::move(sections)}},
         section_rows(set),
         {{"formats", set.formats, "figures",
           fmt::format("{}, each as {}", figures, listed(set.formats))},
          {"pages", pages, "pages", listed(pages)}},
         work_rows(works),
         refused_rows(refused)});
}

std::string check_table(std::span<const CheckedFile> files) {
    constexpr int label_width = 12;
    std::string text;
    for (const CheckedFile& checked : files) {
        if (!text.empty() && checked.facts) text += "\n";
        text += text_table(rows_for_people(checked), label_width);
    }
    return text;
}

std::string check_json(std::span<const CheckedFile> files) {
    Json list = Json::array();
    for (const CheckedFile& checked : files) list.push_back(json_of(facts_of(checked)));
    return text_of(list, 2) + "\n";
}

}  // namespace carom
