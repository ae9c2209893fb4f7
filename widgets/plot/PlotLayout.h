// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plot/Plot.h"
#include "plot/PlotScale.h"

#include <QFontMetricsF>
#include <QRectF>
#include <optional>

namespace handwheel {

// The layout of a plot in a rectangle of the screen or page. It is shared by painting and the cursor read-out.
class PlotLayout {
 public:
  PlotLayout(const Plot& plot, const QRectF& area, const QFontMetricsF& metrics);

  const QRectF& frame() const { return m_frame; }  // the rectangle between the axes
  const PlotScale& x() const { return m_x; }
  const PlotScale& y() const { return m_y; }

  // Returns the indices of the x ticks whose labels fit side by side below the frame: every second or third tick if
  // necessary, including the tick at zero.
  std::vector<std::size_t> labelledTicks(const QLocale& locale, const QFontMetricsF& metrics) const;

  // Returns the indices of the y ticks whose labels fit above each other beside the frame, chosen by the same rule as
  // the x ticks.
  std::vector<std::size_t> labelledRows(const QFontMetricsF& metrics) const;

  QPointF toScreen(const QPointF& value) const;
  bool isShown(const QPointF& value) const;  // true if the value is finite, and above zero on a logarithmic axis

  // A point of a series that is displayed in the read-out.
  struct Reading {
    std::size_t series;
    std::size_t point;
    bool operator==(const Reading&) const = default;
  };
  std::optional<Reading> readingAt(const Plot& plot, const QPointF& screen, double reach) const;

 private:
  PlotScale m_x, m_y;
  QRectF m_frame;
};

// Returns the text "title (unit)".
QString axisTitle(const PlotAxis& axis);

}  // namespace handwheel
