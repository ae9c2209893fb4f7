// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/CurveFile.h"

#include <chrono>
#include <filesystem>
#include <map>

namespace handwheel {

// Measured costs of the settings on this machine. They are stored between sessions.
struct Calibration {
  std::string machine;  // the value of machineClass()
  // Duration (us) of a tick in contact for each rate of the servo loop (Hz), when the loop sleeps between ticks. Empty:
  // not measured.
  std::map<double, double> ticksInUse;
  std::map<std::string, CurveFile> curves;  // by the id of the setting
};

// Returns the settings whose cost is time and thus depends on the machine. The settings of the servo loop come first.
std::vector<const FidelityRegistry::Entry*> machineDependent(const FidelityRegistry& registry);

// Time limit of a calibration; after it no further measurement is started.
inline constexpr std::chrono::seconds kLongestCalibration{60};

// Measures one setting, with fewer points than the curves that come with the program. The first setting of the servo
// loop also measures ticksInUse. All settings together take about half a minute. Error: Cancelled; the calibration is
// then unchanged.
Status calibrate(const FidelityRegistry::Entry& entry, Calibration& calibration, Progress progress);

// Converts a calibration to JSON, including kCalibrationVersion.
std::string jsonOf(const FidelityRegistry& registry, const Calibration& calibration);
// Reads a calibration from JSON. Unknown settings, and curves of other cases than the built-in ones, are skipped.
// Errors: VersionNewer, ElementMalformed.
Result<Calibration> readCalibration(const FidelityRegistry& registry, std::string_view json);
inline constexpr int kCalibrationVersion = 1;

// Returns the path of the calibration file in the user's cache folder, which the window uses. The organisation and
// application names of QCoreApplication must be set before.
std::filesystem::path defaultCalibrationFile();

// Writes a calibration to a file. Error: WriteFailed.
Status storeCalibration(const FidelityRegistry& registry, const Calibration& calibration,
                        const std::filesystem::path& path);
// Reads a calibration from a file. Errors: FileMissing, FileUnreadable, and the errors of readCalibration().
Result<Calibration> loadCalibration(const FidelityRegistry& registry, const std::filesystem::path& path);

}  // namespace handwheel
