// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/workpiece/ManualLatheTool.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace handwheel {

// A line that shows the figures of a cut on a manual lathe. The figures are force, power and torque with the limits of
// the machine, speeds, depth, feed, and the formula by which the force is computed. It must be used on the window
// thread.
class LatheReadout : public QWidget {
  Q_OBJECT

 public:
  explicit LatheReadout(QWidget* parent = nullptr);

  // Shows the present figures. Those beyond a limit of the exercise, where its marks are lost, or of the machine are
  // red.
  void show(const ManualLatheTool& tool);

 private:
  QLabel* cell(QHBoxLayout& line, const QString& name, const char* id, const QString& widest, const QString& tip);
  void showLaw(const ManualLatheTool& tool, const LatheMoment& now);
  void showLimited(QLabel& label, double value, double limit, int digits, const QString& unit);

  QLabel* m_force;
  QLabel* m_power;
  QLabel* m_torque;
  QLabel* m_spindle;
  QLabel* m_speed;
  QLabel* m_depth;
  QLabel* m_feed;
  QLabel* m_roughness;
  QLabel* m_law;
};

}  // namespace handwheel
