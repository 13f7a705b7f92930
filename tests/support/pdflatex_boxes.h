// Formulae and the width, height and depth that pdfLaTeX gives them (TeX Live 2022, article at 10
// points), over 10 points. tests/unit/app/latex.cpp measures them again.
#pragma once

#include <vector>

namespace carom::test {

struct MeasuredFormula {
    bool stands_alone;  ///< \displaystyle
    const char* tex;
    double width, height, depth;
};

// clang-format off
inline const std::vector<MeasuredFormula> pdflatex_boxes{
{false, R"(kT)", 1.27535, 0.694444, 0},
{false, R"(x+y=z)", 4.16225, 0.583333, 0.194444},
{false, R"(-v)", 1.29838, 0.583333, 0.083333},
{false, R"(2(a+b))", 3.45775, 0.75, 0.25},
{false, R"(v^2)", 0.969214, 0.814003, 0},
{false, R"(v_1)", 0.933336, 0.430554, 0.149998},
{false, R"(v_1^2)", 0.969214, 0.814003, 0.24821},
{false, R"(v_1')", 0.933336, 0.751782, 0.24821},
{false, R"(v'^2)", 1.19977, 0.814003, 0},
{false, R"(T^2_0)", 1.17188, 0.814003, 0.24821},
{false, R"(f^2)", 1.04584, 0.814003, 0.194444},
{false, R"(f_1^2)", 1.04584, 0.814003, 0.24821},
{false, R"(\frac{kT}{m})", 1.26198, 0.879842, 0.344841},
{true, R"(\frac{kT}{m})", 1.51535, 1.37095, 0.685951},
{true, R"(\frac{p_x^2+p_y^2}{2m})", 3.45261, 1.58732, 0.685951},
{false, R"(\frac{p_x^2}{2m})", 1.34822, 1.134, 0.344841},
{true, R"(E=\frac12 mv^2)", 4.71638, 1.32095, 0.685951},
{false, R"(\sqrt{x})", 1.40486, 0.800272, 0.239725},
{true, R"(\sqrt{x})", 1.40486, 0.849092, 0.190904},
{true, R"(\sqrt{\frac{2kT}{m}})", 3.01535, 1.67633, 0.763693},
{false, R"(\sqrt{\frac{2kT}{\pi m}})", 2.6606, 1.2525, 0.58751},
{true, R"(\sqrt{\frac{1}{1+\frac{1}{x^2}}})", 4.04597, 1.75447, 1.28556},
{false, R"(\sqrt{m_1}v_1)", 3.0933, 0.725273, 0.314723},
{false, R"(\sqrt{x}^3)", 1.85348, 1.00416, 0.239725},
{false, R"(\langle v^2\rangle)", 1.74699, 0.814003, 0.25},
{false, R"(\left\langle v^2\right\rangle)", 1.91366, 0.850005, 0.350006},
{true, R"(\left(\frac{m}{2\pi kT}\right)^{3/2})", 5.07265, 1.42779, 0.685951},
{true, R"(\left|\frac{a}{b}\right|)", 1.43525, 1.15001, 0.685951},
{true, R"(\left[\frac{\frac{a}{b}}{\frac{c}{d}}\right])", 1.96932, 1.45001, 1.03079},
{false, R"(\left.x\right))", 1.08042, 0.75, 0.25},
{false, R"(e^{\left(\frac{a}{b}\right)})", 1.92062, 1.10764, 0},
{false, R"(e^{-mv^2/2kT})", 4.49596, 0.986893, 0},
{true, R"(f(v)=\frac{m}{kT}\,v\,e^{-mv^2/2kT})", 10.0942, 1.10706, 0.685951},
{false, R"(f(v)\propto v\,e^{-\frac{mv^2}{2kT}})", 6.68017, 1.15562, 0.25},
{true, R"(\sum_{i=1}^N m_iv_i)", 3.6397, 1.82834, 1.27987},
{false, R"(\sum_{i=1}^N m_iv_i)", 4.59625, 0.98112, 0.300005},
{true, R"(\sum_i v_i)", 2.42876, 1.05001, 1.27987},
{true, R"(\sum x)", 2.18264, 1.05001, 0.550006},
{true, R"(\sum^N_jx)", 2.18264, 1.82834, 1.41597},
{true, R"(\int_0^\infty f(v)\,\mathrm{d}v=1)", 6.98564, 1.41529, 0.911122},
{false, R"(\int_0^\infty f(v)\,\mathrm{d}v=1)", 6.65231, 0.859729, 0.35556},
{true, R"(\int_V x)", 1.98819, 1.36112, 0.911122},
{true, R"(\int^a x)", 2.22196, 1.41529, 0.861124},
{true, R"(\int x)", 1.73819, 1.36112, 0.861124},
{false, R"(\bar v)", 0.520601, 0.567776, 0},
{false, R"(\bar T)", 0.723265, 0.820554, 0},
{false, R"(\hat n)", 0.600235, 0.694444, 0},
{false, R"(\vec v)", 0.520601, 0.714444, 0},
{false, R"(\vec v_1)", 0.933336, 0.714444, 0.149998},
{false, R"(\hat{E}^2)", 1.24444, 0.947221, 0},
{false, R"(\dot x)", 0.571527, 0.667859, 0},
{false, R"(\bar{v^2})", 0.969214, 0.877222, 0},
{false, R"(\bar{ab}_1)", 1.40637, 0.831667, 0.149998},
{false, R"(x^{\bar v})", 1.04665, 0.764835, 0},
{false, R"(S=-k\ln w)", 5.2435, 0.694444, 0.083333},
{false, R"(\ln(x))", 2.18264, 0.75, 0.25},
{false, R"(\ln\frac{a}{b})", 1.67376, 0.69512, 0.344841},
{false, R"(\exp x)", 2.26597, 0.430554, 0.194444},
{false, R"(T_\mathrm{max})", 2.11008, 0.683331, 0.149998},
{false, R"(\mathrm{d}x)", 1.12708, 0.694444, 0},
{false, R"(a\leq b\pm c)", 3.94605, 0.694444, 0.135971},
{false, R"(x\to\infty)", 3.12707, 0.430554, 0},
{false, R"(n!=1)", 2.71134, 0.694444, 0},
{false, R"(x,y)", 1.54213, 0.430554, 0.194444},
{false, R"((a,b))", 2.17998, 0.75, 0.25},
{false, R"(\rho_0\approx\Gamma)", 2.92395, 0.683331, 0.194444},
{false, R"(x^{a+b})", 2.02085, 0.849002, 0},
{false, R"(x_{y_z})", 1.43993, 0.430554, 0.286108},
{false, R"(a=-b)", 3.06886, 0.694444, 0.083333},
{false, R"(a\cdot b)", 1.67997, 0.694444, 0},
{false, R"(a\times)", 1.30637, 0.583333, 0.083333},
{false, R"(x^{y^z})", 1.46505, 0.879948, 0},
{false, R"({a+b}c)", 2.61272, 0.694444, 0.083333},
{false, R"(a/b)", 1.45776, 0.75, 0.25},
{false, R"(\lambda=\frac{1}{2\sqrt2\,nd})", 4.65803, 0.844843, 0.543994},
{true, R"(\frac{\partial\rho}{\partial t})", 1.34347, 1.37095, 0.685951},
{false, R"(AV)", 1.55556, 0.683331, 0},
{false, R"(\psi_\mu\quad x\;y)", 3.56308, 0.694444, 0.286108},
{false, R"(2.5\gg\delta)", 3.31562, 0.694444, 0.039098},
{true, R"(\left(\frac{\frac{\frac{a}{b}}{c}}{\frac{d}{\frac{e}{x}}}\right))", 2.69917, 1.76979, 1.35563},
};
// clang-format on

}  // namespace carom::test
