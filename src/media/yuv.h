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
    std::uint8_t* alpha = nullptr;        ///< of the size of luma, for frames that are not opaque
    int alpha_stride = 0;
};

/// The next even number: sizes of 4:2:0 pictures.
constexpr int even_size(int size) { return size + size % 2; }

/// Converts all of `frame` into planes of even_size() of its size; an odd last row or column is
/// repeated. Luma is the nearest integer to ITU-R BT.709-6 (items 3.2 to 3.5), chroma is that of
/// the pixels filtered 1-2-1 about the left luma column and averaged over two rows (the siting of
/// H.264, chroma_sample_loc_type 0). Integer arithmetic: the same bytes on every machine.
void to_yuv420(const PixelView& frame, const YuvPlanes& planes);

/// The same bytes, where `planes` hold a picture that differs from `frame` in no pixel but those in
/// `changed`: only what these boxes touch is converted.
void to_yuv420(const PixelView& frame, std::span<const PixelBounds> changed,
               const YuvPlanes& planes);

/// The same of a frame with alpha, full range in a plane of its own. Colours are those before they
/// were multiplied by alpha, so that edges have no fringes on any ground; where nothing is drawn
/// they are `behind` (0xffRRGGBB).
void to_yuva420(const PixelView& frame, std::uint32_t behind, const YuvPlanes& planes);

}  // namespace carom
