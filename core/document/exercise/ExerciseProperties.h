// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// The groups of properties of a criterion and of a step begin with these.
std::string criterionPrefix(const MarkingCriterion& criterion);  // of their ids: "criterion.d1."
std::string stepPrefix(std::size_t step);                        // "step.1."

// All that can be read and set of an exercise by name: texts and time, what the subject prepares, then each criterion
// and each step.
std::vector<Property> exerciseProperties(const ExerciseSnapshot& exercise);

// The exercise with another value of a property. Errors: ReferenceMissing {property}, ElementMalformed,
// ValueOutOfRange.
Result<ExerciseSnapshot> withExerciseProperty(ExerciseSnapshot exercise, const std::string& id,
                                              const PropertyValue& value);

}  // namespace handwheel
