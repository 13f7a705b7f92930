// An instrument: what reads numbers of a run at every moment, and what these numbers are. Plots
// against time, dials, figures, and the numbers that are listed of a run show the same readings.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "panels/means/running_mean.h"
#include "panels/meters/history.h"
#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "physics/units/quantity.h"

namespace carom {

/// One of the numbers that a meter reads: a line of a plot, or the reading of a dial.
struct MeterLine {
    std::string column;     ///< in a table, in English
    std::string name = {};  ///< plain words; empty: none is needed
    plot::Role role = {.of = plot::Role::Of::bar};
    bool is_theory = false;  ///< what theory expects at the moment; it has no name
};

/// Numbers that a meter finds of each of its lines besides their readings, such as a diffusion
/// coefficient.
struct MeterResults {
    std::vector<Quantity> of = {};  ///< each with its word
    /// These of each line, at present; NaN where the gas has none.
    std::function<std::vector<std::vector<MeanError>>()> find = {};
};

struct Meter {
    std::string title = {};  ///< plain words: "Temperature"
    Quantity quantity = {};  ///< of all lines, with its word
    std::vector<MeterLine> lines = {};
    /// Takes every sample and every frame of the run, in order of time. Empty: only read() does.
    std::function<void(const FrameInput&)> follow = {};
    /// Reads a number for each line; NaN: none. Called at the same moments, after follow(). Empty:
    /// it reads none, and gives results only.
    std::function<std::vector<double>(const FrameInput&)> read = {};
    std::optional<Over> over =
        {};  ///< the time over which readings are averaged; none: they are not
    bool reads_means_since_start = false;  ///< by itself, without `over`
    bool needs_collisions = false;         ///< to read
    bool needs_positions = true;           ///< to read
    MeterResults results = {};

    // Known after the run:
    std::function<ReferenceLevels()> levels = {};
    std::function<std::vector<std::vector<MeanError>>()> numbers = {};  ///< further ones, by line
    std::function<std::vector<LineLaw>()> laws = {};                    ///< of each line
};

/// Reads a meter in the course of a run.
class MeterReader {
  public:
    explicit MeterReader(Meter meter)
        : meter_(std::move(meter)), mean_(meter_.over.value_or(Over{})) {}

    /// The readings of the next moment, averaged over the time that the meter says; empty if the
    /// meter reads none.
    std::vector<double> operator()(const FrameInput& input) {
        if (meter_.follow) meter_.follow(input);
        if (!meter_.read) return {};
        return mean_(input.tick.time, meter_.read(input), input.is_sample);
    }

    /// Whether the readings are averages.
    bool averages() const { return meter_.over && meter_.over->since != Over::Since::now; }

    /// Whether they are averages since time 0.
    bool averages_since_start() const {
        return meter_.reads_means_since_start ||
               (meter_.over && meter_.over->since == Over::Since::start);
    }

    const Meter& meter() const { return meter_; }

  private:
    Meter meter_;
    RunningMean mean_;
};

/// A meter with a line for each choice of particles that the panel shows. The caller adds what is
/// read for each.
Meter meter_of_choices(const PanelContext& context, const PanelSpec& spec, Phrase title,
                       const Quantity& quantity);

/// PanelKind::meter of a kind whose subject is a Meter, or is made of one.
template <auto subject>
Meter meter_of(const PanelContext& context, const PanelSpec& spec) {
    return subject(context, spec);
}

}  // namespace carom
