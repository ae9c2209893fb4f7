// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"

#include <QComboBox>
#include <QPushButton>
#include <QTableWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A window with the sample cell, and the dock that measures its distance queries.
class ProximityWindow : public WindowDriver {
 public:
  ProximityWindow() {
    choose("openCellSample");
    if (!settle()) qFatal("the sample does not open");
    choose("proximityDockToggle");
  }
  QComboBox* scenario() { return find<QComboBox>("proximityScenario"); }
  QTableWidget* table() { return find<QTableWidget>("proximityTable"); }
  QPushButton* measure() { return find<QPushButton>("proximityMeasure"); }
  QPushButton* cancel() { return find<QPushButton>("proximityCancel"); }
  double number(int row, int column) { return QLocale().toDouble(table()->item(row, column)->text()); }
  bool measures(const char* result) {
    QTest::mouseClick(measure(), Qt::LeftButton);
    return QTest::qWaitFor([&] { return measure()->isEnabled() && text("proximityText").contains(result); },
                           kPatienceMs);
  }
};

}  // namespace

// The costs of the distance queries, as a person measures them in the window.
class CellProximityWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // The robot of the sample stands apart from its table, and gets into all three scenarios.
  void scenarios() {
    ProximityWindow driver;
    QVERIFY(driver.find<QDockWidget>("proximityDock")->isVisible());
    QCOMPARE(driver.table()->item(0, 0)->text(), QStringLiteral("—"));
    QVERIFY(!driver.cancel()->isEnabled());
    for (int scenario = 0; scenario <= 3; ++scenario) {
      driver.scenario()->setCurrentIndex(scenario);
      const QByteArray result = "Scenario " + QByteArray::number(std::max(1, scenario));
      QVERIFY2(driver.measures(result), qPrintable(driver.text("proximityText")));
      for (int row = 0; row < 4; ++row) {
        QVERIFY(driver.number(row, 0) > 0.0 && driver.number(row, 1) >= driver.number(row, 0));
        QVERIFY(driver.number(row, 2) >= 0.0);
      }
      QVERIFY(driver.number(0, 3) > 0.0);  // the closest points take pairs in any scenario
    }
    QVERIFY(driver.text("proximityText").contains("colliding"));
    // A change of the cell is said, and where it stands may be called near by another tolerance.
    driver.edit("joint.joint_1", "10");
    QVERIFY(driver.text("proximityText").contains("changed since"));
    driver.scenario()->setCurrentIndex(0);
    driver.edit("tolerance", "5000");
    QVERIFY(driver.measures("Scenario 2"));
    QVERIFY(!driver.text("proximityText").contains("changed since"));
  }

  // A measurement that is cancelled leaves what was there; closing the dock and another document are no matter.
  void cancelled() {
    ProximityWindow driver;
    driver.scenario()->setCurrentIndex(2);
    QTest::mouseClick(driver.measure(), Qt::LeftButton);
    QVERIFY(driver.cancel()->isEnabled() && !driver.measure()->isEnabled());
    QTest::mouseClick(driver.cancel(), Qt::LeftButton);
    QVERIFY(driver.settle());
    QVERIFY(driver.measure()->isEnabled() && !driver.cancel()->isEnabled());
    QVERIFY(driver.text("proximityText").contains("Nothing is measured yet"));
    QTest::mouseClick(driver.measure(), Qt::LeftButton);
    driver.choose("proximityDockToggle");
    QVERIFY(!driver.find<QDockWidget>("proximityDock")->isVisible());
    driver.choose("openRobotSample");
    QVERIFY(driver.settle());
    driver.choose("proximityDockToggle");
    QVERIFY(driver.text("proximityText").contains("Nothing is measured yet"));
    driver.scenario()->setCurrentIndex(3);
    QVERIFY(driver.measures("does not get into scenario 3"));  // there is no obstacle
    QCOMPARE(driver.table()->item(3, 3)->text(), QStringLiteral("—"));
  }
};

HANDWHEEL_WINDOW_TEST(CellProximityWindowTest)
#include "CellProximityWindowTest.moc"
