// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"

#include <span>

namespace handwheel {

// Returns all translatable texts of the built-in exercises, in English. They are titles, tasks, steps, hints and names
// of criteria.
std::span<const char* const> shippedExerciseTexts();

// Returns the exercise for display: unchanged texts of a built-in exercise are translated, and all other texts are left
// as they are.
Exercise inLanguage(const ExerciseSnapshot& exercise);

}  // namespace handwheel
