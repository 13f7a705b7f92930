#include "scene/lettering/word_pattern.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "util/text.h"

namespace carom {
namespace {

constexpr int height = 7;

struct Letter {
    std::string_view name;
    std::array<std::string_view, height> rows;  // from the top
};

constexpr std::array letters{
    Letter{"A", {".###.", "#...#", "#...#", "#####", "#...#", "#...#", "#...#"}},
    Letter{"B", {"####.", "#...#", "#...#", "####.", "#...#", "#...#", "####."}},
    Letter{"C", {".####", "#....", "#....", "#....", "#....", "#....", ".####"}},
    Letter{"D", {"####.", "#...#", "#...#", "#...#", "#...#", "#...#", "####."}},
    Letter{"E", {"#####", "#....", "#....", "####.", "#....", "#....", "#####"}},
    Letter{"F", {"#####", "#....", "#....", "####.", "#....", "#....", "#...."}},
    Letter{"G", {".####", "#....", "#....", "#..##", "#...#", "#...#", ".###."}},
    Letter{"H", {"#...#", "#...#", "#...#", "#####", "#...#", "#...#", "#...#"}},
    Letter{"I", {"###", ".#.", ".#.", ".#.", ".#.", ".#.", "###"}},
    Letter{"J", {"..###", "....#", "....#", "....#", "....#", "#...#", ".###."}},
    Letter{"K", {"#...#", "#..#.", "#.#..", "##...", "#.#..", "#..#.", "#...#"}},
    Letter{"L", {"#....", "#....", "#....", "#....", "#....", "#....", "#####"}},
    Letter{"M", {"#...#", "##.##", "#.#.#", "#.#.#", "#...#", "#...#", "#...#"}},
    Letter{"N", {"#...#", "##..#", "##..#", "#.#.#", "#..##", "#..##", "#...#"}},
    Letter{"O", {".###.", "#...#", "#...#", "#...#", "#...#", "#...#", ".###."}},
    Letter{"P", {"####.", "#...#", "#...#", "####.", "#....", "#....", "#...."}},
    Letter{"Q", {".###.", "#...#", "#...#", "#...#", "#.#.#", "#..#.", ".##.#"}},
    Letter{"R", {"####.", "#...#", "#...#", "####.", "#.#..", "#..#.", "#...#"}},
    Letter{"S", {".####", "#....", "#....", ".###.", "....#", "....#", "####."}},
    Letter{"T", {"#####", "..#..", "..#..", "..#..", "..#..", "..#..", "..#.."}},
    Letter{"U", {"#...#", "#...#", "#...#", "#...#", "#...#", "#...#", ".###."}},
    Letter{"V", {"#...#", "#...#", "#...#", "#...#", ".#.#.", ".#.#.", "..#.."}},
    Letter{"W", {"#...#", "#...#", "#...#", "#.#.#", "#.#.#", "##.##", "#...#"}},
    Letter{"X", {"#...#", "#...#", ".#.#.", "..#..", ".#.#.", "#...#", "#...#"}},
    Letter{"Y", {"#...#", "#...#", ".#.#.", "..#..", "..#..", "..#..", "..#.."}},
    Letter{"Z", {"#####", "....#", "...#.", "..#..", ".#...", "#....", "#####"}},
    Letter{"0", {".###.", "#...#", "#..##", "#.#.#", "##..#", "#...#", ".###."}},
    Letter{"1", {".#.", "##.", ".#.", ".#.", ".#.", ".#.", "###"}},
    Letter{"2", {".###.", "#...#", "....#", "..##.", ".#...", "#....", "#####"}},
    Letter{"3", {".###.", "#...#", "....#", "..##.", "....#", "#...#", ".###."}},
    Letter{"4", {"...#.", "..##.", ".#.#.", "#..#.", "#####", "...#.", "...#."}},
    Letter{"5", {"#####", "#....", "####.", "....#", "....#", "#...#", ".###."}},
    Letter{"6", {"..##.", ".#...", "#....", "####.", "#...#", "#...#", ".###."}},
    Letter{"7", {"#####", "....#", "...#.", "..#..", ".#...", ".#...", ".#..."}},
    Letter{"8", {".###.", "#...#", "#...#", ".###.", "#...#", "#...#", ".###."}},
    Letter{"9", {".###.", "#...#", "#...#", ".####", "....#", "...#.", ".##.."}},
    Letter{" ", {"...", "...", "...", "...", "...", "...", "..."}},
    Letter{".", {".", ".", ".", ".", ".", ".", "#"}},
    Letter{"!", {"#", "#", "#", "#", "#", ".", "#"}},
    Letter{"?", {".###.", "#...#", "....#", "..##.", "..#..", ".....", "..#.."}},
    Letter{"-", {"....", "....", "....", "####", "....", "....", "...."}},
    Letter{"+", {".....", "..#..", "..#..", "#####", "..#..", "..#..", "....."}},
    Letter{"=", {".....", ".....", "#####", ".....", "#####", ".....", "....."}},
    Letter{"♥", {".##.##.", "#######", "#######", "#######", ".#####.", "..###..", "...#..."}},
    Letter{"☺", {"..###..", ".#...#.", "#.#.#.#", "#.....#", "#.#.#.#", ".#.#.#.", "..###.."}},
};

// Returns the first UTF-8 character of a text.
std::string_view next_of(std::string_view text) { return text.substr(0, next_code_point(text, 0)); }

const Letter* letter_of(std::string_view name) {
    const bool small = name.size() == 1 && name[0] >= 'a' && name[0] <= 'z';
    const char capital = small ? static_cast<char>(name[0] - 'a' + 'A') : '\0';
    const std::string_view wanted = small ? std::string_view(&capital, 1) : name;
    const auto found = std::ranges::find(letters, wanted, &Letter::name);
    return found == letters.end() ? nullptr : &*found;
}

}  // namespace

const char* const letters_with_shape = "A to Z, 0 to 9, spaces and . ! ? - + = ♥ ☺";

double WordShape::cell_in(const Region& region) const {
    const Vec size = region.high - region.low;
    return std::min(size[0] / columns, size[1] / rows);
}

WordShape word_shape(const std::string& words) {
    WordShape shape{.columns = 0, .rows = height, .cells = {}};
    for (std::string_view rest = words; !rest.empty(); rest.remove_prefix(next_of(rest).size())) {
        const Letter* letter = letter_of(next_of(rest));
        if (letter == nullptr) continue;
        if (shape.columns > 0) ++shape.columns;  // between letters
        for (int row = 0; row < height; ++row) {
            const std::string_view line = letter->rows[static_cast<std::size_t>(height - 1 - row)];
            for (std::size_t column = 0; column < line.size(); ++column)
                if (line[column] == '#')
                    shape.cells.emplace_back(shape.columns + static_cast<int>(column), row);
        }
        shape.columns += static_cast<int>(letter->rows[0].size());
    }
    return shape;
}

std::vector<std::string> letters_without_shape(const std::string& words) {
    std::vector<std::string> without;
    for (std::string_view rest = words; !rest.empty(); rest.remove_prefix(next_of(rest).size())) {
        const std::string letter(next_of(rest));
        if (letter_of(letter) == nullptr && std::ranges::find(without, letter) == without.end())
            without.push_back(letter);
    }
    return without;
}

std::vector<Vec> places_of(const WordShape& shape, const Region& region, int across,
                           std::int64_t count) {
    const double cell = shape.cell_in(region), step = cell / across;
    const Vec corner = 0.5 * (region.low + region.high - cell * Vec(shape.columns, shape.rows));
    std::vector<Eigen::Array2i> dots;  // on the grid of dots
    for (const Eigen::Array2i& at : shape.cells)
        for (int i = 0; i < across; ++i)
            for (int j = 0; j < across; ++j) dots.push_back(across * at + Eigen::Array2i(i, j));
    std::ranges::sort(dots, [](const Eigen::Array2i& a, const Eigen::Array2i& b) {
        return a[1] != b[1] ? a[1] > b[1] : a[0] < b[0];
    });
    const auto middle_of = [](const Eigen::Array2i& dot) {
        return Vec(dot[0] + 0.5, dot[1] + 0.5);
    };
    std::vector<Vec> places;
    const auto all = static_cast<std::int64_t>(dots.size());
    for (std::int64_t i = 0; i < all; ++i)
        if ((i + 1) * count / all > i * count / all)
            places.push_back(corner + step * middle_of(dots[static_cast<std::size_t>(i)]));
    return places;
}

}  // namespace carom
