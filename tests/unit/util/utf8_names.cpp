// Names of any bytes as UTF-8.
#include "util/files/utf8_names.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "util/text.h"

using namespace carom;

TEST_CASE("names of any bytes are UTF-8, and are found again") {
    std::set<std::string> texts;
    int names = 0;
    for (const std::string name : {"", "gas.yaml", "größe µ 🎱.yaml", "b\xff.yaml", "b\xfe.yaml",
                                   "b\xef\xbf\xbd.yaml", "\\xFF", "\\", "\\\\", "\\x", "\xe2\x82",
                                   "\xe2\x82\xac", "\xc3", "\xed\xa0\x80", "a\\xZZ", "\xff\\xff"}) {
        CAPTURE(name);
        const std::string text = utf8_of_name(name);
        CHECK(is_utf8(text));
        CHECK(name_of_utf8(text) == name);
        texts.insert(text);
        ++names;
    }
    CHECK(static_cast<int>(texts.size()) == names);
    CHECK(utf8_of_name("größe.yaml") == "größe.yaml");
    CHECK(utf8_of_name("b\xff.yaml") == "b\\xFF.yaml");
}

TEST_CASE("text that is no such name is taken as it is") {
    for (const std::string text : {"a\\", "a\\x", "a\\x1", "a\\xZZ", "a\\n"})
        CHECK(name_of_utf8(text) == text);
}
