// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// Return the prefixes of the property ids of a criterion and of a step.
std::string criterionPrefix(const MarkingCriterion& criterion);  // "criterion.d1."
std::string stepPrefix(std::size_t step);                        // "step.1."

// Returns all properties of an exercise: the texts and the time, the properties of the task, and those of each
// criterion and each step.
std::vector<Property> exerciseProperties(const ExerciseSnapshot& exercise);

// Returns the exercise with another value of a property. Errors: ReferenceMissing {property}, ElementMalformed,
// ValueOutOfRange.
Result<ExerciseSnapshot> withExerciseProperty(ExerciseSnapshot exercise, const std::string& id,
                                              const PropertyValue& value);

}  // namespace handwheel
