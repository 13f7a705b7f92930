#include "draw/palette.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace carom {
namespace {

// Every third of the 256 colours of the maps in matplotlib's _cm_listed.py (see
// palette-LICENSE.txt), from the slow end to the fast one. Straight lines between them stay within
// 2.5/255 of the rest.
using Samples = std::array<std::uint32_t, 86>;

constexpr Samples viridis = {
    0x440154, 0x450559, 0x460a5d, 0x470e61, 0x471365, 0x481769, 0x481b6d, 0x481f70, 0x482374,
    0x482677, 0x472a7a, 0x472e7c, 0x46327e, 0x453581, 0x443983, 0x433d84, 0x424086, 0x414487,
    0x3f4788, 0x3e4a89, 0x3d4e8a, 0x3b518b, 0x3a548c, 0x38588c, 0x375b8d, 0x355e8d, 0x34618d,
    0x32648e, 0x31678e, 0x306a8e, 0x2e6d8e, 0x2d708e, 0x2c728e, 0x2b758e, 0x2a788e, 0x297b8e,
    0x277e8e, 0x26818e, 0x25838e, 0x24868e, 0x23898e, 0x228c8d, 0x218f8d, 0x20928c, 0x1f948c,
    0x1f978b, 0x1f9a8a, 0x1e9d89, 0x1fa088, 0x1fa287, 0x21a585, 0x22a884, 0x25ab82, 0x27ad81,
    0x2ab07f, 0x2eb37c, 0x32b67a, 0x37b878, 0x3bbb75, 0x40bd72, 0x46c06f, 0x4cc26c, 0x52c569,
    0x58c765, 0x5ec962, 0x65cb5e, 0x6ccd5a, 0x73d056, 0x7ad151, 0x81d34d, 0x89d548, 0x90d743,
    0x98d83e, 0xa0da39, 0xa8db34, 0xb0dd2f, 0xb8de29, 0xc0df25, 0xc8e020, 0xd0e11c, 0xd8e219,
    0xdfe318, 0xe7e419, 0xefe51c, 0xf6e620, 0xfde725};

constexpr Samples cividis = {
    0x00224e, 0x002553, 0x002758, 0x00295d, 0x002b62, 0x002d68, 0x002f6d, 0x003170, 0x053371,
    0x0f3570, 0x163770, 0x1c396f, 0x213b6e, 0x263d6e, 0x2a3f6d, 0x2e416d, 0x32436d, 0x35456c,
    0x39486c, 0x3c4a6c, 0x3f4c6c, 0x424e6c, 0x45506c, 0x48526c, 0x4b546c, 0x4e566c, 0x51586d,
    0x545a6d, 0x565c6d, 0x595e6e, 0x5c616e, 0x5e636f, 0x61656f, 0x646770, 0x666970, 0x696b71,
    0x6c6d72, 0x6e6f73, 0x717274, 0x737475, 0x767676, 0x787877, 0x7b7a78, 0x7e7c78, 0x807f78,
    0x838179, 0x868379, 0x898578, 0x8c8878, 0x8f8a78, 0x928c78, 0x948e77, 0x979177, 0x9a9376,
    0x9d9576, 0xa09875, 0xa39a74, 0xa69c74, 0xa99f73, 0xaca172, 0xafa471, 0xb3a670, 0xb6a96f,
    0xb9ab6d, 0xbcae6c, 0xbfb06b, 0xc2b369, 0xc5b568, 0xc8b866, 0xccba64, 0xcfbd62, 0xd2c060,
    0xd5c25e, 0xd9c55c, 0xdcc859, 0xdfca57, 0xe2cd54, 0xe6d051, 0xe9d34e, 0xedd54a, 0xf0d846,
    0xf3db42, 0xf7de3e, 0xfbe138, 0xfee434, 0xfee838};

constexpr Samples plasma = {
    0x0d0887, 0x16078a, 0x1d068e, 0x240691, 0x2a0593, 0x2f0596, 0x350498, 0x3a049a, 0x3f049c,
    0x44039e, 0x4903a0, 0x4e02a2, 0x5302a3, 0x5801a4, 0x5c01a6, 0x6100a7, 0x6600a7, 0x6a00a8,
    0x6f00a8, 0x7401a8, 0x7801a8, 0x7d03a8, 0x8104a7, 0x8606a6, 0x8a09a5, 0x8e0ca4, 0x920fa3,
    0x9613a1, 0x9a169f, 0x9e199d, 0xa21d9a, 0xa62098, 0xaa2395, 0xad2793, 0xb12a90, 0xb42e8d,
    0xb7318a, 0xbb3488, 0xbe3885, 0xc13b82, 0xc43e7f, 0xc7427c, 0xca457a, 0xcc4977, 0xcf4c74,
    0xd24f71, 0xd5536f, 0xd7566c, 0xda5a6a, 0xdc5d67, 0xde6164, 0xe16462, 0xe3685f, 0xe56b5d,
    0xe76f5a, 0xe97257, 0xeb7655, 0xed7a52, 0xef7e50, 0xf1814d, 0xf3854b, 0xf48948, 0xf68d45,
    0xf79143, 0xf89540, 0xf99a3e, 0xfa9e3b, 0xfba238, 0xfca636, 0xfdab33, 0xfdaf31, 0xfdb42f,
    0xfeb82c, 0xfebd2a, 0xfdc229, 0xfdc627, 0xfdcb26, 0xfcd025, 0xfbd524, 0xfada24, 0xf8df25,
    0xf7e425, 0xf5e926, 0xf3ee27, 0xf1f426, 0xf0f921};

constexpr Samples inferno = {
    0x000004, 0x010108, 0x02020e, 0x040314, 0x07051b, 0x0a0722, 0x0d0829, 0x110a30, 0x150b37,
    0x190c3e, 0x1e0c45, 0x230c4c, 0x280b53, 0x2d0b59, 0x320a5e, 0x380962, 0x3d0965, 0x420a68,
    0x470b6a, 0x4c0c6b, 0x510e6c, 0x550f6d, 0x5a116e, 0x5f136e, 0x64156e, 0x69166e, 0x6d186e,
    0x721a6e, 0x771c6d, 0x7c1d6d, 0x801f6c, 0x85216b, 0x8a226a, 0x8f2469, 0x932667, 0x982766,
    0x9d2964, 0xa22b62, 0xa62d60, 0xab2f5e, 0xb0315b, 0xb43359, 0xb93556, 0xbd3853, 0xc13a50,
    0xc63d4d, 0xca404a, 0xce4347, 0xd24644, 0xd54a41, 0xd94d3d, 0xdd513a, 0xe05536, 0xe35933,
    0xe65d2f, 0xe9612b, 0xeb6628, 0xee6a24, 0xf06f20, 0xf2741c, 0xf47918, 0xf67e14, 0xf78410,
    0xf8890c, 0xf98e09, 0xfa9407, 0xfb9906, 0xfc9f07, 0xfca50a, 0xfcaa0f, 0xfcb014, 0xfbb61a,
    0xfbbc21, 0xfac228, 0xf9c72f, 0xf8cd37, 0xf7d340, 0xf5d949, 0xf4df53, 0xf3e55d, 0xf2ea69,
    0xf1ef75, 0xf2f482, 0xf4f88e, 0xf8fb9a, 0xfcffa4};

constexpr Samples magma = {
    0x000004, 0x010108, 0x02020d, 0x040414, 0x06051a, 0x090720, 0x0c0926, 0x100b2d, 0x130d34,
    0x160f3b, 0x1a1042, 0x1e1149, 0x221150, 0x271258, 0x2c115f, 0x311165, 0x36106b, 0x3b0f70,
    0x400f74, 0x451077, 0x4a1079, 0x4f127b, 0x54137d, 0x59157e, 0x5d177f, 0x621980, 0x671b80,
    0x6b1d81, 0x701f81, 0x752181, 0x792282, 0x7e2482, 0x832681, 0x882781, 0x8c2981, 0x912b81,
    0x962c80, 0x9b2e7f, 0xa02f7f, 0xa5317e, 0xaa337d, 0xae347b, 0xb3367a, 0xb83779, 0xbd3977,
    0xc23b75, 0xc73d73, 0xcc3f71, 0xd0416f, 0xd5446d, 0xd9466b, 0xde4968, 0xe24d66, 0xe55064,
    0xe95462, 0xec5860, 0xef5d5e, 0xf2625d, 0xf4675c, 0xf66c5c, 0xf7725c, 0xf9785d, 0xfa7d5e,
    0xfb835f, 0xfc8961, 0xfc8e64, 0xfd9467, 0xfd9a6a, 0xfe9f6d, 0xfea571, 0xfeaa74, 0xfeb078,
    0xfeb67c, 0xfebb81, 0xfec185, 0xfec68a, 0xfecc8f, 0xfed194, 0xfed799, 0xfddc9e, 0xfde2a3,
    0xfde7a9, 0xfcecae, 0xfcf2b4, 0xfcf7b9, 0xfcfdbf};

// A colour map, with the two colours (for a dark and for a light ground) that are farthest from all
// colours of the map for every viewer.
struct NamedMap {
    const char* name;
    const Samples& samples;
    Color beside_on_dark, beside_on_light;
};

constexpr Color sky = rgb(0x77CCFF), violet = rgb(0x9977FF);
const std::array named_maps = {NamedMap{"viridis", viridis, rgb(0xFF88FF), rgb(0xA02000)},
                               NamedMap{"cividis", cividis, sky, rgb(0x992200)},
                               NamedMap{"plasma", plasma, sky, rgb(0x500000)},
                               NamedMap{"inferno", inferno, sky, violet},
                               NamedMap{"magma", magma, sky, violet}};

const NamedMap& map_of(std::string_view name) {
    for (const NamedMap& map : named_maps)
        if (map.name == name) return map;
    throw std::invalid_argument("no colour map is named " + std::string(name));
}

const Samples& samples_of(std::string_view name) { return map_of(name).samples; }

// Blue, coral, green and violet, then a nearly white and a slate. Found by simulated annealing in
// Oklch among colours of a chroma of at most 0.17, so that each two, and each and the theory curve,
// differ for every viewer by a CIEDE2000 of 20; that each stands out from page and ground by a
// contrast of 3; that none with a hue has the theory curve's to within 28 degrees, so that there is
// no other gold; and that two are 10 away from all of any scale (see kind_colors_beside).
constexpr std::array on_dark = {rgb(0xABD0FC), rgb(0xCF4F2C), rgb(0x419B7F),
                                rgb(0x9A74E8), rgb(0xF0EADE), rgb(0x5E657D)};
constexpr std::array on_light = {rgb(0x215C95), rgb(0xDC7A4F), rgb(0x5A9F99),
                                 rgb(0x9C80F6), rgb(0x0E2716), rgb(0x5F5E5D)};
// More than four greys would not be that far apart. Lines are also dashed, and pale disks are drawn
// as rings.
constexpr std::array in_print = {rgb(0x000000), rgb(0xE4E4E4), rgb(0x4E4E4E), rgb(0x8E8E8E)};

// NetLogo's colours 105, 55 and 15, made brighter or darker where the ground requires it, and with
// green so much lighter than red that viewers who cannot distinguish their hues see the difference
// in lightness.
constexpr std::array netlogo_on_dark = {rgb(0x5A87D8), rgb(0x9CED6E), rgb(0xE5483F)};
constexpr std::array netlogo_on_light = {rgb(0x345DA9), rgb(0x59A239), rgb(0xA21110)};

}  // namespace

Color ColorMap::at(double share) const {
    const auto last = static_cast<double>(samples_.size() - 1);
    // A share that is not a number is drawn as the slow end.
    const double place = share > 0.0 ? std::min(share, 1.0) * last : 0.0;
    const auto below = static_cast<std::size_t>(std::floor(place));
    const std::size_t above = std::min(below + 1, samples_.size() - 1);
    return mix(samples_[below], samples_[above], place - static_cast<double>(below));
}

ColorMap color_map(std::string_view name, double first, double last) {
    const Samples& samples = samples_of(name);
    std::vector<Color> whole(samples.size());
    std::ranges::transform(samples, whole.begin(), rgb);
    if (first == 0.0 && last == 1.0) return ColorMap(std::move(whole));

    const ColorMap map(std::move(whole));
    std::vector<Color> cut(256);
    for (std::size_t i = 0; i < cut.size(); ++i)
        cut[i] = map.at(std::lerp(first, last, static_cast<double>(i) / 255.0));
    return ColorMap(std::move(cut));
}

ColorMap color_map_on(std::string_view name, const Theme& theme) {
    const ColorMap whole = color_map(name);
    const double step = theme.dark ? 1e-3 : -1e-3, last = theme.dark ? 1.0 : 0.0;
    double first = 1.0 - last;
    const auto stands_out = [&](Color color) {
        return contrast(color, theme.page) >= least_contrast_of_marks &&
               contrast(color, theme.ground) >= least_contrast_of_marks;
    };
    while (std::abs(first - last) > 0.5 * std::abs(step) && !stands_out(whole.at(first)))
        first += step;
    return color_map(name, first, last);
}

std::span<const std::string> color_map_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const NamedMap& map : named_maps) all.emplace_back(map.name);
        return all;
    }();
    return names;
}

ColorMap ramp_map(const Theme& theme) {
    constexpr int steps = 64;
    std::vector<Oklab> knots;
    for (const Color color : theme.ramp) knots.push_back(oklab(color));
    const auto last = static_cast<double>(knots.size() - 1);
    std::vector<Color> samples;
    for (int i = 0; i <= steps; ++i) {
        const double place = last * i / steps;
        const auto below = std::min(static_cast<std::size_t>(place), knots.size() - 2);
        const double share = place - static_cast<double>(below);
        const Oklab &a = knots[below], &b = knots[below + 1];
        samples.push_back(from_oklab({std::lerp(a.lightness, b.lightness, share),
                                      std::lerp(a.a, b.a, share), std::lerp(a.b, b.b, share)}));
    }
    return ColorMap(std::move(samples));
}

ColorMap netlogo_map(bool dark_ground) {
    const auto& colors = dark_ground ? netlogo_on_dark : netlogo_on_light;
    return ColorMap({colors.begin(), colors.end()});
}

Color speed_class_color(std::size_t index, const Theme& theme) {
    if (!theme.ramp.empty()) return ramp_map(theme).at(0.5 * static_cast<double>(index));
    constexpr std::array greys = {in_print[3], in_print[2], in_print[0]};
    if (theme.kind == ThemeKind::print) return greys.at(index);
    return (theme.dark ? netlogo_on_dark : netlogo_on_light).at(index);
}

Color color_beside(std::string_view name, const Theme& theme) {
    return theme.dark ? map_of(name).beside_on_dark : map_of(name).beside_on_light;
}

// Even steps of CIE lightness: from 61, which has a contrast of 3 with white, to 31, which nobody
// takes for black.
ColorMap grey_map() {
    constexpr double light = 61.0, dark = 30.5;
    constexpr int steps = 64;
    std::vector<Color> greys;
    for (int i = 0; i <= steps; ++i) {
        const double luminance =
            std::pow((std::lerp(light, dark, double(i) / steps) + 16) / 116, 3);
        const double grey = 1.055 * std::pow(luminance, 1.0 / 2.4) - 0.055;
        greys.push_back({grey, grey, grey, 1.0});
    }
    return ColorMap(std::move(greys));
}

Color kind_color(std::size_t index, const Theme& theme) {
    if (!theme.series.empty()) return theme.series[index % theme.series.size()];
    switch (theme.kind) {
        case ThemeKind::dark:
            return on_dark[index % on_dark.size()];
        case ThemeKind::light:
            return on_light[index % on_light.size()];
        case ThemeKind::print:
            return in_print[index % in_print.size()];
    }
    assert(false);
    return theme.ink;
}

ColorMap direction_map(const Theme& theme) {
    if (theme.kind != ThemeKind::print) {
        const auto& colors = theme.dark ? on_dark : on_light;
        return ColorMap({colors[0], colors[3], colors[1], colors[2], colors[0]});
    }
    // Four of five steps from black to white; white is left for what is at rest.
    constexpr Color up = rgb(0x444444), left = rgb(0xA8A8A8), down = rgb(0x747474);
    return ColorMap({in_print[0], up, left, down, in_print[0]});
}

std::vector<Color> kind_colors_beside(std::span<const Color> others, const Theme& theme) {
    if (!theme.series.empty()) return {theme.series.begin(), theme.series.end()};
    constexpr double least_contrast_with_words = 1.6;
    std::vector<std::pair<double, Color>> kinds;
    const std::size_t count = theme.kind == ThemeKind::print ? in_print.size() : on_dark.size();
    std::vector<Oklab> apart;
    for (const Color other : {theme.highlight, theme.accent, theme.page})
        apart.push_back(oklab(other));
    for (const Color other : others) apart.push_back(oklab(other));
    for (std::size_t k = 0; k < count; ++k) {
        const Color color = kind_color(k, theme);
        const Oklab own = oklab(color);
        double least = INFINITY;
        for (const Oklab& other : apart) least = std::min(least, difference(own, other));
        if (contrast(color, theme.ink) < least_contrast_with_words) least = 0.0;
        const double stands_out = contrast(color, theme.page) / least_contrast_of_words;
        kinds.emplace_back(least * std::min(1.0, stands_out), color);
    }
    std::ranges::stable_sort(kinds, std::greater(), &std::pair<double, Color>::first);
    std::vector<Color> colors;
    for (const auto& [distance, color] : kinds) colors.push_back(color);
    if (oklab(colors[0]).b > oklab(colors[1]).b) std::swap(colors[0], colors[1]);
    return colors;
}

}  // namespace carom
