#include "validation/study.h"

#include <utility>

namespace carom::validation {

std::vector<Study> all_studies() {
    std::vector<Study> all;
    for (auto* field : {pressures, kinetic_theory, equilibria, wires, gravity, pistons, baths,
                        partitions, billiards, flows, drags})
        for (Study& study : field()) all.push_back(std::move(study));
    return all;
}

}  // namespace carom::validation
