// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurningExercises.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseRows.h"
#include "document/exercise/RoundTarget.h"
#include "document/workpiece/exercise/DrawingTolerance.h"
#include "document/workpiece/exercise/ExerciseDrawing.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const TargetProfile& targetOf(const TaskPointer& task) {
  return *static_cast<const TurningTask&>(*task).target;
}

// The shoulder's task with another bar, its target moved up.
TurningTask shoulderIn(const StockCylinder& stock, double up) {
  static const ExerciseKind kKind(turningOnly());
  static const auto kShoulder = exerciseFrom(kKind, shoulderDescription());
  TurningTask task = static_cast<const TurningTask&>(*kShoulder->task);
  task.stock = stock;
  task.target = task.target->moved(up);
  return task;
}

MarkingCriterion criterionAt(const std::string& figure, std::vector<double> at, const std::string& tolerance) {
  MarkingCriterion c;
  c.figure = figure;
  c.arguments = std::move(at);
  c.tolerance = tolerance;
  if (!tolerance.empty()) return applyDrawingTolerance(c) ? c : MarkingCriterion();
  return c;
}

bool isNear(double a, double b, double within = 1e-9) {
  return std::abs(a - b) < within;
}

}  // namespace

// The target of a turning exercise: from the teacher's own work, from a file, turned round, rounded, and as a drawing.
class TurningTargetsTest : public QObject {
  Q_OBJECT

 private slots:
  // ⌀30 h10 and the length 40 were marked for the shoulder. Of a target of ⌀28, and of one whose shoulder is at 55 mm
  // instead of 60, they are named; the target they were made for meets all.
  void marksOfAnotherTarget() {
    const auto off = [](double diameter, double shoulder) {
      nlohmann::json description = shoulderDescription();
      const double r = 0.5 * diameter;
      description["task"]["target"] = {{"outer", {{20, 0}, {20, shoulder}, {r, shoulder}, {r, 100}}},
                                       {"inner", nlohmann::json::array()}};
      static const ExerciseKind kKind(turningOnly());
      const auto exercise = exerciseFrom(kKind, description);
      const auto note = offTargetNote(*exercise);
      return note ? note->arguments.front() : std::string();
    };
    QCOMPARE(off(30.0, 60.0), std::string());
    QCOMPARE(off(28.0, 60.0), std::string("“⌀30 h10”"));
    QCOMPARE(off(30.0, 55.0), std::string("“40 ±0.2”"));
    QCOMPARE(off(28.0, 55.0), std::string("“⌀30 h10”, “40 ±0.2”"));
  }

  void init() { m_shoulder = shoulderIn({40.0, 100.0, 0.0}, 0.0); }

  void whatWasTurnedIsTheTarget() {
    TurningTask blank = m_shoulder;
    blank.target.reset();
    const auto bar = m_subject.start(blank);
    QCOMPARE(m_subject.withTarget(blank, *bar).error().code, ExerciseError::NothingTurned);
    const auto work = m_subject.makeWork(blank, shoulderWork(29.9), {});
    const auto made = m_subject.withTarget(blank, **work);
    QVERIFY(made.hasValue());
    QVERIFY(isNear(2.0 * targetOf(*made).extentAt(80.0)->outer, 29.9, 5e-3));
    QVERIFY(isNear(2.0 * targetOf(*made).extentAt(40.0)->outer, 40.0, 5e-3));
    QCOMPARE(m_subject.targetMove(blank, **made), 0.0);  // there was none before
  }

  // The upper 40 mm of ⌀30 are at the chuck then, and the ends have the same positions.
  void endForEnd() {
    const auto turned = m_subject.withTurnedTarget(m_shoulder);
    QVERIFY(turned.hasValue());
    const TargetProfile& target = targetOf(*turned);
    QVERIFY(target.lowerEnd() == m_shoulder.target->lowerEnd() && target.upperEnd() == m_shoulder.target->upperEnd());
    QVERIFY(isNear(target.extentAt(20.0)->outer, 15.0) && isNear(target.extentAt(70.0)->outer, 20.0));
    QCOMPARE(m_subject.endsNote(m_shoulder)->arguments, (std::vector<std::string>{"30", "40"}));
    QCOMPARE(m_subject.endsNote(**turned)->arguments, (std::vector<std::string>{"40", "30"}));
    const TurningTask without;
    QCOMPARE(m_subject.withTurnedTarget(without).error().code, ExerciseError::WithoutTarget);
    QVERIFY(!m_subject.endsNote(without) && m_subject.targetPicture(without).isNull());
    QVERIFY(!m_subject.targetPicture(m_shoulder).isNull());
  }

  void aTargetThatDoesNotFit() {
    QVERIFY(m_subject.fitNotes(m_shoulder).empty() && m_subject.fitNotes(TurningTask()).empty());
    // 0.5 mm are missing of the diameter; then 2 mm at the chuck's end.
    const auto thin = m_subject.fitNotes(shoulderIn({39.5, 100.0, 0.0}, 0.0));
    QCOMPARE(thin.size(), std::size_t{1});
    QCOMPARE(thin.front().arguments, (std::vector<std::string>{"40", "100", "39.5", "100"}));
    QCOMPARE(m_subject.fitNotes(shoulderIn({40.0, 100.0, 2.0}, 0.0)).size(), std::size_t{1});
    QVERIFY(m_subject.fitNotes(shoulderIn({40.0, 100.0, 2.0}, 2.0)).empty());
  }

  // A drawing of the shoulder is read as the target it was written from, with the allowance for facing in another bar.
  void drawingsComeBack() {
    const TurningTask longer = shoulderIn({40.0, 110.0, 0.0}, 0.0);
    for (const FileFormat& format : m_subject.drawingFormats()) {
      const std::filesystem::path path = m_folder.filePath("shoulder").toStdString() + format.endings.front();
      const auto written = m_subject.exportDrawing(Exercise(), m_shoulder, path, {});
      if (format.name == "PDF") {  // PDF is for people, and has text: without a window there are no fonts
        QVERIFY(!written && written.error().code == ErrorCode::LibraryFailed);
        continue;
      }
      QVERIFY(written.hasValue());
      QCOMPARE(written->bytes, std::filesystem::file_size(path));
      for (const auto& [asked, left] : {std::pair(std::optional<double>(), 1.0), {std::optional(3.5), 3.5}}) {
        const auto read = m_subject.withImportedTarget(longer, path, asked, {});
        QVERIFY(read.hasValue());
        QVERIFY(isNear(targetOf(read->task).upperEnd(), 110.0 - left));
        QVERIFY(isNear(targetOf(read->task).lowerEnd(), 10.0 - left));
        QVERIFY(isNear(targetOf(read->task).volume(), M_PI * (400.0 * 60.0 + 225.0 * 40.0), 1e-3));
        QVERIFY(isNear(m_subject.targetMove(longer, *read->task), 10.0 - left));
        QCOMPARE(read->positionGroup, std::string("Target"));
        QCOMPARE(read->lies->arguments.at(0), left == 1.0 ? std::string("1") : std::string("3.5"));
      }
      const auto beyond = m_subject.withImportedTarget(longer, path, 110.5, {});
      QVERIFY(!beyond && beyond.error().code == ErrorCode::ValueOutOfRange && beyond.error().subject == path.string());
    }
    const auto none = m_subject.withImportedTarget(longer, m_folder.filePath("none.dxf").toStdString(), {}, {});
    QCOMPARE(none.error().code, ErrorCode::FileMissing);
  }

  void drawingsThatAreNotWritten() {
    const std::filesystem::path path = m_folder.filePath("other.dxf").toStdString();
    const auto empty = m_subject.exportDrawing(Exercise(), TurningTask(), path, {});
    QVERIFY(!empty && empty.error().code == ExerciseError::WithoutTarget && empty.error().subject == path.string());
    JobState state;
    state.cancelled = true;
    QCOMPARE(m_subject.exportDrawing(Exercise(), m_shoulder, path, Progress(state)).error().code, ErrorCode::Cancelled);
    const std::filesystem::path nowhere = m_folder.filePath("nowhere/other.svg").toStdString();
    QVERIFY(!m_subject.exportDrawing(Exercise(), m_shoulder, nowhere, {}));
    QVERIFY(!std::filesystem::exists(path));
  }

  // 29.93 mm over 39.96 mm are ⌀29.9 and 40 in steps of 0.1.
  void roundSizes() {
    TurningTask task = m_shoulder;
    task.target = *TargetProfile::make({{{20.0, 0.0}, {20.0, 60.04}, 0.0},
                                        {{20.0, 60.04}, {14.965, 60.04}, 0.0},
                                        {{14.965, 60.04}, {14.965, 100.0}, 0.0}});
    OperationValues values(roundTargetOperation());
    const auto rounded = withRoundedTarget(m_subject, task, values);
    QVERIFY(rounded.hasValue());
    QVERIFY(isNear(targetOf(rounded->task).extentAt(80.0)->outer, 14.95));
    QVERIFY(isNear(targetOf(rounded->task).extentAt(60.001)->outer, 14.95));
    QVERIFY(isNear(targetOf(rounded->task).extentAt(59.999)->outer, 20.0));
    QVERIFY(isNear(rounded->largestChange, std::hypot(0.015, 0.04)));  // the inner corner
    QCOMPARE(withRoundedTarget(m_subject, TurningTask(), values).error().code, ExerciseError::WithoutTarget);
    QCOMPARE(m_subject.withRoundedTarget(task, 0.0, 0.0).error().code, ErrorCode::ValueOutOfRange);
  }

  // Tolerances as on a drawing: the teacher's text, else deviations from the nominal size, or equal deviations from the
  // middle.
  void tolerancesOnTheDrawing() {
    Exercise exercise;
    const auto add = [&](std::optional<double> nominal, std::optional<double> lower, std::optional<double> upper) {
      MarkingCriterion c;
      c.figure = "diameter";
      c.arguments = {62.0, 99.0};
      c.nominal = nominal, c.lower = lower, c.upper = upper;
      exercise.criteria.push_back(c);
    };
    add(30.0, 29.8, 30.2);
    add(30.0, 29.8, 30.1);
    add(30.0, {}, 30.1);
    add(30.0, 29.9, {});
    add({}, 29.8, 30.1);
    add({}, {}, 30.1);  // no size can be named
    exercise.criteria.push_back(exercise.criteria.front());
    exercise.criteria.back().isHidden = true;
    const DrawingTitle title = drawingTitleOf(exercise, m_shoulder);
    std::vector<std::string> texts;
    for (const DrawnTolerance& each : title.tolerances) texts.push_back(each.text);
    QCOMPARE(texts, (std::vector<std::string>{"±0.2", "+0.1 -0.2", "+0.1", "-0.1", "±0.15"}));
    QVERIFY(isNear(title.tolerances.back().size, 29.95));
  }

  // Each criterion of a thread asks for it: the drawing has its designation, and the other sizes of it. M30×1.5-6g by
  // ISO 965-1; d2 = 30 - 0.6495 · 1.5 = 29.026.
  void threadsOnTheDrawing_data() {
    QTest::addColumn<QStringList>("figures");
    QTest::addColumn<QString>("tolerance");
    QTest::addColumn<double>("nominal");
    QTest::addColumn<QString>("expected");
    const QString fine = "M30x1.5-6g";
    for (const char* const figure : {"thread_pitch", "major_diameter", "pitch_diameter", "minor_diameter"})
      QTest::newRow(figure) << QStringList{figure} << fine << 0.0 << "M30×1.5 – 6g";
    QTest::newRow("all") << QStringList{"major_diameter", "pitch_diameter", "thread_pitch"} << fine << 0.0
                         << "M30×1.5 – 6g";
    QTest::newRow("pitch without a class") << QStringList{"thread_pitch"} << "" << 1.5 << "M30×1.5";
    QTest::newRow("pitch diameter without a class") << QStringList{"pitch_diameter"} << "" << 29.026 << "M30×1.5";
  }
  void threadsOnTheDrawing() {
    QFETCH(QStringList, figures);
    QFETCH(QString, tolerance);
    QFETCH(double, nominal);
    QFETCH(QString, expected);
    Exercise exercise;
    for (const QString& figure : figures) {
      MarkingCriterion c = criterionAt(figure.toStdString(), {70.0, 95.0}, tolerance.toStdString());
      if (nominal > 0.0) c.nominal = nominal, c.lower = nominal - 0.1, c.upper = nominal + 0.1;
      exercise.criteria.push_back(c);
    }
    const DrawingTitle title = drawingTitleOf(exercise, m_shoulder);
    QCOMPARE(title.threads.size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(title.threads.front().designation), expected);
    const Sheet sheet = dimensionSheet(*m_shoulder.target, title, {});
    const auto isThere = [&](const QString& text) {
      return std::any_of(sheet.texts.begin(), sheet.texts.end(),
                         [&](const Sheet::Text& each) { return QString::fromStdString(each.text) == text; });
    };
    QVERIFY(isThere(expected) && !isThere("Ø30"));
    // Along a small part of the cylinder it stands beside the diameter.
    for (MarkingCriterion& c : exercise.criteria) c.arguments = {90.0, 99.0};
    const Sheet partly = dimensionSheet(*m_shoulder.target, drawingTitleOf(exercise, m_shoulder), {});
    for (const QString& text : {expected, QString("Ø30")})
      QVERIFY(std::any_of(partly.texts.begin(), partly.texts.end(),
                          [&](const Sheet::Text& each) { return QString::fromStdString(each.text) == text; }));
    exercise.criteria.front().isHidden = true;
    QCOMPARE(drawingTitleOf(exercise, m_shoulder).threads.size(), exercise.criteria.size() > 1 ? 1u : 0u);
  }

  // The crest of M30×1.5-6g is 29.732 to 29.968 (ISO 965-1): ⌀30 ±0.2 along it admits 30.1 and contradicts it, beside
  // it or within these limits it does not.
  void limitsAgainstAThread() {
    Exercise exercise;
    exercise.criteria.push_back(criterionAt("pitch_diameter", {70.0, 95.0}, "M30x1.5-6g"));
    const auto contradicts = [&](double low, double high, double from, double to) {
      MarkingCriterion c = criterionAt("diameter", {from, to}, {});
      c.nominal = 30.0, c.lower = low, c.upper = high;
      return !m_subject.conflict(c, exercise).empty();
    };
    QVERIFY(contradicts(29.8, 30.2, 64.0, 98.0));
    QVERIFY(contradicts(29.0, 29.9, 64.0, 98.0));
    QVERIFY(!contradicts(29.75, 29.95, 64.0, 98.0));
    QVERIFY(!contradicts(29.8, 30.2, 62.0, 69.0));
    QVERIFY(m_subject.conflict(exercise.criteria.front(), exercise).empty());
  }

  void figures() {
    std::vector<std::string> ids;
    for (const MeasurementType& type : m_subject.figures()) ids.push_back(type.id);
    for (const char* const id : {"diameter", "length", "bore", "roughness", "force", "crashes"})
      QVERIFY2(std::count(ids.begin(), ids.end(), id) == 1, id);
    std::sort(ids.begin(), ids.end());
    QVERIFY(std::adjacent_find(ids.begin(), ids.end()) == ids.end());
  }

 private:
  QTemporaryDir m_folder;
  TurningSubject m_subject;
  TurningTask m_shoulder;
};

HANDWHEEL_TEST(TurningTargetsTest)
#include "TurningTargetsTest.moc"
