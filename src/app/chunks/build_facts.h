// What results depend on beside their input: the program that was built, and its libraries. Two
// machines where all facts are the same give the same bytes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "media/formats.h"
#include "runs/json.h"

namespace carom {

/// Names and values, in one order: "carom" its version, "source" a fingerprint of the files that it
/// was compiled from, "physics" one of the final state of a short reference run; of films also
/// "pictures" and "encoder", each versions of libraries and a fingerprint of what they make of a
/// reference picture.
using BuildFacts = std::vector<std::pair<std::string, std::string>>;

/// Of runs of the physics. May be called from any thread.
BuildFacts physics_facts();

/// Of films in a format. Throws SystemError.
BuildFacts film_facts(const OutputFormat& format);

Json to_json(const BuildFacts& facts);

/// What differs, in words: "pictures: A in one, B in the other"; empty if all are the same.
std::string difference(const Json& one, const Json& other, const std::string& name_of_one,
                       const std::string& name_of_other);

}  // namespace carom
