// Reads panels that are not plots: dials, numbers, text, a single collision, boxes of disks and
// lines of beads.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "readback/checks.h"

namespace carom::test {
namespace {

double distance(Spot a, Spot b) { return std::hypot(a.x - b.x, a.y - b.y); }

std::string off_by(const std::string& what, double pixels) {
    return what + " is " + std::to_string(pixels) + " pixels off";
}

template <class Wanted>
std::vector<Edges> rectangles(const DrawnFigure& figure, const Wanted& is_wanted) {
    std::vector<Edges> all;
    for (const Shape& shape : figure.picture.shapes)
        if (const auto edges = shape.is_stroke ? std::nullopt : shape.rectangle();
            edges && is_wanted(*edges, shape))
            all.push_back(*edges);
    return all;
}

// Concentric circles read as one disk: the radius of the largest, the colour of the last drawn.
struct Disk {
    Spot middle;
    double radius;
    Paint paint;
};

std::vector<Disk> disks_of(const DrawnFigure& figure) {
    constexpr double same = 0.02;  // pixels
    std::vector<Disk> disks;
    for (const Shape& shape : figure.picture.shapes) {
        const auto circle = shape.is_stroke ? std::nullopt : shape.circle();
        if (!circle) continue;
        const auto known = std::ranges::find_if(
            disks, [&](const Disk& disk) { return distance(disk.middle, circle->middle) < same; });
        if (known == disks.end()) {
            disks.push_back({circle->middle, circle->radius, shape.paint});
            continue;
        }
        known->radius = std::max(known->radius, circle->radius);
        known->paint = shape.paint;
    }
    return disks;
}

const Disk& nearest(const std::vector<Disk>& disks, Spot to) {
    return *std::ranges::min_element(disks, {},
                                     [&](const Disk& disk) { return distance(disk.middle, to); });
}

std::vector<Tick> level_ticks(const DrawnFigure& figure, double from, double to) {
    constexpr double longest = 8.0, near = 3.0, beside = 25.0;  // pixels
    std::vector<Tick> ticks;
    const std::vector<Said> texts = texts_of(figure.picture);
    for (const Shape& shape : figure.picture.shapes) {
        const std::vector<Spot> ends = shape.is_stroke ? shape.corners() : std::vector<Spot>{};
        if (ends.size() != 2 || ends[0].y != ends[1].y || ends[0].x < from || ends[1].x > to ||
            ends[1].x - ends[0].x > longest)
            continue;
        for (const Said& text : texts)
            if (const auto value = number_in(text.words);
                value && std::abs(text.ink.middle().y - ends[0].y) < near &&
                text.ink.right < ends[0].x && text.ink.right > ends[0].x - beside)
                ticks.push_back({ends[0].y, *value});
    }
    return ticks;
}

// Checks the error bar to the right of a column that shows a mean: its ends are one standard error
// away.
std::optional<std::string> error_bar_problem(const DrawnFigure& figure, const Edges& column,
                                             const LinearMap& up, const Row& row) {
    constexpr double beside = 25.0;  // pixels
    const double value = number(row, "value"), error = number(row, "standard error");
    for (const Shape& shape : figure.picture.shapes) {
        const std::vector<Spot> ends = shape.is_stroke ? shape.corners() : std::vector<Spot>{};
        if (ends.size() != 2 || ends[0].x != ends[1].x || ends[0].x < column.right ||
            ends[0].x > column.right + beside)
            continue;
        const double low = std::max(ends[0].y, ends[1].y) - up(value - error);
        const double high = std::min(ends[0].y, ends[1].y) - up(value + error);
        if (std::abs(low) <= half_a_pixel && std::abs(high) <= half_a_pixel) return {};
        return off_by("the bar of an error", std::max(std::abs(low), std::abs(high)));
    }
    return "a mean without a bar";
}

}  // namespace

Problems thermometer_problems(const DrawnFigure& figure) {
    Problems problems;
    const std::vector<Disk> disks = disks_of(figure);
    const std::vector<Edges> columns = rectangles(figure, [&](const Edges& edges, const Shape&) {
        return std::ranges::any_of(disks, [&](const Disk& bulb) {
            return distance(bulb.middle, {edges.middle().x, edges.bottom}) < 0.1;
        });
    });
    const std::vector<Row> rows = rows_of(figure, "thermometer");
    if (columns.size() != rows.size()) return {"not as many columns as numbers"};
    double left = 0.0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const std::vector<Tick> ticks = level_ticks(figure, left, columns[k].left);
        if (ticks.size() < 2) return {"a scale without numbers"};
        const LinearMap up = fitted(ticks);
        for (const Tick& tick : ticks)
            if (std::abs(up(tick.value) - tick.at) > half_a_pixel)
                problems.push_back(off_by("a tick", up(tick.value) - tick.at));
        const double off = columns[k].top - up(number(rows[k], "value"));
        if (!(std::abs(off) <= half_a_pixel))
            problems.push_back(off_by("the column of " + rows[k].at("of"), off));
        if (rows[k].contains("standard error"))
            if (auto problem = error_bar_problem(figure, columns[k], up, rows[k]))
                problems.push_back(*std::move(problem));
        left = columns[k].right;
    }
    return problems;
}

namespace {

// The angle clockwise from the top, in [0, 2 pi).
double angle_of(Spot from, Spot to) {
    const double angle = std::atan2(to.x - from.x, from.y - to.y);
    return angle < -1e-6 ? angle + 2.0 * std::numbers::pi : angle;
}

// The long ticks of a dial, each with the number inside of it.
std::vector<Tick> ticks_around(const DrawnFigure& figure, Spot middle, double radius) {
    std::vector<std::pair<Spot, Spot>> marks;
    double longest = 0.0;
    for (const Shape& shape : figure.picture.shapes) {
        const std::vector<Spot> ends = shape.is_stroke ? shape.corners() : std::vector<Spot>{};
        if (ends.size() != 2 || distance(ends[0], middle) > 1.5 * radius) continue;
        longest = std::max(longest, distance(ends[0], ends[1]));
        marks.emplace_back(ends[0], ends[1]);
    }
    std::vector<Tick> ticks;
    const std::vector<Said> texts = texts_of(figure.picture);
    for (const auto& [outer, inner] : marks) {
        if (distance(outer, inner) < 0.9 * longest) continue;
        double least = 0.5 * radius;
        std::optional<double> value;
        for (const Said& text : texts) {
            const double apart = distance(text.ink.middle(), inner);
            if (!number_in(text.words) || apart > least ||
                distance(text.ink.middle(), middle) > radius)
                continue;
            least = apart;
            value = number_in(text.words);
        }
        if (value) ticks.push_back({angle_of(middle, outer), *value});
    }
    // Start at the smallest number, so that angles increase beyond the top.
    std::ranges::sort(ticks, {}, &Tick::value);
    for (std::size_t i = 1; i < ticks.size(); ++i)
        while (ticks[i].at < ticks[i - 1].at) ticks[i].at += 2.0 * std::numbers::pi;
    return ticks;
}

// Checks the error arc between ticks and rim of a dial that shows a mean: its ends are one standard
// error away.
std::optional<std::string> error_arc_problem(const DrawnFigure& figure, Spot hub, double length,
                                             const LinearMap& around, const Row& row) {
    constexpr double inner = 1.05, outer = 1.14;  // lengths of the needle
    const double value = number(row, "value"), error = number(row, "standard error");
    for (const Shape& shape : figure.picture.shapes) {
        const std::vector<Spot> corners = shape.is_stroke ? shape.corners() : std::vector<Spot>{};
        if (corners.size() < 10 || !std::ranges::all_of(corners, [&](Spot corner) {
                const double apart = distance(corner, hub) / length;
                return apart > inner && apart < outer;
            }))
            continue;
        double most = 0.0;
        for (const auto& [end, wanted] : {std::pair{corners.front(), value - error},
                                          std::pair{corners.back(), value + error}}) {
            const double turned = angle_of(hub, end) - around(wanted);
            most =
                std::max(most, length * std::abs(std::remainder(turned, 2.0 * std::numbers::pi)));
        }
        if (most <= half_a_pixel) return {};
        return off_by("the arc of an error", most);
    }
    return "a mean without an arc";
}

}  // namespace

Problems needle_problems(const DrawnFigure& figure) {
    Problems problems;
    std::size_t needles = 0;
    const std::vector<Disk> disks = disks_of(figure);
    for (const Shape& shape : figure.picture.shapes) {
        const std::vector<Spot> corners = shape.is_stroke ? std::vector<Spot>{} : shape.corners();
        if (corners.size() != 3 || needles == figure.table.size()) continue;
        const Row& row = figure.table[needles++];
        const Spot foot{0.5 * (corners[0].x + corners[2].x), 0.5 * (corners[0].y + corners[2].y)};
        const Disk& hub = nearest(disks, foot);
        const double length = distance(hub.middle, corners[1]);
        const std::vector<Tick> ticks = ticks_around(figure, hub.middle, length);
        if (ticks.size() < 2) return {"a dial without numbers"};
        const LinearMap around = fitted(ticks);
        for (const Tick& tick : ticks)
            if (std::abs(around(tick.value) - tick.at) * length > half_a_pixel)
                problems.push_back(off_by("a tick", (around(tick.value) - tick.at) * length));
        const double turned = angle_of(hub.middle, corners[1]) - around(number(row, "value"));
        const double off = length * std::remainder(turned, 2.0 * std::numbers::pi);
        if (!(std::abs(off) <= half_a_pixel))
            problems.push_back(off_by("the needle of " + row.at("of"), off));
        if (!row.contains("standard error")) continue;
        if (auto problem = error_arc_problem(figure, hub.middle, length, around, row))
            problems.push_back(*std::move(problem));
    }
    if (needles != figure.table.size() || needles == 0)
        problems.push_back("not as many needles as numbers");
    return problems;
}

Problems counter_problems(const DrawnFigure& figure) {
    Problems problems;
    const std::vector<Edges> plates = rectangles(figure, [&](const Edges& edges, const Shape&) {
        return edges.width() > 20.0 && edges.height() > 9.0 &&
               edges.width() < figure.picture.width - 1.0;
    });
    if (plates.size() != figure.table.size()) return {"not as many plates as numbers"};
    for (std::size_t k = 0; k < plates.size(); ++k) {
        std::string shown;
        for (const Said& text : texts_of(figure.picture)) {
            const Spot at = text.ink.middle();
            if (at.x > plates[k].left && at.x < plates[k].right && at.y > plates[k].top &&
                at.y < plates[k].bottom)
                shown += text.words;
        }
        if (number_in(shown) != number(figure.table[k], "value"))
            problems.push_back(figure.table[k].at("of") + " reads " + shown);
    }
    return problems;
}

Problems monitor_problems(const DrawnFigure& figure) {
    Problems problems;
    std::vector<std::string> shown;
    for (const Said& text : texts_of(figure.picture))
        if (number_in(text.words)) shown.push_back(text.words);
    if (shown.size() != figure.table.size()) return {"not as many numbers as in the table"};
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const double off = std::abs(*number_in(shown[k]) - number(figure.table[k], "value"));
        if (!(off <= rounding_of(shown[k]) * (1.0 + 1e-9)))
            problems.push_back(figure.table[k].at("of") + " reads " + shown[k]);
    }
    return problems;
}

Problems text_problems(const DrawnFigure& figure, const std::string& words) {
    std::string all;
    for (const Said& text : texts_of(figure.picture)) all += text.words + " ";
    if (all.find(words) == std::string::npos) return {"the words read: " + all};
    if (!figure.table.empty()) return {"words have a table"};
    return {};
}

namespace {

struct DrawnArrow {
    Spot from, tip;
};

std::vector<DrawnArrow> arrows_of(const DrawnFigure& figure) {
    std::vector<DrawnArrow> arrows;
    for (const Shape& shape : figure.picture.shapes) {
        const std::vector<Spot> c = shape.is_stroke ? std::vector<Spot>{} : shape.corners();
        if (c.size() == 7)
            arrows.push_back({{0.5 * (c[0].x + c[6].x), 0.5 * (c[0].y + c[6].y)}, c[3]});
    }
    return arrows;
}

// Three pictures side by side, each centred on its centre of mass.
struct Stages {
    std::vector<Disk> particles, centers;
    double scale = 0.0;

    Spot place(std::size_t stage, const Row& row) const {
        const Spot& middle = centers[stage].middle;
        return {middle.x + scale * number(row, "x (length)"),
                middle.y - scale * number(row, "y (length)")};
    }
};

Stages stages_of(const DrawnFigure& figure) {
    Stages stages;
    const std::vector<Disk> disks = disks_of(figure);
    const double largest = std::ranges::max_element(disks, {}, &Disk::radius)->radius;
    for (const Disk& disk : disks)
        (disk.radius > 0.3 * largest ? stages.particles : stages.centers).push_back(disk);
    std::ranges::sort(stages.centers, {}, [](const Disk& disk) { return disk.middle.x; });
    double radius = 0.0;
    for (const Row& row : rows_of(figure, "particle"))
        radius = std::max(radius, number(row, "radius (length)"));
    stages.scale = largest / radius;
    return stages;
}

}  // namespace

Problems collision_problems(const DrawnFigure& figure) {
    const Stages stages = stages_of(figure);
    if (stages.particles.size() != 6 || stages.centers.size() != 3)
        return {"not three pictures of two particles"};
    Problems problems;
    const std::vector<DrawnArrow> arrows = arrows_of(figure);
    double reach = 0.0;  // pixels of a unit of speed
    for (std::size_t i = 0; i < figure.table.size(); ++i) {
        const Row& row = figure.table[i];
        const std::string name = row.at("part") + " " + row.at("of") + " " + row.at("stage");
        const Spot place = stages.place(i / 3, row);
        if (row.at("part") == "particle") {
            const Disk& disk = nearest(stages.particles, place);
            const double off = distance(disk.middle, place);
            if (!(off <= half_a_pixel)) problems.push_back(off_by(name, off));
            const double radius = stages.scale * number(row, "radius (length)");
            if (!(std::abs(disk.radius - radius) <= half_a_pixel))
                problems.push_back(off_by("the radius of " + name, disk.radius - radius));
        }
        const double x = number(row, "arrow x (length/time)"),
                     y = number(row, "arrow y (length/time)"), speed = std::hypot(x, y);
        if (speed == 0.0) continue;
        const auto its = std::ranges::find_if(arrows, [&](const DrawnArrow& arrow) {
            return distance(arrow.from, place) <= half_a_pixel;
        });
        if (its == arrows.end()) {
            problems.push_back("no arrow begins at the " + name);
            continue;
        }
        if (reach == 0.0) reach = distance(its->from, its->tip) / speed;
        const double off = distance(its->tip, {place.x + reach * x, place.y - reach * y});
        if (!(off <= half_a_pixel)) problems.push_back(off_by("the arrow of " + name, off));
    }
    return problems;
}

Paint paint_of(const std::string& hex) {
    Paint paint{};
    for (std::size_t i = 0; i < 3; ++i) paint[i] = std::stoi(hex.substr(1 + 2 * i, 2), nullptr, 16);
    paint[3] = 1.0;
    return paint;
}

bool is_near_color(const Paint& a, const Paint& b) {
    constexpr double level = 1.0;
    for (std::size_t i = 0; i < 3; ++i)
        if (!(std::abs(a[i] - b[i]) <= level)) return false;
    return true;
}

namespace {

bool is_same(const Paint& a, const Paint& b) {
    constexpr double half_a_level = 0.5;
    for (std::size_t i = 0; i < 3; ++i)
        if (!(std::abs(a[i] - b[i]) <= half_a_level)) return false;
    return true;
}

// The largest filled rectangle except the page: the ground of the box.
Edges ground_of(const DrawnFigure& figure) {
    const std::vector<Edges> all = rectangles(figure, [&](const Edges& edges, const Shape&) {
        return edges.width() < figure.picture.width - 1.0;
    });
    return *std::ranges::max_element(
        all, {}, [](const Edges& edges) { return edges.width() * edges.height(); });
}

void compare_colors(Problems& problems, const Row& row, const Disk& disk) {
    if (!is_same(disk.paint, paint_of(row.at("colour"))))
        problems.push_back("particle " + row.at("particle") + " has another colour");
}

}  // namespace

// In print a sphere is a disk with a smaller one on it, both around its middle. The scale and the
// place of the box in the picture follow from the means and the spread of all middles.
Problems sphere_problems(const DrawnFigure& figure, const std::array<double, 3>& size,
                         const std::array<double, 3>& viewpoint) {
    const auto& [turn, tilt, lens] = viewpoint;
    constexpr double degree = std::numbers::pi / 180.0;
    const double distance_of_eye = lens * std::hypot(size[0], size[1], size[2]);
    struct Sphere {
        double x, y, scale, nearness;
        std::string number;
    };
    std::vector<Sphere> spheres;
    std::vector<double> radii;
    for (const Row& row : rows_of(figure, "sphere")) {
        const double x = number(row, "x (length)") - size[0] / 2,
                     y = number(row, "y (length)") - size[1] / 2,
                     z = number(row, "z (length)") - size[2] / 2;
        const double across = x * std::cos(turn * degree) + z * std::sin(turn * degree);
        const double deep = z * std::cos(turn * degree) - x * std::sin(turn * degree);
        const double up = y * std::cos(tilt * degree) - deep * std::sin(tilt * degree);
        const double near = y * std::sin(tilt * degree) + deep * std::cos(tilt * degree);
        const double scale = distance_of_eye / (distance_of_eye - near);
        spheres.push_back({scale * across, -scale * up, scale * number(row, "radius (length)"),
                           -std::hypot(across, up, distance_of_eye - near), row.at("particle")});
    }
    std::ranges::sort(spheres, {}, &Sphere::nearness);
    std::vector<Disk> disks;
    for (const Disk& disk : disks_of(figure))
        if (disks.empty() || distance(disks.back().middle, disk.middle) > 1e-3)
            disks.push_back(disk);
    if (disks.size() < spheres.size() || spheres.size() < 3)
        return {"not as many spheres as in the table"};
    disks.resize(spheres.size());  // then the key
    const auto count = static_cast<double>(spheres.size());
    double x = 0.0, y = 0.0, own_x = 0.0, own_y = 0.0, square = 0.0, own = 0.0;
    for (std::size_t k = 0; k < spheres.size(); ++k) {
        x += disks[k].middle.x / count, y += disks[k].middle.y / count;
        own_x += spheres[k].x / count, own_y += spheres[k].y / count;
    }
    for (std::size_t k = 0; k < spheres.size(); ++k) {
        square += std::pow(disks[k].middle.x - x, 2) + std::pow(disks[k].middle.y - y, 2);
        own += std::pow(spheres[k].x - own_x, 2) + std::pow(spheres[k].y - own_y, 2);
    }
    const double scale = std::sqrt(square / own);
    Problems problems;
    for (std::size_t k = 0; k < spheres.size(); ++k) {
        const Spot place{x + scale * (spheres[k].x - own_x), y + scale * (spheres[k].y - own_y)};
        const double off = distance(disks[k].middle, place);
        if (!(off <= half_a_pixel)) problems.push_back(off_by("sphere " + spheres[k].number, off));
        const double radius = scale * spheres[k].scale;
        if (!(std::abs(disks[k].radius - radius) <= half_a_pixel))
            problems.push_back(off_by("the radius of sphere " + spheres[k].number, radius));
    }
    return problems;
}

Problems gas_problems(const DrawnFigure& figure, double width, double height) {
    constexpr double least_radius = 1.2;  // the smallest radius with which disks are drawn
    Problems problems;
    const Edges ground = ground_of(figure);
    const double scale = ground.width() / width;
    if (std::abs(ground.height() - scale * height) > half_a_pixel)
        problems.push_back("the box has another shape");
    std::vector<Disk> disks = disks_of(figure);
    std::erase_if(disks, [&](const Disk& disk) { return disk.middle.x > ground.right; });  // key
    const std::vector<Row> rows = rows_of(figure, "disk");
    if (disks.size() != rows.size() || rows.empty()) return {"not as many disks as in the table"};
    const auto place_of = [&](const Row& row) {
        return Spot{ground.left + scale * number(row, "x (length)"),
                    ground.bottom - scale * number(row, "y (length)")};
    };
    for (const Row& row : rows) {
        const Spot place = place_of(row);
        const Disk& disk = nearest(disks, place);
        const double off = distance(disk.middle, place);
        if (!(off <= half_a_pixel)) problems.push_back(off_by("disk " + row.at("particle"), off));
        const double radius = std::max(least_radius, scale * number(row, "radius (length)"));
        if (!(std::abs(disk.radius - radius) <= half_a_pixel))
            problems.push_back(off_by("the radius of disk " + row.at("particle"), radius));
        compare_colors(problems, row, disk);
    }
    return problems;
}

Problems line_problems(const DrawnFigure& figure, double length) {
    Problems problems;
    const Edges ground = ground_of(figure);
    const double scale = ground.width() / length;
    const LinearMap up = fitted(ticks_up(figure.picture));
    const auto across = [&](const Row& row) {
        return ground.left + scale * number(row, "x as drawn (length)");
    };
    const std::vector<Disk> disks = disks_of(figure);
    const std::vector<Row> beads = rows_of(figure, "bead");
    if (beads.empty() || disks.size() < beads.size()) return {"not as many beads as in the table"};
    for (const Row& bead : beads) {
        const Disk& disk = nearest(disks, {across(bead), disks.front().middle.y});
        const double off = disk.middle.x - across(bead);
        if (!(std::abs(off) <= half_a_pixel))
            problems.push_back(off_by("bead " + bead.at("particle"), off));
        compare_colors(problems, bead, disk);
    }
    const double now = number(beads.front(), "time (time)");
    for (const Row& bend : rows_of(figure, "world line")) {
        const Spot place{across(bend), up(now - number(bend, "time (time)"))};
        double off = INFINITY;  // distance to the nearest corner of a line
        for (const Shape& shape : figure.picture.shapes)
            if (shape.is_stroke)
                for (const Spot& corner : shape.corners())
                    off = std::min(
                        off, std::max(std::abs(corner.x - place.x), std::abs(corner.y - place.y)));
        if (!(off <= half_a_pixel))
            problems.push_back(off_by("a bend of bead " + bend.at("particle"), off));
    }
    return problems;
}

namespace {

// The key is a column of strips, from the lowest number, which is 0, up to the number at its top.
struct ColorKey {
    std::vector<Paint> steps;
    double top = 0.0;

    explicit ColorKey(const SvgPicture& picture) {
        Edges bar{INFINITY, INFINITY, 0.0, 0.0};
        for (const Shape& shape : picture.shapes) {
            const auto strip = shape.is_stroke ? std::nullopt : shape.rectangle();
            if (!strip || shape.paint[3] != 1.0 || strip->height() > 4.0 || strip->width() < 5.0 ||
                strip->width() > 10.0)
                continue;
            steps.push_back(shape.paint);
            bar = *strip;  // the last is the highest
        }
        for (const Said& text : texts_of(picture))
            if (const auto number = number_in(text.words.substr(text.words.rfind(' ') + 1));
                number && text.ink.left > bar.right &&
                text.ink.left < bar.right + 10.0)  // or "≥ 3"
                top = std::max(top, *number);
        if (steps.size() < 2 || top == 0.0) throw std::runtime_error("no key of colours");
    }

    // The number with the colour that is nearest to this one.
    double value(const Paint& seen) const {
        const auto off = [&](const Paint& step) {
            double sum = 0.0;
            for (std::size_t i = 0; i < 3; ++i) sum += (step[i] - seen[i]) * (step[i] - seen[i]);
            return sum;
        };
        const auto nearest = std::ranges::min_element(steps, {}, off);
        return top * static_cast<double>(nearest - steps.begin()) /
               static_cast<double>(steps.size() - 1);
    }
};

}  // namespace

Paint key_color(const SvgPicture& picture, double value) {
    const ColorKey key(picture);
    const double last = static_cast<double>(key.steps.size() - 1);
    const double at = std::clamp(value / key.top, 0.0, 1.0) * last,
                 low = std::min(std::floor(at), last - 1.0);
    const Paint &from = key.steps[static_cast<std::size_t>(low)],
                &to = key.steps[static_cast<std::size_t>(low) + 1];
    Paint mixed{};
    for (std::size_t i = 0; i < 4; ++i) mixed[i] = std::lerp(from[i], to[i], at - low);
    return mixed;
}

// The mean of the colours in each cell is that of its number.
Problems field_problems(const DrawnFigure& figure, double side, const std::string& column) {
    constexpr double on_whole_pixels = 1.0;  // parts of cells are drawn on whole pixels
    Problems problems;
    const Edges ground = ground_of(figure);
    const ColorKey key(figure.picture);
    const double scale = ground.width() / side;
    const std::vector<Row> cells = rows_of(figure, "cell");
    const double width = scale * side / std::sqrt(static_cast<double>(cells.size()));
    std::vector<double> areas(cells.size()), sums(cells.size());
    for (const Shape& shape : figure.picture.shapes) {
        const auto edges = shape.is_stroke ? std::nullopt : shape.rectangle();
        if (!edges || shape.paint[3] == 1.0) continue;
        Paint seen{};  // over the white ground
        for (std::size_t i = 0; i < 3; ++i)
            seen[i] = std::lerp(255.0, shape.paint[i], shape.paint[3]);
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const double x = ground.left + scale * number(cells[k], "x (length)") - 0.5 * width,
                         y = ground.bottom - scale * number(cells[k], "y (length)") - 0.5 * width;
            const double area =
                std::max(0.0, std::min(edges->right, x + width) - std::max(edges->left, x)) *
                std::max(0.0, std::min(edges->bottom, y + width) - std::max(edges->top, y));
            areas[k] += area;
            sums[k] += area * key.value(seen);
        }
    }
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const bool is_blank = cells[k].at(column).empty();
        const double covered = areas[k] / (width * width), edge = 4.0 * on_whole_pixels / width;
        if (std::abs(covered - (is_blank ? 0.0 : 1.0)) > edge)
            problems.push_back("a cell is not covered, or one without a number is");
        if (is_blank) continue;
        const double off = sums[k] / areas[k] - number(cells[k], column);
        if (std::abs(off) > 0.01 * key.top)
            problems.push_back("the colours of a cell have another mean than its number");
    }
    return problems;
}

}  // namespace carom::test
