#include "draw/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "util/diagnostics.h"
#include "util/fingerprint.h"
#include "util/text.h"

namespace carom {
namespace {

void prepend_words(pugi::xml_node root, const char* name, const std::string& words) {
    root.prepend_child(name).text().set(words.c_str());
}

bool is_link(const pugi::xml_attribute& attribute) {
    const std::string_view name = attribute.name();
    return name == "href" || name == "xlink:href";
}

// Replaces each id, and each reference to one, by what `renamed` makes of it. An attribute refers
// to an id as a link, "#glyph-0-1", or as "url(#clip-1)" anywhere in its value.
template <class Renamed>
class Renaming : public pugi::xml_tree_walker {
  public:
    explicit Renaming(Renamed renamed) : renamed_(std::move(renamed)) {}

    bool for_each(pugi::xml_node& node) override {
        for (pugi::xml_attribute attribute : node.attributes()) {
            const std::string value = attribute.value();
            if (std::string_view(attribute.name()) == "id")
                attribute.set_value(renamed_(value).c_str());
            else if (is_link(attribute) && value.starts_with('#'))
                attribute.set_value(("#" + renamed_(value.substr(1))).c_str());
            else if (value.find(address) != std::string::npos)
                attribute.set_value(with_addresses(value).c_str());
        }
        return true;
    }

  private:
    static constexpr std::string_view address = "url(#";

    std::string with_addresses(const std::string& value) {
        std::string all;
        std::size_t end = 0;
        for (std::size_t at = value.find(address); at != std::string::npos;
             at = value.find(address, end)) {
            const std::size_t begin = at + address.size();
            all += value.substr(end, begin - end);
            end = std::min(value.find(')', begin), value.size());
            all += renamed_(value.substr(begin, end - begin));
        }
        return all + value.substr(end);
    }

    Renamed renamed_;
};

template <class Renamed>
void rename_ids(pugi::xml_document& xml, Renamed renamed) {
    Renaming renaming(std::move(renamed));
    xml.traverse(renaming);
}

// Cairo numbers surfaces and images consecutively for the whole process; here they are renumbered
// from 1 in each document.
void renumber(pugi::xml_document& xml) {
    std::map<std::string, std::string> names;
    rename_ids(xml, [&](const std::string& id) {
        for (const std::string_view kind : {"surface", "image"})
            if (id.starts_with(kind))
                return names.try_emplace(id, fmt::format("{}{}", kind, names.size() + 1))
                    .first->second;
        return id;
    });
}

std::string rounded(double value) {
    std::string text = fmt::format("{:.3f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

// Attributes rather than a style: rules of a page's style sheet go before them.
void set_paint(pugi::xml_node node, const char* what, Color color) {
    node.append_attribute(what).set_value(hex_of(color).c_str());
    if (color.alpha < 1.0)
        node.append_attribute((std::string(what) + "-opacity").c_str())
            .set_value(rounded(color.alpha).c_str());
}

void add_run(pugi::xml_node text, const TextRun& run) {
    pugi::xml_node span = text.append_child("tspan");
    const auto set = [&](const char* name, const std::string& value) {
        span.append_attribute(name).set_value(value.c_str());
    };
    set("xml:space", "preserve");
    set("x", rounded(run.x));
    set("y", rounded(run.y));
    set("font-family", fmt::format("'{}', sans-serif", run.family));
    set("font-size", rounded(run.size));
    if (run.weight != 400) set("font-weight", std::to_string(run.weight));
    if (run.is_italic) set("font-style", "italic");
    if (run.is_right_to_left) set("direction", "rtl");
    // Words are as wide in other fonts.
    if (code_points(run.words) > 1) {
        set("textLength", rounded(run.width));
        set("lengthAdjust", "spacingAndGlyphs");
    }
    set_paint(span, "fill", run.color);
    span.text().set(run.words.c_str());
}

void add_text(pugi::xml_node before, const WrittenText& written) {
    pugi::xml_node text = before.parent().insert_child_before("text", before);
    text.append_attribute("class").set_value(("carom-" + written.kind).c_str());
    if (written.tabular) text.append_attribute("font-variant-numeric").set_value("tabular-nums");
    if (written.halo > 0.0) {
        set_paint(text, "stroke", written.behind);
        text.append_attribute("stroke-width").set_value(rounded(2.0 * written.halo).c_str());
        text.append_attribute("stroke-linejoin").set_value("round");
        text.append_attribute("paint-order").set_value("stroke");
    }
    for (const TextRun& run : written.runs) add_run(text, run);
}

// The number of the text that a path marks; none if it is no mark.
std::optional<std::size_t> marked_by(const pugi::xml_node& path) {
    const std::string opacity = fmt::format("{}", alpha_of_text_marks);
    const bool is_mark =
        std::string_view(path.attribute("style").value()).find("fill-opacity:" + opacity) !=
            std::string_view::npos ||
        std::string_view(path.attribute("fill-opacity").value()).starts_with(opacity);
    if (!is_mark) return std::nullopt;
    std::vector<double> numbers;
    std::istringstream words(path.attribute("d").value());
    for (std::string word; words >> word;)
        if (const char first = word.front(); first == '-' || (first >= '0' && first <= '9'))
            numbers.push_back(std::strtod(word.c_str(), nullptr));
    constexpr std::size_t of_three_corners = 6;
    if (numbers.size() < of_three_corners) return std::nullopt;
    return static_cast<std::size_t>(std::lround(64.0 * (numbers[5] - numbers[1]))) - 1;
}

void replace_marks(pugi::xml_node parent, std::span<const WrittenText> texts) {
    for (pugi::xml_node child = parent.first_child(); child;) {
        const pugi::xml_node next = child.next_sibling();
        if (const auto index = marked_by(child); index && *index < texts.size()) {
            add_text(child, texts[*index]);
            parent.remove_child(child);
        } else {
            replace_marks(child, texts);
        }
        child = next;
    }
}

struct Bytes : pugi::xml_writer {
    std::vector<std::uint8_t> all;
    void write(const void* data, std::size_t size) override {
        const auto* bytes = static_cast<const std::uint8_t*>(data);
        all.insert(all.end(), bytes, bytes + size);
    }
};

std::vector<std::uint8_t> written(const pugi::xml_document& xml) {
    Bytes bytes;
    xml.save(bytes, "", pugi::format_indent, pugi::encoding_utf8);
    return std::move(bytes.all);
}

// 48 bits: among a thousand different pictures two have the same with a probability of 2e-9. A
// name in XML begins with a letter.
std::string prefix_of(std::span<const std::uint8_t> document) {
    constexpr std::size_t digits = 12;
    const std::string_view text{reinterpret_cast<const char*>(document.data()), document.size()};
    return "p" + fingerprint(text).substr(0, digits) + "-";
}

}  // namespace

std::vector<std::uint8_t> finished_svg(std::span<const std::uint8_t> document,
                                       const PictureWords& words,
                                       std::span<const WrittenText> texts) {
    pugi::xml_document xml;
    const pugi::xml_parse_result result = xml.load_buffer(
        document.data(), document.size(), pugi::parse_default | pugi::parse_declaration);
    pugi::xml_node root = xml.child("svg");
    if (!result || !root)
        throw SystemError(fmt::format("cannot finish an SVG: {}",
                                      result ? "it has no root" : result.description()));
    if (!words.origin.empty()) prepend_words(root, "metadata", words.origin);
    prepend_words(root, "desc", words.description);
    prepend_words(root, "title", words.title);
    root.append_attribute("role").set_value("img");
    if (!texts.empty()) replace_marks(root, texts);
    renumber(xml);
    const std::string own = prefix_of(written(xml));
    rename_ids(xml, [&](const std::string& id) { return own + id; });
    return written(xml);
}

}  // namespace carom
