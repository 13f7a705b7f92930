// Where things stand: pictures of any shape are filled, panels share the room, words are broken at
// spaces.
#include "panels/layout.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

const std::vector<Slot> grid_of_four{{0, 0, 10, 4}, {12, 0, 10, 4}, {0, 5, 10, 4}, {12, 5, 10, 4}};

void check_slot(const Slot& slot, const Slot& wanted) {
    CHECK(slot.x == doctest::Approx(wanted.x));
    CHECK(slot.y == doctest::Approx(wanted.y));
    CHECK(slot.width == doctest::Approx(wanted.width));
    CHECK(slot.height == doctest::Approx(wanted.height));
}

}  // namespace

TEST_CASE("a grid fills a picture of any shape, and its unit fits both ways") {
    const LayoutSpec layout;  // 80 by 45
    const Grid square(layout, {800, 800});
    CHECK(square.unit() == doctest::Approx(10.0));
    const Rect whole = square.place({0, 0, 80, 45});
    CHECK(whole.right() == doctest::Approx(800.0));
    CHECK(whole.bottom() == doctest::Approx(800.0));
    const Grid wide(layout, {1600, 450});
    CHECK(wide.unit() == doctest::Approx(10.0));
    CHECK(wide.place({40, 0, 40, 45}).x == doctest::Approx(800.0));
}

TEST_CASE("fewer panels than places share a column or a row, and nothing else") {
    const std::vector<Slot> column{{0, 0, 10, 6}, {0, 7, 10, 6}, {0, 14, 10, 6}};
    const std::vector<Slot> two = shared_slots(column, 2);
    REQUIRE(two.size() == 2);
    check_slot(two[0], {0, 0, 10, 9.5});
    check_slot(two[1], {0, 10.5, 10, 9.5});
    check_slot(shared_slots(column, 1).front(), {0, 0, 10, 20});
    check_slot(shared_slots(column, 3)[1], column[1]);
    const std::vector<Slot> row{{2, 5, 10, 6}, {14, 5, 10, 6}, {26, 5, 10, 6}};
    check_slot(shared_slots(row, 1).front(), {2, 5, 34, 6});
    check_slot(shared_slots(row, 2)[1], {20, 5, 16, 6});
    const std::vector<Slot> of_four = shared_slots(grid_of_four, 3);
    REQUIRE(of_four.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) check_slot(of_four[i], grid_of_four[i]);
    std::vector<Slot> uneven = column;
    uneven[2].height = 5;
    check_slot(shared_slots(uneven, 2)[1], uneven[1]);
}

TEST_CASE("a panel that has enough leaves the rest of its height to those below and above") {
    const std::vector<Slot> column{{0, 0, 10, 6}, {0, 7, 10, 6}, {0, 14, 10, 6}};
    const std::vector<Slot> shared = with_heights(column, {2.0, {}, {}});
    check_slot(shared[0], {0, 0, 10, 2});
    check_slot(shared[1], {0, 3, 10, 8});
    check_slot(shared[2], {0, 12, 10, 8});
    check_slot(with_heights(column, {9.0, {}, {}})[1], column[1]);    // it has not even that
    check_slot(with_heights(column, {2.0, 2.0, 2.0})[1], column[1]);  // nobody wants more
    check_slot(with_heights(grid_of_four, {2.0, {}, {}, {}})[2], grid_of_four[2]);
}

namespace {

LayoutSpec layout_of(const std::string& name, PictureSize* size = nullptr) {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 3, speed: 1}]\nrun: {until: 1}\n"
        "film: {seconds: 1, panels: [], template: " +
        name + "}\n");
    if (size != nullptr) *size = scene.film.size;
    return scene.film.layout;
}

constexpr std::array all_templates{"hero",   "lecture",  "instrument", "data",   "side-by-side",
                                   "square", "portrait", "wide-gas",   "minimal"};

double area_of(const Slot& slot) { return slot.width * slot.height; }

// Of the picture.
double share_of_gas(const LayoutSpec& layout) {
    return area_of(layout.gas) / (layout.grid_width * layout.grid_height);
}

double share_of_gas_and_panels(const LayoutSpec& layout) {
    double area = area_of(layout.gas);
    for (const Slot& panel : layout.panels)
        if (!is_within(panel, layout.gas)) area += area_of(panel);
    return area / (layout.grid_width * layout.grid_height);
}

bool overlap(const Slot& a, const Slot& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

}  // namespace

TEST_CASE("no words are smaller than those at the back of a lecture hall can read") {
    for (const std::string name : all_templates) {
        CAPTURE(name);
        const double least = name == "portrait" ? 40.0 : 30.0;  // it is seen on phones
        PictureSize size;
        const LayoutSpec layout = layout_of(name, &size);
        CHECK(Grid(layout, size).unit() * 1080 / std::min(size.width, size.height) >= least - 1e-9);
    }
}

TEST_CASE("gas and panels have most of the picture") {
    for (const std::string name : all_templates) {
        CAPTURE(name);
        const LayoutSpec layout = layout_of(name);
        const bool is_alone = name == "hero" || name == "wide-gas" || name == "minimal";
        // The least has four panels, or two in less width.
        const bool has_little = name == "data" || name == "portrait";
        const double least = is_alone ? 0.7 : has_little ? 0.28 : name == "instrument" ? 0.26 : 0.4;
        CHECK(share_of_gas(layout) >= least);
        // The phone's title and captions have two lines.
        CHECK(share_of_gas_and_panels(layout) >= (name == "portrait" ? 0.58 : 0.63));
        // The key takes a line, not a column.
        CHECK(is_one_line(layout.color_bar));
        CHECK_FALSE(overlap(layout.color_bar, layout.gas));
    }
}

TEST_CASE("two boxes share a place, of one size, with words below each") {
    // Side by side 24 wide, above one another 8.1 high, 16.2 wide.
    LayoutSpec layout;
    layout.grid_width = 64;
    layout.grid_height = 36;
    const Grid square(layout, {640, 360});
    const auto wide = places_beside({1, 2, 50, 20}, 0.5, square, 2);
    for (const PlaceBeside& one : wide) {
        CHECK(one.box.width == wide[0].box.width);
        CHECK(one.box.height == doctest::Approx(0.5 * one.box.width));
        CHECK(one.box.y == wide[0].box.y);
        CHECK(one.box.y >= 2.0);
        CHECK(one.words.y == doctest::Approx(one.box.y + one.box.height));
        CHECK(one.words.y + one.words.height <= 22.0 + 1e-9);
        CHECK(one.words.x == one.box.x);
        CHECK(one.words.width == doctest::Approx(24.2));  // half of what the gap leaves
    }
    CHECK(wide[0].box.x == 1.0);
    CHECK(wide[1].box.x > wide[0].box.x + wide[0].box.width);
    CHECK(wide[1].box.x + wide[1].box.width == doctest::Approx(51.0));
    const auto three = places_beside({1, 2, 50, 20}, 0.5, square, 3);
    REQUIRE(three.size() == 3);
    CHECK(three[2].box.x + three[2].words.width == doctest::Approx(51.0));
    CHECK(three[2].box.x - three[1].box.x == doctest::Approx(three[1].box.x - three[0].box.x));
    // A tall place, or a line: one above the other.
    for (const auto& tall : {places_beside({0, 0, 20, 50}, 0.75, square, 2),
                             places_beside({0, 0, 40, 20}, 0.0, square, 2)}) {
        CHECK(tall[0].box.x == tall[1].box.x);
        CHECK(tall[1].box.y > tall[0].words.y + tall[0].words.height);
        CHECK(tall[0].box.height == tall[1].box.height);
    }
    // Lines for which that is too low, in a wide place.
    const auto lines = places_beside({0, 0, 60, 20}, 0.0, square, 2);
    CHECK(lines[0].box.y == lines[1].box.y);
    CHECK(lines[1].box.x > lines[0].box.x + lines[0].box.width);
    CHECK(lines[0].words.y + lines[0].words.height == doctest::Approx(20.0));
    // In pictures of other shapes the boxes have theirs in pixels, and the words are next to them.
    for (const PictureSize size : {PictureSize{960, 720}, PictureSize{360, 640}}) {
        const Grid grid(layout, size);
        for (const double shape : {0.3, 1.0, 2.0}) {
            const Slot place{2, 4, 60, 24};
            const auto both = places_beside(place, shape, grid, 2);
            const Rect whole = grid.place(place);
            double area = 0.0;
            for (const PlaceBeside& one : both) {
                const Rect box = grid.place(one.box), words = grid.place(one.words);
                CHECK(words.y == doctest::Approx(box.y + box.height));
                CHECK(words.height == doctest::Approx(1.9 * grid.unit()));
                CHECK(box.height == doctest::Approx(shape * box.width));
                CHECK(box.y >= whole.y);
                CHECK(words.y + words.height <= whole.y + whole.height + 1e-9);
                area = box.height * box.height / shape;
            }
            // As large as in the better one of two arrangements, which leave no more than the
            // words.
            const double beside = 0.5 * (whole.width - 1.6 * grid.unit());
            const double above = 0.5 * (whole.height - 1.6 * grid.unit()) - 1.9 * grid.unit();
            const double height =
                std::max(std::min(beside * shape, whole.height - 1.9 * grid.unit()),
                         std::min(above, whole.width * shape));
            CHECK(area == doctest::Approx(height * height / shape));
        }
    }
}
