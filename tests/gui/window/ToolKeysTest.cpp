// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ToolKeysFixture.h"
#include "WindowTestMain.h"
#include "controls/CommandModel.h"
#include "tools/MeasureTool.h"
#include "tools/cell/JointDragTool.h"
#include "tools/mesh/DecimateTool.h"
#include "tools/mesh/FillHoleTool.h"
#include "tools/mesh/MakeFaceTool.h"
#include "tools/mesh/SelectTool.h"
#include "tools/mesh/SubdivideTool.h"
#include "tools/mesh/TransformTool.h"
#include "tools/mesh/boundary/BoundaryTool.h"
#include "tools/mesh/sculpt/SculptTool.h"
#include "tools/mesh/voxels/VolumeRepairTool.h"

#include <QListView>

using namespace handwheel;
using namespace handwheel::test;

namespace {

struct ToolUnderTest {
  const char* id;
  std::span<const ToolKey> keys;
};

std::vector<ToolUnderTest> allTools() {
  return {{"measure", MeasureTool::keys()},
          {"joints", JointDragTool::keys()},
          {"boundary", BoundaryTool::keys()},
          {"decimate", DecimateTool::keys()},
          {"fill", FillHoleTool::keys()},
          {"face", MakeFaceTool::keys()},
          {"sculpt", SculptTool::keys()},
          {"select", SelectTool::keys()},
          {"subdivide", SubdivideTool::keys()},
          {"transform", TransformTool::keys()},
          {"volume-repair", VolumeRepairTool::keys()}};
}

}  // namespace

// The keys of a tool are listed and changed with the keys of the other commands, and take effect.
class ToolKeysTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }
  void everyKeyOfEveryToolHasARow();
  void aNewKeyActsAndIsReported();
  void anActionWithoutAKeyGetsOne();
  void keysThatQtWouldTake();
  void signsNeedShiftOrNot();
  void theCommandThatDoesTheSame();
};

// Either its own, or that of the command that does the same.
void ToolKeysTest::everyKeyOfEveryToolHasARow() {
  WindowDriver driver;
  const KeyPage page(driver);
  for (const ToolUnderTest& tool : allTools()) {
    for (const ToolKey& key : tool.keys) {
      const QString own = QStringLiteral("tool/%1/%2").arg(tool.id, key.action);
      const QString id = *key.command ? QString::fromLatin1(key.command) : own;
      QVERIFY2(page.rowOf(id).isValid(), qPrintable(own));
      QCOMPARE(page.shownKeys(id), QKeySequence(QString::fromLatin1(key.input)).toString(QKeySequence::NativeText));
    }
  }
  QCOMPARE(page.rowOf(kSmaller).data().toString(), QStringLiteral("Tools › Select faces › Smaller brush"));
  QTest::keyClicks(driver.find<QLineEdit>("shortcutSearch"), "smaller brush");
  QCOMPARE(page.rows().rowCount(), 3);  // to select, to sculpt, and to shape clay
}

void ToolKeysTest::aNewKeyActsAndIsReported() {
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  const double before = fixture.radius();
  fixture.press(Qt::Key_BracketLeft);
  const double once = fixture.radius();
  QVERIFY(once < before);
  {
    KeyPage page(driver);
    page.press(kSmaller, Qt::Key_Q);
    QCOMPARE(page.shownKeys(kSmaller), QStringLiteral("Q"));
    QCOMPARE(page.status(), QString());
  }
  QVERIFY(fixture.hints("Q: smaller brush"));
  QVERIFY(!fixture.hints("[: smaller brush"));
  QCOMPARE(driver.find<QWidget>("toolAction/smaller")->toolTip(), QStringLiteral("Smaller brush (Q)"));
  fixture.press(Qt::Key_BracketLeft);
  QCOMPARE(fixture.radius(), once);
  fixture.press(Qt::Key_Q);
  QVERIFY(fixture.radius() < once);
  // In the palette, too, from which it can be run.
  const double twice = fixture.radius();
  driver.choose("searchCommands");
  QTest::keyClicks(driver.find<QLineEdit>("commandQuery"), "smaller brush");
  auto* found = driver.find<QListView>("commandList");
  QCOMPARE(found->model()->rowCount(), 1);
  QCOMPARE(found->currentIndex().data(CommandModel::ShortcutRole).toString(), QStringLiteral("Q"));
  QTest::keyClick(driver.find<QLineEdit>("commandQuery"), Qt::Key_Return);
  QTRY_VERIFY(fixture.radius() < twice);
  // The next window knows it.
  WindowDriver second;
  QCOMPARE(KeyPage(second).shownKeys(kSmaller), QStringLiteral("Q"));
  QVERIFY(driver.settle());
}

void ToolKeysTest::anActionWithoutAKeyGetsOne() {
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  {
    KeyPage page(driver);
    page.choose(kSmaller);
    driver.click("shortcutNone");
    page.press("tool/select/all", Qt::Key_I);
    page.press("tool/transform/corner", Qt::Key_I);  // no conflict: there is one tool at a time
    QCOMPARE(page.status(), QString());
  }
  QVERIFY(!fixture.hints("smaller brush"));
  QCOMPARE(driver.find<QWidget>("toolAction/smaller")->toolTip(), QStringLiteral("Smaller brush"));
  const double before = fixture.radius();
  fixture.press(Qt::Key_BracketLeft);
  QCOMPARE(fixture.radius(), before);
  fixture.press(Qt::Key_I);
  QTRY_VERIFY(driver.find<QAbstractButton>("toolAction/delete")->isEnabled());  // all are selected
  driver.find<QAction>("transformTool")->trigger();
  QVERIFY(fixture.hints("I: move the minimum corner to the origin"));
  auto* undo = driver.find<QAction>("undo");
  QVERIFY(!undo->isEnabled());
  fixture.press(Qt::Key_I);
  QVERIFY(driver.settle());
  QTRY_VERIFY2(undo->text().contains("Move the minimum corner to the origin"), qPrintable(undo->text()));
}

// Space goes to the next hole, Ctrl+Z takes back: unless one wants them otherwise.
void ToolKeysTest::keysThatQtWouldTake() {
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  for (const auto& [key, modifiers] :
       std::initializer_list<std::pair<Qt::Key, Qt::KeyboardModifier>>{{Qt::Key_Space, Qt::NoModifier},
                                                                       {Qt::Key_Z, Qt::ControlModifier},
                                                                       {Qt::Key_Up, Qt::NoModifier},
                                                                       {Qt::Key_F10, Qt::NoModifier},
                                                                       {Qt::Key_F, Qt::AltModifier}}) {
    KeyPage(driver).press(kSmaller, key, modifiers);
    const double before = fixture.radius();
    fixture.press(key, modifiers);
    QVERIFY2(fixture.radius() < before, qPrintable(QKeySequence(modifiers | key).toString()));
    QVERIFY(driver.find<Viewport>("viewport")->hasFocus());
    fixture.press(Qt::Key_BracketRight);
  }
}

// "Ctrl++" is pressed with Shift on one keyboard, without on another, and on the block of digits.
void ToolKeysTest::signsNeedShiftOrNot() {
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  KeyPage(driver).press(kSmaller, Qt::Key_Plus, Qt::ControlModifier);
  QVERIFY(fixture.hints("Ctrl++: smaller brush"));
  KeyPage(driver).press("tool/select/grow", Qt::Key_G);
  for (const Qt::KeyboardModifiers also :
       {Qt::KeyboardModifiers(Qt::ShiftModifier), Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::KeypadModifier)}) {
    const double before = fixture.radius();
    fixture.press(Qt::Key_Plus, Qt::ControlModifier | also);
    QVERIFY(fixture.radius() < before);
  }
  const double before = fixture.radius();
  KeyPage(driver).press(kSmaller, Qt::Key_X);
  fixture.press(Qt::Key_X, Qt::ShiftModifier);  // for a letter it is another key
  QCOMPARE(fixture.radius(), before);
}

// "Next hole" is a command of the window; the tools tell its key, and have none of their own.
void ToolKeysTest::theCommandThatDoesTheSame() {
  BrushFixture fixture;
  WindowDriver& driver = fixture.driver;
  KeyPage(driver).press("nextHole", Qt::Key_Y);
  for (const char* tool : {"fillTool", "boundaryTool"}) {
    if (!driver.find<QAction>(tool)->isChecked()) driver.find<QAction>(tool)->trigger();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the buttons of the tool before
    QVERIFY(fixture.hints("Y: next hole"));
    QCOMPARE(driver.find<QWidget>("toolAction/next")->toolTip(), QStringLiteral("Next hole (Y)"));
  }
  fixture.press(Qt::Key_Y);
  QTRY_VERIFY(driver.find<QWidget>("holeSettings")->isVisible());
  QVERIFY(driver.settle());
}

HANDWHEEL_WINDOW_TEST(ToolKeysTest)
#include "ToolKeysTest.moc"
