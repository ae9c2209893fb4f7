// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelitySweep.h"

namespace handwheel {

// The stored measurements of one setting, from resources/fidelity/ID.json. The presets
// are derived from these measurements.
struct CurveFile {
  std::string date;     // "2026-07-01"
  std::string machine;  // processor and number of cores
  std::vector<FidelityRow> rows;
};

// Returns the present date in the form "2026-07-01".
std::string today();
// Returns the processor and the number of cores of this machine.
std::string machineClass();

// Converts a curve to JSON with one row per line. Infinite errors (no result) are written as null.
std::string jsonOf(const FidelitySetting& setting, const CurveFile& curve);
// Reads a curve from JSON. Error: ElementMalformed {element, problem}.
Result<CurveFile> readCurveFile(const FidelitySetting& setting, std::string_view json);

}  // namespace handwheel
