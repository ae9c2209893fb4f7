// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlScenes.h"
#include "ControlsTestMain.h"
#include "controls/ContextAction.h"
#include "controls/ShortcutEditor.h"
#include "controls/ShortcutModel.h"
#include "document/DocumentErrors.h"

#include <rapidcheck.h>

#include <QAbstractItemModelTester>
#include <QFileDialog>
#include <QKeySequenceEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Keys = QList<QKeySequence>;

// A window's actions and their keys.
struct ShortcutBench {
  ShortcutBench() : window(sampleWindow()) { model.setActions(window->findChildren<QAction*>(), window->menuBar()); }

  QAction* action(const char* name) const { return window->findChild<QAction*>(name); }
  int row(const char* name) const {
    for (int row = 0; row < model.rowCount(); ++row) {
      if (model.index(row, 0).data(ShortcutModel::IdRole) == QLatin1String(name)) return row;
    }
    qFatal("there is no %s", name);
  }
  QStringList conflicts(const char* name) const {
    return model.index(row(name), 0).data(ShortcutModel::ConflictRole).toStringList();
  }

  std::unique_ptr<QMainWindow> window;
  ShortcutModel model;
};

ErrorCode codeOf(const QByteArray& json) {
  const Result<ShortcutChanges> result = shortcutsFromJson(json);
  if (result) qFatal("no error");
  return result.error().code;
}

QByteArray fileWith(const QByteArray& shortcuts) {
  return R"({"format":"handwheel-shortcuts","version":1,"shortcuts":)" + shortcuts + "}";
}

}  // namespace

class ShortcutTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }
  void isASoundModel();
  void changesHoldAtOnceAndLater();
  void actionsMayComeLater();
  void onlyDifferencesAreKept();
  void conflicts();
  void scopes();
  void taking();
  void fileAndBack();
  void randomChangesSurviveTheFile();
  void hostileFiles();
  void editor();
  void importAndExport();
};

void ShortcutTest::isASoundModel() {
  ShortcutBench bench;
  const QAbstractItemModelTester tester(&bench.model, QAbstractItemModelTester::FailureReportingMode::QtTest);
  QCOMPARE(bench.model.rowCount(), 8);
  const QModelIndex redo = bench.model.index(bench.row("redo"), ShortcutModel::Command);
  QCOMPARE(redo.data().toString(), QString("Edit › Redo"));
  QCOMPARE(redo.siblingAtColumn(ShortcutModel::Keys).data().toString(), QString("Ctrl+Shift+Z; Ctrl+Y"));
  bench.model.setKeys(redo.row(), {});
  delete bench.action("undo");  // actions may go
  QVERIFY(bench.model.keys(bench.row("undo")).isEmpty());
}

void ShortcutTest::changesHoldAtOnceAndLater() {
  {
    ShortcutBench bench;
    bench.model.setKeys(bench.row("undo"), {QKeySequence("F5")});
    bench.model.setKeys(bench.row("openFile"), {});
    QCOMPARE(bench.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  }
  ShortcutBench next;  // the program starts again
  QCOMPARE(next.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  QVERIFY(next.action("openFile")->shortcuts().isEmpty());
  QVERIFY(next.model.index(next.row("undo"), 0).data(ShortcutModel::ChangedRole).toBool());
  next.model.reset(next.row("undo"));
  QCOMPARE(next.action("undo")->shortcuts(), Keys({QKeySequence("Ctrl+Z")}));
  QVERIFY(next.action("openFile")->shortcuts().isEmpty());
  next.model.resetAll();
  QCOMPARE(next.action("openFile")->shortcuts(), Keys({QKeySequence("Ctrl+O")}));
}

void ShortcutTest::actionsMayComeLater() {
  QSettings().setValue("shortcuts/late", QStringList({"F7"}));
  ShortcutBench bench;
  bench.model.setKeys(bench.row("undo"), {QKeySequence("F5")});
  QAction* late = addAction(bench.window->menuBar()->addMenu("&Tool"), "late", "&Late", QKeySequence("L"));
  for (int i = 0; i < 2; ++i) {  // once more does no harm
    bench.model.setActions(bench.window->findChildren<QAction*>(), bench.window->menuBar());
    QCOMPARE(bench.model.rowCount(), 9);
    QCOMPARE(late->shortcuts(), Keys({QKeySequence("F7")}));
    QCOMPARE(bench.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  }
  bench.model.resetAll();
  QCOMPARE(late->shortcuts(), Keys({QKeySequence("L")}));
  QCOMPARE(bench.action("undo")->shortcuts(), Keys({QKeySequence("Ctrl+Z")}));
}

void ShortcutTest::onlyDifferencesAreKept() {
  ShortcutBench bench;
  QVERIFY(QSettings().allKeys().isEmpty());
  bench.model.setKeys(bench.row("redo"), {QKeySequence("Ctrl+Y")});
  QCOMPARE(QSettings().allKeys(), QStringList({"shortcuts/redo"}));
  bench.model.setKeys(bench.row("redo"), {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  QVERIFY(QSettings().allKeys().isEmpty());
  QVERIFY(bench.model.changes().isEmpty());
}

void ShortcutTest::conflicts() {
  ShortcutBench bench;
  QCOMPARE(bench.conflicts("save"), QStringList());
  bench.model.setKeys(bench.row("wireframe"), {QKeySequence("F9"), QKeySequence("Ctrl+Y")});
  QCOMPARE(bench.conflicts("wireframe"), QStringList({"Redo"}));
  QCOMPARE(bench.conflicts("redo"), QStringList({"Wireframe"}));
  // "S, 1" can never be typed where S alone does something.
  bench.model.setKeys(bench.row("wireframe"), {QKeySequence("S, 1")});
  QCOMPARE(bench.conflicts("shaded"), QStringList({"Wireframe"}));
  bench.model.setKeys(bench.row("wireframe"), {});
  QCOMPARE(bench.conflicts("wireframe"), QStringList());  // those without a key do not collide
}

// What is there in one tool only can have a key that something else has in another.
void ShortcutTest::scopes() {
  ShortcutBench bench;
  const auto add = [&](const QString& scope, const char* name, const char* key) {
    auto* action = new ContextAction(name, scope, "Tools › " + scope, bench.window.get());
    action->setObjectName(scope + "/" + name);
    action->setShortcut(QKeySequence(key));
  };
  add("Cut", "small", "[");
  add("Cut", "large", "]");
  add("Cut", "done", "Return");
  add("Glue", "small", "[");
  add("Glue", "done", "Return");
  bench.model.setActions(bench.window->findChildren<QAction*>(), bench.window->menuBar());
  const auto isAmbiguous = [&](const char* name) {
    return bench.model.index(bench.row(name), 0).data(ShortcutModel::AmbiguousRole).toBool();
  };
  for (const char* name : {"Cut/small", "Cut/done", "Glue/small", "Glue/done"})
    QVERIFY(bench.conflicts(name).isEmpty());
  bench.model.setKeys(bench.row("undo"), {QKeySequence("[")});
  const QStringList both = bench.conflicts("undo");
  QVERIFY(both.size() == 2 && both.contains("Cut › small") && both.contains("Glue › small"));
  QCOMPARE(bench.conflicts("Cut/small"), QStringList({"Undo"}));
  QVERIFY(!isAmbiguous("undo") && !isAmbiguous("Cut/small"));
  bench.model.setKeys(bench.row("Cut/large"), {QKeySequence("[")});
  QVERIFY(!isAmbiguous("undo") && isAmbiguous("Cut/small") && isAmbiguous("Cut/large") && !isAmbiguous("Glue/small"));
  // The ends of a tool are fixed, whatever asks.
  bench.model.setKeys(bench.row("Cut/done"), {});
  bench.model.setKeys(bench.row("undo"), {QKeySequence("Return"), QKeySequence("F5, Esc"), QKeySequence("F6")});
  bench.model.setKeys(bench.row("Cut/small"), {QKeySequence("F7, F8"), QKeySequence("Shift+Return")});
  QCOMPARE(bench.model.keys(bench.row("Cut/done")), Keys({QKeySequence("Return")}));
  QCOMPARE(bench.model.keys(bench.row("undo")), Keys({QKeySequence("F6")}));
  QCOMPARE(bench.model.keys(bench.row("Cut/small")), Keys({QKeySequence("Shift+Return")}));
  QVERIFY(bench.model.index(bench.row("Cut/done"), 0).data(ShortcutModel::FixedRole).toBool());
  QVERIFY(!bench.model.index(bench.row("undo"), 0).data(ShortcutModel::FixedRole).toBool());
}

void ShortcutTest::taking() {
  ShortcutBench bench;
  bench.model.setKeys(bench.row("wireframe"), {QKeySequence("Ctrl+Y")});
  bench.model.resolveInFavourOf(bench.row("wireframe"));
  QCOMPARE(bench.action("redo")->shortcuts(), Keys({QKeySequence("Ctrl+Shift+Z")}));
  QCOMPARE(bench.action("wireframe")->shortcuts(), Keys({QKeySequence("Ctrl+Y")}));
  QCOMPARE(bench.conflicts("wireframe"), QStringList());
}

void ShortcutTest::fileAndBack() {
  ShortcutBench bench;
  bench.model.setKeys(bench.row("undo"), {QKeySequence("Ctrl+Shift+U"), QKeySequence("Ctrl+X, Ctrl+U")});
  bench.model.setKeys(bench.row("save"), {});
  const QByteArray json = toJson(bench.model.changes());
  bench.model.resetAll();
  bench.model.setKeys(bench.row("shaded"), {QKeySequence("F3")});
  const Result<ShortcutChanges> read = shortcutsFromJson(json);
  QVERIFY(read.hasValue());
  bench.model.setChanges(*read);
  QCOMPARE(bench.action("undo")->shortcuts(), Keys({QKeySequence("Ctrl+Shift+U"), QKeySequence("Ctrl+X, Ctrl+U")}));
  QVERIFY(bench.action("save")->shortcuts().isEmpty());
  QCOMPARE(bench.action("shaded")->shortcuts(), Keys({QKeySequence("S")}));  // not in the file: as the program has it
}

void ShortcutTest::randomChangesSurviveTheFile() {
  QVERIFY(rc::check("changes survive JSON", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    ShortcutChanges changes;
    for (auto n = random() % 6; n > 0; --n) {
      QStringList keys;
      for (auto k = random() % 3; k > 0; --k) {
        const int modifiers[] = {0, Qt::CTRL, Qt::SHIFT | Qt::CTRL, Qt::ALT, Qt::META};
        const int key = modifiers[random() % 5] | (Qt::Key_A + int(random() % 26));
        keys << QKeySequence(key, random() % 2 ? key : 0).toString(QKeySequence::PortableText);
      }
      changes[QString("action %1 \"%2\"").arg(random() % 100).arg(QChar(0x4e00 + int(random() % 1000)))] = keys;
    }
    const Result<ShortcutChanges> read = shortcutsFromJson(toJson(changes));
    RC_ASSERT(read.hasValue());
    RC_ASSERT(*read == changes);
  }));
}

void ShortcutTest::hostileFiles() {
  QCOMPARE(codeOf(""), DocumentError::FormatUnknown);
  QCOMPARE(codeOf("[1,2]"), DocumentError::FormatUnknown);
  QCOMPARE(codeOf(QByteArray(100000, '[')), DocumentError::FormatUnknown);
  QCOMPARE(codeOf(R"({"format":"other"})"), DocumentError::FormatUnknown);
  QCOMPARE(codeOf("{\"format\":\"handwheel-shortcuts\xff\"}"), DocumentError::FormatUnknown);
  QCOMPARE(codeOf(QByteArray(kLargestShortcutFile + 1, ' ')), ErrorCode::FileTooLarge);
  QCOMPARE(codeOf(R"({"format":"handwheel-shortcuts"})"), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf(R"({"format":"handwheel-shortcuts","version":2,"shortcuts":{}})"), ErrorCode::VersionNewer);
  QCOMPARE(codeOf(fileWith("[]")), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf(fileWith(R"({"undo":"Ctrl+Z"})")), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf(fileWith(R"({"undo":["Ctrl+Blah"]})")), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf(fileWith(R"({"undo":[""]})")), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf(fileWith(R"({"undo":[7]})")), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf(fileWith(R"({"undo":["A","A","A","A","A","A","A","A","A"]})")), ErrorCode::ElementMalformed);
  QVERIFY(shortcutsFromJson(fileWith(R"({"unknown":["F1"]})")).hasValue());
}

void ShortcutTest::editor() {
  ShortcutBench bench;
  ShortcutEditor editor(&bench.model);
  editor.show();
  auto* list = editor.findChild<QTreeView*>("shortcutList");
  auto* keys = editor.findChild<QKeySequenceEdit*>("shortcutKeys");
  auto* status = editor.findChild<QLabel*>("shortcutStatus");
  auto* take = editor.findChild<QPushButton*>("shortcutTake");
  const auto click = [&](const char* name) { QTest::mouseClick(editor.findChild<QPushButton*>(name), Qt::LeftButton); };
  QVERIFY(!keys->isEnabled());
  QTest::keyClicks(editor.findChild<QLineEdit*>("shortcutSearch"), "wire");
  QCOMPARE(list->model()->rowCount(), 1);
  list->setCurrentIndex(list->model()->index(0, 0));
  QVERIFY(keys->isEnabled());
  keys->setFocus();
  QTest::keyClick(keys, Qt::Key_Y, Qt::ControlModifier);
  QTRY_COMPARE(bench.action("wireframe")->shortcuts(), Keys({QKeySequence("Ctrl+Y")}));  // after the pause
  QVERIFY(status->text().contains("Redo"));
  QVERIFY(take->isVisible());
  click("shortcutTake");
  QCOMPARE(bench.action("redo")->shortcuts(), Keys({QKeySequence("Ctrl+Shift+Z")}));
  QVERIFY(!take->isVisible());
  click("shortcutNone");
  QVERIFY(bench.action("wireframe")->shortcuts().isEmpty());
  click("shortcutResetAll");
  QVERIFY(bench.model.changes().isEmpty());
  list->setCurrentIndex({});
  QVERIFY(!keys->isEnabled());
}

void ShortcutTest::importAndExport() {
  const QTemporaryDir folder;
  ShortcutBench bench;
  ShortcutEditor editor(&bench.model);
  editor.show();
  const auto choose = [&](const char* button, const char* dialogName, const QString& path) {
    QTest::mouseClick(editor.findChild<QPushButton*>(button), Qt::LeftButton);
    auto* dialog = editor.findChild<QFileDialog*>(dialogName);
    QVERIFY(dialog);
    emit dialog->fileSelected(path);
    delete dialog;
  };
  const QString path = folder.filePath("keys.json");
  auto* status = editor.findChild<QLabel*>("shortcutStatus");
  bench.model.setKeys(bench.row("undo"), {QKeySequence("F5")});
  choose("shortcutExport", "shortcutExportDialog", path);
  bench.model.resetAll();
  choose("shortcutImport", "shortcutImportDialog", path);
  QCOMPARE(bench.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  choose("shortcutImport", "shortcutImportDialog", folder.filePath("missing.json"));
  QVERIFY(!status->text().isEmpty());
  QVERIFY(status->property("bad").toBool());
  QCOMPARE(bench.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  choose("shortcutExport", "shortcutExportDialog", folder.filePath("no/such/folder/keys.json"));
  QVERIFY(status->property("bad").toBool());
}

HANDWHEEL_CONTROLS_TEST(ShortcutTest)
#include "ShortcutTest.moc"
