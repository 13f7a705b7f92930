#include "physics/theory/no_law.h"

#include <array>

#include "physics/gas.h"

namespace carom {
namespace {

// In the order of NoLaw::Why.
constexpr std::array words{
    Phrase{"there is no gas"},
    Phrase{"a heat bath exchanges energy with the gas"},
    Phrase{"heat baths of different temperatures act on it"},
    Phrase{"a moving wall does work on it"},
    Phrase{"a piston exchanges energy with it"},
    Phrase{"a membrane selects particles"},
    Phrase{"a wall reflects diffusely"},
    Phrase{"partitions divide the box"},
    Phrase{"obstacles stand in the box"},
    Phrase{"gravity acts on it"},
    Phrase{"events change the walls, the energy or the velocities"},
    Phrase{"events change the velocities"},
    Phrase{"a particle of infinite mass moves, so that energy is not conserved"},
    Phrase{"particles of infinite mass stand in the way"},
    Phrase{"no particle has a finite mass"},
    Phrase{"a single particle has nothing to share its energy with"},
    Phrase{"a single particle keeps the energy of its motion along each axis"},
    Phrase{"a single particle has nothing to collide with"},
    Phrase{"in a periodic box two particles keep the energy of their relative motion"},
    Phrase{"two particles only collide with each other"},
    Phrase{"there are too few particles"},
    Phrase{"it is known for a single particle only"},
    Phrase{"all particles are at rest"},
    Phrase{"a single particle in a periodic box has no motion relative to its centre of mass"},
    Phrase{"it moves as a whole; the momentum of the given velocities is not zero"},
    Phrase{"points never meet"},
    Phrase{"it is known in a plane and in space only"},
    Phrase{"on a wire particles of equal mass only exchange their velocities"},
    Phrase{"between walls fewer than three beads need not be ergodic"},
    Phrase{"on a ring fewer than four beads need not be ergodic"},
    Phrase{"beads that never move separate those that do"},
    Phrase{"beads on a wire keep their order, so that none can go far from the others"},
    Phrase{"the order of the beads on the wire is not known before they are placed"},
    Phrase{"on a wire it is known for points only"},
    Phrase{"the particles fill all the room"},
    Phrase{"it is known for disks in a plane only"},
    Phrase{"in a plane velocities are remembered for too long"},
    Phrase{"momentum is conserved along some axes only"},
    Phrase{"the walls limit how far particles can move"},
    Phrase{"walls limit how far particles can move along some axes"},
    Phrase{"the masses differ"},
    Phrase{"the radii differ"},
    Phrase{"the gas is too dense for the theory of dilute gases"},
    Phrase{"at this density particles freeze"},
    Phrase{"of such a gas, or at this density, the phase is not known"},
    Phrase{"the gas is too near to freezing"},
    Phrase{"the box is not a cube"},
    Phrase{"the partition is not in the middle"},
    Phrase{"the parts are not two halves of the box"},
    Phrase{"particles pass from one part of the box to another"},
    Phrase{"the line does not reach from wall to wall"},
    Phrase{"the line is too near to a wall"},
    Phrase{"the box is periodic"},
    Phrase{"the partition has no gap"},
    Phrase{"the gaps are too wide"},
    Phrase{"there is no heat bath"},
    Phrase{"the wall does not move freely"},
    Phrase{"several walls move freely"},
    Phrase{"no force presses the piston onto the gas"},
    Phrase{"no gravity acts along this axis"},
    Phrase{"there is no floor along this axis"},
    Phrase{"there are too many kinds of particles"},
    Phrase{"walls reflect the particle without ending its flight"},
    Phrase{"the obstacles are not disks or spheres that leave room between them"},
    Phrase{"the obstacles are not staggered rows of pegs under gravity"},
    Phrase{"there have been no collisions yet"},
    Phrase{"there have been too few collisions"}};
static_assert(words.size() == reasons_count);

}  // namespace

std::string to_text(Language language, const NoLaw& reason, const std::vector<Species>& species) {
    const std::string name = reason.species < species.size() ? species[reason.species].name : "";
    if (reason.why == NoLaw::Why::moving_infinite_mass && !name.empty())
        return say(language, "`{}` has infinite mass and moves, so that energy is not conserved",
                   name);
    return say(language, words.at(static_cast<std::size_t>(reason.why)));
}

}  // namespace carom
