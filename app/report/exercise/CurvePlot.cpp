// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/exercise/CurvePlot.h"

#include <QCoreApplication>

namespace handwheel {
namespace {

QString figureWord(const std::string& text) {
  return QCoreApplication::translate("Figure", text.c_str());
}

}  // namespace

Plot plotOf(const ReportCurve& curve) {
  Plot plot;
  plot.title = figureWord(curve.title);
  plot.locale = QLocale();
  plot.x = {figureWord(curve.x), QString::fromStdString(curve.xUnit)};
  plot.y = {figureWord(curve.y), QString::fromStdString(curve.yUnit)};
  for (const ReportCurve::Series& each : curve.series) {
    PlotSeries series;
    series.name = figureWord(each.name);
    series.dotted = false;
    for (const auto& [x, y] : each.points) series.points.emplace_back(x, y);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace handwheel
