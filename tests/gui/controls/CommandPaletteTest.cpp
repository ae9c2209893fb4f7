// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/CommandPalette.h"

#include "ControlScenes.h"
#include "ControlsTestMain.h"
#include "controls/ActionText.h"
#include "controls/CommandModel.h"
#include "controls/CommandSearch.h"

#include <rapidcheck.h>

#include <QAbstractItemModelTester>
#include <QListView>
#include <QSignalSpy>
#include <QTest>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const std::vector<CommandText> kCommands = {
    {"openFile", "Open…", "File", "Open a mesh", "Ctrl+O"},
    {"save", "Save", "File", "", "Ctrl+S"},
    {"saveAs", "Save as…", "File", "", "Ctrl+Shift+S"},
    {"shaded", "Shaded", "View › Shading", "", "S"},
    {"shadedWithEdges", "Shaded with edges", "View › Shading", "", ""},
    {"repairAll", "Alles reparieren", "Reparatur", "Alle Löcher schließen", "R"},
    {"showOpenings", "Öffnungen zeigen", "Ansicht", "", ""},
    {"fitView", "适合窗口", "视图", "显示整个模型", "F"},
};

QStringList found(const QString& query, const QStringList& recent = {}) {
  CommandSearch search;
  search.setCommands(kCommands);
  QStringList ids;
  for (int i : search.find(query, recent)) ids << kCommands[std::size_t(i)].id;
  return ids;
}

// A palette on a window with menus; with the titles of its rows.
struct PaletteFixture {
  PaletteFixture() : window(sampleWindow()), palette(window.get()) {
    QSettings().clear();
    before = new QLineEdit(window->centralWidget());
    before->show();
    window->resize(700, 500);
    window->show();
    window->activateWindow();
    if (!QTest::qWaitForWindowActive(window.get())) qFatal("the window does not appear");
    before->setFocus();
    query = palette.findChild<QLineEdit*>("commandQuery");
    list = palette.findChild<QListView*>("commandList");
  }
  QStringList titles() const {
    QStringList titles;
    for (int row = 0; row < list->model()->rowCount(); ++row) titles << list->model()->index(row, 0).data().toString();
    return titles;
  }
  QString current() const { return list->currentIndex().data().toString(); }
  QAction* action(const char* name) const { return window->findChild<QAction*>(name); }

  std::unique_ptr<QMainWindow> window;
  CommandPalette palette;
  QLineEdit* before;
  QLineEdit* query;
  QListView* list;
};

}  // namespace

class CommandPaletteTest : public QObject {
  Q_OBJECT

 private slots:
  void mnemonics();
  void bestFirst();
  void accentsAndOtherLanguages();
  void recentFirst();
  void findsWhatItShould();
  void listsNamedActionsOnly();
  void saysWhenThereIsNone();
  void keyboardOnly();
  void mouse();
  void disabledActionsSayWhy();
  void goesAway();
  void remembers();
  void actionMayCloseTheWindow();
  void staysWithinTheWindow();
};

void CommandPaletteTest::mnemonics() {
  QCOMPARE(withoutMnemonic("&Open…"), QString("Open…"));
  QCOMPARE(withoutMnemonic("Cut && paste"), QString("Cut & paste"));
  QCOMPARE(withoutMnemonic("打开(&O)…"), QString("打开…"));
  QCOMPARE(withoutMnemonic("Plain"), QString("Plain"));
}

void CommandPaletteTest::bestFirst() {
  QCOMPARE(found("sa").mid(0, 3), QStringList({"save", "saveAs", "shaded"}));  // beginning, beginning, in order
  QCOMPARE(found("swe").first(), QString("shadedWithEdges"));                  // beginnings of words
  QCOMPARE(found("edges").first(), QString("shadedWithEdges"));                // holds it
  QCOMPARE(found("save as"), QStringList({"saveAs"}));
  QCOMPARE(found("svs"), QStringList({"saveAs"}));
  QCOMPARE(found("file save").mid(0, 2), QStringList({"save", "saveAs"}));  // menu and title
  QCOMPARE(found("ctrl+shift+s"), QStringList({"saveAs"}));
  QCOMPARE(found("mesh"), QStringList({"openFile"}));  // tooltip
  QCOMPARE(found("xyzzy"), QStringList());
  QCOMPARE(found("  SAVE   AS "), QStringList({"saveAs"}));
}

void CommandPaletteTest::accentsAndOtherLanguages() {
  QCOMPARE(found("offnungen"), QStringList({"showOpenings"}));
  QCOMPARE(found("schliessen"), QStringList({"repairAll"}));  // ß is ss
  QCOMPARE(found("窗口"), QStringList({"fitView"}));
  QCOMPARE(found("整个").size(), 0);                      // not at the beginning of a word, and only in the tooltip
  QCOMPARE(found("fit view"), QStringList({"fitView"}));  // English ids
  QCOMPARE(found("repair").first(), QString("repairAll"));
}

void CommandPaletteTest::recentFirst() {
  QCOMPARE(found("", {"shaded", "save"}).mid(0, 3), QStringList({"shaded", "save", "openFile"}));
  QCOMPARE(found("").size(), qsizetype(kCommands.size()));
  QCOMPARE(found("sa", {"saveAs"}).mid(0, 2), QStringList({"saveAs", "save"}));
  QCOMPARE(found("save", {"gone", "shaded"}).first(), QString("save"));
}

void CommandPaletteTest::findsWhatItShould() {
  QVERIFY(rc::check("any letters of a title, in order, find it; its beginning ranks with the first", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const CommandText& command = kCommands[random() % kCommands.size()];
    QString letters;
    for (QChar c : command.title) {
      if (random() % 3 == 0 && c.isLetter()) letters += random() % 2 ? c.toUpper() : c;
    }
    RC_ASSERT(found(letters).contains(command.id));
    const QString beginning = command.title.left(1 + int(random() % command.title.size()));
    if (std::any_of(beginning.begin(), beginning.end(), [](QChar c) { return c.unicode() > 127; })) return;
    const QString first = found(beginning).value(0);
    const auto title = std::find_if(kCommands.begin(), kCommands.end(), [&](auto& c) { return c.id == first; });
    RC_ASSERT(title->title.startsWith(beginning.trimmed(), Qt::CaseInsensitive) ||
              title->id.startsWith(beginning, Qt::CaseInsensitive));
  }));
}

void CommandPaletteTest::listsNamedActionsOnly() {
  PaletteFixture fixture;
  fixture.window->menuBar()->addAction("nameless");
  auto* hidden = new QAction("Hidden", fixture.window.get());
  hidden->setObjectName("hidden");
  hidden->setVisible(false);
  fixture.action("shaded")->setText("Sha&ded");
  fixture.palette.popUp();
  const QAbstractItemModelTester tester(fixture.list->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
  QCOMPARE(fixture.titles(),
           QStringList({"Open…", "Save", "Save as…", "Undo", "Redo", "Shaded", "Shaded with edges", "Wireframe"}));
  QTest::keyClicks(fixture.query, "wire");
  QCOMPARE(fixture.titles(), QStringList({"Wireframe"}));
  const QModelIndex row = fixture.list->currentIndex();
  QCOMPARE(row.data(CommandModel::PathRole).toString(), QString("View › Shading"));
}

void CommandPaletteTest::saysWhenThereIsNone() {
  PaletteFixture fixture;
  fixture.palette.popUp();
  const auto* nothing = fixture.palette.findChild<QWidget*>("noCommand");
  QVERIFY(fixture.list->isVisible() && !nothing->isVisible());
  QTest::keyClicks(fixture.query, "xyzzy");
  QVERIFY(!fixture.list->isVisible() && nothing->isVisible());
  QTest::failOnWarning(QRegularExpression("is not valid"));
  QTest::keyClick(fixture.query, Qt::Key_Return);  // nothing is run
  QVERIFY(fixture.palette.isVisible());
}

void CommandPaletteTest::keyboardOnly() {
  PaletteFixture fixture;
  QSignalSpy undone(fixture.action("undo"), &QAction::triggered);
  QSignalSpy redone(fixture.action("redo"), &QAction::triggered);
  QTest::keyClick(fixture.before, Qt::Key_K, Qt::ControlModifier);
  QVERIFY(fixture.palette.isVisible());
  QVERIFY(fixture.query->hasFocus());
  QTest::keyClicks(fixture.query, "do");
  QVERIFY(fixture.titles().contains("Undo") && fixture.titles().contains("Redo"));
  const QString first = fixture.current();
  QTest::keyClick(fixture.query, Qt::Key_Down);
  QVERIFY(fixture.current() != first);
  QTest::keyClick(fixture.query, Qt::Key_Up);
  QCOMPARE(fixture.current(), first);
  QTest::keyClick(fixture.query, Qt::Key_Return);
  QVERIFY(!fixture.palette.isVisible());
  QCOMPARE(QApplication::focusWidget(), fixture.before);
  QTest::qWait(1);
  QCOMPARE(undone.size() + redone.size(), 1);
}

void CommandPaletteTest::mouse() {
  PaletteFixture fixture;
  QSignalSpy triggered(fixture.action("saveAs"), &QAction::triggered);
  fixture.palette.popUp();
  const QModelIndex row = fixture.list->model()->index(2, 0);
  QTest::mouseClick(fixture.list->viewport(), Qt::LeftButton, {}, fixture.list->visualRect(row).center());
  QTest::qWait(1);
  QCOMPARE(triggered.size(), 1);
  QVERIFY(!fixture.palette.isVisible());
}

void CommandPaletteTest::disabledActionsSayWhy() {
  PaletteFixture fixture;
  QSignalSpy triggered(fixture.action("save"), &QAction::triggered);
  fixture.palette.popUp();
  QTest::keyClicks(fixture.query, "save");
  QCOMPARE(fixture.current(), QString("Save"));
  QCOMPARE(fixture.list->currentIndex().data(CommandModel::ReasonRole).toString(), QString("There is nothing to save"));
  QTest::keyClick(fixture.query, Qt::Key_Return);
  QTest::qWait(1);
  QCOMPARE(triggered.size(), 0);
  QVERIFY(fixture.palette.isVisible());
}

void CommandPaletteTest::goesAway() {
  PaletteFixture fixture;
  QAction esc("Esc", fixture.window.get());
  esc.setShortcut(Qt::Key_Escape);
  fixture.window->addAction(&esc);
  QSignalSpy escaped(&esc, &QAction::triggered);
  fixture.palette.popUp();
  QTest::keyClick(fixture.query, Qt::Key_Escape);
  QVERIFY(!fixture.palette.isVisible());
  QCOMPARE(escaped.size(), 0);
  QCOMPARE(QApplication::focusWidget(), fixture.before);
  // The same holds for its other keys: in the window Return fills the selected hole.
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Up, Qt::Key_PageDown, Qt::Key_Tab}) {
    QAction command("Fill", fixture.window.get());
    command.setShortcut(key);
    fixture.window->addAction(&command);
    QSignalSpy triggered(&command, &QAction::triggered);
    fixture.palette.popUp();
    QTest::keyClicks(fixture.query, "no command has this name");
    QTest::keyClick(fixture.query, key);
    QVERIFY2(triggered.empty(), qPrintable(QKeySequence(key).toString()));
    fixture.palette.hide();
    QTest::keyClick(fixture.before, key);
    QCOMPARE(triggered.size(), 1);
  }
  fixture.palette.popUp();
  QTest::mouseClick(fixture.before, Qt::LeftButton);
  fixture.before->setFocus(Qt::MouseFocusReason);
  QVERIFY(!fixture.palette.isVisible());
}

void CommandPaletteTest::remembers() {
  PaletteFixture fixture;
  for (const char* name : {"redo", "shaded"}) {
    fixture.palette.popUp();
    QTest::keyClicks(fixture.query, name);
    QTest::keyClick(fixture.query, Qt::Key_Return);
    QTest::qWait(1);
  }
  fixture.palette.popUp();
  QCOMPARE(fixture.titles().mid(0, 3), QStringList({"Shaded", "Redo", "Open…"}));
}

void CommandPaletteTest::actionMayCloseTheWindow() {
  auto window = sampleWindow();
  auto* palette = new CommandPalette(window.get());
  window->show();
  connect(window->findChild<QAction*>("undo"), &QAction::triggered, this, [&window] { window.reset(); });
  palette->popUp();
  auto* query = palette->findChild<QLineEdit*>("commandQuery");
  QTest::keyClicks(query, "undo");
  QTest::keyClick(query, Qt::Key_Return);
  QTRY_VERIFY(!window);
}

void CommandPaletteTest::staysWithinTheWindow() {
  PaletteFixture fixture;
  for (int i = 0; i < 40; ++i) {
    auto* action = new QAction(QString("Extra %1").arg(i), fixture.window.get());
    action->setObjectName(QString("extra%1").arg(i));
  }
  fixture.palette.popUp();
  for (const QSize& size : {QSize(700, 500), QSize(300, 200), QSize(1600, 900)}) {
    fixture.window->resize(size);
    QTest::qWait(1);
    QVERIFY(fixture.window->rect().contains(fixture.palette.geometry()));
  }
}

HANDWHEEL_CONTROLS_TEST(CommandPaletteTest)
#include "CommandPaletteTest.moc"
