#include "app/report/facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

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

Fact for_people(const char* label, const std::string& words) { return {"", nullptr, label, words}; }

Facts rows_of(const char* label, const std::vector<std::string>& lines) {
    Facts rows;
    if (lines.empty()) return {{label, Json::array()}};
    rows.push_back({label, Json(lines), label, lines.front()});
    for (std::size_t k = 1; k < lines.size(); ++k) rows.push_back({"", nullptr, " ", lines[k]});
    return rows;
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
