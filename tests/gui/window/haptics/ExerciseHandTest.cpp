// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "TurningWindow.h"
#include "document/exercise/ExerciseDocument.h"
#include "document/workpiece/exercise/TurningTask.h"
#include "exercise/SubmissionTable.h"

#include <QFile>
#include <QMenu>
#include <QPushButton>
#include <QTabWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kWanted = 38.0, kWithin = 0.5, kSlack = 0.5;  // mm, a diameter
constexpr double kMeasuredFrom = 92.0, kMeasuredTo = 98.0;     // mm, z
constexpr double kTurnedTo = 89.0;                             // mm, z of the nose; it may stop 1 mm before

// A window for an exercise on a bar of ⌀40 × 100 mm, with the simulated hand at the tool.
struct HandAtTheExercise : TurningWindow {
  HandAtTheExercise() : TurningWindow(kSmallWindow) {}

  bool beginWork() {
    driver.choose("beginExercise");
    if (!driver.settle()) return false;
    view->setStandardView(StandardView::Top);
    if (!driver.settle() || !QTest::qWaitFor([this] { return view->isPickingReady(); }, kPatienceMs)) return false;
    driver.find<QAction>("turnTool")->trigger();
    return driver.settle() && rests() && takeHand();
  }
  bool comesTo(double r, double z, double within) {
    const auto isThere = [&] {
      const Vec3 nose = session.latest()->felt.proxy;
      return std::hypot(std::hypot(nose.x(), nose.y()) - r, nose.z() - z) < within;
    };
    return QTest::qWaitFor(isThere, kPatienceMs);
  }
  // One pass along the end of the bar, from beyond it, with the centre of the nose at a radius.
  bool turnEnd(double r) {
    constexpr double kStep = 2.0, kFrom = 103.0, kStill = 20.0;  // mm, mm, mm/s
    const int passes = document().history()->count();
    leadTo({30.0, 0.0, kFrom}, 0);
    if (!comesTo(30.0, kFrom, 1.0) || !pressAt({30.0, 0.0, kFrom})) return false;
    leadTo({r, 0.0, kFrom}, 1);
    const auto isStill = [this] { return session.latest()->tip.velocity.norm() < kStill; };
    if (!comesTo(r, kFrom, 1.0) || !QTest::qWaitFor(isStill, kPatienceMs)) return false;
    for (double z = kFrom - kStep; z >= kTurnedTo; z -= kStep) {
      leadTo({r, 0.0, z}, 1);
      if (!comesTo(r, z, 1.0)) return false;
    }
    leadTo({30.0, 0.0, kTurnedTo}, 1);
    if (!comesTo(30.0, kTurnedTo, 1.0)) return false;
    leadTo({30.0, 0.0, kTurnedTo}, 0);
    return QTest::qWaitFor([&] { return document().history()->count() > passes; }, kPatienceMs) && driver.settle();
  }
  // The diameter in the measured range that is furthest from the one that is wanted.
  double worstDiameter() {
    const TurnedProfile& profile = workpiece().part->profile;
    double worst = kWanted;
    for (std::size_t i = 0; i < profile.size(); ++i) {
      if (profile.z(i) < kMeasuredFrom || profile.z(i) > kMeasuredTo) continue;
      if (std::abs(2.0 * profile.radius(i) - kWanted) > std::abs(worst - kWanted)) worst = 2.0 * profile.radius(i);
    }
    return worst;
  }
  const ExerciseSnapshot& exercise() {
    return static_cast<ExerciseDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document).exercise();
  }
  void show(int tab) { driver.find<QTabBar>("documentTabBar")->setCurrentIndex(tab); }
  bool saveAs(const QString& path) {
    driver.click("quickActions/saveFile");
    return driver.enterFileName("saveDialog", path) && driver.settle() && QFile::exists(path);
  }
};

}  // namespace

// A complete exercise with the simulated hand at the tool: by the teacher, by a student, and up to the marks.
class ExerciseHandTest : public QObject {
  Q_OBJECT

  // A teacher turns the model solution, makes it the target, and saves the exercise and the copy for students.
  void prepare(const QString& scheme, const QString& copy) {
    HandAtTheExercise teacher;
    WindowDriver& driver = teacher.driver;
    driver.choose("newExercise");
    QVERIFY(driver.settle());
    driver.edit("title", "Shoulder");
    driver.find<QTabWidget>("exerciseEditor")->setCurrentIndex(1);
    QMenu* menu = driver.find<QToolButton>("criteria/add")->menu();
    emit menu->aboutToShow();
    menu->actions().first()->trigger();  // a diameter
    for (const auto& [field, value] :
         {std::pair("nominal", kWanted), std::pair("lower", kWanted - kWithin), std::pair("upper", kWanted + kWithin),
          std::pair("at1", kMeasuredFrom), std::pair("at2", kMeasuredTo), std::pair("points", 10.0),
          std::pair("slack", kSlack)})
      driver.edit((QByteArray("criterion.c1.") + field).constData(), QString::number(value));
    QVERIFY(teacher.beginWork() && teacher.turnEnd(0.5 * kWanted + 1.0));  // the nose has 1 mm
    teacher.session.close();
    teacher.show(0);
    QVERIFY(driver.settle());
    driver.choose("takeTarget");
    QTRY_VERIFY_WITH_TIMEOUT(static_cast<const TurningTask&>(*teacher.exercise().task).target, kPatienceMs);
    driver.choose("takeSolution");
    QTRY_VERIFY_WITH_TIMEOUT(teacher.exercise().solution, kPatienceMs);
    QVERIFY(driver.settle() && teacher.saveAs(scheme));
    driver.choose("studentCopy");
    QVERIFY(driver.settle());
    QVERIFY(teacher.exercise().isForStudents && !teacher.exercise().solution);
    QVERIFY(teacher.saveAs(copy));
  }

  // A student opens the copy, turns, measures, and hands in. diameter: what became of it.
  void work(const QString& copy, const QString& handedIn, double& diameter) {
    HandAtTheExercise student;
    WindowDriver& driver = student.driver;
    QVERIFY(driver.open(copy));
    QVERIFY(student.beginWork() && student.turnEnd(0.5 * kWanted + 1.3));
    diameter = student.worstDiameter();
    auto* lesson = driver.find<QWidget>("exerciseLesson");
    lesson->findChild<QPushButton*>("lesson/measure")->click();
    QVERIFY(driver.settle());
    const auto isReported = [lesson](const QString& sign) {
      const auto labels = lesson->findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [&](const QLabel* each) { return each->text().contains(sign); });
    };
    QTRY_VERIFY(isReported(std::abs(diameter - kWanted) <= kWithin ? QStringLiteral("✓") : QStringLiteral("✗")));
    QTest::keyClicks(lesson->findChild<QLineEdit*>("lesson/name"), "Ada");
    lesson->findChild<QPushButton*>("lesson/handIn")->click();
    QVERIFY(driver.enterFileName("handInDialog", handedIn));
    QVERIFY(driver.settle());
    QTRY_VERIFY(QFile::exists(handedIn));
  }

 private slots:
  void init() { QSettings().clear(); }

  void fromTheTeacherToTheMarks() {
    const QTemporaryDir folder;
    const QString scheme = folder.filePath("scheme.handwheel"), copy = folder.filePath("task.handwheel");
    const QString handedIn = folder.filePath("ada.handwheel"), report = folder.filePath("class.html");
    prepare(scheme, copy);
    if (QTest::currentTestFailed()) return;
    double diameter = 0.0;
    work(copy, handedIn, diameter);
    if (QTest::currentTestFailed()) return;

    WindowDriver teacher(kSmallWindow);
    QVERIFY(teacher.open(scheme));
    teacher.choose("markExercise");
    QVERIFY(teacher.enterFileName("markDialog", handedIn));
    QVERIFY(teacher.settle());
    const QAbstractItemModel* rows = teacher.find<QAbstractItemView>("classRows")->model();
    QTRY_COMPARE(rows->rowCount(), 1);
    QCOMPARE(rows->index(0, SubmissionTable::Student).data().toString(), QStringLiteral("Ada"));
    const double beyond = std::max(0.0, std::abs(diameter - kWanted) - kWithin);
    const double expected = 10.0 * std::max(0.0, 1.0 - beyond / kSlack);
    const double marked = rows->index(0, SubmissionTable::FirstCriterion).data().toString().toDouble();
    QVERIFY2(std::abs(marked - expected) < 0.02, qPrintable(QStringLiteral("%1 for %2 mm").arg(marked).arg(diameter)));
    // By hand it is near to what it was led along: 1.3 - 1 mm beside the target.
    QVERIFY2(std::abs(diameter - kWanted - 0.6) < 1.0, qPrintable(QString::number(diameter)));
    teacher.click("classReport");
    QVERIFY(teacher.enterFileName("classFileDialog", report));
    QVERIFY(teacher.settle());
    QTRY_VERIFY(QFile::exists(report));
    QFile file(report);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray html = file.readAll();
    QVERIFY(html.contains("Ada") && html.contains("work0-picture-0") && html.contains("Largest resultant force: "));
  }
};

HANDWHEEL_WINDOW_TEST(ExerciseHandTest)
#include "ExerciseHandTest.moc"
