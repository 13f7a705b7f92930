#include "draw/svg.h"

#include <fmt/format.h>

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "util/diagnostics.h"

namespace carom {
namespace {

void prepend_words(pugi::xml_node root, const char* name, const std::string& words) {
    root.prepend_child(name).text().set(words.c_str());
}

// Cairo numbers surfaces and images consecutively for the whole process; here they are renumbered
// from 1 in each document.
class Renumbering : public pugi::xml_tree_walker {
  public:
    bool for_each(pugi::xml_node& node) override {
        rename(node.attribute("id"), "");
        rename(node.attribute("xlink:href"), "#");
        return true;
    }

  private:
    void rename(pugi::xml_attribute attribute, std::string_view before) {
        const std::string_view value = attribute.value();
        for (const std::string_view kind : {"surface", "image"}) {
            if (!value.starts_with(std::string(before) + std::string(kind))) continue;
            const std::string old{value.substr(before.size())};
            const auto known =
                names_.try_emplace(old, fmt::format("{}{}", kind, names_.size() + 1));
            attribute.set_value((std::string(before) + known.first->second).c_str());
            return;
        }
    }

    std::map<std::string, std::string> names_;
};

struct Bytes : pugi::xml_writer {
    std::vector<std::uint8_t> all;
    void write(const void* data, std::size_t size) override {
        const auto* bytes = static_cast<const std::uint8_t*>(data);
        all.insert(all.end(), bytes, bytes + size);
    }
};

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
    Renumbering renumbering;
    xml.traverse(renumbering);
    Bytes bytes;
    xml.save(bytes, "", pugi::format_indent, pugi::encoding_utf8);
    return std::move(bytes.all);
}

}  // namespace carom
