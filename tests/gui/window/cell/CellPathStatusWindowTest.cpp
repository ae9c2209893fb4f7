// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "PixelsLike.h"
#include "PlanningWindow.h"
#include "document/cell/RobotCellDocument.h"
#include "panels/time/TimeLinePanel.h"
#include "panels/time/TimePlot.h"
#include "viewport/path/PathLayer.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QTemporaryDir>
#include "window/cell/PathStatus.h"
#include "window/cell/PlanTree.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

using TwoPaths = PlannedWindow<2>;

// Returns the measures of the selected path.
QStringList measures(PlanningWindow& driver) {
  QStringList shown;
  for (const char* id : {"path.time", "path.length", "path.security", "path.manipulability"}) shown += driver.shown(id);
  return shown;
}

}  // namespace

// The status of the paths of a cell in the list: it stays during other actions, and is never empty.
class CellPathStatusWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // A banner goes with the state that it tells of, and is not found again below a newer one.
  void bannersGo() {
    TwoPaths& driver = m_window.beginAnew();  // The messages about planning are still there
    auto* bar = driver.find<QWidget>("messageText");
    driver.choose("storeConfiguration");
    QVERIFY(driver.text("messageText").contains("Configuration 3 was stored"));
    // Another name can be given at once.
    driver.click("messageAction");
    auto& tree = *driver.find<QTreeWidget>("planTree");
    auto* const editor = qobject_cast<QLineEdit*>(tree.indexWidget(tree.currentIndex()));
    QVERIFY(editor);
    QCOMPARE(editor->text(), QString("Configuration 3"));
    QTest::failOnWarning(QRegularExpression(QStringLiteral("closeEditor")));  // For an editor that no longer exists
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("Parked"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(driver.configurations()->child(2)->text(0), QString("Parked"));
    QVERIFY(!tree.indexWidget(tree.currentIndex()));
    driver.choose("storeConfiguration");
    QVERIFY(driver.text("messageText").contains("Configuration 4 was stored"));
    QVERIFY(driver.configurations()->child(3)->isSelected());
    driver.click("quickActions/undo");
    QVERIFY(!bar->isVisible());
    driver.choose("storeConfiguration");
    driver.edit("joint.joint_1", "11");
    QVERIFY(!bar->isVisible());
    QVERIFY(driver.settle());
  }

  // The selected path is verified at each change. Undo brings back what was found before, also for the file. No test
  // before has verified the other one with the box.
  void undoBringsTheProofBack() {
    TwoPaths& driver = m_window.begin();
    const auto& cell =
        static_cast<const RobotCellDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
    QVERIFY(driver.settle());
    const PathProofs before = cell.proofs();
    const QString first = driver.remark(0), second = driver.remark(1);
    for (int path = 0; path < 2; ++path) QVERIFY(before.contains(driver.paths()->child(path)->text(0).toStdString()));
    driver.choose("add-box");
    QTRY_VERIFY_WITH_TIMEOUT(cell.proofs() != before, kPatienceMs);
    driver.click("quickActions/undo");
    QVERIFY(driver.settle());
    QCOMPARE(driver.remark(0), first);
    QCOMPARE(driver.remark(1), second);
    QVERIFY(cell.proofs() == before);
    driver.click("quickActions/redo");
    QVERIFY(driver.settle());
    QVERIFY(driver.remark(0).contains("not verified since") && cell.proofs() != before);
    driver.click("quickActions/undo");
    QVERIFY(driver.settle() && cell.proofs() == before);
  }

  // Edited and undone the one path does not touch what is known of the other.
  void anotherPathIsEdited() {
    TwoPaths& driver = m_window.begin();
    const QString first = driver.remark(0);
    driver.tree()->setCurrentItem(driver.paths()->child(1)->child(0));
    driver.edit("joint.joint_1", "10");
    driver.choose("insertPlace");
    QCOMPARE(driver.remark(0), first);
    QVERIFY(driver.becomes(1, "free"));
    QCOMPARE(driver.remark(0), first);
    driver.choose("add-box");  // The body affects both paths; the selected one is verified at once
    QVERIFY(driver.settle());
    QCOMPARE(driver.remark(0), QString("not verified since the bodies were changed"));
    driver.click("quickActions/undo");
    QVERIFY(driver.settle());
    QCOMPARE(driver.remark(0), first);
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.choose("verifyAllPaths");
    QVERIFY(driver.becomes(0, "free"));
  }

  // Verified all together: how many are proven is said, also where that was known, and why the first other one is not.
  void allAreVerified() {
    TwoPaths& driver = m_window.begin();
    driver.choose("verifyAllPaths");
    QTRY_VERIFY_WITH_TIMEOUT(driver.says("2 paths proven"), kPatienceMs);
    driver.choose("add-box");  // An obstacle for both
    QVERIFY(driver.settle());
    driver.edit("body.1.x", "300");
    driver.edit("body.1.y", "0");
    driver.edit("body.1.z", "400");
    driver.edit("body.1.size_z", "800");
    QVERIFY(driver.settle());
    driver.choose("verifyAllPaths");
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("2 not"), kPatienceMs);
    QVERIFY(driver.text("messageText").contains(driver.paths()->child(0)->text(0) + ": "));
    QVERIFY(driver.text("messageText").contains("collision"));
  }

  // The rows stay where they are, whatever is known of the selected one.
  void theListKeepsItsSize() {
    TwoPaths& driver = m_window.begin();
    driver.tree()->setCurrentItem(driver.configurations()->child(0));
    QApplication::processEvents();
    const QSize before = driver.tree()->size();
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    QApplication::processEvents();
    QVERIFY(driver.find<QLabel>("planDetail")->isVisible());
    QCOMPARE(driver.tree()->size(), before);
  }

  // A banner comes and goes over the view: what is seen there stays.
  void bannersMoveNothing() {
    TwoPaths& driver = m_window.begin();
    driver.choose("verifyPath");
    auto* bar = driver.find<QWidget>("messageBar");
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible(), kPatienceMs);
    const QRect with(driver.view()->mapToGlobal(QPoint()), driver.view()->size());
    while (bar->isVisible()) driver.click("messageClose");
    QApplication::processEvents();
    QCOMPARE(QRect(driver.view()->mapToGlobal(QPoint()), driver.view()->size()), with);
  }

  // The clearance that a path keeps is a field of it, and a line in the plot; changed, the path is verified with it.
  void clearanceIsAField() {
    TwoPaths& driver = m_window.begin();
    driver.clickItem(driver.paths()->child(1));
    QVERIFY(driver.settle());
    driver.choose("pathDockToggle");
    auto* const plot = driver.find<QWidget>("pathTimeLine")->findChild<TimePlot*>("timePlot");
    QTRY_COMPARE_WITH_TIMEOUT(plot->plot().series.size(), std::size_t{1}, kPatienceMs);
    const std::string field = "path." + driver.paths()->child(1)->text(0).toStdString() + ".clearance";
    driver.edit(field.c_str(), "5");
    QTRY_COMPARE_WITH_TIMEOUT(plot->plot().series.size(), std::size_t{2}, kPatienceMs);
    QVERIFY(driver.becomes(1, "free"));
    QCOMPARE(plot->plot().series[1].points.front().y(), 5.0);
    QCOMPARE(plot->plot().series[1].points.back().y(), 5.0);
    QVERIFY(driver.remark(0).contains("free"));
    driver.click("quickActions/undo");
    QTRY_COMPARE_WITH_TIMEOUT(plot->plot().series.size(), std::size_t{1}, kPatienceMs);
    QVERIFY(driver.becomes(1, "free"));
  }

  // The measures by which planners compare paths are beside the selected one, with the values of the command line.
  void measuresAreShown() {
    TwoPaths& driver = m_window.begin();
    driver.clickItem(driver.paths()->child(1));
    QVERIFY(driver.settle());
    const QStringList shown = measures(driver);
    // There is no obstacle: joint 1 alone turns by 120 degrees.
    QCOMPARE(shown[1], QString("2.094 rad"));
    QVERIFY(shown[0].endsWith(" s") && shown[2].startsWith("> "));
    bool isNumber = false;
    QVERIFY(shown[3].toDouble(&isNumber) >= 0.0 && isNumber);
  }

  // By another name it is the same path.
  void renamed() {
    TwoPaths& driver = m_window.begin();
    const QString first = driver.remark(0);
    driver.paths()->child(0)->setText(0, "weld");
    QCOMPARE(driver.paths()->child(0)->text(0), QString("weld"));
    QCOMPARE(driver.remark(0), first);
  }

  // Verified once more, what was known already: that it was done is said.
  void provenAgain() {
    TwoPaths& driver = m_window.begin();
    driver.tree()->setCurrentItem(driver.paths()->child(1));
    QVERIFY(driver.settle());
    driver.choose("verifyPath");
    QVERIFY(driver.remark(1).contains("verifying"));
    QTRY_VERIFY_WITH_TIMEOUT(driver.says("free of collisions"), kPatienceMs);
    QVERIFY(driver.text("messageText").contains("motion"));
    QVERIFY(driver.text("messageText").contains("clearance"));
    QVERIFY(driver.remark(1).contains("free"));
  }

  // The whole of what is known of the selected path is below the list.
  void detailsAreReadable() {
    TwoPaths& driver = m_window.begin();
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    auto* detail = driver.find<QLabel>("planDetail");
    QVERIFY(detail->isVisible() && detail->wordWrap());
    QVERIFY(detail->text().contains("free of collisions"));
    driver.choose("add-box");
    driver.tree()->setCurrentItem(driver.configurations()->child(0));
    QVERIFY(!detail->isVisible());
    QVERIFY(driver.settle());
  }

  // A collision in the list leads to where it is deepest: there the time line shows it.
  void collisionsAreLinks() {
    TwoPaths& driver = m_window.begin();
    driver.choose("add-box");  // An obstacle
    QVERIFY(driver.settle());
    driver.edit("body.1.x", "300");
    driver.edit("body.1.y", "0");
    driver.edit("body.1.z", "400");
    driver.edit("body.1.size_z", "800");
    QVERIFY(driver.settle());
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    QVERIFY(driver.becomes(0, "collision"));
    auto* const detail = driver.find<QLabel>("planDetail");
    const QRegularExpression link("<a href=\"(\\d+)\">On the way to place [^<]* with [^<]*</a>");
    const QRegularExpressionMatch first = link.match(detail->text());
    QVERIFY2(first.hasMatch(), qPrintable(detail->text()));
    emit detail->linkActivated(first.captured(1));
    QTRY_VERIFY(driver.find<QDockWidget>("pathDock")->isVisible());
    QTRY_VERIFY(driver.text("pathText").contains("collision"));
    QVERIFY(driver.find<TimeLinePanel>("pathTimeLine")->time() > 0.0);
    emit detail->linkActivated("99");  // A collision that no longer exists
    QVERIFY(driver.text("pathText").contains("collision"));
    driver.tree()->setCurrentItem(driver.configurations()->child(0));
    QVERIFY(!detail->isVisible());
  }

  // Another name by the menu: as by F2.
  void renamedByTheMenu() {
    TwoPaths& driver = m_window.begin();
    const auto rename = [&](const char* name) {
      driver.choose("renamePlan");
      auto* editor = driver.tree()->findChild<QLineEdit*>();
      if (!editor) return false;
      editor->setText(name);
      QTest::keyClick(editor, Qt::Key_Return);
      return true;
    };
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    QVERIFY(rename("weld"));
    QTRY_COMPARE(driver.paths()->child(0)->text(0), QString("weld"));
    driver.tree()->setCurrentItem(driver.configurations()->child(1));
    QVERIFY(rename("right"));
    QTRY_COMPARE(driver.configurations()->child(1)->text(0), QString("right"));
    driver.tree()->setCurrentItem(driver.paths()->child(0)->child(0));  // A waypoint has none
    QVERIFY(!driver.find<QAction>("renamePlan")->isEnabled());
  }

  // Another name at once, by the button of the message that something was stored: the field stays open until it is
  // left.
  void renamedByTheMessage() {
    TwoPaths& driver = m_window.begin();
    driver.tree()->setCurrentItem(driver.configurations()->child(1));
    driver.storeAt("joint.joint_1", "20");
    QCOMPARE(driver.configurations()->childCount(), 3);
    driver.click("messageAction");
    QTest::qWait(50);  // Some widgets take the focus later
    auto* editor = driver.tree()->findChild<QLineEdit*>();
    QVERIFY(editor && editor->isVisible());
    // Without a window manager no window is active, but it knows what would get the keys.
    QCOMPARE(editor->window()->focusWidget(), static_cast<QWidget*>(editor));
    editor->selectAll();
    QTest::keyClicks(editor, "approach");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(driver.configurations()->child(2)->text(0), QString("approach"));
  }

  // The actions of planners are in menus by subject; with few entries each.
  void menuIsGrouped() {
    TwoPaths& driver = m_window.begin();
    auto* menu = driver.find<QMenu>("kindMenu/cell");
    int entries = 0;
    QStringList groups;
    for (const QAction* action : menu->actions()) {
      entries += action->isSeparator() ? 0 : 1;
      if (action->menu()) groups += QString(action->text()).remove('&');
    }
    QVERIFY(entries <= 16);
    QCOMPARE(groups, QStringList({"Robots", "Bodies", "Configurations, targets and frames", "Paths", "Verification",
                                  "Programs"}));
  }

  // Stored and opened: what was proven is known, as long as nothing was changed since it was; with its measures.
  void afterOpening() {
    QTemporaryDir folder;
    const QString file = folder.filePath("cell.handwheel"), changed = folder.filePath("changed.handwheel");
    QStringList before;
    {
      TwoPaths& driver = m_window.beginAnew();  // No test has verified the first path with the box
      driver.clickItem(driver.paths()->child(1));
      QVERIFY(driver.settle());
      before = measures(driver);
      driver.choose("saveFileAs");
      QVERIFY(driver.enterFileName("saveDialog", file));
      QVERIFY(driver.settle());
      driver.choose("add-box");
      QVERIFY(driver.settle());
      QVERIFY(driver.becomes(1, "free"));
      driver.choose("saveFileAs");
      QVERIFY(driver.enterFileName("saveDialog", changed));
      QVERIFY(driver.settle());
      m_window.end();
    }
    PlanningWindow driver;
    QVERIFY(driver.open(file));
    for (int path = 0; path < 2; ++path) QVERIFY(driver.becomes(path, "free"));
    // It is proven anew before it is exported.
    QVERIFY(!driver.find<QAction>("exportProgram")->isEnabled());
    driver.clickItem(driver.paths()->child(1));
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QAction>("exportProgram")->isEnabled(), kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(measures(driver), before, kPatienceMs);
    driver.choose("add-box");
    QVERIFY(driver.settle());
    QCOMPARE(driver.remark(0), QString("not verified since the bodies were changed"));
    driver.click("quickActions/undo");
    QVERIFY(driver.becomes(0, "free"));
    // In the other file the one path was not verified after the box came. No row is selected whose path would be
    // verified.
    driver.tree()->setCurrentItem(driver.configurations());
    QVERIFY(driver.open(changed));
    QTRY_COMPARE_WITH_TIMEOUT(driver.remark(0), QString("not verified since the bodies were changed"), kPatienceMs);
    QVERIFY(driver.remark(1).contains("free"));
    driver.clickItem(driver.paths()->child(0));
    QVERIFY(driver.becomes(0, "free"));
  }

  // A verification that was asked for goes on while another document is in view, and is reported when its own is again.
  void goesOnBehindAnotherDocument() {
    m_window.end();
    TwoPaths driver;
    driver.tree()->setCurrentItem(driver.paths()->child(1));
    QVERIFY(driver.becomes(1, "free"));
    driver.hold();
    driver.choose("verifyPath");
    driver.choose("newWorkpiece");
    driver.release();
    QVERIFY(driver.settle());
    QVERIFY(!driver.says("free of collisions"));
    driver.hold();  // nothing can be verified now
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.says("free of collisions"));
    driver.release();
    QVERIFY(driver.settle());
    QVERIFY(driver.remark(1).contains("free"));
  }

  // The selected path is in the view again when its document is.
  void drawnAfterAnotherDocument() {
    m_window.end();
    TwoPaths driver;
    driver.setViewSmall(false);
    driver.showAll();
    const auto drawn = [&] {
      return pixelsLike(driver.view()->grabImage(), pathColour(PathLine::Look::Travel, sceneColours(false)));
    };
    constexpr int kFew = 20;  // pixels: far less than a line of the path has
    driver.tree()->setCurrentItem(driver.configurations());
    QVERIFY(driver.settle());
    const int without = drawn();
    driver.tree()->setCurrentItem(driver.paths()->child(1));
    QVERIFY(driver.settle());
    QTRY_VERIFY_WITH_TIMEOUT(drawn() > without + kFew, kPatienceMs);
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    QCOMPARE(driver.tree()->currentItem(), driver.paths()->child(1));
    QTRY_VERIFY_WITH_TIMEOUT(drawn() > without + kFew, kPatienceMs);
  }

  // New results for a path do not end the editing of its name.
  void isRenamedWhileTheListIsFilled() {
    PlanTree tree;
    CellPlans plans;
    plans.paths.resize(2);
    plans.paths[0].name = "one";
    plans.paths[1].name = "two";
    tree.setPlans(plans, nullptr, {}, {});
    tree.show();
    QVERIFY(QTest::qWaitForWindowExposed(&tree));
    const PlanTree::Entry second{PlanTree::Entry::Kind::Path, "two"};
    tree.select(second);
    QStringList names;
    connect(&tree, &PlanTree::renameRequested, this,
            [&](const PlanTree::Entry&, const QString& name) { names += name; });
    tree.editItem(tree.currentItem(), 0);
    const auto editor = [&] { return qobject_cast<QLineEdit*>(tree.indexWidget(tree.currentIndex())); };
    QVERIFY(editor());
    editor()->setText("weld");
    tree.setPlans(plans, nullptr, {{"two", PathStatus()}}, {});
    QVERIFY(tree.current() == second);
    QVERIFY(editor());
    QCOMPARE(editor()->text(), QString("weld"));
    QCOMPARE(names, QStringList());
    QTest::keyClick(editor(), Qt::Key_Return);
    QTRY_COMPARE(names, QStringList("weld"));
  }

  // A path that is out of date and collides shows both: the remedy comes first. Only findings for the present cell
  // count.
  void outdatedAndColliding() {
    RobotPath path{"weld", {{.joints = JointValues::Zero(6)}, {.joints = JointValues::Zero(6)}}};
    PathFindings found{.collisions = 1, .listed = {{1, "flange", "wall", -2.0}}};
    found.outdated.part = "featuretype";
    PathResult result;
    result.basis.path = path;
    result.found = found;
    result.at = QDateTime::currentDateTime();
    const auto status = [&](const PathResult& of, BasisChange change = BasisChange::Nothing) {
      return pathStatusOf({&of, change, false}, path, LengthUnit::Millimetre, QLocale::c());
    };
    const PathStatus both = status(result);
    QCOMPARE(both.text, QString("plan again: featuretype has moved; 1 collision"));
    QVERIFY(both.summary.startsWith(both.text));
    QVERIFY(both.details.contains("Plan it again.") && both.details.contains("featuretype was when it was planned"));
    QCOMPARE(both.collisions.size(), qsizetype{1});
    QVERIFY(both.details.contains(both.collisions.front()) && linkedDetails(both).count("<a href=\"0\">") == 1);
    QVERIFY(!both.isFree);
    QVERIFY(status(result, BasisChange::Bodies).text.startsWith("not verified since"));

    PathResult stopped = result;
    stopped.found->stopsAt = 1;
    QCOMPARE(status(stopped).text, QString("plan again: featuretype has moved; line cannot be followed"));
    PathResult colliding = result;
    colliding.found->outdated = {};
    QVERIFY(!status(colliding).details.contains("lan it again") && status(colliding).text.contains("collision"));
    PathResult outdated = result;
    outdated.found = PathFindings{.isCertified = true, .outdated = found.outdated};
    QCOMPARE(status(outdated).text, QString("plan again: featuretype has moved"));
  }

 private:
  SharedWindow<TwoPaths> m_window;
};

HANDWHEEL_WINDOW_TEST(CellPathStatusWindowTest)
#include "CellPathStatusWindowTest.moc"
