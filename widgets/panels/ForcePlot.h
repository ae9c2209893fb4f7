// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/ForceTrace.h"
#include "plot/PlotWidget.h"

namespace handwheel {

struct ServoSample;

// The force against time, as it was asked for and as it was sent to the motors: what lies between the two the safety
// chain has taken. It holds still while somebody reads a point, and draws nothing while it is hidden.
class ForcePlot : public PlotWidget {
  Q_OBJECT

 public:
  explicit ForcePlot(QWidget* parent = nullptr);

  // The gain is that of the mapping, from newtons in the scene to newtons at the device.
  void showSample(const ServoSample& sample, double forceGain);
  void clear();

  const ForceTrace& trace() const { return m_trace; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void draw();

  ForceTrace m_trace;
  double m_drawn = 0.0;    // s: the last point of the picture
  bool m_isStill = false;  // the picture
};

}  // namespace handwheel
