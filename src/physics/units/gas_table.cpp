#include "physics/units/gas_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace carom {
namespace {

// Masses of molecules are sums of the abridged standard atomic weights of the IUPAC: CIAAW,
// Abridged Standard Atomic Weights 2024 (ciaaw.org/abridged-atomic-weights.htm).
constexpr double hydrogen = 1.0080, helium = 4.0026, carbon = 12.011, nitrogen = 14.007,
                 oxygen = 15.999, fluorine = 18.998, neon = 20.180, sulphur = 32.06, argon = 39.95,
                 krypton = 83.798, xenon = 131.29;

// Of dry air with 0.04 % carbon dioxide: Picard, Davis, Glaser and Fujii, Metrologia 45, 149
// (2008), equation (2), 28.965 46 g/mol.
constexpr double air = 28.965;

// Viscosities at 300 K in micropascal seconds: Huber and Harvey, Viscosity of Gases, CRC Handbook
// of Chemistry and Physics (hbcp.chemnetbase.com, document 06_36), with uncertainties below 3 %,
// in the limit of low pressure or, for nitrogen, oxygen, carbon dioxide and air, at 1 bar, where
// they are less than 2 % higher.
constexpr std::array gases{
    NamedGas{Phrase{"helium"}, "He", helium, 19.9, 0.217, "#bf1f7f", true},
    NamedGas{Phrase{"neon"}, "Ne", neon, 31.9, 0.257, "#f2627a", true},
    NamedGas{Phrase{"argon"}, "Ar", argon, 22.7, 0.362, "#6e31ff", true},
    NamedGas{Phrase{"krypton"}, "Kr", krypton, 25.5, 0.411, "#04ad18", true},
    NamedGas{Phrase{"xenon"}, "Xe", xenon, 23.2, 0.482, "#2a93f7", true},
    NamedGas{Phrase{"hydrogen"}, "H₂", 2.0 * hydrogen, 8.9, 0.274, "#80799a", false},
    NamedGas{Phrase{"methane"}, "CH₄", carbon + 4.0 * hydrogen, 11.1, 0.412, "#337117", false},
    NamedGas{Phrase{"water vapour"}, "H₂O", 2.0 * hydrogen + oxygen, 9.8, 0.451, "#196d80", false},
    NamedGas{Phrase{"nitrogen"}, "N₂", 2.0 * nitrogen, 17.9, 0.373, "#5696eb", false},
    NamedGas{Phrase{"air"}, "air", air, 18.5, 0.370, "#3b5bf5", false},
    NamedGas{Phrase{"oxygen"}, "O₂", 2.0 * oxygen, 20.7, 0.358, "#b14827", false},
    NamedGas{Phrase{"carbon dioxide"}, "CO₂", carbon + 2.0 * oxygen, 15.0, 0.456, "#889a7e", false},
    NamedGas{Phrase{"sulphur hexafluoride"}, "SF₆", sulphur + 6.0 * fluorine, 15.3, 0.609,
             "#ef700e", false}};

}  // namespace

std::span<const NamedGas> named_gases() { return gases; }

const NamedGas* gas_named(std::string_view name) {
    const auto found =
        std::ranges::find_if(gases, [&](const NamedGas& gas) { return gas.name.english == name; });
    return found == gases.end() ? nullptr : &*found;
}

std::string plain_symbol(const NamedGas& gas) {
    std::string symbol(gas.symbol);
    for (const auto& [lowered, digit] :
         {std::pair{"₂", "2"}, std::pair{"₄", "4"}, std::pair{"₆", "6"}})
        if (const std::size_t at = symbol.find(lowered); at != std::string::npos)
            symbol.replace(at, std::string_view(lowered).size(), digit);
    return symbol;
}

}  // namespace carom
