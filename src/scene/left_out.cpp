#include "scene/left_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>

#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

/// A list whose items may be left out, or a mapping that may be left out: the section with it, its
/// key, and a name for an item.
struct List {
    const char *section, *key, *item;
};
constexpr std::array lists{
    List{"film", "panels", "panel"},       List{"film", "monitors", "monitor"},
    List{"film", "callouts", "callout"},   List{"film", "spotlight", "spotlight"},
    List{"film", "camera", "camera move"}, List{"film", "slow", "slow motion"},
    List{"film", "beside", "second run"},  List{nullptr, "figures", "figure"},
};

// Returns what may be left out of a list; a mapping is its own only item.
std::vector<const Node*> items_of(const Node& root, const List& list) {
    const Node* section = list.section != nullptr ? find(root, list.section) : &root;
    const Node* found = section != nullptr ? find(*section, list.key) : nullptr;
    std::vector<const Node*> items;
    if (found != nullptr && found->is_mapping()) items.push_back(found);
    if (found != nullptr && found->is_list())
        for (const Node& item : found->items) items.push_back(&item);
    return items;
}

bool is_at(const Node& node, const SourceSpan& span) {
    const SourceSpan place = place_of(node).span;
    return place.file == span.file && place.line == span.line && place.column == span.column;
}

// Returns whether a place is that of a value or key in `node`, unless the command line sets it.
bool contains(const Node& node, const SourceSpan& span) {
    if (is_at(node, span)) return node.source->origin != Origin::command_line;
    const auto has = [&](const Node& inner) { return contains(inner, span); };
    return std::ranges::any_of(node.keys, has) || std::ranges::any_of(node.items, has);
}

std::optional<ListItems::value_type> item_with(const SourceSpan& span, const Node& root) {
    for (const List& list : lists) {
        const std::vector<const Node*> items = items_of(root, list);
        for (std::size_t i = 0; i < items.size(); ++i)
            if (contains(*items[i], span)) return std::pair{list.key, i};
    }
    return std::nullopt;
}

bool is_after(const Node& node, double until) {
    const auto time = number_in(node);
    return time && *time > until;
}

// Returns what names an item of a list: its name or kind, or when it begins; as it is written.
struct ItemName {
    std::string_view before, text;  // "at " and "5", or "" and "early"
};
ItemName name_of(const Node& item) {
    if (item.kind == Node::Kind::scalar) return {"", item.text};
    for (const auto& [key, before] :
         {std::pair{"name", ""}, {"kind", ""}, {"at", "at "}, {"from", "from "}})
        if (const Node* found = find(item, key);
            found != nullptr && found->kind == Node::Kind::scalar)
            return {before, found->text};
    return {};
}

// "2 figures (`early` and `late`)", "1 event (at 5)"; nothing of no items.
std::string in_words(const std::vector<const Node*>& items, const char* what) {
    constexpr std::size_t most_named = 6;
    if (items.empty()) return "";
    std::vector<std::string> names;
    std::string_view before;
    for (const Node* item : items) {
        const ItemName name = name_of(*item);
        if (name.text.empty()) continue;
        if (names.empty()) before = name.before;
        names.push_back(before.empty() ? in_quotes(name.text) : printable(std::string(name.text)));
    }
    std::string words = counted(static_cast<long long>(items.size()), what);
    if (names.empty()) return words;
    if (const std::size_t all = names.size(); all > most_named) {
        names.resize(most_named - 1);
        names.push_back(fmt::format("{} more", all - names.size()));
    }
    return fmt::format("{} ({}{})", words, before, listed(names));
}

// Removes the events from the end of the run on, except those whose time the command line sets.
Removed remove_events(Node& run, double until) {
    Node* events = find(run, "events");
    if (events == nullptr || !events->is_list()) return {};
    const auto is_later = [&](const Node& event) {
        const Node* at = find(event, "at");
        if (at == nullptr || at->source->origin == Origin::command_line) return false;
        const auto time = number_in(*at);
        return time && *time >= until;
    };
    std::vector<const Node*> captions, others;
    for (const Node& event : events->items)
        if (is_later(event))
            (find(event, "caption") != nullptr ? captions : others).push_back(&event);
    Removed removed{in_words(others, "event"), in_words(captions, "caption")};
    std::erase_if(events->items, is_later);
    return removed;
}

void end_slow_motion(Node& spans, double until) {
    for (Node& span : spans.items)
        if (const Node* to = find(span, "to"); to != nullptr && is_after(*to, until))
            erase_key(span, "to");
}

// A strip keeps its earlier moments if there are at least two.
Removed shorten_strips(Node& figures, double until) {
    Removed removed;
    for (Node& figure : figures.items) {
        Node* strip = find(figure, "strip");
        if (strip == nullptr || !strip->is_list()) continue;
        const auto is_later = [&](const Node& time) { return is_after(time, until); };
        const auto later = std::ranges::count_if(strip->items, is_later);
        if (later == 0 || static_cast<std::size_t>(later) + 2 > strip->items.size()) continue;
        std::erase_if(strip->items, is_later);
        removed.push_back(fmt::format("{} in figure {}", counted(later, "moment"),
                                      in_quotes(name_of(figure).text)));
    }
    return removed;
}

}  // namespace

const Node* end_set_by_command_line(const Node& root) {
    const Node* run = find(root, "run");
    const Node* end = run != nullptr ? find(*run, "until") : nullptr;
    return end != nullptr && end->source->origin == Origin::command_line ? end : nullptr;
}

bool add_items_with(const std::vector<Diagnostic>& errors, const Node& root, ListItems& items) {
    ListItems found;
    for (const Diagnostic& error : errors) {
        if (error.span.line == 0) continue;  // the number of errors that are not listed
        const auto item = item_with(error.span, root);
        if (!item || items.contains(*item)) return false;
        found.insert(*item);
    }
    items.insert(found.begin(), found.end());
    return !found.empty();
}

Removed remove_items(Node& root, const ListItems& items) {
    Removed removed;
    for (const List& list : lists) {
        const std::vector<const Node*> all = items_of(root, list);
        std::vector<Node> kept;
        std::vector<const Node*> others;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (items.contains({list.key, i}))
                others.push_back(all[i]);
            else
                kept.push_back(*all[i]);
        if (others.empty()) continue;
        removed.push_back(in_words(others, list.item));
        Node& section = list.section != nullptr ? *find(root, list.section) : root;
        const bool has_default = list.key == std::string_view("panels");  // by the template
        if (kept.empty() && !has_default)
            erase_key(section, list.key);
        else
            find(section, list.key)->items = std::move(kept);
    }
    return removed;
}

void leave_out_later(Node& root, const Removed& before, Errors* notes) {
    const Node* end = end_set_by_command_line(root);
    if (end == nullptr) return;
    const auto until = number_in(*end);
    if (!until || !(*until > 0.0)) return;
    Removed all = remove_events(*find(root, "run"), *until);
    all.insert(all.end(), before.begin(), before.end());
    Node* film = find(root, "film");
    if (Node* slow = film != nullptr ? find(*film, "slow") : nullptr; slow != nullptr)
        end_slow_motion(*slow, *until);
    if (Node* figures = find(root, "figures"); figures != nullptr)
        std::ranges::move(shorten_strips(*figures, *until), std::back_inserter(all));
    std::erase(all, "");
    if (all.empty() || notes == nullptr) return;
    notes->add_note(
        *end, fmt::format("the run ends at {} now, before {} of the scene", *until, listed(all)),
        "they are left out");
}

}  // namespace carom
