// What the colours of particles show (speed, energy, direction, mass or species): one scale for the
// whole film, and its key. Independent of positions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/palette.h"
#include "panels/field/color_bar.h"
#include "panels/field/key_row.h"
#include "panels/panel.h"

namespace carom {

/// The names of the palettes from slow to fast: the colour maps, and `netlogo`.
std::vector<std::string> palette_names();

/// The colours of the scale of a film's gas, on a theme.
ColorMap scale_colors(const Film& film, const Theme& theme);

/// The default colour of kind number `index` (a species, or a choice of particles) in pictures of a
/// film. If the gas is coloured by a scale, it is none of that scale's colours. May be called from
/// any thread.
Color kind_in(const Film& film, std::size_t index, const Theme& theme);

/// Hatches a disk of infinite mass, as walls are hatched in engineering drawings; small disks are
/// not hatched.
void draw_hatching(Canvas& canvas, const DrawContext& dc, Point center, double radius);

/// The line width of a disk that is drawn as a ring; width, radius and unit are in pixels. It is
/// thinner for a small disk, so that the hole remains visible. A disk without room for two lines is
/// filled.
double ring_line(double radius, double unit);

class GasColors {
  public:
    static constexpr double least_bar = 7.8;  ///< units, with its title and its last number

    explicit GasColors(const PanelContext& context);

    /// First pass, every frame in order; then fix_scale() fixes the scale.
    void survey(const FrameInput& input);
    void fix_scale();

    /// The scale of speeds, energies or masses. It ends at the value that 5 % exceed; for few
    /// particles and for masses, at the highest value.
    const ColorScale& scale() const { return scale_; }

    /// Whether the colours are those of a scale of speeds, energies or masses.
    bool has_bar() const;

    /// For two runs that share a scale: add_survey() adds what another run has shown, before
    /// fix_scale(); take_scale() takes the scale that another run has fixed.
    void add_survey(const GasColors& other) {
        pool_.insert(pool_.end(), other.pool_.begin(), other.pool_.end());
    }
    void take_scale(const GasColors& from) { scale_ = from.scale_; }

    /// Writes or reads the scale.
    void archive(Archive& archive);

    /// The motion of a particle, and the mean speed of all.
    struct Motion {
        double speed;
        Vec direction;  ///< of any length; y is 0 on a line
        double mean_speed;
    };

    /// The colour of a particle, as an index into of_shades(). `membership`: at present; null for
    /// that of the start.
    std::uint16_t shade(Eigen::Index particle, const Motion& motion,
                        const Membership* membership = nullptr) const;
    std::vector<Color> of_shades(const Theme& theme) const;

    /// Whether a colour is that of a species, the same at all times.
    static bool is_of_species(std::uint16_t shade);

    /// Whether infinite masses are distinguished from all others, by a shade of their own and
    /// hatching.
    bool tells_infinite() const { return tells_infinite_; }
    static bool is_of_infinite(std::uint16_t shade);

    /// The height of this key, in pixels, in an area that also holds the key of a field.
    double key_height(const DrawContext& dc, bool has_ramp) const;

    /// Draws the colour bar, or the legend of species, into `page.area`.
    void draw_key(Canvas& canvas, const DrawContext& dc, bool has_ramp) const;

    /// The same in one line.
    void add_key(KeyRow& row, bool has_ramp) const;

  private:
    std::vector<Color> make_shades(const Theme& theme) const;
    double value(Eigen::Index particle, double speed) const;
    bool has_own_color(std::size_t species) const;
    struct Entry;
    std::vector<Entry> entries(const Theme& theme) const;
    static void draw_swatch(Canvas& canvas, const DrawContext& dc, Point center,
                            const Entry& entry);
    double draw_entries(Canvas& canvas, const DrawContext& dc, double y) const;
    void draw_wheel(Canvas& canvas, const DrawContext& dc) const;

    PanelContext context_;
    bool tells_infinite_;
    /// Disks over a field are outlines of one colour, unless their colours show more than speed.
    bool is_plain_;
    std::vector<double> pool_;
    int surveyed_ = 0;
    ColorScale scale_;
    std::vector<Color> shades_;  ///< in the film's theme, after fix_scale()
};

}  // namespace carom
