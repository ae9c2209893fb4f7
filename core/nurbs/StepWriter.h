// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "base/Result.h"
#include "nurbs/ProfileCurve.h"

#include <string>
#include <string_view>

namespace handwheel {

// Writes a turned part as one solid in a STEP file (AP214, millimetres). The part lies between the profile, the flat
// ends through its first and last point, and the axis, or within a closed profile. Between two corners of the profile
// the lateral surface is one exact rational B-spline surface of nine columns. Numbers are written with all their
// digits. May be called on any thread. Calls on several threads run one after another, since Open CASCADE's STEP code
// supports one thread at a time. Errors: ElementMalformed {profile}, LibraryFailed, Cancelled.
Result<std::string> writeStep(const ProfileCurve& profile, Progress progress = {});

// The properties of the solids in a STEP file.
struct StepFileReport {
  std::size_t solids = 0;
  bool isValid = false;  // topology and geometry are consistent according to Open CASCADE's analyser
  double volume = 0.0;   // mm³, total volume of the solids
  double area = 0.0;     // mm²
  Box bounds;            // mm; may be larger than the solids by their tolerance
};

// Reads a STEP file and measures its solids. The file must have been made by this program, since the library's parser
// is not safe with hostile files. Errors: LibraryFailed, Cancelled.
Result<StepFileReport> inspectStep(std::string_view bytes, Progress progress = {});

}  // namespace handwheel
