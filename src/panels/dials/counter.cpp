// Counters with large digits, each on a plate: hits of walls, or crossings of partitions and lines
// in each direction. They keep counting up after a reversal.
#include <algorithm>
#include <memory>

#include "panels/chosen.h"
#include "panels/dials/dial_panel.h"
#include "panels/instruments/crossings.h"
#include "panels/instruments/measured_surfaces.h"
#include "panels/plot/layers.h"
#include "panels/registry.h"
#include "physics/box.h"
#include "scene/describe.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

/// What a counter counts at walls and partitions.
enum class Counted { hits, crossings };

struct CounterOptions {
    CrossedAt at = {};
    std::optional<Counted> counted = {};  ///< none: depends on the surfaces
};

std::vector<Binding<CounterOptions>> counter_keys() {
    return joined<CounterOptions>(
        bind_within(&CounterOptions::at, crossed_keys()),
        std::vector{
            bind_key(
                "count", &CounterOptions::counted,
                one_of<Counted>({{"hits", Counted::hits}, {"crossings", Counted::crossings}}),
                "What it counts: collisions with walls and partitions, or crossings of partitions "
                "in each direction.")
                .default_text("crossings of partitions that let particles through, else hits")});
}

// Unless the scene says what to count, a counter counts crossings if there is something to cross,
// and otherwise hits on all walls.
void check_counter(PanelSpec& panel, const Node& node, Reading& reading) {
    auto& [at, counted] = panel.options.change<CounterOptions>();
    if (is_written(node, "line")) {
        check_line(node, reading);
        if (counted == Counted::hits)
            reading.errors.add(*given(node, "count"), "nothing hits a `line`: it is no wall",
                               "leave out `count`, or name walls by `surfaces`");
        return;
    }
    const bool is_named = is_written(node, "surfaces");
    const SuitableSurface passable = passable_surfaces(reading);
    if (!counted) {
        SurfaceNumbers all = at.surfaces;
        if (!is_named)
            for (std::int32_t k = reading.box().surfaces.first_partition();
                 k < reading.box().surfaces.first_obstacle(); ++k)
                all.push_back(k);
        const bool some = std::ranges::any_of(all, passable.suits);
        const bool every = std::ranges::all_of(all, passable.suits);
        counted = some && (every || !is_named) ? Counted::crossings : Counted::hits;
    }
    const SuitableSurface solid{
        [&](std::int32_t surface) { return is_named || reading.box().surfaces.is_side(surface); },
        "a solid wall of the box", "make a wall solid, or count at `line: {x: PLACE}`"};
    keep_suitable(panel, at.surfaces, counted == Counted::crossings ? passable : solid, node,
                  reading);
}

struct CounterSize {
    static constexpr double name_space = 1.5, inner = 0.35, rim = 0.09;  // units
    static constexpr double digit_height = 0.74;                         // of the size of figures
    static constexpr double largest_figures = 5.0;                       // units
    static constexpr double figures_of_many = 1.7;  // of more than two: none is the only subject
    static constexpr double air = 0.45;             // over and under these
};

class CounterPanel : public DialPanel {
  public:
    using DialPanel::DialPanel;

  protected:
    Width width() const override { return {0.0, 1.5}; }
    bool has_words() const override { return false; }
    void draw_face(Canvas& canvas, const DrawContext& dc, const Rect& face,
                   const MeterLine& line) const override;
    void draw_value(Canvas& canvas, const DrawContext& dc, const Rect& face,
                    const Reading& reading) const override;

  private:
    bool are_many() const { return lines().size() > 2; }
    Rect plate(const DrawContext& dc, const Rect& face) const;
    TextStyle figures(const DrawContext& dc, const Rect& plate) const;
};

// Under the name.
Rect CounterPanel::plate(const DrawContext& dc, const Rect& face) const {
    const double u = dc.unit, width = face.width;
    double height = std::min(face.height - CounterSize::name_space * u, 0.42 * width);
    if (are_many())
        height = std::min(height, (CounterSize::digit_height * CounterSize::figures_of_many +
                                   2.0 * CounterSize::air) *
                                      u);
    return {face.x, face.y + CounterSize::name_space * u, width, std::max(u, height)};
}

// The largest size of the digits with which the largest count fits.
TextStyle CounterPanel::figures(const DrawContext& dc, const Rect& plate) const {
    TextStyle style{.size = dc.unit,
                    .weight = 600,
                    .color = dc.theme.ink,
                    .fonts = dc.theme.fonts,
                    .lettering = Lettering::numbers};
    const double u = dc.unit, wide = widest_number(style);
    const double across = (plate.width - 2.0 * CounterSize::inner * u) / wide;
    const double up =
        (plate.height - 2.0 * CounterSize::inner * u) / (CounterSize::digit_height * u);
    const double largest = are_many() ? CounterSize::figures_of_many : CounterSize::largest_figures;
    style.size = std::clamp(std::min(across, up), 1.0, largest) * u;
    style.align = Align::right;
    return style;
}

void CounterPanel::draw_face(Canvas& canvas, const DrawContext& dc, const Rect& face,
                             const MeterLine& line) const {
    TextStyle style = label_style(dc);
    style.color = legible(plot::color_of(line.role, dc.theme), dc.theme);
    style.max_width = face.width;
    draw_text(canvas, {face.x, face.y + dc.unit}, escape_markup(line.name), style);
    const Rect plate = this->plate(dc, face);
    canvas.fill(plate, dc.theme.ground);
    canvas.stroke_rect(plate, CounterSize::rim * dc.unit, dc.theme.muted);
}

void CounterPanel::draw_value(Canvas& canvas, const DrawContext& dc, const Rect& face,
                              const Reading& reading) const {
    const Rect plate = this->plate(dc, face);
    const TextStyle style = figures(dc, plate);
    const double right = plate.x + 0.5 * (plate.width + widest_number(style));
    draw_text(canvas,
              {right, plate.y + 0.5 * plate.height + 0.5 * CounterSize::digit_height * style.size},
              number(reading.said, reading.error), style);
}

// Counts since the first frame: for each choice of particles, for each surface.
class HitMeter {
  public:
    HitMeter(const PanelContext& context, const std::vector<Chosen>& chosen,
             std::vector<std::int32_t> surfaces)
        : surfaces_(std::move(surfaces)),
          members_(context, chosen),
          is_member_(chosen.size()),
          counts_(chosen.size() * surfaces_.size()) {
        choose();
    }

    std::vector<double> operator()(const FrameInput& o) {
        for (const Collision& one : o.advanced.collisions) {
            if (!is_begun_ || !one.second.is_surface()) continue;
            const auto k = std::ranges::find(surfaces_, one.second.surface()) - surfaces_.begin();
            if (k == std::ssize(surfaces_)) continue;
            for (std::size_t c = 0; c < is_member_.size(); ++c)
                if (is_member_[c].empty() || is_member_[c][static_cast<std::size_t>(one.first)])
                    ++counts_[c * surfaces_.size() + static_cast<std::size_t>(k)];
        }
        is_begun_ = true;
        if (members_.see(o.sample)) choose();
        return counts_;
    }

  private:
    void choose() {
        for (std::size_t c = 0; c < is_member_.size(); ++c) is_member_[c] = members_.flags(c);
    }

    std::vector<std::int32_t> surfaces_;
    Members members_;
    std::vector<std::vector<bool>> is_member_;  // of each choice; empty: all are
    std::vector<double> counts_;
    bool is_begun_ = false;
};

// Counts for each choice of particles, each line and each direction.
class CrossingMeter {
  public:
    CrossingMeter(const PanelContext& context, const CrossedAt& at,
                  const std::vector<Chosen>& chosen)
        : members_(context, chosen), places_(at.line ? 1 : at.surfaces.size()) {
        const Box& box = context.box();
        for (const std::vector<Eigen::Index>& list : members_.lists())
            for (std::size_t k = 0; k < places_; ++k)
                lines_.emplace_back(box, context.particles, crossed_line(box, at, k), list,
                                    velocity_changes(context.run()));
    }

    std::vector<double> operator()(const FrameInput& o) {
        std::vector<double> counts;
        for (LineCrossings& line : lines_)
            for (const std::int64_t count : line.see(o.sample, o.advanced.collisions).count)
                counts.push_back(static_cast<double>(count));
        if (members_.see(o.sample))
            for (std::size_t k = 0; k < lines_.size(); ++k)
                lines_[k].choose(members_.lists()[k / places_]);
        return counts;
    }

  private:
    Members members_;
    std::size_t places_;  // for each choice
    std::vector<LineCrossings> lines_;
};

// The names of plates: which particles, at which line, and in which direction, the latter as an
// arrow if there is more to name.
void add_plates(DialSubject& subject, const PanelContext& context, const PanelSpec& spec,
                const std::vector<Chosen>& chosen, bool crossings) {
    const Language language = context.language();
    const Box& box = context.box();
    const CrossedAt& at = spec.options.as<CounterOptions>().at;
    const std::size_t places = at.line ? 1 : at.surfaces.size();
    const auto with = [](const std::string& first, const std::string& between,
                         const std::string& second) {
        return first.empty() || second.empty() ? first + second : first + between + second;
    };
    for (std::size_t c = 0; c < chosen.size(); ++c)
        for (std::size_t k = 0; k < places; ++k) {
            const std::string which = spec.of.empty() ? "" : name_of(context.scene, chosen[c]);
            const auto add = [&](const std::string& column, const std::string& name) {
                subject.lines.push_back({column, name, role_among(context, chosen, c)});
            };
            if (!crossings) {
                const std::int32_t surface = at.surfaces[k];
                add(with(which, ", ", box.surfaces.names()[static_cast<std::size_t>(surface)]),
                    with(which, ", ", short_name(language, box, surface)));
                continue;
            }
            const std::string line = name_of_line(box, at, k);
            const int axis = crossed_line(box, at, k).axis;
            const std::string before = with(which, ", ", places > 1 ? line : "");
            for (const std::size_t way : {std::size_t{0}, std::size_t{1}})
                add(with(with(which, ", ", line), ", ",
                         std::string(ways_across(axis).at(way).english)),
                    before.empty() ? say(language, ways_across(axis).at(way))
                                   : before + " " + arrows_across(axis).at(way));
        }
    if (chosen.size() > 1) return;
    for (std::size_t k = 0; k < subject.lines.size(); ++k)
        subject.lines[k].role = surface_role(k, subject.lines.size());
}

DialSubject counter(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const Box& box = context.box();
    const auto& [at, counted] = spec.options.as<CounterOptions>();
    const bool crossings = at.line || counted == Counted::crossings;
    const std::vector<Chosen> chosen = choices(spec);
    DialSubject subject;
    subject.part = "counter";
    subject.counts = true;
    subject.needs_collisions = true;
    add_plates(subject, context, spec, chosen, crossings);
    subject.enough = 2.0 + 6.0 * static_cast<double>((subject.lines.size() + 1) / 2);
    const bool is_one = crossings && (at.line || at.surfaces.size() == 1);
    if (crossings) {
        subject.quantity = quantities::count.named(Phrase{"crossings"});
        subject.title = is_one ? say(language, "Crossings of {}", name_of_line(box, at))
                               : say(language, "Crossings");
        subject.read = CrossingMeter(context, at, chosen);
    } else {
        subject.quantity = quantities::count.named(Phrase{"hits"});
        subject.title = say(language, "Hits");
        subject.read = HitMeter(context, chosen, at.surfaces);
    }
    return subject;
}

}  // namespace

PanelKind counter_kind() {
    using enum Ability;
    return dial_kind<CounterPanel, counter>(
        {.name = "counter",
         .words = Phrase{"counter"},
         .shows = "The number of hits on walls and partitions, or of crossings of partitions or a "
                  "`line` in each direction, in large digits.",
         .abilities = {of, means, comparison},
         .keys = option_keys(counter_keys()),
         .rule = check_counter,
         .measured_at = crossed_at(&CounterOptions::at),
         .work = always(PanelWork{.flights = PanelWork::Flights::recorded}),
         .has_plot = false});
}

}  // namespace carom
