#include "app/report/schema_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "media/formats.h"
#include "panels/registry.h"
#include "runs/json.h"
#include "scene/keys/keys.h"
#include "scene/reading/scene_reading.h"
#include "scene/sets/set_reading.h"
#include "scene/style/style_reading.h"
#include "scene/yaml/scalar.h"

namespace carom {
namespace {

Json number(double value) {
    constexpr double exact = 9007199254740992.0;  // 2^53
    if (value == std::floor(value) && std::abs(value) < exact)
        return static_cast<std::int64_t>(value);
    return value;
}

// A default as JSON knows it: `0.5`, `true` or "solid".
Json value_of(const std::string& written) {
    if (const auto value = parse_number(written)) return number(*value);
    if (written == "true" || written == "false") return written == "true";
    return written;
}

Json section_schema(const Section& section);
Json value_schema(const std::vector<Form>& forms);

Json number_schema(const char* type, const Range& range) {
    return {{"type", type}, {"minimum", number(range.low)}, {"maximum", number(range.most.value)}};
}

// No control characters, and no line breaks unless it may have lines; what a text ends with does
// not count.
std::string text_pattern(const Form& form) {
    const std::string controls =
        form.lines ? R"(\u0000-\u0009\u000b-\u001f\u007f-\u009f)" : R"(\u0000-\u001f\u007f-\u009f)";
    const std::string body = "[^" + controls + "]*[^ \\n" + controls + "]";
    return "^" + (form.shortest > 0 ? body : "(" + body + ")?") + "[ \\t\\n]*$";
}

// `title: 2026` is a text for carom, though YAML calls it a number.
Json text_schema(const Form& form) {
    return {{"type", {"string", "number", "boolean"}},
            {"maxLength", form.most.count()},
            {"pattern", text_pattern(form)}};
}

Json color_schema() {
    return {{"anyOf",
             {{{"enum", color_names()}}, {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}}}}};
}

Json list_schema(const Form& form) {
    return {{"type", "array"},
            {"items", value_schema(form.items)},
            {"minItems", form.shortest},
            {"maxItems", form.most.count()}};
}

Json form_schema(const Form& form) {
    switch (form.shape) {
        case Shape::number:
            return number_schema("number", form.range);
        case Shape::integer:
            return number_schema("integer", form.range);
        case Shape::length:
            return {{"type", "string"},
                    {"pattern",
                     fmt::format("^[0-9]+(\\.[0-9]+)? *({})$", fmt::join(length_units(), "|"))}};
        case Shape::flag:
            return {{"type", "boolean"}};
        case Shape::text:
            return text_schema(form);
        case Shape::word:
            return {{"enum", form.words}};
        case Shape::color:
            return color_schema();
        case Shape::list:
            return list_schema(form);
        case Shape::mapping:
            return section_schema(*form.section);
    }
    return {};
}

Json value_schema(const std::vector<Form>& forms) {
    if (forms.size() == 1) return form_schema(forms.front());
    Json any = Json::array();
    for (const Form& form : forms) any.push_back(form_schema(form));
    return {{"anyOf", any}};
}

Json key_schema(const Key& key) {
    Json schema = Json::object();
    schema["description"] = key.default_text.empty()
                                ? key.meaning
                                : key.meaning + " Default: " + key.default_text + ".";
    if (!key.default_value.empty()) schema["default"] = value_of(key.default_value);
    schema.update(value_schema(key.forms));
    return schema;
}

// Editors mark the former name of a key, which a scene may still use.
Json former_schema(const Key& key) {
    Json schema = key_schema(key);
    schema["deprecationMessage"] = "`" + key.formerly + "` is now called `" + key.name + "`.";
    return schema;
}

Json needs(const std::vector<std::string>& names) { return {{"required", names}}; }

void add_choice(Json& rules, const Choice& choice) {
    const auto& names = choice.names;
    if (choice.required) {
        Json one = Json::array();
        for (const std::string& name : names) one.push_back(needs({name}));
        rules.push_back({{"oneOf", one}});
        return;
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        for (std::size_t j = i + 1; j < names.size(); ++j)
            rules.push_back({{"not", needs({names[i], names[j]})}});
}

std::vector<std::string> kinds_without(const Section& section,
                                       const std::vector<std::string>& with) {
    std::vector<std::string> kinds = section.keys.at(section.index("kind")).forms.at(0).words;
    std::erase_if(kinds, [&](const std::string& kind) {
        return std::find(with.begin(), with.end(), kind) != with.end();
    });
    return kinds;
}

// Keys that stand only beside some kinds: none of them beside the others.
void add_kinds(Json& rules, const Section& section) {
    std::map<std::vector<std::string>, Json> refused;
    for (const Key& key : section.keys)
        if (!key.kinds.empty()) refused[key.kinds][key.name] = false;
    for (const auto& [with, keys] : refused) {
        const std::vector<std::string> others = kinds_without(section, with);
        if (others.empty()) continue;
        Json condition = needs({"kind"});
        condition["properties"]["kind"]["enum"] = others;
        rules.push_back({{"if", condition}, {"then", {{"properties", keys}}}});
    }
}

void add_rules(Json& schema, const Section& section) {
    std::vector<std::string> required;
    Json rules = Json::array();
    for (const Key& key : section.keys) {
        if (!key.formerly.empty())
            add_choice(rules, {{key.name, key.formerly}, key.required});
        else if (key.required)
            required.push_back(key.name);
    }
    for (const Choice& choice : section.choices) {
        if (choice.required && choice.names.size() == 1)
            required.push_back(choice.names.front());
        else
            add_choice(rules, choice);
    }
    add_kinds(rules, section);
    if (!required.empty()) schema["required"] = required;
    if (!rules.empty()) schema["allOf"] = rules;
}

Json section_schema(const Section& section) {
    Json schema{{"type", "object"}, {"additionalProperties", false}};
    schema["properties"] = Json::object();
    for (const Key& key : section.keys) {
        schema["properties"][key.name] = key_schema(key);
        if (!key.formerly.empty()) schema["properties"][key.formerly] = former_schema(key);
    }
    add_rules(schema, section);
    return schema;
}

// A condition on the box: `given` holds of it.
Json if_box(Json given) {
    Json condition = needs({"box"});
    condition["properties"]["box"] = std::move(given);
    return condition;
}

// The keys that differ between boxes stand in the branches of conditions on `box.length` and on the
// number of lengths in `box.size`, as the loader decides: so an editor offers the keys of the box
// that is written, and of the plane where nothing is written yet.
void part_dimensions(Json& plane, const Json& wire, const Json& space) {
    Json on_wire = Json::object(), in_plane = Json::object(), in_space = Json::object();
    for (auto& [name, schema] : plane["properties"].items()) {
        const Json of_wire = wire.at("properties").value(name, Json(false));
        const Json of_space = space.at("properties").value(name, Json(false));
        if (schema == of_wire && schema == of_space) continue;
        on_wire[name] = of_wire;
        in_plane[name] = schema;
        in_space[name] = of_space;
        schema = {{"description", schema.at("description")}};
    }
    Json three = needs({"size"});
    three["properties"]["size"] = {{"type", "array"}, {"minItems", 3}};
    plane["if"] = if_box({{"required", {"length"}}, {"not", needs({"size"})}});
    plane["then"] = {{"properties", on_wire}};
    plane["else"] = {{"if", if_box(three)},
                     {"then", {{"properties", in_space}}},
                     {"else", {{"properties", in_plane}}}};
}

Json header(const char* title, const char* description) {
    return {{"$schema", "http://json-schema.org/draft-07/schema#"},
            {"title", title},
            {"description", description}};
}

}  // namespace

// Draft 07: the newest draft that yaml-language-server, which editors read YAML with, takes whole;
// of 2019-09 and 2020-12 it knows only parts.
std::string scene_schema_json() {
    Json plane = section_schema(scene_table(panel_kinds(), 2).section());
    part_dimensions(plane, section_schema(scene_table(panel_kinds(), 1).section()),
                    section_schema(scene_table(panel_kinds(), 3).section()));
    Json schema =
        header("A scene of carom", "What is in the box, what happens to it, what the viewer sees.");
    schema.update(plane);
    return text_of(schema, 1) + "\n";
}

std::string set_schema_json() {
    Json schema = header("A figure set of carom", "Scenes whose figures belong together.");
    schema.update(section_schema(set_table(panel_kinds(), figure_formats()).section()));
    return text_of(schema, 1) + "\n";
}

std::string style_schema_json() {
    Json schema = header("A style of carom", "Colours, fonts and sizes of films and figures.");
    schema.update(section_schema(style_table().section()));
    return text_of(schema, 1) + "\n";
}

}  // namespace carom
