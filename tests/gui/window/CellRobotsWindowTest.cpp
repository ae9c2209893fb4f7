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
  // Pixels in which red is far more than the other colours: of what collides, and of an axis.
  int reds() {
    const QImage image = view()->grabImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor pixel = image.pixelColor(x, y);
        count += pixel.red() > 60 && pixel.red() > 3 * pixel.green() && pixel.red() > 3 * pixel.blue() ? 1 : 0;
      }
    }
    return count;
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

  // The robot that is selected goes, not the one that is planned for.
  void removeWhatIsSelected() {
    TwoRobotsWindow driver;
    driver.addBuiltIn();
    QTRY_COMPARE_WITH_TIMEOUT(driver.box()->count(), 2, kPatienceMs);
    QVERIFY(driver.settle());
    driver.tree()->setCurrentItem(driver.robot(0));
    driver.choose("chooseRobot");
    QVERIFY(driver.settle());
    driver.tree()->setCurrentItem(driver.robot(1));
    const QString removed = driver.box()->itemText(1);
    driver.choose("removeRobot");
    QVERIFY(driver.settle());
    QCOMPARE(driver.box()->count(), 1);
    QVERIFY(driver.box()->itemText(0) != removed);
    for (const char* const step : {"undo", "redo", "undo"}) {
      driver.find<QAction>(step)->trigger();
      QVERIFY(driver.settle());
    }
    QCOMPARE(driver.box()->count(), 2);
  }

  // Tools that work with the prepared cell hear of another number of joints before the cell is prepared anew.
  void whileAToolRuns() {
    for (const char* const tool : {"armWaysTool", "leadTool"}) {
      TwoRobotsWindow driver;
      driver.choose("storeConfiguration");
      driver.choose(tool);
      QVERIFY(driver.settle());
      driver.addBuiltIn();
      QTRY_COMPARE_WITH_TIMEOUT(driver.box()->count(), 2, kPatienceMs);
      QVERIFY(driver.settle());
      driver.tree()->setCurrentItem(driver.robot(1));
      driver.choose("chooseRobot");
      QVERIFY(driver.settle());
      for (const char* const step : {"undo", "undo", "redo", "redo"}) {
        driver.find<QAction>(step)->trigger();
        QVERIFY(driver.settle());
      }
      QCOMPARE(driver.box()->currentIndex(), 1);
      driver.choose("removeRobot");
      QCOMPARE(driver.box()->count(), 1);
      QVERIFY(driver.settle());
    }
  }

  // One robot within the other is red, whichever is planned for, and no longer when it stands beside it.
  void whatMeetsIsRed() {
    TwoRobotsWindow driver;
    driver.addBuiltIn();
    QTRY_COMPARE_WITH_TIMEOUT(driver.box()->count(), 2, kPatienceMs);
    QVERIFY(driver.settle());
    driver.showAll();
    QVERIFY(driver.settle());
    const int apart = driver.reds();
    driver.tree()->setCurrentItem(driver.robot(1));
    driver.edit("robot.ur5.x", "0");
    QTRY_VERIFY_WITH_TIMEOUT(driver.reds() > apart + 500, kPatienceMs);
    driver.choose("chooseRobot");
    QVERIFY(driver.settle());
    QTRY_VERIFY_WITH_TIMEOUT(driver.reds() > apart + 500, kPatienceMs);
    driver.tree()->setCurrentItem(driver.robot(1));
    driver.edit("robot.ur5.x", "3000");
    QVERIFY(driver.settle());
    QTRY_VERIFY_WITH_TIMEOUT(driver.reds() <= apart + 100, kPatienceMs);
  }
};

HANDWHEEL_WINDOW_TEST(CellRobotsWindowTest)
#include "CellRobotsWindowTest.moc"
