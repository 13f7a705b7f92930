// YAML as the scene language reads it.
#include "scene/yaml/yaml.h"

#include <doctest/doctest.h>

#include <string>

#include "scene/yaml/scalar.h"

using namespace carom;

namespace {

std::string first_error(const std::string& text) {
    const Source source{"text", text, Origin::scene};
    Errors errors;
    static_cast<void>(read_yaml(source, errors));
    try {
        errors.throw_if_any();
    } catch (const SceneError& error) {
        const Diagnostic& first = error.diagnostics().front();
        return std::to_string(first.span.line) + ":" + std::to_string(first.span.column) + " " +
               first.message;
    }
    return "";
}

// Line, column and length of the value of `key` in a mapping.
SourceSpan span_of(const std::string& text, const std::string& key) {
    const Source source{"text", text, Origin::scene};
    Errors errors;
    const auto root = read_yaml(source, errors);
    REQUIRE(root);
    REQUIRE(find(*root, key) != nullptr);
    return place_of(*find(*root, key)).span;
}

void check_span(const std::string& text, int line, int column, int length) {
    CAPTURE(text);
    const SourceSpan span = span_of(text, "key");
    CHECK(span.line == line);
    CHECK(span.column == column);
    CHECK(span.length == length);
}

}  // namespace

TEST_CASE("values know their place, in characters") {
    check_span("key: value", 1, 6, 5);
    check_span("# ä\r\nkey:   value # more\r\n", 2, 8, 5);
    check_span("{ä: ö, key: ü}", 1, 13, 1);
    check_span("key: 'it''s'", 1, 6, 7);
    check_span("key: \"a \\\" b\" # c", 1, 6, 8);
    check_span("key: [1, [2, ']'], 3] # c", 1, 6, 16);
    check_span("key: {a: 1}", 1, 6, 6);
    check_span("key:\n  - a\n  - b", 2, 3, 1);
    check_span("key: &name value", 1, 12, 5);
    check_span("key: |\n  a\n  b\n", 1, 6, 1);
    check_span("key:\nother: 1", 1, 1, 3);
    check_span("key: ~", 1, 6, 1);
    check_span("\xEF\xBB\xBFkey: value", 1, 7, 5);
}

TEST_CASE("an alias stands for what its anchor holds") {
    const Source source{"text", "a: &x [1, {b: 2}]\nc: *x\nd: [*x, *x]", Origin::scene};
    Errors errors;
    const auto root = read_yaml(source, errors);
    REQUIRE(root);
    CHECK(errors.empty());
    CHECK(find(*root, "c")->items.at(1).items.at(0).text == "2");
    CHECK(find(*root, "d")->items.at(1).items.at(0).text == "1");
}

TEST_CASE("a merge key gives a mapping the keys of others that it lacks") {
    const Source source{"text",
                        "a: &x {one: 1, two: 2}\nb: &y {two: 3, three: 3}\nc: {<<: *x, two: 5}\n"
                        "d:\n  <<: [*x, *y]\n  four: 4\n'<<': 6",
                        Origin::scene};
    Errors errors;
    const auto root = read_yaml(source, errors);
    REQUIRE(root);
    CHECK(errors.empty());
    const auto text = [&](const char* key, const char* inner) {
        return find(*find(*root, key), inner)->text;
    };
    CHECK(text("c", "one") == "1");
    CHECK(text("c", "two") == "5");
    CHECK(find(*root, "c")->keys.size() == 2);
    CHECK(text("d", "two") == "2");
    CHECK(text("d", "three") == "3");
    CHECK(text("d", "four") == "4");
    CHECK(find(*root, "<<")->text == "6");
    CHECK(first_error("a: {<<: 1}") == "1:9 `<<` takes the keys of other mappings, found `1`");
    CHECK(first_error("a: {<<: [{b: 1}, c]}") ==
          "1:18 `<<` takes the keys of other mappings, found `c`");
}

TEST_CASE("what is ambiguous or hostile is refused at its place") {
    CHECK(first_error("a: 1\nb: 2\na: 3") == "3:1 `a` is given twice, first in line 1");
    CHECK(first_error("{a: {b: 1, b: 2}}") == "1:12 `b` is given twice, first in line 1");
    CHECK(first_error("a: 1\n---\nb: 2") == "2:1 a second document begins here");
    CHECK(first_error("a: !secret 1") == "1:4 a YAML tag (`!secret`) has no meaning in a scene");
    CHECK(first_error("a: !!str 1").starts_with("1:4 a YAML tag"));
    CHECK(first_error("a: \x01") == "1:4 there is a control character (U+0001) here");
    CHECK(first_error("a: \xC2\x85") == "1:4 there is a control character (U+0085) here");
    CHECK(first_error("a: b\rc: d") == "1:5 there is a control character (U+000D) here");
    CHECK(first_error("a: \xED\xA0\x80") == "1:4 byte 0xED is not UTF-8");
    CHECK(first_error(std::string{"a: b\0c", 6}) ==
          "1:5 there is a control character (U+0000) here");
    CHECK(
        first_error("a: 'b").starts_with("1:4 not valid YAML: this quotation mark is not closed"));
    CHECK(first_error("? {a: 1}\n: 2") == "1:3 expected a word as a key, found a mapping");
    CHECK(first_error(std::string(30, '[') + std::string(30, ']'))
              .starts_with("1:25 nested deeper than 24"));
    CHECK(first_error(std::string(100'000, '[')).find("nested deeper than 24") !=
          std::string::npos);
    CHECK(first_error("a: " + std::string(5 << 20, 'x')) ==
          "0:0 the file has more than 4194304 bytes");
}

// 30,000 texts of 2 MB would take 60 GB.
TEST_CASE("aliases of a large text are refused before they take memory") {
    std::string text = "a: &a " + std::string(2 << 20, 'x') + "\nb: [";
    for (int i = 0; i < 30'000; ++i) text += "*a, ";
    CHECK(first_error(text + "]") == "2:13 the aliases stand for more than 4194304 bytes");
    CHECK(first_error("a: &a " + std::string(2 << 20, 'x') + "\nb: [*a, *a]").empty());
}

TEST_CASE("an empty document is no error of its own") {
    for (const char* text : {"", "\n\n", "# only words\n", "---\n", "~"}) {
        CAPTURE(text);
        const Source source{"text", text, Origin::scene};
        Errors errors;
        const auto root = read_yaml(source, errors);
        REQUIRE(root);
        CHECK(root->kind == Node::Kind::null);
        CHECK(errors.empty());
    }
}

TEST_CASE("of two keys of one name the first stays") {
    const Source source{"text", "a: 1\nb: 2\na: 3\n", Origin::scene};
    Errors errors;
    const auto root = read_yaml(source, errors);
    REQUIRE(root);
    CHECK(!errors.empty());
    CHECK(root->keys.size() == 2);
    CHECK(find(*root, "a")->text == "1");
}

TEST_CASE("many duplicates of a key cost no more than one") {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += "a: 1\n";
    CHECK(first_error(text) == "2:1 `a` is given twice, first in line 1");
}

TEST_CASE("numbers are decimal and finite") {
    CHECK(parse_number("12") == 12.0);
    CHECK(parse_number("-0.5") == -0.5);
    CHECK(parse_number("+.5") == 0.5);
    CHECK(parse_number("5.") == 5.0);
    CHECK(parse_number("1e3") == 1000.0);
    CHECK(parse_number("1.5E-3") == 0.0015);
    CHECK(parse_number("0") == 0.0);
    CHECK(parse_number("0.1") == 0.1);
    for (const char* text :
         {"",      ".",      "-",     "e5",   "1e",    "1e+",  "0x10",  "0o7", "010",
          "1_000", "1,5",    "1 000", ".nan", "nan",   ".inf", "-.inf", "inf", "infinity",
          "1e999", "1e-999", "--1",   "+-1",  "1.2.3", "1:30", "12kg",  "٣"}) {
        CAPTURE(text);
        CHECK(!parse_number(text));
    }
}
