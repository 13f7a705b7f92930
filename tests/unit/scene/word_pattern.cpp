// Words as patterns of disks: whole, apart, inside of their region, as many as asked for.
#include "scene/lettering/word_pattern.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "physics/placement/placement.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Gas gas_of(const std::string& item) {
    return test::scene_from("title: T\nbox: {size: [40, 30]}\ngas: [{" + item +
                            "}]\nrun: {until: 1}\n")
        .gas;
}

const std::vector<Vec>& places_in(const Gas& gas) {
    return std::get<Places>(gas.species[0].position).values;
}

double least_distance(const std::vector<Vec>& places) {
    double least = 1e300;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, length(places[i] - places[j]));
    return least;
}

// The word drawn with characters, a row for each row of cells.
std::vector<std::string> picture(const WordShape& shape) {
    std::vector<std::string> rows(static_cast<std::size_t>(shape.rows),
                                  std::string(static_cast<std::size_t>(shape.columns), ' '));
    for (const Eigen::Array2i& cell : shape.cells)
        rows[static_cast<std::size_t>(shape.rows - 1 - cell[1])]
            [static_cast<std::size_t>(cell[0])] = 'o';
    return rows;
}

}  // namespace

TEST_CASE("letters stand upright, from left to right") {
    CHECK(picture(word_shape("Lt!")) == std::vector<std::string>{"o     ooooo o",  //
                                                                 "o       o   o",  //
                                                                 "o       o   o",  //
                                                                 "o       o   o",  //
                                                                 "o       o   o",  //
                                                                 "o       o    ",  //
                                                                 "ooooo   o   o"});
    CHECK(picture(word_shape("gas")) == picture(word_shape("GAS")));
    CHECK(word_shape("").cells.empty());
}

TEST_CASE("every letter has a shape of its own, seven rows high") {
    std::vector<std::vector<std::string>> seen;
    for (const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.!?-+=";
         const char letter : letters) {
        const WordShape shape = word_shape(std::string(1, letter));
        CAPTURE(letter);
        CHECK(shape.rows == 7);
        CHECK(!shape.cells.empty());
        CHECK(std::ranges::find(seen, picture(shape)) == seen.end());
        seen.push_back(picture(shape));
    }
    CHECK(!word_shape("♥").cells.empty());
    CHECK(!word_shape("☺").cells.empty());
    CHECK(letters_without_shape("GÄS € Gä☺") == std::vector<std::string>{"Ä", "€", "ä"});
}

TEST_CASE("a word fills its region and no more, its disks apart") {
    struct Part {
        const char* text;
        Vec from, to;
        int filled;  // axis
    };
    for (const Part& part :
         {Part{"[4, 8, 36, 22]", {4, 8}, {36, 22}, 0}, Part{"[4, 1, 14, 29]", {4, 1}, {14, 29}, 0},
          Part{"[4, 8, 36, 14]", {4, 8}, {36, 14}, 1}}) {
        CAPTURE(part.text);
        const Gas gas =
            gas_of("radius: 0.2, position: {text: GAS, within: " + std::string(part.text) + "}");
        const auto& places = places_in(gas);
        CHECK(gas.species[0].count == static_cast<std::int64_t>(places.size()));
        CHECK(least_distance(places) >= 0.4);
        Vec low = places[0], high = places[0];
        for (const Vec& place : places) {
            low = lower(low, place);
            high = upper(high, place);
        }
        for (const int axis : {0, 1}) {
            CHECK(low[axis] >= part.from[axis] + 0.2);
            CHECK(high[axis] <= part.to[axis] - 0.2);
        }
        // Half a step is left at both ends of the side that it fills, and as much on both sides.
        CHECK(low[part.filled] - part.from[part.filled] < 1.0);
        CHECK(longest(abs(low + high - part.from - part.to), 2) < 1e-9);
        CHECK_NOTHROW(place(gas));
    }
}

TEST_CASE("a word has as many disks as asked for") {
    for (const int count : {20, 39, 40, 132, 350}) {
        const Gas gas = gas_of("radius: 0.3, count: " + std::to_string(count) +
                               ", position: {text: GAS, within: [4, 8, 36, 22]}");
        CHECK(gas.species[0].count == count);
        CHECK(places_in(gas).size() == static_cast<std::size_t>(count));
        CHECK(least_distance(places_in(gas)) >= 0.6);
    }
}

TEST_CASE("what is left out of a word is spread over it") {
    const WordShape shape = word_shape("GAS");
    const Region region{{0, 0}, {17, 7}};
    const auto all = static_cast<std::int64_t>(shape.cells.size());
    const auto places = places_of(shape, region, 1, all - 3);
    int holes[3] = {};
    for (const Eigen::Array2i& cell : shape.cells) {
        const Vec at(cell[0] + 0.5, cell[1] + 0.5);
        const bool is_there = std::ranges::any_of(
            places, [&](const Vec& place) { return longest(abs(place - at), 2) < 0.1; });
        if (!is_there) ++holes[cell[1] * 3 / 7];
    }
    CHECK(holes[0] + holes[1] + holes[2] == 3);
    CHECK(std::ranges::max(holes) <= 2);
}
