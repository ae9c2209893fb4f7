// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "PlanningWindow.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Two configurations, and between them a path if that is wanted.
class TwoWaypoints : public PlanningWindow {
 public:
  explicit TwoWaypoints(bool hasPath) {
    storeAt("joint.joint_1", "60");
    storeAt("joint.joint_1", "-60");
    if (!settle()) qFatal("the cell is not prepared");
    if (!hasPath) return;
    planPath();
    if (!becomes(0, "free")) qFatal("no path is planned");
  }
  int verifications() {
    int count = 0;
    for (auto* label : find<QWidget>("jobList")->findChildren<QLabel*>()) {
      if (label->objectName().startsWith("jobName") && label->text().contains("Verifying")) ++count;
    }
    return count;
  }
};

// A long tool whose tip is in a box, and a configuration of that; joint 1 is at 0.
class LongTool : public PlanningWindow {
 public:
  LongTool() {
    edit("joint.joint_2", "20");
    edit("joint.joint_3", "30");
    edit("joint.joint_5", "40");
    choose("add-box");
    prepare();
    setSize("body.1.", "40", "200");
    choose("mountBody");
    prepare();
    edit("body.1.z", "120");  // from 20 to 220 mm in front of the flange
    edit("tcp.z", "200");
    const QStringList tip{numberOf("property/tool.x"), numberOf("property/tool.y"), numberOf("property/tool.z")};
    choose("add-box");
    prepare();
    setSize("body.2.", "20", "20");
    edit("body.2.x", tip[0]);
    edit("body.2.y", tip[1]);
    edit("body.2.z", tip[2]);
    choose("storeConfiguration");
  }
  QString numberOf(const char* property) {
    auto* const row = find<QDockWidget>("propertiesDock")->findChild<QWidget*>(property);
    return row->findChild<QLineEdit*>()->text().section(' ', 0, 0);
  }

 private:
  void prepare() {
    if (!settle()) qFatal("the cell is not prepared");
  }
  void setSize(const std::string& body, const char* across, const char* along) {
    for (const auto& [side, value] : {std::pair("size_x", across), {"size_y", across}, {"size_z", along}})
      edit((body + side).c_str(), value);
  }
};

}  // namespace

// Plans that are late, requested often, or begun without a cell.
class CellReplanningWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // The cell changes while a path is planned: it is said, and the plan is made again when it is asked for.
  void aPlanThatComesTooLate() {
    TwoWaypoints driver(false);
    driver.hold();
    driver.planPath();
    driver.choose("add-box");
    driver.release();
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("changed while"), kPatienceMs);
    QVERIFY(driver.settle());
    QCOMPARE(driver.paths()->childCount(), 0);
    driver.click("messageAction");
    QTRY_COMPARE_WITH_TIMEOUT(driver.paths()->childCount(), 1, kPatienceMs);
  }

  // A request that needs the cell after its preparation was cancelled begins it again.
  void aCancelledPreparation() {
    TwoWaypoints driver(false);
    driver.hold();
    driver.choose("add-box");
    driver.click("jobCancel");
    driver.release();
    QVERIFY(driver.settle());
    driver.planPath();
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("being prepared"), kPatienceMs);
    QVERIFY(driver.settle());
    driver.planPath();
    QTRY_COMPARE_WITH_TIMEOUT(driver.paths()->childCount(), 1, kPatienceMs);
  }

  // Manual changes while the path is planned again stay; the plan becomes another path.
  void changesByHandStay() {
    TwoWaypoints driver(true);
    const int count = driver.paths()->child(0)->childCount();
    driver.hold();
    driver.tree()->setCurrentItem(driver.paths()->child(0)->child(0));
    driver.choose("planPathAgain");
    driver.choose("insertPlace");
    driver.release();
    QTRY_COMPARE_WITH_TIMEOUT(driver.paths()->childCount(), 2, kPatienceMs);
    QCOMPARE(driver.paths()->child(0)->childCount(), count + 1);
    QVERIFY(driver.text("messageText").contains("changed while"));
    driver.click("quickActions/undo");
    QCOMPARE(driver.paths()->childCount(), 1);
    QCOMPARE(driver.paths()->child(0)->childCount(), count + 1);
  }

  // Whoever presses again and again waits for one verification.
  void verificationsDoNotPileUp() {
    TwoWaypoints driver(true);
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    driver.hold();
    for (int i = 0; i < 5; ++i) driver.choose("verifyPath");
    QTest::qWait(50);
    QCOMPARE(driver.verifications(), 1);
    QVERIFY(driver.remark(0).contains("verifying"));
    driver.release();
    QTRY_VERIFY_WITH_TIMEOUT(driver.remark(0).contains("free"), kPatienceMs);
  }

  // By a worker: written as a program, opened again, and free of collisions like before.
  void programsThereAndBack() {
    TwoWaypoints driver(true);
    QTemporaryDir folder;
    const QString file = folder.filePath("way.mod");
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    driver.choose("exportProgram");
    QVERIFY(driver.enterFileName("exportProgramDialog", file));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("way.mod was written"), kPatienceMs);
    driver.choose("importProgram");
    QVERIFY(driver.enterFileName("importProgramDialog", file));
    QTRY_COMPARE_WITH_TIMEOUT(driver.paths()->childCount(), 2, kPatienceMs);
    QCOMPARE(driver.paths()->child(1)->childCount(), driver.paths()->child(0)->childCount());
    QTRY_VERIFY_WITH_TIMEOUT(driver.remark(1).contains("free"), kPatienceMs);
    driver.click("quickActions/undo");
    QCOMPARE(driver.paths()->childCount(), 1);
  }

  // The language follows the ending; at first it is that of the robot's controller, in the folder used last, by the
  // name of the path. Another type changes the ending.
  void theLanguageOfTheEnding() {
    TwoWaypoints driver(true);
    QTemporaryDir folder;
    QSettings().setValue("lastFolder", folder.path());
    driver.tree()->setCurrentItem(driver.paths()->child(0));
    driver.choose("exportProgram");
    const auto* dialog = driver.find<QFileDialog>("exportProgramDialog");
    QTRY_VERIFY(dialog->isVisible());
    QCOMPARE(dialog->directory().canonicalPath(), QDir(folder.path()).canonicalPath());
    const auto name = [&] { return dialog->findChild<QLineEdit*>("fileNameEdit")->text(); };
    auto* types = dialog->findChild<QComboBox*>("fileTypeCombo");
    for (const auto& [type, ending] :
         {std::pair("KRL", ".src"), std::pair("JSON", ".program.json"), std::pair("URScript", ".script")}) {
      types->setCurrentIndex(types->findText(QString(type), Qt::MatchContains));
      emit types->textActivated(types->currentText());
      QTRY_COMPARE(name(), driver.paths()->child(0)->text(0) + ending);
    }
    QVERIFY(driver.enterFileName("exportProgramDialog", folder.filePath("way.ls")));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("way.ls was written"), kPatienceMs);
    QFile written(folder.filePath("way.ls"));
    QVERIFY(written.open(QIODevice::ReadOnly) && written.readAll().startsWith("/PROG"));
    // The end of an ending is enough, whatever the type.
    QTRY_VERIFY(!driver.window().findChild<QFileDialog*>("exportProgramDialog"));
    driver.choose("exportProgram");
    QVERIFY(driver.enterFileName("exportProgramDialog", folder.filePath("way.json")));
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("way.program.json was written"), kPatienceMs);
  }

  // From the start page, where nothing is open.
  void aCellWithABuiltInRobot() {
    WindowDriver driver;
    QCOMPARE(driver.tabs(), 0);
    driver.choose("newBuiltInCell");
    auto* dialog = driver.find<QInputDialog>("builtInRobotDialog");
    QTRY_VERIFY(dialog->isVisible());
    const QString title = dialog->comboBoxItems().at(1);
    dialog->setTextValue(title);
    dialog->accept();
    QTRY_COMPARE_WITH_TIMEOUT(driver.tabs(), 1, kPatienceMs);
    QVERIFY(driver.settle());
    QVERIFY(driver.find<QTreeWidget>("planTree")->isVisible());
  }

  // A long tool that meets a part where the path begins: a target is on that, so it is worked on, and the message of
  // the plan that failed lets the two touch, in one undo step. Then the path is found, and the pair is named as not
  // checked.
  void aToolMayTouchItsPart() {
    LongTool driver;
    driver.edit("joint.joint_1", "60");
    driver.choose("storeTarget");  // on the box, which is selected
    QVERIFY(driver.settle());
    driver.planPath();
    auto* const let = driver.find<QAbstractButton>("messageAction");
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("collides"), kPatienceMs);
    QVERIFY2(let->isVisible() && let->text().contains("touch"), qPrintable(driver.text("messageText")));
    QVERIFY(driver.find<QAbstractButton>("messageOther")->text().contains("Go to"));
    QCOMPARE(driver.paths()->childCount(), 0);
    driver.click("messageAction");
    QVERIFY(driver.settle());
    driver.planPath();
    QTRY_COMPARE_WITH_TIMEOUT(driver.paths()->childCount(), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(driver.paths()->child(0)->text(1).contains("not checked"), kPatienceMs);
    driver.click("quickActions/undo");  // the path
    driver.click("quickActions/undo");  // the pair
    QVERIFY(driver.settle());
    driver.planPath();
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("collides"), kPatienceMs);
    QCOMPARE(driver.paths()->childCount(), 0);
  }

  // The same with a body that nothing is worked on: no click lets the tool touch it, but one shows where they meet.
  void aToolMustNotTouchAWall() {
    LongTool driver;
    driver.storeAt("joint.joint_1", "60");
    QVERIFY(driver.settle());
    driver.planPath();
    auto* const go = driver.find<QAbstractButton>("messageAction");
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("messageText").contains("collides"), kPatienceMs);
    const QString begin = driver.configurations()->child(0)->text(0);
    QVERIFY(driver.text("messageText").contains(begin));
    QVERIFY2(go->isVisible() && go->text().contains("Go to " + begin), qPrintable(go->text()));
    QVERIFY(!driver.find<QAbstractButton>("messageOther")->isVisible());
    driver.click("messageAction");
    QVERIFY(driver.settle());
    QCOMPARE(driver.numberOf("property/joint.joint_1").toDouble(), 0.0);
    QVERIFY(driver.find<QAction>("undo")->text().contains("Go to " + begin));
  }
};

HANDWHEEL_WINDOW_TEST(CellReplanningWindowTest)
#include "CellReplanningWindowTest.moc"
