// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/exercise/TurningTask.h"
#include "exercise/Exercise.h"
#include "machining/drawing/PartDrawing.h"

namespace handwheel {

// Returns the texts on the drawing of an exercise's target. They are the title, the material, and the tolerances,
// threads and roughness of the criteria that students see.
DrawingTitle drawingTitleOf(const Exercise& exercise, const TurningTask& task);

}  // namespace handwheel
