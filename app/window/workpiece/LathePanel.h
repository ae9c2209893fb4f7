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

// The controls and displays of a manual lathe. Levers and handwheels in sections that fold, its read-out, the figures
// of the cut, its crashes and warnings. What is done comes out as commands; what the lathe does is shown by show().
// Window thread.
class LathePanel : public QWidget {
  Q_OBJECT

 public:
  explicit LathePanel(QWidget* parent = nullptr);

  // A tool has begun: the rings of the dials are set to these, none: to zero. touch: the number for touching off.
  void begin(const ManualLatheTool& tool, const std::optional<LatheWheels::Rings>& rings, double touch);
  LatheWheels::Rings rings() const { return m_wheels->rings(); }
  double touchValue() const;  // the number that was typed for touching off, mm
  // To be called some times a second while the lathe runs.
  void show(const ManualLatheTool& tool);

 signals:
  void commanded(const handwheel::LatheCommand& command);
  void touchOffRequested(bool isX, double value);  // mm, X as it is shown
  void folded();                                   // it needs more or less room than before
  void mountRequested(const QString& tool);        // id, on the side of the post in use; empty: none

 private:
  QWidget* section(const QString& title, const char* name, QWidget& content, bool isOpenAtFirst);
  QWidget* makeReadout();
  QWidget* makeTouchingOff();
  QWidget* makeSpindle();
  QWidget* makeSurfaceSpeed();
  QWidget* makeFeed();
  QWidget* makeThreadAndRapid();
  QPushButton* button(const QString& text, const char* name, const QString& tip);
  // meaning: what the number counts from and in which sense; remedy: what to do while there is no zero.
  void showAxis(QLabel& label, const QString& axis, const QString& read, const QString& meaning, const QString& remedy);
  void sendSpeed();
  void sendFeed(int way);

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
  QButtonGroup* m_feedWays;
  NumberField* m_lead;
  QPushButton* m_isLeft;  // left-hand thread
  QPushButton* m_nut;
  LatheWheels* m_wheels;
  LatheReadout* m_figures;
  LatheEvents* m_events;
  QLabel* m_latest;  // of these
};

}  // namespace handwheel
