// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/MarkedSubmissions.h"

#include "TestClass.h"
#include "TurningExercises.h"
#include "document/Container.h"
#include "document/exercise/ExerciseJson.h"
#include "document/exercise/StartedWork.h"
#include "document/exercise/Submission.h"
#include "document/workpiece/TurnedPartEdit.h"

#include <QtTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;
using Json = nlohmann::json;

namespace {

const ExerciseKind& kindOfClass() {
  static const ExerciseKind kKind(turningOnly());
  return kKind;
}

ExerciseSnapshot classExercise() {
  return *exerciseFrom(kindOfClass(), shoulderDescription());
}

// Work that was handed in by a student, as it is marked.
ReportedWork markedWork(const char* student, const Json& passes) {
  const ExerciseSnapshot exercise = classExercise();
  Attempt attempt{student, "2026-11-23T08:15:00Z", "2026-11-23T09:15:00Z", 300.0, {1}, {true}};
  const auto submission = handedIn(exercise, workFrom(exercise, passes), attempt);
  if (!submission) qFatal("the work is not handed in");
  ReportedWork work;
  work.row = *markSubmission(exercise, *submission, std::string(student) + ".handwheel");
  work.details = exercise.subject->details(*exercise.task, *submission->work, {});
  work.path = "/class/" + work.row.file;
  work.scheme = schemeMark(exercise);
  return work;
}

ReportedWork unmarkedWork(const char* path) {
  ReportedWork work;
  work.path = path;
  work.row.file = "broken.handwheel";
  work.row.problem = "It is damaged.";
  return work;
}

std::string bytesOf(const ExerciseSnapshot& exercise) {
  Container container;
  kindOfClass().save(exercise, container);
  return container.manifest->dump();
}

std::shared_ptr<const ExerciseSnapshot> readBack(const std::string& manifest, std::vector<Error>& damage) {
  Container container;
  *container.manifest = Json::parse(manifest);
  const auto loaded = kindOfClass().load(container, damage, {});
  return loaded ? std::static_pointer_cast<const ExerciseSnapshot>(*loaded) : nullptr;
}

}  // namespace

// The class of an exercise: it is added to, it is in the teacher's file, and nowhere else.
class MarkedSubmissionsTest : public QObject {
  Q_OBJECT

 private slots:
  // Late submissions are added to the others; the same file submitted again replaces the first.
  void moreWorksAreAdded() {
    MarkedSubmissions all =
        withMarked({}, {markedWork("Ada", shoulderWork()), unmarkedWork("/class/broken.handwheel")});
    QCOMPARE(all.size(), std::size_t{2});
    all = withMarked(all, {markedWork("Bob", shoulderWork(29.9))});
    QCOMPARE(all.size(), std::size_t{3});
    QCOMPARE(all[0]->row.marking.points, 25.0);
    all = withMarked(all, {markedWork("Ada", shoulderWork(29.9))});
    QCOMPARE(all.size(), std::size_t{3});
    QCOMPARE(all[0]->row.attempt.student, std::string("Ada"));
    QVERIFY(all[0]->row.marking.points < 25.0);  // ⌀29.9 is 0.016 mm below the limit
    QCOMPARE(all[1]->row.problem, std::string("It is damaged."));
  }

  // A student's copy keeps the rules of its day. The scheme's rules are told by themselves; other sizes, stock, tools
  // or limits are another version.
  void otherVersions() {
    const ExerciseSnapshot before = classExercise();
    const auto submission = handedIn(before, workFrom(before, shoulderWork()), Attempt());
    const auto remarkAfter = [&](const char* property, const PropertyValue& value) {
      ExerciseSnapshot scheme = before;
      const auto task = before.subject->withProperty(*before.task, property, value);
      if (!task) return std::string("no such property");
      scheme.task = *task;
      const SubmissionRow row = *markSubmission(scheme, *submission, "a.handwheel");
      return row.remarks.empty() ? std::string() : row.remarks.front();
    };
    QCOMPARE(remarkAfter("commands", true), std::string());
    QCOMPARE(remarkAfter("power_limit", 9.5),
             std::string("It was done by another version of the exercise: its machine, its tools or its material are "
                         "not these."));
    ExerciseSnapshot scheme = before;
    scheme.exercise.criteria.front().upper = 99.0;
    QCOMPARE(markSubmission(scheme, *submission, "a.handwheel")->remarks.front(),
             std::string("It was done by another version of the exercise: its sizes or its stock are not these."));
  }

  // An arc of another bulge through the same points is another pass.
  void arcsAreInTheFingerprint() {
    TurningPass pass;
    pass.noseRadius = 0.8;
    pass.isExact = true;
    pass.path = {{18.8, 100.0}, {18.8, 80.0}};
    pass.times = {0.0, 10.0};
    const auto fingerprint = [&] {
      WorkpieceSnapshot work =
          static_cast<const WorkpieceSnapshot&>(*classExercise().subject->start(*classExercise().task));
      work.part = withPass(work, pass, 0.05);
      return classExercise().subject->details(*classExercise().task, work, {}).pieces.front().fingerprint;
    };
    const auto straight = fingerprint();
    pass.arcs = {{0, 1, 0.01}};
    const auto arc = fingerprint();
    pass.arcs.front().bulge = 0.02;
    QVERIFY(straight != arc && arc != fingerprint());
  }

  // Saved and opened again: names, files, marks with their reasons, what was moved.
  void theClassIsInTheFile() {
    ExerciseSnapshot exercise = classExercise();
    ReportedWork ada = markedWork("Ada", shoulderWork());
    ada.row.tries = 2;
    ada.details.events = {{std::nullopt, {"Try %1 was taken back.", {"1"}}}, {3.5, {"Contact.", {}}}};
    exercise.marked = std::make_shared<const MarkedSubmissions>(
        withMarked({}, {std::move(ada), unmarkedWork("/class/caf\xe9/broken.handwheel")}));
    std::vector<Error> damage;
    const auto read = readBack(bytesOf(exercise), damage);
    QVERIFY(read && read->marked && damage.empty());
    QCOMPARE(read->marked->size(), std::size_t{2});
    const ReportedWork &before = *(*exercise.marked)[0], &after = *(*read->marked)[0];
    QVERIFY(after.isKept);
    QCOMPARE(after.path, before.path);
    QCOMPARE(after.row.file, std::string("Ada.handwheel"));
    QVERIFY(after.row.attempt == before.row.attempt);
    QVERIFY(after.row.origin == before.row.origin && after.scheme == before.scheme);
    QVERIFY(after.row.tries == std::optional<std::size_t>(2) && !(*read->marked)[1]->row.tries);
    QCOMPARE(after.row.marking.points, 25.0);
    QCOMPARE(after.row.marking.marks.size(), before.row.marking.marks.size());
    for (std::size_t i = 0; i < before.row.marking.marks.size(); ++i) {
      const Mark &was = before.row.marking.marks[i], &is = after.row.marking.marks[i];
      QVERIFY(is.criterion == was.criterion && is.verdict == was.verdict && is.value == was.value);
      QVERIFY(is.points == was.points && is.of == was.of && is.reason == was.reason && is.remark == was.remark);
    }
    QCOMPARE(after.details.events.size(), std::size_t{2});
    QVERIFY(!after.details.events[0].seconds && after.details.events[1].seconds == std::optional(3.5));
    for (std::size_t i = 0; i < 2; ++i) QVERIFY(after.details.events[i].text == before.details.events[i].text);
    QCOMPARE(after.details.pieces.size(), std::size_t{4});  // three passes to rough, one to finish
    for (std::size_t i = 0; i < 4; ++i) {
      QCOMPARE(after.details.pieces[i].fingerprint, before.details.pieces[i].fingerprint);
      QCOMPARE(after.details.pieces[i].seconds, before.details.pieces[i].seconds);
    }
    QCOMPARE((*read->marked)[1]->path, std::string("/class/caf\xe9/broken.handwheel"));
    QCOMPARE((*read->marked)[1]->row.problem, std::string("It is damaged."));
    QCOMPARE(bytesOf(*read), bytesOf(*readBack(bytesOf(*read), damage)));
    // Before the first work was marked the file is as it ever was.
    QVERIFY(!Json::parse(bytesOf(classExercise()))["document"].contains("class"));
  }

  // Neither a copy for students, nor their initial work or submission, nor a description contains any of it.
  void studentsDoNotGetIt() {
    ExerciseSnapshot exercise = classExercise();
    exercise.marked = std::make_shared<const MarkedSubmissions>(withMarked({}, {markedWork("Grace", shoulderWork())}));
    QVERIFY(bytesOf(exercise).find("Grace") != std::string::npos);
    const auto isIn = [](const std::string& text) { return text.find("Grace") != std::string::npos; };
    const ExerciseSnapshot copy = forStudents(exercise);
    QVERIFY(!copy.marked && !isIn(bytesOf(copy)));
    QVERIFY(!isIn(assignmentOf(exercise, {}).description->dump()));
    const auto submission = handedIn(exercise, workFrom(exercise, shoulderWork()), {"Bob", {}, {}, 1.0, {}, {}});
    QVERIFY(submission && !submission->marked && !isIn(bytesOf(*submission)));
    QVERIFY(!isIn(ExerciseKind::description(exercise).dump()));
    // Nor does a file that calls itself a student's.
    Json forged = Json::parse(bytesOf(exercise));
    forged["document"]["for_students"] = true;
    std::vector<Error> damage;
    const auto read = readBack(forged.dump(), damage);
    QVERIFY(read && !read->marked && !isIn(bytesOf(*read)));
  }

  // An error in the file costs only the data concerned, and is reported.
  void damagedClasses() {
    ExerciseSnapshot exercise = classExercise();
    exercise.marked = std::make_shared<const MarkedSubmissions>(withMarked({}, {markedWork("Ada", shoulderWork())}));
    const Json whole = Json::parse(bytesOf(exercise));
    const auto worksIn = [&](const Json& given, std::size_t& reported) {
      Json changed = whole;
      changed["document"]["class"] = given;
      std::vector<Error> damage;
      const auto read = readBack(changed.dump(), damage);
      reported = damage.size();
      return read && read->marked ? read->marked->size() : std::size_t{0};
    };
    std::size_t reported = 0;
    QCOMPARE(worksIn(7, reported), std::size_t{0});
    QCOMPARE(reported, std::size_t{1});
    QCOMPARE(worksIn(Json::array({1, Json::object()}), reported), std::size_t{1});
    QVERIFY(reported >= 1);
    Json odd = whole["document"]["class"];
    for (const char* key : {"marks", "events", "figures", "pieces", "remarks"}) odd[0][key] = Json::array({1, "x"});
    odd[0]["points"] = "many";
    QCOMPARE(worksIn(odd, reported), std::size_t{1});
    QCOMPARE(worksIn(Json::array(), reported), std::size_t{0});
    QCOMPARE(reported, std::size_t{0});
  }

  // Other limits, points or positions may give other marks; names do not.
  void whatTellsSchemesApart() {
    Exercise exercise = classExercise().exercise;
    const std::uint64_t before = schemeMark(exercise);
    exercise.criteria[0].name = "another";
    exercise.title = "another";
    QCOMPARE(schemeMark(exercise), before);
    exercise.criteria[0].points += 1.0;
    QVERIFY(schemeMark(exercise) != before);
    exercise.criteria[0].points -= 1.0;
    QCOMPARE(schemeMark(exercise), before);
    exercise.criteria[0].arguments[0] += 0.5;
    QVERIFY(schemeMark(exercise) != before);
    // Another machine or target may, too.
    ExerciseSnapshot other = classExercise();
    const std::uint64_t whole = schemeMark(other);
    other.exercise.title = "another";
    QCOMPARE(schemeMark(other), whole);
    const auto task = other.subject->withProperty(*other.task, "largest_feed", 0.5);
    QVERIFY(task.hasValue());
    other.task = *task;
    QVERIFY(schemeMark(other) != whole);
  }
};

HANDWHEEL_TEST(MarkedSubmissionsTest)
#include "MarkedSubmissionsTest.moc"
