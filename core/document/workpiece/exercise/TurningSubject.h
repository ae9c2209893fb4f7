// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/exercise/TurningTask.h"

namespace handwheel {

// Exercises of turning, in which students cut a workpiece that is measured against a drawing.
class TurningSubject : public ExerciseSubject {
 public:
  std::string id() const override { return "turning"; }
  std::string title() const override;
  const DocumentKind& kind() const override { return m_kind; }
  bool isTurned() const override { return true; }
  std::vector<MeasurementType> figures() const override;

  bool sharesTolerance(const MarkingCriterion& criterion, const MarkingCriterion& other) const override;
  Status applyTolerance(MarkingCriterion& criterion) const override;
  // Returns Z of the finished face.
  std::optional<double> drawingZero(const ExerciseTask& task) const override;
  double targetMove(const ExerciseTask& from, const ExerciseTask& to) const override;
  std::vector<MarkingCriterion> targetSizes(const ExerciseTask& task) const override;
  // Returns 0 for collisions, and the limits of the lathe for force and power.
  std::optional<double> usualLimit(const std::string& figure, const ExerciseTask& task) const override;
  std::string positionProblem(const MarkingCriterion& criterion, const ExerciseTask& task) const override;
  std::string conflict(const MarkingCriterion& criterion, const Exercise& exercise) const override;
  TaskPointer blankTask() const override;
  nlohmann::json toJson(const ExerciseTask& task) const override;
  TaskPointer fromJson(const nlohmann::json& json, std::vector<Error>& damage) const override;
  nlohmann::json unknownKeys(const nlohmann::json& json, const ExerciseTask& task) const override;
  std::vector<Property> properties(const ExerciseTask& task) const override;
  Result<TaskPointer> withProperty(const ExerciseTask& task, const std::string& id,
                                   const PropertyValue& value) const override;

  std::vector<ExerciseText> conditions(const ExerciseTask& task) const override;
  SnapshotPointer start(const ExerciseTask& task) const override;
  Status checkWork(const ExerciseTask& task, const Snapshot& work) const override;
  // Judges the origin by the passes. Passes in files of older programs that do not tell count as made by hand.
  WorkOrigin originOf(const Snapshot& work) const override;
  bool areProgramsAllowed(const ExerciseTask& task) const override;
  bool areCommandsAllowed(const ExerciseTask& task) const override;
  // Reads {"passes": [{"nose_radius": mm, "side": "outside" or "bore", "feed": mm per revolution, "points": [[r, z],
  // …], "thread": {"pitch": mm, "starts", "hand": "right" or "left", "flat": mm}}]}. The key "points" contains the
  // positions of the centre of the nose; all other keys are optional.
  Result<SnapshotPointer> makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                   Progress progress) const override;
  nlohmann::json describeWork(const ExerciseTask& task, const Snapshot& work) const override;
  Result<TaskPointer> withTarget(const ExerciseTask& task, const Snapshot& work) const override;
  // Judges sizes, not threads, which a target does not have, and what only passes tell.
  std::vector<std::string> criteriaOffTarget(const Exercise& exercise, const ExerciseTask& task) const override;
  std::vector<Note> fitNotes(const ExerciseTask& task) const override;
  std::optional<Note> endsNote(const ExerciseTask& task) const override;
  QImage targetPicture(const ExerciseTask& task) const override;
  Result<TaskPointer> withTurnedTarget(const ExerciseTask& task) const override;
  std::vector<std::string> targetEndings() const override;
  Result<ImportedTask> withImportedTarget(const ExerciseTask& task, const std::filesystem::path& path,
                                          std::optional<double> facing, Progress progress) const override;
  Result<RoundedTask> withRoundedTarget(const ExerciseTask& task, double step, double largestFillet) const override;

  std::vector<Measurement> measure(const Exercise& exercise, const ExerciseTask& task, const Snapshot& work,
                                   Progress progress) const override;
  ReportDetails details(const ExerciseTask& task, const Snapshot& work, Progress progress) const override;
  DisplayModel display(const ExerciseTask& task) const override;
  std::vector<FileFormat> drawingFormats() const override;
  Result<WrittenFile> exportDrawing(const Exercise& exercise, const ExerciseTask& task,
                                    const std::filesystem::path& path, Progress progress) const override;

 private:
  WorkpieceKind m_kind;
};

}  // namespace handwheel
