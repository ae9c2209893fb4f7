// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../StlFiles.h"
#include "../WindowTestMain.h"
#include "CellWindow.h"

#include <QInputDialog>
#include <QPointer>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

// Bodies beside a robot: added, selected, moved, hidden, removed in the window.
class CellBodiesWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void aShapeIsAddedAndChangedByItsFields() {
    CellWindow& driver = m_window.begin();
    const QString before = driver.figures();
    driver.choose("add-box");
    QVERIFY(driver.settle());
    QVERIFY(driver.figures() != before);
    QCOMPARE(driver.field("body.1.name"), "box");
    driver.edit("body.1.name", "vice");
    QCOMPARE(driver.field("body.1.name"), "vice");
    driver.edit("body.1.y", "250");
    QVERIFY(driver.field("body.1.y").startsWith("250"));
    driver.click("quickActions/undo");
    QVERIFY(driver.field("body.1.y").startsWith("0"));
    driver.click("quickActions/undo");
    QCOMPARE(driver.field("body.1.name"), "box");
    driver.click("quickActions/undo");
    QCOMPARE(driver.figures(), before);
    QVERIFY(driver.field("body.1.name").isEmpty());
  }

  void aClickSelectsAndADragMoves() {
    CellWindow& driver = m_window.begin();
    driver.choose("add-box");
    driver.choose("add-sphere");
    QVERIFY(driver.settle());
    driver.showAll();
    QCOMPARE(driver.field("body.2.name"), "sphere");
    const QPoint grip = driver.pixelOf("body.1");
    QVERIFY(!grip.isNull());
    QTest::mouseClick(driver.view(), Qt::LeftButton, {}, grip);
    QCOMPARE(driver.field("body.1.name"), "box");
    QVERIFY(driver.field("body.2.name").isEmpty());

    auto* undo = driver.find<QAction>("undo");
    const QString added = undo->text(), position = driver.field("body.1.x") + driver.field("body.1.y");
    QTest::mousePress(driver.view(), Qt::LeftButton, {}, grip);
    driver.move(grip + QPoint(30, 10));
    QTest::keyClick(driver.view(), Qt::Key_Escape);  // takes it back
    QTest::mouseRelease(driver.view(), Qt::LeftButton, {}, grip + QPoint(30, 10));
    QCOMPARE(undo->text(), added);
    QTest::mousePress(driver.view(), Qt::LeftButton, {}, grip);
    driver.move(grip + QPoint(15, 5));
    driver.move(grip + QPoint(40, 20));
    QTest::mouseRelease(driver.view(), Qt::LeftButton, {}, grip + QPoint(40, 20));
    QVERIFY(undo->text().contains("Move box"));
    QVERIFY(driver.field("body.1.x") + driver.field("body.1.y") != position);
    driver.click("quickActions/undo");
    QCOMPARE(driver.field("body.1.x") + driver.field("body.1.y"), position);
    QCOMPARE(undo->text(), added);
  }

  // A body inside the robot is moved to the position of new shapes; not one that the robot carries.
  void besideTheOthers() {
    CellWindow& driver = m_window.begin();
    driver.choose("add-box");
    QVERIFY(driver.settle());
    const QString x = driver.field("body.1.x"), y = driver.field("body.1.y"), z = driver.field("body.1.z");
    driver.edit("body.1.x", "0");
    driver.edit("body.1.y", "10");
    driver.edit("body.1.z", "20");
    QVERIFY(driver.settle());
    driver.choose("placeBeside");
    QVERIFY(driver.settle());
    QCOMPARE(driver.field("body.1.x"), x);
    QCOMPARE(driver.field("body.1.y"), y);
    QCOMPARE(driver.field("body.1.z"), z);
    driver.click("quickActions/undo");
    QVERIFY(driver.field("body.1.x").startsWith("0"));
    driver.choose("mountBody");
    QVERIFY(!driver.find<QAction>("placeBeside")->isEnabled());
  }

  // A body that its file puts into the robot is placed beside the others, on the floor, and its message offers the pose
  // of the file; if that is free it is kept. The ring reaches 10 mm above and below the origin of its file.
  void aFileThatIsInsideTheRobot() {
    const QTemporaryDir folder;
    const QString inside = folder.filePath("inside.stl"), apart = folder.filePath("apart.stl");
    writeStl(inside, quadTorus(24, 12, {}));
    std::vector<Corners> far = quadTorus(24, 12, {});
    for (Corners& triangle : far) {
      for (Corner& corner : triangle) corner[1] += 2000.0f;
    }
    writeStl(apart, far);
    CellWindow& driver = m_window.begin();
    const auto number = [&](const char* field) { return QLocale().toDouble(driver.field(field).section(' ', 0, 0)); };
    driver.choose("addBody");
    QVERIFY(driver.enterFileName("addBodyDialog", inside));
    QTRY_COMPARE_WITH_TIMEOUT(driver.field("body.1.name"), QString("inside"), kPatienceMs);
    QVERIFY(driver.text("messageText").contains("beside the others"));
    QVERIFY(driver.text("messageText").contains("has no unit"));
    QVERIFY(number("body.1.x") > 130.0 + 40.0);  // the radii of the base and of the ring
    QCOMPARE(number("body.1.z"), 10.0);
    driver.click("messageOther");
    QVERIFY(driver.settle());
    QCOMPARE(number("body.1.x"), 0.0);
    QCOMPARE(number("body.1.z"), 0.0);
    driver.click("quickActions/undo");
    QCOMPARE(number("body.1.z"), 10.0);
    driver.click("quickActions/undo");
    QCOMPARE(driver.listedBodies(), 0);
    driver.choose("addBody");
    QVERIFY(driver.enterFileName("addBodyDialog", apart));
    QTRY_COMPARE_WITH_TIMEOUT(driver.field("body.1.name"), QString("apart"), kPatienceMs);
    QVERIFY(!driver.text("messageText").contains("beside the others"));
    QCOMPARE(number("body.1.x"), 0.0);
    QCOMPARE(number("body.1.z"), 0.0);
  }

  // The message after mounting offers the tool centre point at the tip; one step, also by the menu.
  void theCentrePointIsPutAtTheTip() {
    CellWindow& driver = m_window.begin();
    driver.choose("add-box");
    QVERIFY(driver.settle());
    auto* const tip = driver.find<QAction>("centreAtTip");
    QVERIFY(!tip->isEnabled());
    driver.choose("mountBody");
    QVERIFY(tip->isEnabled());
    driver.click("messageAction");
    auto* const undo = driver.find<QAction>("undo");
    QVERIFY(undo->text().contains("Tool centre point at the tip of box"));
    driver.click("quickActions/undo");
    QVERIFY(undo->text().contains("Mount box"));
    driver.choose("centreAtTip");
    QVERIFY(undo->text().contains("Tool centre point at the tip of box"));
    QVERIFY(driver.settle());
  }

  // A tool goes with the robot, is dragged with it, and stays in the air when it is taken off.
  void aToolIsMountedAndTakenOff() {
    CellWindow& driver = m_window.begin();
    driver.choose("add-sphere");
    QVERIFY(driver.settle());
    driver.edit("body.1.x", "1500");
    auto* mount = driver.find<QAction>("mountBody");
    auto* release = driver.find<QAction>("releaseBody");
    QVERIFY(mount->isEnabled() && !release->isEnabled());
    driver.choose("mountBody");
    QVERIFY(driver.field("body.1.x").startsWith("0"));
    QVERIFY(release->isEnabled());
    driver.showAll();
    const QPoint grip = driver.pixelOf("body.1");
    QVERIFY(!grip.isNull());
    auto* undo = driver.find<QAction>("undo");
    QTest::mousePress(driver.view(), Qt::LeftButton, {}, grip);
    driver.move(grip + QPoint(20, 15));
    driver.move(grip + QPoint(60, 40));
    QTest::mouseRelease(driver.view(), Qt::LeftButton, {}, grip + QPoint(60, 40));
    QVERIFY(undo->text().contains("Move") && !undo->text().contains("sphere"));
    QVERIFY(driver.field("body.1.x").startsWith("0"));
    driver.choose("releaseBody");
    QVERIFY(!release->isEnabled());
    QVERIFY(!driver.field("body.1.x").startsWith("0"));
    driver.click("quickActions/undo");
    QVERIFY(release->isEnabled());
  }

  void theFieldsFollowADragAndTheLabelGoesWithEscape() {
    CellWindow& driver = m_window.begin();
    driver.choose("add-box");
    QVERIFY(driver.settle());
    driver.showAll();
    const QPoint grip = driver.pixelOf("body.1");
    QVERIFY(!grip.isNull());
    const auto position = [&] { return driver.field("body.1.x") + driver.field("body.1.y"); };
    const QString before = position(), height = driver.field("body.1.z");
    auto* label = driver.find<QLabel>("toolReadout");
    QTest::mousePress(driver.view(), Qt::LeftButton, {}, grip);
    driver.move(grip + QPoint(40, 10));
    QTRY_VERIFY(position() != before);
    QCOMPARE(driver.field("body.1.z"), height);
    QVERIFY(label->isVisible());
    QVERIFY2(!label->text().contains("10000000"), qPrintable(label->text()));
    QTest::keyClick(driver.view(), Qt::Key_Escape);
    QVERIFY(!label->isVisible());
    QTRY_COMPARE(position(), before);
    QTest::mouseRelease(driver.view(), Qt::LeftButton, {}, grip + QPoint(40, 10));
  }

  // Wherever the arm reaches: beside it as it was opened, on the floor.
  void aNewShapeStandsOnTheFloor() {
    CellWindow& driver = m_window.begin();
    driver.choose("add-box");
    const QString x = driver.field("body.1.x");
    QVERIFY(driver.field("body.1.z").startsWith("50"));
    driver.click("quickActions/undo");
    driver.edit("joint.joint_2", "80");
    driver.choose("add-box");
    QCOMPARE(driver.field("body.1.x"), x);
    QVERIFY(driver.field("body.1.z").startsWith("50"));
  }

  void bodiesAreHiddenAndRemoved() {
    CellWindow& driver = m_window.begin();
    const QString before = driver.figures();
    driver.choose("add-cylinder");
    QVERIFY(driver.settle());
    driver.showAll();
    QVERIFY(!driver.pixelOf("body.1").isNull());
    driver.choose("hideBody");
    QVERIFY(driver.settle());
    QVERIFY(driver.pixelOf("body.1").isNull());
    driver.choose("showBodies");
    QVERIFY(driver.settle());
    QVERIFY(!driver.pixelOf("body.1").isNull());
    driver.view()->setFocus();
    QTest::keyClick(driver.view(), Qt::Key_Delete);
    QVERIFY(driver.settle());
    QCOMPARE(driver.figures(), before);
    QVERIFY(!driver.find<QAction>("removeBody")->isEnabled());
  }

  // A file without a unit: its size is said, and a choice of units scales it, in one step.
  void theUnitIsChosen() {
    const QTemporaryDir folder;
    const QString part = folder.filePath("part.stl");
    writeStl(part, quadTorus(24, 12, {}));
    CellWindow& driver = m_window.begin();
    driver.choose("addBody");
    QVERIFY(driver.enterFileName("addBodyDialog", part));
    QTRY_COMPARE_WITH_TIMEOUT(driver.field("body.1.name"), QString("part"), kPatienceMs);
    QVERIFY(driver.text("messageText").contains("part.stl has no unit"));
    const auto choose = [&](const char* unit) {
      driver.choose("bodyUnit");
      const QPointer<QInputDialog> dialog = driver.find<QInputDialog>("bodyUnitDialog");
      const QStringList all = dialog->comboBoxItems();
      const auto found =
          std::find_if(all.begin(), all.end(), [&](const QString& each) { return each.startsWith(unit); });
      if (found == all.end()) return QString();
      const QString text = *found;
      dialog->setTextValue(text);
      dialog->accept();
      return QTest::qWaitFor([&] { return dialog.isNull(); }) ? text : QString();
    };
    const auto sizeIn = [](const QString& text) {
      return QLocale().toDouble(text.section("measures ", 1).section(' ', 0, 0));
    };
    const double millimetres = sizeIn(choose("mm:"));  // Unscaled
    QVERIFY(millimetres > 0.0);
    const QString inches = choose("in:");
    QVERIFY2(std::abs(sizeIn(inches) - 25.4 * millimetres) < 0.002 * 25.4 * millimetres, qPrintable(inches));
    QTRY_VERIFY(driver.find<QAction>("undo")->text().contains("unit"));
    QVERIFY(!driver.text("messageText").contains("has no unit") || !driver.find<QLabel>("messageText")->isVisible());
    QVERIFY(std::abs(sizeIn(choose("mm:")) - 25.4 * millimetres) < 0.002 * 25.4 * millimetres);
    driver.click("quickActions/undo");
    QVERIFY(std::abs(sizeIn(choose("mm:")) - millimetres) < 1e-9);
  }

  void aBodyIsLinkedToAnotherFile() {
    const QTemporaryDir folder;
    const QString first = folder.filePath("first.stl"), second = folder.filePath("second.stl");
    writeStl(first, quadTorus(24, 12, {}));
    writeStl(second, quadTorus(12, 6, {}));
    CellWindow& driver = m_window.begin();
    driver.choose("linkBody");
    QVERIFY(driver.enterFileName("addBodyDialog", first));
    QTRY_COMPARE_WITH_TIMEOUT(driver.field("body.1.name"), QString("first"), kPatienceMs);
    driver.edit("body.1.x", "300");
    driver.choose("relinkBody");
    QVERIFY(driver.enterFileName("addBodyDialog", second));
    QVERIFY(driver.settle());
    QTRY_VERIFY(driver.find<QAction>("undo")->text().contains("Link first to another file"));
    QVERIFY(driver.field("body.1.x").startsWith("300"));
    const QModelIndex link = driver.list()->model()->index(0, BodyModel::Link);
    QVERIFY(link.data(Qt::ToolTipRole).toString().endsWith("second.stl"));
  }

  void aLinkedFileIsMissed() {
    const QTemporaryDir folder;
    const QString part = folder.filePath("part.stl");
    writeStl(part, quadTorus(24, 12, {}));
    const QString cell = folder.filePath("cell.handwheel");
    {
      CellWindow& driver = m_window.begin();
      driver.choose("linkBody");
      QVERIFY(driver.enterFileName("addBodyDialog", part));
      QTRY_COMPARE_WITH_TIMEOUT(driver.field("body.1.name"), QString("part"), kPatienceMs);
      driver.click("quickActions/saveFile");
      QVERIFY(driver.enterFileName("saveDialog", cell));
      QVERIFY(driver.settle());
      m_window.end();
    }
    QVERIFY(QFile::remove(part));
    WindowDriver driver;
    QVERIFY(driver.open(cell));
    QTRY_VERIFY(driver.text("messageText").contains("part.stl"));
  }

  void aFileIsReadForItsDocument() {
    const QTemporaryDir folder;
    const QString part = folder.filePath("part.stl");
    writeStl(part, quadTorus(24, 12, {}));
    m_window.end();
    CellWindow driver;
    QVERIFY(driver.open(part));
    auto* tabs = driver.find<QTabBar>("documentTabBar");
    QCOMPARE(tabs->count(), 2);
    tabs->setCurrentIndex(0);
    driver.hold();
    driver.choose("addBody");
    QVERIFY(driver.enterFileName("addBodyDialog", part));
    tabs->setCurrentIndex(1);
    driver.release();
    QVERIFY(driver.settle());
    tabs->setCurrentIndex(0);
    QCOMPARE(driver.listedBodies(), 1);
  }

 private:
  SharedWindow<CellWindow> m_window;
};

HANDWHEEL_WINDOW_TEST(CellBodiesWindowTest)
#include "CellBodiesWindowTest.moc"
