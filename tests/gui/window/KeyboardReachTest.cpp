// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../controls/Accessibility.h"
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>

using namespace handwheel;
using namespace handwheel::test;

// Whoever has no mouse reaches all that the window offers.
class KeyboardReachTest : public QObject {
  Q_OBJECT

 private:
  static bool isInMenus(const MainWindow& window, const QAction* action) {
    const QList<QMenu*> menus = window.findChildren<QMenu*>();
    return std::any_of(menus.begin(), menus.end(), [&](const QMenu* m) { return m->actions().contains(action); });
  }
  // Buttons of commands that stand in the menus too, which Alt and F10 open; the tabs of docks, whose panels the View
  // menu brings forward; and what closes a tab, as the File menu closes its document.
  static QStringList notReached(MainWindow& window) {
    return notReachedByTab(window, [&window](const QWidget* widget) {
      if (qobject_cast<const QMenuBar*>(widget)) return true;
      const auto* button = qobject_cast<const QToolButton*>(widget);
      if (button && button->defaultAction()) return isInMenus(window, button->defaultAction());
      return widget->objectName() == QLatin1String("dockTabs") || widget->objectName() == QLatin1String("closeTab");
    });
  }

 private slots:
  void fromTheStart() {
    WindowDriver driver;
    QCOMPARE(notReached(driver.window()).join('\n'), QString());
  }

  void withADocument_data() {
    QTest::addColumn<QString>("sample");
    for (const char* sample : {"openSample", "openShaftSample", "openRobotSample"}) QTest::newRow(sample) << sample;
  }
  void withADocument() {
    QFETCH(QString, sample);
    WindowDriver driver;
    driver.choose(qPrintable(sample));
    QVERIFY(driver.settle());
    for (const char* panel : {"kindDock", "toolDock", "propertiesDock", "viewDock"}) {
      driver.find<QDockWidget>(panel)->raise();
      QTRY_VERIFY(!driver.find<QDockWidget>(panel)->visibleRegion().isEmpty());
      QCOMPARE(notReached(driver.window()).join('\n'), QString());
    }
  }
};

HANDWHEEL_WINDOW_TEST(KeyboardReachTest)
#include "KeyboardReachTest.moc"
