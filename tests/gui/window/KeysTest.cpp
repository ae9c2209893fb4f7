// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QComboBox>
#include <QDockWidget>
#include <QUndoStack>

using namespace handwheel;
using namespace handwheel::test;

// Keys go where the user means them to, and end what they should.
class KeysTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString fileWithHoles(const char* name) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, quadTorus(48, 24, {{3, 5}, {20, 11}, {35, 17}}));
    return path;
  }
  // Keys of menus need an active window.
  static void press(WindowDriver& driver, int key) {
    driver.window().activateWindow();
    if (!QTest::qWaitForWindowActive(&driver.window())) qFatal("the window does not become active");
    auto* view = driver.find<Viewport>("viewport");
    view->setFocus();
    QTest::keyClick(view, Qt::Key(key));
  }

 private slots:
  void keysInTheViewWorkTheTool() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("view.stl")));
    press(driver, Qt::Key_N);
    QVERIFY(driver.find<QWidget>("holeSettings")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("previewStatus").contains("new triangle"), kPatienceMs);
    press(driver, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 2, kPatienceMs);
    QVERIFY(driver.settle());
    QTRY_VERIFY(!driver.find<QWidget>("holeSettings")->isVisible());  // nothing would be filled unseen
    press(driver, Qt::Key_N);
    QTRY_VERIFY(driver.find<QWidget>("holeSettings")->isVisible());
    press(driver, Qt::Key_Escape);
    QTRY_VERIFY(!driver.find<QWidget>("holeSettings")->isVisible());
  }

  // A patch can be looked at for as long as the user wants; N goes on to the hole after it, not to the first.
  void theCameraStaysWithTheNewPatch() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("camera.stl")));
    auto* view = driver.find<Viewport>("viewport");
    QList<Vec3> seen;
    for (int i = 0; i < 3; ++i) {
      press(driver, Qt::Key_N);
      seen << view->camera().centre;
    }
    press(driver, Qt::Key_N);
    press(driver, Qt::Key_N);  // the second
    QVERIFY((view->camera().centre - seen[1]).norm() < 1e-6);
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("previewStatus").contains("new triangle"), kPatienceMs);
    const CameraState atPatch = view->camera();
    press(driver, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 2, kPatienceMs);
    QVERIFY(driver.settle());
    QTest::qWait(700);  // longer than any flight that would begin by itself
    QCOMPARE(view->camera(), atPatch);
    QVERIFY(!driver.find<QAction>("fillHole")->isEnabled());
    press(driver, Qt::Key_N);
    QVERIFY((view->camera().centre - seen[2]).norm() < 1e-6);
    QVERIFY(std::abs(view->camera().right().z()) < 1e-9);  // level, as in the standard views
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("previewStatus").contains("new triangle"), kPatienceMs);
    press(driver, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 1, kPatienceMs);
    QVERIFY(driver.settle());
  }

  // A hole that is chosen while another one is being filled stays chosen.
  void aHoleChosenMeanwhileStaysChosen() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("meanwhile.stl")));
    driver.clickDefect(DefectKind::Hole, 0);
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("previewStatus").contains("new triangle"), kPatienceMs);
    driver.find<QAction>("fillHole")->trigger();
    if (driver.count(DefectKind::Hole) == 2) QSKIP("filled at once");
    driver.clickDefect(DefectKind::Hole, 1);
    QTRY_COMPARE_WITH_TIMEOUT(driver.count(DefectKind::Hole), 2, kPatienceMs);
    QVERIFY(driver.settle());
    QVERIFY(driver.find<QWidget>("holeSettings")->isVisible());
  }

  // Return takes the choice; it must not fill the selected hole as well.
  void keysInAListOfChoicesStayThere() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("popup.stl")));
    driver.clickDefect(DefectKind::Hole, 0);
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("previewStatus").contains("new triangle"), kPatienceMs);
    auto* methods = driver.find<QComboBox>("fillMethod");
    methods->showPopup();
    QTRY_VERIFY(QApplication::activePopupWidget());
    QTest::keyClick(methods->view(), Qt::Key_Down);
    QTest::keyClick(methods->view(), Qt::Key_Return);
    QTRY_VERIFY(!QApplication::activePopupWidget());
    QCOMPARE(methods->currentIndex(), 1);
    QVERIFY(driver.settle());
    QTest::qWait(100);
    QCOMPARE(driver.count(DefectKind::Hole), 3);
    methods->showPopup();
    QTRY_VERIFY(QApplication::activePopupWidget());
    QTest::keyClick(methods->view(), Qt::Key_Escape);
    QTRY_VERIFY(!QApplication::activePopupWidget());
    QVERIFY(driver.find<QWidget>("holeSettings")->isVisible());  // Esc closed the list, and did not deselect
  }

  void lettersTypedIntoAFieldAreNoCommands() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    auto* line = driver.find<QWidget>("property/diameter")->findChild<QLineEdit*>();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, "1m");  // M is the key of a tool, 1 that of a view
    QCOMPARE(line->text(), QStringLiteral("1m"));
    QVERIFY(!driver.find<QAction>("measureTool")->isChecked());
    QTest::keyClick(line, Qt::Key_Escape);
  }

  // A tool that ends is replaced by the usual one, so a click into a hole always selects it.
  void theUsualToolComesBack() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("usual.stl")));
    QVERIFY(driver.find<QAction>("fillTool")->isChecked());
    press(driver, Qt::Key_S);
    QVERIFY(driver.find<QAction>("selectTool")->isChecked());
    QVERIFY(!driver.find<QAction>("fillTool")->isChecked());
    QTRY_VERIFY(!driver.find<QWidget>("toolPanel")->visibleRegion().isEmpty());  // its settings are at hand
    press(driver, Qt::Key_Return);
    QTRY_VERIFY(driver.find<QAction>("fillTool")->isChecked());
    QVERIFY(!driver.find<QAction>("selectTool")->isChecked());
    QTRY_VERIFY(!driver.find<QWidget>("defectList")->visibleRegion().isEmpty());
    press(driver, Qt::Key_Escape);
    press(driver, Qt::Key_Escape);
    QCoreApplication::processEvents();
    QVERIFY(driver.find<QAction>("fillTool")->isChecked());
    press(driver, Qt::Key_N);
    QTRY_VERIFY(driver.find<QWidget>("holeSettings")->isVisible());
    QVERIFY(driver.settle());
  }

  void aKindWithoutAUsualToolIsLeftWithNone() {
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    QVERIFY(!driver.find<QAction>("measureTool")->isChecked());
    press(driver, Qt::Key_M);
    QVERIFY(driver.find<QAction>("measureTool")->isChecked());
    press(driver, Qt::Key_Escape);
    QTRY_VERIFY(!driver.find<QAction>("measureTool")->isChecked());
  }

  void eachDocumentKeepsItsTool() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("first.stl")));
    press(driver, Qt::Key_S);
    QVERIFY(driver.open(fileWithHoles("second.stl")));
    QVERIFY(driver.find<QAction>("fillTool")->isChecked());
    driver.choose("nextDocument");
    QVERIFY(driver.find<QAction>("selectTool")->isChecked());
    driver.choose("previousDocument");
    QVERIFY(driver.find<QAction>("fillTool")->isChecked());
    QVERIFY(driver.settle());
  }

  // The tooltip and the page of keys follow the user's choice.
  void changedKeysAreReported() {
    WindowDriver driver;
    auto* open = driver.find<QAction>("openFile");
    open->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_F5));
    QVERIFY(open->toolTip().contains("Ctrl+F5"));
    driver.choose("showKeys");
    auto* page = driver.find<QWidget>("keysPage");
    QVERIFY(page->findChild<QLabel*>()->text().contains("Ctrl+F5"));
    page->close();
    QVERIFY(driver.open(fileWithHoles("list.stl")));
    driver.find<QAction>("closeDocument")->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_F6));
    QVERIFY(driver.find<QToolButton>("closeTab")->toolTip().contains("Ctrl+F6"));
    QVERIFY(driver.settle());
  }

  // Every command of the menus can be found by its name and be given a key.
  void everyCommandIsFound() {
    WindowDriver driver;
    QVERIFY(driver.open(fileWithHoles("all.stl")));
    const QList<QAction*> known = driver.window().findChildren<QAction*>();
    for (const QMenu* menu : driver.window().findChildren<QMenu*>()) {
      for (QAction* action : menu->actions()) {
        if (action->isSeparator() || action->menu() || action->objectName().isEmpty()) continue;
        QVERIFY2(known.contains(action), qPrintable(action->text()));
      }
    }
    QVERIFY(driver.settle());
  }
};

HANDWHEEL_WINDOW_TEST(KeysTest)
#include "KeysTest.moc"
