// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeKind.h"
#include "document/volume/exercise/DrillingTask.h"

namespace handwheel {

// Exercises of drilling: students drill a hole into a volume along a planned path. The path is the target, and the
// imported file is the stock.
class DrillingSubject : public ExerciseSubject {
 public:
  std::string id() const override { return "drilling"; }
  std::string title() const override;
  const DocumentKind& kind() const override { return m_kind; }
  std::vector<MeasurementType> figures() const override;

  Status applyTolerance(MarkingCriterion& criterion) const override;
  // Returns the usual limit of a figure. The forbidden region must not be touched at all.
  std::optional<double> usualLimit(const std::string& figure, const ExerciseTask&) const override {
    return figure == "forbidden" ? std::optional(0.0) : std::nullopt;
  }
  std::string positionProblem(const MarkingCriterion&, const ExerciseTask&) const override { return {}; }
  TaskPointer blankTask() const override;
  nlohmann::json toJson(const ExerciseTask& task) const override;
  TaskPointer fromJson(const nlohmann::json& json, std::vector<Error>& damage) const override;
  nlohmann::json unknownKeys(const nlohmann::json& json, const ExerciseTask& task) const override;
  std::vector<Property> properties(const ExerciseTask& task) const override;
  Result<TaskPointer> withProperty(const ExerciseTask& task, const std::string& id,
                                   const PropertyValue& value) const override;

  std::vector<ExerciseText> conditions(const ExerciseTask& task) const override;
  SnapshotPointer start(const ExerciseTask& task) const override;
  bool startsSlowly() const override { return true; }
  Status checkWork(const ExerciseTask& task, const Snapshot& work) const override;
  std::optional<std::size_t> triesOf(const Snapshot& work) const override;
  // Makes the work from a description, whose form is that of describedHoles().
  Result<SnapshotPointer> makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                   Progress progress) const override;
  // Returns nothing, as holes are drilled by hand.
  nlohmann::json describeWork(const ExerciseTask& task, const Snapshot& work) const override;
  // Returns the task with the path of the last hole as its target. The path begins at the first contact of the drill
  // with the stock. Holes of a saw are skipped. Error: NothingDrilled.
  Result<TaskPointer> withTarget(const ExerciseTask& task, const Snapshot& work) const override;
  std::vector<std::string> targetEndings() const override;
  // Replaces the stock by a volume from a document, a VDB file or images.
  Result<ImportedTask> withImportedTarget(const ExerciseTask& task, const std::filesystem::path& path,
                                          std::optional<double> facing, Progress progress) const override;
  // These functions and exportDrawing() always return the error WithoutTarget. They are meant for turned parts: a path
  // cannot be turned end for end, has no sizes to round, and has no drawing.
  Result<TaskPointer> withTurnedTarget(const ExerciseTask& task) const override;
  Result<RoundedTask> withRoundedTarget(const ExerciseTask& task, double step, double largestFillet) const override;

  std::vector<Measurement> measure(const Exercise& exercise, const ExerciseTask& task, const Snapshot& work,
                                   Progress progress) const override;
  ReportDetails details(const ExerciseTask& task, const Snapshot& work, Progress progress) const override;
  DisplayModel display(const ExerciseTask& task) const override;
  std::vector<FileFormat> drawingFormats() const override { return {}; }
  Result<WrittenFile> exportDrawing(const Exercise& exercise, const ExerciseTask& task,
                                    const std::filesystem::path& path, Progress progress) const override;

 private:
  VolumeKind m_kind;
};

// Returns the parts that display a plan. The planned path is a thin rod, which begins outside of the stock and ends
// a short way behind the entry; the forbidden region consists of balls.
std::vector<DisplayPart> planParts(const DrillPlan& plan);

}  // namespace handwheel
