// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/commands/MeasureReport.h"
#include "fidelity/Calibration.h"

namespace handwheel {

// The result of a calibration, the same as that of the button in the window.
struct BenchmarkRun {
  std::filesystem::path file;  // the file that the window loads the calibration from
  Calibration calibration;     // settings that were not measured now keep their earlier measurements
  std::vector<MeasuredSetting> measured;
  std::size_t wanted = 0;  // number of settings to measure; more than were measured if the time limit was reached
  Status kept = Done{};    // result of writing the file
};

// Measures these settings one after another and stores the results after each. All must be machineDependent(). After
// kLongestCalibration no further measurement is started. Errors: Cancelled; earlier measurements are kept then.
Result<BenchmarkRun> benchmarkMachine(const FidelityRegistry& registry,
                                      const std::vector<const FidelityRegistry::Entry*>& entries, Progress progress);

// Formats the results as text: costs of the presets, and ticks of the servo loop.
std::string readableText(const BenchmarkRun& run);
// Returns the results as JSON.
nlohmann::ordered_json toJson(const BenchmarkRun& run);

}  // namespace handwheel
