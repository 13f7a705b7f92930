// How far the gas is from where it was, on its way home after a reversal: the largest distance and
// the root of the mean square, over powers of ten, against the time or the collisions since the
// reversal, with the law by which such distances grow. Of several runs side by side the largest.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "panels/echo/echo_record.h"
#include "panels/panel.h"

namespace carom {

class ReturnDistancePanel : public Panel {
  public:
    ReturnDistancePanel(const PanelContext& context, const PanelSpec& spec);

    void survey(const FrameInput& input) override { echo_.survey(input); }
    bool wants_return_distances() const override { return true; }
    void fix_axes() override;
    void settle_beside(const std::vector<Panel*>& others,
                       const std::vector<std::string>& names) override;
    std::shared_ptr<const PanelState> beside(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    std::vector<std::string> told_of_runs(const PanelState& state) const override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;
    std::string finding(const PanelState& state) const override;
    std::string account(const PanelState& state) const override;

  private:
    enum class Line { largest, root_mean_square };
    static const char* name_of(Line line);
    static double value_of(const EchoRecord::Step& step, Line line);
    static double log_of(const EchoRecord::Step& step, Line line);

    using Steps = std::span<const EchoRecord::Step>;
    struct Scales;
    /// How a line is drawn.
    struct Look {
        Color color;
        std::vector<double> dashes;
    };
    /// A place on the growth law.
    struct LawPoint {
        EchoRecord::Step step;
        double along, log10_distance;
    };

    bool compares() const { return !names_.empty(); }
    std::vector<Line> lines() const;
    double along(const EchoRecord::Step& step) const;
    double radius() const;
    Steps way_back(const ReturnDistancePanel& run, std::size_t reversal) const;
    std::vector<LawPoint> law(const ReturnDistancePanel& run, std::size_t reversal) const;
    bool has_law() const;
    void choose_axes();
    std::string told_of(const ReturnDistancePanel& run, std::size_t shown) const;

    Scales scales(const DrawContext& dc) const;
    Look look(Line line, std::size_t run, const DrawContext& dc) const;
    std::vector<std::string> titles() const;
    std::string along_words(const DrawContext& dc) const;
    void draw_note(Canvas& canvas, const DrawContext& dc) const;
    void draw_floor(Canvas& canvas, const DrawContext& dc) const;
    double level_baseline(const DrawContext& dc) const;
    bool is_crossed(const Rect& part, const DrawContext& dc) const;
    void draw_level(Canvas& canvas, const DrawContext& dc) const;
    void draw_home(Canvas& canvas, const DrawContext& dc) const;
    void draw_law(Canvas& canvas, const DrawContext& dc, const ReturnDistancePanel& run,
                  std::size_t reversal) const;
    void draw_start(Canvas& canvas, const DrawContext& dc) const;
    void draw_run(Canvas& canvas, const DrawContext& dc, std::size_t run, std::size_t shown) const;
    void draw_way(Canvas& canvas, const DrawContext& dc, Steps steps, Line line, const Look& look,
                  bool is_present) const;
    Table table_of(const ReturnDistancePanel& run, std::size_t shown) const;

    PanelContext context_;
    PanelSpec spec_;
    EchoRecord echo_;
    std::vector<const ReturnDistancePanel*> runs_{this};  // this one, then those beside it
    std::vector<std::string> names_;                      // of runs side by side; or none
    double low_ = -16.0, high_ = 0.0;                     // powers of ten
    double last_ = 1.0;                                   // of the horizontal axis
};

}  // namespace carom
