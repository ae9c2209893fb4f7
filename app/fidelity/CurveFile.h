// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelitySweep.h"

namespace handwheel {

// The measurements of one setting as resources/fidelity/ID.json keeps them. Presets are derived from them, so they are
// data: with the day and the kind of machine they come from.
struct CurveFile {
  std::string date;     // "2026-07-01"
  std::string machine;  // processor and number of cores
  std::vector<FidelityRow> rows;
};

// What the day and the machine are here and now.
std::string today();
std::string machineClass();

// JSON, one row to a line. Infinite errors (no result) stand as null.
std::string jsonOf(const FidelitySetting& setting, const CurveFile& curve);
// Errors: ElementMalformed {element, what is wrong}.
Result<CurveFile> readCurveFile(const FidelitySetting& setting, std::string_view json);

}  // namespace handwheel
