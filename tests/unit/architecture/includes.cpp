// A file includes what declares the functions it calls, itself or by a header that it includes.
// Where several files are compiled as one, the compiler does not see a header that is missing.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "support/test_root.h"

namespace fs = std::filesystem;

namespace {

// Texts by their paths in src/, without comments and without what stands in quotes.
using Sources = std::map<std::string, std::string>;

std::string code_of(std::string code) {
    static const std::regex quoted(R"re("(\\.|[^"\\\n])*")re"), comment("//.*");
    for (std::size_t raw = code.find("R\"("); raw != std::string::npos;
         raw = code.find("R\"(", raw + 2))
        code.replace(raw, code.find(")\"", raw) + 2 - raw, "\"\"");
    std::string kept;
    std::istringstream lines(code);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("#"))
            line = std::regex_replace(std::regex_replace(line, quoted, "\"\""), comment, "");
        kept += line + "\n";
    }
    return kept;
}

Sources sources() {
    const fs::path source = carom::test::checkout() / "src";
    Sources found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source)) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        std::ifstream file(entry.path());
        std::ostringstream text;
        text << file.rdbuf();
        found[fs::relative(entry.path(), source).string()] = code_of(text.str());
    }
    return found;
}

struct Declarations {
    std::map<std::string, std::set<std::string>> functions;  // the headers, by names
    std::set<std::string> members;                           // of any type
};

Declarations declarations(const Sources& all) {
    static const std::regex declaration(R"(^( *)[\w:<>,&*\[\]][\w:<>,&*\[\] ]*[ &*](\w+)\(.*)"),
        other(R"(^ *(#|using|namespace|template|class|struct|enum|return|static_assert).*)");
    Declarations found;
    std::smatch match;
    for (const auto& [path, text] : all) {
        if (!path.ends_with(".h")) continue;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            if (std::regex_match(line, other) || !std::regex_match(line, match, declaration))
                continue;
            if (match[1].length() > 0)
                found.members.insert(match[2]);
            else
                found.functions[match[2]].insert(path);
        }
    }
    return found;
}

void include_into(std::set<std::string>& included, const Sources& all, const std::string& path) {
    static const std::regex line(R"re(#include "([^"]+)")re");
    if (!all.contains(path) || !included.insert(path).second) return;
    const std::string& text = all.at(path);
    for (std::sregex_iterator one(text.begin(), text.end(), line), end; one != end; ++one)
        include_into(included, all, (*one)[1]);
}

bool is_of_name(char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

// Names that a bracket follows, and no type, object or namespace precedes.
std::set<std::string> calls(const std::string& text) {
    std::set<std::string> names;
    for (std::size_t bracket = text.find('('); bracket != std::string::npos;
         bracket = text.find('(', bracket + 1)) {
        std::size_t from = bracket;
        while (from > 0 && is_of_name(text[from - 1])) --from;
        if (from == bracket) continue;
        const std::size_t before = text.find_last_not_of(" \n", from == 0 ? 0 : from - 1);
        if (from == 0 || before == std::string::npos) continue;
        const bool follows_return = before >= 5 && text.compare(before - 5, 6, "return") == 0;
        const bool is_in_namespace =
            before == from - 1 && before > 0 && text[before] == ':' && text[before - 1] == ':';
        const bool follows_sign =
            std::string_view("(,=!&|+-*/<?:;{}[").find(text[before]) != std::string_view::npos;
        if (follows_return || (follows_sign && !is_in_namespace))
            names.insert(text.substr(from, bracket - from));
    }
    return names;
}

// In templates of headers: what is called depends on the type that they are used for.
const std::set<std::string> by_argument{"archive_parts", "invert", "mean_of"};

// A function of this file alone, or a variable that is called: behind a type, which `return` and an
// operand of an operator are not.
bool defines(const std::string& text, const std::string& name) {
    const std::regex behind_word(R"((\w+)[>\]&*]* )" + name + R"(\b *[({=;,):])");
    for (std::sregex_iterator one(text.begin(), text.end(), behind_word), end; one != end; ++one)
        if ((*one)[1] != "return" && (*one)[1] != "throw" && (*one)[1] != "case") return true;
    return false;
}

}  // namespace

TEST_CASE("a file includes what declares the functions it calls") {
    const Sources all = sources();
    const Declarations declared = declarations(all);
    CHECK(declared.functions.size() > 500);
    for (const auto& [path, text] : all) {
        CAPTURE(path);
        std::set<std::string> included;
        include_into(included, all, path);
        for (const std::string& name : calls(text)) {
            const auto headers = declared.functions.find(name);
            if (headers == declared.functions.end() || declared.members.contains(name)) continue;
            if (path.ends_with(".h") && by_argument.contains(name)) continue;
            const bool is_included = std::ranges::any_of(
                headers->second, [&](const std::string& one) { return included.contains(one); });
            if (is_included || defines(text, name)) continue;
            const std::string header = *headers->second.begin();
            CAPTURE(name);
            CAPTURE(header);
            CHECK(is_included);
        }
    }
}
