// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "window/tools/ToolHost.h"
#include "window/tools/ToolKeys.h"

#include <QDockWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Stands for a tool in some state: offers the same actions, and notes which of them are performed.
class NotingTool final : public Tool {
 public:
  NotingTool(std::string id, std::vector<ToolAction> actions, QStringList& performed)
      : m_id(std::move(id)), m_actions(std::move(actions)), m_performed(performed) {}

  std::string id() const override { return m_id; }
  ToolReply pointer(const PointerEvent&) override { return ToolReply::Ignored; }
  ToolReply perform(std::string_view action) override {
    m_performed << QString::fromUtf8(action.data(), static_cast<qsizetype>(action.size()));
    return ToolReply::Used;
  }
  std::vector<ToolAction> actions() const override { return m_actions; }

 private:
  std::string m_id;
  std::vector<ToolAction> m_actions;
  QStringList& m_performed;
};

}  // namespace

// Each key in the hint bar does what the bar says, wherever the focus is in the window, and whatever is selected.
class HintedKeysTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  static ToolHost& host(WindowDriver& driver) { return *driver.window().findChild<ToolHost*>(); }
  static void activate(WindowDriver& driver) {
    driver.window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&driver.window()));
  }
  void openMesh(WindowDriver& driver) {
    const QString path = m_folder.filePath(QStringLiteral("holes.stl"));
    writeStl(path, quadTorus(48, 24, {{3, 5}, {20, 11}, {35, 17}}));
    QVERIFY(driver.open(path));
    activate(driver);
  }
  static void press(QWidget& focus, const QString& shown) {
    const QKeySequence keys(shown, QKeySequence::NativeText);
    QTest::keyClick(&focus, keys[0].key(), keys[0].keyboardModifiers());
  }
  // Presses each key of the running tool, whose work is left to a stand-in.
  static void tryAll(WindowDriver& driver, QWidget& focus) {
    ToolHost& tools = host(driver);
    const Tool* const real = tools.runner().tool();
    QVERIFY(real);
    std::vector<ToolAction> actions = real->actions();
    for (ToolAction& action : actions) action.enabled = true;
    QStringList performed;
    tools.runner().start(std::make_unique<NotingTool>(real->id(), actions, performed), *tools.runner().document());
    for (const ToolAction& action : actions) {
      const QString keys = tools.keys().text(*tools.runner().tool(), action);
      if (keys.isEmpty() || action.id.empty() || !action.command.empty()) continue;
      // These move in a list of rows or choices that has the focus.
      if (focus.objectName() != "viewport" && (keys == "PgUp" || keys == "PgDown")) continue;
      focus.setFocus();
      QVERIFY(focus.hasFocus());
      performed.clear();
      press(focus, keys);
      QVERIFY2(performed == QStringList{QString::fromStdString(action.id)},
               qPrintable(QStringLiteral("%1 in %2, %3: %4 instead of %5")
                              .arg(keys, focus.objectName(), QString::fromStdString(tools.runner().tool()->id()),
                                   performed.join(','), QString::fromStdString(action.id))));
    }
  }
  static QStringList toolsOf(WindowDriver& driver) {
    QStringList names;
    for (const QAction* action : driver.window().findChildren<QAction*>()) {
      if (action->objectName().endsWith("Tool") && action->isEnabled() && action->isVisible())
        names << action->objectName();
    }
    return names;
  }

 private slots:
  void init() { QSettings().clear(); }

  void everyToolOfAMesh_data() {
    QTest::addColumn<QString>("focus");
    for (const char* name : {"viewport", "defectList", "fillMethod", "repairAllButton"}) QTest::newRow(name) << name;
  }
  void everyToolOfAMesh() {
    QFETCH(QString, focus);
    WindowDriver driver;
    openMesh(driver);
    driver.clickDefect(DefectKind::Hole, 1);  // the commands of the window that fill and deselect it have keys, too
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QAction>("fillHole")->isEnabled(), kPatienceMs);
    const QStringList names = toolsOf(driver);
    QVERIFY(names.size() >= 10);
    for (const QString& name : names) {
      driver.find<QAction>(qPrintable(name))->trigger();
      driver.find<QDockWidget>("kindDock")->raise();
      auto* const widget = driver.find<QWidget>(qPrintable(focus));
      if (!widget->isVisible() || !widget->isEnabled()) driver.clickDefect(DefectKind::Hole, 1);
      QTRY_VERIFY(widget->isVisible() && widget->isEnabled());
      tryAll(driver, *widget);
      if (QTest::currentTestFailed()) return;
      QCOMPARE(driver.count(DefectKind::Hole), 3);
    }
    QVERIFY(driver.settle());
  }

  void everyToolOfOtherKinds_data() {
    QTest::addColumn<QString>("sample");
    for (const char* sample : {"openShaftSample", "openRobotSample", "newVolume"}) QTest::newRow(sample) << sample;
  }
  void everyToolOfOtherKinds() {
    QFETCH(QString, sample);
    WindowDriver driver;
    driver.choose(qPrintable(sample));
    QVERIFY(driver.settle());
    activate(driver);
    for (const QString& name : toolsOf(driver)) {
      driver.find<QAction>(qPrintable(name))->trigger();
      if (!host(driver).runner().tool()) continue;
      tryAll(driver, *driver.find<QWidget>("viewport"));
      if (QTest::currentTestFailed()) return;
    }
    QVERIFY(driver.settle());
  }

  // The first Return ends the text, the next one is that of the tool.
  void returnInAFieldOfTheTool() {
    WindowDriver driver;
    openMesh(driver);
    driver.clickDefect(DefectKind::Hole, 1);
    QTRY_VERIFY_WITH_TIMEOUT(driver.find<QAction>("fillHole")->isEnabled(), kPatienceMs);
    driver.find<QAction>("subdivideTool")->trigger();
    auto* const line = driver.find<QWidget>("toolDock")->findChild<QLineEdit*>();
    QVERIFY(line);
    QTRY_VERIFY(line->isVisible());
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, "2");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(driver.count(DefectKind::Hole), 3);
    QVERIFY(driver.find<QAction>("subdivideTool")->isChecked());
    QVERIFY(line->hasFocus());
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(driver.window().isWindowModified(), kPatienceMs);
    QVERIFY(driver.settle());
  }
};

HANDWHEEL_WINDOW_TEST(HintedKeysTest)
#include "HintedKeysTest.moc"
