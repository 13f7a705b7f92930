// The coverage of the pixels of a grid by a single disk, in rows ready to be blended four pixels at
// a time. Computed with integers and correctly rounded square roots: the same on every machine.
// Draws nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom {

/// A disk with its centre rounded to 1/16 of a pixel and its radius to 1/256 (an error of 1/512 at
/// most, which is half a step of an 8-bit coverage).
struct DiskShape {
    static constexpr int phases = 16;
    static constexpr int radius_steps = 256;
    int phase_x = 0, phase_y = 0;  ///< of the centre, right of and below its pixel's corner
    int radius = 1;                ///< in 1/radius_steps of a pixel, positive
};

/// One row of pixels, from `left` on: groups of four pixels with individual coverages, then a run
/// of `full` pixels, then groups again.
struct MaskRow {
    std::int16_t left = 0;
    std::uint16_t left_groups = 0, full = 0, right_groups = 0;
};

constexpr int group_size = 4;

/// The position of a disk's rows in a MaskStore, and the smallest box that holds their groups;
/// `left` and `top` count from the pixel that contains the centre.
struct DiskMask {
    int left = 0, top = 0, width = 0, height = 0;
    std::size_t first_row = 0, first_coverage = 0;
};

/// Stores masks one after another in two arrays, so that dropping the last ones costs nothing.
class MaskStore {
  public:
    /// Adds the mask of a disk.
    DiskMask add(const DiskShape& shape);

    /// Drops `mask` and all masks added after it.
    void truncate_to(const DiskMask& mask);

    const MaskRow* rows(const DiskMask& mask) const { return rows_.data() + mask.first_row; }

    /// The coverages, in 1/255, of the groups of all rows, row by row.
    const std::uint8_t* coverages(const DiskMask& mask) const {
        return coverages_.data() + mask.first_coverage;
    }

    std::size_t bytes() const { return rows_.size() * sizeof(MaskRow) + coverages_.size(); }

  private:
    void find_changes(int width, std::uint32_t middle, int first_line);
    void sum_changes(int width);
    void add_row(int left, int width, bool is_whole);
    void append(int first, int groups);

    std::vector<MaskRow> rows_;
    std::vector<std::uint8_t> coverages_;
    std::vector<std::uint32_t>
        half_chords_;                    ///< of the disk being added, from its equator to a pole
    std::vector<std::int32_t> changes_;  ///< of coverage from one pixel to the next, in one row
    std::vector<std::uint8_t> row_;      ///< coverages of one row, and a group of zeros
};

}  // namespace carom
