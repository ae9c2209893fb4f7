// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "LessonWidgets.h"
#include "document/exercise/ExerciseDocument.h"
#include "report/exercise/MarkingReport.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QAbstractItemView>
#include <QFile>
#include <QFileDialog>
#include <QItemSelectionModel>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The students in the table of a class.
QStringList namesIn(const QAbstractItemView* rows) {
  QStringList names;
  for (int row = 0; row < rows->model()->rowCount(); ++row) names << rows->model()->index(row, 0).data().toString();
  return names;
}

}  // namespace

// The submissions of a class: marked, added to, reported and kept.
class SubmissionsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  void handedInAndMarked() {
    const QTemporaryDir folder;
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    driver.choose("beginExercise");
    QVERIFY(driver.settle());
    auto* name = partOfLesson<QLineEdit>(driver, "exerciseLesson", "lesson/name");
    QTest::keyClicks(name, "Ada");
    auto* handIn = partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/handIn");
    QVERIFY(handIn->isEnabled());
    // Cancelling hands in nothing.
    handIn->click();
    auto* dialog = driver.find<QFileDialog>("handInDialog");
    QTRY_VERIFY(dialog->isVisible());
    dialog->reject();
    QVERIFY(driver.settle());
    QVERIFY(driver.tabs() == 2 && !labelsOf(&driver.window()).contains("Handed in by"));
    handIn->click();
    const QString path = folder.filePath("ada.handwheel");
    QVERIFY(driver.enterFileName("handInDialog", path));
    QVERIFY(driver.settle());
    QTRY_VERIFY(QFile::exists(path));
    QTRY_VERIFY(driver.text("messageText").contains("Handed in by Ada"));
    QVERIFY(driver.text("messageText").contains("cannot be measured"));  // a bar has no shoulders
    QCOMPARE(driver.tabs(), 2);

    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    QVERIFY(!driver.find<QWidget>("messageBar")->isVisible());  // the student's is over the student's work only
    driver.choose("markExercise");
    QVERIFY(driver.enterFileName("markDialog", path));
    QVERIFY(driver.settle());
    auto* rows = driver.find<QAbstractItemView>("classRows");
    QTRY_COMPARE(rows->model()->rowCount(), 1);
    QVERIFY(driver.find<QWidget>("messageBar")->isVisible());
    QVERIFY(driver.text("messageText").contains("1 work marked"));
    QVERIFY(driver.text("messageText").contains("Ada: "));
    QCOMPARE(rows->model()->index(0, 0).data().toString(), QStringLiteral("Ada"));
    QVERIFY(rows->isVisible());
    // Another document for a moment, and the class is there still.
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(1);
    QVERIFY(driver.settle());
    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    QCOMPARE(rows->model()->rowCount(), 1);
    // Late ones come to the others, the same file again takes its row; each is an undo step.
    const QString late = folder.filePath("late.handwheel"), broken = folder.filePath("broken.handwheel");
    QVERIFY(QFile::copy(path, late));
    QFile junk(broken);
    QVERIFY(junk.open(QIODevice::WriteOnly) && junk.write("no file of ours") > 0);
    junk.close();
    for (const QString& more : {late, path, broken}) {
      driver.choose("markExercise");
      QVERIFY(driver.enterFileName("markDialog", more));
      QVERIFY(driver.settle());
    }
    QTRY_COMPARE(rows->model()->rowCount(), 3);
    QVERIFY(namesIn(rows).contains(QStringLiteral("broken.handwheel")));  // it has no name
    Document& marked = driver.find<DocumentTabs>("tabRow")->current()->document;
    QVERIFY(marked.isModified());  // closing asks
    marked.history()->undo();
    QTRY_COMPARE(rows->model()->rowCount(), 2);
    driver.click("classReport");
    const QString report = folder.filePath("class.html");
    QVERIFY(driver.enterFileName("classFileDialog", report));
    QVERIFY(driver.settle());
    QTRY_VERIFY(QFile::exists(report));
    QFile file(report);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray html = file.readAll();
    QVERIFY(html.contains("Ada") && html.contains("0 / 15") && html.contains("data:image/png;base64,"));
  }

  // Work marked by other criteria is labelled so; work marked by older versions, whose hash covers the criteria alone,
  // is not.
  void whatWasMarkedByAnotherScheme() {
    WindowDriver driver;
    driver.choose("exercise/shaft");
    QVERIFY(driver.settle());
    const auto& shown = static_cast<ExerciseDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
    ExerciseSnapshot exercise = shown.exercise();
    std::vector<ReportedWork> works(3);
    works[0].scheme = schemeMark(exercise);
    works[1].scheme = schemeMark(exercise.exercise);
    works[2].scheme = 1;
    for (std::size_t i = 0; i < works.size(); ++i) works[i].path = "/class/" + std::to_string(i);
    exercise.marked = std::make_shared<const MarkedSubmissions>(withMarked({}, std::move(works)));
    const auto isRemarked = [&exercise](std::size_t work) {
      const std::vector<std::string> remarks = submissionsReportOf(exercise).works.at(work).row.remarks;
      return std::any_of(remarks.begin(), remarks.end(),
                         [](const std::string& each) { return each.starts_with("The exercise was changed"); });
    };
    QVERIFY(!isRemarked(0) && !isRemarked(1) && isRemarked(2));
    exercise.exercise.criteria[0].points += 1.0;
    QVERIFY(isRemarked(0) && isRemarked(1) && isRemarked(2));
  }

  // Saved with the exercise, the class is there again; whom the teacher takes out is not.
  void theClassIsKept() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("ada.handwheel"), teachers = folder.filePath("teacher.handwheel");
    {
      WindowDriver driver;
      driver.choose("exercise/shaft");
      QVERIFY(driver.settle());
      driver.choose("beginExercise");
      QVERIFY(driver.settle());
      QTest::keyClicks(partOfLesson<QLineEdit>(driver, "exerciseLesson", "lesson/name"), "Ada");
      partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/handIn")->click();
      QVERIFY(driver.enterFileName("handInDialog", path));
      QVERIFY(driver.settle());
      driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
      QVERIFY(driver.settle());
      driver.choose("markExercise");
      QVERIFY(driver.enterFileName("markDialog", path));
      QVERIFY(driver.settle());
      QTRY_COMPARE(namesIn(driver.find<QAbstractItemView>("classRows")), QStringList{"Ada"});
      driver.choose("saveFile");
      QVERIFY(driver.enterFileName("saveDialog", teachers));
      QVERIFY(driver.settle());
      QTRY_VERIFY(QFile::exists(teachers));
    }
    WindowDriver driver;
    QVERIFY(driver.open(teachers));
    QVERIFY(driver.settle());
    auto* const rows = driver.find<QAbstractItemView>("classRows");
    QTRY_COMPARE(namesIn(rows), QStringList{"Ada"});
    rows->selectionModel()->select(rows->model()->index(0, 0), QItemSelectionModel::Select | QItemSelectionModel::Rows);
    auto* const remove = driver.find<QPushButton>("classRemove");
    QVERIFY(remove->isEnabled());
    remove->click();
    QTRY_COMPARE(namesIn(rows), QStringList());
    driver.find<DocumentTabs>("tabRow")->current()->document.history()->undo();
    QTRY_COMPARE(namesIn(rows), QStringList{"Ada"});
  }
};

HANDWHEEL_WINDOW_TEST(SubmissionsWindowTest)
#include "SubmissionsWindowTest.moc"
