// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "controls/PropertyList.h"
#include "viewport/surface/PartsLayer.h"

#include <QDockWidget>
#include <QUndoStack>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A window with the sample robot and its means to look at bodies.
class CellWindow : public WindowDriver {
 public:
  CellWindow() {
    choose("openRobotSample");
    if (!settle()) qFatal("the sample does not open");
  }
  Viewport* view() { return find<Viewport>("viewport"); }
  // At once, where the camera would take its time.
  void showAll() {
    view()->fit();
    view()->setCamera(view()->camera());
  }
  QString figures() { return text("figures"); }

  // The text of a field of the selected body in the panel of the cell; none where it is not listed.
  QString field(const char* property) {
    const QString name = QStringLiteral("property/") + QString::fromLatin1(property);
    for (const auto* row : find<QDockWidget>("kindDock")->findChildren<QWidget*>(name)) {
      // One that was hidden is about to be deleted; a new one is shown with the next event.
      const bool isLeaving = row->isHidden() && row->testAttribute(Qt::WA_WState_ExplicitShowHide);
      if (!isLeaving) return row->findChild<QLineEdit*>()->text();
    }
    return {};
  }

  // A place in the view where this part is seen; null where it is not.
  QPoint placeOf(const std::string& part) {
    if (!QTest::qWaitFor([this] { return view()->isPickingReady(); }, kPatienceMs)) return {};
    for (int y = 10; y < view()->height(); y += 6) {
      for (int x = 10; x < view()->width(); x += 6) {
        const ViewRay ray = view()->rayAt(QPointF(x, y));
        if (partOf(view()->pickAlong(ray.origin, ray.direction)) == part) return {x, y};
      }
    }
    return {};
  }

  void move(const QPoint& to) {
    QMouseEvent moved(QEvent::MouseMove, to, view()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view(), &moved);
  }
};

}  // namespace

// What stands beside a robot: added, selected, moved, hidden, removed in the window.
class CellBodiesWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void aShapeIsAddedAndChangedByItsFields() {
    CellWindow driver;
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
    CellWindow driver;
    driver.choose("add-box");
    driver.choose("add-sphere");
    QVERIFY(driver.settle());
    driver.showAll();
    QCOMPARE(driver.field("body.2.name"), "sphere");
    const QPoint grip = driver.placeOf("body.1");
    QVERIFY(!grip.isNull());
    QTest::mouseClick(driver.view(), Qt::LeftButton, {}, grip);
    QCOMPARE(driver.field("body.1.name"), "box");
    QVERIFY(driver.field("body.2.name").isEmpty());

    auto* undo = driver.find<QAction>("undo");
    const QString added = undo->text(), place = driver.field("body.1.x") + driver.field("body.1.y");
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
    QVERIFY(driver.field("body.1.x") + driver.field("body.1.y") != place);
    driver.click("quickActions/undo");
    QCOMPARE(driver.field("body.1.x") + driver.field("body.1.y"), place);
    QCOMPARE(undo->text(), added);
  }

  void bodiesAreHiddenAndRemoved() {
    CellWindow driver;
    const QString before = driver.figures();
    driver.choose("add-cylinder");
    QVERIFY(driver.settle());
    driver.showAll();
    QVERIFY(!driver.placeOf("body.1").isNull());
    driver.choose("hideBody");
    QVERIFY(driver.settle());
    QVERIFY(driver.placeOf("body.1").isNull());
    driver.choose("showBodies");
    QVERIFY(driver.settle());
    QVERIFY(!driver.placeOf("body.1").isNull());
    driver.view()->setFocus();
    QTest::keyClick(driver.view(), Qt::Key_Delete);
    QVERIFY(driver.settle());
    QCOMPARE(driver.figures(), before);
    QVERIFY(!driver.find<QAction>("removeBody")->isEnabled());
  }

  void aLinkedFileIsMissed() {
    const QTemporaryDir folder;
    const QString part = folder.filePath("part.stl");
    writeStl(part, quadTorus(24, 12, {}));
    const QString cell = folder.filePath("cell.handwheel");
    {
      CellWindow driver;
      driver.choose("linkBody");
      QVERIFY(driver.enterFileName("addBodyDialog", part));
      QTRY_COMPARE_WITH_TIMEOUT(driver.field("body.1.name"), QString("part"), kPatienceMs);
      driver.click("quickActions/saveFile");
      QVERIFY(driver.enterFileName("saveDialog", cell));
      QVERIFY(driver.settle());
    }
    QVERIFY(QFile::remove(part));
    WindowDriver driver;
    QVERIFY(driver.open(cell));
    QTRY_VERIFY(driver.text("messageText").contains("part.stl"));
  }
};

HANDWHEEL_WINDOW_TEST(CellBodiesWindowTest)
#include "CellBodiesWindowTest.moc"
