// The diffusion coefficient of displacements: where there is one, how it is drawn and described,
// and what is drawn where there is none.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "panels/chosen.h"
#include "panels/meters/history.h"
#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "stats/fitted_slope.h"

namespace carom {

/// Indices of the numbers of a line beyond its points.
enum DiffusionNumber : std::size_t {
    of_diffusion,
    of_square_speed,
    of_bend,        ///< how much D is larger in the second half of the fit than in the first
    of_collisions,  ///< of each particle before the fit
    of_pieces,      ///< independent parts of the run
    numbers_count
};

/// What is known of the diffusion of one line.
struct Finding {
    std::string name = {};                     ///< empty: the only line
    LineLaw law = {};                          ///< of its displacements
    std::optional<SlopeProblem> problem = {};  ///< of the fit, where the law allows one
    MeanError diffusion = {};

    bool is_known() const { return law.reason.empty() && !problem; }

    /// The diffusion coefficient; NaN if there is none.
    MeanError known() const { return is_known() ? diffusion : MeanError{NAN, NAN}; }

    bool has_plateau() const { return !law.reason.empty() && std::isfinite(law.value); }
};

/// The law of the displacements (LawOf::displacement) of chosen particles of the run of `context`,
/// each of which has collided so often; none: as often as it takes.
LineLaw displacement_law(const PanelContext& context, const Chosen& chosen,
                         std::optional<double> collisions);

/// What the law and the fit make of the numbers of a line, from one run or the mean of several.
Finding finding_of(const std::string& name, LineLaw law, const std::vector<MeanError>& numbers,
                   int runs);

/// The reason why there is no diffusion coefficient.
std::string reason_of(Language language, const Finding& finding);

/// A diffusion coefficient with its error.
std::string with_error(Language language, const MeanError& number);

/// The straight line fitted to a line of a run between `from` and `until`, the first reversal; none
/// if there are too few points.
std::optional<plot::Polyline> fit_of(const plot::Plot& plot, const std::vector<double>& x,
                                     const std::vector<double>& y, double from, double until);

/// Adds the ballistic parabola as far as it is visible. Returns false if it is not, and under
/// gravity, where it does not hold.
bool add_ballistic(const PanelContext& context, double from, double square_speed, bool is_still,
                   plot::Plot& plot);

/// Adds the plateau to which walls limit displacements. Returns false if there is none within the
/// axis.
bool add_plateau(const Finding& finding, const std::string& of, plot::Plot& plot);

/// The entries of a key. That of a line is its diffusion coefficient, or why it has none; it takes
/// the same room in all frames.
plot::KeyEntry ballistic_entry(Language language);
plot::KeyEntry plateau_entry(Language language, const Finding& finding);
plot::KeyEntry finding_entry(Language language, const Finding& finding);

/// Adds the diffusion coefficients of a fit from a time on as text, each with the name of its line,
/// or why there are none.
void add_findings(Language language, double from, const std::vector<Finding>& all,
                  plot::Plot& plot);

}  // namespace carom
