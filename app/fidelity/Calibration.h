// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/CurveFile.h"

#include <chrono>
#include <filesystem>
#include <map>

namespace handwheel {

// What was measured on the machine that the program runs on, kept from session to session.
struct Calibration {
  std::string machine;  // as by machineClass()
  // By the rate of the servo loop (Hz): us of a tick in touch when the loop sleeps between ticks. Empty: not measured.
  std::map<double, double> ticksInUse;
  std::map<std::string, CurveFile> curves;  // by the id of the setting
};

// The settings whose cost is time, and thus another one on another machine; those of the servo loop first.
std::vector<const FidelityRegistry::Entry*> machineDependent(const FidelityRegistry& registry);

// Measuring all of them begins with none any more after so long.
inline constexpr std::chrono::seconds kLongestCalibration{60};

// Measures one of them, coarser than the curves that come with the program. The first also finds ticksInUse. All take
// about half a minute. Errors: Cancelled; then nothing has changed.
Status calibrate(const FidelityRegistry::Entry& entry, Calibration& calibration, Progress progress);

// JSON with a version. Unknown settings, and curves of other cases than are built in, are left out when it is read.
// Errors: VersionNewer, ElementMalformed.
std::string jsonOf(const FidelityRegistry& registry, const Calibration& calibration);
Result<Calibration> readCalibration(const FidelityRegistry& registry, std::string_view json);
inline constexpr int kCalibrationVersion = 1;

// Where the window keeps it, in the user's cache folder. The application must have its names by then.
std::filesystem::path usualCalibrationFile();

// The same as a file. Errors: FileMissing, FileUnreadable, WriteFailed.
Status storeCalibration(const FidelityRegistry& registry, const Calibration& calibration,
                        const std::filesystem::path& path);
Result<Calibration> loadCalibration(const FidelityRegistry& registry, const std::filesystem::path& path);

}  // namespace handwheel
