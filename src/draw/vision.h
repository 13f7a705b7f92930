// How colours look to viewers with normal and with deficient colour vision, and how different they
// are to them.
#pragma once

#include <array>

#include "draw/color.h"

namespace carom::vision {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

struct Vision {
    const char* name;
    Matrix matrix;  ///< from linear sRGB to linear sRGB
};

/// Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision
/// deficiency", IEEE Trans. Vis. Comput. Graph. 15(6), 1291-1298 (2009),
/// doi:10.1109/TVCG.2009.113: the matrices of severity 1. The rows sum to 1: greys stay grey.
inline constexpr std::array<Vision, 4> visions = {{
    {"full", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779},
       {-0.078411, 0.930809, 0.147602},
       {0.004733, 0.691367, 0.303900}}}},
}};

/// A colour as a viewer sees it, in linear sRGB.
Triple seen_by(const Vision& vision, Color color);

/// CIE 1976 L*a*b* under illuminant D65, from linear sRGB.
Triple lab_of(const Triple& light);

/// The colour difference CIEDE2000 in the formulation of Sharma, Wu and Dalal (Color Res. Appl. 30,
/// 21-30, 2005).
double ciede2000(const Triple& one, const Triple& two);

/// The difference of two colours to a viewer.
double distance(const Vision& vision, Color a, Color b);

/// CIE lightness in [0, 100]: what remains of a colour in a greyscale copy.
double lightness(Color color);

/// Colours that stand for different things differ at least this much (CIEDE2000) for every viewer.
/// A difference of about 1 is just visible side by side; one of 10 is seen at a glance, and one of
/// 20 from the back of a lecture hall.
inline constexpr double least_distance = 20.0;

/// The least difference of neighbouring colours of one scale, which are also told apart by the
/// numbers beside it, and of the colours of panels from those of a scale beside them.
inline constexpr double least_distance_on_scale = 10.0;

}  // namespace carom::vision
