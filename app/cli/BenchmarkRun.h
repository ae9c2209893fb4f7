// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/commands/MeasureReport.h"
#include "fidelity/Calibration.h"

namespace handwheel {

// The result of a calibration. The calibration button of the window gives the same result.
struct BenchmarkRun {
  std::filesystem::path file;  // the file from which the window loads the calibration
  Calibration calibration;     // settings that were not measured now keep their earlier measurements
  std::vector<MeasuredSetting> measured;
  std::size_t wanted = 0;  // number of settings to measure; greater than measured.size() if the time limit was reached
  Status kept = Done{};    // result of writing the file
};

// Measures settings one after another and stores the results after each. All settings must be machineDependent(). After
// kLongestCalibration no further measurement is started. Errors: Cancelled; the measurements completed before the
// cancellation are kept.
Result<BenchmarkRun> benchmarkMachine(const FidelityRegistry& registry,
                                      const std::vector<const FidelityRegistry::Entry*>& entries, Progress progress);

// Formats the costs of the presets and the durations of the ticks of the servo loop as text.
std::string readableText(const BenchmarkRun& run);
// Returns the results as JSON.
nlohmann::ordered_json toJson(const BenchmarkRun& run);

}  // namespace handwheel
