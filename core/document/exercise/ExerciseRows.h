// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// Returns the exercise with a new criterion for a figure at the end. The criterion has an unused id, and the usual
// limit of the figure if there is one.
ExerciseSnapshot withNewCriterion(ExerciseSnapshot exercise, const MeasurementType& figure);
// Adds criteria, which get unused ids. Criteria beyond Exercise::kMostCriteria are left out.
ExerciseSnapshot withCriteria(ExerciseSnapshot exercise, std::vector<MarkingCriterion> criteria);
// Returns the sizes of the target that no criterion of the scheme covers. Each criterion covers the nearest size that
// has its nominal value or lies within its limits.
std::vector<MarkingCriterion> unmarkedSizes(const ExerciseSnapshot& exercise);
// Returns a note that names the criteria that the target itself would not meet. Returns nothing if it meets all of
// them.
std::optional<Note> offTargetNote(const ExerciseSnapshot& exercise);
ExerciseSnapshot withNewStep(ExerciseSnapshot exercise);
// Remove a criterion or a step. A removed criterion is removed from the steps, too.
ExerciseSnapshot withoutCriterion(ExerciseSnapshot exercise, const std::string& id);
ExerciseSnapshot withoutStep(ExerciseSnapshot exercise, std::size_t step);
// Exchange a row with its upper or lower neighbour; the first row cannot move up, nor the last one down.
ExerciseSnapshot withMovedCriterion(ExerciseSnapshot exercise, std::size_t row, bool isUp);
ExerciseSnapshot withMovedStep(ExerciseSnapshot exercise, std::size_t row, bool isUp);

}  // namespace handwheel
