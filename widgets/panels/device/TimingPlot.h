// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/servo/TimingHistogram.h"
#include "plot/Plot.h"

#include <QLocale>

namespace handwheel {

// A copy of a timing histogram with its percentiles.
struct TimingCounts {
  TimingHistogram::Counts counts{};
  double binSeconds = 0.0;
  double median = 0.0;   // s; like the other percentiles, the upper end of a bin
  double most = 0.0;     // 99th percentile, s
  double longest = 0.0;  // maximum, s; not valid if isOpen
  bool isOpen = false;   // some values are beyond the range of the histogram
};
// Copies the counts of a histogram and computes the percentiles.
TimingCounts countsOf(const TimingHistogram& histogram);

// Returns a bar plot of the number of ticks by duration in microseconds. It extends from the shortest to the longest
// duration that occurred, and has at most 40 bars: bins are merged if there are more. The number of ticks is on a
// logarithmic axis, so that rare late ticks are visible.
Plot timingPlot(const TimingCounts& counts, const QString& title, const QLocale& locale);

}  // namespace handwheel
