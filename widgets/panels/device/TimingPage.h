// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/device/DeviceInUse.h"
#include "panels/device/TimingPlot.h"

#include <QWidget>
#include <array>

class QComboBox;
class QLabel;

namespace handwheel {

class ServoStatistics;
class PlotWidget;

// The page with the timing of the servo loop. It gives advice when the loop is not real-time.
class TimingPage : public QWidget {
  Q_OBJECT

 public:
  explicit TimingPage(QWidget* parent = nullptr);

  void showLoop(const ServoLoopStatus& loop);
  void showTiming(const ServoStatistics& measure);
  void clear();

 private:
  QWidget* warning();
  void draw();

  QWidget* m_warning;
  QLabel* m_rate;
  QComboBox* m_kind;
  PlotWidget* m_plot;
  QLabel* m_summary;
  std::array<TimingCounts, 3> m_counts{};  // in the order of the combo box
};

}  // namespace handwheel
