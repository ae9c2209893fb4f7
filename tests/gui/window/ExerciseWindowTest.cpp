// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowDriver.h"
#include "WindowTestMain.h"

#include <QDockWidget>
#include <QFile>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A widget of a lesson, of which there are two: the page of a student's file, and the panel while the work is done.
template <class Widget>
Widget* partOfLesson(WindowDriver& driver, const char* lesson, const char* name) {
  auto* widget = driver.find<QWidget>(lesson)->findChild<Widget*>(QString::fromLatin1(name));
  if (!widget) qFatal("there is no %s", name);
  return widget;
}

QString labelsOf(QWidget* widget) {
  QString text;
  for (const QLabel* label : widget->findChildren<QLabel*>()) text += label->text() + QLatin1Char('\n');
  return text;
}

}  // namespace

// The ways of a student and of a teacher through the window.
class ExerciseWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void aLessonOpensItsBar() {
    WindowDriver driver;
    driver.click("lessonTile");
    QVERIFY(driver.settle());
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Exercise"));
    QVERIFY(!driver.find<QDockWidget>("lessonDock")->isVisible());
    QTest::mouseClick(partOfLesson<QPushButton>(driver, "exercisePage", "lesson/begin"), Qt::LeftButton);
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
    auto* lesson = driver.find<QWidget>("exerciseLesson");
    QTRY_VERIFY(lesson->isVisible());
    QVERIFY(driver.text("figures").contains(QStringLiteral("40")));

    // A step that the person does, with its hint; the next one is current then.
    auto* steps = partOfLesson<QListWidget>(driver, "exerciseLesson", "lessonSteps");
    QCOMPARE(steps->count(), 5);
    steps->setCurrentRow(1);
    auto* hint = partOfLesson<QPushButton>(driver, "exerciseLesson", "lessonAskHint");
    QTRY_VERIFY(hint->isVisible());
    hint->click();
    QTRY_VERIFY(labelsOf(lesson).contains("Begin beyond its end"));

    // The bar is too thick yet.
    partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/measure")->click();
    QVERIFY(driver.settle());
    QTRY_VERIFY(labelsOf(lesson).contains(QStringLiteral("✗")));
    QVERIFY2(labelsOf(lesson).contains("above the upper limit"), qPrintable(labelsOf(lesson)));

    QVERIFY(!partOfLesson<QPushButton>(driver, "exerciseLesson", "lesson/handIn")->isEnabled());
  }

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
    handIn->click();
    const QString path = folder.filePath("ada.handwheel");
    QVERIFY(driver.enterFileName("saveDialog", path));
    QVERIFY(driver.settle());
    QVERIFY(QFile::exists(path));
    QCOMPARE(driver.tabs(), 3);

    driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);
    QVERIFY(driver.settle());
    driver.choose("markExercise");
    QVERIFY(driver.enterFileName("markDialog", path));
    QVERIFY(driver.settle());
    auto* rows = driver.find<QTreeView>("classRows");
    QTRY_COMPARE(rows->model()->rowCount(), 1);
    QCOMPARE(rows->model()->index(0, 0).data().toString(), QStringLiteral("Ada"));
    QVERIFY(rows->isVisible());
    driver.click("classReport");
    const QString report = folder.filePath("class.html");
    QVERIFY(driver.enterFileName("classFileDialog", report));
    QTRY_VERIFY(QFile::exists(report));
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
    // What students see is another document, without an editor.
    driver.choose("studentCopy");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
    QVERIFY(driver.find<QWidget>("exercisePage")->isVisible());
    QVERIFY(!editor->isVisible());
  }
};

HANDWHEEL_WINDOW_TEST(ExerciseWindowTest)
#include "ExerciseWindowTest.moc"
