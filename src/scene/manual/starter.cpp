#include "scene/manual/starter.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "scene/keys/key_text.h"
#include "scene/reading/scene_reading.h"

namespace carom {
namespace {

constexpr std::string_view schema_mark = "# yaml-language-server:";

std::string first_line(const std::string& schema) {
    return fmt::format("{} $schema={}\n", schema_mark, schema);
}

/// Keys that the scene gives, with their values.
using Given = std::map<std::string, std::string>;

// Returns words as comment lines of limited width.
std::string comment(const std::string& words, const std::string& indent) {
    constexpr std::size_t width = 96;
    std::string text, line;
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(' ', begin), words.size());
        const std::string word = words.substr(begin, end - begin);
        if (!line.empty() && indent.size() + line.size() + word.size() + 3 > width) {
            text += indent + "#" + line + "\n";
            line.clear();
        }
        line += " " + word;
        begin = end + 1;
    }
    return text + indent + "#" + line + "\n";
}

std::string words_of(const Key& key) {
    std::string words = key.meaning;
    if (!key.default_text.empty()) words += " Default: " + key.default_text + ".";
    return words + " Values: " + forms_text(key) + ".";
}

// Returns the lines of a key. A value that begins with # is an example for a key that the scene
// does not give.
std::string lines_of(const Key& key, const Given& given, const std::string& indent) {
    const auto found = given.find(key.name);
    std::string value = found != given.end() ? found->second : "#" + example_text(key);
    const bool is_given = !value.starts_with('#');
    if (!is_given) value.erase(0, 1);
    return comment(words_of(key), indent) +
           fmt::format("{}{}{}: {}\n", indent, is_given ? "" : "# ", key.name, value);
}

std::string section_lines(const Section& section, const Given& given, const std::string& indent) {
    std::string text;
    for (const Key& key : section.keys) text += lines_of(key, given, indent);
    return text;
}

std::string heading(const Section& scene, const std::string& name) {
    const Key& key = scene.keys.at(scene.index(name));
    return "\n" + comment(key.meaning, "") + name + ":\n";
}

// Returns the lines of the top-level keys that contain no other keys.
std::string top_lines(const Section& scene) {
    const Given given{{"title", "Light and heavy disks share energy, not speed"}, {"seed", "1"}};
    std::string text;
    for (const Key& key : scene.keys)
        if (section_in(key.forms) == nullptr) text += "\n" + lines_of(key, given, "");
    return text;
}

// Returns the commented-out line of a top-level key that the scene does not give.
std::string hidden_line(const Section& scene, const std::string& name, const std::string& value) {
    const Key& key = scene.keys.at(scene.index(name));
    return "\n" + comment(words_of(key), "") + fmt::format("# {}: {}\n", name, value);
}

std::string species_lines(const Section& item) {
    const Given light{
        {"name", "light"}, {"count", "160"}, {"radius", "0.5"}, {"mass", "1"}, {"speed", "2"}};
    std::string text = "  -\n" + section_lines(item, light, "    ");
    return text + "  - {name: heavy, count: 30, radius: 1.6, mass: 12, speed: 2}\n";
}

}  // namespace

std::string starter_scene(PanelKinds kinds, const std::string& schema, const std::string& name) {
    const Section scene = scene_table(kinds, 2).section();
    const auto inner = [&](const char* key) -> const Section& { return section_of(scene, key); };
    std::string text = first_line(schema);
    text +=
        comment(fmt::format("A scene: `carom render {0}` makes its film, `carom check {0}` says "
                            "whether it is valid, and what it is.",
                            name),
                "");
    text += comment(
        "Remove the # in front of a key to use it. Its value is the default, or an example.", "");
    text += top_lines(scene);
    text += heading(scene, "box") + section_lines(inner("box"), {{"size", "[64, 48]"}}, "  ");
    text += hidden_line(scene, "partitions", "[{name: divider, x: 32}]");
    text += hidden_line(scene, "obstacles", "[{name: peg, disk: [32, 24], radius: 3}]");
    text += heading(scene, "gas") + species_lines(inner("gas"));
    text += heading(scene, "run") + section_lines(inner("run"), {{"until", "75"}}, "  ");
    text += heading(scene, "film") +
            section_lines(inner("film"),
                          {{"seconds", "30"},
                           {"color_by", "species"},
                           {"beside", "#{own_label: seed 1, label: seed 2, set: seed=2}"},
                           {"fade_out", "#{within: [0, 36, 64, 48], seconds: 3}"},
                           {"panels", "[energy-by-species, speed-histogram, energy-histogram]"}},
                          "  ");
    return text;
}

std::string starter_from(const std::string& scene, const std::string& schema) {
    std::string text = scene;
    if (text.starts_with(schema_mark))
        text.erase(0, std::min(text.find('\n'), text.size() - 1) + 1);
    return first_line(schema) + text;
}

}  // namespace carom
