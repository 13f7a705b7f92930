// Each law under each condition: that there is one, or the reason why there is none. A cell that is
// missing fails.
#include <doctest/doctest.h>

#include <array>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "physics/theory/law.h"
#include "support/gas_states.h"

using namespace carom;
using test::Condition;
using test::GasState;

namespace {

// In the order of NoLaw::Why.
constexpr std::array<const char*, reasons_count> words_of_reasons{"unknown_gas",
                                                                  "bath",
                                                                  "baths_differ",
                                                                  "driven",
                                                                  "piston",
                                                                  "membrane",
                                                                  "diffuse",
                                                                  "partitions",
                                                                  "obstacles",
                                                                  "gravity",
                                                                  "event",
                                                                  "reversal",
                                                                  "moving_infinite_mass",
                                                                  "fixed_particles",
                                                                  "no_finite_mass",
                                                                  "alone",
                                                                  "keeps_axes",
                                                                  "unhindered",
                                                                  "pair",
                                                                  "pair_only",
                                                                  "few",
                                                                  "many",
                                                                  "at_rest",
                                                                  "no_freedom",
                                                                  "drifts",
                                                                  "points",
                                                                  "line",
                                                                  "equal_masses",
                                                                  "few_between_ends",
                                                                  "few_on_ring",
                                                                  "parted",
                                                                  "keeps_order",
                                                                  "unknown_order",
                                                                  "rods",
                                                                  "no_room",
                                                                  "plane_only",
                                                                  "remembers",
                                                                  "one_axis",
                                                                  "bounded",
                                                                  "bounded_once",
                                                                  "unequal_masses",
                                                                  "unequal_radii",
                                                                  "dense",
                                                                  "freezes",
                                                                  "no_such_phase",
                                                                  "near_freezing",
                                                                  "no_cube",
                                                                  "off_center",
                                                                  "regions",
                                                                  "passes",
                                                                  "part_of_line",
                                                                  "near_wall",
                                                                  "no_walls",
                                                                  "no_gap",
                                                                  "wide_gap",
                                                                  "no_bath",
                                                                  "no_piston",
                                                                  "pistons",
                                                                  "no_force",
                                                                  "no_gravity",
                                                                  "no_floor",
                                                                  "many_kinds",
                                                                  "flies_on",
                                                                  "shapes",
                                                                  "no_board",
                                                                  "no_collisions",
                                                                  "few_collisions"};

std::string cell_of(const Law& law) {
    return law ? "yes" : words_of_reasons.at(static_cast<std::size_t>(law.none->why));
}

// A word for each condition, in their order: "yes" or the reason.
const std::map<LawOf, std::string>& table() {
    static const std::map<LawOf, std::string> rows{
        {LawOf::mean_energy,
         "yes yes yes yes gravity yes moving_infinite_mass yes baths_differ driven "
         "piston membrane partitions partitions obstacles event event event yes yes "
         "yes obstacles gravity obstacles yes yes no_finite_mass at_rest yes points "
         "gravity yes yes equal_masses yes yes yes equal_masses driven yes yes yes"},
        {LawOf::mean_speed,
         "yes yes yes yes gravity yes moving_infinite_mass yes baths_differ driven "
         "piston membrane partitions partitions obstacles event event event yes alone "
         "alone obstacles gravity obstacles yes pair no_finite_mass at_rest drifts "
         "points gravity yes yes equal_masses yes yes yes equal_masses driven yes alone yes"},
        {LawOf::bath,
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath yes baths_differ "
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath "
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath "
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath "
         "no_bath no_bath no_bath no_bath no_bath no_bath"},
        {LawOf::temperature,
         "yes yes yes yes gravity yes moving_infinite_mass yes baths_differ driven "
         "piston membrane partitions partitions obstacles event event event yes yes "
         "no_freedom obstacles gravity obstacles yes yes no_finite_mass at_rest yes "
         "yes gravity yes yes yes yes yes yes yes driven yes yes yes"},
        {LawOf::distribution,
         "yes yes yes yes gravity yes moving_infinite_mass bath baths_differ driven "
         "piston membrane partitions partitions obstacles event event event yes alone "
         "alone obstacles gravity obstacles yes pair no_finite_mass at_rest drifts "
         "points gravity yes yes equal_masses yes yes yes equal_masses driven yes alone yes"},
        {LawOf::side_distribution,
         "passes passes passes passes passes passes passes passes passes passes "
         "passes membrane yes passes passes passes event event passes passes passes "
         "passes passes passes passes passes passes passes passes passes passes line "
         "line line passes passes line line passes passes passes passes"},
        {LawOf::goodness_of_fit,
         "yes yes one_axis unequal_masses gravity fixed_particles moving_infinite_mass "
         "bath baths_differ driven piston membrane partitions partitions obstacles "
         "event event event yes alone alone obstacles gravity obstacles yes pair "
         "no_finite_mass at_rest drifts points gravity unequal_masses unequal_masses "
         "equal_masses yes yes unequal_masses equal_masses driven yes alone yes"},
        {LawOf::velocity_entropy,
         "yes yes yes yes gravity yes moving_infinite_mass bath baths_differ driven "
         "piston membrane partitions partitions obstacles event event event yes alone "
         "alone obstacles gravity obstacles yes pair no_finite_mass at_rest drifts "
         "points gravity yes yes equal_masses yes yes yes equal_masses driven yes alone yes"},
        {LawOf::position_entropy,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass yes "
         "baths_differ driven piston membrane partitions yes obstacles yes yes "
         "partitions yes yes yes obstacles gravity obstacles yes yes no_finite_mass "
         "at_rest yes yes gravity yes yes yes yes yes yes yes driven yes yes yes"},
        {LawOf::collision_rate,
         "yes yes yes yes gravity yes moving_infinite_mass bath baths_differ driven "
         "piston membrane partitions partitions obstacles event event event yes yes "
         "yes obstacles gravity obstacles yes yes yes yes yes yes gravity yes yes yes "
         "yes yes unknown_order yes driven yes yes yes"},
        {LawOf::mean_free_path,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event event yes alone alone obstacles gravity obstacles yes pair "
         "no_finite_mass at_rest drifts points gravity yes yes equal_masses yes yes "
         "unknown_order equal_masses driven yes alone yes"},
        {LawOf::ideal_pressure,
         "yes yes one_axis yes gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event event yes keeps_axes no_freedom obstacles gravity obstacles yes yes "
         "no_finite_mass at_rest yes yes gravity yes yes yes yes yes yes yes driven yes yes yes"},
        {LawOf::pressure,
         "yes yes one_axis yes gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event event yes keeps_axes no_freedom obstacles gravity obstacles few yes "
         "no_finite_mass at_rest yes yes gravity yes yes yes yes yes yes yes driven yes few yes"},
        {LawOf::contact,
         "yes yes yes unequal_masses gravity fixed_particles moving_infinite_mass yes "
         "baths_differ driven piston membrane partitions partitions obstacles yes "
         "event event yes unhindered unhindered obstacles gravity obstacles yes yes "
         "no_finite_mass at_rest yes points gravity line line line yes yes line line "
         "driven yes unhindered yes"},
        {LawOf::displacement,
         "bounded yes bounded_once yes bounded bounded moving_infinite_mass bounded "
         "bounded bounded bounded bounded bounded bounded bounded bounded bounded "
         "bounded bounded bounded unhindered bounded bounded bounded bounded pair "
         "no_finite_mass at_rest drifts bounded bounded keeps_order keeps_order "
         "keeps_order no_collisions few_collisions keeps_order keeps_order "
         "bounded_once bounded bounded bounded_once"},
        {LawOf::autocorrelation,
         "yes yes yes yes gravity yes moving_infinite_mass bath baths_differ driven "
         "piston membrane partitions partitions obstacles event event event reversal "
         "alone alone obstacles gravity obstacles yes pair no_finite_mass at_rest "
         "drifts points gravity yes yes equal_masses no_collisions few_collisions yes "
         "equal_masses driven yes alone yes"},
        {LawOf::free_flight,
         "many many many many many many many many many many many many many many many "
         "many many many many unhindered unhindered yes gravity flies_on many many "
         "many many many many many line line line many many line line many many unhindered many"},
        {LawOf::memoryless,
         "yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes yes "
         "unhindered unhindered yes yes yes pair_only pair_only no_finite_mass at_rest "
         "yes points points yes yes yes no_collisions yes yes yes yes yes unhindered yes"},
        {LawOf::flux,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event event yes alone alone obstacles gravity obstacles yes pair "
         "no_finite_mass at_rest drifts points gravity rods yes equal_masses yes yes "
         "rods equal_masses driven yes alone yes"},
        {LawOf::gap_flux,
         "partitions no_walls no_walls no_walls gravity fixed_particles "
         "fixed_particles bath bath driven piston membrane no_gap yes obstacles "
         "partitions no_gap no_gap partitions partitions no_walls obstacles gravity "
         "obstacles partitions no_walls no_finite_mass partitions no_walls partitions "
         "gravity line line line no_walls no_walls line line driven partitions partitions "
         "no_walls"},
        {LawOf::side_count,
         "regions regions regions regions gravity fixed_particles moving_infinite_mass "
         "bath bath driven piston membrane partitions yes obstacles event event event "
         "regions regions regions obstacles gravity obstacles regions regions "
         "no_finite_mass regions regions regions gravity regions regions regions "
         "regions regions regions regions driven regions regions regions"},
        {LawOf::side_energy,
         "regions regions regions regions gravity fixed_particles moving_infinite_mass "
         "bath bath driven piston membrane partitions yes obstacles event event event "
         "regions regions regions obstacles gravity obstacles regions regions "
         "no_finite_mass regions regions regions gravity regions regions regions "
         "regions regions regions regions driven regions regions regions"},
        {LawOf::side_temperature,
         "regions regions regions regions gravity fixed_particles moving_infinite_mass "
         "bath bath driven piston membrane partitions yes obstacles event event event "
         "regions regions regions obstacles gravity obstacles regions regions "
         "no_finite_mass regions regions regions gravity regions regions regions "
         "regions regions regions regions driven regions regions regions"},
        {LawOf::piston,
         "no_piston no_piston no_piston no_piston no_piston no_piston no_piston "
         "no_piston no_piston no_piston yes partitions partitions partitions no_piston "
         "no_piston partitions partitions no_piston no_piston no_piston no_piston "
         "no_piston no_piston no_piston no_piston no_piston no_piston no_piston "
         "no_piston no_piston no_piston no_piston no_piston no_piston no_piston "
         "no_piston no_piston no_piston no_piston no_piston no_piston"},
        {LawOf::isotherm,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass yes baths_differ yes "
         "yes partitions partitions partitions obstacles yes partitions partitions yes "
         "keeps_axes no_freedom obstacles obstacles obstacles few yes no_finite_mass "
         "at_rest yes points gravity yes yes yes yes yes yes yes driven yes few yes"},
        {LawOf::adiabat,
         "yes yes yes yes gravity fixed_particles moving_infinite_mass yes baths_differ yes "
         "yes partitions partitions partitions obstacles yes partitions partitions yes "
         "keeps_axes no_freedom obstacles obstacles obstacles few yes no_finite_mass "
         "at_rest yes points gravity yes yes yes yes yes yes yes driven yes few yes"},
        {LawOf::binomial,
         "no_board no_board no_board no_board no_board no_board no_board no_board no_board "
         "no_board "
         "no_board no_board no_board no_board no_board no_board no_board no_board no_board "
         "no_board "
         "no_board no_board no_board no_board no_board no_board no_finite_mass no_board no_board "
         "no_board no_board plane_only plane_only plane_only no_board no_board plane_only "
         "plane_only no_board no_board no_board "
         "no_board"},
        {LawOf::heights,
         "no_gravity no_gravity no_gravity no_gravity yes no_gravity "
         "moving_infinite_mass bath bath driven piston membrane partitions partitions "
         "obstacles event event event no_gravity no_gravity no_gravity obstacles "
         "obstacles obstacles no_gravity no_gravity no_gravity no_gravity no_gravity "
         "no_gravity points line line line no_gravity no_gravity line line driven no_gravity "
         "no_gravity no_gravity"},
        {LawOf::error_growth,
         "yes yes yes unequal_masses gravity fixed_particles moving_infinite_mass bath "
         "baths_differ driven piston membrane partitions partitions obstacles event "
         "event event yes few few obstacles gravity obstacles few few no_finite_mass "
         "at_rest yes points gravity line line line yes yes line "
         "line driven diffuse diffuse "
         "diffuse"},
        {LawOf::diffusion,
         "remembers remembers remembers remembers remembers remembers remembers remembers "
         "remembers "
         "remembers remembers remembers remembers remembers remembers remembers remembers "
         "remembers "
         "remembers remembers remembers remembers remembers remembers remembers remembers "
         "remembers "
         "remembers remembers remembers remembers keeps_order keeps_order "
         "keeps_order remembers remembers keeps_order keeps_order "
         "remembers remembers remembers remembers"}};
    return rows;
}

// The same for the conditions in space, which follow them.
const std::map<LawOf, std::string>& table_of_space() {
    static const std::map<LawOf, std::string> rows{
        {LawOf::mean_energy,
         "yes yes yes yes yes yes gravity gravity yes piston piston partitions "
         "partitions yes obstacles obstacles yes points yes yes yes"},
        {LawOf::mean_speed,
         "yes yes yes yes yes yes gravity gravity yes piston piston partitions "
         "partitions alone obstacles obstacles pair points yes yes yes"},
        {LawOf::bath,
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath yes no_bath "
         "no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath no_bath "
         "no_bath no_bath"},
        {LawOf::temperature,
         "yes yes yes yes yes yes gravity gravity yes piston piston partitions "
         "partitions yes obstacles obstacles yes yes yes yes yes"},
        {LawOf::distribution,
         "yes yes yes yes yes yes gravity gravity bath piston piston partitions "
         "partitions alone obstacles obstacles pair points yes yes yes"},
        {LawOf::side_distribution,
         "passes passes passes passes passes passes passes passes passes passes passes "
         "yes passes passes passes passes passes passes passes passes passes"},
        {LawOf::goodness_of_fit,
         "yes yes one_axis one_axis unequal_masses unequal_masses gravity gravity bath "
         "piston piston partitions partitions alone obstacles obstacles pair points yes "
         "yes yes"},
        {LawOf::velocity_entropy,
         "yes yes yes yes yes yes gravity gravity bath piston piston partitions "
         "partitions alone obstacles obstacles pair points yes yes yes"},
        {LawOf::position_entropy,
         "yes yes yes yes yes yes gravity gravity yes piston piston partitions yes yes "
         "obstacles obstacles yes yes yes yes yes"},
        {LawOf::collision_rate,
         "yes yes yes yes yes yes gravity gravity bath piston piston partitions "
         "partitions yes obstacles obstacles yes yes yes yes yes"},
        {LawOf::mean_free_path,
         "yes yes yes yes yes yes gravity gravity bath piston piston partitions "
         "partitions alone obstacles obstacles pair points yes yes yes"},
        {LawOf::ideal_pressure,
         "yes yes one_axis one_axis yes yes gravity gravity bath piston piston "
         "partitions partitions keeps_axes obstacles obstacles yes yes yes yes yes"},
        {LawOf::pressure,
         "yes yes one_axis one_axis yes yes gravity gravity bath piston piston "
         "partitions partitions keeps_axes obstacles obstacles yes yes yes yes freezes"},
        {LawOf::contact,
         "yes yes yes yes unequal_masses unequal_masses gravity gravity yes piston "
         "piston partitions partitions unhindered obstacles obstacles yes points yes yes "
         "freezes"},
        {LawOf::displacement,
         "bounded yes bounded_once bounded_once yes bounded bounded bounded bounded "
         "bounded bounded_once bounded bounded bounded bounded bounded pair bounded yes "
         "yes yes"},
        {LawOf::autocorrelation,
         "yes yes yes yes yes yes gravity gravity bath piston piston partitions "
         "partitions alone obstacles obstacles pair points yes yes yes"},
        {LawOf::free_flight,
         "many many many many many many many many many many many many many unhindered "
         "yes shapes many many many many many"},
        {LawOf::memoryless,
         "yes yes yes yes yes yes yes yes yes yes yes yes yes unhindered yes yes "
         "pair_only points yes yes yes"},
        {LawOf::flux,
         "yes yes yes yes yes unequal_radii gravity gravity bath piston piston "
         "partitions partitions alone obstacles obstacles pair points yes yes yes"},
        {LawOf::gap_flux,
         "partitions no_walls no_walls no_walls no_walls partitions gravity gravity bath "
         "piston piston no_gap yes partitions obstacles obstacles no_walls partitions "
         "no_walls no_walls no_walls"},
        {LawOf::side_count,
         "regions regions regions regions regions regions gravity gravity bath piston "
         "piston partitions yes regions obstacles obstacles regions regions regions "
         "regions regions"},
        {LawOf::side_energy,
         "regions regions regions regions regions regions gravity gravity bath piston "
         "piston partitions yes regions obstacles obstacles regions regions regions "
         "regions regions"},
        {LawOf::side_temperature,
         "regions regions regions regions regions regions gravity gravity bath piston "
         "piston partitions yes regions obstacles obstacles regions regions regions "
         "regions regions"},
        {LawOf::piston,
         "no_piston no_piston no_piston no_piston no_piston no_piston no_piston "
         "no_piston no_piston yes one_axis partitions partitions no_piston no_piston "
         "no_piston no_piston no_piston no_piston no_piston no_piston"},
        {LawOf::isotherm,
         "yes yes yes yes unequal_radii unequal_radii gravity gravity yes yes yes "
         "partitions partitions keeps_axes obstacles obstacles yes points yes yes "
         "freezes"},
        {LawOf::adiabat,
         "yes yes yes yes unequal_radii unequal_radii gravity gravity yes yes yes "
         "partitions partitions keeps_axes obstacles obstacles yes points yes yes "
         "freezes"},
        {LawOf::binomial,
         "plane_only plane_only plane_only plane_only plane_only plane_only plane_only "
         "plane_only plane_only plane_only plane_only plane_only plane_only plane_only "
         "plane_only plane_only plane_only plane_only plane_only plane_only plane_only"},
        {LawOf::heights,
         "no_gravity no_gravity no_gravity no_gravity no_gravity no_gravity yes gravity "
         "bath piston piston partitions partitions no_gravity obstacles obstacles "
         "no_gravity no_gravity no_gravity no_gravity no_gravity"},
        {LawOf::error_growth,
         "yes yes yes yes unequal_masses unequal_masses gravity gravity bath piston piston "
         "partitions partitions few obstacles obstacles few points yes yes yes"},
        {LawOf::diffusion,
         "bounded few bounded_once bounded_once unequal_masses bounded bounded bounded "
         "bounded bounded bounded_once bounded bounded bounded bounded bounded pair "
         "bounded yes near_freezing freezes"}};
    return rows;
}

std::vector<std::string> words_in(const std::string& row) {
    std::istringstream stream(row);
    return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

TEST_CASE("each law holds, or gives its reason, under each condition") {
    const std::vector<Condition> all = test::conditions();
    for (std::size_t k = 0; k < laws_count; ++k) {
        CAPTURE(k);
        REQUIRE(table().contains(LawOf(k)));
        REQUIRE(table_of_space().contains(LawOf(k)));
        const std::vector<std::string> row =
            words_in(table().at(LawOf(k)) + " " + table_of_space().at(LawOf(k)));
        REQUIRE(row.size() == all.size());
        for (std::size_t c = 0; c < all.size(); ++c) {
            CAPTURE(all[c].name);
            const GasState s = test::state_of(all[c]);
            CHECK(cell_of(law(s.boxed(), LawOf(k), s.asked)) == row[c]);
        }
    }
}

TEST_CASE("a picture without a gas has no law") {
    for (std::size_t k = 0; k < laws_count; ++k)
        CHECK(law({}, LawOf(k)).none->why == NoLaw::Why::unknown_gas);
}

TEST_CASE("every reason has words, in every language") {
    for (std::size_t k = 0; k < reasons_count; ++k)
        for (const Language language :
             {Language::english, Language::german, Language::french, Language::spanish}) {
            const NoLaw reason{static_cast<NoLaw::Why>(k)};
            CHECK(to_text(language, reason, {}).size() > 5);
            CHECK(to_text(language, reason, {test::disks(1)}).find("{}") == std::string::npos);
        }
}
