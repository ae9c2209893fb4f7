// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/exercise/DrillingTask.h"
#include "volume/drilling/DrillReview.h"

namespace handwheel {

// Returns the types of all figures of drilling, with their units.
const std::vector<MeasurementType>& drillingMeasurementTypes();

// Returns the tries at the holes of a work.
DrillTries triesOf(const VolumeSnapshot& work);

// The drilling of an exercise, replayed to measure its figures.
class MeasuredDrilling {
 public:
  MeasuredDrilling(const DrillingTask& task, const VolumeSnapshot& work, Progress progress);

  // Measures a figure, or states the reason why it cannot be measured. The result is deterministic.
  Measurement measure(const MarkingCriterion& criterion) const;

  // Replay of the holes; none: the replay was cancelled, or another drill was used.
  const std::optional<DrillReview>& review() const { return m_review; }

 private:
  ExerciseText problem(const std::string& figure) const;
  std::optional<double> valueOf(const std::string& figure) const;
  void addFailedTries(const MarkingCriterion& criterion, Measurement& figure) const;

  std::optional<DrillReview> m_review;
  DrillTries m_tries;
  FailedTries m_rule = FailedTries::CostTheMark;
  bool m_isAsPrepared = false;  // all holes were drilled with the drill of the task
  bool m_isOfItsHoles = false;  // replaying the holes results in the volume of the work
};

}  // namespace handwheel
