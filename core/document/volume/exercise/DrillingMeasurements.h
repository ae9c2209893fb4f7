// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/exercise/DrillingTask.h"
#include "volume/drilling/DrillReview.h"

namespace handwheel {

// All figures of drilling, with their units.
const std::vector<MeasurementType>& drillingMeasurementTypes();

// The tries that the holes of a work have taken.
DrillTries triesOf(const VolumeSnapshot& work);

// What was drilled in an exercise, gone through again for its figures.
class MeasuredDrilling {
 public:
  MeasuredDrilling(const DrillingTask& task, const VolumeSnapshot& work, Progress progress);

  // Deterministic. What a figure does not find there, it says.
  Measurement measure(const MarkingCriterion& criterion) const;

  // None: cancelled, or another drill was used.
  const std::optional<DrillReview>& review() const { return m_review; }

 private:
  ExerciseText problem(const std::string& figure) const;
  std::optional<double> valueOf(const std::string& figure) const;
  void addFailedTries(const MarkingCriterion& criterion, Measurement& figure) const;

  std::optional<DrillReview> m_review;
  DrillTries m_tries;
  FailedTries m_rule = FailedTries::CostTheMark;
  bool m_isAsPrepared = false;  // all of it with the drill of the task
  bool m_isOfItsHoles = false;  // they leave the volume that there is
};

}  // namespace handwheel
