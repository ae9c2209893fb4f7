// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/TimingPlot.h"

#include <QCoreApplication>
#include <algorithm>
#include <numeric>

namespace handwheel {

namespace {
constexpr std::ptrdiff_t kMostBars = 40;
constexpr double kMicroseconds = 1e6;  // us per second
}  // namespace

TimingCounts countsOf(const TimingHistogram& histogram) {
  TimingCounts result;
  result.counts = histogram.counts();
  result.binSeconds = histogram.binSeconds();
  result.median = histogram.quantile(0.5);
  result.most = histogram.quantile(0.99);
  result.longest = histogram.quantile(1.0);
  result.isOpen = result.counts.back() > 0;
  return result;
}

Plot timingPlot(const TimingCounts& timing, const QString& title, const QLocale& locale) {
  Plot plot;
  plot.title = title;
  plot.x = {QCoreApplication::translate("TimingPlot", "Time"), QStringLiteral("µs"), false, {}};
  plot.y = {QCoreApplication::translate("TimingPlot", "Ticks"), QString(), true, {0.5}};
  plot.locale = locale;
  const auto& counts = timing.counts;
  const auto isUsed = [](std::uint64_t count) { return count > 0; };
  const auto first = std::find_if(counts.begin(), counts.end(), isUsed);
  const auto end = std::find_if(counts.rbegin(), std::make_reverse_iterator(first), isUsed).base();
  const std::ptrdiff_t bins = std::max<std::ptrdiff_t>(1, (end - first + kMostBars - 1) / kMostBars);  // bins per bar
  PlotSeries bars;
  bars.name = plot.y.title;
  bars.barWidth = static_cast<double>(bins) * timing.binSeconds * kMicroseconds;
  for (auto bin = first; bin < end; bin += std::min(bins, end - bin)) {
    const auto count = std::accumulate(bin, bin + std::min(bins, end - bin), std::uint64_t{0});
    const double left = static_cast<double>(bin - counts.begin()) * timing.binSeconds * kMicroseconds;
    if (count > 0) bars.points.emplace_back(left + 0.5 * bars.barWidth, static_cast<double>(count));
  }
  plot.series.push_back(std::move(bars));
  return plot;
}

}  // namespace handwheel
