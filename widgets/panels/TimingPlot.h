// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/TimingHistogram.h"
#include "plot/Plot.h"

#include <QLocale>

namespace handwheel {

// What a histogram of times holds at one moment.
struct TimingCounts {
  TimingHistogram::Counts counts{};
  double binSeconds = 0.0;
  double median = 0.0;   // s, as all of these the upper end of a bin
  double most = 0.0;     // 99 of 100 are not above
  double longest = 0.0;  // none is above, unless isOpen
  bool isOpen = false;   // some are longer than the histogram reaches
};
TimingCounts countsOf(const TimingHistogram& histogram);

// Bars of the numbers of ticks against microseconds, from the shortest to the longest that occurred, at most 40 of
// them: bins are put together where there are more. The ticks on a logarithmic axis, so that the rare late one is seen.
Plot timingPlot(const TimingCounts& counts, const QString& title, const QLocale& locale);

}  // namespace handwheel
