// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/workpiece/ManualLatheTool.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace handwheel {

// The figures of a cut on a manual lathe in one line. They are force, power and torque with the limits of the machine,
// speeds, depth, feed, and the law of the force. Window thread.
class LatheReadout : public QWidget {
  Q_OBJECT

 public:
  explicit LatheReadout(QWidget* parent = nullptr);

  // forceLimit: N, of the exercise; 0: none.
  void show(const ManualLatheTool& tool, double forceLimit);

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
