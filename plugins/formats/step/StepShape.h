// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <TopoDS_Shape.hxx>
#include <string>
#include <string_view>

namespace handwheel {

// What a STEP file holds.
struct StepShape {
  TopoDS_Shape shape;  // mm
  int parts = 0;       // roots of the file
  int partsRead = 0;
  int solids = 0;
  int openShells = 0;  // and single faces: what belongs to no solid
  std::string unit;    // of its lengths: "millimetre", "inch"; empty where it does not say
};

// Reads a STEP file. Faces that belong to no solid are sewn where they meet. May throw Standard_Failure and bad_alloc,
// and much else may happen with hostile bytes. Errors: LibraryFailed with the reason.
Result<StepShape> readShape(std::string_view bytes, Progress progress);

}  // namespace handwheel
