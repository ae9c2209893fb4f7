// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Marking.h"

#include <QString>

namespace handwheel {

// Returns an exercise text in the language of the program.
QString exerciseText(const ExerciseText& text);
// Returns the reason for a mark, with the position of the measurement or the reason why there is no measurement. An
// example is "it could not be measured (the first face is missing)".
QString reasonText(const Mark& mark);

}  // namespace handwheel
