// The line with its beads, and below it their recent world lines. The main picture of a film in one
// dimension.
#pragma once

#include <optional>
#include <vector>

#include "panels/gas/particle_panel.h"
#include "panels/line/line_ends.h"
#include "panels/line/line_map.h"
#include "panels/line/world_lines.h"

namespace carom {

class LinePanel : public ParticlePanel {
  public:
    explicit LinePanel(const PanelContext& context, const std::optional<View>& view = {})
        : ParticlePanel(context, {view, {}}), ends_(context) {}

    void survey(const FrameInput& input) override;
    void fix_axes() override;
    void archive(Archive& archive) override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;
    bool wants_collisions() const override { return true; }

    /// Describes the ends, unless they only reflect.
    std::string account(const PanelState& state) const override;

    /// For tests: the simulated time that the world lines show.
    double memory() const { return memory_; }

  private:
    struct View;
    struct Drawing;
    struct Bends {
        double time;
        double count;  // bends of all world lines since the start
    };
    struct State : ParticleState {
        double time = 0.0;
        std::vector<std::vector<WorldLines::Bend>> lines;  // oldest bend first, the present last;
                                                           // empty of a bead that is absent
        std::vector<double> reversals;                     // simulated times in memory
        std::vector<LineEnds::End> ends;                   // empty if they only reflect
        std::size_t bytes() const override {
            std::size_t sum = ParticleState::bytes();
            for (const auto& line : lines) sum += line.size() * sizeof(WorldLines::Bend);
            for (const LineEnds::End& end : ends) sum += end.path.size() * sizeof(Point);
            return sum;
        }
    };

    double drawn_length() const;
    View whole_view(const DrawContext& dc) const;
    View part_of(const View& whole, const CameraView& seen, const DrawContext& dc) const;
    View view(const DrawContext& dc, const State& state) const;
    double scale_in(const DrawContext& own) const override;
    void share_span(const std::vector<ParticlePanel*>& others) override;
    void survey_places(const FrameInput& input);
    double usual_rate() const;  // bends of one world line in a unit of time
    bool is_ring() const { return context_.box().is_periodic(0); }
    Labels shown_labels() const;

    LineEnds ends_;
    std::optional<LineMap> map_;  // from the first frame on
    std::vector<Bends> bends_;    // at each frame of the first pass
    double memory_ = 1.0;
    std::optional<WorldLines> lines_;               // after fix_axes()
    Eigen::ArrayXd surveyed_places_, last_places_;  ///< of the frame before, in each pass
};

}  // namespace carom
