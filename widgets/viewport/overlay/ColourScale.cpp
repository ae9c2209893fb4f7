// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/overlay/ColourScale.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

struct Lab {
  double lightness, a, b;
};

// The ends have lightness 40 and chroma 56, at hues of 285° and 25°: the most that fits into sRGB on both sides.
constexpr Lab kNeutral{95.0, 0.0, 0.0}, kLow{40.0, 14.494, -54.092}, kHigh{40.0, 50.753, 23.667};
constexpr double kWhite[] = {0.95047, 1.0, 1.08883};  // D65

// Inverts the function of CIE 15:2004, sections 8.2.1 and Annex B.
double unfolded(double f) {
  constexpr double kKnee = 6.0 / 29.0;
  return f > kKnee ? f * f * f : 3.0 * kKnee * kKnee * (f - 4.0 / 29.0);
}

// Encodes according to IEC 61966-2-1.
float encoded(double linear) {
  const double c = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<float>(std::clamp(c, 0.0, 1.0));
}

QColor labColour(const Lab& lab) {
  const double fy = (lab.lightness + 16.0) / 116.0;
  const double x = kWhite[0] * unfolded(fy + lab.a / 500.0), y = kWhite[1] * unfolded(fy),
               z = kWhite[2] * unfolded(fy - lab.b / 200.0);
  return QColor::fromRgbF(encoded(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
                          encoded(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
                          encoded(0.0556434 * x - 0.2040259 * y + 1.0572252 * z));
}

}  // namespace

QColor ColourScale::at(double value) const {
  if (std::isnan(value)) return labColour({70.0, 0.0, 0.0});
  const double t = std::min(std::abs(value) / range, 1.0);
  const Lab& end = value < 0.0 ? kLow : kHigh;
  return labColour({std::lerp(kNeutral.lightness, end.lightness, t), t * end.a, t * end.b});
}

}  // namespace handwheel
