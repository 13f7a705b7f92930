// Input files of any size that cause a reader of scenes as much work as possible.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace carom::test {

/// An input file: `text` generates it with about `bytes` bytes.
struct HostileFile {
    std::string about;
    std::function<std::string(std::size_t bytes)> text;
};

inline std::string filled(std::size_t bytes, const std::string& before, const std::string& part,
                          const std::string& after = "") {
    std::string text = before;
    while (text.size() + part.size() + after.size() < bytes) text += part;
    return text + after;
}

/// The same with parts that have their number in place of each `@`.
inline std::string numbered(std::size_t bytes, const std::string& before, const std::string& part,
                            const std::string& after = "") {
    std::string text = before;
    for (int k = 0; text.size() + part.size() + after.size() < bytes; ++k)
        for (const char c : part) text += c == '@' ? std::to_string(k) : std::string(1, c);
    return text + after;
}

inline std::vector<HostileFile> hostile_files() {
    const std::string start = "title: T\nbox: {size: [1e6, 1e6]}\nrun: {until: 1}\n";
    const std::string gas = start + "gas: [{count: 2, radius: 0.1}]\n";
    const auto fill = [](const std::string& about, const std::string& before,
                         const std::string& part, const std::string& after = "") {
        return HostileFile{about,
                           [=](std::size_t bytes) { return filled(bytes, before, part, after); }};
    };
    const auto number = [](const std::string& about, const std::string& before,
                           const std::string& part, const std::string& after = "") {
        return HostileFile{about,
                           [=](std::size_t bytes) { return numbered(bytes, before, part, after); }};
    };
    std::string laughs = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int k = 1; k < 20; ++k) {
        const std::string its = std::to_string(k), last = "*a" + std::to_string(k - 1);
        laughs += "a" + its + ": &a" + its + " [" + last;
        for (int i = 0; i < 9; ++i) laughs += ", " + last;
        laughs += "]\n";
    }
    return {
        fill("open brackets", "", "["),
        fill("open braces", "", "{"),
        fill("open braces and keys", "", "{a: "),
        fill("dashes", "", "- "),
        fill("lines of dashes", "", "-\n"),
        fill("question marks", "", "? "),
        fill("colons", "", ": "),
        fill("closed brackets", "", "[]"),
        fill("commas", "[", "1,", "]"),
        fill("ampersands", "a: ", "&"),
        fill("stars", "a: ", "*"),
        fill("exclamation marks", "a: ", "! "),
        fill("per cents", "", "%\n"),
        fill("document ends", "", "...\n"),
        fill("document starts", "", "---\n"),
        fill("tabs", "", "\t"),
        fill("spaces", "", " ", "a: 1"),
        fill("line ends", "", "\n"),
        fill("comments", "", "# words\n"),
        fill("one comment", "# ", "[{: x"),
        fill("comment signs after values", "", "a: 1 #\n"),
        fill("a plain text", "title: ", "x"),
        fill("a plain text of many words", "title: ", "x y "),
        fill("a plain text of many lines", "title:\n", "  x\n"),
        fill("a plain text with colons", "title: ", "a:b"),
        fill("a plain text with number signs", "title: ", "a#b"),
        fill("a plain text in brackets", "title: [", "x y"),
        fill("a quotation", "title: \"", "x", "\"\n"),
        fill("a quotation of escapes", "title: \"", "\\x41", "\"\n"),
        fill("a quotation of long escapes", "title: \"", "\\U0001F600", "\"\n"),
        fill("a quotation of lines", "title: \"", "x\n\n  ", "\"\n"),
        fill("a quotation of blanks", "title: \"", " ", "\"\n"),
        fill("a quotation in single marks", "title: '", "''", "'\n"),
        fill("a quotation that does not end", "title: \"", "x"),
        fill("many quotations that do not end", "", "a: 'b\n"),
        fill("a literal text", "title: |\n", "  x\n"),
        fill("a literal text of blank lines", "title: |\n  x\n", "\n", "  y\n"),
        fill("a folded text", "title: >\n", "  x\n"),
        fill("a folded text of blank lines", "title: >\n  x\n", "\n", "  y\n"),
        fill("a folded text of indented lines", "title: >\n", "    x\n\n  y\n"),
        fill("a text of blanks", "title: |\n", "   \n"),
        fill("a long key", "", "k", ": 1\n"),
        fill("a long key in quotation marks", "\"", "k", "\": 1\n"),
        fill("a long key of question mark", "? ", "k", "\n: 1\n"),
        number("unknown keys", gas, "key@: 1\n"),
        number("unknown keys in braces", "{", "key@: 1, ", "}"),
        number("unknown keys of a species", start + "gas:\n  - count: 2\n", "    key@: 1\n"),
        fill("one key many times", gas, "title: T\n"),
        number("long unknown keys", gas, std::string(200, 'k') + "@: 1\n"),
        number("anchors", "", "k@: &a@ x\n"),
        number("anchors in a list", "[", "&a@ x, ", "]"),
        number("aliases of anchors before", "k: &a x\n", "k@: *a\n"),
        {"aliases of aliases",
         [laughs](std::size_t bytes) { return filled(bytes, laughs, "#\n"); }},
        {"aliases of a large text",
         [](std::size_t bytes) {
             const std::string text = "a: &a " + std::string(bytes / 2, 'x') + "\nb: [";
             return filled(bytes, text, "*a,", "]\n");
         }},
        {"aliases of a large list",
         [](std::size_t bytes) {
             const std::string text = filled(bytes / 2, "a: &a [", "1,", "]\nb: [");
             return filled(bytes, text, "*a,", "]\n");
         }},
        fill("aliases that are not known", "[", "*a,", "]"),
        fill("tags", "[", "!a b,", "]"),
        fill("numbers that are words", start + "gas: [{radius: [", "-1,", "]}]\n"),
        fill("numbers that are lists", start + "gas: [{position: [", "[],", "]}]\n"),
        fill("places outside", start + "gas: [{radius: 0.1, position: [", "[-1,-1],", "]}]\n"),
        fill("one place", start + "gas: [{radius: 0.1, position: [", "[1,1],", "]}]\n"),
        number("places", start + "gas: [{radius: 0.1, position: [", "[@,@],", "]}]\n"),
        number("places in lines", start + "gas:\n  - radius: 0.1\n    position:\n",
               "      - [@.5, 7]\n"),
        number("places with many digits", start + "gas:\n  - radius: 0.1\n    position:\n",
               "      - [@.12345678901234567890, 50.12345678901234567890]\n"),
        number("beads",
               "title: T\nbox: {length: 1e6}\nrun: {until: 1}\ngas: [{radius: 0, position: [",
               "@.5,", "]}]\n"),
        number("velocities", start + "gas: [{radius: 0.1, count: 9, velocity: [", "[@,@],",
               "]}]\n"),
        number("species", start + "gas:\n", "  - {name: s@, count: 1, radius: 0.1}\n"),
        number("species with mistakes", start + "gas:\n", "  - {name: s@, coutn: 1, radius: -1}\n"),
        number("captions", gas + "run:\n  until: 1e6\n  events:\n", "    - {at: @, caption: c@}\n"),
        number(
            "captions in a run",
            "title: T\nbox: {size: [1e6, 1e6]}\ngas: [{count: 2}]\nfilm: {seconds: 80000, fps: 1}\n"
            "run:\n  until: 1e6\n  events:\n",
            "    - {at: @, caption: c@}\n"),
        number(
            "marks of formulae",
            "title: T\nbox: {size: [1e6, 1e6]}\ngas: [{count: 2}]\nrun:\n  until: 1e6\n  events:\n",
            "    - {at: @, caption: '$\\frac{a}{\\sqrt{b}}$'}\n"),
        fill("a formula", gas + "figures: [{name: a, kind: gas, at: 0, caption: '$", "{", "$'}]\n"),
        fill("a text of formulae", gas + "figures: [{name: a, kind: gas, at: 0, caption: '", "$x$ ",
             "'}]\n"),
        number("partitions", gas + "partitions:\n", "  - {name: p@, x: @}\n"),
        number("gaps", gas + "partitions:\n  - x: 5\n    gaps: [", "[@,@.5],", "]\n"),
        number("obstacles", gas + "obstacles:\n", "  - {disk: [@, @], radius: 0.5}\n"),
        number("corners", gas + "obstacles:\n  - polygon: [", "[@,@.5],", "]\n"),
        number("figures", gas + "figures:\n", "  - {name: f@, kind: gas, at: 0}\n"),
        number("figures that compare", gas + "figures:\n",
               "  - {name: f@, kind: speed-histogram, at: 0, compare: {seeds: 6}}\n"),
        number(
            "figures of a sweep", gas + "figures:\n",
            "  - {name: f@, kind: sweep, number: temperature, vary: \"gas.0.radius=0.1:0.2:500\", "
            "seeds: 2}\n"),
        number("panels", gas + "film:\n  seconds: 1\n  panels:\n",
               "    - {kind: text, words: w@}\n"),
        number("overlays", gas + "film:\n  seconds: 1\n  callouts:\n",
               "    - {at: @, points_to: 0, text: t@}\n"),
        fill("a description", gas + "description: |\n", "  A word and another one.\n"),
        fill("words to be spelt with disks",
             start + "gas: [{radius: 0.1, position: {within: [0, 0, 9, 9], text: \"", "W ",
             "\"}}]\n"),
        number("scenes of a set", "scenes:\n", "  - scene: s@.yaml\n"),
    };
}

}  // namespace carom::test
