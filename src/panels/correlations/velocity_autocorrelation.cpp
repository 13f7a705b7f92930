// The velocity autocorrelation <v(0) v(t)> / <v^2>, averaged over all starting times, with its
// initial slope in equilibrium.
#include <algorithm>
#include <cmath>

#include "panels/chosen.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/correlations/lag_meter.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "util/text.h"

namespace carom {
namespace {

const plot::Stroke of_slope{.role = {.of = plot::Role::Of::accent},
                            .width = 0.1,
                            .dashes = {0.5, 0.35},
                            .shade = plot::Shade::legible};

class AutocorrelationMeter : public LagMeter {
  public:
    AutocorrelationMeter(const PanelContext& context,
                         const std::vector<std::vector<Eigen::Index>>& members, double from,
                         double lags)
        : LagMeter(context, LagAverages::Of::velocities, members, from, lags),
          context_(context),
          from_(from),
          lists_of_(static_cast<std::size_t>(context.particles.count())),
          sizes_(members.size()),
          weights_(members.size()),
          loss_(members.size()),
          ends_(members.size()) {
        for (std::size_t k = 0; k < members.size(); ++k) {
            for (const Eigen::Index i : members[k]) {
                lists_of_[static_cast<std::size_t>(i)].push_back(k);
                weights_[k] += context.particles.inverse_mass[i];
                if (context.particles.inverse_mass[i] > 0.0) sizes_[k] += 1.0;
            }
        }
    }

    void see(const FrameInput& input) override {
        LagMeter::see(input);
        time_ = input.sample.time;
        for (const Collision& one : input.advanced.collisions) {
            if (one.time < from_) continue;
            const bool is_pair = one.second.is_particle();
            add(one.first, is_pair ? inverse_mass(one.second.particle()) : 0.0, is_pair);
            if (is_pair) add(one.second.particle(), inverse_mass(one.first), is_pair);
        }
    }

    // The numbers of each line are the slope at 0 for very many particles, and the collisions of
    // each particle.
    Measured measured() const override {
        Measured now;
        const Eigen::ArrayXXd means = averages_.averages();
        for (std::size_t k = 0; k < sizes_.size(); ++k) {
            const auto its = means.row(static_cast<Eigen::Index>(k));
            const Eigen::ArrayXd shares = its / its[0];
            now.y.emplace_back(shares.begin(), shares.end());
            const double time = time_ - from_;
            const double slope = time > 0.0 ? -loss_[k] / (weights_[k] * time) : NAN;
            const double collisions = sizes_[k] > 0.0 ? ends_[k] / sizes_[k] : 0.0;
            now.numbers.push_back({{slope, NAN}, {collisions, NAN}});
        }
        return now;
    }

    void archive(Archive& archive) override {
        LagMeter::archive(archive);
        archive(loss_, ends_);
    }

  private:
    double inverse_mass(Eigen::Index i) const { return context_.particles.inverse_mass[i]; }

    // In equilibrium a collision with a mass M removes on average the fraction 4 / d M / (m + M) of
    // the velocity of a particle of mass m, up to a factor near 1 for finite numbers. The initial
    // slope -d C / d t at t = 0 is therefore the sum of this fraction over all collisions per unit
    // time, each with the weight of the particle's mean squared velocity, 1 / m. A wall is an
    // infinite mass.
    void add(Eigen::Index particle, double others_inverse_mass, bool is_pair) {
        const double sum = inverse_mass(particle) + others_inverse_mass;
        if (!(sum > 0.0)) return;  // two infinite masses
        const double lost = 4.0 / context_.box().dimension * inverse_mass(particle) / sum;
        for (const std::size_t k : lists_of_[static_cast<std::size_t>(particle)]) {
            loss_[k] += lost * inverse_mass(particle);
            if (is_pair) ends_[k] += 1.0;
        }
    }

    PanelContext context_;
    double from_, time_ = 0.0;
    std::vector<std::vector<std::size_t>> lists_of_;     // of each particle
    std::vector<double> sizes_, weights_, loss_, ends_;  // of each list
};

void add_slopes(const PanelContext& context, const std::vector<Chosen>& chosen, double lags,
                const CurveValues* values, plot::Plot& plot) {
    const Language language = context.language();
    plot::Note note{.wraps = true, .changes = true};
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        plot::Stroke stroke = of_slope;
        if (chosen.size() > 1) stroke.role = choice_role(context, chosen[k], k);
        double slope = 0.0;
        if (values != nullptr)
            if (const Law found = law(
                    context.gas, LawOf::autocorrelation,
                    {.of = members(context, chosen[k]), .collisions = values->numbers[k][1].mean}))
                slope = found.value * values->numbers[k][0].mean;
        const auto words = [&](const std::string& number) {
            return plot::Text(say(language, "slope {}", number));
        };
        note.entries.push_back({.swatch = stroke,
                                .words = {words(slope < 0.0 ? three_digits(language, slope) : "")},
                                .reserved = {{words(longest_number)}}});
        if (!(slope < 0.0)) continue;
        const double end = std::min(lags, -1.0 / slope);
        plot::Polyline line;
        line.part = "slope at 0";
        line.of = column_name_of(context.scene, chosen[k]);
        line.x = plot::column(plot.columns[0], {0.0, end});
        line.y = plot::column(plot.columns[1], {1.0, 1.0 + slope * end});
        line.stroke = stroke;
        line.depth = 1;
        plot.layers.emplace_back(std::move(line));
    }
    plot.notes.push_back(std::move(note));
}

std::vector<Binding<AutocorrelationOptions>> autocorrelation_keys() {
    return {bind_within(&AutocorrelationOptions::lags, lags_key()),
            bind_within(&AutocorrelationOptions::from, from_key())};
}

void check_autocorrelation(PanelSpec& panel, const Node& node, Reading& reading) {
    const auto& options = panel.options.as<AutocorrelationOptions>();
    if (!(reading.run.until > 0.0) || is_late(given(node, "from"), options.from, reading)) return;
    check_lags(options.lags, options.from, node, reading);
}

std::unique_ptr<Panel> make_velocity_autocorrelation(const PanelContext& context,
                                                     const PanelSpec& spec) {
    const Language language = context.language();
    const std::vector<Chosen> chosen = choices(spec);
    const auto& options = spec.options.as<AutocorrelationOptions>();
    const double lags = longest_lag(options, context.run());
    CurveSubject subject{.points = lag_count, .from = options.from};
    subject.meter = [context, lists = members_that_collide(context, chosen), from = options.from,
                     lags] {
        return std::make_unique<AutocorrelationMeter>(context, lists, from, lags);
    };
    name_curves(subject, context, spec, say(language, "Velocity autocorrelation"), "");
    subject.along = quantities::time.named(Phrase{"time lag"});
    subject.up = quantities::number.named(Phrase{"velocity autocorrelation"});
    subject.reach = lags;
    subject.top = 1.0;
    subject.account = [language, context, chosen](const CurveValues& values,
                                                  std::size_t line) -> std::string {
        const std::vector<double>& curve = values.y[line];
        const auto half = std::ranges::find_if(curve, [](double value) { return value < 0.5; });
        if (half == curve.end()) return "";
        const double at = values.reach() * static_cast<double>(half - curve.begin()) /
                          static_cast<double>(curve.size() - 1);
        return say(language,
                   "{}: the velocity autocorrelation falls to one half after a time of {}",
                   name_of(context.scene, chosen[line]), three_digits(language, at));
    };
    if (spec.theory && law(context.gas, LawOf::autocorrelation))
        subject.add = [context, chosen, lags](const CurveValues* values, plot::Plot& plot) {
            add_slopes(context, chosen, lags, values, plot);
        };
    return std::make_unique<CurvePanel>(context, std::move(subject));
}

}  // namespace

PanelKind velocity_autocorrelation_kind() {
    using enum Ability;
    return {.name = "velocity-autocorrelation",
            .words = Phrase{"velocity autocorrelation"},
            .shows =
                "The mean of **v**(0)·**v**(*t*) over all starting times, divided by that of "
                "*v*², with the initial slope that collisions give it in equilibrium.",
            .make = make_velocity_autocorrelation,
            .abilities = {of, theory, means, comparison},
            .tried_as = {"vacf"},
            .keys = option_keys(autocorrelation_keys()),
            .rule = check_autocorrelation,
            .laws = always(std::vector{LawOf::autocorrelation}),
            .work = [](const PanelSpec& panel, const Run& run) {
                return PanelWork{
                    .flights = PanelWork::Flights::lags,
                    .longest_lag = longest_lag(panel.options.as<AutocorrelationOptions>(), run)};
            }};
}

}  // namespace carom
