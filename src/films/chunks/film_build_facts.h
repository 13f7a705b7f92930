// What films depend on apart from their input: what runs depend on (works/build_facts.h), and the
// libraries that draw and encode.
#pragma once

#include "media/formats.h"
#include "works/build_facts.h"

namespace carom {

/// The facts that films in a format depend on: those of runs, then "pictures" and "encoder", each
/// of which gives the versions of libraries and a fingerprint of what they make of a reference
/// picture. Throws SystemError.
BuildFacts film_build_facts(const OutputFormat& format);

}  // namespace carom
