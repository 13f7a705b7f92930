#include "draw/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "util/diagnostics.h"
#include "util/fingerprint.h"

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
                                       const PictureWords& words) {
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
    renumber(xml);
    const std::string own = prefix_of(written(xml));
    rename_ids(xml, [&](const std::string& id) { return own + id; });
    return written(xml);
}

}  // namespace carom
