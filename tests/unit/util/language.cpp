// The program's own words: every phrase that is used has its row in the table, every row is used,
// and all languages fill in the same places.
#include "util/language.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/test_root.h"

namespace fs = std::filesystem;
using namespace carom;

namespace {

// The value of a literal as it stands in a source: what of C++ escapes the phrases have.
std::string unescaped(const std::string& literal) {
    static const std::map<std::string, std::string> letters{{"\\u2019", "’"},
                                                            {"\\u00B1", "±"},
                                                            {"\\u03C7", "χ"},
                                                            {"\\u00B2", "²"},
                                                            {"\\u2009", "\u2009"}};
    std::string text = literal;
    for (const auto& [escape, letter] : letters)
        for (std::size_t at = 0; (at = text.find(escape, at)) != std::string::npos;)
            text.replace(at, escape.size(), letter);
    return text;
}

struct Scanned {
    std::set<std::string> used;  // in calls that say something
};

// Reads a literal that begins at `at`, and those that follow with blanks between; ends after them.
std::string literal_at(const std::string& source, std::size_t& at) {
    std::string text;
    while (at < source.size() && source[at] == '"') {
        for (++at; source[at] != '"'; ++at) {
            if (source[at] == '\\') text += source[at++];
            text += source[at];
        }
        ++at;
        std::size_t next = at;
        while (next < source.size() && std::isspace(static_cast<unsigned char>(source[next])))
            ++next;
        if (next < source.size() && source[next] == '"') at = next;
    }
    return unescaped(text);
}

// The literals between the brackets of a call that are not in brackets of their own.
void scan_call(const std::string& source, std::size_t at, Scanned& found) {
    int depth = 0;
    do {
        const char c = source[at];
        if (c == '\'') {
            at += source[at + 1] == '\\' ? 4 : 3;
            continue;
        }
        if (c == '"') {
            const std::string text = literal_at(source, at);
            if (depth == 1) found.used.insert(text);
            continue;
        }
        if (c == '(' || c == '{') ++depth;
        if (c == ')' || c == '}') --depth;
        ++at;
    } while (depth > 0);
}

Scanned scan() {
    Scanned found;
    const std::regex call(
        R"(\b(say(?=\([^",]*([lL]anguage|[wW]ording))|Phrase|ReferenceLevel)(\(|\{)\s*[^)\s])");
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(test::checkout() / "src")) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        std::ifstream file(entry.path());
        const std::string source(std::istreambuf_iterator<char>(file), {});
        for (std::sregex_iterator match(source.begin(), source.end(), call), end; match != end;
             ++match)
            scan_call(source, static_cast<std::size_t>(match->position(3)), found);
    }
    const std::regex tag(R"(\{\{_([^}]*)\}\})");
    for (const char* const folder : {"documents", "pages"})
        for (const fs::directory_entry& entry :
             fs::directory_iterator(test::checkout() / "templates" / folder)) {
            std::ifstream file(entry.path());
            const std::string page(std::istreambuf_iterator<char>(file), {});
            for (std::sregex_iterator match(page.begin(), page.end(), tag), end; match != end;
                 ++match)
                found.used.insert((*match)[1]);
        }
    return found;
}

// What a phrase fills in, in order: "0", "0", "1".
std::multiset<std::string> places(std::string_view phrase) {
    std::multiset<std::string> found;
    int next = 0;
    for (std::size_t at = 0; (at = phrase.find('{', at)) != std::string_view::npos; ++at) {
        const std::string_view inside = phrase.substr(at + 1, phrase.find('}', at) - at - 1);
        found.insert(inside.empty() ? std::to_string(next++) : std::string(inside));
    }
    return found;
}

std::multiset<std::string> tags(std::string_view phrase) {
    static const std::regex tag("<[^>]*>|&[a-z]+;");
    const std::string text(phrase);
    return {std::sregex_token_iterator(text.begin(), text.end(), tag), {}};
}

}  // namespace

TEST_CASE("every phrase that is used has its words in all languages") {
    const Scanned found = scan();
    CHECK(found.used.size() > 50);  // the sources were found
    std::set<std::string> known;
    for (const phrases::Row& row : phrases::all()) {
        const std::string english(row[0]);
        CHECK_MESSAGE(known.insert(english).second, "twice: ", english);
        CHECK_MESSAGE(found.used.contains(english), "not used: ", english);
    }
    for (const std::string& phrase : found.used)
        CHECK_MESSAGE(known.contains(phrase), "no words in src/util/phrases.inc: ", phrase);
}

TEST_CASE("a phrase has the same places and markup in all languages") {
    for (const phrases::Row& row : phrases::all())
        for (std::size_t k = 1; k < language_count; ++k) {
            CAPTURE(row[0]);
            CAPTURE(row[k]);
            CHECK_FALSE(row[k].empty());
            CHECK(places(row[k]) == places(row[0]));
            CHECK(tags(row[k]) == tags(row[0]));
            CHECK(row[k].ends_with(' ') == row[0].ends_with(' '));
            CHECK(row[k].ends_with('.') == row[0].ends_with('.'));
            // All places are numbered or none, as the formatting wants it.
            CHECK((row[k].find("{}") == std::string_view::npos ||
                   row[k].find("{0}") == std::string_view::npos));
        }
}

TEST_CASE("French signs do not part from their words at the end of a line") {
    const std::regex breakable(" [:;!?%]| »|« ");
    for (const phrases::Row& row : phrases::all()) {
        const std::string french(row[static_cast<std::size_t>(Language::french)]);
        CAPTURE(french);
        CHECK_FALSE(std::regex_search(french, breakable));
    }
    CHECK(say(Language::french, "{}: {}", "a", "b") == "a\u00A0: b");
}

TEST_CASE("numbers and lists are those of the language") {
    CHECK(three_digits(Language::english, 1.234) == "1.23");
    CHECK(three_digits(Language::german, 1.234) == "1,23");
    CHECK(plain_number(Language::french, -0.25) == "\u22120,25");
    CHECK(steady_number(Language::spanish, 1.5, {0.0, 3.0}) == "1,50");
    CHECK(say(Language::german, "at time {}", 2.5) == "zur Zeit 2,5");
    CHECK(say(Language::english, "at time {}", 2.5) == "at time 2.5");
    CHECK(say(Language::german, "particle {}", 3) == "Teilchen 3");
    CHECK(say(Language::french, "{}: {}", "a", 2.5) == "a\u00A0: 2,5");
    CHECK(say(Language::german, "{}, {}", 0.1f, std::string("1.5")) == "0,1, 1.5");
    const std::vector<std::string> three{"a", "b", "c"}, islands{"mar", "isla"};
    CHECK(listed(Language::english, three) == "a, b and c");
    CHECK(listed(Language::german, three) == "a, b und c");
    CHECK(listed(Language::french, three) == "a, b et c");
    CHECK(listed(Language::spanish, three) == "a, b y c");
    CHECK(listed(Language::spanish, islands) == "mar e isla");
}

TEST_CASE("counts have the plural of the language") {
    const Phrase one{"mean of {} run"}, more{"mean of {} runs"};
    CHECK(counted(Language::english, 1, one, more) == "mean of 1 run");
    CHECK(counted(Language::english, 0, one, more) == "mean of 0 runs");
    CHECK(counted(Language::german, 12345, one, more) == "Mittel aus 12\u2009345 Läufen");
    CHECK(counted(Language::french, 0, one, more) == "moyenne de 0 simulation");
    CHECK(counted(Language::french, 2, one, more) == "moyenne de 2 simulations");
}

TEST_CASE("words that the table does not have stay English") {
    CHECK(say(Language::german, Phrase{std::string_view("no such words")}) == "no such words");
}

TEST_CASE("numbers with commas in a row have semicolons between them") {
    CHECK(between_numbers(Language::english) == ", ");
    for (const Language language : {Language::german, Language::french, Language::spanish})
        CHECK(between_numbers(language) == "; ");
}
