#include "app/report/facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "util/text.h"

namespace carom {
namespace {

std::string printable_lines(std::string_view text) {
    std::string lines;
    for (std::size_t end = 0; !text.empty(); text.remove_prefix(end)) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        end = std::min(length + 1, text.size());
        lines += printable(text.substr(0, length)) + (end > length ? "\n" : "");
    }
    return lines;
}

}  // namespace

const char* words_of_dimension(int dimension) {
    return dimension == 1   ? "one dimension"
           : dimension == 2 ? "two dimensions"
                            : "three dimensions";
}

const char* word_for_bodies(int dimension) {
    return dimension == 1 ? "beads" : dimension == 2 ? "disks" : "spheres";
}

Fact for_people(const char* label, const std::string& words) { return {"", nullptr, label, words}; }

Facts rows_of(const char* name, const char* label, std::vector<ListItem> items) {
    Facts rows{{name, Json::array()}};
    for (ListItem& item : items) {
        rows.front().value.push_back(std::move(item.value));
        if (rows.front().label.empty()) {
            rows.front().label = label;
            rows.front().words = std::move(item.words);
        } else {
            rows.push_back(for_people(" ", item.words));
        }
    }
    return rows;
}

Facts rows_of(const char* name, const char* label, const std::vector<std::string>& lines) {
    std::vector<ListItem> items;
    for (const std::string& line : lines) items.push_back({line, line});
    return rows_of(name, label, std::move(items));
}

Fact ties_fact(const std::optional<Ties>& ties, bool is_cut) {
    if (!ties) return {"ties"};
    Fact fact{"ties", Json{{"instants", ties->instants}, {"contacts", ties->contacts}}};
    if (ties->instants == 0) return fact;
    fact.label = "ties";
    fact.words = fmt::format(
        "{} of connected particles at {}, the first at time {:.6g}{}: carried out together",
        counted(ties->contacts, "contact"), counted(ties->instants, "instant"), ties->first,
        is_cut ? ", in the beginning of the run" : "");
    return fact;
}

std::string text_table(const Facts& facts, int label_width) {
    std::string text;
    for (const Fact& fact : facts)
        text += fact.label.empty() ? printable_lines(fact.words)
                                   : fmt::format("  {:<{}} {}\n", printable(fact.label),
                                                 label_width, printable(fact.words));
    return text;
}

Json json_of(const Facts& facts) {
    Json object = Json::object();
    for (const Fact& fact : facts)
        if (!fact.name.empty()) object[fact.name] = fact.value;
    return object;
}

}  // namespace carom
