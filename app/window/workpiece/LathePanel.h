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

// The controls and displays of a manual lathe. Sections that fold contain the levers and handwheels, the read-out, the
// figures of the cut, and the crashes and warnings. Controls emit commands, and show() displays the state of the lathe.
// It must be used on the window thread.
class LathePanel : public QWidget {
  Q_OBJECT

 public:
  explicit LathePanel(QWidget* parent = nullptr);

  // Prepares the panel for a tool. rings: the adjustable zeros of the handwheel dials (LatheWheels::Rings); none: all
  // dials show zero. touch: the number for touching off, mm.
  void begin(const ManualLatheTool& tool, const std::optional<LatheWheels::Rings>& rings, double touch);
  LatheWheels::Rings rings() const { return m_wheels->rings(); }
  double touchValue() const;  // the entered number for touching off, mm
  // Updates the display. The caller must call it several times a second while the lathe runs.
  void show(const ManualLatheTool& tool);

 signals:
  void commanded(const handwheel::LatheCommand& command);
  void touchOffRequested(bool isX, double value);  // mm, X as displayed
  void folded();                                   // the panel needs more or less room than before
  void mountRequested(const QString& tool);        // id, for the side of the post in use; empty: no tool

 private:
  QWidget* section(const QString& title, const char* name, QWidget& content, bool isOpenAtFirst);
  QWidget* makeReadout();
  QWidget* makeTouchingOff();
  QWidget* makeSpindle();
  QWidget* makeSurfaceSpeed();
  QWidget* makeFeed();
  QWidget* makeThreadAndRapid();
  QPushButton* button(const QString& text, const char* name, const QString& tip);
  // Shows the read-out of an axis. meaning: a text on the zero and the direction of the number; remedy: advice that is
  // shown while there is no zero.
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
