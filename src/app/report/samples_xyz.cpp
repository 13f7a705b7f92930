#include "app/report/samples_xyz.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string_view>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/membership.h"
#include "util/csv.h"

namespace carom {
namespace {

constexpr std::array<std::string_view, 118> elements{
    "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",
    "S",  "Cl", "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn",
    "Ga", "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh",
    "Pd", "Ag", "Cd", "In", "Sn", "Sb", "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd",
    "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu", "Hf", "Ta", "W",  "Re",
    "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra", "Ac", "Th",
    "Pa", "U",  "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr", "Rf", "Db",
    "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og"};

std::string_view symbol_of(std::size_t species) {
    return species < elements.size() ? elements[species] : "X";
}

// What readers take in a quoted value, each in its own way, is written as a blank.
std::string plain(std::string name) {
    for (char& letter : name)
        if (std::string_view("\"'\\{}[](),=").find(letter) != std::string_view::npos ||
            static_cast<unsigned char>(letter) < ' ')
            letter = ' ';
    return name;
}

std::string lattice_of(const Box& box) {
    const auto length = [&](int axis) { return axis < box.dimension ? box.size[axis] : 1.0; };
    return fmt::format("Lattice=\"{} 0 0 0 {} 0 0 0 {}\"", length(0), length(1), length(2));
}

std::string periodic_sides(const Box& box) {
    const auto flag = [&](int axis) {
        return box.dimension > axis && box.is_periodic(axis) ? 'T' : 'F';
    };
    return fmt::format("pbc=\"{} {} {}\"", flag(0), flag(1), flag(2));
}

}  // namespace

SamplesXyz::SamplesXyz(const Gas& gas, Output& output, UnitSystem units) : rows_(output) {
    before_time_ = lattice_of(gas.box) +
                   " Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1 Time=";
    after_time_ = " " + periodic_sides(gas.box) + " species_names=\"";
    for (std::size_t k = 0; k < gas.species.size(); ++k) {
        begins_.push_back(fmt::format("{}", symbol_of(k)));
        after_time_ +=
            fmt::format("{}{}: {}", k > 0 ? "; " : "", begins_.back(), plain(gas.species[k].name));
    }
    after_time_ += units == UnitSystem::real ? "\" units=\"nm ps u\"\n" : "\"\n";
}

void SamplesXyz::name_lines(const Particles& particles) {
    const Eigen::ArrayXd mass = masses(particles);
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        ends_.push_back(fmt::format(" {} {} {}\n", particles.radius[i], mass[i], i));
}

void SamplesXyz::add(const Particles& particles, const Sample& sample) {
    if (ends_.empty()) name_lines(particles);
    auto out = rows_.end();
    const Eigen::ArrayXi& species = species_at(sample, particles);
    const Eigen::Index count =
        sample.membership ? sample.membership->is_present.count() : particles.count();
    fmt::format_to(out, "{}\n{}{}{}", count, before_time_, csv_number(sample.time), after_time_);
    const auto add_vector = [&](const Eigen::ArrayXXd& values, Eigen::Index i) {
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            if (axis < values.cols())
                fmt::format_to(out, FMT_COMPILE(" {}"), values(i, axis));
            else
                fmt::format_to(out, " 0");
    };
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        if (!is_present(sample, i)) continue;
        fmt::format_to(out, "{}", begins_[static_cast<std::size_t>(species[i])]);
        add_vector(sample.position, i);
        add_vector(sample.velocity, i);
        fmt::format_to(out, "{}", ends_[static_cast<std::size_t>(i)]);
        rows_.end_row();
    }
}

}  // namespace carom
