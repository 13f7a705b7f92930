// Instruments that are read in the course of a run without being drawn: their numbers, by name, and
// what they read last.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "panels/meters/meter.h"

namespace carom {

/// One of the numbers of a run.
struct RunNumber {
    std::string name;  ///< "virial pressure"
    Quantity quantity;
    bool operator==(const RunNumber&) const = default;
};

/// What an instrument reads at the end of a run, or at a moment of it.
struct LastReading {
    RunNumber number;
    double value = 0.0;                                       ///< NaN: none
    double error = std::numeric_limits<double>::quiet_NaN();  ///< standard error; NaN: unknown
};

/// Not safe to use from several threads.
class Instruments {
  public:
    /// Instruments of these kinds of panels (PanelKind::meter) and options. What the context refers
    /// to, and the specs, must outlive the object.
    Instruments(const PanelContext& context, std::span<const PanelSpec> specs);

    bool need_collisions() const;

    /// Takes the next moment of the run, with the collisions since the moment before.
    void see(const FrameInput& input);

    /// The numbers of each instrument, in the order of the specs: the readings of its lines,
    /// without what theory expects, and its results.
    std::vector<std::vector<RunNumber>> numbers() const;

    /// What all of them say after the last moment, in the same order.
    std::vector<LastReading> readings() const;

    /// What the instrument of one of the specs says after the last moment of the line of this
    /// column: its reading, or its result. Without a column, of the first line that has a number.
    /// NaN if there is none.
    double value(std::size_t instrument, const std::string& column, bool is_result) const;

    /// What that number is.
    const Quantity& quantity(std::size_t instrument, bool is_result) const;

  private:
    struct Instrument {
        const PanelSpec* spec;
        MeterReader reader;
        std::vector<double> last = {};
    };
    static std::vector<RunNumber> numbers_of(const Instrument& instrument);
    static std::vector<MeanError> values_of(const Instrument& instrument);

    std::vector<Instrument> instruments_;
};

}  // namespace carom
