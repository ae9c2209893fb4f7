// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <TopoDS_Shape.hxx>
#include <string>
#include <string_view>

namespace handwheel {

// The content of a STEP file.
struct StepShape {
  TopoDS_Shape shape;  // mm
  int parts = 0;       // number of roots of the file
  int partsRead = 0;
  int solids = 0;
  int openShells = 0;  // number of open shells, and of single faces, that belong to no solid
  std::string unit;    // unit of its lengths: "millimetre", "inch"; empty: not stated
};

// Reads a STEP file. Adjacent faces that belong to no solid are sewn. May throw Standard_Failure and bad_alloc; with
// hostile bytes the behaviour is undefined. Errors: LibraryFailed with the reason.
Result<StepShape> readShape(std::string_view bytes, Progress progress);

}  // namespace handwheel
