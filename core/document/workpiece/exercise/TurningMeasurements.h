// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"
#include "document/workpiece/ReplayCurves.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "document/workpiece/exercise/TurningTask.h"
#include "machining/finish/FinishReading.h"

namespace handwheel {

// All figures of turning, with their units and arguments.
const std::vector<MeasurementType>& turningMeasurementTypes();

// As ExerciseSubject::placeProblem(), for parts that are made of this bar.
std::string placeProblem(const MarkingCriterion& criterion, const StockCylinder& bar);

// The largest force (N) and power (kW) of the passes that follow those of `before` in a workpiece that was cut, as they
// are marked; null: of all. `before` must be that workpiece at an earlier time. None: too much work, cancelled.
std::optional<std::pair<double, double>> peakLoads(const TurningTask& task, const WorkpieceSnapshot& workpiece,
                                                   const TurnedPart* before, Progress progress = {});

// "1.25"; "∞" while the spindle stood.
std::string feedText(double feed);

// A turned part with what its passes tell, for measuring. Computed once for all figures.
class MeasuredPart {
 public:
  // The review is missing where it takes too much work; then what needs it is not measured.
  MeasuredPart(const TurningTask& task, const WorkpieceSnapshot& workpiece, Progress progress);

  // Deterministic. What a figure does not find there, it says.
  Measurement measure(const MarkingCriterion& criterion, Progress progress = {}) const;

  const TurnedProfile& profile() const { return m_profile; }
  const std::optional<TurningReview>& review() const { return m_review; }
  // Recorded while the part was cut, by the manual lathe or by programs.
  const std::vector<LatheCollision>& crashes() const;
  // Those that the review alone tells.
  std::vector<CrashMoment> unrecordedCrashes() const;
  // Whether the passes give this part, sample by sample, and its finish. Else somebody has changed the file.
  bool isOfItsPasses() const { return m_isOfItsPasses; }
  // The cutting force (N) and the power (kW) at each moment of the review, by Kienzle's law.
  using Load = CutLoad;
  std::vector<Load> loads() const;
  // The roughness of a side along a range: that which is kept along the part; where it is not kept all the way, as in
  // files of older programs, that of the passes at the speed of the task. None where it is not cut all the way.
  std::optional<FinishReading> finish(TurningSide side, AxisRange range) const;
  // The same at a sample.
  FinishMark finishAt(TurningSide side, std::size_t i) const;
  // mm, Z that remarks count from.
  double zero() const { return m_task.zero(); }

 private:
  Measurement ofPasses(const MarkingCriterion& criterion) const;
  Measurement collisions(const MarkingCriterion& criterion) const;
  Measurement ofShape(const MarkingCriterion& criterion, Progress progress) const;

  const TurningTask& m_task;
  TurnedProfile m_profile;
  std::optional<TurningReview> m_review;
  SurfaceFinish m_finish;  // kept
  std::vector<std::shared_ptr<const TurningPass>> m_passes;
  std::shared_ptr<const std::vector<LatheCollision>> m_crashes;
  std::shared_ptr<const PartThreads> m_threads;  // null: none
  bool m_isOfItsPasses = false;
};

}  // namespace handwheel
