// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeKind.h"
#include "document/volume/exercise/DrillingTask.h"

namespace handwheel {

// Exercises of drilling: students drill a hole into a volume. It is judged by the planned path. The target is that
// path; what is imported is the stock.
class DrillingSubject : public ExerciseSubject {
 public:
  std::string id() const override { return "drilling"; }
  std::string title() const override;
  const DocumentKind& kind() const override { return m_kind; }
  std::vector<MeasurementType> figures() const override;

  Status applyTolerance(MarkingCriterion& criterion) const override;
  // None of the forbidden region is touched.
  std::optional<double> usualLimit(const std::string& figure, const ExerciseTask&) const override {
    return figure == "forbidden" ? std::optional(0.0) : std::nullopt;
  }
  std::string placeProblem(const MarkingCriterion&, const ExerciseTask&) const override { return {}; }
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
  // As describedHoles() reads it.
  Result<SnapshotPointer> makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                   Progress progress) const override;
  // None: holes are drilled by hand.
  nlohmann::json describeWork(const ExerciseTask& task, const Snapshot& work) const override;
  // The path of the last hole from where it met the stock. Error: NothingDrilled.
  Result<TaskPointer> withTarget(const ExerciseTask& task, const Snapshot& work) const override;
  std::vector<std::string> targetEndings() const override;
  // Another stock: a document of a volume, VDB or images.
  Result<ImportedTask> withImportedTarget(const ExerciseTask& task, const std::filesystem::path& path,
                                          std::optional<double> facing, Progress progress) const override;
  // Error WithoutTarget, always: a path has neither ends nor sizes to be rounded; nor is there a drawing of it.
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

// The planned path and the forbidden region as they are shown: a thin rod to the entry and on through the stock, and
// the balls.
std::vector<DisplayPart> planParts(const DrillPlan& plan);

}  // namespace handwheel
