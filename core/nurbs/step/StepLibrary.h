// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/StepWriter.h"

namespace handwheel {

// What the library hw_step does, the only one that links Open CASCADE. It is loaded with the first need of it. Errors
// and threads are those of the functions in StepWriter.h.
struct StepFunctions {
  Result<std::string> (*write)(const ProfileCurve& profile, Progress progress) = nullptr;
  Result<StepFileReport> (*inspect)(std::string_view bytes, Progress progress) = nullptr;
};

}  // namespace handwheel

// Found by this name in the loaded library. What it returns lives as long as the library.
extern "C" const handwheel::StepFunctions* handwheelStepFunctions();
