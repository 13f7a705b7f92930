// The squared distance of two particles against time: the parabola of their free flight, and the
// two roots at which it equals the squared contact distance, of which the first is the contact
// time. After the contact the actual distance is drawn too, with a mark at the present.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "panels/collision/pair_collision.h"
#include "panels/plot/plot_panel.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "util/text.h"

namespace carom {
namespace {

using namespace plot;

struct ContactState : PanelState {
    std::optional<double> time;  // the present, in a film
};

// Shown before and after the contact, in units of the time between the roots.
constexpr double ahead = 1.25, beyond = 1.75;
constexpr int curve_points = 200;
constexpr std::string_view passing = Phrase{"if they passed through each other"}.english;
const Stroke level_stroke{.width = 0.08};
const Heading time_column = quantities::time;
const Heading square_column{"squared distance", quantities::distance.squared()};
const Heading rv_column{"r.v", quantities::distance* quantities::velocity};
const Heading vv_column{"v.v", quantities::velocity.squared()};

class ContactTimePanel : public PlotPanel {
  public:
    ContactTimePanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context), spec_(spec), watch_(context, spec) {}

    void survey(const FrameInput& input) override { watch_.survey(input); }
    bool surveys_collisions() const override { return true; }
    void fix_axes() override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive&) override {}
    Plot plot(const PanelState* state) const override;
    std::optional<std::array<double, 2>> time_shown(double) const override {
        return {{collision_.time, collision_.time}};
    }
    void archive(Archive& archive) override {
        archive(collision_, contact_, are_points_, first_, last_, top_);
    }

  private:
    using Curve = std::function<double(double)>;
    Polyline line(const char* of, const Curve& curve, double from, double to, Stroke stroke) const;
    void add_lines(Plot& plot) const;
    void add_parabola(Plot& plot) const;
    void add_point(Plot& plot, const char* of, Point at, const plot::Dot& dot, const Role& drop,
                   bool still) const;
    void add_roots(Plot& plot) const;
    Label label(const std::string& words, std::vector<Anchor> anchors) const;
    void add_labels(Plot& plot) const;
    void add_present(Plot& plot, double now) const;
    std::string account() const;

    PanelContext context_;
    PanelSpec spec_;
    PairCollisionWatch watch_;
    PairCollision collision_;
    double contact_ = 0.0;             // the square of the distance at contact
    bool are_points_ = false;          // the two roots coincide
    double first_ = 0.0, last_ = 1.0;  // of the time axis
    double top_ = 1.0;
};

void ContactTimePanel::fix_axes() {
    collision_ = watch_.collision();
    const Eigen::ArrayXd& radius = context_.particles.radius;
    const double sigma = radius[collision_.particle[0]] + radius[collision_.particle[1]];
    contact_ = sigma * sigma;
    const double between = collision_.other_root() - collision_.time;
    const double flight = collision_.time - collision_.since;
    are_points_ = !(between > 1e-3 * flight);
    double back = are_points_ ? flight : ahead * between;
    double on = are_points_ ? 0.6 * flight : beyond * between;
    if (!(back > 0.0)) back = on = 1.0;
    first_ = std::max(0.0, collision_.time - back);
    last_ = collision_.time + on;
    top_ = 1.08 * std::max({collision_.free_square(collision_.time - 0.6 * back),
                            collision_.free_square(first_),
                            are_points_ ? 0.0 : collision_.free_square(last_)});
}

std::shared_ptr<const PanelState> ContactTimePanel::state(const FrameInput& input) {
    auto state = std::make_shared<ContactState>();
    if (context_.in_film) state->time = input.tick.time;
    return state;
}

Polyline ContactTimePanel::line(const char* of, const Curve& curve, double from, double to,
                                Stroke stroke) const {
    std::vector<double> times, squares;
    for (int i = 0; i <= curve_points; ++i) {
        times.push_back(from + (to - from) * i / curve_points);
        squares.push_back(curve(times.back()));
    }
    Polyline line{{.part = "curve", .of = of, .still = true},
                  column(time_column, std::move(times)),
                  column(square_column, std::move(squares))};
    line.is_thinned = false;
    line.stroke = std::move(stroke);
    return line;
}

// For points the two roots coincide, and so do the two curves.
void ContactTimePanel::add_lines(Plot& plot) const {
    const Stroke dashed{.width = 0.14, .dashes = {0.35}};
    Stroke solid{.role = {Role::Of::highlight}, .width = 0.2, .shade = Shade::legible};
    const auto parabola = [this](double time) { return collision_.free_square(time); };
    const auto truth = [this](double time) { return collision_.square(time); };
    const double from = std::max(first_, collision_.since), met = collision_.time;
    if (!are_points_)
        plot.notes = {{.entries = {{dashed,
                                    {say(context_.language(), Phrase{passing}),
                                     say(context_.language(), "without a collision")}}}}};
    if (from > first_)
        plot.layers.push_back(line("without the collision before", parabola, first_, from, dashed));
    Polyline through = line(passing.data(), parabola, met, last_, dashed);
    through.depth = 1;
    plot.layers.push_back(line("before", truth, from, met, solid));
    solid.fade = 0.35;
    plot.layers.push_back(line("after", truth, met, std::min(last_, collision_.until), solid));
    plot.layers.push_back(std::move(through));
}

// The coefficients of the parabola, whose time counts from that of the row. At contact it has the
// value of the level.
void ContactTimePanel::add_parabola(Plot& plot) const {
    const PairCollision::Parabola terms = collision_.parabola();
    plot.numbers.push_back(
        {.part = "parabola",
         .of = "before",
         .more = {column(time_column, {collision_.since}), column(square_column, {terms.rr}),
                  column(rv_column, {terms.rv}), column(vv_column, {terms.vv})}});
}

// A point, with a line down to the time.
void ContactTimePanel::add_point(Plot& plot, const char* of, Point at, const plot::Dot& dot,
                                 const Role& drop, bool still) const {
    const Stroke dashed{.role = drop, .width = 0.07, .dashes = {0.25}};
    plot.layers.emplace_back(Marker{{.still = still}, "", at.x, at.y, dashed});
    Points point{{.part = "mark", .of = of, .still = still},
                 column(time_column, {at.x}),
                 column(square_column, {at.y})};
    point.dot = dot;
    plot.layers.emplace_back(std::move(point));
}

void ContactTimePanel::add_roots(Plot& plot) const {
    if (contact_ > 0.0) {
        Level level{{.part = "level", .of = "contact", .depth = 2, .still = true},
                    square_column,
                    contact_,
                    level_stroke};
        level.x_column = time_column;
        plot.layers.emplace_back(std::move(level));
    }
    const Role muted{Role::Of::muted};
    add_point(plot, "contact", {collision_.time, contact_},
              {.role = {Role::Of::ink}, .radius = 0.34}, muted, true);
    add_point(plot, "other root", {collision_.other_root(), contact_},
              {.role = muted, .radius = 0.32, .shade = Shade::as_it_is, .is_hollow = true}, muted,
              true);
}

Label ContactTimePanel::label(const std::string& words, std::vector<Anchor> anchors) const {
    Label label{{.still = true}, {words}, std::move(anchors), {Role::Of::ink}};
    label.swatch = level_stroke;
    return label;
}

// The time as near to the contact as there is room between the curves. In low
// plots the level has its name in the row under the title, if there is room.
void ContactTimePanel::add_labels(Plot& plot) const {
    const Point contact{collision_.time, contact_}, other{collision_.other_root(), contact_};
    const double aside = 0.15 * (last_ - first_);
    const auto at_top = [](double time, Point offset, Align align) {
        return Anchor{.at = {time, 0.0}, .y_is_share = true, .offset = offset, .align = align};
    };
    const auto at_left = [&](double down) {
        return Anchor{.at = {0.0, contact_}, .x_is_share = true, .offset = {0.4, down}};
    };
    const auto at_right = [](double y, bool is_share, double down, bool has_swatch = false) {
        return Anchor{.at = {1.0, y},
                      .x_is_share = true,
                      .y_is_share = is_share,
                      .offset = {-0.2, down},
                      .align = Align::right,
                      .has_swatch = has_swatch};
    };
    const auto add = [&](const std::string& words, std::vector<Anchor> anchors) {
        plot.layers.emplace_back(label(words, std::move(anchors)));
    };
    const Language language = context_.language();
    add(say(language, "contact at {}", three_digits(language, contact.x)),
        {{.at = contact, .offset = {0.0, -1.0}, .align = Align::center, .step = {0.0, -0.5}},
         at_top(contact.x, {0.0, 1.1}, Align::center),
         at_top(contact.x + aside, {0.0, 1.1}, Align::center),
         at_top(contact.x - aside, {0.0, 1.1}, Align::center),
         at_top(contact.x, {0.6, 1.1}, Align::left),
         at_top(contact.x, {0.6, 2.1}, Align::left)});
    if (contact_ > 0.0)
        add("σ² = " + three_digits(language, contact_), {at_left(-0.5),
                                                         at_left(1.2),
                                                         {.at = contact, .offset = {0.7, -0.5}},
                                                         at_right(0.0, true, -note_height, true)});
    if (are_points_) return;
    add(say(language, "they would separate at {}", three_digits(language, other.x)),
        {at_right(contact_, false, 1.3),
         at_right(0.0, true, 1.1),
         at_right(0.0, true, 2.1),
         at_right(contact_, false, -0.5),
         {.at = other, .offset = {-0.5, -0.5}, .align = Align::right},
         {.at = other, .offset = {-0.5, -1.5}, .align = Align::right}});
}

void ContactTimePanel::add_present(Plot& plot, double now) const {
    const double square = collision_.square(now);
    if (now < std::max(first_, collision_.since) || now > std::min(last_, collision_.until) ||
        square > top_)
        return;
    add_point(plot, "present", {now, square},
              {.role = {Role::Of::highlight}, .radius = 0.4, .halo = 0.1}, {Role::Of::ink}, false);
}

std::string ContactTimePanel::account() const {
    const Language language = context_.language();
    const std::string names = plain_names_of(context_, collision_);
    const std::string contact = three_digits(language, collision_.time);
    if (are_points_) return say(language, "{} meet at time {}.", names, contact);
    return say(language,
               "{} touch at time {}; if they passed through each other, they would separate at "
               "time {}.",
               names, contact, three_digits(language, collision_.other_root()));
}

Plot ContactTimePanel::plot(const PanelState* state) const {
    const Language language = context_.language();
    const Text title = say(language, "Squared distance r²");
    Plot plot{.language = language,
              .titles = {text_of(language, Phrase{"Squared distance r² of {}"},
                                 {names_of(context_, collision_)}),
                         title},
              .x = axis_of(language, quantities::time, first_, last_),
              .y = {.high = top_, .quantity = square_column.quantity}};
    if (spec_.title) plot.titles = {escape_markup(*spec_.title)};
    plot.columns = {time_column, square_column, rv_column, vv_column};
    add_lines(plot);
    add_parabola(plot);
    add_roots(plot);
    add_labels(plot);
    if (state == nullptr) return plot;
    plot.account = account();
    if (const auto now = static_cast<const ContactState&>(*state).time) add_present(plot, *now);
    return plot;
}

std::unique_ptr<Panel> make_contact_time(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<ContactTimePanel>(context, spec);
}

}  // namespace

PanelKind contact_time_kind() {
    using enum Ability;
    return {.name = "contact-time",
            .words = Phrase{"contact time"},
            .shows =
                "The squared distance of two particles against time, and the time of contact "
                "that follows from it.",
            .make = make_contact_time,
            .abilities = {of, pair},
            .has_own_time = always(true),
            .work = always(PanelWork{.flights = PanelWork::Flights::recorded}),
            .in_space_instead = "give `size` two lengths: it shows a collision in a plane"};
}

}  // namespace carom
