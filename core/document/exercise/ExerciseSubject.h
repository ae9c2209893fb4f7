// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/Property.h"
#include "exercise/Marking.h"
#include "exercise/WorkOrigin.h"

#include <QImage>

namespace handwheel {

// A type of figure that can be measured on a student's work.
struct MeasurementType {
  std::string id;                           // id in files: "diameter"
  std::string label;                        // English text, translated in the context "Figure": "Diameter"
  std::string unit;                         // unit: "mm"; empty: a count
  std::vector<std::string> arguments = {};  // English names of lengths, context "Property": "From Z"
};

// Returns the types of the figures that every exercise can mark, which are time and hints.
std::span<const MeasurementType> commonMeasurements();

// Base class of the data of an exercise: stock, machine, target. Objects are immutable. Each kind of work derives its
// own class.
class ExerciseTask {
 public:
  virtual ~ExerciseTask() = default;
};
using TaskPointer = std::shared_ptr<const ExerciseTask>;

// A curve of a report on how the work was done.
struct ReportCurve {
  struct Series {
    std::string name;  // English text, translated in the context "Figure"
    std::vector<std::pair<double, double>> points;
  };
  std::string title;               // English text, translated in the context "Figure"
  std::string x, xUnit, y, yUnit;  // labels and units of the axes
  std::vector<Series> series;
};

// A notable event during the work, for example a collision.
struct ReportEvent {
  std::optional<double> seconds;  // none: the event was before the recorded work
  ExerciseText text;
};

// A picture of the finished work.
struct ReportPicture {
  QImage image;
  ExerciseText caption;
};

// A figure that is reported even if it is not marked.
struct ReportMeasurement {
  std::string figure;  // id of the figure: "force"
  double value = 0.0;
};

// A piece of a recording, such as a pass. Movements by hand are never identical, so equal pieces are copies.
struct RecordedPiece {
  std::uint64_t fingerprint = 0;  // hash of the movement and its times (base/Fingerprint.h)
  double seconds = 0.0;
  bool isByHand = true;  // false: made by a program, which makes the same pieces for everyone
};

// The part of a report that shows a student's work besides the marks.
struct ReportDetails {
  std::vector<ReportPicture> pictures;
  std::vector<ReportMeasurement> figures;
  std::vector<ReportCurve> curves;
  std::vector<ReportEvent> events;
  std::vector<RecordedPiece> pieces;  // pieces of the recorded work, in order
  double seconds = 0.0;               // duration of the work
};

// Base class of exercise subjects. A subject prepares and measures one kind of work, such as turning or drilling. It
// has no state and may be used on any thread.
class ExerciseSubject {
 public:
  virtual ~ExerciseSubject() = default;

  virtual std::string id() const = 0;            // id in files: "turning"
  virtual std::string title() const = 0;         // English text, translated in the context "Figure": "Turning"
  virtual const DocumentKind& kind() const = 0;  // the kind of the documents that students work in
  virtual std::vector<MeasurementType> figures() const = 0;

  // Returns true if the tolerance on the drawing of a criterion is that of another one, too, such as that of a thread.
  virtual bool sharesTolerance(const MarkingCriterion& criterion, const MarkingCriterion& other) const {
    (void)criterion, (void)other;
    return false;
  }
  // Sets the limits of a criterion from its tolerance on the drawing. Error ElementMalformed {criterion, what is
  // wrong}: the tolerance is not known for this figure and nominal value.
  virtual Status applyTolerance(MarkingCriterion& criterion) const = 0;

  // Returns the Z coordinate (mm) of the zero of drawings and programs, in the coordinates of measured positions.
  // Returns nothing if there is no such zero.
  virtual std::optional<double> drawingZero(const ExerciseTask& task) const {
    (void)task;
    return std::nullopt;
  }

  // Returns the displacement of the target along Z between two tasks that differ by a property, mm. Measured positions
  // move with the target.
  virtual double targetMove(const ExerciseTask& from, const ExerciseTask& to) const {
    (void)from, (void)to;
    return 0.0;
  }

  // Returns the sizes of the target as criteria, so that teachers need not enter each size. The ids of the criteria are
  // empty.
  virtual std::vector<MarkingCriterion> targetSizes(const ExerciseTask& task) const {
    (void)task;
    return {};
  }

  // Returns the usual upper limit of a figure, for criteria without a limit. Returns nothing if the figure has no usual
  // limit.
  virtual std::optional<double> usualLimit(const std::string& figure, const ExerciseTask& task) const = 0;

  // Returns the reason why a criterion can never be measured at its arguments, as an English text that is translated in
  // the context "Property". The text is empty if the criterion can probably be measured.
  virtual std::string positionProblem(const MarkingCriterion& criterion, const ExerciseTask& task) const = 0;

  // Returns the reason why a criterion contradicts another one of the exercise, as an English text that is translated
  // in the context "Property". The text is empty if it does not.
  virtual std::string conflict(const MarkingCriterion&, const Exercise&) const { return {}; }

  virtual TaskPointer blankTask() const = 0;
  virtual nlohmann::json toJson(const ExerciseTask& task) const = 0;
  // Reads a task from any JSON. Invalid values are added to the damage and replaced by those of the blank task.
  virtual TaskPointer fromJson(const nlohmann::json& json, std::vector<Error>& damage) const = 0;
  // Returns the keys of a task that fromJson() does not know, as a JSON object. The object is empty if there are no
  // such keys.
  virtual nlohmann::json unknownKeys(const nlohmann::json& json, const ExerciseTask& task) const = 0;
  // Returns the properties of a task that teachers change. withProperty() returns the same errors as
  // Document::propertyEdit().
  virtual std::vector<Property> properties(const ExerciseTask& task) const = 0;
  virtual Result<TaskPointer> withProperty(const ExerciseTask& task, const std::string& id,
                                           const PropertyValue& value) const = 0;

  // Returns lines for the student about stock, machine and tools. The lines are translated in the context "Note".
  virtual std::vector<ExerciseText> conditions(const ExerciseTask& task) const = 0;
  // Returns the document that a student begins with.
  virtual SnapshotPointer start(const ExerciseTask& task) const = 0;
  // Returns true if the work turns about z in a lathe, which determines the view.
  virtual bool isTurned() const { return false; }
  // Returns true if start() takes longer than a person waits for a click.
  virtual bool startsSlowly() const { return false; }
  // Checks that a document can be work on a task, which requires the same stock. Error: ExerciseError::OtherWork
  // {reason}.
  virtual Status checkWork(const ExerciseTask& task, const Snapshot& work) const = 0;
  // Returns how the work was made.
  virtual WorkOrigin originOf(const Snapshot& work) const {
    (void)work;
    return WorkOrigin::Unknown;
  }
  // Returns the number of tries that the work took. Returns nothing if tries are not counted.
  virtual std::optional<std::size_t> triesOf(const Snapshot& work) const {
    (void)work;
    return std::nullopt;
  }
  // Returns true if students may do the work by program.
  virtual bool areProgramsAllowed(const ExerciseTask& task) const {
    (void)task;
    return true;
  }
  // Returns true if students may make shapes by commands, without a tool in their hands.
  virtual bool areCommandsAllowed(const ExerciseTask& task) const {
    (void)task;
    return true;
  }
  // Makes work from a description in JSON, for model solutions. Errors: ElementMalformed, Cancelled.
  virtual Result<SnapshotPointer> makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                           Progress progress) const = 0;
  // Returns the description from which makeWork() makes this work. Returns null if the work cannot be described, for
  // example work by hand.
  virtual nlohmann::json describeWork(const ExerciseTask& task, const Snapshot& work) const = 0;
  // Returns a task whose target is the shape of this work, for teachers who turn the model solution first. Errors:
  // ExerciseError::NothingTurned, ElementMalformed.
  virtual Result<TaskPointer> withTarget(const ExerciseTask& task, const Snapshot& work) const = 0;
  // Returns the ids of the criteria that the target of a task itself would not meet: they were made for another one.
  virtual std::vector<std::string> criteriaOffTarget(const Exercise& exercise, const ExerciseTask& task) const {
    (void)exercise, (void)task;
    return {};
  }
  // Returns warnings if the target does not fit into the stock, for a dialog that changes one of them. The result is
  // empty if the target fits.
  virtual std::vector<Note> fitNotes(const ExerciseTask& task) const {
    (void)task;
    return {};
  }
  // Returns a sentence that tells which end of the target is at the free end of the stock. Returns nothing if the
  // target has no ends or if there is no target.
  virtual std::optional<Note> endsNote(const ExerciseTask& task) const {
    (void)task;
    return std::nullopt;
  }
  // Returns a picture of the target in the stock. The picture is null if there is no target or if drawing would take
  // long.
  virtual QImage targetPicture(const ExerciseTask& task) const {
    (void)task;
    return {};
  }
  // Returns a task whose target is turned end for end in the same part of the stock. Errors:
  // ExerciseError::WithoutTarget.
  virtual Result<TaskPointer> withTurnedTarget(const ExerciseTask& task) const = 0;
  // Returns the extensions of the files that a target is imported from: ".step", …
  virtual std::vector<std::string> targetEndings() const = 0;
  struct ImportedTask {
    TaskPointer task;
    std::vector<Note> notes;  // remarks on the file for the teacher
    // group of the properties for the position of the target in the stock, which the user confirms; empty: none
    std::string positionGroup = {};
    std::optional<Note> lies = {};  // sentence on the position of the target, valid until the position is changed
  };
  // Returns a task whose target is read from a file: a drawing, a solid, a mesh or a Handwheel document. Blocks the
  // calling thread. Errors: the errors of the readers, FormatUnknown, ValueOutOfRange; the subject of an error is the
  // path. facing: the allowance for facing at the free end of the stock, mm; none: the usual allowance.
  virtual Result<ImportedTask> withImportedTarget(const ExerciseTask& task, const std::filesystem::path& path,
                                                  std::optional<double> facing, Progress progress) const = 0;
  struct RoundedTask {
    TaskPointer task;
    double largestChange = 0.0;  // mm, largest distance by which a surface of the target moved
  };
  // Returns a task whose target has round sizes, as on a drawing. step: the step of the sizes, mm. Hollow corners with
  // fillets of up to largestFillet (mm) become sharp. Errors: ExerciseError::WithoutTarget, and the errors of rounding
  // the target with this step.
  virtual Result<RoundedTask> withRoundedTarget(const ExerciseTask& task, double step, double largestFillet) const = 0;

  // Measures the figures of all criteria except the common figures. The result is deterministic.
  virtual std::vector<Measurement> measure(const Exercise& exercise, const ExerciseTask& task, const Snapshot& work,
                                           Progress progress) const = 0;
  virtual ReportDetails details(const ExerciseTask& task, const Snapshot& work, Progress progress) const = 0;
  // Returns the display of the target for the view.
  virtual DisplayModel display(const ExerciseTask& task) const = 0;

  // Returns the file formats for drawings of the target.
  virtual std::vector<FileFormat> drawingFormats() const = 0;
  // Writes a drawing of the target with the tolerances that students see. The extension of the path must be one of
  // drawingFormats(). Errors: ExerciseError::WithoutTarget, and the errors of writing the file.
  virtual Result<WrittenFile> exportDrawing(const Exercise& exercise, const ExerciseTask& task,
                                            const std::filesystem::path& path, Progress progress) const = 0;
};

}  // namespace handwheel
