#include "util/formula/symbols.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace carom::formula {
namespace {

using enum Class;

// Characters that a formula may contain directly, in addition to letters and digits.
const std::vector<Symbol>& characters() {
    static const std::vector<Symbol> all{
        {"+", "+", binary, false, Phrase{"plus"}},
        {"-", "−", binary, false, Phrase{"minus"}},
        {"/", "/", ordinary, false, Phrase{"over"}},
        {"=", "=", relation, false, Phrase{"equals"}},
        {"<", "<", relation, false, Phrase{"is less than"}},
        {">", ">", relation, false, Phrase{"is greater than"}},
        {":", ":", relation, false, Phrase{"to"}},
        {"(", "(", opening, false, Phrase{"open bracket"}},
        {")", ")", closing, false, Phrase{"close bracket"}},
        {"[", "[", opening, false, Phrase{"open square bracket"}},
        {"]", "]", closing, false, Phrase{"close square bracket"}},
        {"|", "|", ordinary, false, Phrase{"bar"}},
        {",", ",", punctuation, false},
        {";", ";", punctuation, false},
        {".", ".", ordinary, false, Phrase{"point"}},
        {"!", "!", closing, false, Phrase{"factorial"}},
    };
    return all;
}

const std::vector<Symbol>& named() {
    static const std::vector<Symbol> all{
        {"alpha", "α", ordinary, true, Phrase{"alpha"}},
        {"beta", "β", ordinary, true, Phrase{"beta"}},
        {"gamma", "γ", ordinary, true, Phrase{"gamma"}},
        {"delta", "δ", ordinary, true, Phrase{"delta"}},
        {"epsilon", "ϵ", ordinary, true, Phrase{"epsilon"}},
        {"varepsilon", "ε", ordinary, true, Phrase{"epsilon"}},
        {"zeta", "ζ", ordinary, true, Phrase{"zeta"}},
        {"eta", "η", ordinary, true, Phrase{"eta"}},
        {"theta", "θ", ordinary, true, Phrase{"theta"}},
        {"iota", "ι", ordinary, true, Phrase{"iota"}},
        {"kappa", "κ", ordinary, true, Phrase{"kappa"}},
        {"lambda", "λ", ordinary, true, Phrase{"lambda"}},
        {"mu", "μ", ordinary, true, Phrase{"mu"}},
        {"nu", "ν", ordinary, true, Phrase{"nu"}},
        {"xi", "ξ", ordinary, true, Phrase{"xi"}},
        {"pi", "π", ordinary, true, Phrase{"pi"}},
        {"rho", "ρ", ordinary, true, Phrase{"rho"}},
        {"sigma", "σ", ordinary, true, Phrase{"sigma"}},
        {"tau", "τ", ordinary, true, Phrase{"tau"}},
        {"upsilon", "υ", ordinary, true, Phrase{"upsilon"}},
        {"phi", "ϕ", ordinary, true, Phrase{"phi"}},
        {"varphi", "φ", ordinary, true, Phrase{"phi"}},
        {"chi", "χ", ordinary, true, Phrase{"chi"}},
        {"psi", "ψ", ordinary, true, Phrase{"psi"}},
        {"omega", "ω", ordinary, true, Phrase{"omega"}},
        {"Gamma", "Γ", ordinary, false, Phrase{"capital gamma"}},
        {"Delta", "Δ", ordinary, false, Phrase{"capital delta"}},
        {"Theta", "Θ", ordinary, false, Phrase{"capital theta"}},
        {"Lambda", "Λ", ordinary, false, Phrase{"capital lambda"}},
        {"Xi", "Ξ", ordinary, false, Phrase{"capital xi"}},
        {"Pi", "Π", ordinary, false, Phrase{"capital pi"}},
        {"Sigma", "Σ", ordinary, false, Phrase{"capital sigma"}},
        {"Phi", "Φ", ordinary, false, Phrase{"capital phi"}},
        {"Psi", "Ψ", ordinary, false, Phrase{"capital psi"}},
        {"Omega", "Ω", ordinary, false, Phrase{"capital omega"}},
        {"partial", "∂", ordinary, true, Phrase{"partial"}},
        {"infty", "∞", ordinary, false, Phrase{"infinity"}},
        {"prime", "′", ordinary, false, Phrase{"prime"}},
        {"cdot", "·", binary, false, Phrase{"times"}},
        {"times", "×", binary, false, Phrase{"times"}},
        {"pm", "±", binary, false, Phrase{"plus or minus"}},
        {"leq", "≤", relation, false, Phrase{"is at most"}},
        {"geq", "≥", relation, false, Phrase{"is at least"}},
        {"neq", "≠", relation, false, Phrase{"is not"}},
        {"approx", "≈", relation, false, Phrase{"is about"}},
        {"sim", "∼", relation, false, Phrase{"goes as"}},
        {"equiv", "≡", relation, false, Phrase{"is defined as"}},
        {"propto", "∝", relation, false, Phrase{"is proportional to"}},
        {"ll", "≪", relation, false, Phrase{"is much less than"}},
        {"gg", "≫", relation, false, Phrase{"is much greater than"}},
        {"to", "→", relation, false, Phrase{"goes to"}},
        {"langle", "⟨", opening, false, Phrase{"the mean of"}},
        {"rangle", "⟩", closing, false},
        {"sum", "∑", operation, false, Phrase{"the sum"}},
        {"int", "∫", operation, false, Phrase{"the integral"}},
    };
    return all;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> synonyms{
    {{"le", "leq"}, {"ge", "geq"}, {"ne", "neq"}, {"rightarrow", "to"}}};

const std::vector<Symbol>& accents() {
    static const std::vector<Symbol> all{
        {"bar", "‾", ordinary, false, Phrase{"bar"}},
        {"hat", "^", ordinary, false, Phrase{"hat"}},
        {"vec", "→", ordinary, false, Phrase{"vector"}},
        {"dot", "˙", ordinary, false, Phrase{"dot"}},
    };
    return all;
}

constexpr std::array<std::pair<std::string_view, Phrase>, 7> functions{
    {{"exp", Phrase{"the exponential of"}},
     {"ln", Phrase{"the natural logarithm of"}},
     {"log", Phrase{"the logarithm of"}},
     {"sin", Phrase{"the sine of"}},
     {"cos", Phrase{"the cosine of"}},
     {"tan", Phrase{"the tangent of"}},
     {"tanh", Phrase{"the hyperbolic tangent of"}}}};

const Symbol* by_tex(const std::vector<Symbol>& symbols, std::string_view tex) {
    const auto found = std::ranges::find(symbols, tex, &Symbol::tex);
    return found == symbols.end() ? nullptr : &*found;
}

std::map<std::string, Symbol, std::less<>> all_letters() {
    std::map<std::string, Symbol, std::less<>> letters;
    const auto add = [&](const Symbol& symbol) {
        letters.emplace(symbol.tex, symbol);
        letters.emplace(symbol.letter, symbol);
    };
    for (char c = 'a'; c <= 'z'; ++c) {
        const std::string small(1, c), large(1, static_cast<char>(c - 'a' + 'A'));
        add({small, small, ordinary, true});
        add({large, large, ordinary, true});
    }
    for (char c = '0'; c <= '9'; ++c) add({std::string(1, c), std::string(1, c), ordinary, false});
    for (const Symbol& symbol : characters()) add(symbol);
    for (const Symbol& symbol : named()) letters.emplace(symbol.letter, symbol);
    return letters;
}

}  // namespace

const Symbol* symbol_of_letter(std::string_view letter) {
    static const auto letters = all_letters();
    const auto found = letters.find(letter);
    return found == letters.end() ? nullptr : &found->second;
}

const Symbol* symbol_of_command(std::string_view name) {
    const auto synonym = std::ranges::find(synonyms, name, &decltype(synonyms)::value_type::first);
    return by_tex(named(), synonym == synonyms.end() ? name : synonym->second);
}

const Symbol* accent_of_command(std::string_view name) { return by_tex(accents(), name); }

const Symbol* bracket_of(std::string_view name) {
    if (std::string_view("()[]|").find(name) != std::string_view::npos && name.size() == 1)
        return symbol_of_letter(name);
    return name == "langle" || name == "rangle" ? symbol_of_command(name) : nullptr;
}

Phrase spoken_function(std::string_view name) {
    const auto found = std::ranges::find(functions, name, &decltype(functions)::value_type::first);
    return found == functions.end() ? Phrase{} : found->second;
}

const std::vector<std::string>& commands() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> names{"frac", "sqrt", "left", "right", "mathrm", "text", "quad"};
        for (const Symbol& symbol : named()) names.push_back(symbol.tex);
        for (const Symbol& symbol : accents()) names.push_back(symbol.tex);
        for (const auto& [name, spoken] : functions) names.emplace_back(name);
        for (const auto& [name, its] : synonyms) names.emplace_back(name);
        return names;
    }();
    return all;
}

}  // namespace carom::formula
