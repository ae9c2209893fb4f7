// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <span>
#include <vector>

namespace handwheel {

// The range and the ticks of an axis.
struct PlotScale {
  double least = 0.0;
  double largest = 1.0;
  bool logarithmic = false;
  std::vector<double> ticks;  // in ascending order, within the range

  double positionOf(double value) const;  // relative position: 0 at `least`, 1 at `largest`
};

// Computes a scale that contains all values with a margin. It has about `count` ticks at multiples of 1, 2 or 5 times a
// power of ten (Heckbert, "Nice numbers for graph labels", 1990). Values that are not finite, or beyond 1e300, are
// ignored; without any other values, the scale is 0…1. The scale is logarithmic only if all values are above 1e-300.
PlotScale scaleFor(std::span<const double> values, bool logarithmic, int count = 6);

// Returns the label of a tick: plain digits, or a power of ten.
QString tickLabel(double tick, const PlotScale& scale, const QLocale& locale);

}  // namespace handwheel
