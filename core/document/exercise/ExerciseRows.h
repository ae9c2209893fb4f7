// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// The exercise with one more criterion or step at the end. The new one has an id that is free. A new criterion has the
// usual limit of its figure, if there is one.
ExerciseSnapshot withNewCriterion(ExerciseSnapshot exercise, const MeasurementType& figure);
// The same of criteria whose ids are empty; as many as there may be.
ExerciseSnapshot withCriteria(ExerciseSnapshot exercise, std::vector<MarkingCriterion> criteria);
// The sizes of the target less one for each criterion that it is the nominal value of, or within the limits of:
// that which is measured nearest to it.
std::vector<MarkingCriterion> unmarkedSizes(const ExerciseSnapshot& exercise);
ExerciseSnapshot withNewStep(ExerciseSnapshot exercise);
// Without one; steps do not name the criterion any more.
ExerciseSnapshot withoutCriterion(ExerciseSnapshot exercise, const std::string& id);
ExerciseSnapshot withoutStep(ExerciseSnapshot exercise, std::size_t step);
// With a row before its neighbour, or behind it; the first and the last stay where they are.
ExerciseSnapshot withMovedCriterion(ExerciseSnapshot exercise, std::size_t row, bool isUp);
ExerciseSnapshot withMovedStep(ExerciseSnapshot exercise, std::size_t row, bool isUp);

}  // namespace handwheel
