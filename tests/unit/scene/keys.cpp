// The bindings of all keys: that what they say is sound, and that a binding is all there is to say
// of a key.
#include "scene/keys/keys.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "media/formats.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/registry.h"
#include "scene/keys/binding.h"
#include "scene/keys/check.h"
#include "scene/keys/colors.h"
#include "scene/reading/film_reading.h"
#include "scene/reading/scene_reading.h"
#include "scene/sets/set_reading.h"
#include "scene/style/style_reading.h"
#include "scene/yaml/yaml.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

// What readers of YAML 1.1 such as PyYAML take for true, false or nothing. `y` and `n`, which the
// specification lists too, are texts for PyYAML, libyaml, SnakeYAML and js-yaml.
bool is_other_in_yaml_1_1(std::string word) {
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const std::set<std::string> words{"yes", "no", "on", "off", "true", "false", "null", "~"};
    const bool is_number =  // also octal (010), with underscores, and sexagesimal (1:30)
        !word.empty() && word.find_first_not_of("0123456789_:.+-") == std::string::npos;
    return words.contains(word) || is_number;
}

template <typename Visit>
void visit_sections(const Section& section, const Visit& visit);

template <typename Visit>
void visit_forms(const std::vector<Form>& forms, const Visit& visit) {
    for (const Form& form : forms) {
        if (form.section) visit_sections(*form.section, visit);
        visit_forms(form.items, visit);
    }
}

template <typename Visit>
void visit_sections(const Section& section, const Visit& visit) {
    visit(section);
    for (const Key& key : section.keys) visit_forms(key.forms, visit);
}

template <typename Visit>
void visit_keys(const Visit& visit) {
    const auto each = [&](const Section& section) {
        for (std::size_t i = 0; i < section.keys.size(); ++i) visit(section, i);
    };
    for (const int dimension : {1, 2, 3})
        visit_sections(scene_table(panel_kinds(), dimension).section(), each);
    visit_sections(template_table(panel_kinds()).section(), each);
    visit_sections(set_table(panel_kinds(), figure_formats()).section(), each);
    visit_sections(style_table().section(), each);
}

bool passes(const Key& key, Node value) {
    Section only{.name = "test", .keys = {key}};
    only.keys[0].required = false;
    const Source source{"test", key.name, Origin::scene};
    Node mapping;
    mapping.kind = Node::Kind::mapping;
    mapping.source = &source;
    value.source = &source;
    Node name;
    name.kind = Node::Kind::scalar;
    name.source = &source;
    name.text = key.name;
    mapping.keys.push_back(name);
    mapping.items.push_back(std::move(value));
    Errors errors;
    check_mapping(mapping, only, errors);
    return errors.empty();
}

}  // namespace

TEST_CASE("no key and no word is something else for readers of YAML 1.1") {
    visit_keys([](const Section& section, std::size_t index) {
        const Key& key = section.keys[index];
        CAPTURE(section.name);
        CAPTURE(key.name);
        CHECK_FALSE(is_other_in_yaml_1_1(key.name));
        for (const Form& form : key.forms) {
            if (form.shape != Shape::word) continue;
            for (const std::string& word : form.words) {
                CAPTURE(word);
                CHECK_FALSE(is_other_in_yaml_1_1(word));
            }
        }
    });
}

TEST_CASE("a key may have its former name, with a note") {
    struct Lamp {
        std::int64_t light = 0;
    };
    const FixedTable<Lamp> table(
        KeyTable<Lamp>{.name = "a lamp",
                       .keys = {bind_key("of", &Lamp::light, whole(0, {9}), "What it lights.")
                                    .required()
                                    .formerly("on")}});
    const auto read = [&](const std::string& scene, const std::string& set = "") {
        Errors errors;
        const Source source{"lamp.yaml", scene, Origin::scene};
        const Source change{"--set", set, Origin::command_line};
        Node node = read_yaml(source, errors).value();
        if (!set.empty()) {
            const Node other = read_yaml(change, errors).value();
            node.keys.push_back(other.keys[0]);
            node.items.push_back(other.items[0]);
        }
        check_mapping(node, table.section(), errors);
        errors.throw_if_any();
        const Gas gas;
        const Run run;
        std::vector<NumberInWords> numbers;
        Reading reading{errors, gas, run, numbers};
        Lamp lamp;
        table.read(node, lamp, reading);
        return std::pair{lamp.light, errors.notes()};
    };
    CHECK(read("{of: 3}").first == 3);
    CHECK(read("{of: 3}").second.empty());
    const auto [light, notes] = read("{on: 4}");
    CHECK(light == 4);
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].message == "`on` is now called `of`");
    CHECK(notes[0].span.column == 2);
    CHECK(notes[0].span.length == 2);
    CHECK_THROWS_AS(read("{on: 4, of: 3}"), SceneError);
    CHECK_THROWS_AS(read("{}"), SceneError);
    CHECK(read("{on: 4}", "of: 5").first == 5);
    CHECK(read("{of: 4}", "on: 5").first == 5);
}

TEST_CASE("every default has a form that its key allows") {
    int defaults = 0;
    visit_keys([&](const Section& section, std::size_t i) {
        const Key& key = section.keys[i];
        CAPTURE(section.name);
        CAPTURE(key.name);
        if (key.default_value.empty()) return;
        ++defaults;
        CHECK(!key.required);
        CHECK(key.default_text.empty());
        CHECK(passes(key, default_node(key.default_value)));
    });
    CHECK(defaults > 15);
}

TEST_CASE("every key says what it means in a sentence, and what stands in for it") {
    visit_keys([](const Section& section, std::size_t i) {
        const Key& key = section.keys[i];
        CAPTURE(section.name);
        CAPTURE(key.name);
        CHECK(key.meaning.ends_with('.'));
        CHECK(!key.forms.empty());
        for (const Form& form : key.forms) CHECK(!phrase(form).empty());
    });
}

TEST_CASE("the names of a section are unique, and its choices name its keys") {
    const auto check = [](const Section& section) {
        CAPTURE(section.name);
        std::set<std::string> names;
        for (const Key& key : section.keys) CHECK(names.insert(key.name).second);
        for (const Refused& refused : section.refused) CHECK(names.count(refused.name) == 0);
        for (const Choice& choice : section.choices)
            for (const std::string& name : choice.names) CHECK(names.count(name) == 1);
    };
    for (const int dimension : {1, 2, 3})
        visit_sections(scene_table(panel_kinds(), dimension).section(), check);
    visit_sections(template_table(panel_kinds()).section(), check);
}

TEST_CASE("a key that goes with some kinds only names kinds that there are") {
    std::set<std::string> kinds;
    for (const PanelKind& kind : panel_kinds()) CHECK(kinds.insert(kind.name).second);
    visit_keys([&](const Section& section, std::size_t i) {
        for (const std::string& kind : section.keys[i].kinds) CHECK(kinds.contains(kind));
    });
}

TEST_CASE("colours by name are those of CSS") {
    CHECK(color_hex("orange") == "#ffa500");
    CHECK(color_hex("teal") == "#008080");
    CHECK(color_hex("#12aBcd") == "#12aBcd");
    CHECK(color_hex("#12aBc") == "");
    CHECK(color_hex("#12aBcg") == "");
    CHECK(color_hex("biege") == "");
    CHECK(color_hex("darkblue") == "#00008b");  // CSS Color Module Level 4, 6.1
    CHECK(color_hex("rebeccapurple") == "#663399");
    CHECK(color_hex("gray") == "#808080");  // not the lighter one of X11
    CHECK(color_names().size() == 148);
}

TEST_CASE("colours are in groups of like hues, from dark to light") {
    std::map<std::string, std::vector<std::string>> names;
    for (const ColorGroup& group : color_groups()) {
        CHECK(!group.colors.empty());
        for (const NamedColor& color : group.colors)
            names[group.name].insert(names[group.name].end(), color.names.begin(),
                                     color.names.end());
    }
    CHECK(names.at("yellows") == std::vector<std::string>{"olive", "darkkhaki", "gold", "khaki",
                                                          "palegoldenrod", "yellow"});
    CHECK(names.at("black to white").front() == "black");
    CHECK(names.at("black to white").back() == "white");
    const auto has = [&](const char* group, const char* name) {
        return std::ranges::find(names.at(group), name) != names.at(group).end();
    };
    CHECK(has("reds and pinks", "crimson"));
    CHECK(has("reds and pinks", "brown"));
    CHECK(has("oranges and browns", "chocolate"));
    CHECK(has("greens", "lime"));
    CHECK(has("cyans", "teal"));
    CHECK(has("blues", "darkslateblue"));
    CHECK(has("purples", "indigo"));
    CHECK(has("almost white", "ivory"));
}

TEST_CASE("a text that is no colour is told the nearest names") {
    CHECK(color_hint("rde") == "did you mean `red`?");
    CHECK(color_hint("Dark Blue") == "did you mean `darkblue`?");
    CHECK(color_hint("RED") == "did you mean `red`?");
    CHECK(color_hint("blood-red") ==
          "names are `red`, `darkred`, `indianred`, `mediumvioletred` and others; "
          "docs/scene-reference.md lists all");
    CHECK(color_hint("blau").starts_with("names are `black`, `blue`, "));
    CHECK(color_hint("gelb").starts_with("names are `gold`, "));
    CHECK(color_hint("ffb000") == "write `#` before the digits, in quotes: \"#ffb000\"");
    CHECK(color_hint("#fb0") == "write it with six digits: \"#ffbb00\"");
    CHECK(color_hint("#12345").starts_with("write six digits after `#`"));
    CHECK(color_hint("0.5").starts_with("names are `red`, "));
    CHECK(color_hint(std::string(100000, 'x')).size() < 200);
}

namespace {

struct Lamp {
    int watts = 60;
    bool lit = false;
    std::optional<double> seconds;
};

FixedTable<Lamp> lamp_table() {
    return KeyTable<Lamp>{
        .name = "a lamp",
        .keys = {bind_key("watts", &Lamp::watts, whole(1, most_seeds), "Its power."),
                 bind_key("lit", &Lamp::lit, one_of<bool>({{"on", true}, {"off", false}}),
                          "Whether it shines."),
                 bind_key("seconds", &Lamp::seconds, number(positive), "How long.")
                     .default_text("for ever")}};
}

}  // namespace

TEST_CASE("a binding says a key once: its default is the field's, its words are the schema's") {
    const Section section = lamp_table().section();
    REQUIRE(section.keys.size() == 3);
    CHECK(section.keys[0].default_value == "60");
    CHECK(section.keys[1].default_value == "off");
    CHECK(section.keys[1].forms[0].words == std::vector<std::string>{"on", "off"});
    CHECK(section.keys[2].default_value.empty());
    CHECK(section.keys[2].default_text == "for ever");
}

TEST_CASE("a table reads what is given and valid, and leaves the defaults of the rest") {
    const Source source{"test", "{watts: 40, lit: maybe}", Origin::scene};
    Errors errors;
    auto root = read_yaml(source, errors);
    REQUIRE(root.has_value());
    check_mapping(*root, lamp_table().section(), errors);
    CHECK_FALSE(errors.empty());  // of `lit`
    Lamp lamp;
    const Gas gas;
    const Run run;
    std::vector<NumberInWords> numbers;
    Reading reading{errors, gas, run, numbers};
    lamp_table().read(*root, lamp, reading);
    CHECK(lamp.watts == 40);
    CHECK_FALSE(lamp.lit);
    CHECK_FALSE(lamp.seconds.has_value());
}

TEST_CASE("options are values of the type that their kind has for them") {
    Options options;
    CHECK(options.as<FreeFlightOptions>().logarithmic == false);
    CHECK(options.find<FreeFlightOptions>() == nullptr);
    options.change<FreeFlightOptions>().logarithmic = true;
    Options copy = options;
    copy.change<FreeFlightOptions>().logarithmic = false;
    CHECK(options.as<FreeFlightOptions>().logarithmic == true);
    CHECK(copy.find<FreeFlightOptions>()->logarithmic == false);
    CHECK(options.find<DisplacementOptions>() == nullptr);
}

TEST_CASE("a key of several kinds is read into the options of the panel's own") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 20, speed: 1}]\nrun: {until: 40}\n"
        "film:\n  template: data\n  panels:\n"
        "    - {kind: velocity-autocorrelation, from: 3, lags: 5}\n"
        "    - {kind: mean-squared-displacement, from: 4, origins: all, lags: 6}\n"
        "    - velocity-autocorrelation\n");
    const auto velocities = [&](std::size_t k) {
        return scene.film.panels.at(k).options.as<AutocorrelationOptions>();
    };
    CHECK(velocities(0).from == 3.0);
    CHECK(velocities(0).lags == 5.0);
    CHECK(velocities(2).from == 0.0);
    CHECK(!velocities(2).lags);
    const auto& places = scene.film.panels.at(1).options.as<DisplacementOptions>();
    CHECK(places.from == 4.0);
    CHECK(places.lags == 6.0);
    CHECK(places.all_origins);
}
