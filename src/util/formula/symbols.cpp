#include "util/formula/symbols.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace carom::formula {
namespace {

using enum Class;

// Characters that a formula may have as they are, beside letters and digits.
const std::vector<Symbol>& characters() {
    static const std::vector<Symbol> all{
        {"+", "+", binary, false, "plus"},
        {"-", "−", binary, false, "minus"},
        {"/", "/", ordinary, false, "over"},
        {"=", "=", relation, false, "equals"},
        {"<", "<", relation, false, "is less than"},
        {">", ">", relation, false, "is greater than"},
        {":", ":", relation, false, "to"},
        {"(", "(", opening, false, "open bracket"},
        {")", ")", closing, false, "close bracket"},
        {"[", "[", opening, false, "open square bracket"},
        {"]", "]", closing, false, "close square bracket"},
        {"|", "|", ordinary, false, "bar"},
        {",", ",", punctuation, false, ","},
        {";", ";", punctuation, false, ";"},
        {".", ".", ordinary, false, "point"},
        {"!", "!", closing, false, "factorial"},
    };
    return all;
}

const std::vector<Symbol>& named() {
    static const std::vector<Symbol> all{
        {"alpha", "α", ordinary, true, "alpha"},
        {"beta", "β", ordinary, true, "beta"},
        {"gamma", "γ", ordinary, true, "gamma"},
        {"delta", "δ", ordinary, true, "delta"},
        {"epsilon", "ϵ", ordinary, true, "epsilon"},
        {"varepsilon", "ε", ordinary, true, "epsilon"},
        {"zeta", "ζ", ordinary, true, "zeta"},
        {"eta", "η", ordinary, true, "eta"},
        {"theta", "θ", ordinary, true, "theta"},
        {"iota", "ι", ordinary, true, "iota"},
        {"kappa", "κ", ordinary, true, "kappa"},
        {"lambda", "λ", ordinary, true, "lambda"},
        {"mu", "μ", ordinary, true, "mu"},
        {"nu", "ν", ordinary, true, "nu"},
        {"xi", "ξ", ordinary, true, "xi"},
        {"pi", "π", ordinary, true, "pi"},
        {"rho", "ρ", ordinary, true, "rho"},
        {"sigma", "σ", ordinary, true, "sigma"},
        {"tau", "τ", ordinary, true, "tau"},
        {"upsilon", "υ", ordinary, true, "upsilon"},
        {"phi", "ϕ", ordinary, true, "phi"},
        {"varphi", "φ", ordinary, true, "phi"},
        {"chi", "χ", ordinary, true, "chi"},
        {"psi", "ψ", ordinary, true, "psi"},
        {"omega", "ω", ordinary, true, "omega"},
        {"Gamma", "Γ", ordinary, false, "capital gamma"},
        {"Delta", "Δ", ordinary, false, "capital delta"},
        {"Theta", "Θ", ordinary, false, "capital theta"},
        {"Lambda", "Λ", ordinary, false, "capital lambda"},
        {"Xi", "Ξ", ordinary, false, "capital xi"},
        {"Pi", "Π", ordinary, false, "capital pi"},
        {"Sigma", "Σ", ordinary, false, "capital sigma"},
        {"Phi", "Φ", ordinary, false, "capital phi"},
        {"Psi", "Ψ", ordinary, false, "capital psi"},
        {"Omega", "Ω", ordinary, false, "capital omega"},
        {"partial", "∂", ordinary, true, "partial"},
        {"infty", "∞", ordinary, false, "infinity"},
        {"prime", "′", ordinary, false, "prime"},
        {"cdot", "·", binary, false, "times"},
        {"times", "×", binary, false, "times"},
        {"pm", "±", binary, false, "plus or minus"},
        {"leq", "≤", relation, false, "is at most"},
        {"geq", "≥", relation, false, "is at least"},
        {"neq", "≠", relation, false, "is not"},
        {"approx", "≈", relation, false, "is about"},
        {"sim", "∼", relation, false, "goes as"},
        {"equiv", "≡", relation, false, "is defined as"},
        {"propto", "∝", relation, false, "is proportional to"},
        {"ll", "≪", relation, false, "is much less than"},
        {"gg", "≫", relation, false, "is much greater than"},
        {"to", "→", relation, false, "to"},
        {"langle", "⟨", opening, false, "the mean of"},
        {"rangle", "⟩", closing, false, ""},
        {"sum", "∑", operation, false, "the sum of"},
        {"int", "∫", operation, false, "the integral of"},
    };
    return all;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> synonyms{
    {{"le", "leq"}, {"ge", "geq"}, {"ne", "neq"}, {"rightarrow", "to"}}};

const std::vector<Symbol>& accents() {
    static const std::vector<Symbol> all{
        {"bar", "‾", ordinary, false, "bar"},
        {"hat", "^", ordinary, false, "hat"},
        {"vec", "→", ordinary, false, "vector"},
        {"dot", "˙", ordinary, false, "dot"},
    };
    return all;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 7> functions{
    {{"exp", "the exponential of"},
     {"ln", "the natural logarithm of"},
     {"log", "the logarithm of"},
     {"sin", "the sine of"},
     {"cos", "the cosine of"},
     {"tan", "the tangent of"},
     {"tanh", "the hyperbolic tangent of"}}};

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
        add({small, small, ordinary, true, small});
        add({large, large, ordinary, true, large});
    }
    for (char c = '0'; c <= '9'; ++c)
        add({std::string(1, c), std::string(1, c), ordinary, false, std::string(1, c)});
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

std::string_view spoken_function(std::string_view name) {
    const auto found = std::ranges::find(functions, name, &decltype(functions)::value_type::first);
    return found == functions.end() ? std::string_view{} : found->second;
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
