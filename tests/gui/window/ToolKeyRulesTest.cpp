// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ToolKeysFixture.h"
#include "WindowTestMain.h"

using namespace handwheel;
using namespace handwheel::test;

// The keys that can be given to the actions of tools, and the treatment of keys that are already in use.
class ToolKeyRulesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }
  void nothingCollidesFromTheBeginning();
  void conflictsBothWays();
  void twoOfOneTool();
  void whatEndsStays();
  void toFileAndBack();
  void hostileSettings();
};

void ToolKeyRulesTest::nothingCollidesFromTheBeginning() {
  WindowDriver driver;
  const KeyPage page(driver);
  for (int row = 0; row < page.rows().rowCount(); ++row) {
    const QModelIndex index = page.rows().index(row, 0);
    QVERIFY2(index.data(ShortcutModel::ConflictRole).toStringList().isEmpty(), qPrintable(index.data().toString()));
  }
}

void ToolKeyRulesTest::conflictsBothWays() {
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  auto* view = driver.find<Viewport>("viewport");
  {
    KeyPage page(driver);
    page.press(kSmaller, Qt::Key_7);  // is that of a view
    QCOMPARE(page.conflicts(kSmaller), QStringList{"Isometric"});
    QCOMPARE(page.conflicts("viewIsometric"), QStringList{"Select faces › Smaller brush"});
    QVERIFY2(page.status().contains("Isometric") && page.status().contains("active tool"), qPrintable(page.status()));
    QVERIFY(driver.find<QPushButton>("shortcutTake")->isVisible());
  }
  view->setStandardView(StandardView::Front);
  QTRY_VERIFY(driver.window().isSettled());
  const Vec3 front = view->camera().towardsViewer();
  const double before = fixture.radius();
  fixture.press(Qt::Key_7);
  QVERIFY(fixture.radius() < before);
  driver.find<QAction>("measureTool")->trigger();  // it leaves the key to the window
  fixture.press(Qt::Key_7);
  QTRY_VERIFY((view->camera().towardsViewer() - front).norm() > 0.1);
  KeyPage page(driver);
  page.press("fitView", Qt::Key_BracketRight);    // the opposite direction
  QCOMPARE(page.conflicts("fitView").size(), 3);  // to select, to sculpt, to shape clay
  QVERIFY(page.conflicts("tool/sculpt/larger").contains("Fit"));
  page.choose(kSmaller);
  driver.click("shortcutTake");
  QCOMPARE(page.shownKeys("viewIsometric"), QString());
  QCOMPARE(page.conflicts(kSmaller), QStringList());
  driver.click("shortcutReset");
  QCOMPARE(page.shownKeys(kSmaller), QStringLiteral("["));
  driver.click("shortcutResetAll");
  QCOMPARE(page.shownKeys("viewIsometric"), QStringLiteral("7"));
}

void ToolKeyRulesTest::twoOfOneTool() {
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  {
    KeyPage page(driver);
    page.press(kSmaller, Qt::Key_BracketRight);
    QCOMPARE(page.conflicts(kSmaller), QStringList{"Select faces › Larger brush"});
    QVERIFY2(page.status().contains("neither works"), qPrintable(page.status()));
  }
  const double before = fixture.radius();
  fixture.press(Qt::Key_BracketRight);
  QCOMPARE(fixture.radius(), before);
}

void ToolKeyRulesTest::whatEndsStays() {
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  {
    KeyPage page(driver);
    page.choose("tool/select/commit");
    QVERIFY(!driver.find<QKeySequenceEdit>("shortcutKeys")->isEnabled());
    QVERIFY(!driver.find<QPushButton>("shortcutNone")->isEnabled());
    QVERIFY(page.status().contains("Return"));
    QCOMPARE(page.rowOf("tool/select/commit").data(Qt::ToolTipRole).toString(), page.status());
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape}) {
      for (const char* id : {kSmaller, "fitView"}) {
        const QString before = page.shownKeys(id);
        page.press(id, key);
        QCOMPARE(page.shownKeys(id), before);
        QVERIFY2(page.status().contains("Esc"), qPrintable(page.status()));
      }
    }
    page.press("fillHole", Qt::Key_F5);  // may lose them, and take them back
    QCOMPARE(page.shownKeys("fillHole"), QStringLiteral("F5"));
    driver.click("shortcutReset");
    QCOMPARE(page.shownKeys("fillHole"), QStringLiteral("Return; Enter"));
    page.press(kSmaller, Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(page.shownKeys(kSmaller), QStringLiteral("Ctrl+Return"));
  }
  const double before = fixture.radius();
  fixture.press(Qt::Key_Return, Qt::ControlModifier);
  QVERIFY(fixture.radius() < before);
  fixture.press(Qt::Key_Enter, Qt::KeypadModifier);
  QTRY_VERIFY(driver.find<QAction>("fillTool")->isChecked());
}

void ToolKeyRulesTest::toFileAndBack() {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("keys.json"));
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  {
    KeyPage page(driver);
    page.press(kSmaller, Qt::Key_X);
    page.useFile("shortcutExport", "shortcutExportDialog", path);
    driver.click("shortcutResetAll");
    QCOMPARE(page.shownKeys(kSmaller), QStringLiteral("["));
    page.useFile("shortcutImport", "shortcutImportDialog", path);
    QCOMPARE(page.shownKeys(kSmaller), QStringLiteral("X"));
  }
  const double before = fixture.radius();
  fixture.press(Qt::Key_X);
  QVERIFY(fixture.radius() < before);
  // A file of another's making cannot give away what ends.
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(R"({"format":"handwheel-shortcuts","version":1,"shortcuts":{"tool/select/smaller":["Return"],
    "tool/select/larger":["V, V"],"tool/select/commit":["V"],"fitView":["Esc"]}})");
  file.close();
  KeyPage page(driver);
  page.useFile("shortcutImport", "shortcutImportDialog", path);
  QCOMPARE(page.shownKeys("tool/select/commit"), QStringLiteral("Return"));
  for (const char* id : {kSmaller, "tool/select/larger", "fitView"}) {
    QVERIFY2(!page.shownKeys(id).contains("Return") && !page.shownKeys(id).contains("V") &&
                 !page.shownKeys(id).contains("Esc"),
             qPrintable(page.shownKeys(id)));
  }
}

void ToolKeyRulesTest::hostileSettings() {
  QSettings settings;
  settings.setValue("shortcuts/tool/select/smaller", QStringList{"Ctrl+Blah"});
  settings.setValue("shortcuts/tool/select/larger", QStringList{"Esc", "Q"});
  settings.setValue("shortcuts/tool/select/commit", QStringList{"Q"});
  settings.setValue("shortcuts/tool/select/all", 7);
  settings.setValue("shortcuts/tool/unknown/all", QStringList{"Q"});
  settings.setValue("shortcuts/fitView", QStringList{"Return"});
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  const KeyPage page(driver);
  QCOMPARE(page.shownKeys(kSmaller), QStringLiteral("["));
  QCOMPARE(page.shownKeys("tool/select/larger"), QStringLiteral("Q"));
  QCOMPARE(page.shownKeys("tool/select/commit"), QStringLiteral("Return"));
  QCOMPARE(page.shownKeys("fitView"), QStringLiteral("F"));
}

HANDWHEEL_WINDOW_TEST(ToolKeyRulesTest)
#include "ToolKeyRulesTest.moc"
