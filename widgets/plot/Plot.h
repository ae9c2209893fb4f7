// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QLocale>
#include <QPointF>
#include <QString>
#include <vector>

namespace handwheel {

// What a plot shows: a value, as every part of the window that draws curves makes one. All texts come from the caller.
struct PlotAxis {
  QString title;                   // "CPU time of a fill"
  QString unit;                    // "ms"; shown in brackets behind the title
  bool logarithmic = false;        // where all values are above zero; else it is linear all the same
  std::vector<double> shown = {};  // values that lie on it whatever the series have
};

struct PlotSeries {
  QString name;
  std::vector<QPointF> points;    // in units of the axes; those that are not finite are left out
  bool joined = true;             // by lines, in order
  double barWidth = 0.0;          // above zero: drawn as bars so wide, in units of x, instead
  std::vector<QColor> bars = {};  // their colours; none: that of the series
  bool dotted = true;             // each point has its shape; false for a line of too many to be told apart
};

// A point with words beside it.
struct PlotMark {
  QPointF place;
  QString label;
};

struct Plot {
  QString title;
  PlotAxis x, y;
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks;
  QLocale locale = QLocale::c();  // of the numbers at the axes
};

}  // namespace handwheel
