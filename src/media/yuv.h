// Conversion of drawn pixels to planar 4:2:0 for the encoder: BT.709, limited range, left-sited
// chroma. Owns the arithmetic only; buffers belong to the caller.
#pragma once

#include <cstdint>
#include <span>

#include "draw/canvas.h"

namespace carom {

/// Three planes of bytes: luma of `width` x `height` (both even), chroma of half of each.
struct YuvPlanes {
    std::uint8_t* y = nullptr;
    std::uint8_t* cb = nullptr;
    std::uint8_t* cr = nullptr;
    int y_stride = 0, chroma_stride = 0;  ///< bytes from one row to the next
    std::uint8_t* alpha = nullptr;        ///< as large as luma; for frames that are not opaque
    int alpha_stride = 0;
};

/// Rounds a size up to an even number, as 4:2:0 pictures require.
constexpr int even_size(int size) { return size + size % 2; }

/// Converts all of `frame` into planes of even_size() of its size; an odd last row or column is
/// repeated. Luma is the nearest integer to ITU-R BT.709-6 (items 3.2 to 3.5), chroma is that of
/// the pixels filtered 1-2-1 about the left luma column and averaged over two rows (the siting of
/// H.264, chroma_sample_loc_type 0). Integer arithmetic: the same bytes on every machine.
void to_yuv420(const PixelView& frame, const YuvPlanes& planes);

/// Gives the same bytes if `planes` hold a picture that differs from `frame` only in the pixels of
/// the boxes `changed`: only what these boxes touch is converted.
void to_yuv420(const PixelView& frame, std::span<const PixelBounds> changed,
               const YuvPlanes& planes);

/// The same conversion for a frame with alpha, which goes to its own plane in full range. Colours
/// are taken before multiplication by alpha, so that edges have no fringes on any background; where
/// nothing is drawn they are `behind` (0xffRRGGBB).
void to_yuva420(const PixelView& frame, std::uint32_t behind, const YuvPlanes& planes);

}  // namespace carom
