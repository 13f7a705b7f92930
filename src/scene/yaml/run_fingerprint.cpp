#include "scene/yaml/run_fingerprint.h"

#include <fmt/format.h>

#include "util/fingerprint.h"

namespace carom {
namespace {

// Appends an unambiguous text of a node: because it contains the lengths of texts and lists,
// different nodes have different texts.
void add_text_of(const Node& node, std::string& text) {
    text += fmt::format("{}{}:{}{}", static_cast<int>(node.kind), node.quoted ? "q" : "",
                        node.text.size(), node.text);
    text += fmt::format("[{}", node.items.size());
    for (const Node& key : node.keys) add_text_of(key, text);
    for (const Node& item : node.items) add_text_of(item, text);
}

}  // namespace

std::string run_fingerprint(const Node& scene) {
    std::string text;
    for (const char* key : {"box", "gravity", "partitions", "obstacles", "gas", "run"})
        if (const Node* value = find(scene, key)) {
            text += key;
            add_text_of(*value, text);
        }
    return fingerprint(text);
}

}  // namespace carom
