// What results depend on apart from their input: the build of the program, and its libraries. Two
// machines on which all facts are equal give the same bytes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "runs/json.h"

namespace carom {

/// Names and values, always in the same order: "carom", the version; "source", a fingerprint of the
/// files that it was compiled from; "physics", a fingerprint of the final state of a short
/// reference run. Other results may depend on more.
using BuildFacts = std::vector<std::pair<std::string, std::string>>;

/// The facts that runs of the physics depend on. May be called from any thread.
BuildFacts physics_build_facts();

Json to_json(const BuildFacts& facts);

/// The differences in words, "pictures: A in one, B in the other"; empty if there are none.
std::string difference(const Json& one, const Json& other, const std::string& name_of_one,
                       const std::string& name_of_other);

}  // namespace carom
