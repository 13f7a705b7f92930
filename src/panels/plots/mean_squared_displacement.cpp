// The mean squared displacement of particles against time, since a time and on through periodic
// sides, with the line of slope 2 d D that fits it from a time on: D is the diffusion coefficient.
#include <cmath>

#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "stats/displacements.h"
#include "util/text.h"

namespace carom {
namespace {

const plot::Stroke of_fit{.role = {.of = plot::Role::Of::highlight},
                          .width = 0.08,
                          .dashes = {0.3},
                          .shade = plot::Shade::legible};

// The line that fits a line of a run from a time on, before the run turns back; none of too few
// points.
std::optional<plot::Line> fit_of(const PanelContext& context, const SeriesRun& run,
                                 std::size_t line, double from, double& coefficient) {
    std::vector<double> times, squares;
    const double reversal = run.turns.empty() ? INFINITY : run.turns.front();
    for (std::size_t i = 0; i < run.time.size() && run.time[i] <= reversal; ++i) {
        const bool stands = !times.empty() && times.back() == run.time[i];
        if (run.time[i] < from || stands || !std::isfinite(run.lines[line][i])) continue;
        times.push_back(run.time[i]);
        squares.push_back(run.lines[line][i]);
    }
    if (times.size() < 2) return {};
    const LineFit fit = fit_line(times, squares);
    coefficient = fit.slope / (2.0 * context.scene.gas.box.dimension);
    const double first = times.front(), last = times.back();
    plot::Line found{{.part = "fit", .still = true},
                     plot::column("", {first, last}),
                     plot::column("", {fit.at(first), fit.at(last)})};
    found.stroke = of_fit;
    return found;
}

// The lines that fit, and their coefficients in words.
void add_fits(const PanelContext& context, const std::vector<Chosen>& chosen, double from,
              const SeriesRecord& record, plot::Plot& whole) {
    const Language language = context.language();
    const bool compares = record.compares();
    std::vector<std::string> all;
    for (std::size_t k = 0; k < record.runs.size(); ++k)
        for (std::size_t i = 0; i < record.runs[k].lines.size(); ++i) {
            double coefficient = 0.0;
            std::optional<plot::Line> line = fit_of(context, record.runs[k], i, from, coefficient);
            if (!line) continue;
            line->of = column_name_of(context.scene, chosen[compares ? record.compared : i]);
            line->x.name = whole.columns[0];
            line->y.name = whole.columns[1];
            if (compares) line->run = k;
            if (compares) line->stroke = plot::stroke_of_run(k, of_fit.width);
            const std::string value = three_digits(language, coefficient);
            const std::string name =
                compares ? record.runs[k].name : name_of(context.scene, chosen[i]);
            all.push_back(chosen.size() > 1 || compares ? name + " " + value : value);
            whole.layers.emplace_back(std::move(*line));
        }
    if (all.empty()) return;
    const std::string since = three_digits(language, from), values = listed(language, all);
    const std::string found = "<i>D</i> = " + escape_markup(values);
    whole.notes.push_back(
        {.entries = {
             {of_fit, {say(language, "fit 2<i>dDt</i> from time {}: {}", since, found), found}}}});
    whole.account =
        say(language, "The line 2dDt fitted from time {} on has D = {}.", since, values);
}

}  // namespace

std::unique_ptr<Panel> make_mean_squared_displacement(const PanelContext& context,
                                                      const PanelSpec& spec) {
    const double fit_from = spec.fit_from.value_or(0.5 * (spec.from + context.scene.run.until));
    SeriesSubject subject = subject_of_choices(context, spec, Phrase{"Mean squared displacement"});
    subject.measure =
        [of = members(context, choices(spec)),
         moved = Displacements(context.scene.gas.box, spec.from)](const FrameInput& input) mutable {
            const Eigen::ArrayXd square =
                moved(input.sample, input.advanced.collisions).square().rowwise().sum();
            std::vector<double> now;
            for (const std::vector<Eigen::Index>& list : of) now.push_back(square(list).mean());
            return now;
        };
    subject.quantity = Phrase{"mean squared displacement"};
    subject.unit = "length^2";
    subject.needs_collisions = true;
    subject.add = [context, chosen = choices(spec), fit_from](const SeriesRecord& record,
                                                              plot::Plot& whole) {
        add_fits(context, chosen, fit_from, record, whole);
    };
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace carom
