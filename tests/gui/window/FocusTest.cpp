// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QDockWidget>

using namespace handwheel;
using namespace handwheel::test;

// After a command the keys are those of the view: Space must not press a button that nobody chose.
class FocusTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  // Four holes of four edges each, and a torus beside it that is whole.
  void open(WindowDriver& driver) {
    writeStl(m_folder.filePath("other.stl"), quadTorus(12, 8, {}));
    writeStl(m_folder.filePath("holes.stl"), quadTorus(48, 24, {{0, 3}, {6, 3}, {12, 3}, {18, 3}}));
    QVERIFY(driver.open(m_folder.filePath("other.stl")));
    QVERIFY(driver.open(m_folder.filePath("holes.stl")));
    driver.window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&driver.window()));
  }
  static bool isInView(WindowDriver& driver) {
    return driver.window().focusWidget() == driver.find<QWidget>("viewport");
  }
  void selectHole(WindowDriver& driver) {
    driver.clickDefect(DefectKind::Hole, 0);
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QAction>("fillHole")->isEnabled(), kPatienceMs);
  }

  // Clicks like a user: the effect of the press is complete before the release.
  static void clickSlowly(QAbstractButton* button) {
    QTest::mousePress(button, Qt::LeftButton);
    QTest::qWait(50);
    QTest::mouseRelease(button, Qt::LeftButton);
  }

 private slots:
  void afterFillByButton() {
    WindowDriver driver;
    open(driver);
    selectHole(driver);
    clickSlowly(driver.find<QAbstractButton>("fillHoleButton"));
    QVERIFY(driver.settle());
    QTRY_VERIFY(isInView(driver));
    QCOMPARE(driver.count(DefectKind::Hole), 3);
    QTest::keyClick(driver.window().focusWidget(), Qt::Key_Space);
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
  }

  void afterFillByKey() {
    WindowDriver driver;
    open(driver);
    selectHole(driver);
    driver.find<QWidget>("viewport")->setFocus();
    QTest::keyClick(driver.window().focusWidget(), Qt::Key_Return);
    QVERIFY(driver.settle());
    QCOMPARE(driver.count(DefectKind::Hole), 3);
    QTRY_VERIFY(isInView(driver));
  }

  // A button that was reached by Tab and pressed loses the focus when it is disabled: to the view, not to the next
  // button.
  void whenTheFocusedButtonIsDisabled() {
    WindowDriver driver;
    open(driver);
    auto* button = driver.find<QAbstractButton>("repairAllButton");
    QTRY_VERIFY(button->isVisible() && button->isEnabled());
    button->setFocus(Qt::TabFocusReason);
    QVERIFY(button->hasFocus());
    QTest::keyClick(button, Qt::Key_Space);
    QVERIFY(driver.settle());
    QTRY_VERIFY(!button->isEnabled());
    QTRY_VERIFY(isInView(driver));
  }

  // A field that is being edited hears of it when a button is clicked: its value counts.
  void afterAFieldWasEdited() {
    WindowDriver driver;
    driver.choose("openShaftSample");
    QVERIFY(driver.settle());
    driver.window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&driver.window()));
    driver.find<QDockWidget>("propertiesDock")->raise();
    auto* row = driver.find<QWidget>("property/diameter");
    auto* line = row->findChild<QLineEdit*>();
    QTRY_VERIFY(line->isVisible());
    line->setFocus(Qt::MouseFocusReason);
    line->selectAll();
    QTest::keyClicks(line, "33");
    auto* button = driver.window().findChild<QAbstractButton*>("dockMenu");
    for (auto* each : driver.window().findChildren<QAbstractButton*>()) {
      if (!button && each->isVisible() && each->isEnabled() && each->isCheckable()) button = each;
    }
    QVERIFY(button);
    clickSlowly(button);
    QTRY_VERIFY(isInView(driver));
    QTRY_VERIFY(driver.find<QAction>("undo")->isEnabled());
  }

  // By Tab one may stay on a button as long as it is one.
  void tabStaysWhereItLeads() {
    WindowDriver driver;
    open(driver);
    auto* button = driver.find<QAbstractButton>("repairAllButton");
    QTRY_VERIFY(button->isVisible() && button->isEnabled());
    button->setFocus(Qt::TabFocusReason);
    QTest::qWait(50);
    QVERIFY(button->hasFocus());
  }

  void closingATabIsNoStopOfTab() {
    WindowDriver driver;
    open(driver);
    for (const auto* close : driver.window().findChildren<QAbstractButton*>("closeTab"))
      QCOMPARE(close->focusPolicy(), Qt::NoFocus);
  }
};

HANDWHEEL_WINDOW_TEST(FocusTest)
#include "FocusTest.moc"
