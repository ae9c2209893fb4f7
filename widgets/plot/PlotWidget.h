// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plot/Plot.h"
#include "plot/PlotLayout.h"

#include <QWidget>
#include <optional>

namespace handwheel {

// A widget that shows a plot with a read-out. The point nearest to the cursor is marked and its values are shown. The
// left and right arrow keys move along the points, the up and down keys between the series. Escape hides the read-out.
class PlotWidget : public QWidget {
  Q_OBJECT

 public:
  explicit PlotWidget(QWidget* parent = nullptr);

  void setPlot(Plot plot);
  const Plot& plot() const { return m_plot; }

  // Returns the displayed read-out: "sphere: 10 ms, 0.05 mm". The result is empty if no point is read out.
  QString reading() const;

  QSize sizeHint() const override;

 signals:
  void readingChanged(const QString& reading);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  PlotLayout layoutNow() const;
  void read(std::optional<PlotLayout::Reading> reading);
  // Returns the next displayable point, starting from a reading in the given direction.
  std::optional<PlotLayout::Reading> neighbour(PlotLayout::Reading from, int alongSeries, int alongPoints) const;

  Plot m_plot;
  std::optional<PlotLayout::Reading> m_reading;
};

}  // namespace handwheel
