// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"

#include <QFile>
#include <QFileDialog>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

class FramesWindow : public CellWindow {
 public:
  FramesWindow() {
    edit("joint.joint_2", "20");
    edit("joint.joint_3", "30");
    edit("joint.joint_5", "40");
  }
  QTreeWidget* tree() { return find<QTreeWidget>("planTree"); }
  QTreeWidgetItem* target() { return tree()->topLevelItem(2)->child(0); }
  // The frames come after configurations, paths and targets, where there are some.
  bool hasFrames() { return tree()->topLevelItemCount() > 3; }
  QTreeWidgetItem* frame() { return tree()->topLevelItem(3)->child(0); }
  double number(const char* property) { return field(property).split(' ').front().toDouble(); }
  double toolHeight() {
    tree()->setCurrentItem(tree()->topLevelItem(0));
    return number("tool.z");
  }
};

}  // namespace

// Named frames in the window, with the rows and fields of targets.
class CellFramesWindowTest : public QObject {
  Q_OBJECT

  // A program with two motions in a frame of its own.
  static bool writeProgram(const QString& name) {
    QFile file(name);
    const QByteArray joints = ",[9E9,9E9,9E9,9E9,9E9,9E9]]\\NoEOffs,v100,fine,tool0\\WObj:=jig;\n";
    const QByteArray text =
        "MODULE seam\nPERS wobjdata jig:=[FALSE,TRUE,\"\",[[100,20,30],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n"
        "PROC main()\nMoveAbsJ [[0,0,0,0,30,0]" +
        joints + "MoveAbsJ [[10,0,0,0,30,0]" + joints + "ENDPROC\nENDMODULE\n";
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
  }

 private slots:
  void storeWorkMoveRenameRemove() {
    FramesWindow driver;
    QVERIFY(driver.settle());
    const double z = driver.toolHeight();
    QVERIFY(!driver.hasFrames());
    driver.choose("storeFrame");
    QVERIFY(driver.hasFrames());
    QCOMPARE(driver.frame()->text(0), QString("Frame 1"));
    QVERIFY(std::abs(driver.number("frame.Frame 1.z") - z) < 1e-3);  // in the panel, as it is selected
    // Targets that are stored while one works in it belong to it, and are shown in it.
    driver.choose("workInFrame");
    QVERIFY(driver.frame()->text(1).contains("programs"));
    driver.choose("storeTarget");
    QVERIFY(std::abs(driver.number("target.Target 1.z")) < 1e-3);
    QTRY_VERIFY_WITH_TIMEOUT(driver.target()->text(1).contains("in Frame 1"), kPatienceMs);
    // It is moved, and the target with it.
    driver.tree()->setCurrentItem(driver.frame());
    driver.edit("frame.Frame 1.z", QString::number(z + 5.0));
    driver.tree()->setCurrentItem(driver.target());
    QVERIFY(std::abs(driver.number("target.Target 1.z")) < 1e-3);
    QVERIFY(driver.settle());
    driver.choose("goToConfiguration");
    QVERIFY(std::abs(driver.toolHeight() - (z + 5.0)) < 1e-3);
    driver.frame()->setText(0, "fixture");
    QCOMPARE(driver.frame()->text(0), QString("fixture"));
    QTRY_VERIFY_WITH_TIMEOUT(driver.target()->text(1).contains("in fixture"), kPatienceMs);
    // Without it the target stays where it is.
    driver.tree()->setCurrentItem(driver.frame());
    driver.choose("removePlan");
    QVERIFY(!driver.hasFrames());
    driver.tree()->setCurrentItem(driver.target());
    QVERIFY(std::abs(driver.number("target.Target 1.z") - (z + 5.0)) < 1e-3);
    driver.click("quickActions/undo");
    QVERIFY(driver.hasFrames());
    driver.tree()->setCurrentItem(driver.target());
    QVERIFY(std::abs(driver.number("target.Target 1.z")) < 1e-3);
  }

  // On a body it moves with that, and is set anew where the tool is.
  void onABody() {
    FramesWindow driver;
    QVERIFY(driver.settle());
    const double z = driver.toolHeight();
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.edit("body.1.z", "100");
    driver.choose("storeFrame");
    QVERIFY(driver.frame()->text(1).contains("on "));
    driver.tree()->setCurrentItem(driver.tree()->topLevelItem(0));
    driver.tree()->setCurrentItem(driver.frame());
    QVERIFY(std::abs(driver.number("frame.Frame 1.z") - (z - 100.0)) < 1e-3);  // in the box
    driver.choose("setPlaceHere");
    QVERIFY(std::abs(driver.number("frame.Frame 1.z") - (z - 100.0)) < 1e-3);
  }

  // A program in a frame brings it along, in one step; opened again it finds it.
  void aProgramInAFrame() {
    FramesWindow driver;
    QVERIFY(driver.settle());
    const QTemporaryDir folder;
    const QString name = folder.filePath("seam.mod");
    QVERIFY(writeProgram(name));
    const auto open = [&](int count) {
      driver.choose("importProgram");
      QVERIFY(driver.enterFileName("importProgramDialog", name));
      QTRY_COMPARE_WITH_TIMEOUT(driver.tree()->topLevelItem(1)->childCount(), count, kPatienceMs);
    };
    open(1);
    QVERIFY(driver.hasFrames());
    QCOMPARE(driver.frame()->text(0), QString("jig"));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("jig"), kPatienceMs);
    driver.tree()->setCurrentItem(driver.frame());
    QVERIFY(std::abs(driver.number("frame.jig.x") - 100.0) < 1e-3);
    open(2);
    QCOMPARE(driver.tree()->topLevelItem(3)->childCount(), 1);
    driver.click("quickActions/undo");
    QVERIFY(driver.hasFrames());
    driver.click("quickActions/undo");
    QVERIFY(!driver.hasFrames());
    QCOMPARE(driver.tree()->topLevelItem(1)->childCount(), 0);
  }

  // The advice to work in the frame of a program is for who does not.
  void adviceOnTheFrame() {
    FramesWindow driver;
    QVERIFY(driver.settle());
    const QTemporaryDir folder;
    const QString name = folder.filePath("seam.mod");
    QVERIFY(writeProgram(name));
    driver.choose("importProgram");
    QVERIFY(driver.enterFileName("importProgramDialog", name));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("choose to work in it"), kPatienceMs);
    driver.tree()->setCurrentItem(driver.frame());
    driver.choose("workInFrame");
    driver.choose("importProgram");
    QVERIFY(driver.enterFileName("importProgramDialog", name));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("It is in frames of the cell: jig."), kPatienceMs);
    QVERIFY(!driver.text("messageText").contains("choose to work in it"));
  }

  // With two programs in one frame the second one only names it.
  void aFrameThatIsDeclaredElsewhere() {
    FramesWindow driver;
    QVERIFY(driver.settle());
    const QTemporaryDir folder;
    QVERIFY(writeProgram(folder.filePath("seam.mod")));
    driver.choose("importProgram");
    QVERIFY(driver.enterFileName("importProgramDialog", folder.filePath("seam.mod")));
    QTRY_COMPARE_WITH_TIMEOUT(driver.tree()->topLevelItem(1)->childCount(), 1, kPatienceMs);
    driver.tree()->setCurrentItem(driver.frame());
    driver.choose("workInFrame");
    const auto path = [&] { return driver.tree()->topLevelItem(1)->child(0); };
    driver.tree()->setCurrentItem(path());
    QTRY_VERIFY_WITH_TIMEOUT(path()->text(1).contains("free"), kPatienceMs);
    for (const bool declares : {true, false}) {
      if (!declares) driver.choose("declareFrame");
      const QString name = declares ? QStringLiteral("one.mod") : QStringLiteral("other.mod");
      driver.choose("exportProgram");
      QVERIFY(driver.enterFileName("exportProgramDialog", folder.filePath(name)));
      QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains(name + " was written"), kPatienceMs);
      QTRY_VERIFY(!driver.window().findChild<QFileDialog*>("exportProgramDialog"));
      QFile file(folder.filePath(name));
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QByteArray text = file.readAll();
      QCOMPARE(text.contains("\n  PERS wobjdata jig:="), declares);
      QVERIFY(text.contains("\\WObj:=jig;"));
    }
  }
};

HANDWHEEL_WINDOW_TEST(CellFramesWindowTest)
#include "CellFramesWindowTest.moc"
