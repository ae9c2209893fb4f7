// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlanningWindow.h"
#include "WindowTestMain.h"

#include <QLabel>
#include <QTemporaryDir>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Two paths between two configurations, both verified; the second one is selected.
class TwoPaths : public PlanningWindow {
 public:
  TwoPaths() {
    storeAt("joint.joint_1", "60");
    storeAt("joint.joint_1", "-60");
    for (int path = 0; path < 2; ++path) {
      if (!settle()) qFatal("the cell is not prepared");
      planPath();
      if (!QTest::qWaitFor([&] { return remark(path).contains("free"); }, kPatienceMs)) qFatal("no path is planned");
    }
  }
  QString remark(int path) { return paths()->childCount() > path ? paths()->child(path)->text(1) : QString(); }
  bool becomes(int path, const char* text) {
    return QTest::qWaitFor([&] { return remark(path).contains(text); }, kPatienceMs);
  }
};

}  // namespace

// What the list says of the paths of a cell: it stays while something else is done, and is never empty.
class CellPathStatusWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // Edited and undone the one path does not touch what is known of the other.
  void anotherPathIsEdited() {
    TwoPaths driver;
    const QString first = driver.remark(0);
    driver.tree()->setCurrentItem(driver.paths()->child(1)->child(0));
    driver.edit("joint.joint_1", "10");
    driver.choose("insertPlace");
    QCOMPARE(driver.remark(0), first);
    QVERIFY(driver.becomes(1, "free"));
    QCOMPARE(driver.remark(0), first);
    driver.choose("add-box");  // of a body both hear; the selected one is verified at once
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

  // By another name it is the same path.
  void renamed() {
    TwoPaths driver;
    const QString first = driver.remark(0);
    driver.paths()->child(0)->setText(0, "weld");
    QCOMPARE(driver.paths()->child(0)->text(0), QString("weld"));
    QCOMPARE(driver.remark(0), first);
  }

  // Verified once more, what was known already: that it was done is said.
  void provenAgain() {
    TwoPaths driver;
    driver.tree()->setCurrentItem(driver.paths()->child(1));
    QVERIFY(driver.settle());
    driver.choose("verifyPath");
    QVERIFY(driver.remark(1).contains("verifying"));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("free of collisions"), kPatienceMs);
    QVERIFY(driver.text("messageText").contains("motion"));
    QVERIFY(driver.text("messageText").contains("clearance"));
    QVERIFY(driver.remark(1).contains("free"));
  }

  // Stored and opened: nothing is claimed that was not proven in this session.
  void afterOpening() {
    QTemporaryDir folder;
    const QString file = folder.filePath("cell.handwheel");
    {
      TwoPaths driver;
      driver.choose("saveFileAs");
      QVERIFY(driver.enterFileName("saveDialog", file));
      QVERIFY(driver.settle());
    }
    PlanningWindow driver;
    QVERIFY(driver.open(file));
    QCOMPARE(driver.paths()->childCount(), 2);
    for (int path = 0; path < 2; ++path) QCOMPARE(driver.paths()->child(path)->text(1), QString("not verified yet"));
    driver.choose("verifyAllPaths");
    for (int path = 0; path < 2; ++path) {
      QTRY_VERIFY_WITH_TIMEOUT(driver.paths()->child(path)->text(1).contains("free"), kPatienceMs);
    }
  }
};

HANDWHEEL_WINDOW_TEST(CellPathStatusWindowTest)
#include "CellPathStatusWindowTest.moc"
