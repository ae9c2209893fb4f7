// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/StartedWork.h"

#include "TestClass.h"
#include "TurningExercises.h"
#include "document/exercise/Submission.h"
#include "document/workpiece/ProgramTrial.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceErrors.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/exercise/AssignedTask.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const ExerciseKind& kindOfStartedWork() {
  static const ExerciseKind kKind(turningOnly());
  return kKind;
}

const DocumentKinds& workpiecesOnly() {
  static const DocumentKinds kKinds([] {
    std::vector<std::unique_ptr<DocumentKind>> kinds;
    kinds.push_back(std::make_unique<WorkpieceKind>());
    return kinds;
  }());
  return kKinds;
}

const Attempt kHalfDone{"Ada", "2026-01-01T08:00:00Z", {}, 95.5, {1, 0}, {true, false}};

OpenedFile startedWork() {
  const auto exercise = exerciseFrom(kindOfStartedWork(), shoulderDescription());
  OpenedFile opened = DocumentKinds::blank(*workpiecesOnly().withId("workpiece"));
  opened.content = exercise->subject->start(*exercise->task);
  opened.file.assigned = assignmentOf(*exercise, kHalfDone);
  return opened;
}

// Continues the work by a program that turns 20 mm of it to this diameter.
WorkpieceSnapshot goneOnByProgram(const Snapshot& work, double diameter) {
  WorkpieceSnapshot made = static_cast<const WorkpieceSnapshot&>(work);
  const std::string text =
      "G7 G21 G97 S600 M3\nG0 X" + std::to_string(diameter) + " Z2\nG1 Z-20 F120\nG0 X44\nG0 Z2\nM2\n";
  const ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, made.stock, 25.0, 0.0);
  const auto trial = ProgramTrial::run(made, text, setup, 0.05);
  if (!trial || !trial.value()->part()) qFatal("the program does not touch the part");
  made.part = trial.value()->part();
  return made;
}

}  // namespace

// The document of the work keeps exercise and attempt: in its file, and whatever is undone.
class StartedWorkTest : public QObject {
  Q_OBJECT

 private slots:
  // The bar is that of the exercise while it is worked on; how finely it is shown is not.
  void theBarStays() {
    OpenedFile opened = startedWork();
    const auto made = opened.kind->make(opened);
    auto& work = static_cast<WorkpieceDocument&>(*made);
    for (const char* id : {"diameter", "length", "position", "material"}) {
      QVERIFY2(!work.property(id)->editable, id);
      const Status refused =
          id == std::string("material") ? work.setProperty(id, std::string("brass")) : work.setProperty(id, 33.0);
      QVERIFY2(!refused && refused.error().code == WorkpieceError::BarOfExercise, id);
    }
    QVERIFY(work.property("chord")->editable && work.setProperty("chord", 0.05));
    opened.file.assigned = {};
    const auto free = opened.kind->make(opened);
    QVERIFY(free->property("diameter")->editable && free->setProperty("diameter", 33.0));
  }

  void comesBackFromItsFile() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("work.handwheel").toStdString();
    const OpenedFile begun = startedWork();
    QVERIFY(saveDocument(*begun.kind, begun.file, *begun.content, path).hasValue());
    const Result<OpenedFile> opened = workpiecesOnly().open(path, {});
    QVERIFY(opened && opened->file.damage.empty() && opened->file.assigned);
    QVERIFY(isSameExercise(opened->file.assigned, begun.file.assigned));
    const auto exercise = exerciseOf(kindOfStartedWork(), opened->file.assigned);
    QVERIFY(exercise && (*exercise)->attempt == kHalfDone && (*exercise)->exercise.title == "Shoulder");
    QVERIFY((*exercise)->subject->checkWork(*(*exercise)->task, *opened->content));
    // Saved once more, it has them still.
    QVERIFY(saveDocument(*opened->kind, opened->file, *opened->content, path).hasValue());
    QVERIFY(isSameExercise(workpiecesOnly().open(path, {})->file.assigned, begun.file.assigned));
  }

  void hasNoAnswers() {
    const auto exercise = exerciseOf(kindOfStartedWork(), startedWork().file.assigned);
    QVERIFY(exercise && (*exercise)->isForStudents && handwheel::hasNoAnswers((*exercise)->exercise));
    QVERIFY(!(*exercise)->exercise.find("force"));  // hidden
    QCOMPARE((*exercise)->key, exerciseFrom(kindOfStartedWork(), shoulderDescription())->key);
  }

  // Work begun from memory equals work begun from the file: the student's copy, with the attempt.
  void begunAsItIsReadBack() {
    const auto exercise = exerciseFrom(kindOfStartedWork(), shoulderDescription());
    const AssignedExercise assigned = assignmentOf(*exercise, kHalfDone, "1");
    const auto begun = begunCopy(*exercise, assigned);
    const auto read = exerciseOf(kindOfStartedWork(), assigned);
    QVERIFY(read && begun->task == exercise->task && (*read)->task != exercise->task);
    QVERIFY(ExerciseKind::description(*begun) == ExerciseKind::description(**read));
    QVERIFY(begun->key == (*read)->key && begun->subject == (*read)->subject);
    QVERIFY(begun->attempt == kHalfDone && begun->attempt == (*read)->attempt);
    QVERIFY(begun->isForStudents && handwheel::hasNoAnswers(begun->exercise));
    QVERIFY(!begun->solution && !begun->work && !begun->marked);
  }

  // A warning about marks may name those that the student knows.
  void knowsWhatIsMarked() {
    const AssignedExercise assigned = startedWork().file.assigned;
    QVERIFY(isMarked(assigned, "diameter"));
    QVERIFY(!isMarked(assigned, "force"));  // hidden
    QVERIFY(!isMarked(assigned, "power"));
    QVERIFY(!isMarked({}, "diameter"));
  }

  // The exercise and the copy of it that is tried are two documents, and so are the works.
  void knowsWhatItWasBegunFrom() {
    const auto exercise = exerciseFrom(kindOfStartedWork(), shoulderDescription());
    const AssignedExercise work = assignmentOf(*exercise, kHalfDone, "1");
    DocumentFile one, other, description;
    one.id = "1";
    other.id = "2";
    description.id = "3";
    description.path = "/shoulder.exercise.json";
    QVERIFY(isBegunFrom(work, one) && !isBegunFrom(work, other));
    QVERIFY(isBegunFrom(work, description));  // read once more, it has another id
    description.isContainer = true;
    QVERIFY(!isBegunFrom(work, description));
    // Later time and hints, and an older file.
    Attempt later = kHalfDone;
    later.seconds += 60.0;
    QVERIFY(!isBegunFrom(withAttempt(work, later), other) && isBegunFrom(withAttempt(work, later), one));
    QVERIFY(isBegunFrom(assignmentOf(*exercise, kHalfDone), other));
    QVERIFY(!isBegunFrom({}, one));
  }

  // The recording tells what moved the tool, also when read from its file.
  void byHandAndByProgram() {
    const auto exercise = exerciseFrom(kindOfStartedWork(), shoulderDescription());
    const ExerciseSubject& subject = *exercise->subject;
    const SnapshotPointer bar = subject.start(*exercise->task);
    const SnapshotPointer byHand = workFrom(*exercise, shoulderWork());
    const WorkpieceSnapshot byProgram = goneOnByProgram(*bar, 30.0), byBoth = goneOnByProgram(*byHand, 28.0);
    QVERIFY(subject.originOf(*bar) == WorkOrigin::Unknown);
    QVERIFY(subject.originOf(*byHand) == WorkOrigin::Hand);
    QVERIFY(subject.originOf(byProgram) == WorkOrigin::Program);
    QVERIFY(subject.originOf(byBoth) == WorkOrigin::Both);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("both.handwheel").toStdString();
    const OpenedFile begun = startedWork();
    QVERIFY(saveDocument(*begun.kind, begun.file, byBoth, path).hasValue());
    const Result<OpenedFile> opened = workpiecesOnly().open(path, {});
    QVERIFY(opened && subject.originOf(*opened->content) == WorkOrigin::Both);
  }

  // A thread by the command is no work by hand: the file keeps it, the marks say it, unless the exercise allows it.
  void madeByACommand() {
    const auto exercise = exerciseFrom(kindOfStartedWork(), shoulderDescription());
    const ExerciseSubject& subject = *exercise->subject;
    TurningPass pass;
    pass.path = {{12.0, 90.0}, {12.0, 70.0}};
    pass.times = {0.0, 1.0};
    pass.isOfCommand = true;
    const auto threaded = [&](const SnapshotPointer& before) {
      auto work = std::make_shared<WorkpieceSnapshot>(static_cast<const WorkpieceSnapshot&>(*before));
      work->part = withPass(*work, pass, 0.05);
      return work;
    };
    const auto byCommand = threaded(subject.start(*exercise->task));
    const auto afterHand = threaded(workFrom(*exercise, shoulderWork()));
    QVERIFY(subject.originOf(*byCommand) == WorkOrigin::Command);
    QVERIFY(subject.originOf(*afterHand) == WorkOrigin::HandAndCommand);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("thread.handwheel").toStdString();
    const OpenedFile begun = startedWork();
    QVERIFY(saveDocument(*begun.kind, begun.file, *afterHand, path).hasValue());
    const Result<OpenedFile> opened = workpiecesOnly().open(path, {});
    QVERIFY(opened && subject.originOf(*opened->content) == WorkOrigin::HandAndCommand);

    const auto remarkOn = [&](const ExerciseSnapshot& scheme) {
      const auto submission = handedIn(scheme, afterHand, kHalfDone);
      const auto row = markSubmission(scheme, *submission, "x");
      return row && !row->remarks.empty() ? row->remarks.front() : std::string();
    };
    QCOMPARE(remarkOn(*exercise), std::string("Part of it was made by a command, which this exercise does not allow."));
    QVERIFY(!subject.areCommandsAllowed(*exercise->task) && !subject.toJson(*exercise->task).contains("commands"));
    const auto changed = subject.withProperty(*exercise->task, "commands", true);
    QVERIFY(changed && subject.areCommandsAllowed(**changed) && subject.toJson(**changed)["commands"] == true);
    nlohmann::json description = shoulderDescription();
    description["task"]["commands"] = true;
    const auto open = exerciseFrom(kindOfStartedWork(), description);
    QVERIFY(open->subject->areCommandsAllowed(*open->task) && remarkOn(*open).empty());
    QCOMPARE(subject.conditions(*open->task).size(), subject.conditions(*exercise->task).size() + 1);
  }

  // The marks say it of work that an exercise wants to be done by hand.
  void programsThatAreNotAllowed() {
    const auto open = exerciseFrom(kindOfStartedWork(), shoulderDescription());
    QVERIFY(open->subject->areProgramsAllowed(*open->task) && !open->subject->toJson(*open->task).contains("programs"));
    nlohmann::json description = shoulderDescription();
    description["task"]["programs"] = false;
    const auto closed = exerciseFrom(kindOfStartedWork(), description);
    QVERIFY(!closed->subject->areProgramsAllowed(*closed->task));
    QVERIFY(closed->subject->toJson(*closed->task)["programs"] == false);
    QCOMPARE(closed->subject->conditions(*closed->task).size(), open->subject->conditions(*open->task).size() + 1);
    const auto remarksOn = [](const ExerciseSnapshot& scheme, SnapshotPointer work) {
      const auto submission = handedIn(scheme, std::move(work), kHalfDone);
      const auto row =
          submission ? markSubmission(scheme, *submission, "x") : Result<SubmissionRow>(submission.error());
      return row ? row->remarks.size() : std::size_t{99};
    };
    const auto byProgram =
        std::make_shared<const WorkpieceSnapshot>(goneOnByProgram(*closed->subject->start(*closed->task), 30.0));
    QCOMPARE(remarksOn(*closed, byProgram), std::size_t(1));
    QCOMPARE(remarksOn(*open, byProgram), std::size_t(0));
    QCOMPARE(remarksOn(*closed, workFrom(*closed, shoulderWork())), std::size_t(0));
    // A setting of the teacher; the default value in a file is not an unknown key.
    const auto changed = closed->subject->withProperty(*closed->task, "programs", true);
    QVERIFY(changed && closed->subject->areProgramsAllowed(**changed));
    QVERIFY(!closed->subject->withProperty(*closed->task, "programs", 1.0));
    description["task"]["programs"] = true;
    QVERIFY(open->subject->unknownKeys(description["task"], *open->task).empty());
    std::vector<Error> damage;
    description["task"]["programs"] = "no";
    const TaskPointer read = open->subject->fromJson(description["task"], damage);
    QVERIFY(open->subject->areProgramsAllowed(*read) && damage.size() == 1);
  }

  // Time and hints do not come back with an undo, and are worth saving.
  void anUndoKeepsTheAttempt() {
    WorkpieceDocument document(startedWork());
    QVERIFY(document.setProperty("chord", 0.05));
    Attempt later = kHalfDone;
    later.hints = {2, 1};
    document.assign(withAttempt(document.file().assigned, later), true);
    document.history()->undo();
    QCOMPARE(exerciseOf(kindOfStartedWork(), document.file().assigned).value()->attempt->hints, later.hints);
    QVERIFY(document.history()->isClean() && document.isModified());
    document.markSaved(QStringLiteral("/work.handwheel"), true);
    QVERIFY(!document.isModified());
    const std::uint64_t revision = document.revision();
    later.seconds += 0.5;
    document.assign(withAttempt(document.file().assigned, later), false);
    QVERIFY(!document.isModified() && document.revision() == revision);
    QCOMPARE(exerciseOf(kindOfStartedWork(), document.file().assigned).value()->attempt->seconds, 96.0);
  }

  void anyFile() {
    const OpenedFile begun = startedWork();
    const auto with = [&](nlohmann::json description, nlohmann::json attempt) {
      AssignedExercise assigned{std::make_shared<const nlohmann::json>(std::move(description)),
                                std::make_shared<const nlohmann::json>(std::move(attempt))};
      return exerciseOf(kindOfStartedWork(), assigned).hasValue();
    };
    QVERIFY(with(*begun.file.assigned.description, nlohmann::json::object()));
    QVERIFY(with(*begun.file.assigned.description, {{"seconds", -3}, {"hints", "x"}}));
    QVERIFY(!with({{"subject", "knitting"}}, nlohmann::json::object()));
    QVERIFY(!with(nlohmann::json::array(), nlohmann::json::object()));
    QVERIFY(!isSameExercise({}, {}) && !isSameExercise(begun.file.assigned, {}));
  }
};

HANDWHEEL_TEST(StartedWorkTest)
#include "StartedWorkTest.moc"
