// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/PlotScale.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kMargin = 0.04;        // share of the range, on each side
constexpr double kLargestSize = 1e300;  // beyond, the ends of a range are no numbers any more

// Returns 1, 2 or 5 times a power of ten, near the value.
double niceStep(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double share = value / power;
  return power * (share < 1.5 ? 1.0 : share < 3.0 ? 2.0 : share < 7.0 ? 5.0 : 10.0);
}

std::vector<double> linearTicks(double least, double largest, int count) {
  const double step = niceStep((largest - least) / count);
  const double first = std::ceil(least / step);
  std::vector<double> ticks;
  for (int i = 0; i <= 4 * count; ++i) {  // bounded, and each larger than the last even where doubles are coarse
    const double tick = (first + i) * step;
    if (tick <= largest && (ticks.empty() || tick > ticks.back())) ticks.push_back(tick);
  }
  return ticks;
}

std::vector<double> logarithmicTicks(double least, double largest, int count) {
  const double decades = std::log10(largest / least);
  const auto every = static_cast<int>(std::max(1.0, std::ceil(decades / count)));
  std::vector<double> ticks;
  for (auto k = static_cast<int>(std::floor(std::log10(least))); std::pow(10.0, k) <= largest; ++k) {
    if (k % every != 0) continue;
    for (double digit : {1.0, 2.0, 5.0}) {
      const double tick = digit * std::pow(10.0, k);
      const bool isWanted = digit == 1.0 || 3.0 * decades <= count;  // few decades: also 2 and 5
      if (isWanted && tick >= least && tick <= largest) ticks.push_back(tick);
    }
  }
  return ticks;
}

QString superscript(int number) {
  static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString text;
  for (const QChar c : QString::number(number)) {
    text += c == QLatin1Char('-') ? QStringLiteral("⁻") : QString(digits[c.digitValue()]);
  }
  return text;
}

}  // namespace

double PlotScale::positionOf(double value) const {
  if (logarithmic) return std::log(value / least) / std::log(largest / least);
  return (value - least) / (largest - least);
}

PlotScale scaleFor(std::span<const double> values, bool logarithmic, int count) {
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
               [](double v) { return std::abs(v) <= kLargestSize; });
  PlotScale scale;
  if (!finite.empty()) {
    const auto [low, high] = std::minmax_element(finite.begin(), finite.end());
    scale.logarithmic = logarithmic && *low >= 1.0 / kLargestSize;
    scale.least = *low;
    scale.largest = *high;
    if (scale.logarithmic) {
      const double margin = std::pow(std::max(scale.largest / scale.least, 2.0), kMargin);
      scale.least /= margin;
      scale.largest *= margin;
    } else {
      const double size = scale.largest - scale.least;
      const double margin = size > 0.0 ? kMargin * size : std::max(0.1 * std::abs(scale.least), 1e-12);
      scale.least = *low >= 0.0 && *low < margin ? 0.0 : scale.least - margin;  // no room below a natural zero
      scale.largest += margin;
    }
  }
  scale.ticks = scale.logarithmic ? logarithmicTicks(scale.least, scale.largest, count)
                                  : linearTicks(scale.least, scale.largest, count);
  return scale;
}

QString tickLabel(double tick, const PlotScale& scale, const QLocale& locale) {
  const double size = std::abs(tick);
  if (size == 0.0) return locale.toString(0);
  const double exponent = std::floor(std::log10(size) + 1e-9);
  if (exponent >= -3.0 && exponent <= 4.0) {
    // The digits behind the point tell neighbours apart.
    const double step = scale.logarithmic || scale.ticks.size() < 2 ? size : scale.ticks[1] - scale.ticks[0];
    const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return locale.toString(tick, 'f', digits);
  }
  const double digit = tick / std::pow(10.0, exponent);
  const QString power = QStringLiteral("10") + superscript(static_cast<int>(exponent));
  if (std::abs(digit - 1.0) < 1e-9) return power;
  return locale.toString(digit, 'g', 3) + QStringLiteral("·") + power;
}

}  // namespace handwheel
