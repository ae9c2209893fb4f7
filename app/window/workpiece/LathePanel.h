// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/workpiece/ManualLatheTool.h"

#include <QWidget>
#include <array>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace handwheel {

class HandwheelDial;
class LatheEvents;
class LatheFigures;
class NumberField;

// The levers and handwheels of a manual lathe, its read-out, the figures of the cut, its crashes and warnings. What is
// done comes out as commands; what the lathe does is shown by show(). Window thread.
class LathePanel : public QWidget {
  Q_OBJECT

 public:
  explicit LathePanel(QWidget* parent = nullptr);

  // To be called some times a second while the lathe runs.
  void show(const ManualLatheTool& tool);

 signals:
  void commanded(const handwheel::LatheCommand& command);
  void touchOffRequested(bool isX, double value);  // mm, X as it is shown

 private:
  QWidget* makeReadout();
  QWidget* makeTouchingOff();
  QWidget* makeSpindle();
  QWidget* makeSurfaceSpeed();
  QWidget* makeFeed();
  QWidget* makeThread();
  QWidget* makeWheels();
  QPushButton* button(const QString& text, const char* name, const QString& tip);
  void sendSpeed();
  void sendFeed(int way);
  void showTools(const ManualLatheTool& tool);
  void showWheels(const ManualLatheTool& tool);

  QComboBox* m_tools;
  QLabel* m_x;
  QLabel* m_z;
  NumberField* m_touch;
  QButtonGroup* m_spindle;
  NumberField* m_speed;
  QCheckBox* m_isConstant;
  NumberField* m_surface;
  NumberField* m_clamp;
  NumberField* m_feed;
  QButtonGroup* m_feedWays;
  NumberField* m_lead;
  QPushButton* m_nut;
  std::array<HandwheelDial*, kLatheAxes> m_wheels;
  std::array<QLabel*, kLatheAxes> m_captions{};
  std::array<double, kLatheAxes> m_turned{};  // mm, what the dials show
  LatheFigures* m_figures;
  LatheEvents* m_events;
  std::vector<std::string> m_listed;  // ids of the tools in the post
};

}  // namespace handwheel
