// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CellWindow.h"
#include "WindowTestMain.h"

#include <QComboBox>
#include <QInputDialog>
#include <QTreeWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The sample cell's robot, and beside it one of the library.
class TwoRobotsWindow : public CellWindow {
 public:
  QTreeWidget* tree() { return find<QTreeWidget>("planTree"); }
  QComboBox* box() { return find<QComboBox>("armBox"); }
  void addBuiltIn() {
    choose("addBuiltInRobot");
    auto* dialog = find<QInputDialog>("builtInRobotDialog");
    dialog->setTextValue("Universal Robots UR5");
    dialog->accept();
  }
  // The row of a robot in the list of what is planned.
  QTreeWidgetItem* robot(int number) { return tree()->topLevelItem(3)->child(number); }
};

}  // namespace

// Several robots in the window: added, chosen, moved, removed.
class CellRobotsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void addChooseMoveRemove() {
    TwoRobotsWindow driver;
    QVERIFY(!driver.find<QAction>("removeRobot")->isEnabled());
    QVERIFY(driver.box()->isHidden());
    driver.addBuiltIn();
    QTRY_COMPARE_WITH_TIMEOUT(driver.box()->count(), 2, kPatienceMs);
    QVERIFY(!driver.box()->isHidden());
    QVERIFY(driver.settle());
    const double x = driver.field("tool.x").split(' ').front().toDouble();
    // The other one is planned for: the pose of its tool is in the panel.
    driver.box()->setCurrentIndex(1);
    emit driver.box()->activated(1);
    QVERIFY(driver.settle());
    QVERIFY(std::abs(driver.field("tool.x").split(' ').front().toDouble() - x) > 1.0);
    driver.edit("joint.ur5_joint_1", "45");
    driver.choose("storeConfiguration");
    // Its base is typed; a double click on the first one goes back to that.
    driver.tree()->setCurrentItem(driver.robot(1));
    driver.edit("robot.ur5.y", "1500");
    QCOMPARE(driver.field("robot.ur5.y").split(' ').front().toDouble(), 1500.0);
    driver.tree()->setCurrentItem(driver.robot(0));
    driver.choose("chooseRobot");
    QCOMPARE(driver.box()->currentIndex(), 0);
    // It goes with its configuration, and both come back.
    driver.tree()->setCurrentItem(driver.robot(1));
    driver.choose("removePlan");
    QCOMPARE(driver.box()->count(), 1);
    QCOMPARE(driver.tree()->topLevelItem(0)->childCount(), 0);
    driver.click("quickActions/undo");
    QCOMPARE(driver.box()->count(), 2);
    QCOMPARE(driver.tree()->topLevelItem(0)->childCount(), 1);
  }
};

HANDWHEEL_WINDOW_TEST(CellRobotsWindowTest)
#include "CellRobotsWindowTest.moc"
