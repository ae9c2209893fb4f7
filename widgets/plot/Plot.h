// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QLocale>
#include <QPointF>
#include <QString>
#include <vector>

namespace handwheel {

// An axis of a plot. The structs of a plot are plain values, created by every part of the window that draws curves. All
// texts come from the caller.
struct PlotAxis {
  QString title;                   // "CPU time of a fill"
  QString unit;                    // "ms"; shown in parentheses after the title
  bool logarithmic = false;        // logarithmic if all values are above zero, else linear
  std::vector<double> shown = {};  // values that the axis includes in any case
};

// A series of points, drawn as a line or as bars.
struct PlotSeries {
  QString name;
  // The points in units of the axes. Points that are not finite are omitted, and interrupt lines without markers.
  std::vector<QPointF> points;
  bool joined = true;             // the points are connected by lines, in order
  double barWidth = 0.0;          // if above zero, the points are drawn as bars of this width, in units of x
  std::vector<QColor> bars = {};  // colours of the bars; empty: the colour of the series
  bool dotted = true;             // each point has a marker; false for lines with too many points
};

// An annotated point of a plot.
struct PlotMark {
  QPointF position;
  QString label;
};

// The complete description of a plot.
struct Plot {
  QString title;
  PlotAxis x, y;
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks;
  QLocale locale = QLocale::c();  // locale of the axis labels
};

}  // namespace handwheel
