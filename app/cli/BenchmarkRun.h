// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/commands/MeasureReport.h"
#include "fidelity/Calibration.h"

namespace handwheel {

// The result of a calibration, the same that the button in the window performs.
struct BenchmarkRun {
  std::filesystem::path file;  // from which the window loads it
  Calibration calibration;     // settings that were not measured now keep their earlier measurements
  std::vector<MeasuredSetting> measured;
  std::size_t wanted = 0;  // number of settings; more than were measured when the time limit was reached
  Status kept = Done{};    // whether the file was written, and why not
};

// Measures these settings one after another and stores the results after each. All must be machineDependent(). After
// kLongestCalibration no further measurement is started. Errors: Cancelled; what was measured before that is kept.
Result<BenchmarkRun> benchmarkMachine(const FidelityRegistry& registry,
                                      const std::vector<const FidelityRegistry::Entry*>& entries, Progress progress);

// The results as text: costs of the presets, and ticks of the servo loop.
std::string readableText(const BenchmarkRun& run);
// The same as JSON.
nlohmann::ordered_json toJson(const BenchmarkRun& run);

}  // namespace handwheel
