// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/MeasureReport.h"
#include "fidelity/Calibration.h"

namespace handwheel {

// What was measured of this machine, as the button of the window does it.
struct CalibrationRun {
  std::filesystem::path file;  // where the window finds it
  Calibration calibration;     // with what was there before of settings that were not measured now
  std::vector<MeasuredSetting> measured;
  std::size_t wanted = 0;  // settings: more than were measured where the time was up
  Status kept = Done{};    // why the file was not written, if it was not
};

// Measures these settings, which are machineDependent(), one after another and keeps what it has after each; begins
// with none any more after kLongestCalibration. Errors: Cancelled; then what was measured by then is kept.
Result<CalibrationRun> calibrateMachine(const FidelityRegistry& registry,
                                        const std::vector<const FidelityRegistry::Entry*>& entries, Progress progress);

// What presets cost here; the ticks of the servo loop.
std::string readableText(const CalibrationRun& run);
nlohmann::ordered_json toJson(const CalibrationRun& run);

}  // namespace handwheel
