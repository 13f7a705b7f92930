// The squared distance of two particles against time: the parabola of their free flight, the two
// times at which it is that of contact, and the first of them, which counts. After it the true
// distance, and on it the present.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "panels/collision/pair_event.h"
#include "panels/registry.h"
#include "util/text.h"

namespace carom {
namespace {

struct ContactState : PanelState {
    std::optional<double> time;  // the present, in a film
};

constexpr double ahead = 1.25, beyond = 1.75;  // of the time between the roots, that are shown
constexpr int curve_points = 200;
constexpr const char* passing = "if they passed through each other";

class ContactTimePanel : public Panel {
  public:
    ContactTimePanel(const PanelContext& context, const PanelSpec& spec)
        : context_(context), spec_(spec), watch_(context, spec) {}

    void survey(const FrameInput& input) override { watch_.survey(input); }
    bool surveys_collisions() const override { return true; }
    void fix_axes() override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;

  private:
    using Curve = std::function<double(double)>;
    struct Scales {
        Rect area;
        Scale x, y;
        Point operator()(double time, double square) const { return {x(time), y(square)}; }
    };
    Scales scales(const DrawContext& dc) const;
    std::vector<Point> path(const DrawContext& dc, const Curve& curve, double from,
                            double to) const;
    void draw_note(Canvas& canvas, const DrawContext& dc) const;
    void draw_curves(Canvas& canvas, const DrawContext& dc) const;
    void draw_roots(Canvas& canvas, const DrawContext& dc) const;
    bool draw_label(Canvas& canvas, const DrawContext& dc, const std::string& words,
                    std::span<const Point> places, Align align) const;
    bool is_free(const DrawContext& dc, const Rect& rect) const;
    void draw_level_note(Canvas& canvas, const DrawContext& dc, const std::string& words) const;

    PanelContext context_;
    PanelSpec spec_;
    MeetingWatch watch_;
    Meeting met_;
    double contact_ = 0.0;             // σ²
    double first_ = 0.0, last_ = 1.0;  // of the time axis
    double top_ = 1.0;
};

void ContactTimePanel::fix_axes() {
    met_ = watch_.meeting();
    const double sigma =
        context_.particles.radius[met_.particle[0]] + context_.particles.radius[met_.particle[1]];
    contact_ = sigma * sigma;
    const double between = met_.other_root() - met_.time;
    const double flight = met_.time - met_.since;
    const bool are_points = !(between > 1e-3 * flight);  // the roots lie upon each other
    double back = are_points ? flight : ahead * between;
    double on = are_points ? 0.6 * flight : beyond * between;
    if (!(back > 0.0)) back = on = 1.0;
    first_ = std::max(0.0, met_.time - back);
    last_ = met_.time + on;
    top_ = 1.08 * std::max({met_.free_square(met_.time - 0.6 * back), met_.free_square(first_),
                            are_points ? 0.0 : met_.free_square(last_)});
}

std::shared_ptr<const PanelState> ContactTimePanel::state(const FrameInput& input) {
    auto state = std::make_shared<ContactState>();
    if (context_.in_film) state->time = input.tick.time;
    return state;
}

ContactTimePanel::Scales ContactTimePanel::scales(const DrawContext& dc) const {
    Rect area = plot_area(dc);
    area.y += note_height * dc.unit;
    area.height = std::max(dc.unit, area.height - note_height * dc.unit);
    return {area, {first_, last_, area.x, area.right()}, {0.0, top_, area.bottom(), area.y}};
}

std::vector<Point> ContactTimePanel::path(const DrawContext& dc, const Curve& curve, double from,
                                          double to) const {
    const Scales s = scales(dc);
    std::vector<Point> points;
    for (int i = 0; i <= curve_points; ++i) {
        const double time = from + (to - from) * i / curve_points;
        points.push_back(s(time, curve(time)));
    }
    return points;
}

void ContactTimePanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const std::string of = names_of(context_, met_, dc.theme);
    const std::array titles{"Squared distance r² of " + of, std::string("Squared distance r²")};
    draw_panel_title(canvas, dc,
                     spec_.title ? escape_markup(*spec_.title)
                                 : fitting_title(dc, {titles.begin(), titles.end()}));
    const Scales s = scales(dc);
    if (met_.other_root() > met_.time) draw_note(canvas, dc);
    draw_x_axis(canvas, s.area, s.x, "time", axis_style(dc));
    draw_y_axis(canvas, s.area, s.y, "", axis_style(dc));
    draw_curves(canvas, dc);
    draw_roots(canvas, dc);
}

// What the dashes are. Points touch for no time: the two ways are one.
void ContactTimePanel::draw_note(Canvas& canvas, const DrawContext& dc) const {
    const double u = dc.unit;
    const Point sample{dc.area.x, dc.area.y + 2.35 * u};
    canvas.stroke_dashed(sample, {sample.x + 1.8 * u, sample.y}, 0.14 * u, 0.35 * u,
                         dc.theme.muted);
    TextStyle note = label_style(dc);
    note.max_width = dc.area.width - 2.3 * u;
    const bool fits = measure_text(passing, label_style(dc)).width <= note.max_width;
    draw_text(canvas, {sample.x + 2.3 * u, sample.y + 0.35 * u},
              fits ? passing : "if they did not touch", note);
}

void ContactTimePanel::draw_curves(Canvas& canvas, const DrawContext& dc) const {
    const Scales s = scales(dc);
    const double u = dc.unit;
    const auto parabola = [this](double time) { return met_.free_square(time); };
    const auto truth = [this](double time) { return met_.square(time); };
    const double level = s.y(contact_);
    if (contact_ > 0.0)
        canvas.stroke_line({s.area.x, level}, {s.area.right(), level}, 0.08 * u, dc.theme.muted);
    canvas.clip_to({s.area.x, s.area.y, s.area.width, s.area.height + u});
    const double from = std::max(first_, met_.since);
    if (from > first_)
        canvas.stroke_path(path(dc, parabola, first_, from), 0.14 * u, dc.theme.muted, 0.35 * u);
    canvas.stroke_path(path(dc, parabola, met_.time, last_), 0.14 * u, dc.theme.muted, 0.35 * u);
    const Color color = edge_of(dc.theme.highlight, dc.theme);
    canvas.stroke_path(path(dc, truth, from, met_.time), 0.2 * u, color);
    canvas.stroke_path(path(dc, truth, met_.time, std::min(last_, met_.until)), 0.2 * u,
                       mix(color, dc.theme.page, 0.35));
    canvas.release_clip();
}

void ContactTimePanel::draw_roots(Canvas& canvas, const DrawContext& dc) const {
    const Scales s = scales(dc);
    const double u = dc.unit;
    const Point contact = s(met_.time, contact_), other = s(met_.other_root(), contact_);
    for (const Point& root : {contact, other})
        canvas.stroke_dashed(root, {root.x, s.area.bottom()}, 0.07 * u, 0.25 * u, dc.theme.muted);
    canvas.fill_circle(other, 0.32 * u, dc.theme.muted);
    canvas.fill_circle(other, 0.19 * u, dc.theme.page);
    canvas.fill_circle(contact, 0.34 * u, dc.theme.ink);

    // As near to the contact as there is room between the curves.
    const double high = s.area.y + 1.1 * u;
    std::vector<Point> above;
    for (double y = contact.y - u; y > high; y -= 0.5 * u) above.push_back({contact.x, y});
    for (const double aside : {0.0, 0.15, -0.15})
        above.push_back({contact.x + aside * s.area.width, high});
    const std::string words = "contact at " + three_digits(met_.time);
    const std::array beside_it{Point{contact.x + 0.6 * u, high},
                               Point{contact.x + 0.6 * u, high + u}};
    if (!draw_label(canvas, dc, words, above, Align::center))
        draw_label(canvas, dc, words, beside_it, Align::left);
    const double left = s.area.x + 0.4 * u, right = s.area.right() - 0.2 * u;
    if (contact_ > 0.0) {
        const std::array beside{Point{left, contact.y - 0.5 * u}, Point{left, contact.y + 1.2 * u},
                                Point{contact.x + 0.7 * u, contact.y - 0.5 * u}};
        const std::string level = "σ² = " + three_digits(contact_);
        if (!draw_label(canvas, dc, level, beside, Align::left)) draw_level_note(canvas, dc, level);
    }
    if (other.x - contact.x < u) return;
    const std::array after{Point{right, other.y + 1.3 * u},
                           Point{right, s.area.y + 1.1 * u},
                           Point{right, s.area.y + 2.1 * u},
                           Point{right, other.y - 0.5 * u},
                           Point{other.x - 0.5 * u, other.y - 0.5 * u},
                           Point{other.x - 0.5 * u, other.y - 1.5 * u}};
    draw_label(canvas, dc, three_digits(met_.other_root()) + " is too late", after, Align::right);
}

// In low areas the level has its name at the end of the row under the title, if there is room.
void ContactTimePanel::draw_level_note(Canvas& canvas, const DrawContext& dc,
                                       const std::string& words) const {
    const double u = dc.unit;
    TextStyle style = label_style(dc);
    style.align = Align::right;
    const Point end{dc.area.right(), dc.area.y + 2.7 * u};
    const double width = measure_text(words, style).width;
    if (width + measure_text(passing, style).width + 4.7 * u > dc.area.width) return;
    draw_text(canvas, end, words, style);
    const double x = end.x - width - 0.5 * u;
    canvas.stroke_line({x - 1.0 * u, end.y - 0.35 * u}, {x, end.y - 0.35 * u}, 0.08 * u,
                       dc.theme.muted);
}

// At the first of some places where it lies upon no curve; false if there is none.
bool ContactTimePanel::draw_label(Canvas& canvas, const DrawContext& dc, const std::string& words,
                                  std::span<const Point> places, Align align) const {
    TextStyle style = label_style(dc);
    style.align = align;
    style.color = dc.theme.ink;
    const double width = measure_text(words, style).width;
    const double share = align == Align::left ? 0.0 : align == Align::center ? 0.5 : 1.0;
    for (const Point& at : places) {
        const Rect rect{at.x - share * width, at.y - 0.85 * dc.unit, width, 1.1 * dc.unit};
        if (!is_free(dc, rect)) continue;
        draw_text(canvas, at, words, style);
        return true;
    }
    return false;
}

bool ContactTimePanel::is_free(const DrawContext& dc, const Rect& rect) const {
    const Scales s = scales(dc);
    if (rect.x < s.area.x || rect.right() > s.area.right() + 0.1 * dc.unit ||
        rect.bottom() > s.area.bottom())
        return false;
    const double margin = 0.25 * dc.unit;
    const auto parabola = [this](double time) { return met_.free_square(time); };
    const auto truth = [this](double time) { return met_.square(time); };
    for (const Curve& curve : {Curve(parabola), Curve(truth)})
        for (const Point& p : path(dc, curve, first_, last_))
            if (p.x > rect.x - margin && p.x < rect.right() + margin && p.y > rect.y - margin &&
                p.y < rect.bottom() + margin)
                return false;
    const double level = s.y(contact_);
    return level < rect.y || level > rect.bottom();
}

void ContactTimePanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const std::optional<double> present = static_cast<const ContactState&>(state).time;
    if (!present) return;
    const double now = *present;
    if (now < std::max(first_, met_.since) || now > std::min(last_, met_.until)) return;
    const Scales s = scales(dc);
    const Point at = s(now, met_.square(now));
    if (at.y < s.area.y) return;
    const double u = dc.unit;
    canvas.stroke_dashed(at, {at.x, s.area.bottom()}, 0.07 * u, 0.25 * u, dc.theme.ink);
    canvas.fill_circle(at, 0.5 * u, dc.theme.page);
    canvas.fill_circle(at, 0.4 * u, edge_of(dc.theme.highlight, dc.theme));
}

Table ContactTimePanel::table(const PanelState& state, const Theme&) const {
    Table table{{"part", "of", column_name("time", reduced::time),
                 column_name("squared distance", "length^2")}};
    const auto add_curve = [&](const char* of, const Curve& curve, double from, double to) {
        for (int i = 0; i <= curve_points; ++i) {
            const double time = from + (to - from) * i / curve_points;
            table.rows.push_back({"curve", of, time, curve(time)});
        }
    };
    const auto parabola = [this](double time) { return met_.free_square(time); };
    const auto truth = [this](double time) { return met_.square(time); };
    const double from = std::max(first_, met_.since), to = std::min(last_, met_.until);
    if (from > first_) add_curve("without the collision before", parabola, first_, from);
    add_curve("before", truth, from, met_.time);
    add_curve("after", truth, met_.time, to);
    add_curve("if they passed through each other", parabola, met_.time, last_);
    if (contact_ > 0.0)
        for (const double time : {first_, last_})
            table.rows.push_back({"level", "contact", time, contact_});
    table.rows.push_back({"mark", "contact", met_.time, contact_});
    table.rows.push_back({"mark", "other root", met_.other_root(), contact_});
    const std::optional<double> now = static_cast<const ContactState&>(state).time;
    if (now && *now >= from && *now <= to)
        table.rows.push_back({"mark", "present", *now, met_.square(*now)});
    return table;
}

}  // namespace

std::unique_ptr<Panel> make_contact_time(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<ContactTimePanel>(context, spec);
}

}  // namespace carom
