// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plot/PlotWidget.h"

namespace handwheel {

// A plot over a time axis with a line at the present position. Dragging moves the line.
class TimePlot : public PlotWidget {
  Q_OBJECT

 public:
  explicit TimePlot(QWidget* parent = nullptr);

  void showCurves(Plot plot);         // to be used instead of setPlot()
  void setPosition(double position);  // units of x

  // Convert between positions on the axis and pixels of this widget.
  double screenX(double position) const;
  double positionAt(double screenX) const;

  QSize sizeHint() const override { return {480, 200}; }
  QSize minimumSizeHint() const override { return {200, 190}; }

 signals:
  void positionWanted(double position);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  const PlotLayout& layoutOfAxis() const;

  double m_position = 0.0;
  mutable std::optional<PlotLayout> m_layout;  // layout for the present plot and size
};

}  // namespace handwheel
