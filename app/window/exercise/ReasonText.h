// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Marking.h"

#include <QString>

namespace handwheel {

// An exercise text in the language of the program.
QString exerciseText(const ExerciseText& text);
// Why a mark is what it is, and where or why not that was measured: "it could not be measured (the first face is
// missing)".
QString reasonText(const Mark& mark);

}  // namespace handwheel
