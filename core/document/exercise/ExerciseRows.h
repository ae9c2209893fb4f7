// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// The exercise with one more criterion or step at the end. The new one has an id that is free. A new criterion has the
// usual limit of its figure, if there is one.
ExerciseSnapshot withNewCriterion(ExerciseSnapshot exercise, const FigureType& figure);
ExerciseSnapshot withNewStep(ExerciseSnapshot exercise);
// Without one; steps do not name the criterion any more.
ExerciseSnapshot withoutCriterion(ExerciseSnapshot exercise, const std::string& id);
ExerciseSnapshot withoutStep(ExerciseSnapshot exercise, std::size_t step);
// With a row before its neighbour, or behind it; the first and the last stay where they are.
ExerciseSnapshot withMovedCriterion(ExerciseSnapshot exercise, std::size_t row, bool isUp);
ExerciseSnapshot withMovedStep(ExerciseSnapshot exercise, std::size_t row, bool isUp);

}  // namespace handwheel
