// Panels that are given samples in which particles change their species or are absent.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "panels/dials/dial_panel.h"
#include "panels/field/profile.h"
#include "panels/gas/camera.h"
#include "panels/gas/marks/spotlights.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/points_panel.h"
#include "physics/archived.h"
#include "support/first_frame.h"
#include "support/relative.h"
#include "support/seen_panel.h"

using namespace carom;
using test::relative;

namespace {

// Four disks that fly to the right, each at a height of its own: 0 and 1 are `a`, 2 and 3 are `b`.
Scene scene_of(const std::string& film) {
    return test::scene_from(
        "title: T\nbox: {size: [20, 10]}\n"
        "gas: [{name: a, count: 2, radius: 0.3, speed: 1}, {name: b, count: 2, radius: 0.3, "
        "speed: 1, drawn_radius: 1, fill: false}]\n"
        "run: {until: 4, sample_every: 1}\nfilm: {size: [480, 270], seconds: 4, " +
        film + "}\n");
}

constexpr std::array<double, 4> velocities{0.5, 1.5, 2.5, 3.5};

// From time 2 on, 1 is a `b` and 3 is absent.
std::shared_ptr<const Membership> changed() {
    Membership its{Eigen::Array4i(0, 1, 1, 1),
                   Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(4, true)};
    its.is_present[3] = false;
    return std::make_shared<const Membership>(its);
}

// `back`: when all is again as at the start.
Sample sample_at(double time, double back = INFINITY) {
    static const std::shared_ptr<const Membership> later = changed();
    Sample sample{time, Eigen::ArrayXXd::Zero(4, 2), Eigen::ArrayXXd::Zero(4, 2)};
    for (Eigen::Index i = 0; i < 4; ++i) {
        sample.velocity(i, 0) = velocities.at(std::size_t(i));
        sample.position(i, 0) = 1.0 + time * sample.velocity(i, 0);
        sample.position(i, 1) = 2.0 + 2.0 * double(i);
    }
    if (time >= 2.0 && time < back) sample.membership = later;
    return sample;
}

// The first panel of the film after both passes, at times 0 to 4.
struct Seen {
    Scene scene;
    Particles particles;
    BoxedGas gas;
    PanelContext context;
    std::unique_ptr<Panel> panel;
    double back;
    std::vector<std::shared_ptr<const PanelState>> states;

    explicit Seen(const std::string& written, std::span<const Collision> hits = {},
                  double returns = INFINITY)
        : scene(scene_of("panels: [" + written + "]")),
          particles(Simulation(scene.gas, scene.run).particles()),
          gas(scene.gas.box, scene.run.events, particles, sample_at(0.0)),
          context{scene, particles, 5, gas},
          panel(make_panel(context, scene.film.panels.at(0))),
          back(returns) {
        each([&](const FrameInput& input) { panel->survey(input); }, hits);
        panel->fix_axes();
        each([&](const FrameInput& input) { states.push_back(panel->state(input)); }, hits);
    }

    void each(const auto& take, std::span<const Collision> hits) const {
        for (int frame = 0; frame <= 4; ++frame) {
            const Sample sample = sample_at(frame, back);
            AdvanceResult advanced;
            if (frame == 3) advanced.collisions = hits;
            const Tick tick{.frame = frame, .time = double(frame)};
            take(FrameInput{tick, sample, speeds(sample), kinetic_energies(particles, sample),
                            advanced});
        }
    }
    const std::vector<std::vector<double>>& lines() const {
        return dynamic_cast<const SeriesPanel&>(*panel).record().runs.front().y;
    }
    double reading(std::size_t line) const {
        return dynamic_cast<const DialPanel&>(*panel).readings(*states.back()).at(line).value;
    }
    const std::vector<double>& bars(std::size_t choice, std::size_t frame) const {
        return HistogramPanel::histograms(*states.at(frame)).at(choice).counts;
    }
};

using Indices = std::vector<Eigen::Index>;

}  // namespace

TEST_CASE("the members of choices are those of the sample, and found again only when it changes") {
    const Scene scene = scene_of("panels: []");
    const Particles particles = Simulation(scene.gas, scene.run).particles();
    const BoxedGas none;
    const PanelContext context{scene, particles, 5, none};
    const std::vector<Chosen> chosen{{.species = 0}, {.species = 1}, {}, {.particle = 3}};
    Members members(context, chosen);
    CHECK(members.lists() == std::vector<Indices>{{0, 1}, {2, 3}, {0, 1, 2, 3}, {3}});
    CHECK(members.flags(2).empty());
    Sample sample = sample_at(0.0);
    CHECK(!members.see(sample));
    sample.membership = membership_at_start(particles);
    CHECK(!members.see(sample));  // another object that says the same
    const Indices* before = members.lists().data();
    CHECK(!members.see(sample));
    CHECK(members.lists().data() == before);
    CHECK(members.see(sample_at(2.0)));
    CHECK(!members.see(sample_at(3.0)));
    const std::vector<Indices> later{{0}, {1, 2}, {0, 1, 2}, {}};
    CHECK(members.lists() == later);
    CHECK(members.flags(1) == std::vector<bool>{false, true, true, false});

    Archive written;
    written(members);
    Members read(context, chosen);
    Archive bytes(written.finished(), "the members");
    bytes(read);
    bytes.expect_end();
    CHECK(read.lists() == later);
    CHECK(!read.see(sample_at(4.0)));  // which has not changed since
    CHECK(members.see(sample_at(1.0)));
    CHECK(members.lists()[1] == Indices{2, 3});
}

TEST_CASE("temperatures, mean energies and numbers are those of the members at each time") {
    for (const char* written : {"{kind: temperature, of: [a, b]}", "energy-by-species"}) {
        const Seen seen(written);
        const std::vector<std::vector<double>> expected{{0.625, 0.625, 0.125, 0.125, 0.125},
                                                        {4.625, 4.625, 2.125, 2.125, 2.125}};
        REQUIRE(seen.lines().size() == 2);
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < 5; ++i)
                CHECK(seen.lines()[k].at(i) == relative(expected[k][i], 1e-12));
    }
    const Seen sides("{kind: sides, regions: [{name: all, within: [0, 0, 20, 10]}]}");
    CHECK(sides.lines().front() == std::vector<double>{4.0, 4.0, 3.0, 3.0, 3.0});
}

TEST_CASE(
    "a histogram counts the members of the time, and over time each for as long as it is one") {
    const std::string kind = "{kind: speed-histogram, of: [a, b], range: [0, 5], bins: 5";
    const auto check = [](const std::vector<double>& found, const std::vector<double>& expected) {
        for (std::size_t k = 0; k < expected.size(); ++k)
            CHECK(found.at(k) == doctest::Approx(expected[k]).epsilon(1e-12));
    };
    const Seen now(kind + ", over: now}");
    check(now.bars(0, 1), {1, 1, 0, 0, 0});
    check(now.bars(1, 1), {0, 0, 1, 1, 0});
    check(now.bars(0, 2), {1, 0, 0, 0, 0});
    check(now.bars(1, 4), {0, 1, 1, 0, 0});
    const Seen all(kind + ", over: start}");
    check(all.bars(0, 4), {1, 0.5, 0, 0, 0});
    check(all.bars(1, 4), {0, 0.5, 1, 0.5, 0});
    check(all.bars(0, 3), {1, 2.0 / 3.0, 0, 0, 0});
    const Seen again(kind + ", over: start}", {}, 3.0);
    check(again.bars(0, 4), {1, 0.75, 0, 0, 0});
    check(again.bars(1, 4), {0, 0.25, 1, 0.75, 0});
    const Seen part(
        "{kind: speed-histogram, range: [0, 5], bins: 5, over: start, regions: [{name: all, "
        "within: [0, 0, 20, 10]}]}");
    check(part.bars(0, 4), {1, 1, 1, 0.5, 0});
}

TEST_CASE("meters of flights count a particle for what it is on the way") {
    const Seen thermometer("{kind: thermometer, of: [a, b], over: start}");
    // 2 units of time with the energies 1/8 and 9/8, then 2 with 1/8 alone; and so on.
    CHECK(thermometer.reading(0) == relative((2.0 * 1.25 + 2.0 * 0.125) / 6.0, 1e-12));
    CHECK(thermometer.reading(1) == relative((2.0 * 9.25 + 2.0 * 4.25) / 8.0, 1e-12));
    // They pass x = 5 at 8, 8/3, 8/5 and 8/7; the fourth passes x = 12 at 22/7, when it is absent.
    const Seen near("{kind: counter, of: [a, b], line: {x: 5}}");
    CHECK(near.reading(0) == 0.0);
    CHECK(near.reading(2) == 3.0);
    const Seen far("{kind: counter, of: [b], line: {x: 12}}");
    CHECK(far.reading(0) == 0.0);
    const Seen flux("{kind: flux, of: [b], line: {x: 5}, over: start, theory: false}");
    CHECK(flux.lines().front().back() == relative(3.0 / 4.0, 1e-12));
    // A hit between 2 and 3, of the one that was an `a`.
    const std::vector<Collision> hits{
        {2.5, 1, Partner::of_surface(1), {4.75, 4.0}, {}, {1.5, 0.0}, {}, {1.5, 0.0}, {}}};
    const Seen counter("{kind: counter, of: [a, b], count: hits}", hits);
    CHECK(counter.reading(1) == 0.0);
    CHECK(counter.reading(5) == 1.0);
}

TEST_CASE("cells and rings hold the members of the time") {
    const auto sum_of = [](const std::vector<double>& all) {
        return std::accumulate(all.begin(), all.end(), 0.0);
    };
    const auto numbers = [&](const Seen& seen, std::size_t choice) {
        const auto& state = dynamic_cast<const ProfileState&>(*seen.states.back());
        return 10.0 * sum_of(state.runs.front().y.at(choice));  // of slabs 1 wide and 10 high
    };
    const Seen all("{kind: profile, of: [a, b], cells: 20, over: start}");
    CHECK(numbers(all, 0) == relative(1.5, 1e-12));
    CHECK(numbers(all, 1) == relative(2.0, 1e-12));
    const Seen now("{kind: profile, of: [a, b], cells: 20, over: now}");
    CHECK(numbers(now, 0) == relative(1.0, 1e-12));
    CHECK(numbers(now, 1) == relative(2.0, 1e-12));
    const Seen rings("{kind: profile, of: [b], around: [10, 5], cells: 2, over: now}");
    const plot::Plot plot =
        dynamic_cast<const PlotPanel&>(*rings.panel).plot(&*rings.states.back());
    // At time 4 the second is at (7, 4), the third at (11, 6): both rings are 2.5 wide.
    const plot::Column& density = std::get<plot::Polyline>(plot.layers.front()).y;
    CHECK(density[0] == relative(1.0 / (6.25 * std::numbers::pi), 1e-12));
    CHECK(density[2] == relative(1.0 / (18.75 * std::numbers::pi), 1e-12));
}

TEST_CASE("points are those of the members that are present") {
    const Seen phase("{kind: phase, of: [a, b]}");
    CHECK(PointsPanel::points(*phase.states[1], 0).size() == 2);
    CHECK(PointsPanel::points(*phase.states[2], 0).size() == 1);
    REQUIRE(PointsPanel::points(*phase.states[2], 1).size() == 2);
    CHECK(PointsPanel::points(*phase.states[2], 1)[0].y == 1.5);
    const Seen positions("{kind: positions, of: [0, 3]}");
    CHECK(PointsPanel::points(*positions.states[1], 0).size() == 1);
    CHECK(PointsPanel::points(*positions.states[2], 0).empty());
}

TEST_CASE(
    "a disk has the colour and the looks of its species, and none is drawn of an absent one") {
    test::FirstFrame first(scene_of("color_by: species"));
    const Rect box = first.box();
    const FrameData later = first.panels.frame_data({.frame = 1, .time = 2.0}, sample_at(2.0), {});
    const PixelView view = first.painter->paint(later).pixels();
    const auto pixel = [&](double x, double y) {
        const double scale = box.width / 20.0;
        const auto column = int(box.x + x * scale), row = int(box.y + box.height - y * scale);
        return view.data[row * view.stride + column] & 0xFFFFFF;
    };
    const std::uint32_t ground = pixel(18.0, 9.0);
    CHECK(pixel(2.0, 2.0) != ground);   // 0: an `a`, filled
    CHECK(pixel(2.0, 2.7) == ground);   // and small
    CHECK(pixel(4.0, 4.0) == ground);   // 1: a ring
    CHECK(pixel(4.0, 4.93) != ground);  // as large as a `b` is drawn
    CHECK(pixel(6.0, 6.93) != ground);  // 2
    for (double y = 7.2; y < 9.0; y += 0.1) CHECK(pixel(8.0, y) == ground);  // 3: absent
}

TEST_CASE("tables, lights and the camera go by the members of the time") {
    const Scene scene = scene_of(
        "color_by: species, spotlight: [{from: 0, to: 4, of: [b]}], camera: [{at: 0, follow: b, "
        "width: "
        "5}]");
    const Particles particles = Simulation(scene.gas, scene.run).particles();
    const BoxedGas gas(scene.gas.box, scene.run.events, particles, sample_at(0.0));
    const PanelContext context{scene, particles, 5, gas, false};
    const auto panel = make_gas_panel(context);
    Spotlights lights(context);
    std::vector<Table> tables;
    std::vector<std::vector<float>> light;
    Camera camera(context);
    for (int frame = 0; frame <= 4; ++frame) {
        const Sample sample = sample_at(frame);
        const Tick tick{.frame = frame, .time = double(frame)};
        const FrameInput input{
            tick, sample, speeds(sample), kinetic_energies(particles, sample), {}};
        panel->survey(input);
        camera.survey(input);
        lights.see(sample);
        light.push_back(lights.light(tick));
    }
    panel->fix_axes();
    camera.fix_way({{0.0, 0.0}, scene.gas.box.size});
    for (int frame = 0; frame <= 2; ++frame) {
        const Sample sample = sample_at(frame);
        const Tick tick{.frame = frame, .time = double(frame)};
        const auto state =
            panel->state({tick, sample, speeds(sample), kinetic_energies(particles, sample), {}});
        tables.push_back(panel->table(*state, theme_of(ThemeName::dark)));
    }
    const auto species = [](const Table& table) {
        std::string all;
        for (const auto& row : table.rows)
            if (std::get<std::string>(row[0]) == "disk") all += std::get<std::string>(row[2]);
        return all;
    };
    CHECK(species(tables[1]) == "aabb");
    CHECK(species(tables[2]) == "abb");
    const auto color = [&](std::size_t table, std::size_t row) {
        return std::get<std::string>(tables[table].rows[row][6]);
    };
    CHECK(color(1, 0) == color(1, 1));
    CHECK(color(2, 0) == color(1, 0));
    CHECK(color(2, 1) == color(1, 2));  // the second is now a `b`
    CHECK(color(2, 1) != color(2, 0));
    CHECK(light[1][1] < 1.0F);
    CHECK(light[2][1] == 1.0F);
    CHECK(light[2][3] < 1.0F);
    // Halfway between 2 and 3, then between 1 and 2.
    CHECK(camera.at(1)->middle[0] == relative(4.0, 1e-12));
    CHECK(camera.at(2)->middle[0] == relative(5.0, 1e-12));
}
