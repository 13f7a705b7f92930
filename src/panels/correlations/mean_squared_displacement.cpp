// The mean squared displacement of particles, unwrapped across periodic sides: since a fixed time,
// or averaged over all starting times from then on; of the particles chosen at the start. With the
// initial ballistic parabola <v^2> t^2, and where the gas diffuses (LawOf::displacement) the fitted
// line of slope 2 d D, where D is the diffusion coefficient.
#include <algorithm>
#include <cmath>
#include <variant>

#include "panels/chosen.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/correlations/diffusion.h"
#include "panels/correlations/displacement_meter.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "physics/gas.h"
#include "scene/panel_kind.h"
#include "stats/displacements.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr Quantity mean_square =
    quantities::distance.squared().named(Phrase{"mean squared displacement"});

constexpr Quantity diffusion_coefficient =
    (mean_square / quantities::time).named(Phrase{"diffusion coefficient"});

// The time of the first reversal, or infinity.
double first_reversal(const Run& run) {
    const std::vector<double> times = reversal_times(run);
    return times.empty() ? INFINITY : times.front();
}

// Fits a line to the squared displacements of each particle. The mean of the slopes is the slope of
// the mean, and their scatter gives its standard error.
class SlopesOfParticles {
  public:
    SlopesOfParticles(double from, double until) : from_(from), until_(until) {}

    void add(double time, const Eigen::ArrayXd& squares) {
        if (time < from_ || time > until_ || time == last_ || !squares.allFinite()) return;
        last_ = time;
        if (count_ == 0.0) values_ = products_ = 0.0 * squares;
        count_ += 1.0;
        times_ += time;
        time_squares_ += time * time;
        values_ += squares;
        products_ += time * squares;
    }

    // Of one particle; NaN if too little was seen.
    double slope(Eigen::Index i) const {
        const double spread = time_squares_ - times_ * times_ / count_;
        if (!(count_ > 1.0) || !(spread > 0.0)) return NAN;
        return (products_[i] - values_[i] * times_ / count_) / spread;
    }

  private:
    double from_, until_, last_ = -INFINITY;
    double count_ = 0.0, times_ = 0.0, time_squares_ = 0.0;
    Eigen::ArrayXd values_, products_;
};

// What a run has shown of displacements since a fixed time.
struct DisplacementsSoFar {
    std::vector<std::vector<Eigen::Index>> lists;
    Displacements moved;
    SlopesOfParticles slopes, first, second;  // of the fit, and of its two halves
    PartnerCounts collisions;
    std::vector<double> square_speeds = {};

    std::vector<double> see(const FrameInput& input) {
        const Eigen::ArrayXd square =
            moved(input.sample, input.advanced.collisions).square().rowwise().sum();
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : lists) now.push_back(square(list).mean());
        if (square_speeds.empty() && square.allFinite())
            for (const std::vector<Eigen::Index>& list : lists)
                square_speeds.push_back(input.speed(list).square().mean());
        for (SlopesOfParticles* each : {&slopes, &first, &second})
            if (input.is_sample) each->add(input.tick.time, square);
        collisions.see(input);
        return now;
    }

    std::vector<std::vector<MeanError>> numbers(int dimension) const {
        std::vector<std::vector<MeanError>> all;
        for (std::size_t k = 0; k < lists.size(); ++k) {
            std::vector<double> coefficients, bends;
            for (const Eigen::Index i : lists[k]) {
                coefficients.push_back(slopes.slope(i) / (2.0 * dimension));
                bends.push_back((second.slope(i) - first.slope(i)) / (2.0 * dimension));
            }
            const std::size_t count = lists[k].size();
            std::vector<MeanError> of(numbers_count, {NAN, NAN});
            of[of_diffusion] = mean_error(coefficients);
            if (!square_speeds.empty()) of[of_square_speed].mean = square_speeds[k];
            of[of_bend] = mean_error(bends);
            of[of_collisions].mean = collisions.mean(lists[k]);
            of[of_pieces].mean = count >= fewest_scattered ? double(count) : 1.0;
            all.push_back(std::move(of));
        }
        return all;
    }
};

const DisplacementOptions& options_of_displacements(const PanelSpec& panel) {
    return panel.options.as<DisplacementOptions>();
}

std::vector<Binding<DisplacementOptions>> displacement_keys() {
    return {
        bind_within(&DisplacementOptions::from, from_key()),
        bind_key("origins", &DisplacementOptions::all_origins,
                 one_of<bool>({{"one", false}, {"all", true}}),
                 "Displacements since `from`, or their mean over all starting times from then on, "
                 "against the time lag."),
        bind_within(&DisplacementOptions::lags, lags_key()),
        bind_key("fit_from", &DisplacementOptions::fit_from, number(not_negative, quantities::time),
                 "The time from which the line 2 d D t is fitted; D is the diffusion "
                 "coefficient. With `origins: all`, the time lag.")
            .default_text("half-way from `from` to the end; with `origins: all`, half of `lags`")};
}

// The fitted line needs a part of the run in which displacements are measured.
void check_displacements(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!(reading.run.until > 0.0)) return;
    const auto& options = options_of_displacements(panel);
    const Node *from = given(node, "from"), *fit_from = given(node, "fit_from");
    if (is_late(from, options.from, reading)) return;
    if (options.all_origins) {
        check_lags(options.lags, options.from, node, reading);
        const double lags = longest_lag(options, reading.run);
        if (fit_from != nullptr && *options.fit_from >= lags)
            reading.errors.add(*fit_from, fmt::format("expected a time below {}", lags),
                               fmt::format("times since a start go up to {}", lags));
        return;
    }
    if (const Node* lags = given(node, "lags"))
        reading.errors.add(*lags, "`lags` belongs to `origins: all`", "add that, or leave it out");
    if (fit_from == nullptr || is_late(fit_from, *options.fit_from, reading)) return;
    if (*options.fit_from < options.from)
        reading.errors.add(
            *fit_from,
            fmt::format("displacements are measured from {}, which is later", options.from),
            "give a time from there on, or an earlier `from`");
}

PanelWork work_of_displacements(const PanelSpec& panel, const Run& run) {
    const auto& options = options_of_displacements(panel);
    if (!options.all_origins) return {.flights = PanelWork::Flights::displaced};
    return {.flights = PanelWork::Flights::lags, .longest_lag = longest_lag(options, run)};
}

// Whether places at the start say nothing of those at the end: the plateau is the mean over both.
bool starts_anywhere(const PanelContext& context) {
    return context.run().equilibrate > 0.0 ||
           std::ranges::all_of(context.species(), [](const Species& species) {
               return species.count == 0 || std::holds_alternative<RandomPlaces>(species.position);
           });
}

// The law of a line of a run; of a mean over runs, which differ in their collisions only, that of
// the mean.
LineLaw law_of_line(const std::vector<LineLaw>& of_run, std::size_t line,
                    const PanelContext& context, const Chosen& chosen,
                    const std::vector<MeanError>& numbers) {
    return of_run.empty() ? displacement_law(context, chosen, numbers[of_collisions].mean)
                          : of_run[line];
}

SeriesSubject since_a_time(const PanelContext& context, const PanelSpec& spec) {
    const auto& options = options_of_displacements(spec);
    const double fit_from = options.fit_from.value_or(0.5 * (options.from + context.run().until));
    const double fit_until = std::min(first_reversal(context.run()), context.run().until);
    const double middle = 0.5 * (fit_from + fit_until);
    const std::vector<Chosen> chosen = choices(spec);
    SeriesSubject subject =
        subject_of_choices(context, spec, Phrase{"Mean squared displacement"}, mean_square);
    const auto followed = std::make_shared<DisplacementsSoFar>(DisplacementsSoFar{
        members_that_collide(context, chosen), Displacements(context.box(), options.from),
        SlopesOfParticles(fit_from, fit_until), SlopesOfParticles(fit_from, middle),
        SlopesOfParticles(middle, fit_until),
        PartnerCounts(context.box(), context.particles, options.from, fit_from)});
    subject.read = [followed](const FrameInput& input) { return followed->see(input); };
    subject.numbers = [followed, dimension = context.box().dimension] {
        return followed->numbers(dimension);
    };
    subject.laws = [context, chosen, followed] {
        std::vector<LineLaw> all;
        for (std::size_t k = 0; k < chosen.size(); ++k)
            all.push_back(displacement_law(context, chosen[k],
                                           followed->collisions.mean(followed->lists[k])));
        return all;
    };
    subject.results = {
        {diffusion_coefficient}, [numbers = subject.numbers, laws = subject.laws] {
            const std::vector<LineLaw> of_lines = laws();
            std::vector<std::vector<MeanError>> found;
            for (const std::vector<MeanError>& line : numbers())
                found.push_back({finding_of("", of_lines[found.size()], line, 1).known()});
            return found;
        }};
    subject.needs_collisions = true;
    if (!spec.theory) return subject;
    subject.add = [context, chosen, fit_from, from = options.from](const HistoryRecord& record,
                                                                   plot::Plot& whole) {
        const bool compares = record.compares();
        std::vector<Finding> all;
        for (std::size_t k = 0; k < record.runs.size(); ++k)
            for (std::size_t i = 0; i < record.runs[k].y.size(); ++i) {
                const History& run = record.runs[k];
                const Chosen& choice = chosen[compares ? *record.compared : i];
                const std::string name = compares ? run.name : name_of(context.scene, choice);
                all.push_back(finding_of(chosen.size() > 1 || compares ? name : "",
                                         law_of_line(run.laws, i, context, choice, run.numbers[i]),
                                         run.numbers[i], record.runs_in_mean));
                if (!all.back().is_known()) continue;
                std::optional<plot::Polyline> line =
                    fit_of(whole, run.x, run.y[i], fit_from,
                           run.turns.empty() ? INFINITY : run.turns.front());
                if (!line) continue;
                line->of = column_name_of(context.scene, choice);
                if (compares) line->run = k;
                if (compares) line->stroke = plot::stroke_of_run(k, line->stroke.width);
                whole.layers.emplace_back(std::move(*line));
            }
        add_findings(context.language(), fit_from, all, whole);
        if (compares || chosen.size() != 1) return;
        const History& run = record.runs.front();
        plot::Note note{.wraps = true};
        if (starts_anywhere(context) &&
            add_plateau(all.front(), column_name_of(context.scene, chosen.front()), whole))
            note.entries.push_back(plateau_entry(context.language(), all.front()));
        if (add_ballistic(context, from, run.numbers[0][of_square_speed].mean, true, whole))
            note.entries.push_back(ballistic_entry(context.language()));
        if (!note.entries.empty()) whole.notes.push_back(std::move(note));
    };
    return subject;
}

// Adds the theory of each line to the plot of a moment.
class LagTheory {
  public:
    LagTheory(const PanelContext& context, const PanelSpec& spec, double lags, double fit_from)
        : context_(context),
          chosen_(choices(spec)),
          has_names_(!spec.of.empty()),
          runs_(spec.seeds),
          lags_(lags),
          fit_from_(fit_from) {}

    Finding finding(const CurveValues& values, std::size_t line) const {
        const int runs = values.error.empty() ? 1 : runs_;
        const std::vector<MeanError>& numbers = values.numbers[line];
        return finding_of(name(line),
                          law_of_line(values.laws, line, context_, chosen_[line], numbers), numbers,
                          runs);
    }

    void operator()(const CurveValues* values, plot::Plot& plot) const {
        plot::Note note{.wraps = true, .changes = true};
        for (std::size_t k = 0; k < chosen_.size(); ++k) add_line(values, k, note, plot);
        if (chosen_.size() == 1 && !context_.gas.influences.has_gravity())
            add_parabola(values, note, plot);
        plot.notes.push_back(std::move(note));
    }

  private:
    std::string name(std::size_t line) const {
        return has_names_ ? name_of(context_.scene, chosen_[line]) : "";
    }

    // Before anything is known, what the walls decide is.
    Finding before_all(std::size_t line) const {
        return {.name = name(line),
                .law = displacement_law(context_, chosen_[line], {}),
                .diffusion = {NAN, NAN}};
    }

    void add_line(const CurveValues* values, std::size_t k, plot::Note& note,
                  plot::Plot& plot) const {
        const std::string of = column_name_of(context_.scene, chosen_[k]);
        const Finding found = values != nullptr ? finding(*values, k) : before_all(k);
        plot::KeyEntry entry = finding_entry(context_.language(), found);
        const bool may_pass = !entry.reserved.empty();
        entry.is_hidden = context_.in_film && may_pass && !found.is_known();
        note.entries.push_back(std::move(entry));
        if (chosen_.size() == 1 && add_plateau(found, of, plot))
            note.entries.push_back(plateau_entry(context_.language(), found));
        if (values == nullptr) return;
        std::vector<double> x;
        for (int i = 0; i < lag_count; ++i) x.push_back(lags_ * i / (lag_count - 1));
        std::optional<plot::Polyline> line;
        if (found.is_known()) line = fit_of(plot, x, values->y[k], fit_from_, INFINITY);
        if (line) {
            line->still = false;
            line->of = of;
            plot.layers.emplace_back(std::move(*line));
        }
    }

    // Its entry keeps its room while the parabola cannot be seen.
    void add_parabola(const CurveValues* values, plot::Note& note, plot::Plot& plot) const {
        plot::KeyEntry entry = ballistic_entry(context_.language());
        entry.is_hidden =
            values == nullptr ||
            !add_ballistic(context_, 0.0, values->numbers[0][of_square_speed].mean, false, plot);
        note.entries.push_back(std::move(entry));
    }

    PanelContext context_;
    std::vector<Chosen> chosen_;
    bool has_names_;
    int runs_;
    double lags_, fit_from_;
};

CurveSubject over_all_origins(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const std::vector<Chosen> chosen = choices(spec);
    const auto& options = options_of_displacements(spec);
    const double lags = longest_lag(options, context.run());
    const double fit_from = options.fit_from.value_or(0.5 * lags);
    CurveSubject subject{.points = lag_count, .from = options.from};
    subject.meter = [context, lists = members_that_collide(context, chosen), from = options.from,
                     lags, fit_from] {
        return std::make_unique<DisplacementMeter>(context, lists, from, lags, fit_from);
    };
    name_curves(subject, context, spec, say(language, "Mean squared displacement"), "");
    if (spec.theory && spec.of.size() == 1) subject.names.clear();  // beside its coefficient
    subject.along = quantities::time.named(Phrase{"time lag"});
    subject.up = mean_square;
    subject.reach = lags;
    const LagTheory theory(context, spec, lags, fit_from);
    subject.laws = [context, chosen](const CurveValues& values) {
        std::vector<LineLaw> all;
        for (std::size_t k = 0; k < chosen.size(); ++k)
            all.push_back(
                displacement_law(context, chosen[k], values.numbers[k][of_collisions].mean));
        return all;
    };
    subject.account = [language, theory](const CurveValues& values,
                                         std::size_t line) -> std::string {
        const Finding found = theory.finding(values, line);
        return found.is_known()
                   ? "D = " + with_error(language, found.diffusion)
                   : say(language, "no diffusion coefficient: {}", reason_of(language, found));
    };
    if (spec.theory) subject.add = theory;
    subject.results = {{diffusion_coefficient},
                       [theory](const CurveValues& values, std::size_t line) {
                           return std::vector{theory.finding(values, line).known()};
                       }};
    return subject;
}

// Averages over all starting times are curves, of which only the diffusion coefficient is a
// reading.
Meter meter_of_displacements(const PanelContext& context, const PanelSpec& spec) {
    if (options_of_displacements(spec).all_origins)
        return meter_of_curves(over_all_origins(context, spec));
    return since_a_time(context, spec);
}

std::unique_ptr<Panel> make_mean_squared_displacement(const PanelContext& context,
                                                      const PanelSpec& spec) {
    if (options_of_displacements(spec).all_origins)
        return std::make_unique<CurvePanel>(context, over_all_origins(context, spec));
    return std::make_unique<SeriesPanel>(context, spec, since_a_time(context, spec));
}

}  // namespace

PanelKind mean_squared_displacement_kind() {
    using enum Ability;
    return {.name = "mean-squared-displacement",
            .words = Phrase{"mean squared displacement"},
            .shows =
                "The mean squared displacement, unwrapped across periodic sides, with the fitted "
                "line 2*dDt*, the diffusion coefficient *D* with its error (or the reason why "
                "there is none, and the plateau between walls), and the parabola of free flight; "
                "with `origins: all` averaged over all starting times.",
            .make = make_mean_squared_displacement,
            .meter = meter_of_displacements,
            .abilities = {of, theory, means, comparison},
            .asked = {{.name = "diffusion_coefficient",
                       .meaning = "the diffusion coefficient",
                       .options = "origins: all",
                       .is_result = true}},
            .tried_as = {"msd"},
            .keys = option_keys(displacement_keys()),
            .rule = check_displacements,
            .laws = always(std::vector{LawOf::displacement}),
            .work = work_of_displacements};
}

}  // namespace carom
