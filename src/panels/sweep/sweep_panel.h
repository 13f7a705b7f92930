// A number of many runs against the varied parameter: the mean at each value with its standard
// error, and the prediction of theory. Runs nothing itself: the caller supplies the numbers of the
// runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "panels/plot/plot_panel.h"

namespace carom {

/// A curve that is known without runs.
struct SweptCurve {
    std::string name = {};  ///< its source: "hard disks by Kolafa and Rottner"
    std::vector<double> x = {}, y = {};
};

/// The points of one line.
struct SweptLine {
    std::string name = {};    ///< in the film's language; empty: the only one
    std::string column = {};  ///< the same in a table, in English
    std::vector<double> x = {}, mean = {}, error = {};
    std::vector<std::int64_t> runs = {};  ///< of each point: how many have the number
    SweptCurve theory = {};               ///< without values if none is known
    SweptCurve coexistence = {};          ///< of spheres, where fluid and crystal are side by side
    SweptCurve crystal = {};              ///< and where they are a crystal
    SweptCurve ideal = {};                ///< of an ideal gas
};

/// What a panel of a sweep shows.
struct SweptNumbers {
    Heading number;       ///< of the vertical axis
    std::string across;   ///< title of the horizontal axis, in the film's language
    Heading column = {};  ///< the same in a table, in English
    std::vector<SweptLine> lines = {};
};

class SweepPanel : public PlotPanel {
  public:
    SweepPanel(const PanelContext& context, const PanelSpec& spec)
        : language_(context.language()), title_(spec.title) {}

    /// Sets what the panel shows from now on; before, it is empty.
    void show(const SweptNumbers& numbers);

    void archive(Archive&) override {}
    std::shared_ptr<const PanelState> state(const FrameInput&) override { return state(); }
    std::shared_ptr<const PanelState> state() const { return std::make_shared<PanelState>(); }
    void archive_progress(Archive&) override {}
    plot::Plot plot(const PanelState*) const override { return plot_; }

  private:
    void add_line(const SweptNumbers& numbers, std::size_t k);
    void add_curve(const SweptCurve& curve, const plot::Stroke& stroke, const std::string& line);
    void add_curves(const SweptLine& line, std::size_t k, std::size_t lines);
    void set_axes(const SweptNumbers& numbers);
    void set_words(const SweptNumbers& numbers);
    void set_words_of_lines(const SweptNumbers& numbers);
    plot::Dot dot_of(std::size_t line, std::size_t lines) const;
    plot::Role role_of(std::size_t line, std::size_t lines) const;

    Language language_;
    std::optional<std::string> title_;
    plot::Plot plot_;
};

}  // namespace carom
