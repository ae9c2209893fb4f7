// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "../haptics/TurningWindow.h"
#include "LessonWidgets.h"
#include "controls/CommandModel.h"
#include "document/exercise/ExerciseDocument.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/exercise/TurningTask.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/Samples.h"

#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTabWidget>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Begins the exercise with this command, seen from above with the turning tool in use.
bool beginTurning(TurningWindow& turning, const char* command) {
  turning.driver.choose(command);
  if (!turning.driver.settle()) return false;
  turning.driver.choose("beginExercise");
  if (!turning.driver.settle()) return false;
  turning.view->setStandardView(StandardView::Top);
  if (!QTest::qWaitFor([&] { return turning.view->isPickingReady(); }, kPatienceMs)) return false;
  turning.driver.find<QAction>("turnTool")->trigger();
  QSize before;  // the settings of the tool take room from the view
  do {
    before = turning.view->size();
    QTest::qWait(200);
  } while (turning.view->size() != before);
  return turning.driver.settle();
}

}  // namespace

// The procedures of a student and of a teacher through the window.
class ExerciseWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  void aLessonOpensItsBar() {
    WindowDriver driver;
    driver.click("lessonTile");
    QVERIFY(driver.settle());
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Exercise"));
    QVERIFY(!driver.find<QDockWidget>("lessonDock")->isVisible());
    // The task shows the sizes.
    QVERIFY2(labelsOf(driver.find<QWidget>("exercisePage")).contains(QStringLiteral("⌀30 ±0.5: 29.5 … 30.5 mm")),
             qPrintable(labelsOf(driver.find<QWidget>("exercisePage"))));
    QTest::mouseClick(partOfLesson<QPushButton>(driver, "exercisePage", "lesson/begin"), Qt::LeftButton);
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
    auto* lesson = driver.find<QWidget>("exerciseLesson");
    QTRY_VERIFY(lesson->isVisible());
    QVERIFY(driver.text("figures").contains(QStringLiteral("40")));
    QVERIFY(labelsOf(lesson).contains(QStringLiteral("⌀30 ±0.5: 29.5 … 30.5 mm")));

    // A step that the person does, with one hint after another.
    auto* steps = partOfLesson<QListWidget>(driver, "exerciseLesson", "lessonSteps");
    QCOMPARE(steps->count(), 5);
    steps->setCurrentRow(1);
    auto* hint = partOfLesson<QPushButton>(driver, "exerciseLesson", "lessonAskHint");
    QTRY_VERIFY(hint->isVisible());
    hint->click();
    QTRY_VERIFY(labelsOf(lesson).contains("Begin beyond its end"));
    QVERIFY(!labelsOf(lesson).contains("takes a pass back") && hint->isVisible());
    hint->click();
    QTRY_VERIFY(labelsOf(lesson).contains("takes a pass back"));
    QVERIFY(!hint->isVisible());

    // The bar is too thick yet.
    partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/measure")->click();
    QVERIFY(driver.settle());
    QTRY_VERIFY(labelsOf(lesson).contains(QStringLiteral("✗")));
    QVERIFY2(labelsOf(lesson).contains("above the upper limit"), qPrintable(labelsOf(lesson)));
    const auto* const sizes = partOfLesson<QLabel>(driver, "exerciseLesson", "lesson/sizes");
    QTRY_VERIFY(sizes->visibleRegion().boundingRect().height() > sizes->fontMetrics().height());
    QTRY_VERIFY(sizes->visibleRegion().contains(QPoint(2, 2)));  // the first of them is in view
    // Measured sizes look outdated once the work is changed, and new when it is measured again.
    QVERIFY(sizes->isEnabled());
    QVERIFY(driver.window().findChild<DocumentTabs*>()->current()->document.setProperty("chord", 0.05));
    QTRY_VERIFY(!sizes->isEnabled() && sizes->text().startsWith("The work was changed since"));
    QVERIFY(sizes->text().contains(QStringLiteral("✗")));
    partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/measure")->click();
    QVERIFY(driver.settle());
    QTRY_VERIFY(sizes->isEnabled() && !sizes->text().contains("changed since"));
    // A look at the task, and they are there still.
    const QString measured = sizes->text();
    auto* const tabs = driver.find<QTabBar>("documentTabBar");
    tabs->setCurrentIndex(0);
    QVERIFY(driver.settle());
    tabs->setCurrentIndex(1);
    QVERIFY(driver.settle());
    QCOMPARE(sizes->text(), measured);
    QVERIFY(sizes->isEnabled());
    // Cuts made during a measurement are measured, too: ⌀30 up to the shoulder at Z 50, at 0.25 mm per revolution.
    auto& work = static_cast<WorkpieceDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
    TurningPass pass;
    pass.noseRadius = 0.8;
    pass.path = {{15.8, 82.0}, {15.8, 50.8}};
    pass.times = {0.0, 31.2 / (0.25 * 800.0 / 60.0)};
    const auto part = withPass(work.workpiece(), pass, 0.05);
    partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/measure")->click();
    work.commit("Turn", std::make_unique<TurnedPartEdit>(part));
    QVERIFY(driver.settle());
    QTRY_VERIFY2(sizes->isEnabled() && sizes->text().contains(QStringLiteral("✓ ⌀30 ±0.5")), qPrintable(sizes->text()));
    // A crash outdates them, too, which is no undo step, but not the data of the lesson itself: its name and its time.
    QTest::keyClicks(partOfLesson<QLineEdit>(driver, "exerciseLesson", "lesson/name"), "A");
    QTest::qWait(1200);  // two ticks of its clock
    QVERIFY(sizes->isEnabled());
    const LatheCollision crash;
    work.addCrashes({&crash, 1});
    QTRY_VERIFY(!sizes->isEnabled() && sizes->text().startsWith("The work was changed since"));
    partOfLesson<QLineEdit>(driver, "exerciseLesson", "lesson/name")->clear();

    QVERIFY(!partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/handIn")->isEnabled());
  }

  // The work is a document: saved and opened another day, the lesson continues with its hints, its time and its name.
  void theNextDay() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("work.handwheel");
    {
      WindowDriver driver;
      driver.click("lessonTile");
      QVERIFY(driver.settle());
      driver.choose("beginExercise");
      QVERIFY(driver.settle());
      partOfLesson<QListWidget>(driver, "exerciseLesson", "lessonSteps")->setCurrentRow(1);
      partOfLesson<QPushButton>(driver, "exerciseLesson", "lessonAskHint")->click();
      QTest::keyClicks(partOfLesson<QLineEdit>(driver, "exerciseLesson", "lesson/name"), "Ada");
      // It is worth a question before it is closed.
      auto* tabs = driver.window().findChild<DocumentTabs*>();
      QVERIFY(tabs->current()->document.isModified());
      // Begin goes to the work that there is.
      driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
      QVERIFY(!driver.find<QDockWidget>("lessonDock")->isVisible());
      driver.choose("beginExercise");
      QVERIFY(driver.settle());
      QCOMPARE(driver.tabs(), 2);
      QVERIFY(driver.find<QDockWidget>("lessonDock")->isVisible());
      // Closed by mistake, it comes back by the menu View; the search finds it by its purpose.
      auto* const toggle = driver.window().findChild<QAction*>("lessonDockToggle");
      QVERIFY(toggle && driver.window().findChild<QMenu*>("viewMenu")->actions().contains(toggle));
      for (const char* word : {"measure", "hand in"}) QVERIFY(toggle->toolTip().contains(QLatin1String(word)));
      driver.find<QDockWidget>("lessonDock")->close();
      QTRY_VERIFY(!toggle->isChecked());
      toggle->trigger();
      QTRY_VERIFY(driver.find<QDockWidget>("lessonDock")->isVisible());
      driver.click("quickActions/saveFile");
      QVERIFY(driver.enterFileName("saveDialog", path));
      QVERIFY(driver.settle());
      QVERIFY(!tabs->current()->document.isModified());
    }
    WindowDriver driver;
    QVERIFY(driver.open(path));
    QTRY_VERIFY(driver.find<QDockWidget>("lessonDock")->isVisible());
    QCOMPARE(partOfLesson<QLineEdit>(driver, "exerciseLesson", "lesson/name")->text(), QStringLiteral("Ada"));
    QVERIFY(partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/handIn")->isEnabled());
    auto* lesson = driver.find<QWidget>("exerciseLesson");
    partOfLesson<QListWidget>(driver, "exerciseLesson", "lessonSteps")->setCurrentRow(1);
    QVERIFY(labelsOf(lesson).contains("Begin beyond its end"));
    QVERIFY(!labelsOf(lesson).contains("takes a pass back"));
  }

  // Save writes the description that was opened; no name is asked for.
  void aDescriptionIsSavedInPlace() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("own.exercise.json");
    QVERIFY(QFile::copy(samplePath("shaft.exercise.json"), path));
    QFile(path).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    WindowDriver driver;
    QVERIFY(driver.open(path));
    auto* tabs = driver.window().findChild<DocumentTabs*>();
    Document& document = tabs->current()->document;
    QVERIFY(document.setProperty("title", std::string("Axle")));
    driver.choose("saveFile");
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().findChild<QFileDialog*>("saveDialog"));
    QVERIFY(!document.isModified() && !document.file().isContainer);
    QFile file(path);
    QVERIFY(file.open(QFile::ReadOnly));
    const auto json = nlohmann::json::parse(file.readAll().toStdString());
    QVERIFY(json["title"] == "Axle" && json["solution"]["passes"].size() > 1 && json.contains("faults"));
    QVERIFY(!driver.find<QWidget>("messageBar")->isVisible());
    // Another name keeps the ending of descriptions apart from the name.
    driver.choose("saveFileAs");
    QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
    QCOMPARE(driver.find<QFileDialog>("saveDialog")->selectedFiles(), QStringList(folder.filePath("own.handwheel")));
    driver.find<QFileDialog>("saveDialog")->reject();
  }

  // A pass by the mouse: the marks are those of the radii that the part has.
  void turnedHandedInAndMarked() {
    const QTemporaryDir folder;
    TurningWindow turning;
    WindowDriver& driver = turning.driver;
    QVERIFY(beginTurning(turning, "exercise/first-lesson-teacher"));
    turning.drag(turning.pixelOf(16.1, 84.0), turning.pixelOf(16.1, 51.0));
    QVERIFY(turning.workpiece().part);
    QVERIFY(driver.settle());
    double largest = 0.0;
    for (double z = 53.0; z <= 79.0; z += 0.05) largest = std::max(largest, 2.0 * turning.radiusAt(z));
    double least = 100.0;
    for (double z = 53.0; z <= 79.0; z += 0.05) least = std::min(least, 2.0 * turning.radiusAt(z));
    const double worst = largest - 30.0 >= 30.0 - least ? largest : least;
    const double beyond = std::max({0.0, 29.5 - worst, worst - 30.5});
    const double expected = 10.0 * std::max(0.0, 1.0 - beyond / 0.2);  // "No points this far beyond"

    // The step of that diameter is ticked at once where the part is so, and no size is revealed.
    const auto isTicked = [&driver] {
      Document& work = driver.window().findChild<DocumentTabs*>()->current()->document;
      const nlohmann::json done = work.file().assigned.attempt->value("done", nlohmann::json::array());
      return std::any_of(done.begin(), done.end(), [](const auto& each) { return each == true; });
    };
    if (beyond == 0.0) QTRY_VERIFY(isTicked());
    QVERIFY(!labelsOf(driver.find<QWidget>("exerciseLesson")).contains(QStringLiteral("✓")));

    QTest::keyClicks(partOfLesson<QLineEdit>(driver, "exerciseLesson", "lesson/name"), "Ada");
    partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/handIn")->click();
    // Neither among the samples nor in the folder of the program; the next time where it was handed in.
    auto* handIn = driver.find<QFileDialog>("handInDialog");
    QVERIFY(!handIn->directory().absolutePath().contains("samples"));
    const QString path = folder.filePath("ada.handwheel");
    QVERIFY(driver.enterFileName("handInDialog", path));
    QVERIFY(driver.settle());
    partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/handIn")->click();
    QCOMPARE(QFileInfo(driver.find<QFileDialog>("handInDialog")->directory().absolutePath()).canonicalFilePath(),
             QFileInfo(folder.path()).canonicalFilePath());
    driver.find<QFileDialog>("handInDialog")->reject();
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    driver.choose("markExercise");
    QVERIFY(driver.enterFileName("markDialog", path));
    QVERIFY(driver.settle());
    const QAbstractItemModel* rows = driver.find<QAbstractItemView>("classRows")->model();
    QTRY_COMPARE(rows->rowCount(), 1);
    int column = 0;
    while (column < rows->columnCount() &&
           rows->headerData(column, Qt::Horizontal).toString() != QStringLiteral("⌀30 ±0.5"))
      ++column;
    const double marked = rows->index(0, column).data().toString().toDouble();
    QVERIFY2(std::abs(marked - expected) < 0.02, qPrintable(QStringLiteral("%1 for %2 mm").arg(marked).arg(worst)));

    // A submission is played beside the work.
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(1);
    QVERIFY(driver.settle());
    driver.choose("replayDockToggle");
    QVERIFY(driver.settle());
    auto* const compare = driver.find<QPushButton>("replayCompare");
    QTRY_VERIFY(compare->isEnabled());
    driver.click("replayCompare");
    QVERIFY(driver.enterFileName("replayCompareDialog", path) && driver.settle());
    QTRY_VERIFY2(compare->text().contains("ada.handwheel"), qPrintable(compare->text()));
  }

  // The class of a tolerance is said once, also where the name has it and the tolerance more than it.
  void aToleranceIsSaidOnce() {
    WindowDriver driver;
    driver.choose("exercise/thread-m20");
    QVERIFY(driver.settle());
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    const QString sizes = labelsOf(driver.find<QWidget>("exerciseLesson"));
    QVERIFY2(sizes.contains(QStringLiteral("Pitch diameter 18.376 6g:")), qPrintable(sizes));
    QVERIFY2(!sizes.contains(QStringLiteral("6g 6g")) && !sizes.contains(QStringLiteral("h11 h11")), qPrintable(sizes));
  }

  // The dialog says how much that changes; one undo step.
  void theTargetInRoundSizes() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    const auto task = [&driver] {
      Document& shown = driver.window().findChild<DocumentTabs*>()->current()->document;
      return static_cast<ExerciseDocument&>(shown).exercise().task;
    };
    const TaskPointer before = task();
    driver.choose("roundTargetAction");
    QTRY_VERIFY(driver.find<QDialog>("roundTargetDialog")->isVisible());
    driver.edit("round-target", "10");
    QTRY_VERIFY2(driver.text("roundTargetRemark").contains(QStringLiteral("mm")),
                 qPrintable(driver.text("roundTargetRemark")));
    driver.edit("round-target", "2");
    QTRY_VERIFY(driver.find<QPushButton>("roundTarget")->isEnabled());
    driver.click("roundTarget");
    QVERIFY(driver.settle());
    QVERIFY(task() != before);
    driver.click("quickActions/undo");
    QTRY_VERIFY(task() == before);
  }

  // An untouched bar is no target, which is said.
  void theBarIsNoTarget() {
    WindowDriver driver;
    driver.choose("newExercise");
    QVERIFY(driver.settle());
    auto* tabs = driver.window().findChild<DocumentTabs*>();
    auto& exercise = static_cast<ExerciseDocument&>(tabs->current()->document);
    const TaskPointer before = exercise.exercise().task;
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    driver.choose("takeTarget");
    QVERIFY(driver.settle());
    QTRY_VERIFY2(driver.text("messageText").contains("Nothing was turned"), qPrintable(driver.text("messageText")));
    QVERIFY(exercise.exercise().task == before);
  }

  // A drawing becomes the target at the position in the bar that the dialog shows, in one undo step; a file that is not
  // a drawing is refused by its name.
  void theTargetFromADrawing() {
    const QTemporaryDir folder;
    const auto put = [&folder](const char* name, const QByteArray& bytes) {
      QFile file(folder.filePath(name));
      if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("no room for %s", name);
      return file.fileName();
    };
    const QString shaft = put("shaft.svg",
                              "<svg xmlns='http://www.w3.org/2000/svg' width='60mm' height='20mm' viewBox='0 0 60 20'>"
                              "<line id='axis' x1='0' y1='20' x2='60' y2='20'/>"
                              "<path d='M0,20 L0,2 L40,2 L40,8 L60,8 L60,20'/></svg>");
    const QString notes = put("notes.dxf", "hello");
    WindowDriver driver;
    driver.choose("newExercise");
    QVERIFY(driver.settle());
    auto& exercise = static_cast<ExerciseDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
    const TaskPointer before = exercise.exercise().task;
    driver.choose("importExerciseTarget");
    QVERIFY(driver.enterFileName("exerciseTargetDialog", notes));
    QVERIFY(driver.settle());
    QTRY_VERIFY2(driver.text("messageText").contains("notes.dxf"), qPrintable(driver.text("messageText")));
    QVERIFY(exercise.exercise().task == before);
    driver.choose("importExerciseTarget");
    QVERIFY(driver.enterFileName("exerciseTargetDialog", shaft));
    QVERIFY(driver.settle());
    // The bar is 100 mm long, the part 60 mm: 1 mm is offered for facing, and taken back once.
    QTRY_VERIFY(driver.window().findChild<QDialog*>("targetPlaceDialog"));
    auto* dialog = driver.find<QDialog>("targetPlaceDialog");
    QTRY_VERIFY(dialog->isVisible());
    const auto faceIs = [&](const QString& text) {
      const auto labels = dialog->findChild<QWidget*>("property/target_face")->findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [&](const QLabel* each) { return each->text() == text; });
    };
    QVERIFY(faceIs("99\u00a0mm"));
    dialog->reject();
    QTRY_VERIFY(!driver.window().findChild<QDialog*>("targetPlaceDialog"));
    QVERIFY(exercise.exercise().task == before);
    driver.choose("importExerciseTarget");
    QVERIFY(driver.enterFileName("exerciseTargetDialog", shaft));
    QVERIFY(driver.settle());
    QTRY_VERIFY(driver.window().findChild<QDialog*>("targetPlaceDialog"));
    dialog = driver.find<QDialog>("targetPlaceDialog");
    QVERIFY(QTest::qWaitForWindowActive(dialog, kPatienceMs));  // Tab takes a number where the field has the focus
    const auto facing = [&] {
      return dialog->findChild<QWidget*>("property/facing_allowance")->findChild<QLineEdit*>();
    };
    const auto enter = [&](const char* length) {
      facing()->setFocus();
      facing()->selectAll();
      QTest::keyClicks(facing(), QString::fromLatin1(length));
      QTest::keyClick(facing(), Qt::Key_Tab);
    };
    QVERIFY(facing()->text().startsWith(QLatin1Char('1')));
    // 60 mm do not fit behind 50 mm in a bar of 100; the warning about that disappears with it.
    enter("50");
    QTRY_VERIFY_WITH_TIMEOUT(labelsOf(dialog).contains("does not fit"), kPatienceMs);
    enter("2.5");
    QTRY_VERIFY_WITH_TIMEOUT(!labelsOf(dialog).contains("does not fit"), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(faceIs("97.5\u00a0mm"), kPatienceMs);  // no text in the dialog shows another position
    QVERIFY(!labelsOf(dialog).contains("behind the free end of the bar"));
    // The end of ⌀24 is at the largest X of the drawing; end for end, that of ⌀36 is the free one, and back.
    QVERIFY2(labelsOf(dialog).contains(QStringLiteral("⌀24 mm is the free one")), qPrintable(labelsOf(dialog)));
    QVERIFY(dialog->findChild<QLabel*>("targetPlacePicture")->isVisible());
    dialog->findChild<QPushButton*>("turnTarget")->click();
    QVERIFY2(labelsOf(dialog).contains(QStringLiteral("⌀36 mm is the free one")), qPrintable(labelsOf(dialog)));
    QVERIFY(faceIs("97.5\u00a0mm"));
    dialog->findChild<QPushButton*>("propertiesAccept")->click();
    QVERIFY(driver.settle());
    const auto& task = static_cast<const TurningTask&>(*exercise.exercise().task);
    QVERIFY(task.target);
    QVERIFY(std::abs(task.target->largestRadius() - 18.0) < 1e-3);
    QVERIFY(std::abs(task.target->length() - 60.0) < 1e-3);
    QVERIFY(std::abs(task.target->upperEnd() - (task.stock.length - 2.5)) < 1e-3);
    QVERIFY(std::abs(task.target->extentAt(task.target->upperEnd() - 20.5)->outer - 18.0) < 1e-3);
    driver.choose("turnTargetAction");
    QTRY_VERIFY(driver.text("messageText").contains("the other way round"));
    const auto& back = static_cast<const TurningTask&>(*exercise.exercise().task);
    QVERIFY(std::abs(back.target->extentAt(back.target->upperEnd() - 19.5)->outer - 12.0) < 1e-3);
    driver.click("quickActions/undo");
    QTRY_VERIFY(!driver.text("messageText").contains("the other way round"));
    driver.click("quickActions/undo");
    QTRY_VERIFY(exercise.exercise().task == before);
    QVERIFY(!driver.text("messageText").contains("is the target now"));  // the message is outdated
  }

  // The work becomes the model solution, which says so and can be looked at.
  void theModelSolution() {
    WindowDriver driver;
    driver.choose("newExercise");
    QVERIFY(driver.settle());
    QVERIFY(!driver.find<QAction>("openSolution")->isEnabled());
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    driver.choose("takeSolution");
    QTRY_VERIFY(driver.text("messageText").contains("Model solution taken"));
    QCOMPARE(driver.tabs(), 2);
    driver.choose("openSolution");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 3);
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Stock"));
  }

  // Teachers with several documents open know which one is the solution, and which one is a student's; so do the files.
  void worksAreCalledByTheirExercise() {
    WindowDriver driver;
    const auto name = [&] { return driver.window().findChild<DocumentTabs*>()->current()->document.name(); };
    const auto offered = [&] {
      driver.choose("saveFileAs");
      QFileDialog* dialog = nullptr;
      const auto appears = [&] { return (dialog = driver.window().findChild<QFileDialog*>("saveDialog")) != nullptr; };
      if (!QTest::qWaitFor(appears, kPatienceMs) || dialog->selectedFiles().isEmpty()) return QString();
      const QString file = QFileInfo(dialog->selectedFiles().constFirst()).fileName();
      dialog->reject();
      const auto goes = [&] { return !driver.window().findChild<QFileDialog*>("saveDialog"); };
      return QTest::qWaitFor(goes, kPatienceMs) ? file : QString();
    };
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    driver.choose("openSolution");
    QVERIFY(driver.settle());
    QCOMPARE(name(), QStringLiteral("Model solution of Shaft with shoulders"));
    QCOMPARE(offered(), QStringLiteral("Model solution of Shaft with shoulders.handwheel"));
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    QCOMPARE(name(), QStringLiteral("Work on Shaft with shoulders"));
    QCOMPARE(offered(), QStringLiteral("Work on Shaft with shoulders.handwheel"));
  }

  // The student sees the target, and cannot change the bar.
  void theTargetBesideTheWork() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    QTRY_VERIFY(labelsOf(driver.find<QWidget>("targetPanel")).contains("Target of the exercise"));
    QVERIFY(driver.text("targetSizes").contains(QStringLiteral("⌀")));
    QVERIFY(driver.find<QAction>("targetOutline")->isChecked());
    QVERIFY(!driver.find<QAction>("importTarget")->isEnabled() && !driver.find<QAction>("removeTarget")->isEnabled());
    QCOMPARE(driver.find<QAction>("importTarget")->property(kDisabledReason).toString(),
             "The target is that of the exercise.");
    auto* diameter = driver.find<QWidget>("property/diameter")->findChild<QLineEdit*>();
    QVERIFY(!diameter || !diameter->isEnabled() || diameter->isReadOnly());
  }
};

HANDWHEEL_WINDOW_TEST(ExerciseWindowTest)
#include "ExerciseWindowTest.moc"
