// The key table itself: that what it says is sound.
#include "scene/keys/keys.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "scene/keys/check.h"

using namespace carom;

namespace {

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
    for (const int dimension : {1, 2}) visit_sections(scene_section(dimension), each);
    visit_sections(template_section(), each);
    visit_sections(set_section(), each);
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

TEST_CASE("every default has a form that its key allows") {
    int defaults = 0;
    visit_keys([&](const Section& section, std::size_t i) {
        const Key& key = section.keys[i];
        CAPTURE(section.name);
        CAPTURE(key.name);
        REQUIRE(section.presets.size() == section.keys.size());
        if (key.preset.empty()) return;
        ++defaults;
        CHECK(!key.required);
        CHECK(section.presets[i].text == key.preset);
        CHECK(passes(key, section.presets[i]));
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
    for (const int dimension : {1, 2}) visit_sections(scene_section(dimension), check);
    visit_sections(template_section(), check);
}

TEST_CASE("a key that goes with some kinds only names kinds that there are") {
    std::vector<std::string> kinds{panel_kinds().begin(), panel_kinds().end()};
    kinds.emplace_back("gas");  // of figures
    visit_keys([&](const Section& section, std::size_t i) {
        for (const std::string& kind : section.keys[i].with)
            CHECK(std::find(kinds.begin(), kinds.end(), kind) != kinds.end());
    });
}

TEST_CASE("colours by name are those of CSS") {
    CHECK(color_hex("orange") == "#ffa500");
    CHECK(color_hex("teal") == "#008080");
    CHECK(color_hex("#12aBcd") == "#12aBcd");
    CHECK(color_hex("#12aBc") == "");
    CHECK(color_hex("#12aBcg") == "");
    CHECK(color_hex("beige") == "");
}
