// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"
#include "panels/HintBar.h"
#include "viewport/camera/CameraNavigation.h"

#include <QComboBox>
#include <QInputDialog>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace handwheel::test {

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
        const QRgb pixel = image.pixel(x, y);
        count += qRed(pixel) > 60 && qRed(pixel) > 3 * qGreen(pixel) && qRed(pixel) > 3 * qBlue(pixel) ? 1 : 0;
      }
    }
    return count;
  }
  // The row of a robot in the list of what is planned.
  QTreeWidgetItem* robot(int number) { return tree()->topLevelItem(3)->child(number); }
};

// A window to which the robot of the library was added at the beginning.
class BesideAnother : public TwoRobotsWindow {
 public:
  BesideAnother() {
    addBuiltIn();
    if (!QTest::qWaitFor([this] { return box()->count() == 2; }, kPatienceMs) || !settle())
      qFatal("the robot is not added");
  }
  void takeBack(const QString& step) {
    TwoRobotsWindow::takeBack(step);
    // No robot is selected.
    tree()->setCurrentItem(tree()->topLevelItem(0));
    if (!settle()) qFatal("the cell is not prepared");
  }
};

}  // namespace handwheel::test

// Several robots in the window: added, chosen, moved, removed.
class CellRobotsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void addChooseMoveRemove() {
    m_window.end();
    TwoRobotsWindow driver;
    driver.setViewSmall(true);
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

  // All paths of both robots are verified, each with the other robot where it stands; a new robot is in view.
  void allRobotsAreVerified() {
    m_window.end();
    TwoRobotsWindow driver;
    driver.addBuiltIn();
    QTRY_COMPARE_WITH_TIMEOUT(driver.box()->count(), 2, kPatienceMs);
    QVERIFY(driver.settle());
    driver.view()->setCamera(driver.view()->camera());  // at once where it flies to
    QVERIFY(!driver.pixelOf("ur5_link_2/0").isNull());
    const auto plan = [&](const char* joint, const char* from, const char* to) {
      driver.edit(joint, from);
      driver.choose("storeConfiguration");
      driver.edit(joint, to);
      driver.choose("storeConfiguration");
      if (!driver.settle()) return;
      driver.choose("planPath");
      QTest::qWait(50);
      QTest::mouseClick(driver.find<QDialog>("planDialog")->findChild<QPushButton*>("planNow"), Qt::LeftButton);
    };
    const auto remark = [&](int path) {
      auto* paths = driver.tree()->topLevelItem(1);
      return paths->childCount() > path ? paths->child(path)->text(1) : QString();
    };
    plan("joint.joint_1", "20", "-20");
    QTRY_VERIFY_WITH_TIMEOUT(remark(0).contains("free"), kPatienceMs);
    driver.box()->setCurrentIndex(1);
    emit driver.box()->activated(1);
    QVERIFY(driver.settle());
    plan("joint.ur5_joint_1", "10", "30");
    QTRY_VERIFY_WITH_TIMEOUT(remark(1).contains("free"), kPatienceMs);
    driver.choose("add-box");
    QVERIFY(driver.settle());
    QVERIFY(remark(0).contains("not verified since"));
    driver.choose("verifyAllPaths");
    QTRY_VERIFY_WITH_TIMEOUT(remark(0).contains("free"), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(remark(1).contains("free"), kPatienceMs);
  }

  // The handles move the base of the selected robot, in one step.
  void placedByHandles() {
    m_window.end();
    TwoRobotsWindow driver;
    driver.addBuiltIn();
    QTRY_COMPARE_WITH_TIMEOUT(driver.box()->count(), 2, kPatienceMs);
    QVERIFY(driver.settle());
    driver.choose("placeTool");
    driver.tree()->setCurrentItem(driver.robot(1));
    driver.view()->setStandardView(StandardView::Front);
    driver.showAll();
    QVERIFY(driver.settle());
    const auto number = [&](const char* field) { return driver.field(field).split(' ').front().toDouble(); };
    const Vec3 base(number("robot.ur5.x"), number("robot.ur5.y"), number("robot.ur5.z"));
    const CameraNavigation navigation(driver.view()->camera(), Vec2(driver.view()->width(), driver.view()->height()));
    const Vec2 at = navigation.toScreen(base);
    const QPoint grip(int(std::lround(at.x())) + 60, int(std::lround(at.y())));
    driver.move(grip);
    QTest::mousePress(driver.view(), Qt::LeftButton, {}, grip);
    driver.move(grip + QPoint(20, 10));
    driver.move(grip + QPoint(60, 20));
    QTest::mouseRelease(driver.view(), Qt::LeftButton, {}, grip + QPoint(60, 20));
    QVERIFY(driver.find<QAction>("undo")->text().contains("Move ur5"));
    QVERIFY(number("robot.ur5.x") > base.x() + 1.0);
    QCOMPARE(number("robot.ur5.y"), base.y());
    driver.click("quickActions/undo");
    QCOMPARE(number("robot.ur5.x"), base.x());
  }

  // While links are dragged the hint names the tool that moves a base; with that tool any link does, and no joint
  // moves.
  void draggedByALink() {
    m_window.end();
    TwoRobotsWindow driver;
    const auto hint = [&] { return driver.find<HintBar>("hintBar")->accessibleName(); };
    QVERIFY(!hint().contains("by its base"));
    driver.addBuiltIn();
    QTRY_COMPARE_WITH_TIMEOUT(driver.box()->count(), 2, kPatienceMs);
    QVERIFY(driver.settle());
    QTRY_VERIFY(hint().contains("Shift+W: move a robot by its base"));
    driver.choose("placeTool");
    driver.view()->setStandardView(StandardView::Top);
    driver.showAll();
    QVERIFY(driver.settle());
    const QPoint link = driver.pixelOf("ur5_link_2/0");
    QVERIFY(!link.isNull());
    driver.tree()->setCurrentItem(driver.robot(1));
    const auto number = [&](const char* field) { return driver.field(field).split(' ').front().toDouble(); };
    const double x = number("robot.ur5.x"), y = number("robot.ur5.y");
    driver.tree()->setCurrentItem(driver.robot(0));  // pressing chooses the other one
    QTest::mousePress(driver.view(), Qt::LeftButton, {}, link);
    driver.move(link + QPoint(20, 0));
    driver.move(link + QPoint(60, 0));
    QTest::mouseRelease(driver.view(), Qt::LeftButton, {}, link + QPoint(60, 0));
    QVERIFY(driver.find<QAction>("undo")->text().contains("Move ur5"));
    QTRY_VERIFY(number("robot.ur5.x") > x + 1.0);
    QCOMPARE(number("robot.ur5.y"), y);
  }

  // Tools that work with the prepared cell hear of another number of joints before the cell is prepared anew.
  void whileAToolRuns() {
    m_window.end();
    TwoRobotsWindow driver;
    driver.setViewSmall(true);
    for (const char* const tool : {"armWaysTool", "leadTool"}) {
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

  // The joints of each robot are in a group of its own; that of the one that is planned for is open.
  void jointsAreGrouped() {
    BesideAnother& driver = m_window.begin();
    const auto isOpen = [&](const char* joint) { return !driver.field(joint).isEmpty(); };
    QVERIFY(isOpen("joint.joint_1") && !isOpen("joint.ur5_joint_1"));
    driver.box()->setCurrentIndex(1);
    emit driver.box()->activated(1);
    QVERIFY(driver.settle());
    QVERIFY(!isOpen("joint.joint_1") && isOpen("joint.ur5_joint_1"));
    driver.click(("propertyGroup/" + driver.box()->itemText(0)).toUtf8().constData());
    QVERIFY(isOpen("joint.joint_1") && isOpen("joint.ur5_joint_1"));
  }

  // The latest selection has its fields in the panel: a body, the robot in the list, a robot in the view.
  void theFieldsOfWhatWasSelectedLast() {
    BesideAnother& driver = m_window.begin();
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.tree()->setCurrentItem(driver.robot(1));
    const auto isOfBody = [&] { return !driver.field("body.1.x").isEmpty(); };
    const auto isOfRobot = [&] { return !driver.field("robot.ur5.x").isEmpty(); };
    QVERIFY(isOfRobot() && !isOfBody());
    driver.clickRow(0);
    QVERIFY(isOfBody() && !isOfRobot());
    const QRect row = driver.tree()->visualItemRect(driver.robot(1));  // Still the current row
    driver.tree()->scrollToItem(driver.robot(1));
    QTest::mouseClick(driver.tree()->viewport(), Qt::LeftButton, {},
                      driver.tree()->visualItemRect(driver.robot(1)).center());
    QVERIFY(!row.isNull() && isOfRobot() && !isOfBody());
    driver.clickRow(0);
    driver.tree()->setCurrentItem(driver.robot(0));
    driver.clickRow(0);
    QVERIFY(isOfBody());
    driver.showAll();
    QVERIFY(driver.settle());
    const QPoint link = driver.pixelOf("ur5_link_2/0");
    QVERIFY(!link.isNull());
    QTest::mouseClick(driver.view(), Qt::LeftButton, {}, link);
    QTRY_VERIFY(isOfRobot() && !isOfBody());
    QVERIFY(driver.tree()->currentItem() == driver.robot(1));
  }

  // The description of the other robot's pairs and states is read for that one.
  void semanticsOfTheSelectedRobot() {
    BesideAnother& driver = m_window.begin();
    QTemporaryDir folder;
    QFile file(folder.filePath("ur5.srdf"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "<robot name='ur5'><disable_collisions link1='link_1' link2='link_3'/>"
        "<group_state name='folded' group='arm'><joint name='joint_2' value='-1'/></group_state></robot>");
    file.close();
    driver.tree()->setCurrentItem(driver.robot(1));
    driver.choose("readSemantics");
    driver.hold();  // a worker reads it
    QVERIFY(driver.enterFileName("readSemanticsDialog", file.fileName()));
    QCOMPARE(driver.tree()->topLevelItem(0)->childCount(), 0);
    driver.release();
    QTRY_VERIFY(driver.text("messageText").contains("was read for ur5"));
    QCOMPARE(driver.tree()->topLevelItem(0)->childCount(), 1);
    QCOMPARE(driver.tree()->topLevelItem(0)->child(0)->text(0), QString("folded"));
    QCOMPARE(driver.tree()->topLevelItem(0)->child(0)->text(1), QString("of ur5"));
  }

  // The robot that is selected goes, not the one that is planned for.
  void removeWhatIsSelected() {
    BesideAnother& driver = m_window.begin();
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

  // One robot within the other is red, whichever is planned for, and no longer when it stands beside it.
  void whatMeetsIsRed() {
    BesideAnother& driver = m_window.begin();
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

 private:
  SharedWindow<BesideAnother> m_window;
};

HANDWHEEL_WINDOW_TEST(CellRobotsWindowTest)
#include "CellRobotsWindowTest.moc"
