// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/Property.h"
#include "exercise/Marking.h"
#include "exercise/WorkOrigin.h"

#include <QImage>

namespace handwheel {

// A figure that a kind of work can measure of a student's result.
struct MeasurementType {
  std::string id;                           // "diameter"; in files
  std::string label;                        // English, context "Figure": "Diameter"
  std::string unit;                         // "mm"; empty for a count
  std::vector<std::string> arguments = {};  // lengths; English, context "Property": "From Z"
};

// The figures that every exercise has, whatever the work is: time and hints.
std::span<const MeasurementType> commonMeasurements();

// What a kind of work prepares for an exercise: stock, machine, target. Immutable; each kind derives its own.
class ExerciseTask {
 public:
  virtual ~ExerciseTask() = default;
};
using TaskPointer = std::shared_ptr<const ExerciseTask>;

// A curve of a report: how the work was done.
struct ReportCurve {
  struct Series {
    std::string name;  // English, context "Figure"
    std::vector<std::pair<double, double>> points;
  };
  std::string title;               // English, context "Figure"
  std::string x, xUnit, y, yUnit;  // of the axes
  std::vector<Series> series;
};

// A remarkable moment of the work: a collision, for example.
struct ReportEvent {
  std::optional<double> seconds;  // none: before the work that is there
  ExerciseText text;
};

// What the work looks like in the end.
struct ReportPicture {
  QImage image;
  ExerciseText caption;
};

// A figure that is reported whether or not a mark is given for it.
struct ReportMeasurement {
  std::string figure;  // id of its type: "force"
  double value = 0.0;
};

// A piece of a recording, as a pass: nobody who moves by hand makes the same one twice.
struct RecordedPiece {
  std::uint64_t fingerprint = 0;  // of the movement and its times (base/Fingerprint.h)
  double seconds = 0.0;
  bool isByHand = true;  // else a program has made it, as it makes it for everybody
};

// What a report shows of a student's work besides the marks.
struct ReportDetails {
  std::vector<ReportPicture> pictures;
  std::vector<ReportMeasurement> figures;
  std::vector<ReportCurve> curves;
  std::vector<ReportEvent> events;
  std::vector<RecordedPiece> pieces;  // of the recorded work, in order
  double seconds = 0.0;               // that it took
};

// What a kind of document brings to exercises: what is prepared and what is measured. Turning and drilling are two;
// assembly would be another. No state; any thread.
class ExerciseSubject {
 public:
  virtual ~ExerciseSubject() = default;

  virtual std::string id() const = 0;            // in files: "turning"
  virtual std::string title() const = 0;         // English, context "Figure": "Turning"
  virtual const DocumentKind& kind() const = 0;  // of the documents that students work in
  virtual std::vector<MeasurementType> figures() const = 0;

  // Sets the limits of a criterion to those that its tolerance on the drawing stands for. Error ElementMalformed
  // {criterion, what is wrong}: the tolerance is not known for this figure and nominal value.
  virtual Status applyTolerance(MarkingCriterion& criterion) const = 0;

  // Z of the zero of the drawing and of programs, mm, where places count from another one; none: there is no drawing.
  virtual std::optional<double> drawingZero(const ExerciseTask& task) const {
    (void)task;
    return std::nullopt;
  }

  // How far the target has moved along Z from one task to another that differs by a property, mm: what is measured on
  // it moves with it.
  virtual double targetMove(const ExerciseTask& from, const ExerciseTask& to) const {
    (void)from, (void)to;
    return 0.0;
  }

  // The sizes of the target as criteria, for teachers who need not enter each. Their ids are empty.
  virtual std::vector<MarkingCriterion> targetSizes(const ExerciseTask& task) const {
    (void)task;
    return {};
  }

  // The limit above which a figure is wrong as long as the teacher sets no other; none: it has none.
  virtual std::optional<double> usualLimit(const std::string& figure, const ExerciseTask& task) const = 0;

  // Why a criterion cannot be measured at its arguments, whatever the work is: English, context "Property". Empty: it
  // can, as far as one can know.
  virtual std::string placeProblem(const MarkingCriterion& criterion, const ExerciseTask& task) const = 0;

  virtual TaskPointer blankTask() const = 0;
  virtual nlohmann::json toJson(const ExerciseTask& task) const = 0;
  // Accepts any JSON; what it cannot take is added to the damage and replaced by that of the blank task.
  virtual TaskPointer fromJson(const nlohmann::json& json, std::vector<Error>& damage) const = 0;
  // The keys of a task that fromJson() does not know: an object, empty where there are none.
  virtual nlohmann::json unknownKeys(const nlohmann::json& json, const ExerciseTask& task) const = 0;
  // The properties of a task that teachers change. Errors of a change: as Document::propertyEdit().
  virtual std::vector<Property> properties(const ExerciseTask& task) const = 0;
  virtual Result<TaskPointer> withProperty(const ExerciseTask& task, const std::string& id,
                                           const PropertyValue& value) const = 0;

  // What the student has to know of stock, machine and tools: a line each, in the context "Note".
  virtual std::vector<ExerciseText> conditions(const ExerciseTask& task) const = 0;
  // What a student begins with.
  virtual SnapshotPointer start(const ExerciseTask& task) const = 0;
  // Whether the work turns about z in a lathe: so it is looked at.
  virtual bool isTurned() const { return false; }
  // Whether start() takes longer than a person waits for a click.
  virtual bool startsSlowly() const { return false; }
  // Whether a document can be work on this task: of the same stock. Error: ExerciseError::OtherWork {reason}.
  virtual Status checkWork(const ExerciseTask& task, const Snapshot& work) const = 0;
  // How the work was made.
  virtual WorkOrigin originOf(const Snapshot& work) const {
    (void)work;
    return WorkOrigin::Unknown;
  }
  // How many tries the work took; none: they are not counted.
  virtual std::optional<std::size_t> triesOf(const Snapshot& work) const {
    (void)work;
    return std::nullopt;
  }
  // Whether students may make it by program.
  virtual bool areProgramsAllowed(const ExerciseTask& task) const {
    (void)task;
    return true;
  }
  // Work as a description in JSON tells it, for model solutions. Errors: ElementMalformed, Cancelled.
  virtual Result<SnapshotPointer> makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                           Progress progress) const = 0;
  // The description that makeWork() makes this work from; null: none can hold it, as work that was done by hand.
  virtual nlohmann::json describeWork(const ExerciseTask& task, const Snapshot& work) const = 0;
  // A task whose target is what this work made, for teachers who turn the model solution first. Errors:
  // ExerciseError::NothingTurned, ElementMalformed.
  virtual Result<TaskPointer> withTarget(const ExerciseTask& task, const Snapshot& work) const = 0;
  // What is wrong with the place of a task's target in the stock, for who changes either; empty: nothing.
  virtual std::vector<Note> placeNotes(const ExerciseTask& task) const {
    (void)task;
    return {};
  }
  // Which end of the target is the free one of the stock, in words; none: it has no ends, or there is no target.
  virtual std::optional<Note> endsNote(const ExerciseTask& task) const {
    (void)task;
    return std::nullopt;
  }
  // The target in the stock; null: there is none, or it would take long.
  virtual QImage placePicture(const ExerciseTask& task) const {
    (void)task;
    return {};
  }
  // A task whose target lies the other way round, between the same places. Errors: ExerciseError::WithoutTarget.
  virtual Result<TaskPointer> withTurnedTarget(const ExerciseTask& task) const = 0;
  // The extensions of the files that a target is imported from: ".step", …
  virtual std::vector<std::string> targetEndings() const = 0;
  struct ImportedTask {
    TaskPointer task;
    std::vector<Note> notes;        // what the teacher should know of the file
    std::string place = {};         // group of the properties that say where it lies, to be confirmed; empty: none
    std::optional<Note> lies = {};  // the same as a sentence, as long as none of them is changed
  };
  // A task whose target is in a file: a drawing, a solid, a mesh or a document of our own. Blocks. Errors: those of the
  // readers, FormatUnknown, ValueOutOfRange; the subject is the path. facing: mm of the stock that are left at its free
  // end, to be worked off; none: what is usual.
  virtual Result<ImportedTask> withImportedTarget(const ExerciseTask& task, const std::filesystem::path& path,
                                                  std::optional<double> facing, Progress progress) const = 0;
  // A task whose target is in round sizes, as a drawing has them. step: mm; hollow corners of up to largestFillet (mm)
  // become sharp. Errors: ExerciseError::WithoutTarget, those of the target in such a step.
  struct RoundedTask {
    TaskPointer task;
    double largestChange = 0.0;  // mm, of a surface of the target
  };
  virtual Result<RoundedTask> withRoundedTarget(const ExerciseTask& task, double step, double largestFillet) const = 0;

  // Measures the figures of the criteria that are not common ones. Deterministic.
  virtual std::vector<Measurement> measure(const Exercise& exercise, const ExerciseTask& task, const Snapshot& work,
                                           Progress progress) const = 0;
  virtual ReportDetails details(const ExerciseTask& task, const Snapshot& work, Progress progress) const = 0;
  // The target, as it is shown in the view.
  virtual DisplayModel display(const ExerciseTask& task) const = 0;

  // The formats in which a drawing of the target is written.
  virtual std::vector<FileFormat> drawingFormats() const = 0;
  // Writes it, with the tolerances that students see. The path ends as one of the formats. Errors:
  // ExerciseError::WithoutTarget, those of the files.
  virtual Result<WrittenFile> exportDrawing(const Exercise& exercise, const ExerciseTask& task,
                                            const std::filesystem::path& path, Progress progress) const = 0;
};

}  // namespace handwheel
