// Density, temperature, mean speed or flow along an axis of the box: means over slabs perpendicular
// to it, from exact residence times. A profile along y has the height as its vertical axis, as in
// the box. If a barometric law holds for an ideal gas, it is drawn with the density. Measured in
// profile.cpp, drawn in profile_plot.cpp.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/chosen.h"
#include "panels/field/field_layer.h"
#include "panels/means/runs_record.h"
#include "panels/plot/plot_panel.h"
#include "panels/plot/window.h"
#include "stats/cell_averages.h"
#include "stats/means/measured.h"

namespace carom {

struct ProfileOptions {
    FieldOf quantity = FieldOf::density;
    std::optional<int> cells = {};   ///< none: usual
    std::optional<Vec> around = {};  ///< of distances from this point
    bool front = false;              ///< marks the front of these distances
};

struct ProfileState : PanelState {
    std::vector<Measured> runs;  // one, or the compared runs; a line of each choice, between the
                                 // edges of slabs; NaN: too few particles, or unknown errors
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const Measured& run : runs) sum += run.bytes();
        return sum;
    }
};

// What the first pass of a run has shown.
struct ProfileRun {
    std::string name = {};  // among compared runs
    double length = 1.0;    // of the axis
    double most = 0.0;
    Measured laws = {};       // a line of each choice, in each slab; or none
    bool has_errors = false;  // known at most samples with a full window
    void archive(Archive& archive) { archive(name, length, most, laws, has_errors); }
};

struct ProfileRecord : RunsRecord<ProfileRun> {
    bool has_errors() const { return !compares() && (runs_in_mean > 1 || runs.front().has_errors); }
};

ProfileRecord mean_of(const std::vector<ProfileRecord>& records);

class ProfilePanel : public RecordPanel<ProfileRecord> {
  public:
    ProfilePanel(const PanelContext& context, const PanelSpec& spec);

    void survey(const FrameInput& input) override;
    SurveyedAt surveyed_at() const override { return SurveyedAt::samples; }
    std::optional<std::array<double, 2>> time_shown(double at) const override;
    bool surveys_collisions() const override { return window_of(over_) != 0.0; }
    bool wants_collisions() const override { return surveys_collisions(); }
    void archive(Archive& archive) override { archive_record(archive); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override {
        for (CellQuantity& one : shown_) archive(one);
    }
    std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const override;
    plot::Plot plot(const PanelState* state) const override;

  protected:
    void finish_record() override;
    void make_axes() override;
    void take_axes(const RecordPanel& of) override { take_record(of); }

  private:
    void add_laws();
    bool is_changed_in_window(double until) const;
    std::optional<Eigen::ArrayXd> errors_of(const CellQuantity& quantity, double time) const;
    const ProfileOptions& options() const { return spec_.options.as<ProfileOptions>(); }
    bool is_up() const { return axis_ == 1; }
    // A slab without particles has a density, 0, but no temperature.
    Eigen::ArrayXd values_of(const CellQuantity& quantity) const {
        return quantity.values(axis_, options().quantity == FieldOf::density ? 0.0 : least_in_cell);
    }
    plot::Polyline curve(std::size_t run, std::size_t choice, const char* part,
                         std::vector<double> along, std::vector<double> up) const;
    plot::Polyline line_of(const Measured& its, std::size_t run, std::size_t choice) const;
    plot::Polyline law_of(std::size_t run, std::size_t choice) const;
    plot::Band band_of(const plot::Polyline& line, const Measured& its, std::size_t choice) const;
    plot::Column column_of_errors(const Measured& its, std::size_t choice) const;
    std::string account_of(const std::vector<double>& of_slabs, std::size_t choice) const;
    plot::Stroke stroke_of_law() const;
    std::vector<plot::Text> titles() const;
    plot::Note note() const;

    PanelContext context_;
    PanelSpec spec_;
    int axis_;
    Cells cells_;
    Over over_;
    std::vector<Chosen> choices_;
    std::vector<CellQuantity> surveyed_, shown_;
    std::vector<double> pool_;
    int frames_seen_ = 0, full_windows_ = 0, known_errors_ = 0;
    plot::Plot whole_;
};

}  // namespace carom
