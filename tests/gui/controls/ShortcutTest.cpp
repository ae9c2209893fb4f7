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
struct ShortcutFixture {
  ShortcutFixture() : window(sampleWindow()) { model.setActions(window->findChildren<QAction*>(), window->menuBar()); }

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
  ShortcutFixture fixture;
  const QAbstractItemModelTester tester(&fixture.model, QAbstractItemModelTester::FailureReportingMode::QtTest);
  QCOMPARE(fixture.model.rowCount(), 8);
  const QModelIndex redo = fixture.model.index(fixture.row("redo"), ShortcutModel::Command);
  QCOMPARE(redo.data().toString(), QString("Edit › Redo"));
  QCOMPARE(redo.siblingAtColumn(ShortcutModel::Keys).data().toString(), QString("Ctrl+Shift+Z; Ctrl+Y"));
  fixture.model.setKeys(redo.row(), {});
  delete fixture.action("undo");  // actions may go
  QVERIFY(fixture.model.keys(fixture.row("undo")).isEmpty());
}

void ShortcutTest::changesHoldAtOnceAndLater() {
  {
    ShortcutFixture fixture;
    fixture.model.setKeys(fixture.row("undo"), {QKeySequence("F5")});
    fixture.model.setKeys(fixture.row("openFile"), {});
    QCOMPARE(fixture.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  }
  ShortcutFixture next;  // the program starts again
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
  ShortcutFixture fixture;
  fixture.model.setKeys(fixture.row("undo"), {QKeySequence("F5")});
  QAction* late = addAction(fixture.window->menuBar()->addMenu("&Tool"), "late", "&Late", QKeySequence("L"));
  for (int i = 0; i < 2; ++i) {  // once more does no harm
    fixture.model.setActions(fixture.window->findChildren<QAction*>(), fixture.window->menuBar());
    QCOMPARE(fixture.model.rowCount(), 9);
    QCOMPARE(late->shortcuts(), Keys({QKeySequence("F7")}));
    QCOMPARE(fixture.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  }
  fixture.model.resetAll();
  QCOMPARE(late->shortcuts(), Keys({QKeySequence("L")}));
  QCOMPARE(fixture.action("undo")->shortcuts(), Keys({QKeySequence("Ctrl+Z")}));
}

void ShortcutTest::onlyDifferencesAreKept() {
  ShortcutFixture fixture;
  QVERIFY(QSettings().allKeys().isEmpty());
  fixture.model.setKeys(fixture.row("redo"), {QKeySequence("Ctrl+Y")});
  QCOMPARE(QSettings().allKeys(), QStringList({"shortcuts/redo"}));
  fixture.model.setKeys(fixture.row("redo"), {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  QVERIFY(QSettings().allKeys().isEmpty());
  QVERIFY(fixture.model.changes().isEmpty());
}

void ShortcutTest::conflicts() {
  ShortcutFixture fixture;
  QCOMPARE(fixture.conflicts("save"), QStringList());
  fixture.model.setKeys(fixture.row("wireframe"), {QKeySequence("F9"), QKeySequence("Ctrl+Y")});
  QCOMPARE(fixture.conflicts("wireframe"), QStringList({"Redo"}));
  QCOMPARE(fixture.conflicts("redo"), QStringList({"Wireframe"}));
  // "S, 1" can never be typed where S alone does something.
  fixture.model.setKeys(fixture.row("wireframe"), {QKeySequence("S, 1")});
  QCOMPARE(fixture.conflicts("shaded"), QStringList({"Wireframe"}));
  fixture.model.setKeys(fixture.row("wireframe"), {});
  QCOMPARE(fixture.conflicts("wireframe"), QStringList());  // those without a key do not collide
}

// A command of one tool can have a key that another has in another tool.
void ShortcutTest::scopes() {
  ShortcutFixture fixture;
  const auto add = [&](const QString& scope, const char* name, const char* key) {
    auto* action = new ContextAction(name, scope, "Tools › " + scope, fixture.window.get());
    action->setObjectName(scope + "/" + name);
    action->setShortcut(QKeySequence(key));
  };
  add("Cut", "small", "[");
  add("Cut", "large", "]");
  add("Cut", "done", "Return");
  add("Glue", "small", "[");
  add("Glue", "done", "Return");
  fixture.model.setActions(fixture.window->findChildren<QAction*>(), fixture.window->menuBar());
  const auto isAmbiguous = [&](const char* name) {
    return fixture.model.index(fixture.row(name), 0).data(ShortcutModel::AmbiguousRole).toBool();
  };
  for (const char* name : {"Cut/small", "Cut/done", "Glue/small", "Glue/done"})
    QVERIFY(fixture.conflicts(name).isEmpty());
  fixture.model.setKeys(fixture.row("undo"), {QKeySequence("[")});
  const QStringList both = fixture.conflicts("undo");
  QVERIFY(both.size() == 2 && both.contains("Cut › small") && both.contains("Glue › small"));
  QCOMPARE(fixture.conflicts("Cut/small"), QStringList({"Undo"}));
  QVERIFY(!isAmbiguous("undo") && !isAmbiguous("Cut/small"));
  fixture.model.setKeys(fixture.row("Cut/large"), {QKeySequence("[")});
  QVERIFY(!isAmbiguous("undo") && isAmbiguous("Cut/small") && isAmbiguous("Cut/large") && !isAmbiguous("Glue/small"));
  // The ending keys of a tool are fixed for all callers.
  fixture.model.setKeys(fixture.row("Cut/done"), {});
  fixture.model.setKeys(fixture.row("undo"), {QKeySequence("Return"), QKeySequence("F5, Esc"), QKeySequence("F6")});
  fixture.model.setKeys(fixture.row("Cut/small"), {QKeySequence("F7, F8"), QKeySequence("Shift+Return")});
  QCOMPARE(fixture.model.keys(fixture.row("Cut/done")), Keys({QKeySequence("Return")}));
  QCOMPARE(fixture.model.keys(fixture.row("undo")), Keys({QKeySequence("F6")}));
  QCOMPARE(fixture.model.keys(fixture.row("Cut/small")), Keys({QKeySequence("Shift+Return")}));
  QVERIFY(fixture.model.index(fixture.row("Cut/done"), 0).data(ShortcutModel::FixedRole).toBool());
  QVERIFY(!fixture.model.index(fixture.row("undo"), 0).data(ShortcutModel::FixedRole).toBool());
}

void ShortcutTest::taking() {
  ShortcutFixture fixture;
  fixture.model.setKeys(fixture.row("wireframe"), {QKeySequence("Ctrl+Y")});
  fixture.model.resolveInFavourOf(fixture.row("wireframe"));
  QCOMPARE(fixture.action("redo")->shortcuts(), Keys({QKeySequence("Ctrl+Shift+Z")}));
  QCOMPARE(fixture.action("wireframe")->shortcuts(), Keys({QKeySequence("Ctrl+Y")}));
  QCOMPARE(fixture.conflicts("wireframe"), QStringList());
}

void ShortcutTest::fileAndBack() {
  ShortcutFixture fixture;
  fixture.model.setKeys(fixture.row("undo"), {QKeySequence("Ctrl+Shift+U"), QKeySequence("Ctrl+X, Ctrl+U")});
  fixture.model.setKeys(fixture.row("save"), {});
  const QByteArray json = toJson(fixture.model.changes());
  fixture.model.resetAll();
  fixture.model.setKeys(fixture.row("shaded"), {QKeySequence("F3")});
  const Result<ShortcutChanges> read = shortcutsFromJson(json);
  QVERIFY(read.hasValue());
  fixture.model.setChanges(*read);
  QCOMPARE(fixture.action("undo")->shortcuts(), Keys({QKeySequence("Ctrl+Shift+U"), QKeySequence("Ctrl+X, Ctrl+U")}));
  QVERIFY(fixture.action("save")->shortcuts().isEmpty());
  QCOMPARE(fixture.action("shaded")->shortcuts(), Keys({QKeySequence("S")}));  // not in the file: the program's default
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
  ShortcutFixture fixture;
  ShortcutEditor editor(&fixture.model);
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
  QTRY_COMPARE(fixture.action("wireframe")->shortcuts(), Keys({QKeySequence("Ctrl+Y")}));  // after the pause
  QVERIFY(status->text().contains("Redo"));
  QVERIFY(take->isVisible());
  click("shortcutTake");
  QCOMPARE(fixture.action("redo")->shortcuts(), Keys({QKeySequence("Ctrl+Shift+Z")}));
  QVERIFY(!take->isVisible());
  click("shortcutNone");
  QVERIFY(fixture.action("wireframe")->shortcuts().isEmpty());
  click("shortcutResetAll");
  QVERIFY(fixture.model.changes().isEmpty());
  list->setCurrentIndex({});
  QVERIFY(!keys->isEnabled());
}

void ShortcutTest::importAndExport() {
  const QTemporaryDir folder;
  ShortcutFixture fixture;
  ShortcutEditor editor(&fixture.model);
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
  fixture.model.setKeys(fixture.row("undo"), {QKeySequence("F5")});
  choose("shortcutExport", "shortcutExportDialog", path);
  fixture.model.resetAll();
  choose("shortcutImport", "shortcutImportDialog", path);
  QCOMPARE(fixture.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  choose("shortcutImport", "shortcutImportDialog", folder.filePath("missing.json"));
  QVERIFY(!status->text().isEmpty());
  QVERIFY(status->property("bad").toBool());
  QCOMPARE(fixture.action("undo")->shortcuts(), Keys({QKeySequence("F5")}));
  choose("shortcutExport", "shortcutExportDialog", folder.filePath("no/such/folder/keys.json"));
  QVERIFY(status->property("bad").toBool());
}

HANDWHEEL_CONTROLS_TEST(ShortcutTest)
#include "ShortcutTest.moc"
