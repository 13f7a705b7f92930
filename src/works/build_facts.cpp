#include "works/build_facts.h"

#include <fmt/format.h>

#include "physics/gas.h"
#include "physics/simulation.h"
#include "util/archive.h"
#include "util/fingerprint.h"
#include "works/source_fingerprint.h"

namespace carom {
namespace {

// The fingerprint of a run with sampled velocities, heat baths at sides and collisions of unequal
// disks, which uses those functions of the processor and of the mathematical library that runs
// depend on.
std::string fingerprint_of_physics() {
    Gas gas;
    gas.box.size = {10.0, 10.0};
    gas.box.surfaces.sides[0] = Bath{2.0};
    gas.species = {{.name = "",
                    .count = 40,
                    .radius = UniformDistribution{0.2, 0.4},
                    .mass = Density{1.0},
                    .velocity = Temperature{1.0}}};
    Run run;
    run.until = 10.0;
    Simulation simulation(gas, run);
    simulation.advance_to(run.until);
    Sample sample = simulation.sample();
    Archive archive;
    archive(sample.position, sample.velocity);
    return fingerprint(archive.finished());
}

}  // namespace

BuildFacts physics_build_facts() {
    static const BuildFacts facts{{"carom", CAROM_VERSION},
                                  {"source", source_fingerprint},
                                  {"physics", fingerprint_of_physics()}};
    return facts;
}

Json to_json(const BuildFacts& facts) {
    Json json = Json::object();
    for (const auto& [name, value] : facts) json[name] = value;
    return json;
}

std::string difference(const Json& one, const Json& other, const std::string& name_of_one,
                       const std::string& name_of_other) {
    const auto value = [](const Json& facts, const std::string& name) {
        const auto found = facts.find(name);
        return found == facts.end() ? std::string("nothing")
               : found->is_string() ? found->get<std::string>()
                                    : text_of(*found);
    };
    for (const auto& [name, unused] : one.items())
        if (value(one, name) != value(other, name))
            return fmt::format("{} differ: {} in {}, {} in {}", name, value(one, name), name_of_one,
                               value(other, name), name_of_other);
    return "";
}

}  // namespace carom
