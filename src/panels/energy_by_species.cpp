// The mean kinetic energy of each species against time: who gives, who takes, and where they meet.
#include <algorithm>
#include <cmath>

#include "panels/registry.h"
#include "stats/histogram.h"
#include "util/text.h"

namespace carom {
namespace {

// The whole history is known after the first pass: every frame's state shares it and says how much
// of it to show.
struct History {
    std::vector<double> time;                ///< folded at reversals
    std::vector<int> leg;                    ///< reversals so far
    std::vector<std::vector<double>> means;  ///< species x frame
};

struct SeriesState : PanelState {
    std::size_t shown = 0;
};

// Points nearer than half the line's width to the one before show nothing new, and a long film has
// thousands.
bool is_apart(const Point& a, const Point& b, double distance) {
    return std::abs(a.x - b.x) > distance || std::abs(a.y - b.y) > distance;
}

class EnergyBySpecies : public Panel {
  public:
    EnergyBySpecies(const Cast& cast, const PanelSpec& spec) : cast_(cast), spec_(spec) {
        history_.means.resize(cast.scene.gas.species.size());
    }

    void survey(const Observation& observation) override;
    void settle() override;
    std::shared_ptr<const PanelState> state(const Observation& observation) override;
    void draw_ground(Canvas& canvas, const Page& page) const override;
    void draw(Canvas& canvas, const Page& page, const PanelState& state) const override;

  private:
    struct Scales {
        Rect area;
        Scale x, y;
        double height(double energy, bool logarithmic) const {
            return std::clamp(y(logarithmic ? std::log10(energy) : energy), area.y, area.bottom());
        }
    };
    Scales scales(const Page& page) const;
    Eigen::ArrayXd means(const Eigen::ArrayXd& energy) const;
    std::string title(const Page& page) const;
    void draw_reversals(Canvas& canvas, const Page& page) const;
    void draw_line(Canvas& canvas, const Page& page, std::size_t species, std::size_t shown) const;

    Cast cast_;
    PanelSpec spec_;
    History history_;
    std::size_t seen_ = 0;
    double low_ = 0.0, high_ = 1.0;    // of the vertical axis; powers of ten if logarithmic
    double first_ = 0.0, last_ = 1.0;  // of the time axis
    double overall_ = 0.0;
    bool logarithmic_ = false;
};

Eigen::ArrayXd EnergyBySpecies::means(const Eigen::ArrayXd& energy) const {
    const auto kinds = static_cast<Eigen::Index>(history_.means.size());
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(kinds);
    Eigen::ArrayXd count = Eigen::ArrayXd::Zero(kinds);
    for (Eigen::Index i = 0; i < energy.size(); ++i) {
        sum[cast_.particles.species[i]] += energy[i];
        count[cast_.particles.species[i]] += 1.0;
    }
    return sum / count.max(1.0);
}

void EnergyBySpecies::survey(const Observation& observation) {
    const Eigen::ArrayXd mean = means(observation.energy);
    if (history_.time.empty() && cast_.equilibrium) overall_ = mean_energy(*cast_.equilibrium);
    history_.time.push_back(folded_time(cast_.scene.run, observation.tick.time));
    history_.leg.push_back(observation.tick.reversals);
    for (std::size_t k = 0; k < history_.means.size(); ++k)
        history_.means[k].push_back(mean[static_cast<Eigen::Index>(k)]);
}

void EnergyBySpecies::settle() {
    std::vector<double> all;
    for (const std::vector<double>& line : history_.means)
        for (double mean : line)
            if (mean > 0.0 && std::isfinite(mean)) all.push_back(mean);
    first_ = *std::ranges::min_element(history_.time);
    last_ = *std::ranges::max_element(history_.time);
    if (last_ <= first_) last_ = first_ + 1.0;
    if (all.empty()) return;

    const double most = *std::ranges::max_element(all);
    const double least =
        quantile(all, 0.01);  // one particle's energy may touch zero for an instant
    constexpr double linear_up_to = 50.0;
    logarithmic_ = most > linear_up_to * least;
    low_ = logarithmic_ ? std::floor(std::log10(least)) : 0.0;
    high_ = logarithmic_ ? std::ceil(std::log10(most)) : round_up_for_axis(most);
}

std::shared_ptr<const PanelState> EnergyBySpecies::state(const Observation&) {
    auto state = std::make_shared<SeriesState>();
    state->shown = ++seen_;
    return state;
}

EnergyBySpecies::Scales EnergyBySpecies::scales(const Page& page) const {
    const Rect area = plot_area(page);
    return {area, {first_, last_, area.x, area.right()}, {low_, high_, area.bottom(), area.y}};
}

std::string EnergyBySpecies::title(const Page& page) const {
    if (spec_.title) return escape_markup(*spec_.title);
    const std::vector<Species>& species = cast_.scene.gas.species;
    if (species.size() == 1) return "Mean energy";
    std::string words;
    for (std::size_t k = 0; k < species.size(); ++k) {
        if (k > 0) words += k + 1 == species.size() ? " and " : ", ";
        words += colored(species[k].name, species_color(cast_, k, page.theme));
    }
    return "Mean energy: " + words;
}

void EnergyBySpecies::draw_ground(Canvas& canvas, const Page& page) const {
    draw_panel_title(canvas, page, title(page));
    const Scales s = scales(page);
    draw_x_axis(canvas, s.area, s.x, "time", axis_style(page));
    if (logarithmic_) draw_log_y_axis(canvas, s.area, s.y, "", axis_style(page));
    if (!logarithmic_) draw_y_axis(canvas, s.area, s.y, "", axis_style(page));
    draw_reversals(canvas, page);
    if (!cast_.equilibrium || history_.means.size() < 2) return;
    const double y = s.height(overall_, logarithmic_);
    canvas.stroke_dashed({s.area.x, y}, {s.area.right(), y}, 0.08 * page.unit, 0.3 * page.unit,
                         page.theme.muted);
    const double u = page.unit;
    const Point sample{s.area.right() - 10.3 * u, s.area.y + 0.8 * u};
    canvas.stroke_dashed({sample.x - 1.2 * u, sample.y - 0.35 * u},
                         {sample.x + 0.1 * u, sample.y - 0.35 * u}, 0.08 * u, 0.3 * u,
                         page.theme.muted);
    draw_text(canvas, {sample.x + 0.6 * u, sample.y}, "equal shares " + three_digits(overall_),
              label_style(page));
}

// A thin line where the time axis turns back, with the word.
void EnergyBySpecies::draw_reversals(Canvas& canvas, const Page& page) const {
    const Scales s = scales(page);
    for (const RunEvent& event : cast_.scene.run.events) {
        const double x = s.x(folded_time(cast_.scene.run, event.at));
        canvas.stroke_line({x, s.area.y}, {x, s.area.bottom()}, 0.08 * page.unit, page.theme.muted);
        TextStyle style = label_style(page);
        style.align = x > s.area.x + s.area.width / 2 ? Align::right : Align::left;
        const double gap = style.align == Align::right ? -0.4 : 0.4;
        draw_text(canvas, {x + gap * page.unit, s.area.bottom() - 0.5 * page.unit}, "reversed",
                  style);
    }
}

void EnergyBySpecies::draw_line(Canvas& canvas, const Page& page, std::size_t species,
                                std::size_t shown) const {
    const Scales s = scales(page);
    const std::vector<double>& line = history_.means[species];
    const Color color = species_color(cast_, species, page.theme);
    std::vector<Point> path;
    for (std::size_t i = 0; i < shown; ++i) {
        if (!std::isfinite(line[i])) continue;
        const Point last{s.x(history_.time[i]), s.height(std::max(line[i], 1e-300), logarithmic_)};
        const bool leg_ends = i + 1 == shown || history_.leg[i + 1] != history_.leg[i];
        if (leg_ends || path.empty() || is_apart(path.back(), last, 0.08 * page.unit))
            path.push_back(last);
        if (!leg_ends) continue;
        const bool way_back = history_.leg[i] % 2 == 1;
        canvas.stroke_path(path, 0.16 * page.unit,
                           way_back ? mix(color, page.theme.ink, 0.5) : color);
        path = {last};
    }
    if (!path.empty()) canvas.fill_circle(path.back(), 0.3 * page.unit, color);
}

void EnergyBySpecies::draw(Canvas& canvas, const Page& page, const PanelState& state) const {
    const auto& now = static_cast<const SeriesState&>(state);
    for (std::size_t k = history_.means.size(); k-- > 0;) draw_line(canvas, page, k, now.shown);
}

}  // namespace

std::unique_ptr<Panel> make_energy_by_species(const Cast& cast, const PanelSpec& spec) {
    return std::make_unique<EnergyBySpecies>(cast, spec);
}

}  // namespace carom
