// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/workpiece/ManualLatheTool.h"
#include "window/workpiece/LatheWheels.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QLabel;
class QPushButton;

namespace handwheel {

class LatheEvents;
class LatheReadout;
class NumberField;
class ToolPostRow;

// The controls and displays of a manual lathe. Levers and handwheels are in sections that fold, with its read-out, the
// figures of the cut, its crashes and warnings. Controls emit commands; show() displays the state. Window thread.
class LathePanel : public QWidget {
  Q_OBJECT

 public:
  explicit LathePanel(QWidget* parent = nullptr);

  // Prepares the panel for a tool: sets the rings of the dials, none: to zero. touch: the number for touching off.
  void begin(const ManualLatheTool& tool, const std::optional<LatheWheels::Rings>& rings, double touch);
  LatheWheels::Rings rings() const { return m_wheels->rings(); }
  double touchValue() const;  // the entered number for touching off, mm
  // Updates the display. To be called some times a second while the lathe runs.
  void show(const ManualLatheTool& tool);

 signals:
  void commanded(const handwheel::LatheCommand& command);
  void touchOffRequested(bool isX, double value);  // mm, X as displayed
  void folded();                                   // the panel needs more or less room than before
  void mountRequested(const QString& tool);        // id, for the side of the post in use; empty: none

 private:
  QWidget* section(const QString& title, const char* name, QWidget& content, bool isOpenAtFirst);
  QWidget* makeReadout();
  QWidget* makeTouchingOff();
  QWidget* makeSpindle();
  QWidget* makeSurfaceSpeed();
  QWidget* makeFeed();
  QWidget* makeThreadAndRapid();
  QPushButton* button(const QString& text, const char* name, const QString& tip);
  // meaning: zero and direction of the number; remedy: advice while there is no zero.
  void showAxis(QLabel& label, const QString& axis, const QString& read, const QString& meaning, const QString& remedy);
  void sendSpeed();
  void sendFeed(int direction);

  ToolPostRow* m_post;
  QLabel* m_x;
  QLabel* m_z;
  NumberField* m_touch;
  QPushButton* m_touchX;
  QButtonGroup* m_spindle;
  NumberField* m_speed;
  QCheckBox* m_isConstant;
  NumberField* m_surface;
  NumberField* m_clamp;
  NumberField* m_feed;
  QButtonGroup* m_feedDirections;
  NumberField* m_lead;
  QPushButton* m_isLeft;  // left-hand thread
  QPushButton* m_nut;
  LatheWheels* m_wheels;
  LatheReadout* m_figures;
  LatheEvents* m_events;
  QLabel* m_latest;  // the latest event
};

}  // namespace handwheel
