// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../haptics/TurningWindow.h"
#include "controls/NumberField.h"
#include "controls/machine/HandwheelDial.h"
#include "tools/workpiece/ManualLatheTool.h"
#include "window/tools/ToolHost.h"

#include <QDockWidget>
#include <cmath>
#include <numbers>

namespace handwheel::test {

// A window with a new bar of 50 × 100 mm in the manual lathe.
struct LatheWindow : TurningWindow {
  using TurningWindow::TurningWindow;

  bool beginLathe() {
    driver.choose("newWorkpiece");
    if (!driver.settle()) return false;
    driver.find<QAction>("latheTool")->trigger();
    if (!driver.settle() || !lathe()) return false;
    view->setFocus();
    return rests() && driver.find<QDockWidget>("latheDock")->isVisible();
  }
  ToolHost& tools() { return *driver.window().findChild<ToolHost*>(); }
  const ManualLatheTool* lathe() { return dynamic_cast<const ManualLatheTool*>(tools().runner().tool()); }
  LatheState machine() { return lathe()->moment()->machine; }
  double slide(LatheAxis axis) { return machine().slides[static_cast<std::size_t>(axis)]; }
  bool comesTo(LatheAxis axis, double mm, double within = 1e-6) {
    return QTest::qWaitFor([&] { return std::abs(slide(axis) - mm) < within; }, kPatienceMs);
  }
  HandwheelDial& dial(const char* name) { return *driver.find<HandwheelDial>(name); }
  // Turns a handwheel with the mouse by this number of turns, clockwise if it is positive.
  void crank(HandwheelDial& wheel, double turns) {
    const auto at = [&wheel](double degrees) {
      const double angle = degrees * std::numbers::pi / 180.0;
      return (wheel.centre() + QPointF(50.0 * std::sin(angle), -50.0 * std::cos(angle))).toPoint();
    };
    const int steps = static_cast<int>(std::lround(std::abs(turns) * 36.0));
    QTest::mousePress(&wheel, Qt::LeftButton, {}, at(0.0));
    for (int i = 1; i <= steps; ++i) {
      const QPoint to = at(std::copysign(10.0 * i, turns));
      QMouseEvent move(QEvent::MouseMove, to, wheel.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&wheel, &move);
    }
    QTest::mouseRelease(&wheel, Qt::LeftButton, {}, at(360.0 * turns));
  }
  // Cuts 2 mm off the radius over some millimetres of the end, by keys and the automatic feed. feed: mm per
  // revolution. The default needs less than the power of the spindle: π · (25² - 23²) mm² · 2 mm/s · 3 J/mm³ = 1.8 kW
  // of 3 kW.
  bool turnEnd(double feed = 0.2) {
    driver.find<NumberField>("latheFeed")->setValue(feed);
    QTest::keyClick(view, Qt::Key_Space);
    for (int i = 0; i < 9; ++i) QTest::keyClick(view, Qt::Key_Left, Qt::ShiftModifier);  // 2 mm each
    for (int i = 0; i < 5; ++i) QTest::keyClick(view, Qt::Key_Left);                     // 0.2 mm each
    for (int i = 0; i < 110; ++i) QTest::keyClick(view, Qt::Key_Up, Qt::ShiftModifier);  // 0.2 mm each
    if (!comesTo(LatheAxis::Carriage, 101.0) || !comesTo(LatheAxis::Cross, 23.0)) return false;
    driver.click("latheFeedLeft");
    const auto isCut = [this] { return lathe()->moment()->isCut && slide(LatheAxis::Carriage) < 98.0; };
    return QTest::qWaitFor(isCut, kPatienceMs);
  }
};

}  // namespace handwheel::test
