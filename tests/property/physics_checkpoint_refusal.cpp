// A checkpoint of a simulation that is damaged or of another one is refused.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "physics/box.h"
#include "physics/gas.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/simulation.h"
#include "support/checkpoint.h"
#include "util/archive.h"
#include "util/diagnostics.h"
#include "util/fingerprint.h"

using namespace carom;
using test::a_gas, test::CheckpointCase, test::restored, test::start_of, test::written;

namespace {

std::optional<std::string> refusal_of(const CheckpointCase& its, const Simulation& simulation,
                                      const std::string& bytes) {
    try {
        restored(simulation, its.run, bytes);
    } catch (const SystemError& error) {
        return error.what();
    }
    return std::nullopt;
}

// An archive whole in itself, with other content.
std::string sealed_again(const std::string& bytes, const std::string& content) {
    std::string length;
    for (std::size_t k = 0; k < 8; ++k)
        length += static_cast<char>(content.size() >> (8 * k) & 0xff);
    return bytes.substr(0, 12) + length + fingerprint(content) + content;
}

constexpr std::size_t header_size = 8 + 4 + 8 + 32;

}  // namespace

TEST_CASE("a checkpoint that is cut short or changed is refused") {
    const CheckpointCase its = a_gas(12);
    Simulation simulation = start_of(its);
    simulation.advance_to(2.0);
    const std::string bytes = written(simulation);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 16) {
        CAPTURE(size);
        REQUIRE(refusal_of(its, simulation, bytes.substr(0, size)));
    }
    for (std::size_t at = 0; at < bytes.size(); at += 1 + at / 64) {
        CAPTURE(at);
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 0x40);
        REQUIRE(refusal_of(its, simulation, changed));
    }
}

TEST_CASE(
    "a checkpoint whose content is wrong in a whole archive neither crashes nor takes memory") {
    for (const int bits : {53, 128}) {
        CAPTURE(bits);
        const CheckpointCase its = a_gas(6, bits);
        Simulation simulation = start_of(its);
        simulation.advance_to(2.0);
        const std::string bytes = written(simulation), content = bytes.substr(header_size);
        REQUIRE_FALSE(refusal_of(its, simulation, sealed_again(bytes, content)));
        for (std::size_t size = 0; size < content.size(); size += 1 + size / 200) {
            CAPTURE(size);
            REQUIRE(refusal_of(its, simulation, sealed_again(bytes, content.substr(0, size))));
        }
        for (std::size_t at = 0; at < content.size(); at += 1 + at / 500) {
            CAPTURE(at);
            std::string changed = content;
            changed[at] = static_cast<char>(changed[at] ^ 0x55);
            CHECK_NOTHROW(refusal_of(its, simulation, sealed_again(bytes, changed)));
        }
    }
}

TEST_CASE("a checkpoint of another gas or another kind of run is refused") {
    const CheckpointCase its = a_gas(12);
    Simulation simulation = start_of(its);
    simulation.advance_to(1.0);
    const std::string bytes = written(simulation);
    const auto refused = [&](const CheckpointCase& other) {
        const Simulation another = start_of(other);
        const auto cause = refusal_of(other, another, bytes);
        return cause && cause->find("another kind") != std::string::npos;
    };
    CHECK_FALSE(refused(its));
    CHECK(refused(a_gas(13)));
    CHECK(refused(a_gas(12, 64)));
    CheckpointCase other = its;
    other.gas.species[0].radius = 0.21;
    CHECK(refused(other));
    other = its;
    other.gas.box.size[0] = 8.5;
    CHECK(refused(other));
    other = its;
    other.gas.box.walls[0] = Wall::periodic;
    CHECK(refused(other));
    other = its;
    other.gas.box.surfaces.sides[1] = Bath{1.0};
    CHECK(refused(other));
    other = its;
    other.run.time_step = 0.1;
    CHECK(refused(other));
    other = its;
    other.run.events = {{1.0, Heat{{}, 1.0}}};
    CHECK(refused(other));
}

TEST_CASE("a simulation that refuses a checkpoint stays as it was") {
    const CheckpointCase its = a_gas(12), other = a_gas(13);
    Simulation simulation = start_of(its), another = start_of(other);
    simulation.advance_to(1.0);
    another.advance_to(0.5);
    const std::string before = written(another);
    Archive archive(written(simulation), "checkpoint");
    CHECK_THROWS_AS(another.archive(archive), SystemError);
    CHECK(written(another) == before);
}

TEST_CASE("numbers of many bits are read back with every bit") {
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<Real> numbers{Real(0.0),           Real(-0.0, 64), Real(infinity, 300),
                              Real(-infinity),     Real(5e-324),   sqrt(Real(2.0, 16'384)),
                              -sqrt(Real(3.0, 65))};
    for (int bits = 53; bits < 140; ++bits) numbers.push_back(Real(1.0, bits) / 3.0);
    Archive archive;
    archive(numbers);
    Archive again(archive.finished(), "numbers");
    std::vector<Real> read;
    again(read);
    REQUIRE(read.size() == numbers.size());
    for (std::size_t k = 0; k < read.size(); ++k) {
        CAPTURE(k);
        CHECK(read[k].bits() == numbers[k].bits());
        CHECK(read[k] == numbers[k]);
        const auto one = static_cast<double>(read[k]), other = static_cast<double>(numbers[k]);
        CHECK(std::signbit(one) == std::signbit(other));
    }
    Archive of_none;
    std::vector<Real> none{Real(std::numeric_limits<double>::quiet_NaN(), 80)};
    of_none(none);
    Archive none_again(of_none.finished(), "numbers");
    none_again(read);
    CHECK(read.at(0).bits() == 80);
    CHECK(std::isnan(static_cast<double>(read[0])));
}
