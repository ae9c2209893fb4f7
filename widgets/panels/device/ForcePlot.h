// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/device/ForceTrace.h"
#include "plot/PlotWidget.h"

namespace handwheel {

struct ServoSample;

// A plot of the requested and the sent force against time. They differ because of the safety chain. The plot freezes
// while the user reads a point, and does not draw while it is hidden.
class ForcePlot : public PlotWidget {
  Q_OBJECT

 public:
  explicit ForcePlot(QWidget* parent = nullptr);

  // Adds a sample. forceGain: the gain of the mapping from newtons in the scene to newtons at the device.
  void showSample(const ServoSample& sample, double forceGain);
  void clear();

  const ForceTrace& trace() const { return m_trace; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void draw();

  ForceTrace m_trace;
  double m_drawn = 0.0;    // s: time of the last drawn point
  bool m_isStill = false;  // the drawn picture does not change with time
};

}  // namespace handwheel
