// Archives: what is written is read back, and what is cut short or changed is refused.
#include "util/archive.h"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "util/diagnostics.h"

namespace carom {
namespace {

enum class Colour { red, green };

struct Inner {
    double number = 0.0;
    std::optional<std::string> name;
    void archive(Archive& archive) { archive(number, name); }
};

struct Outer {
    bool flag = false;
    Colour colour = Colour::red;
    std::int64_t count = 0;
    float small = 0.0F;
    std::vector<double> list;
    std::vector<Inner> nested;
    std::map<std::string, int> map;
    std::multimap<double, int> multimap;
    std::set<std::pair<double, int>> set;
    std::vector<bool> flags;
    std::array<std::pair<int, double>, 2> pairs{};
    Eigen::ArrayXd line;
    Eigen::ArrayXXd plane;
    Eigen::ArrayXi whole;
    Eigen::Array2d fixed{0.0, 0.0};
    std::variant<double, Inner> either, other;
    void archive(Archive& archive) {
        archive(flag, colour, count, small, list, nested, map, multimap, set, flags, pairs, line,
                plane, whole, fixed, either, other);
    }
};

Outer example() {
    Outer value;
    value.flag = true;
    value.colour = Colour::green;
    value.count = -(std::int64_t{1} << 60);
    value.small = 0.1F;
    value.list = {0.1, -0.0, std::numeric_limits<double>::infinity(), 5e-324};
    value.nested = {{0.3, "a name"}, {0.4, std::nullopt}, {0.5, std::string("\0\xff", 2)}};
    value.map = {{"one", 1}, {"two", 2}};
    value.multimap = {{0.5, 1}, {0.5, 2}, {0.1, 3}};
    value.set = {{0.5, 1}, {0.1, 7}};
    value.flags = {true, false, true};
    value.pairs = {std::pair{1, 0.1}, {2, 0.2}};
    value.line = Eigen::ArrayXd::LinSpaced(5, 0.0, 1.0);
    value.plane = Eigen::ArrayXXd::Constant(3, 2, 0.7);
    value.whole = Eigen::ArrayXi::LinSpaced(4, 0, 3);
    value.fixed = {1.5, 2.5};
    value.either = 0.6;
    value.other = Inner{0.7, "another"};
    return value;
}

std::string written(Outer value) {
    Archive archive;
    archive(value);
    return archive.finished();
}

Outer read(const std::string& bytes) {
    Archive archive(bytes, "film.plan");
    Outer value;
    archive(value);
    archive.expect_end();
    return value;
}

std::string refusal_of(const std::string& bytes) {
    try {
        read(bytes);
    } catch (const SystemError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("what an archive holds is read back, bit for bit") {
    const std::string bytes = written(example());
    const Outer value = read(bytes);
    CHECK(value.colour == Colour::green);
    CHECK(value.count == -(std::int64_t{1} << 60));
    CHECK(value.nested.at(1).name == std::nullopt);
    CHECK(value.nested.at(2).name == std::string("\0\xff", 2));
    CHECK(value.map.at("two") == 2);
    CHECK(value.multimap == example().multimap);
    CHECK(value.set == example().set);
    CHECK(value.flags == example().flags);
    CHECK(value.plane.rows() == 3);
    CHECK(value.fixed[1] == 2.5);
    CHECK(std::get<double>(value.either) == 0.6);
    CHECK(std::get<Inner>(value.other).name == "another");
    CHECK(written(value) == bytes);
}

TEST_CASE("an archive that is cut short anywhere is refused") {
    const std::string bytes = written(example());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        CAPTURE(size);
        CHECK(refusal_of(bytes.substr(0, size)).starts_with("cannot read film.plan: it"));
    }
    CHECK(refusal_of(bytes.substr(0, bytes.size() - 1)).find("cut short") != std::string::npos);
}

TEST_CASE("a list of a wrong size and an array of a wrong shape are refused") {
    Archive archive;
    std::uint64_t items = 5;
    double one = 1.0, another = 2.0;
    archive(items, one, another);
    Archive of_numbers(archive.finished(), "film.plan");
    std::vector<double> numbers;
    CHECK_THROWS_WITH_AS(of_numbers(numbers), "cannot read film.plan: it ends early", SystemError);
    CHECK(numbers.capacity() <= 2);
    Archive of_pairs(archive.finished(), "film.plan");
    std::vector<std::pair<double, double>> pairs;
    CHECK_THROWS_WITH_AS(of_pairs(pairs), "cannot read film.plan: it ends early", SystemError);
    Archive three;
    Eigen::ArrayXd line = Eigen::ArrayXd::LinSpaced(3, 0.0, 1.0);
    three(line);
    Archive of_three(three.finished(), "film.plan");
    Eigen::Array2d fixed{0.0, 0.0};
    CHECK_THROWS_WITH_AS(of_three(fixed),
                         "cannot read film.plan: it holds an array of another shape", SystemError);
}

TEST_CASE("an archive in which any byte was changed is refused") {
    const std::string bytes = written(example());
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        CAPTURE(at);
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 1);
        CHECK(refusal_of(changed) != "");
    }
}

TEST_CASE("an archive of something else is refused") {
    CHECK(refusal_of("title: A scene") == "cannot read film.plan: it was not written by carom");
    CHECK(refusal_of(written(example()) + "x") ==
          "cannot read film.plan: there are data after its end");
    Archive shorter;
    double number = 1.0;
    shorter(number);
    CHECK(refusal_of(shorter.finished()) == "cannot read film.plan: it ends early");
    Archive other;
    std::int64_t index = 2;
    other(index);
    Archive wrong(other.finished(), "film.plan");
    std::variant<double, Inner> either;
    CHECK_THROWS_WITH_AS(wrong(either),
                         "cannot read film.plan: it holds a value of an unknown type", SystemError);
    Archive archive(written(example()), "film.plan");
    archive(number);
    CHECK_THROWS_AS(archive.expect_end(), SystemError);
}

}  // namespace carom
