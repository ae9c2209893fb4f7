// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "DeviceScenes.h"

#include <QLabel>
#include <QTabWidget>
#include <QTest>

namespace handwheel::test {

// A fixture with a device panel that is visible and has the focus.
struct DevicePanelFixture {
  DevicePanelFixture() {
    panel.resize(300, 680);
    panel.show();
    panel.activateWindow();
    if (!QTest::qWaitForWindowActive(&panel)) qFatal("the panel does not appear");
  }
  template <class Widget>
  Widget* part(const char* name) {
    return panel.findChild<Widget*>(name);
  }
  QString text(const char* label) { return part<QLabel>(label)->text(); }
  void turnTo(int page) { part<QTabWidget>("devicePages")->setCurrentIndex(page); }

  DevicePanel panel;
};

}  // namespace handwheel::test
