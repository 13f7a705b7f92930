// Numbers in fixed places: time, collisions, mean speed, mean energy, shares of slow, medium and
// fast, or some of these; a row under the gas, or as large as a panel.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "panels/echo/echo_record.h"
#include "panels/panel.h"

namespace carom {

class MonitorsPanel : public Panel {
  public:
    /// No numbers stand for all of them.
    MonitorsPanel(const PanelContext& context, std::vector<Monitor> numbers,
                  std::optional<std::string> title = {});

    void survey(const FrameInput& input) override;
    bool wants_return_distances() const override { return echo_.has_value(); }
    void archive(Archive& archive) override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;
    bool shows_time() const override;
    std::optional<double> enough_height() const override;

  private:
    struct Row;
    Row row(const DrawContext& dc) const;
    Row row_of(const Rect& area, double unit, std::size_t count) const;
    Point place(const Row& row, std::size_t index) const;  ///< its top left corner
    void draw_slowness(Canvas& canvas, const DrawContext& dc, const Row& rows,
                       const PanelState& state) const;
    std::string text(const PanelState& state, Monitor number) const;
    double width(Monitor number, double unit) const;  ///< of its column
    double widest_time(double unit) const;
    double column_width(double unit) const;

    PanelContext context_;
    std::vector<Monitor> numbers_;
    std::optional<std::string> title_;
    double largest_speed_ = 0.0;  ///< of the mean over the film: fixes the number of decimals
    double largest_energy_ = 0.0;
    double smallest_speed_ = std::numeric_limits<double>::infinity();
    double smallest_energy_ = std::numeric_limits<double>::infinity();
    std::optional<EchoRecord> echo_;  ///< if its number is shown
};

}  // namespace carom
