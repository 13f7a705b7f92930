// Numbers at fixed places: time, collisions, mean speed and mean energy, or those that the scene
// asks for; in a row under the gas, or filling a panel.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/echo/echo_record.h"
#include "panels/panel.h"
#include "scene/words.h"
#include "util/archive.h"

namespace carom {

struct MonitorOptions {
    std::vector<Monitor> numbers = {};  ///< those shown; none: usual
};

/// The numbers that are asked for; if there are none, those that apply to any gas.
std::vector<Monitor> or_usual(const std::vector<Monitor>& asked);

using MonitorNumbers = std::array<double, enum_words<Monitor>.size()>;

inline std::size_t index_of(Monitor number) { return static_cast<std::size_t>(number); }

/// The numbers at a moment; the distance of a return, which takes the whole run, is none.
MonitorNumbers monitor_numbers(const PanelContext& context, const FrameInput& input);

/// What a number is, with its label.
const Quantity& quantity_of(Monitor number);

struct MonitorsState : PanelState {
    MonitorNumbers readouts{};  // the numbers that are shown
    MonitorNumbers numbers{};   // a distance as its decimal logarithm, or none
    double return_distance =
        std::numeric_limits<double>::quiet_NaN();  // the same as a double, which may be 0
    Slowness slow;
    double arrow = 0.0;  // direction of the clock's arrow: 0 forward, 1 back
};

/// Draws a triangle that points along the direction of time: `turn` from 0 (right) to 1 (left);
/// `size` from its middle to its ends.
void draw_time_arrow(Canvas& canvas, Point center, double size, double turn, Color color);

class MonitorsPanel : public Panel {
  public:
    /// Shows these numbers, or the usual ones.
    MonitorsPanel(const PanelContext& context, const std::vector<Monitor>& numbers,
                  const std::optional<std::string>& title = {});

    void survey(const FrameInput& input) override;
    bool surveys_positions() const override { return echo_.has_value(); }
    bool wants_return_distances() const override { return echo_.has_value(); }
    void archive(Archive& archive) override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override { archive(readouts_); }
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;
    bool shows_time() const override;
    std::optional<double> enough_height() const override;
    std::vector<std::string> left_out(const DrawContext& dc) const override;

    /// Makes room for the numbers of a gas at its start, before any survey.
    void expect(const Eigen::ArrayXd& speed, const Eigen::ArrayXd& energy);

    /// Gives the numbers of all these panels the same digits and places.
    static void share_ranges(const std::vector<MonitorsPanel*>& panels);

  protected:
    // The names of the numbers that the scene lists, from index `shown` on.
    std::vector<std::string> names_after(std::size_t shown) const;
    std::string text(Monitor number, double value) const;
    double widest_value(Monitor number) const;
    TextStyle style_of_numbers(double size, int weight) const;  // without a colour
    std::string label(Monitor number) const;                    // markup
    // A number that has no meaning all the time is not always there, nor is its name.
    static bool comes_and_goes(Monitor number) { return number == Monitor::return_distance; }
    static bool is_absent(Monitor number, double value) {
        return comes_and_goes(number) && std::isnan(value);
    }
    bool turns() const;  // velocities are reversed in the run

    PanelContext context_;
    bool are_asked_;  // the numbers are listed in the scene; otherwise they are the default ones
    std::vector<Monitor> numbers_;
    MonitorNumbers largest_{}, smallest_;  // in the film; they determine the number of decimals

  private:
    struct Row;
    Row row(const DrawContext& dc) const;
    Row row_of(const Rect& area, double unit, std::size_t count) const;
    Point place(const Row& row, std::size_t index) const;  // its top left corner
    void draw_label(Canvas& canvas, const DrawContext& dc, const Row& rows,
                    std::size_t index) const;
    Point place_of_arrow(const DrawContext& dc, const Row& rows, const Point& at) const;
    void draw_slowness(Canvas& canvas, const DrawContext& dc, const Row& rows,
                       const Slowness& slow) const;
    double width(Monitor number, double unit) const;  // of its column
    double width_for_label(Monitor number, double unit) const;
    double widest_time(double unit) const;
    double column_width(double unit) const;

    std::optional<std::string> title_;
    std::optional<EchoRecord> echo_;  // if its number is shown
    std::optional<MonitorNumbers> readouts_;
};

}  // namespace carom
