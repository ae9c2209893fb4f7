// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/PlotLayout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

PlotScale scaleOf(const Plot& plot, const PlotAxis& axis, double (*of)(const QPointF&)) {
  std::vector<double> values = axis.shown;
  for (const PlotSeries& s : plot.series) {
    for (const QPointF& p : s.points) {
      if (!std::isfinite(p.x()) || !std::isfinite(p.y())) continue;
      values.push_back(of(p));
      if (!(s.barWidth > 0.0)) continue;
      // Bars extend from the left end to the right one, and down to zero.
      for (const double x : {p.x() - 0.5 * s.barWidth, p.x() + 0.5 * s.barWidth}) {
        values.push_back(of(QPointF(x, axis.logarithmic ? p.y() : 0.0)));
      }
    }
  }
  for (const PlotMark& m : plot.marks) values.push_back(of(m.position));
  return scaleFor(values, axis.logarithmic);
}

double widestLabel(const PlotScale& scale, const QLocale& locale, const QFontMetricsF& metrics) {
  double width = 0.0;
  for (double tick : scale.ticks) width = std::max(width, metrics.horizontalAdvance(tickLabel(tick, scale, locale)));
  return width;
}

// Returns the ticks whose labels fit one after the other along an axis of this length, at least that far apart; pixels.
// Each, each second, third and so on, including the one at zero.
template <class Size>
std::vector<std::size_t> fitting(const PlotScale& scale, double length, double apart, Size sizeOf) {
  const std::vector<double>& ticks = scale.ticks;
  const auto zero = std::find(ticks.begin(), ticks.end(), 0.0);
  const std::size_t kept = zero == ticks.end() ? 0 : static_cast<std::size_t>(zero - ticks.begin());
  for (std::size_t every = 1; every < ticks.size(); ++every) {
    std::vector<std::size_t> labelled;
    double end = -std::numeric_limits<double>::infinity();
    for (std::size_t i = kept % every; i < ticks.size(); i += every) {
      const double middle = scale.positionOf(ticks[i]) * length, half = 0.5 * sizeOf(ticks[i]);
      if (middle - half < end) break;
      end = middle + half + apart;
      labelled.push_back(i);
    }
    if (labelled.size() == (ticks.size() - kept % every + every - 1) / every) return labelled;
  }
  return ticks.empty() ? std::vector<std::size_t>{} : std::vector<std::size_t>{kept};
}

}  // namespace

PlotLayout::PlotLayout(const Plot& plot, const QRectF& area, const QFontMetricsF& metrics)
    : m_x(scaleOf(plot, plot.x, [](const QPointF& p) { return p.x(); })),
      m_y(scaleOf(plot, plot.y, [](const QPointF& p) { return p.y(); })) {
  const double line = metrics.height(), gap = 0.5 * line;
  const bool hasLegend = plot.series.size() > 1;
  const double left = widestLabel(m_y, plot.locale, metrics) + gap;
  const double bottom = gap + line + gap + line;
  const double top = 3.0 * line + (hasLegend ? 1.2 * line * static_cast<double>(plot.series.size()) : 0.0);
  m_frame = area.adjusted(gap + left, gap + top, -2.0 * gap, -gap - bottom);
}

std::vector<std::size_t> PlotLayout::labelledTicks(const QLocale& locale, const QFontMetricsF& metrics) const {
  return fitting(m_x, m_frame.width(), 0.4 * metrics.height(),
                 [&](double tick) { return metrics.horizontalAdvance(tickLabel(tick, m_x, locale)); });
}

std::vector<std::size_t> PlotLayout::labelledRows(const QFontMetricsF& metrics) const {
  return fitting(m_y, m_frame.height(), 0.0, [&](double) { return metrics.height(); });
}

QPointF PlotLayout::toScreen(const QPointF& value) const {
  return {m_frame.left() + m_x.positionOf(value.x()) * m_frame.width(),
          m_frame.bottom() - m_y.positionOf(value.y()) * m_frame.height()};
}

bool PlotLayout::isShown(const QPointF& value) const {
  constexpr double kFar = 1e6;  // pixels; a logarithm gives NaN outside of its domain
  const QPointF screen = toScreen(value);
  return std::abs(screen.x()) < kFar && std::abs(screen.y()) < kFar;
}

std::optional<PlotLayout::Reading> PlotLayout::readingAt(const Plot& plot, const QPointF& screen, double reach) const {
  std::optional<Reading> reading;
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    for (std::size_t i = 0; i < plot.series[s].points.size(); ++i) {
      if (!isShown(plot.series[s].points[i])) continue;
      const QPointF d = toScreen(plot.series[s].points[i]) - screen;
      const double distance = std::hypot(d.x(), d.y());
      if (distance > reach) continue;
      reach = distance;
      reading = Reading{s, i};
    }
  }
  return reading;
}

QString axisTitle(const PlotAxis& axis) {
  return axis.unit.isEmpty() ? axis.title : QStringLiteral("%1 (%2)").arg(axis.title, axis.unit);
}

}  // namespace handwheel
