// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"

#include <span>

namespace handwheel {

// All translatable texts of the built-in exercises, in English. They are titles, tasks, steps, hints and names of
// criteria.
std::span<const char* const> shippedExerciseTexts();

// The exercise as it is shown: what ships is in the language of the window, where it was not changed. What people have
// written themselves stays as they wrote it.
Exercise inLanguage(const ExerciseSnapshot& exercise);

}  // namespace handwheel
