// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "PlanningWindow.h"
#include "panels/time/TimeLinePanel.h"

#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QRegularExpression>
#include <QTabBar>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Places the robot above a block, with the tool for paths along curves. Returns a position in the view where the block
// is seen.
QPoint beforeABlock(PlanningWindow& driver) {
  driver.edit("joint.joint_2", "28.6");
  driver.edit("joint.joint_3", "45.8");
  driver.choose("add-box");
  if (!driver.settle()) return {};
  driver.edit("body.1.x", "500");
  driver.edit("body.1.y", "0");
  driver.edit("body.1.z", "150");
  driver.choose("processTool");
  if (!driver.settle()) return {};
  driver.view()->setStandardView(StandardView::Front);
  driver.showAll();
  return driver.pixelOf("body.1");
}

// Shows the path from 60 to -60 degrees of joint 1 on the time line.
void beginToPlay(PlanningWindow& driver) {
  driver.choose("pathDockToggle");
  QTRY_VERIFY_WITH_TIMEOUT(driver.find<TimeLinePanel>("pathTimeLine")->isEnabled(), kPatienceMs);
}

}  // namespace

// A planner's work in the window: configurations are stored, a path is planned, verified, edited and played.
class CellPlanningWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void storePlanAndUndo() {
    PlanningWindow& driver = withoutPath();
    QVERIFY(!driver.find<QAction>("planPath")->isEnabled());
    driver.storeAt("joint.joint_1", "60");
    driver.storeAt("joint.joint_1", "-60");
    QVERIFY(driver.settle());
    QCOMPARE(driver.configurations()->childCount(), 2);
    driver.planPath();
    QTRY_COMPARE_WITH_TIMEOUT(driver.paths()->childCount(), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(driver.paths()->child(0)->text(1).contains("free"), kPatienceMs);
    driver.click("quickActions/undo");
    QCOMPARE(driver.paths()->childCount(), 0);
    driver.click("quickActions/redo");
    QCOMPARE(driver.paths()->childCount(), 1);
  }

  // The pair that collides at the present configuration may touch from now on, by a list of the pairs found; one undo
  // step.
  void pairsAreAllowed() {
    PlanningWindow& driver = withoutPath();
    driver.choose("add-box");  // At the arm
    QVERIFY(driver.settle());
    driver.edit("body.1.x", "300");
    driver.edit("body.1.y", "0");
    driver.edit("body.1.z", "400");
    driver.edit("body.1.size_z", "800");
    QVERIFY(driver.settle());
    const auto list = [&] { return driver.find<QDialog>("pairsDialog")->findChild<QListWidget*>("pairsList"); };
    const auto close = [&](const char* button) {
      auto* const dialog = driver.find<QDialog>("pairsDialog");
      if (button)
        QTest::mouseClick(dialog->findChild<QPushButton*>(button), Qt::LeftButton);
      else
        dialog->reject();
      return QTest::qWaitFor([dialog = QPointer<QDialog>(dialog)] { return dialog.isNull(); }, kPatienceMs);
    };
    driver.choose("allowPairs");
    const int found = list()->count();
    QVERIFY(found > 0);
    for (int row = 0; row < found; ++row) {
      QVERIFY(list()->item(row)->text().contains("box") && list()->item(row)->checkState() == Qt::Unchecked);
      list()->item(row)->setCheckState(Qt::Checked);
    }
    QVERIFY(close("pairsNow"));
    QVERIFY(driver.settle());
    driver.choose("allowPairs");
    QCOMPARE(list()->count(), found);
    for (int row = 0; row < found; ++row) QCOMPARE(list()->item(row)->checkState(), Qt::Checked);
    QVERIFY(close(nullptr));
    driver.click("quickActions/undo");
    QVERIFY(driver.settle());
    driver.choose("allowPairs");
    QCOMPARE(list()->count(), found);
    for (int row = 0; row < found; ++row) QCOMPARE(list()->item(row)->checkState(), Qt::Unchecked);
    QVERIFY(close(nullptr));
  }

  // With the mouse alone: an edge of a block is pointed to, taken, and the path along it planned.
  void alongAnEdge() {
    PlanningWindow& driver = withoutPath();
    const QPoint middle = beforeABlock(driver);
    QVERIFY(!middle.isNull());
    const auto settings = [&](const char* id) {
      return driver.find<QDockWidget>("toolDock")->findChild<QWidget*>(QStringLiteral("property/") + QLatin1String(id));
    };
    QVERIFY(settings("lead") && settings("standoff") && settings("from"));
    auto* plan = driver.find<QAbstractButton>("toolAction/commit");
    QVERIFY(!plan->isEnabled());
    driver.move(middle);  // its edges are found when it is first pointed to
    QTest::mouseMove(driver.view(), middle);
    QVERIFY(driver.settle());
    QTest::mouseClick(driver.view(), Qt::LeftButton, {}, middle);
    QTRY_VERIFY(plan->isEnabled());
    QTest::keyClick(driver.view(), Qt::Key_Escape);
    QTRY_VERIFY(!plan->isEnabled());
    QTest::mouseClick(driver.view(), Qt::LeftButton, {}, middle);
    QTRY_VERIFY(plan->isEnabled());
    QTest::mouseClick(plan, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(driver.paths()->childCount(), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(driver.paths()->child(0)->text(1).contains("free"), kPatienceMs);
    QCOMPARE(driver.paths()->child(0)->childCount(), 4);  // approach, both ends of the edge, retract
    // Its process is among its fields: slower, and with another approach, each a step that plans it anew.
    driver.choose("jointTool");
    driver.clickItem(driver.paths()->child(0));
    QCOMPARE(driver.field("process.speed").toDouble(), 50.0);
    QVERIFY(driver.field("process.approach").startsWith("50"));
    driver.edit("process.speed", "35");
    QVERIFY(driver.settle());
    QTRY_VERIFY(driver.find<QAction>("undo")->text().contains("Change the process"));
    QCOMPARE(driver.field("process.speed").toDouble(), 35.0);
    driver.tree()->setCurrentItem(driver.paths()->child(0)->child(2));  // the end of the edge
    QCOMPARE(driver.field("path.Process.3.speed").toDouble(), 35.0);
    driver.click("quickActions/undo");
    QVERIFY(driver.settle());
    QCOMPARE(driver.field("path.Process.3.speed").toDouble(), 50.0);
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    QCOMPARE(driver.field("process.speed").toDouble(), 50.0);
    driver.click("quickActions/undo");
    QCOMPARE(driver.paths()->childCount(), 0);
    // Manual changes stay when it is planned again.
    driver.click("quickActions/redo");
    driver.tree()->setCurrentItem(driver.paths()->child(0)->child(0));
    driver.choose("removePlan");
    QCOMPARE(driver.paths()->child(0)->childCount(), 3);
    QVERIFY(driver.settle());
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    driver.choose("planPathAgain");
    QVERIFY(driver.settle());
    QCOMPARE(driver.paths()->child(0)->childCount(), 3);
  }

  // Return in a field of the dialog takes what was typed: the path is planned by the button.
  void namedInTheDialog() {
    PlanningWindow& driver = withoutPath();
    driver.storeAt("joint.joint_1", "60");
    driver.storeAt("joint.joint_1", "-60");
    QVERIFY(driver.settle());
    driver.choose("planPath");
    auto* const dialog = driver.find<QDialog>("planDialog");
    QTest::qWait(50);
    auto* const line = dialog->findChild<QWidget*>("property/name")->findChild<QLineEdit*>();
    line->setFocus();
    QTest::keyClicks(line, "swing");
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(dialog->isVisible());
    QVERIFY(driver.settle());
    QCOMPARE(driver.paths()->childCount(), 0);
    QTest::mouseClick(dialog->findChild<QPushButton*>("planNow"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(driver.paths()->childCount(), 1, kPatienceMs);
    QCOMPARE(driver.paths()->child(0)->text(0), QString("swing"));
  }

  void waypointsAreEdited() {
    PlannedWindow<1>& driver = planned();
    QTreeWidgetItem* path = driver.paths()->child(0);
    const int count = path->childCount();
    QVERIFY(count >= 2);
    // The present configuration is inserted after the first waypoint, moved, set anew and removed.
    driver.edit("joint.joint_1", "10");
    driver.tree()->setCurrentItem(driver.paths()->child(0)->child(0));
    driver.choose("insertPlace");
    QCOMPARE(driver.paths()->child(0)->childCount(), count + 1);
    QVERIFY(driver.tree()->currentItem()->text(0).contains("critical"));
    driver.choose("movePlaceUp");
    QVERIFY(driver.paths()->child(0)->child(0)->text(0).contains("critical"));
    driver.choose("removePlan");
    QCOMPARE(driver.paths()->child(0)->childCount(), count);
    for (int i = 0; i < 3; ++i) driver.click("quickActions/undo");
    QCOMPARE(driver.paths()->child(0)->childCount(), count);
  }

  // The goal stays the goal whichever end is selected.
  void insertedBeforeTheGoal() {
    PlannedWindow<1>& driver = planned();
    const auto path = [&] { return driver.paths()->child(0); };
    const QString goal = path()->child(path()->childCount() - 1)->text(0).section(':', 1);
    QVERIFY(!goal.isEmpty());
    for (const bool isPath : {true, false}) {
      const int count = path()->childCount();
      driver.tree()->setCurrentItem(isPath ? path() : path()->child(count - 1));
      driver.choose("insertPlace");
      QCOMPARE(path()->childCount(), count + 1);
      QCOMPARE(path()->child(count)->text(0).section(':', 1), goal);
      QVERIFY(driver.tree()->currentItem() == path()->child(count - 1));
    }
  }

  // Waypoints in disorder are sorted along the path, in one step that can be undone.
  void aPathIsOptimised() {
    PlannedWindow<1>& driver = planned();
    QVERIFY(!driver.find<QAction>("optimisePath")->isEnabled());  // there is nothing between its ends
    int behind = 0;
    for (const char* value : {"-40", "30"}) {
      driver.edit("joint.joint_1", value);
      driver.tree()->setCurrentItem(driver.paths()->child(0)->child(behind++));
      driver.choose("insertPlace");
    }
    driver.edit("joint.joint_1", "5");  // at none of them, so that going there is a step
    const auto turnAt = [&](int waypoint) {
      driver.tree()->setCurrentItem(driver.paths()->child(0)->child(waypoint));
      driver.choose("goToConfiguration");
      const QString text = driver.field("joint.joint_1");
      driver.click("quickActions/undo");
      return text.split(QLatin1Char(' ')).front().toDouble();
    };
    QCOMPARE(turnAt(1), -40.0);
    QVERIFY(driver.settle());
    driver.choose("optimisePath");
    QVERIFY(driver.settle());
    QCOMPARE(turnAt(1), 30.0);
    QCOMPARE(turnAt(2), -40.0);
    driver.click("quickActions/undo");
    QCOMPARE(turnAt(1), -40.0);
  }

  void aPathIsPlayed() {
    PlannedWindow<1>& driver = planned();
    beginToPlay(driver);
    auto* line = driver.find<TimeLinePanel>("pathTimeLine");
    QVERIFY(driver.text("pathText").contains("place 2"));
    const QString before = driver.text("pathText");
    line->advance(0.5);
    QTRY_VERIFY(driver.text("pathText") != before);
    // Stored values are those of the view: between the ends, they differ from the document's.
    driver.choose("storeConfiguration");
    const auto first = [&] { return driver.field("joint.joint_1").split(' ').front().toDouble(); };
    QTRY_VERIFY(std::abs(first() - 60.0) > 1.0 && std::abs(first() + 60.0) > 1.0);  // the fields show it, too
    driver.choose("pathDockToggle");
    QVERIFY(!driver.find<QDockWidget>("pathDock")->isVisible());
    QCOMPARE(first(), -60.0);
    driver.tree()->setCurrentItem(driver.configurations()->child(2));
    driver.choose("goToConfiguration");
    QVERIFY(std::abs(first() + 60.0) > 1.0);
  }

  // A joint that is changed while a path is played starts at the displayed values; two undo steps lead back to the
  // original ones.
  void aShownPoseIsEdited() {
    PlannedWindow<1>& driver = planned();
    beginToPlay(driver);
    const auto angle = [&](const char* joint) { return driver.field(joint).split(' ').front().toDouble(); };
    QTRY_COMPARE(angle("joint.joint_1"), 60.0);  // it begins there
    driver.editInPanel("joint.joint_2", "12");
    QVERIFY(!driver.find<QDockWidget>("pathDock")->isVisible());
    QCOMPARE(angle("joint.joint_1"), 60.0);
    QCOMPARE(angle("joint.joint_2"), 12.0);
    driver.click("quickActions/undo");
    QCOMPARE(angle("joint.joint_1"), 60.0);
    QCOMPARE(angle("joint.joint_2"), 0.0);
    driver.click("quickActions/undo");
    QCOMPARE(angle("joint.joint_1"), -60.0);
    QVERIFY(driver.settle());
    // The robot is shown at its destination, also if it is there already.
    driver.choose("pathDockToggle");
    QTRY_COMPARE(angle("joint.joint_1"), 60.0);
    driver.tree()->setCurrentItem(driver.configurations()->child(1));
    driver.choose("goToConfiguration");
    QVERIFY(!driver.find<QDockWidget>("pathDock")->isVisible());
    QCOMPARE(angle("joint.joint_1"), -60.0);
    // The panel of the properties has the joints as they stand: moved there, the robot is seen there.
    driver.choose("pathDockToggle");
    QTRY_COMPARE(angle("joint.joint_1"), 60.0);
    auto* const row = driver.find<QDockWidget>("propertiesDock")->findChild<QWidget*>("property/joint.joint_3");
    auto* const line = row->findChild<QLineEdit*>();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, "20");
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(!driver.find<QDockWidget>("pathDock")->isVisible());
    QTRY_COMPARE(angle("joint.joint_1"), -60.0);
    QTRY_COMPARE(angle("joint.joint_3"), 20.0);
  }

  // In the frame that one works in the time line counts from that, and names it.
  void aPathIsPlayedInAFrame() {
    PlannedWindow<1>& driver = planned();
    beginToPlay(driver);
    const auto shown = [&] {
      const QRegularExpression numbers(QStringLiteral("X (\\S+) +Y (\\S+) +Z (\\S+) mm(.*)$"));
      const QRegularExpressionMatch match = numbers.match(driver.text("pathText"));
      return QStringList{match.captured(1), match.captured(2), match.captured(3), match.captured(4)};
    };
    QVERIFY(shown()[3].isEmpty() && !shown()[0].isEmpty());
    // A frame at the tool, where the path begins: there the tool is at its origin.
    driver.choose("storeFrame");
    driver.choose("workInFrame");
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    QTRY_VERIFY2(shown()[3] == QString(" in Frame 1"), qPrintable(driver.text("pathText")));
    for (int i = 0; i < 3; ++i) QVERIFY2(std::abs(shown()[i].toDouble()) < 5.0, qPrintable(shown()[i]));
  }

  // Planned, written and verified for the cell in which it was asked for, also when another document is in view then.
  void goesOnWhileAnotherDocumentIsInView() {
    endWindows();
    PlanningWindow driver;
    driver.setViewSmall(true);
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    auto* tabs = driver.find<QTabBar>("documentTabBar");
    tabs->setCurrentIndex(0);
    QVERIFY(driver.settle());
    driver.storeAt("joint.joint_1", "60");
    driver.storeAt("joint.joint_1", "-60");
    QVERIFY(driver.settle());
    const auto leaveAndReturn = [&] {
      tabs->setCurrentIndex(1);
      driver.release();
      if (!driver.settle()) qFatal("it does not end");
      tabs->setCurrentIndex(0);
    };
    const auto isFree = [&](int path) { return driver.paths()->child(path)->text(1).contains("free"); };
    for (int count = 1; count <= 2; ++count) {
      driver.hold();
      driver.planPath();
      leaveAndReturn();
      QVERIFY(driver.settle());
      QCOMPARE(driver.paths()->childCount(), count);
      driver.tree()->setCurrentItem(driver.paths()->child(count - 1));
      QTRY_VERIFY_WITH_TIMEOUT(isFree(count - 1), kPatienceMs);
    }
    leaveAndReturn();
    QVERIFY(driver.paths()->child(1)->isSelected());
    QVERIFY(driver.settle());
    const QTemporaryDir folder;
    driver.choose("exportProgram");
    driver.hold();
    QVERIFY(driver.enterFileName("exportProgramDialog", folder.filePath("way.mod")));
    leaveAndReturn();
    QVERIFY(QFile::exists(folder.filePath("way.mod")));
    QTRY_VERIFY(driver.text("messageText").contains("way.mod was written"));
    QVERIFY(driver.settle());
    // Nothing is known of both paths with another body in the cell.
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.edit("body.1.x", "3000");
    QVERIFY(driver.settle());
    driver.tree()->setCurrentItem(nullptr);
    driver.hold();
    driver.choose("verifyAllPaths");
    leaveAndReturn();
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("2 paths proven"), kPatienceMs);
    QVERIFY(isFree(0) && isFree(1));
    // One that is verified once more.
    driver.click("messageClose");
    driver.tree()->setCurrentItem(driver.paths()->child(1));
    QVERIFY(driver.settle());
    driver.hold();
    driver.choose("verifyPath");
    leaveAndReturn();
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains(" was verified: "), kPatienceMs);
  }

  // The part of a path was moved: who exports it is asked before, and may plan it again, or write it as it is; then the
  // program says it.
  void anOutdatedPathIsAskedAbout() {
    endWindows();
    PlanningWindow driver;
    const QPoint middle = beforeABlock(driver);
    QVERIFY(!middle.isNull());
    driver.move(middle);
    QTest::mouseMove(driver.view(), middle + QPoint(9, 9));  // the test before has left the pointer there
    QTest::mouseMove(driver.view(), middle);
    QVERIFY(driver.settle());
    QTest::mouseClick(driver.view(), Qt::LeftButton, {}, middle);
    auto* plan = driver.find<QAbstractButton>("toolAction/commit");
    QTRY_VERIFY(plan->isEnabled());
    QTest::mouseClick(plan, Qt::LeftButton);
    const auto remark = [&] {
      return driver.paths()->childCount() > 0 ? driver.paths()->child(0)->text(1) : QString();
    };
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("free"), kPatienceMs);
    driver.choose("jointTool");
    driver.clickRow(0);
    driver.edit("body.1.x", "510");
    driver.clickItem(driver.paths()->child(0));
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("plan again"), kPatienceMs);
    const auto dialog = [&] { return driver.window().findChild<QFileDialog*>(QStringLiteral("exportProgramDialog")); };
    driver.choose("exportProgram");
    QVERIFY(!dialog());
    QVERIFY(driver.text("messageText").contains("outdated"));
    QVERIFY(driver.text("messageText").contains("box"));
    // The results of a path follow its new name.
    driver.paths()->child(0)->setText(0, "weld");
    QVERIFY(!driver.find<QWidget>("messageOther")->isVisible());
    driver.choose("exportProgram");
    QVERIFY(driver.text("messageText").contains("weld is outdated"));
    driver.click("messageOther");  // Written unchanged
    QTemporaryDir folder;
    QVERIFY(driver.enterFileName("exportProgramDialog", folder.filePath("way.mod")));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("way.mod was written"), kPatienceMs);
    QFile written(folder.filePath("way.mod"));
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.readAll().contains("! Outdated: the part box has moved"));
    QTRY_VERIFY(!dialog());
    driver.choose("exportProgram");
    driver.click("messageAction");  // planned again
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains("free"), kPatienceMs);
    driver.choose("exportProgram");
    QTRY_VERIFY(dialog());
  }

 private:
  PlanningWindow& withoutPath() {
    m_planned.end();
    return m_plain.begin();
  }
  PlannedWindow<1>& planned() {
    m_plain.end();
    return m_planned.begin();
  }
  void endWindows() {
    m_plain.end();
    m_planned.end();
  }

  SharedWindow<PlanningWindow> m_plain;
  SharedWindow<PlannedWindow<1>> m_planned;
};

HANDWHEEL_WINDOW_TEST(CellPlanningWindowTest)
#include "CellPlanningWindowTest.moc"
