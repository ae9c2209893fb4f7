// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plot/Plot.h"
#include "plot/PlotScale.h"

#include <QFontMetricsF>
#include <QRectF>
#include <optional>

namespace handwheel {

// The layout of a plot in a rectangle of the screen or page. Shared by painting and by the cursor read-out.
class PlotLayout {
 public:
  PlotLayout(const Plot& plot, const QRectF& area, const QFontMetricsF& metrics);

  const QRectF& frame() const { return m_frame; }  // the rectangle between the axes
  const PlotScale& x() const { return m_x; }
  const PlotScale& y() const { return m_y; }

  // Returns the indices of the x ticks whose labels fit side by side below the frame: each second or third if
  // necessary, including the one at zero.
  std::vector<std::size_t> labelledTicks(const QLocale& locale, const QFontMetricsF& metrics) const;

  // Returns the indices of the y ticks whose labels fit above each other beside the frame, chosen likewise.
  std::vector<std::size_t> labelledRows(const QFontMetricsF& metrics) const;

  QPointF toScreen(const QPointF& value) const;
  bool isShown(const QPointF& value) const;  // finite, and above zero on a logarithmic axis

  // The point of a series nearest to a screen position, if one is within reach (pixels).
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
