#include "scene/yaml/yaml.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "scene/limits.h"
#include "scene/yaml/file_text.h"
#include "scene/yaml/yaml_text.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

// Thrown to end the parsing at the first error after which no tree is left.
struct Stop {
    std::size_t offset;
    std::string message;
    std::string hint;
};

Stop too_many_values(std::size_t offset) {
    return {offset, fmt::format("the file holds more than {} values", most_values.value),
            to_text(most_values)};
}

Stop too_many_bytes(std::size_t offset) {
    return {offset,
            fmt::format("the aliases stand for more than {} bytes", most_file_bytes.count()),
            to_text(most_file_bytes)};
}

std::size_t count_nodes(const Node& node) {
    std::size_t count = 1 + node.keys.size();
    for (const Node& item : node.items) count += count_nodes(item);
    return count;
}

std::size_t count_bytes(const Node& node) {
    std::size_t bytes = node.text.size();
    for (const Node& key : node.keys) bytes += count_bytes(key);
    for (const Node& item : node.items) bytes += count_bytes(item);
    return bytes;
}

class TreeBuilder : public YAML::EventHandler {
  public:
    TreeBuilder(const Source& source, Errors& errors, std::size_t begin)
        : source_(source), errors_(errors), begin_(begin) {
        root_.source = &source;
    }

    Node take() { return std::move(root_); }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (documents_++ > 0)
            throw Stop{at(mark), "a second document begins here", "one file holds one scene"};
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        Node node = make(Node::Kind::null, mark);
        const std::string_view rest = std::string_view{source_.text}.substr(node.offset);
        if (!rest.starts_with("~") && !rest.starts_with("null") && !rest.starts_with("Null") &&
            !rest.starts_with("NULL"))
            node.offset = place_of_nothing(node.offset);
        finish(std::move(node), anchor);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        refuse_tag(mark, tag);
        Node node = make(Node::Kind::scalar, mark);
        node.quoted = tag == "!";
        node.text = value;
        refuse_open_quote(node);
        finish(std::move(node), anchor);
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto found = anchored_.find(anchor);
        if (found == anchored_.end())
            throw Stop{at(mark), "an alias inside the value that it refers to",
                       "write the value out there"};
        count(count_nodes(found->second), at(mark));
        bytes_of_aliases_ += count_bytes(found->second);
        if (bytes_of_aliases_ > most_file_bytes.count()) throw too_many_bytes(at(mark));
        finish(Node{found->second}, 0);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(Node::Kind::list, mark, tag, anchor);
    }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(Node::Kind::mapping, mark, tag, anchor);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapEnd() override {
        refuse_duplicates(open_.back().node);
        merge(open_.back().node);
        close();
    }

  private:
    struct Open {
        Node node;
        YAML::anchor_t anchor;
    };

    // yaml-cpp counts bytes; an anchor or a tag stands before the value that is meant.
    std::size_t at(const YAML::Mark& mark) const {
        const std::string_view text = source_.text;
        std::size_t offset =
            std::min(begin_ + static_cast<std::size_t>(std::max(0, mark.pos)), text.size());
        while (offset < text.size() && text[offset] == '&') {
            offset = std::min(text.find_first_of(" \t\r\n", offset), text.size());
            offset = std::min(text.find_first_not_of(" \t\r\n", offset), text.size());
        }
        return offset;
    }

    Node make(Node::Kind kind, const YAML::Mark& mark) {
        const std::size_t offset = at(mark);
        count(1, offset);
        return {.kind = kind, .source = &source_, .offset = offset};
    }

    void count(std::size_t nodes, std::size_t offset) {
        values_ += nodes;
        if (values_ > most_values.count()) throw too_many_values(offset);
    }

    // An empty value has no place of its own: it gets that of its key, or of its dash in a list.
    std::size_t place_of_nothing(std::size_t offset) const {
        if (open_.empty()) return offset;
        const Node& parent = open_.back().node;
        if (parent.keys.size() > parent.items.size()) return parent.keys.back().offset;
        const std::size_t before = source_.text.find_last_of("-,[", offset > 0 ? offset - 1 : 0);
        return before == std::string::npos ? parent.offset : before;
    }

    // yaml-cpp accepts the end of the file as the end of a quotation; refuses that.
    void refuse_open_quote(const Node& node) const {
        const std::string_view text = source_.text;
        const char quote = node.offset < text.size() ? text[node.offset] : ' ';
        if (!node.quoted || (quote != '"' && quote != '\'')) return;
        if (end_of_quotation(text, node.offset) != text.npos) return;
        throw Stop{node.offset, "not valid YAML: this quotation mark is not closed",
                   "write the same mark at the end of the text"};
    }

    void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
        if (tag.empty() || tag == "?" || tag == "!") return;
        throw Stop{begin_ + static_cast<std::size_t>(std::max(0, mark.pos)),
                   "a YAML tag (" + in_quotes(tag) + ") has no meaning in a scene", "leave it out"};
    }

    void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag,
              YAML::anchor_t anchor) {
        refuse_tag(mark, tag);
        if (open_.size() >= most_nesting.count())
            throw Stop{at(mark), fmt::format("nested deeper than {}", most_nesting.value),
                       to_text(most_nesting)};
        open_.push_back({make(kind, mark), anchor});
    }

    void close() {
        Open last = std::move(open_.back());
        open_.pop_back();
        finish(std::move(last.node), last.anchor);
    }

    void finish(Node node, YAML::anchor_t anchor) {
        if (anchor != 0) {
            count(count_nodes(node), node.offset);
            anchored_[anchor] = node;
        }
        if (open_.empty()) {
            root_ = std::move(node);
            return;
        }
        Node& parent = open_.back().node;
        const bool is_key = parent.is_mapping() && parent.keys.size() == parent.items.size();
        if (is_key && !node.is_scalar())
            throw Stop{node.offset, "expected a word as a key, found " + described(node),
                       "a text that begins with `[` or `{` needs quotes"};
        (is_key ? parent.keys : parent.items).push_back(std::move(node));
    }

    // Gives a mapping the keys of those that its merge key (`<<: *name`) names, unless it or an
    // earlier one of these has them.
    void merge(Node& mapping) {
        const auto key = std::ranges::find_if(
            mapping.keys, [](const Node& one) { return one.text == "<<" && !one.quoted; });
        if (key == mapping.keys.end()) return;
        const auto index = static_cast<std::size_t>(key - mapping.keys.begin());
        const Node merged = mapping.items[index];
        const std::vector<Node> sources = merged.is_list() ? merged.items : std::vector{merged};
        for (const Node& source : sources)
            if (!source.is_mapping())
                throw Stop{source.offset,
                           "`<<` takes the keys of other mappings, found " + described(source),
                           "mark a mapping with `&name` and write `<<: *name`"};
        erase_key(mapping, index);
        std::set<std::string_view> own;
        for (const Node& one : mapping.keys) own.insert(one.text);
        std::vector<Node> keys, items;
        for (const Node& source : sources)
            for (std::size_t k = 0; k < source.keys.size(); ++k) {
                if (!own.insert(source.keys[k].text).second) continue;
                keys.push_back(source.keys[k]);
                items.push_back(source.items[k]);
            }
        mapping.keys.insert(mapping.keys.end(), keys.begin(), keys.end());
        mapping.items.insert(mapping.items.end(), items.begin(), items.end());
    }

    // Reports keys that occur more than once; the first occurrence is kept.
    void refuse_duplicates(Node& mapping) {
        std::map<std::string_view, const Node*> first;
        std::vector<bool> doubled;
        std::size_t reported = 0;
        for (const Node& key : mapping.keys) {
            const auto [seen, is_new] = first.emplace(key.text, &key);
            doubled.push_back(!is_new);
            if (!is_new && ++reported <= most_errors_shown.count())
                report_duplicate(*seen->second, key);
        }
        if (reported > 0) drop(mapping, doubled);
    }

    void report_duplicate(const Node& first, const Node& second) {
        const auto from = source_.text.begin();
        const auto line =
            1 + std::count(from, from + static_cast<std::ptrdiff_t>(first.offset), '\n');
        errors_.add(
            second,
            fmt::format("{} is given twice, first in line {}", in_quotes(second.text), line),
            "remove one of them");
    }

    static void drop(Node& mapping, const std::vector<bool>& doubled) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < doubled.size(); ++i) {
            if (doubled[i]) continue;
            std::swap(mapping.keys[kept], mapping.keys[i]);
            std::swap(mapping.items[kept++], mapping.items[i]);
        }
        mapping.keys.resize(kept);
        mapping.items.resize(kept);
    }

    const Source& source_;
    Errors& errors_;
    std::size_t begin_;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, Node> anchored_;
    std::size_t values_ = 0, bytes_of_aliases_ = 0;
    int documents_ = 0;
    Node root_;
};

// Finds bytes that no text may contain: invalid UTF-8, and control characters except tab and line
// ends.
std::optional<Stop> unreadable_byte(std::string_view text, std::size_t begin) {
    for (std::size_t i = begin; i < text.size();) {
        i += plain_length(text.substr(i));
        if (i == text.size()) break;
        const std::size_t next = next_code_point(text, i);
        const std::string_view letter = text.substr(i, next - i);
        if (!is_utf8(letter))
            return Stop{
                i, fmt::format("byte 0x{:02X} is not UTF-8", static_cast<unsigned char>(text[i])),
                "save the file as UTF-8"};
        const bool line_end = letter == "\n" || text.substr(i, 2) == "\r\n";
        if (is_control(letter) && letter != "\t" && !line_end)
            return Stop{i,
                        fmt::format("there is a control character (U+{:04X}) here",
                                    static_cast<unsigned char>(letter.back())),
                        "remove it"};
        i = next;
    }
    return std::nullopt;
}

std::string way_out(const std::string& problem, std::string_view before, std::string_view line) {
    using namespace YAML::ErrorMsg;
    if (has_bare_color(before)) return "`#` begins a comment; put the colour in quotes";
    if (line.starts_with('\t') || problem == TAB_IN_INDENTATION)
        return "indent with spaces, not with tabs";
    if (problem.starts_with(INVALID_ESCAPE) || problem.starts_with(INVALID_HEX) ||
        problem.starts_with(INVALID_UNICODE))
        return "in double quotes a backslash begins an escape of YAML: write the text in single "
               "quotes";
    if (const std::string hint = odd_space_hint(line.substr(0, line.find('\n'))); !hint.empty())
        return hint;
    if (problem.starts_with(UNKNOWN_ANCHOR))
        return "write the value out, or quotes around a text that begins with `*`";
    const std::string_view left =
        before.substr(before.rfind('\n') + 1);  // before the mistake in its line
    if (problem == UNKNOWN_TOKEN)
        return fmt::format("a text that begins with `{}` needs quotes",
                           line.substr(left.size(), 1));
    const std::size_t dash = left.find_first_not_of(' ');
    if (problem == MAP_VALUE && dash != left.npos && left[dash] == '-' &&
        left.substr(dash, 2) != "- ")
        return "put a space after the `-` of an item";
    const bool begins_line = left.find_first_not_of(' ') == std::string_view::npos;
    if ((problem == END_OF_MAP || problem == END_OF_SEQ) && !begins_line)
        return "nothing may follow a closing quote or bracket in the same line: leave out the "
               "rest, or "
               "put quotes around the whole text";
    const bool is_first_key = problem == MAP_VALUE && left.find(':') == std::string_view::npos;
    const std::string columns = "lines that belong together begin in the same column";
    if (problem == END_OF_MAP || problem == END_OF_SEQ || problem == BLOCK_ENTRY) return columns;
    if (is_first_key) return columns + "; a text with `: ` in it needs quotes";
    if (problem == MAP_VALUE) return "a text with `: ` in it needs quotes";
    return "";
}

// From yaml-cpp 0.8 on, the name of an anchor follows these words.
std::string problem_of(const YAML::Exception& error) {
    using namespace YAML::ErrorMsg;
    if (error.msg.starts_with(UNKNOWN_ANCHOR)) return "this anchor is not defined";
    if (error.msg == END_OF_MAP || error.msg == END_OF_SEQ) return "this text is out of place";
    if (error.msg == MAP_VALUE) return "this `:` is out of place";
    if (error.msg == BLOCK_ENTRY) return "this `-` is out of place";
    return error.msg;
}

// Reports the quotation mark or bracket at `mark`, which is open where the parser stops;
// `is_other`: there another bracket is closed.
void report_open(const Source& source, std::size_t mark, std::size_t offset, bool is_other,
                 const std::string& hint, Errors& errors) {
    const std::string_view text = source.text, before = text.substr(0, offset);
    const char open = text[mark];
    if (is_other)
        return errors.add(source, mark,
                          fmt::format("not valid YAML: this `{}` is not closed before the `{}` of "
                                      "line {}, column {}",
                                      open, text[offset], 1 + std::ranges::count(before, '\n'),
                                      offset - before.rfind('\n')),
                          "close it there, or leave out the other");
    if (open == '"' || open == '\'')
        return errors.add(source, mark, "not valid YAML: this quotation mark is not closed",
                          "write the same mark at the end of the text");
    std::string way = hint;
    if (way.empty() && before.find(';', mark) != before.npos)
        way = "a comma separates its items, not `;`";
    if (way.empty())
        way = fmt::format("write `{}` where it ends, and `,` between its items",
                          open == '{' ? '}' : ']');
    errors.add(
        source, mark,
        fmt::format("not valid YAML: this `{}` is not closed, or a comma is missing in it", open),
        way);
}

void report_syntax(const Source& source, const YAML::Exception& error, std::size_t begin,
                   Errors& errors) {
    const std::string_view text = source.text;
    const std::size_t offset =
        std::min(begin + static_cast<std::size_t>(std::max(0, error.mark.pos)), text.size());
    const std::string_view before = text.substr(0, offset);
    const std::string hint = way_out(error.msg, before, text.substr(before.rfind('\n') + 1));
    const std::string_view left = before.substr(before.rfind('\n') + 1);
    const bool is_key = error.msg == YAML::ErrorMsg::MAP_VALUE && left.find(':') == left.npos;
    const std::size_t above = is_key ? line_without_key(text, offset) : std::string_view::npos;
    if (above != std::string_view::npos && !has_bare_color(before)) {
        const std::string_view line = text.substr(above, text.find('\n', above) - above);
        return errors.add(source, above, "not valid YAML: this line has no key", key_hint(line));
    }
    const bool is_open = error.msg == YAML::ErrorMsg::END_OF_MAP_FLOW ||
                         error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW ||
                         error.msg == YAML::ErrorMsg::EOF_IN_SCALAR ||
                         (error.msg == YAML::ErrorMsg::FLOW_END && offset < text.size());
    const std::size_t mark = is_open ? open_mark(before) : std::string_view::npos;
    if (mark == std::string_view::npos)
        return errors.add(source, offset, "not valid YAML: " + problem_of(error), hint);
    report_open(source, mark, offset, error.msg == YAML::ErrorMsg::FLOW_END, hint, errors);
}

Node parse(const Source& source, Errors& errors, std::size_t begin) {
    std::istringstream stream{source.text.substr(begin)};
    TreeBuilder builder{source, errors, begin};
    YAML::Parser parser{stream};
    while (parser.HandleNextDocument(builder)) {
    }
    return builder.take();
}

}  // namespace

std::optional<Node> read_yaml(const Source& source, Errors& errors, std::size_t begin) {
    const EndsAtOnce whole;
    if (std::string_view{source.text}.substr(begin).starts_with("\xEF\xBB\xBF")) begin += 3;
    try {
        if (source.text.size() > most_file_bytes.count()) {
            errors.add(source,
                       fmt::format("the file has more than {} bytes", most_file_bytes.count()),
                       to_text(most_file_bytes));
            return std::nullopt;
        }
        if (const auto stop = unreadable_byte(source.text, begin)) throw *stop;
        const std::size_t beyond = place_beyond(source.text, begin, most_values.count());
        if (beyond != source.text.npos) throw too_many_values(beyond);
        return parse(source, errors, begin);
    } catch (const Stop& stop) {
        errors.add(source, stop.offset, stop.message, stop.hint);
    } catch (const YAML::Exception& error) {
        report_syntax(source, error, begin, errors);
    }
    return std::nullopt;
}

std::optional<Node> read_yaml_file(const std::filesystem::path& path, Source& source,
                                   Errors& errors) {
    source.name = path.string();
    auto text = file_text(path, source, errors);
    if (!text) return std::nullopt;
    source.text = std::move(*text);
    return read_yaml(source, errors);
}

}  // namespace carom
