// What the colour of a particle says (speed, energy, direction, mass, species): one scale for the
// whole film, and its key. Knows no places.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/palette.h"
#include "panels/field/color_bar.h"
#include "panels/panel.h"

namespace carom {

/// Names of the colours from slow to fast: the colour maps, and `netlogo`.
std::vector<std::string> palette_names();

/// The colour of a kind in pictures of a scene: where the colours of the gas are a scale, not one
/// of these. Can be called from any thread.
Color kind_in(const Scene& scene, std::size_t index, const Theme& theme);

/// Hatches a disk of infinite mass, as walls are in drawings of machines; small ones stay as they
/// are.
void draw_hatching(Canvas& canvas, const DrawContext& dc, Point center, double radius);

/// The line of a disk that is drawn as a ring, in pixels as its radius and the unit: thinner in a
/// small one, so that its hole is seen. The disk is filled where it has no room for two lines.
double ring_line(double radius, double unit);

class GasColors {
  public:
    static constexpr double least_bar = 7.8;  ///< units, with its title and its last number

    explicit GasColors(const PanelContext& context);

    /// First pass, every frame in order; then fix_scale() fixes the scale.
    void survey(const FrameInput& input);
    void fix_scale();

    /// The scale of speeds, energies or masses: its end is the value that 5 % exceed, of few
    /// particles and of masses the highest.
    const ColorScale& scale() const { return scale_; }

    /// Of two runs that share a scale: adds what another has seen, before fix_scale(); takes what
    /// another has fixed, after it.
    void add_survey(const GasColors& other) {
        pool_.insert(pool_.end(), other.pool_.begin(), other.pool_.end());
    }
    void take_scale(const GasColors& from) { scale_ = from.scale_; }

    /// Writes or reads the scale.
    void archive(Archive& archive);

    /// The motion of a particle, and the mean speed of all.
    struct Motion {
        double speed;
        Eigen::Array2d direction;  ///< of any length; y is 0 on a line
        double mean_speed;
    };

    /// The colour of a particle, as an index into of_shades().
    std::uint16_t shade(Eigen::Index particle, const Motion& motion) const;
    std::vector<Color> of_shades(const Theme& theme) const;

    /// Whether a colour is that of a species, the same at all times.
    static bool is_of_species(std::uint16_t shade);

    /// Whether the scale tells infinite masses from all others, by a shade of their own and
    /// hatching.
    bool tells_infinite() const { return tells_infinite_; }
    bool is_told_infinite(Eigen::Index particle) const;

    /// The height of the key beside that of a field, in pixels, of an area for both.
    double key_height(const DrawContext& dc) const;

    /// Draws the colour bar, or the legend of species, into `page.area`.
    void draw_key(Canvas& canvas, const DrawContext& dc) const;

  private:
    std::vector<Color> make_shades(const Theme& theme) const;
    double value(Eigen::Index particle, double speed) const;
    bool has_own_color(std::size_t species) const;
    bool has_bar() const;
    struct Entry;
    std::vector<Entry> entries(const Theme& theme) const;
    static void draw_swatch(Canvas& canvas, const DrawContext& dc, Point center,
                            const Entry& entry);
    double draw_entries(Canvas& canvas, const DrawContext& dc, double y) const;
    void draw_wheel(Canvas& canvas, const DrawContext& dc) const;

    PanelContext context_;
    bool tells_infinite_;
    bool is_plain_;  ///< over a field the disks of a plane are outlines of one colour, unless their
                     ///< colours mean more than speed
    std::vector<double> pool_;
    int surveyed_ = 0;
    ColorScale scale_;
    std::vector<Color> shades_;  ///< in the film's theme, after fix_scale()
};

}  // namespace carom
