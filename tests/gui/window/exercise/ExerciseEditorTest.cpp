// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "controls/program/ProgramEditor.h"
#include "document/exercise/ExerciseDocument.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "document/workpiece/exercise/TurningTask.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTabWidget>

using namespace handwheel;
using namespace handwheel::test;

// The panel in which a teacher prepares an exercise, with copy and work beside it.
class ExerciseEditorTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // "h10" is replaced by its limits.
  void aToleranceInTheEditor() {
    WindowDriver driver;
    driver.choose("newExercise");
    QVERIFY(driver.settle());
    QVERIFY(!driver.find<QAction>("roundTargetAction")->isEnabled());  // there is none yet
    driver.find<QTabWidget>("exerciseEditor")->setCurrentIndex(1);
    QMenu* menu = driver.find<QToolButton>("criteria/add")->menu();
    emit menu->aboutToShow();
    menu->actions().first()->trigger();  // a diameter
    driver.edit("criterion.c1.nominal", "25");
    driver.edit("criterion.c1.tolerance", "h10");
    const auto field = [&](const char* property) {
      return driver.find<QWidget>((QByteArray("property/criterion.c1.") + property).constData())
          ->findChild<QLineEdit*>()
          ->text();
    };
    QTRY_COMPARE(field("upper"), QStringLiteral("25"));
    QCOMPARE(field("lower"), QStringLiteral("24.916"));  // IT10 of 18 to 30 mm: 84 µm
    // The sum of the points stands there, too.
    driver.edit("criterion.c1.points", "7.5");
    QTRY_VERIFY2(driver.text("criteria/sum").contains("7.5"), qPrintable(driver.text("criteria/sum")));
    emit menu->aboutToShow();
    menu->actions().first()->trigger();
    driver.edit("criterion.c2.points", "3");
    QTRY_VERIFY2(driver.text("criteria/sum").contains("10.5"), qPrintable(driver.text("criteria/sum")));
    // Students read the class beside its limits.
    driver.choose("studentCopy");
    QVERIFY(driver.settle());
    QString sizes;
    for (const QLabel* const each : driver.window().findChildren<QLabel*>("lesson/sizes")) sizes += each->text();
    QVERIFY2(sizes.contains(QStringLiteral("h10: 24.916 … 25 mm")), qPrintable(sizes));
  }

  // A name says a tolerance that is in it as it stands, and not one that it begins with.
  void tolerancesInNames() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    Document& exercise = driver.window().findChild<DocumentTabs*>()->current()->document;
    QVERIFY(exercise.setProperty("criterion.d36.tolerance", std::string("±0.1")));
    QVERIFY(exercise.setProperty("criterion.d36.name", std::string("⌀36 ±0.15")));
    QVERIFY(exercise.setProperty("criterion.d28.tolerance", std::string("±0.1")));
    QVERIFY(exercise.setProperty("criterion.d28.name", std::string("⌀28 ±0.1")));
    driver.choose("studentCopy");
    QVERIFY(driver.settle());
    QString sizes;
    for (const QLabel* const each : driver.window().findChildren<QLabel*>("lesson/sizes")) sizes += each->text();
    QVERIFY2(sizes.contains(QStringLiteral("⌀36 ±0.15 ±0.1: 35.9 … 36.1 mm")), qPrintable(sizes));
    QVERIFY2(sizes.contains(QStringLiteral("⌀28 ±0.1: 27.9 … 28.1 mm")), qPrintable(sizes));
  }

  // All sizes of the target that are not marked yet by one entry of the menu, in one undo step.
  void theSizesOfTheTarget() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    driver.find<QTabWidget>("exerciseEditor")->setCurrentIndex(1);
    QMenu* menu = driver.find<QToolButton>("criteria/add")->menu();
    auto* list = driver.find<QListWidget>("criteria");
    const int before = list->count();
    emit menu->aboutToShow();
    auto* all = menu->findChild<QAction*>("criteria/addAllSizes");
    auto* each = menu->findChild<QMenu*>("criteria/sizes");
    QVERIFY(all && each && !each->actions().isEmpty());
    const auto sizes = static_cast<int>(each->actions().size());
    all->trigger();
    QTRY_COMPARE(list->count(), before + sizes);
    emit menu->aboutToShow();
    QVERIFY(!menu->findChild<QAction*>("criteria/addAllSizes"));
    driver.click("quickActions/undo");
    QTRY_COMPARE(list->count(), before);
    emit menu->aboutToShow();
    menu->findChild<QMenu*>("criteria/sizes")->actions().first()->trigger();
    QTRY_COMPARE(list->count(), before + 1);
    QCOMPARE(list->currentRow(), before);
  }

  // A warning of one field moves no other, and goes with its cause.
  void warningsMoveNoField() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    driver.find<QTabWidget>("exerciseEditor")->setCurrentIndex(1);
    driver.find<QListWidget>("criteria")->setCurrentRow(0);
    auto* const page = driver.find<QListWidget>("criteria")->parentWidget();
    const auto* const remarks = page->findChild<QLabel*>("propertyRemarks");
    QVERIFY(remarks && remarks->text().isEmpty());
    Document& exercise = driver.window().findChild<DocumentTabs*>()->current()->document;
    const auto positions = [&] {
      QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // nothing waits to be laid out
      QList<int> heights;
      for (const char* const id : {"at1", "lower", "points", "slack", "hidden"}) {
        auto* row = page->findChild<QWidget*>(QStringLiteral("property/criterion.d36.") + QLatin1String(id));
        heights << (row ? row->mapTo(page, QPoint(0, 0)).y() : -1);
      }
      return heights;
    };
    auto* const field = page->findChild<QWidget*>("property/criterion.d36.lower")->findChild<QLineEdit*>();
    const QString good = field->text(), bad = QStringLiteral("45 min");
    // The panels get their widths some time after the window is shown, and narrow names have more lines.
    for (int same = 0, width = 0; same < 5; same = page->width() == std::exchange(width, page->width()) ? same + 1 : 0)
      QTest::qWait(100);
    const QList<int> before = positions();
    QVERIFY(!before.contains(-1));
    for (const QString& text : {bad, good, bad, good}) {
      field->setFocus();
      field->selectAll();
      QTest::keyClicks(field, text);
      QTest::keyClick(field, Qt::Key_Return);
      QTRY_COMPARE(remarks->text().isEmpty(), text == good);
      QTRY_COMPARE(positions(), before);
    }
    for (const char* const limit : {"criterion.d36.lower", "criterion.d36.upper"})
      QVERIFY(exercise.setProperty(limit, std::string()));
    QTRY_VERIFY2(remarks->text().contains("they cannot be scored without a limit"), qPrintable(remarks->text()));
    driver.click("quickActions/undo");
    QTRY_VERIFY(remarks->text().isEmpty());
    QTRY_COMPARE(positions(), before);
  }

  // The marks of a step are checked in a list, and its hints are rows of another; each change is one undo step.
  void theMarksOfAStep() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    driver.find<QTabWidget>("exerciseEditor")->setCurrentIndex(2);
    driver.find<QListWidget>("steps")->setCurrentRow(0);
    const auto step = [&driver] {
      Document& shown = driver.window().findChild<DocumentTabs*>()->current()->document;
      return static_cast<ExerciseDocument&>(shown).exercise().exercise.steps[0];
    };
    const auto before = step();
    auto* marks = driver.find<QListWidget>("steps/marks");
    QVERIFY(marks->count() > 2);
    const auto isMet = [](const ExerciseStep& of, const QListWidgetItem* item) {
      const std::string id = item->data(Qt::UserRole).toString().toStdString();
      return std::find(of.criteria.begin(), of.criteria.end(), id) != of.criteria.end();
    };
    for (int i = 0; i < marks->count(); ++i)
      QCOMPARE(marks->item(i)->checkState() == Qt::Checked, isMet(before, marks->item(i)));
    QCOMPARE(marks->item(1)->checkState(), Qt::Unchecked);
    marks->item(1)->setCheckState(Qt::Checked);
    QVERIFY(isMet(step(), marks->item(1)) && step().criteria.size() == before.criteria.size() + 1);
    marks->item(1)->setCheckState(Qt::Unchecked);
    QVERIFY(step().criteria == before.criteria);
    driver.click("quickActions/undo");
    QTRY_COMPARE(step().criteria.size(), before.criteria.size() + 1);
    QCOMPARE(marks->item(1)->checkState(), Qt::Checked);

    auto* hints = driver.find<QListWidget>("steps/hints");
    QCOMPARE(hints->count(), static_cast<int>(before.hints.size()));
    const auto steps = [&driver] {
      return driver.window().findChild<DocumentTabs*>()->current()->document.history()->index();
    };
    const int done = steps();
    driver.click("steps/addHint");
    QCOMPARE(step().hints.size(), before.hints.size() + 1);
    hints->item(hints->count() - 1)->setText("Oil | or air; not both");
    QCOMPARE(step().hints.back(), std::string("Oil | or air; not both"));
    QCOMPARE(steps(), done + 1);  // added with its text
    driver.click("steps/addHint");
    hints->item(hints->count() - 1)->setText("Slowly");
    QCOMPARE(steps(), done + 2);
    QCOMPARE(step().hints.size(), before.hints.size() + 2);
    driver.click("quickActions/undo");
    QTRY_COMPARE(step().hints.size(), before.hints.size() + 1);
    hints->item(hints->count() - 1)->setText("Oil | or air; not both!");
    QCOMPARE(steps(), done + 2);  // a change later is one of its own
    driver.click("quickActions/undo");
    QTRY_COMPARE(step().hints.back(), std::string("Oil | or air; not both"));
    hints->setCurrentRow(hints->count() - 1);
    driver.click("steps/removeHint");
    QVERIFY(step().hints == before.hints);
  }

  // A teacher adds a mark and a step, changes them, and takes it back.
  void theTeachersEditor() {
    WindowDriver driver;
    driver.choose("newExercise");
    QVERIFY(driver.settle());
    driver.edit("title", "Bolt");
    driver.edit("diameter", "30");
    auto* editor = driver.find<QTabWidget>("exerciseEditor");
    editor->setCurrentIndex(2);
    driver.click("steps/add");
    auto* steps = driver.find<QListWidget>("steps");
    QTRY_COMPARE(steps->count(), 1);
    driver.edit("step.1.title", "Face");
    QTRY_VERIFY(steps->item(0)->text().contains("Face"));
    driver.click("quickActions/undo");
    driver.click("quickActions/undo");
    QTRY_COMPARE(steps->count(), 0);
    // The student's copy is another document, without an editor.
    driver.choose("studentCopy");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
    QVERIFY(driver.find<QWidget>("exercisePage")->isVisible());
    QVERIFY(!editor->isVisible());
    // It is named by its title and its kind, and so is its file: neither is taken for the teacher's.
    QCOMPARE(driver.find<DocumentTabs>("tabRow")->current()->document.name(), QStringLiteral("Bolt, student's copy"));
    driver.choose("saveFile");
    auto* dialog = driver.find<QFileDialog>("saveDialog");
    QTRY_VERIFY(dialog->isVisible());
    QCOMPARE(QFileInfo(dialog->selectedFiles().value(0)).fileName(), QStringLiteral("Bolt, student's copy.handwheel"));
    dialog->reject();
  }

  // The exercise that is open in another tab is not written over by the copy, whatever a person answers to the question
  // of the dialog.
  void theCopyDoesNotReplaceTheExercise() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("bolt.handwheel");
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", path));
    QVERIFY(driver.settle());
    const auto bytes = [&path] {
      QFile file(path);
      return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray before = bytes();
    QVERIFY(!before.isEmpty());
    driver.choose("studentCopy");
    QVERIFY(driver.settle());
    driver.choose("saveFile");
    QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
    driver.find<QFileDialog>("saveDialog")->setOption(QFileDialog::DontConfirmOverwrite);  // it was answered with Yes
    QVERIFY(driver.enterFileName("saveDialog", path));
    QVERIFY(driver.settle());
    QTRY_VERIFY2(driver.text("messageText").contains("open in another tab"), qPrintable(driver.text("messageText")));
    QVERIFY(bytes() == before);
    const Document& copy = driver.window().findChild<DocumentTabs*>()->current()->document;
    QVERIFY(copy.path().isEmpty());
    // Another name is offered, and taken.
    driver.click("messageAction");
    QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
    QVERIFY(driver.enterFileName("saveDialog", folder.filePath("copy.handwheel")));
    QVERIFY(driver.settle());
    QCOMPARE(copy.path(), folder.filePath("copy.handwheel"));
    // Both keep their own files.
    driver.choose("saveFile");
    QVERIFY(driver.settle());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    driver.choose("saveFile");
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
  }

  // A teacher who tries the copy begins with a new bar, even if the teacher's own work is still open.
  void theCopyHasWorkOfItsOwn() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    auto* tabs = driver.window().findChild<DocumentTabs*>();
    const DocumentTab* const own = tabs->current();
    auto* bar = driver.find<QTabBar>("documentTabBar");
    bar->setCurrentIndex(0);
    driver.choose("studentCopy");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 3);
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 4);
    const DocumentTab* const tried = tabs->current();
    QVERIFY(tried != own && driver.find<QDockWidget>("lessonDock")->isVisible());
    // Each continues with its own work.
    bar->setCurrentIndex(2);
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    QVERIFY(tabs->current() == tried);
    bar->setCurrentIndex(0);
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    QVERIFY(tabs->current() == own);
    QCOMPARE(driver.tabs(), 4);
  }

  // The pages of the exercise are in front whenever it is shown, and the panel of the part after that of the program.
  void thePanelComesToTheFront() {
    WindowDriver driver;
    const auto isInFront = [&driver](const char* dock) {
      return !driver.find<QDockWidget>(dock)->visibleRegion().isEmpty();
    };
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    QTRY_VERIFY(isInFront("kindDock"));
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    driver.choose("programDockToggle");
    QTRY_VERIFY(isInFront("programDock") && !isInFront("kindDock"));
    driver.choose("programDockToggle");
    QTRY_VERIFY(isInFront("kindDock"));
    driver.choose("programDockToggle");
    QTRY_VERIFY(isInFront("programDock"));
    auto* bar = driver.find<QTabBar>("documentTabBar");
    bar->setCurrentIndex(0);
    QTRY_VERIFY(isInFront("kindDock") && driver.find<QWidget>("exerciseEditor")->isVisible());
    // The same holds after any other panel.
    bar->setCurrentIndex(1);
    driver.find<QDockWidget>("viewDock")->raise();
    QTRY_VERIFY(isInFront("viewDock"));
    bar->setCurrentIndex(0);
    QTRY_VERIFY(isInFront("kindDock"));
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Exercise"));
    // The same holds after the panel of the part was closed.
    bar->setCurrentIndex(1);
    driver.find<QDockWidget>("kindDock")->close();
    QTRY_VERIFY(!isInFront("kindDock"));
    bar->setCurrentIndex(0);
    QTRY_VERIFY(isInFront("kindDock") && driver.find<QWidget>("exerciseEditor")->isVisible());
  }

  // If the exercise is to be done by hand, no program is run or made, and the panel gives the reason.
  void programsAreRefused() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    auto* tabs = driver.window().findChild<DocumentTabs*>();
    QVERIFY(tabs->current()->document.setProperty("programs", false));
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    driver.choose("programDockToggle");
    QTRY_VERIFY(driver.find<ProgramEditor>("programEditor")->isVisible());
    QVERIFY2(driver.text("programSummary").contains("by hand"), qPrintable(driver.text("programSummary")));
    auto* editor = driver.find<ProgramEditor>("programEditor");
    editor->insertPlainText("G7 G21 G97 S600 M3\nG0 X36 Z2\nG1 Z-20 F120\nG0 X44\nM2\n");
    driver.click("programRun");
    QVERIFY(driver.settle());
    QVERIFY2(driver.text("programSummary").contains("by hand"), qPrintable(driver.text("programSummary")));
    QVERIFY(!driver.find<QPushButton>("programCut")->isEnabled());
    driver.find<QToolButton>("programMake")->actions().back()->trigger();  // "Rough and finish…"
    QVERIFY(!driver.window().findChild<QDialog*>("cyclesDialog"));
    const SnapshotPointer work = tabs->current()->document.snapshot();
    QVERIFY(!static_cast<const WorkpieceSnapshot&>(*work).part);
    // Nor is a thread made by a command, unless the teacher allows it.
    auto* const thread = driver.find<QAction>("thread");
    QVERIFY(!thread->isEnabled() && thread->property("disabledReason").toString().contains("half-nut"));
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(tabs->current()->document.setProperty("commands", true));
    driver.choose("beginExercise");
    QVERIFY(driver.settle() && thread->isEnabled());
  }
};

HANDWHEEL_WINDOW_TEST(ExerciseEditorTest)
#include "ExerciseEditorTest.moc"
