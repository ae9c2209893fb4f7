// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/StepWriter.h"

namespace handwheel {

// The functions of the library hw_step, the only one that links Open CASCADE. It is loaded when it is first needed.
// Errors and thread safety are those of the functions in StepWriter.h.
struct StepFunctions {
  Result<std::string> (*write)(const ProfileCurve& profile, Progress progress) = nullptr;
  Result<StepFileReport> (*inspect)(std::string_view bytes, Progress progress) = nullptr;
};

}  // namespace handwheel

// The entry point of the loaded library, found by this name. Its result lives as long as the library.
extern "C" const handwheel::StepFunctions* handwheelStepFunctions();
