#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "util/formula/formula.h"

namespace carom::formula {
namespace {

bool is_symbol(const Part& part, std::string_view tex) {
    return part.of == Part::Of::symbol && part.symbol->tex == tex;
}

bool is_digit(const Part& part) {
    return part.of == Part::Of::symbol &&
           part.symbol->tex.find_first_not_of("0123456789.") == std::string::npos;
}

bool is_sign(const Part& part) {
    return part.kind == Class::binary || part.kind == Class::relation;
}

// Returns whether parts form a sum, a relation or a list: then words mark where they end.
bool is_compound(std::span<const Part> parts) {
    if (!parts.empty() && is_sign(parts.front())) parts = parts.subspan(1);
    return std::ranges::any_of(parts, [](const Part& part) {
        return (is_sign(part) && !is_symbol(part, "cdot") && !is_symbol(part, "times")) ||
               part.kind == Class::punctuation || part.of == Part::Of::fraction;
    });
}

bool is_factor(const Part& part) {
    if (part.of == Part::Of::space || part.of == Part::Of::upright) return false;
    return part.kind == Class::ordinary || part.kind == Class::inner;
}

// Returns whether a letter before a bracket is read as a function of the bracket's content.
bool is_function(const Part& part) {
    return part.of == Part::Of::symbol &&
           (part.symbol->tex.size() == 1
                ? std::string_view("fghFP").find(part.symbol->tex) != std::string_view::npos
                : part.symbol->tex == "phi" || part.symbol->tex == "psi");
}

class Speaker {
  public:
    explicit Speaker(Language language) : language_(language) {}

    std::string speak(std::span<const Part> parts) {
        for (std::size_t i = 0; i < parts.size(); ++i) say_part(parts, i);
        return std::move(said_);
    }

  private:
    void add(const std::string& words) {
        if (words.empty()) return;
        if (!said_.empty() && !words.starts_with(',') && !words.starts_with(';')) said_ += ' ';
        said_ += words;
    }

    std::string in_words(Phrase phrase) const { return say(language_, phrase); }

    std::string inside(std::span<const Part> parts) const {
        return Speaker(language_).speak(parts);
    }

    std::string ended(std::span<const Part> parts, Phrase end) const {
        return inside(parts) + (is_compound(parts) ? ", " + in_words(end) : "");
    }

    void say_part(std::span<const Part> parts, std::size_t i) {
        const Part& part = parts[i];
        const bool goes_on =
            i > 0 && is_digit(part) && is_digit(parts[i - 1]) && !parts[i - 1].has_indices();
        if (goes_on)
            said_ += part.symbol->tex;
        else if (i > 0 && multiplies(parts[i - 1], part))
            add((parts[i - 1].of == Part::Of::fraction ? ", " : "") + say(language_, "times"));
        if (!goes_on) add(words_of(parts, i));
        if (part.kind != Class::operation) say_indices(part);
    }

    static bool multiplies(const Part& before, const Part& next) {
        const bool opens = next.kind == Class::opening || next.of == Part::Of::fenced;
        if (opens && is_function(before)) return false;
        if (is_symbol(before, "/") || is_symbol(next, "/")) return false;
        if (is_symbol(before, "|") || is_symbol(next, "|")) return false;
        return (is_factor(before) || before.kind == Class::closing) && (is_factor(next) || opens) &&
               !is_symbol(next, "!");
    }

    std::string words_of(std::span<const Part> parts, std::size_t i) const {
        const Part& part = parts[i];
        switch (part.of) {
            case Part::Of::symbol:
                return part.kind == Class::operation ? operation(part) : symbol(parts, i);
            case Part::Of::group:
                return inside(part.body);
            case Part::Of::fraction:
                return fraction(part);
            case Part::Of::root:
                return say(language_, "the square root of {}",
                           ended(part.body, Phrase{"end of root"}));
            case Part::Of::accent:
                return part.symbol->tex == "vec"
                           ? in_words(part.symbol->spoken) + " " + inside(part.body)
                           : inside(part.body) + " " + in_words(part.symbol->spoken);
            case Part::Of::fenced:
                return fenced(part, i > 0 && is_function(parts[i - 1]));
            case Part::Of::upright:
                return part.kind == Class::operation ? in_words(spoken_function(part.words))
                                                     : part.words;
            case Part::Of::space:
                break;
        }
        return {};
    }

    // Brackets without words are not read aloud.
    std::string spoken_symbol(const Symbol* symbol) const {
        if (symbol == nullptr) return {};
        if (!symbol->spoken.english.empty()) return in_words(symbol->spoken);
        const bool is_bracket = symbol->kind == Class::opening || symbol->kind == Class::closing;
        return is_bracket ? std::string() : symbol->tex;
    }

    std::string symbol(std::span<const Part> parts, std::size_t i) const {
        const Part& part = parts[i];
        if (part.symbol->tex == "(" && i > 0 && is_function(parts[i - 1]))
            return say(language_, "of");
        if (part.symbol->tex == ")") {
            const bool is_of_one =
                i > 2 && is_symbol(parts[i - 2], "(") && is_function(parts[i - 3]);
            if (is_of_one) return {};
        }
        if (part.symbol->tex == "rangle") {
            const auto before = parts.first(i);
            const auto open =
                std::ranges::find_if(before.rbegin(), before.rend(),
                                     [](const Part& one) { return is_symbol(one, "langle"); });
            const auto within = static_cast<std::size_t>(open - before.rbegin());
            if (open != before.rend() && is_compound(before.last(within)))
                return ", " + say(language_, "end of mean");
        }
        return spoken_symbol(part.symbol);
    }

    std::string fraction(const Part& part) const {
        if (!is_compound(part.body) && !is_compound(part.below))
            return say(language_, "{} over {}", inside(part.body), inside(part.below));
        return say(language_, "the fraction {}, over {}, end of fraction", inside(part.body),
                   inside(part.below));
    }

    std::string fenced(const Part& part, bool is_argument) const {
        const auto is = [](const Symbol* bracket, std::string_view tex) {
            return bracket != nullptr && bracket->tex == tex;
        };
        if (is(part.left, "langle") && is(part.right, "rangle"))
            return say(language_, "the mean of") + " " + ended(part.body, Phrase{"end of mean"});
        if (is(part.left, "|") && is(part.right, "|"))
            return say(language_, "the absolute value of {}",
                       ended(part.body, Phrase{"end of absolute value"}));
        if (is_argument)
            return say(language_, "of") + " " + ended(part.body, Phrase{"end of argument"});
        return spoken_symbol(part.left) + " " + inside(part.body) + " " + spoken_symbol(part.right);
    }

    // "the sum over i of", "the integral from 0 to infinity of".
    std::string operation(const Part& part) const {
        const std::string what = in_words(part.symbol->spoken);
        const bool below = !part.below_index.empty(), above = !part.above_index.empty();
        const std::string low = inside(part.below_index), high = inside(part.above_index);
        if (below && above) return say(language_, "{} from {} to {} of", what, low, high);
        if (below) return say(language_, "{} over {} of", what, low);
        if (above) return say(language_, "{} up to {} of", what, high);
        return say(language_, "{} of", what);
    }

    void say_indices(const Part& part) {
        if (!part.below_index.empty()) add(say(language_, "sub {}", inside(part.below_index)));
        std::span<const Part> power = part.above_index;
        while (!power.empty() && is_symbol(power.front(), "prime")) {
            add(say(language_, "prime"));
            power = power.subspan(1);
        }
        if (power.empty()) return;
        if (power.size() == 1 && !power[0].has_indices() && is_symbol(power[0], "2"))
            add(say(language_, "squared"));
        else if (power.size() == 1 && !power[0].has_indices() && is_symbol(power[0], "3"))
            add(say(language_, "cubed"));
        else
            add(say(language_, "to the power {}", ended(power, Phrase{"end of power"})));
    }

    Language language_;
    std::string said_;
};

std::string escaped(std::string_view letters) {
    std::string text;
    for (const char c : letters) {
        if (c == '<')
            text += "&lt;";
        else if (c == '>')
            text += "&gt;";
        else if (c == '&')
            text += "&amp;";
        else
            text += c;
    }
    return text;
}

std::string row(std::span<const Part> parts);

std::string in_mathml(const Part& part) {
    const auto bracket = [](const Symbol* one) {
        return one == nullptr ? std::string()
                              : fmt::format("<mo fence=\"true\">{}</mo>", escaped(one->letter));
    };
    switch (part.of) {
        case Part::Of::symbol: {
            const std::string letter = escaped(part.symbol->letter);
            if (part.kind == Class::opening || part.kind == Class::closing || letter == "|")
                return "<mo stretchy=\"false\">" + letter + "</mo>";
            if (part.kind != Class::ordinary || letter == "/") return "<mo>" + letter + "</mo>";
            return part.symbol->is_slanted ? "<mi>" + letter + "</mi>"
                                           : "<mi mathvariant=\"normal\">" + letter + "</mi>";
        }
        case Part::Of::group:
            return row(part.body);
        case Part::Of::fraction:
            return "<mfrac>" + row(part.body) + row(part.below) + "</mfrac>";
        case Part::Of::root:
            return "<msqrt>" + row(part.body) + "</msqrt>";
        case Part::Of::accent:
            return fmt::format("<mover accent=\"true\">{}<mo>{}</mo></mover>", row(part.body),
                               part.symbol->letter);
        case Part::Of::fenced:
            return "<mrow>" + bracket(part.left) + row(part.body) + bracket(part.right) + "</mrow>";
        case Part::Of::upright:
            return part.kind == Class::operation || part.words.size() == 1
                       ? "<mi mathvariant=\"normal\">" + escaped(part.words) + "</mi>"
                       : "<mtext>" + escaped(part.words) + "</mtext>";
        case Part::Of::space:
            return fmt::format("<mspace width=\"{:.3g}em\"/>", part.width / 18.0);
    }
    return {};
}

std::string with_indices(const Part& part, const std::string& nucleus) {
    const bool has_limits = part.of == Part::Of::symbol && part.symbol->tex == "sum";
    const bool above = !part.above_index.empty(), below = !part.below_index.empty();
    if (!above && !below) return nucleus;
    std::string name = has_limits ? "m" : "ms";
    if (below) name += has_limits ? "under" : "ub";
    if (above) name += has_limits ? "over" : below ? "sup" : "up";
    return "<" + name + ">" + nucleus + (below ? row(part.below_index) : "") +
           (above ? row(part.above_index) : "") + "</" + name + ">";
}

std::string row(std::span<const Part> parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::string number;
        while (i < parts.size() && is_digit(parts[i])) {
            number += parts[i].symbol->tex;
            if (parts[i].has_indices() || i + 1 == parts.size() || !is_digit(parts[i + 1])) break;
            ++i;
        }
        text += with_indices(parts[i],
                             number.empty() ? in_mathml(parts[i]) : "<mn>" + number + "</mn>");
    }
    return parts.size() == 1 ? text : "<mrow>" + text + "</mrow>";
}

}  // namespace

std::string spoken(Language language, const Parts& formula) {
    return Speaker(language).speak(formula);
}

std::string spoken_text(Language language, std::string_view text) {
    std::string words;
    for (const Span& span : spans_of(text))
        words += span.is_formula ? spoken(language, parsed(span.text)) : span.text;
    return words;
}

std::string mathml(const Parts& formula) {
    return "<math xmlns=\"http://www.w3.org/1998/Math/MathML\">" + row(formula) + "</math>";
}

}  // namespace carom::formula
