// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LargeInputs.h"
#include "QuickWindow.h"
#include "StlFiles.h"
#include "WindowTestMain.h"
#include "mesh/holes/Patch.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/Samples.h"

#include <rapidcheck.h>
#include <QComboBox>
#include <QPlainTextEdit>
#include <QTreeView>

using namespace handwheel;
using namespace handwheel::test;

// A selection in one document is never looked up in another, which may have fewer holes; nor is typed text.
class DocumentSwitchTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  // Returns a file with this number of holes, each a quad.
  QString fileWithHoles(int holes) {
    const QString path = m_folder.filePath(QStringLiteral("%1-holes.stl").arg(holes));
    std::set<std::pair<int, int>> missing;
    for (int i = 0; i < holes; ++i) missing.emplace(4 * i, 3);
    writeStl(path, quadTorus(48, 24, missing));
    return path;
  }
  static void press(WindowDriver& driver, const char* action) {
    if (auto* wanted = driver.find<QAction>(action); wanted->isEnabled()) wanted->trigger();
  }
  // The row that the list shows as selected names a hole of the document in view.
  static bool isSelectionOfDocument(WindowDriver& driver) {
    const auto rows = driver.find<QTreeView>("defectList")->selectionModel()->selectedRows();
    return std::all_of(rows.begin(), rows.end(), [&](const QModelIndex& row) { return row.isValid(); }) &&
           driver.find<QAction>("deselect")->isEnabled() == !rows.isEmpty();
  }

 private slots:
  void initTestCase() {
    const QByteArray draws = QByteArray::number(sized(4, 8));
    qputenv("RC_PARAMS", qgetenv("RC_PARAMS") + " max_success=" + draws);
  }

  void toOneWithFewerHoles() {
    QuickWindow driver;
    QVERIFY(driver.open(fileWithHoles(1)));
    QVERIFY(driver.open(fileWithHoles(4)));
    for (int i = 0; i < 4; ++i) press(driver, "nextHole");
    QVERIFY(driver.settle());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    QVERIFY(isSelectionOfDocument(driver));
    QVERIFY(!driver.find<QAction>("deselect")->isEnabled());
    // The other still has its own.
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(1);
    QVERIFY(driver.settle());
    QVERIFY(driver.find<QAction>("deselect")->isEnabled());
    // Opening a file is a switch, too.
    QVERIFY(driver.open(fileWithHoles(0)));
    QVERIFY(!driver.find<QAction>("nextHole")->isEnabled());
    QVERIFY(isSelectionOfDocument(driver));
  }

  // The method that is chosen for the holes of one document is not that of another; it is saved with the document.
  void theMethodBelongsToTheDocument() {
    QuickWindow driver;
    QVERIFY(driver.open(fileWithHoles(1)));
    QVERIFY(driver.open(fileWithHoles(2)));
    auto* tabs = driver.find<QTabBar>("documentTabBar");
    auto* method = driver.find<QComboBox>("fillMethod");
    const QString usual = method->currentText();
    press(driver, "nextHole");
    QVERIFY(driver.settle());
    const int flat = method->findData(static_cast<int>(FillMethod::Flat));
    method->setCurrentIndex(flat);
    QVERIFY(driver.settle());
    tabs->setCurrentIndex(0);
    QVERIFY(driver.settle());
    QCOMPARE(method->currentText(), usual);
    tabs->setCurrentIndex(1);
    QVERIFY(driver.settle());
    QCOMPARE(method->currentIndex(), flat);
    const QString path = m_folder.filePath("flat.handwheel");
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", path) && driver.settle());
    QuickWindow again;
    QVERIFY(again.open(path));
    QVERIFY(again.settle());
    QCOMPARE(again.find<QComboBox>("fillMethod")->currentIndex(), flat);
  }

  // Typed text belongs to the document that was in view, also if its tab is left by a click or a key.
  void aTypedTaskStaysWithItsExercise() {
    const QTemporaryDir folder;
    QuickWindow driver;
    for (const char* name : {"one.exercise.json", "two.exercise.json"}) {
      const QString path = folder.filePath(QLatin1String(name));
      QVERIFY(QFile::copy(samplePath("shaft.exercise.json"), path));
      QVERIFY(driver.open(path));
    }
    auto* tabs = driver.window().findChild<DocumentTabs*>();
    const auto task = [&](std::size_t tab) {
      return std::get<std::string>(tabs->all()[tab]->document.property("text")->value);
    };
    const std::string before = task(0);
    auto* row = driver.find<QWidget>("exerciseEditor")->findChild<QWidget*>("property/text");
    QVERIFY(row);
    auto* field = row->findChild<QPlainTextEdit*>("propertyLongText");
    QTRY_VERIFY(field->isVisible());
    driver.window().activateWindow();
    field->setFocus();
    QTRY_VERIFY(field->hasFocus());
    QTest::keyClicks(field, "Mine. ");
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    QCOMPARE(task(1), "Mine. " + before);
    QCOMPARE(task(0), before);
  }

  // Switches with any selection, loop kept open, preview or tool; also while jobs run.
  void inEveryState() {
    const bool holds = rc::check([this] {
      QuickWindow driver;
      for (const int holes : {0, 5, 2}) RC_ASSERT(driver.open(fileWithHoles(holes)));
      driver.choose("openShaftSample");
      RC_ASSERT(driver.settle());
      const auto steps = *rc::gen::container<std::vector<int>>(30, rc::gen::inRange(0, 15));
      const char* const tools[] = {"fillTool", "selectTool", "boundaryTool", "sculptTool", "measureTool"};
      const char* const actions[] = {"nextHole", "previousHole", "keepOpen", "deselect", "fillHole", "undo"};
      for (const int step : steps) {
        auto* tabs = driver.find<QTabBar>("documentTabBar");
        if (step < 4) tabs->setCurrentIndex(step);
        if (step >= 4 && step < 10) press(driver, actions[step - 4]);
        if (step >= 10) press(driver, tools[step - 10]);
        if (step % 3 == 0) RC_ASSERT(driver.settle());
        RC_ASSERT(tabs->currentIndex() == 3 || isSelectionOfDocument(driver));
      }
      RC_ASSERT(driver.settle());
      RC_ASSERT(driver.tabs() == 4);
    });
    QVERIFY(holds);
  }
};

HANDWHEEL_WINDOW_TEST(DocumentSwitchTest)
#include "DocumentSwitchTest.moc"
