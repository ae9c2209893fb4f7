// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeKind.h"
#include "document/volume/exercise/DrillingTask.h"

namespace handwheel {

// Exercises of drilling: students drill a hole into a volume. It is compared with the planned path. The target is that
// path; the imported file is the stock.
class DrillingSubject : public ExerciseSubject {
 public:
  std::string id() const override { return "drilling"; }
  std::string title() const override;
  const DocumentKind& kind() const override { return m_kind; }
  std::vector<MeasurementType> figures() const override;

  Status applyTolerance(MarkingCriterion& criterion) const override;
  // The forbidden region must not be touched at all.
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
  // The description is that of describedHoles().
  Result<SnapshotPointer> makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                   Progress progress) const override;
  // Returns nothing, as holes are drilled by hand.
  nlohmann::json describeWork(const ExerciseTask& task, const Snapshot& work) const override;
  // Takes the path of the last hole from its contact with the stock. Error: NothingDrilled.
  Result<TaskPointer> withTarget(const ExerciseTask& task, const Snapshot& work) const override;
  std::vector<std::string> targetEndings() const override;
  // Replaces the stock by a document of a volume, a VDB file or images.
  Result<ImportedTask> withImportedTarget(const ExerciseTask& task, const std::filesystem::path& path,
                                          std::optional<double> facing, Progress progress) const override;
  // Always returns the error WithoutTarget: a path has no ends to turn, no sizes to round, and no drawing.
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

// Returns the displayed planned path and forbidden region: a thin rod to the entry and on through the stock, and the
// balls.
std::vector<DisplayPart> planParts(const DrillPlan& plan);

}  // namespace handwheel
