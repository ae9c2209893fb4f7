// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSubject.h"
#include "plot/Plot.h"

namespace handwheel {

// Returns a curve of a report as a plot, in the language of the program.
Plot plotOf(const ReportCurve& curve);

}  // namespace handwheel
