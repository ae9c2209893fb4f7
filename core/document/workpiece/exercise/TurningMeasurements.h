// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"
#include "document/workpiece/ReplayCurves.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "document/workpiece/exercise/TurningTask.h"
#include "machining/finish/FinishReading.h"

namespace handwheel {

// Returns all figures of turning, with their units and arguments.
const std::vector<MeasurementType>& turningMeasurementTypes();

// Implements ExerciseSubject::positionProblem() for parts that are made from a bar.
std::string positionProblem(const MarkingCriterion& criterion, const StockCylinder& bar);

// Measures a figure of the shape of a part: its sizes, or its deviation from the target of the task. threads: null for
// none.
Measurement measureShape(const TurningTask& task, const MarkingCriterion& criterion, const TurnedProfile& profile,
                         const PartThreads* threads, Progress progress = {});

// Takes back the pitch diameter of a thread whose pitch is not within its limits: those of the criterion for the pitch
// along the same range, or of the tolerance of the pitch diameter. It is no pitch diameter of the thread that was asked
// for. figures: figures of criteria of the exercise.
void rejectWrongPitches(const Exercise& exercise, std::vector<Measurement>& figures);

// Returns the largest resultant force (N) and motor power (kW), as they are marked, of the passes of a workpiece after
// the passes of `before`. `before` must be an earlier part of that workpiece; if it is null, all passes count. Returns
// nothing if the computation takes too much work or is cancelled.
std::optional<std::pair<double, double>> peakLoads(const TurningTask& task, const WorkpieceSnapshot& workpiece,
                                                   const TurnedPart* before, Progress progress = {});

// Returns a feed as text, such as "1.25", or "∞" for a spindle that stood still.
std::string feedText(double feed);

// A turned part with a review of its passes, for measuring. It is computed once for all figures.
class MeasuredPart {
 public:
  // The review is missing if it takes too much work; figures that need it are then not measured.
  MeasuredPart(const TurningTask& task, const WorkpieceSnapshot& workpiece, Progress progress);

  // Measures the figure of a criterion. The result is deterministic. A figure that cannot be measured has a remark with
  // the reason.
  Measurement measure(const MarkingCriterion& criterion, Progress progress = {}) const;

  const TurnedProfile& profile() const { return m_profile; }
  const std::optional<TurningReview>& review() const { return m_review; }
  // Returns the crashes that were recorded while the part was cut, by the manual lathe or by programs.
  const std::vector<LatheCollision>& crashes() const;
  // Returns the crashes that only the review finds.
  std::vector<CrashMoment> unrecordedCrashes() const;
  // Returns true if the passes give this part, sample by sample, and its finish. Returns false if the file was
  // manipulated.
  bool isOfItsPasses() const { return m_isOfItsPasses; }
  using Load = CutLoad;
  // Returns the resultant force (N) and the motor power (kW) at each moment of the review, by Kienzle's law.
  std::vector<Load> loads() const;
  // Returns the roughness of a side over a range. It is the finish stored with the part or, if that has gaps as in
  // files of older programs, the finish of the passes at the speed of the task. Returns nothing if part of the range is
  // uncut.
  std::optional<FinishReading> finish(TurningSide side, AxisRange range) const;
  // Returns the finish at a sample.
  FinishMark finishAt(TurningSide side, std::size_t i) const;
  // Returns the zero point of the Z values in remarks, mm.
  double zero() const { return m_task.zero(); }

 private:
  Measurement ofPasses(const MarkingCriterion& criterion) const;
  Measurement collisions(const MarkingCriterion& criterion) const;
  bool isDrilled(AxisRange range) const;

  const TurningTask& m_task;
  TurnedProfile m_profile;
  std::optional<TurningReview> m_review;
  SurfaceFinish m_finish;  // the finish stored with the part
  std::vector<std::shared_ptr<const TurningPass>> m_passes;
  std::shared_ptr<const std::vector<LatheCollision>> m_crashes;
  std::shared_ptr<const PartThreads> m_threads;  // null: none
  bool m_isOfItsPasses = false;
};

}  // namespace handwheel
