// A few numbers to be read like instruments: each has a face of its own, with its name and its
// value. The file of each kind of panel defines which numbers; a derived class draws the faces.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "panels/meters/meter.h"
#include "panels/plot/plot.h"
#include "panels/plot/plot_panel.h"
#include "panels/shared_panel.h"
#include "scene/panel_kind.h"

namespace carom {

/// What the faces show: the readings of a meter, each with its name under its face.
struct DialSubject : Meter {
    std::string note = {};              ///< plain words on what the numbers are
    std::string part = {};              ///< in a table: "reading"
    bool counts = false;                ///< whole numbers
    std::optional<double> enough = {};  ///< Panel::enough_height()
};

/// The scale that all faces of a panel share for the whole film.
struct DialScale {
    double low = 0.0, high = 1.0;
    void archive(auto& archive) { archive(low, high); }

    /// The position of a value on the scale, from 0 to 1; values beyond the ends are clamped.
    double share(double value) const;
};

/// Returns a scale that holds nearly all of some numbers: from 0, or symmetric about 0 if any is
/// negative. NaN is ignored.
DialScale scale_of_readings(const std::vector<std::vector<double>>& lines);

class DialPanel : public RecordPanel<HistoryRecord, SharedPanel> {
  public:
    DialPanel(const PanelContext& context, const PanelSpec& spec, DialSubject subject);

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::both; }
    bool surveys_collisions() const override { return reader_.meter().needs_collisions; }
    void archive(Archive& archive) override { archive_record(archive); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override { archive(seen_, said_); }
    std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    std::optional<double> enough_height() const override { return subject_.enough; }
    Room least_room() const override { return {6.0, 5.0}; }
    void draw_ground(Canvas& canvas, const DrawContext& dc) const final;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const final;
    Table table(const PanelState& state, const Theme& theme) const override;
    std::string account(const PanelState& state) const override;
    std::vector<std::string> accounts_of_runs(const PanelState& state) const override;

    /// One of the numbers in a state.
    struct Reading {
        MeterLine line;
        double value = 0.0;                ///< of this frame; NaN: none
        double said = 0.0;                 ///< as written in the text, which changes less often
        std::optional<double> error = {};  ///< standard error of a mean over runs; NaN: unknown
    };
    std::vector<Reading> readings(const PanelState& state) const;

    /// A number as text, with the decimals that the film's numbers need and, for a mean, its
    /// standard error; a dash if there is no number.
    std::string number(double value, const std::optional<double>& error) const;

  protected:
    void make_axes() override;

    /// The width of a face: `units` units, plus `heights` times its height.
    struct Width {
        double units = 0.0, heights = 1.0;
    };
    virtual Width width() const = 0;

    /// The least height of a face, in units. If there is less room, the text stands without a face.
    virtual double least_face() const { return 0.0; }

    /// Whether the panel writes the number and the name beside or under the face; otherwise the
    /// derived class draws them.
    virtual bool has_words() const { return true; }

    /// Draw the part of a face that is the same in every frame, and the part that changes.
    virtual void draw_face(Canvas& canvas, const DrawContext& dc, const Rect& face,
                           const MeterLine& line) const = 0;
    virtual void draw_value(Canvas& canvas, const DrawContext& dc, const Rect& face,
                            const Reading& reading) const = 0;

    const PanelContext& context() const { return context_; }
    const DialScale& scale() const { return scale_; }

    /// The scale in the numbers that are written: without a power of ten that they have in common,
    /// which the title names.
    DialScale written_scale() const;

    /// The range of one standard error to either side of a mean, as shares of the scale; none for a
    /// single run and if the error is not known.
    std::optional<std::array<double, 2>> error_band(const Reading& reading) const;

    /// The width of the widest number of all frames as text, in pixels.
    double widest_number(const TextStyle& style) const;

    std::vector<MeterLine> lines() const;

  private:
    struct Layout;
    bool is_whole() const;
    int power() const;
    std::string written(double value, const std::optional<double>& error, int power) const;
    Layout layout(const DrawContext& dc) const;
    Layout layout_in_grid(const DrawContext& dc, const Rect& area) const;
    void draw_words(Canvas& canvas, const DrawContext& dc, const Layout& layout) const;
    bool has_room_for(const Rect& face, const DrawContext& dc) const {
        return face.height >= least_face() * dc.unit;
    }
    std::string note() const;
    std::string account_of(const std::vector<Reading>& readings) const;

    PanelContext context_;
    DialSubject subject_;  ///< what it reads is read by:
    MeterReader reader_;
    DialScale scale_;
    std::size_t seen_ = 0, said_ = 0;
};

/// Returns a kind of panel that shows the readings of a meter on faces, with what makes its panels,
/// of the class `Face`, and its meter. `subject(context, spec)` gives a DialSubject.
template <class Face, auto subject>
PanelKind dial_kind(PanelKind kind) {
    kind.meter = meter_of<subject>;
    kind.make = [](const PanelContext& context, const PanelSpec& spec) -> std::unique_ptr<Panel> {
        return std::make_unique<Face>(context, spec, subject(context, spec));
    };
    return kind;
}

}  // namespace carom
