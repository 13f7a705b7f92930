#include "media/yuv.h"

#include <doctest/doctest.h>

extern "C" {
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "util/random.h"

using namespace carom;

namespace {

struct Picture {
    int width, height, stride;
    std::vector<std::uint32_t> pixels;

    Picture(int w, int h, int padding = 0)
        : width(w),
          height(h),
          stride(w + padding),
          pixels(static_cast<std::size_t>(stride) * static_cast<std::size_t>(h), 0xff000000u) {}
    PixelView view() { return {pixels.data(), width, height, stride}; }
    std::uint32_t& at(int x, int y) { return pixels[static_cast<std::size_t>(y * stride + x)]; }
    /// Outside, the nearest pixel inside.
    std::array<double, 3> rgb(int x, int y) {
        const std::uint32_t p = at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
        return {double((p >> 16) & 255), double((p >> 8) & 255), double(p & 255)};
    }
};

struct Converted {
    int width, height;
    std::vector<std::uint8_t> y, cb, cr;
    int luma(int column, int row) const { return y[std::size_t(row * width + column)]; }
    int blue(int column, int row) const { return cb[std::size_t(row * width / 2 + column)]; }
    int red(int column, int row) const { return cr[std::size_t(row * width / 2 + column)]; }
    bool operator==(const Converted&) const = default;
};

Converted empty_planes(const Picture& picture) {
    const int width = even_size(picture.width), height = even_size(picture.height);
    const auto luma = std::size_t(width * height);
    return {width, height, std::vector<std::uint8_t>(luma), std::vector<std::uint8_t>(luma / 4),
            std::vector<std::uint8_t>(luma / 4)};
}

Converted convert(Picture& picture) {
    Converted out = empty_planes(picture);
    to_yuv420(picture.view(),
              {out.y.data(), out.cb.data(), out.cr.data(), out.width, out.width / 2});
    return out;
}

Picture noise(int width, int height, int padding = 0) {
    Picture picture(width, height, padding);
    Random random(7, "noise");
    for (std::uint32_t& pixel : picture.pixels)
        pixel = 0xff000000u | static_cast<std::uint32_t>(random.below(1 << 24));
    return picture;
}

// The formulas of BT.709-6, items 3.2 to 3.5, in the order in which they stand there.
std::array<double, 3> bt709(const std::array<double, 3>& rgb) {
    const double r = rgb[0] / 255, g = rgb[1] / 255, b = rgb[2] / 255;
    const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    return {219 * y + 16, 224 * (b - y) / 1.8556 + 128, 224 * (r - y) / 1.5748 + 128};
}

// Weights 1-2-1 about the left column of a pair, both rows alike.
std::array<double, 3> filtered(Picture& picture, int column, int row) {
    std::array<double, 3> sum = {};
    for (int dy = 0; dy < 2; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += (dx == 0 ? 2 : 1) / 8.0 * picture.rgb(2 * column + dx, 2 * row + dy)[k];
    return sum;
}

}  // namespace

TEST_CASE("every byte is the nearest to BT.709 in double precision") {
    // Rounding to the nearest errs by at most 0.5; the fixed-point weights add less than 1e-4.
    const double tolerance = 0.5 + 1e-4;
    for (const auto& size : {std::pair{1, 1},
                             {2, 2},
                             {3, 5},
                             {31, 2},
                             {32, 3},
                             {33, 4},
                             {37, 21},
                             {64, 48},
                             {65, 3},
                             {319, 17},
                             {1921, 9}}) {
        const int width = size.first, height = size.second;
        CAPTURE(width);
        CAPTURE(height);
        Picture picture = noise(width, height, 5);
        const Converted out = convert(picture);
        double luma_error = 0, chroma_error = 0;
        for (int y = 0; y < out.height; ++y)
            for (int x = 0; x < out.width; ++x)
                luma_error =
                    std::max(luma_error, std::abs(out.luma(x, y) - bt709(picture.rgb(x, y))[0]));
        for (int y = 0; y < out.height / 2; ++y)
            for (int x = 0; x < out.width / 2; ++x) {
                const auto exact = bt709(filtered(picture, x, y));
                chroma_error = std::max({chroma_error, std::abs(out.blue(x, y) - exact[1]),
                                         std::abs(out.red(x, y) - exact[2])});
            }
        CHECK(luma_error <= tolerance);
        CHECK(chroma_error <= tolerance);
    }
}

TEST_CASE("planes may have longer rows than the picture, whose rest stays as it was") {
    for (const int width : {6, 32, 95}) {
        CAPTURE(width);
        Picture picture = noise(width, 7, 3);
        const Converted tight = convert(picture);
        const auto w = std::size_t(tight.width), h = std::size_t(tight.height),
                   rest = std::size_t{9};
        std::vector<std::uint8_t> y((w + rest) * h, 77), cb((w / 2 + rest) * h / 2, 77), cr = cb;
        to_yuv420(picture.view(),
                  {y.data(), cb.data(), cr.data(), int(w + rest), int(w / 2 + rest)});
        const auto rows_agree = [&](const auto& rows, const auto& expected, std::size_t length) {
            for (std::size_t k = 0; k < rows.size(); ++k) {
                const std::size_t row = k / (length + rest), column = k % (length + rest);
                if (rows[k] != (column < length ? expected[row * length + column] : 77))
                    return false;
            }
            return true;
        };
        CHECK(rows_agree(y, tight.y, w));
        CHECK(rows_agree(cb, tight.cb, w / 2));
        CHECK(rows_agree(cr, tight.cr, w / 2));
    }
}

TEST_CASE("known colours have the values of BT.709, not of BT.601") {
    struct Known {
        std::uint32_t pixel;
        int y, cb, cr;
    };
    for (const Known& known : {Known{0xffff0000u, 63, 102, 240}, Known{0xff00ff00u, 173, 42, 26},
                               Known{0xff0000ffu, 32, 240, 118}, Known{0xffffffffu, 235, 128, 128},
                               Known{0xff000000u, 16, 128, 128}}) {
        Picture picture(16, 4);
        std::fill(picture.pixels.begin(), picture.pixels.end(), known.pixel);
        const Converted out = convert(picture);
        CAPTURE(known.pixel);
        CHECK(std::count(out.y.begin(), out.y.end(), known.y) == 64);
        CHECK(std::count(out.cb.begin(), out.cb.end(), known.cb) == 16);
        CHECK(std::count(out.cr.begin(), out.cr.end(), known.cr) == 16);
    }
}

TEST_CASE("all greys are free of colour") {
    Picture picture(512, 2);
    for (int x = 0; x < 512; ++x)
        for (int y = 0; y < 2; ++y)
            picture.at(x, y) = 0xff000000u | static_cast<std::uint32_t>(x / 2) * 0x010101u;
    const Converted out = convert(picture);
    CHECK(std::count(out.cb.begin(), out.cb.end(), 128) == 256);
    CHECK(std::count(out.cr.begin(), out.cr.end(), 128) == 256);
}

TEST_CASE("chroma is sited on the left luma column") {
    const int full = 240 - 128;
    Picture even(16, 2), odd(16, 2);
    for (int y = 0; y < 2; ++y) even.at(6, y) = odd.at(7, y) = 0xffff0000u;
    const Converted on_site = convert(even), between = convert(odd);
    CHECK(on_site.red(3, 0) == 128 + full / 2);
    CHECK(on_site.red(2, 0) == 128);
    CHECK(on_site.red(4, 0) == 128);
    CHECK(between.red(3, 0) == 128 + full / 4);
    CHECK(between.red(4, 0) == 128 + full / 4);
}

TEST_CASE("an odd picture is converted as one whose last row and column are repeated") {
    Picture odd = noise(51, 23);
    Picture even(52, 24);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 52; ++x) even.at(x, y) = odd.at(std::min(x, 50), std::min(y, 22));
    CHECK(convert(odd) == convert(even));
}

TEST_CASE("converting what has changed gives the bytes of converting all") {
    Random random(11, "boxes");
    for (const auto& size :
         {std::pair{1, 1}, {2, 3}, {63, 5}, {64, 64}, {65, 31}, {127, 8}, {129, 66}, {300, 40}}) {
        const int width = size.first, height = size.second;
        CAPTURE(width);
        CAPTURE(height);
        Picture picture = noise(width, height, 3);
        Converted out = convert(picture);
        for (int round = 0; round < 40; ++round) {
            std::vector<PixelBounds> boxes;
            for (int k = static_cast<int>(random.below(4)); k > 0; --k) {
                const auto within = [&](int begin, int end) {
                    return begin + static_cast<int>(random.below(std::uint64_t(end - begin)));
                };
                const int left = within(0, width), top = within(0, height);
                boxes.push_back({left, top, within(left + 1, std::min(left + 70, width + 1)),
                                 within(top + 1, std::min(top + 9, height + 1))});
            }
            for (const PixelBounds& box : boxes)
                for (int y = box.top; y < box.bottom; ++y)
                    for (int x = box.left; x < box.right; ++x)
                        picture.at(x, y) ^= static_cast<std::uint32_t>(random.below(1 << 24));
            to_yuv420(picture.view(), boxes,
                      {out.y.data(), out.cb.data(), out.cr.data(), out.width, out.width / 2});
            REQUIRE(out == convert(picture));
        }
    }
}

TEST_CASE("what has not changed is not converted") {
    Picture picture = noise(400, 40);
    Converted out = empty_planes(picture);
    const std::vector<PixelBounds> boxes = {{130, 10, 140, 12}};
    to_yuv420(picture.view(), boxes,
              {out.y.data(), out.cb.data(), out.cr.data(), out.width, out.width / 2});
    const Converted all = convert(picture);
    CHECK(out.luma(130, 10) == all.luma(130, 10));
    CHECK(std::ranges::count_if(out.y, [](auto byte) { return byte != 0; }) == 2 * 32);
}

TEST_CASE("swscale, told to use BT.709, agrees on flat patches") {
    const int patch = 16, columns = 20, rows = 12;
    Picture picture(columns * patch, rows * patch);
    Random random(3, "patches");
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto color = 0xff000000u | static_cast<std::uint32_t>(random.below(1 << 24));
            for (int y = 0; y < patch; ++y)
                for (int x = 0; x < patch; ++x)
                    picture.at(column * patch + x, row * patch + y) = color;
        }
    const Converted ours = convert(picture);
    Converted theirs = empty_planes(picture);

    SwsContext* const context = sws_getContext(picture.width, picture.height, AV_PIX_FMT_BGRA,
                                               picture.width, picture.height, AV_PIX_FMT_YUV420P,
                                               SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP,
                                               nullptr, nullptr, nullptr);
    REQUIRE(context != nullptr);
    const int* const matrix = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(context, matrix, 1, matrix, 0, 0, 1 << 16, 1 << 16);
    const auto* const source = reinterpret_cast<const std::uint8_t*>(picture.pixels.data());
    const std::array<const std::uint8_t*, 4> from = {source, nullptr, nullptr, nullptr};
    const std::array<int, 4> from_stride = {4 * picture.stride, 0, 0, 0};
    const std::array<std::uint8_t*, 4> to = {theirs.y.data(), theirs.cb.data(), theirs.cr.data(),
                                             nullptr};
    const std::array<int, 4> to_stride = {theirs.width, theirs.width / 2, theirs.width / 2, 0};
    sws_scale(context, from.data(), from_stride.data(), 0, picture.height, to.data(),
              to_stride.data());
    sws_freeContext(context);

    // The middle of each patch: there no filter of either side sees a neighbour. swscale's own
    // weights have 15 bits and its rounding is not to the nearest: it may be one off.
    int luma_error = 0, chroma_error = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int x = column * patch + patch / 2, y = row * patch + patch / 2;
            luma_error = std::max(luma_error, std::abs(ours.luma(x, y) - theirs.luma(x, y)));
            chroma_error = std::max({chroma_error,
                                     std::abs(ours.blue(x / 2, y / 2) - theirs.blue(x / 2, y / 2)),
                                     std::abs(ours.red(x / 2, y / 2) - theirs.red(x / 2, y / 2))});
        }
    CHECK(luma_error <= 1);
    CHECK(chroma_error <= 1);
}

TEST_CASE("colours that were multiplied by alpha are converted as they were before") {
    // A letter of one ink on an odd picture: covered, half covered, and not at all on its right.
    constexpr std::uint32_t ink = 0xffe9a040, page = 0xff101418;
    Picture letter(9, 5, 3), whole(9, 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 9; ++x) {
            const std::uint32_t alpha = x < 3 ? 255u : x < 6 ? 130u : 0u;
            std::uint32_t multiplied = alpha;
            for (const int shift : {16, 8, 0})
                multiplied = multiplied << 8 | (((ink >> shift) & 255) * alpha + 127) / 255;
            letter.pixels[std::size_t(y * letter.stride + x)] = multiplied;
            whole.pixels[std::size_t(y * whole.stride + x)] = x < 6 ? ink : page;
        }
    std::array<std::vector<std::uint8_t>, 4> planes;
    for (std::vector<std::uint8_t>& plane : planes) plane.assign(60, 0);
    std::array<std::vector<std::uint8_t>, 3> expected{planes[0], planes[1], planes[2]};
    to_yuv420(whole.view(), {expected[0].data(), expected[1].data(), expected[2].data(), 10, 5});
    to_yuva420(letter.view(), page,
               {planes[0].data(), planes[1].data(), planes[2].data(), 10, 5, planes[3].data(), 10});
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 60; ++i)
            CHECK(std::abs(int(planes[k][i]) - int(expected[k][i])) <= 2);  // 8 bits, twice rounded
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 10; ++x)
            CHECK(planes[3][std::size_t(10 * y + x)] == (x < 3 ? 255 : x < 6 ? 130 : 0));
}
