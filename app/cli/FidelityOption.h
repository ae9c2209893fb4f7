// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "cli/Arguments.h"

#include <span>

namespace handwheel {

// What --fidelity chooses for a command that reads only these settings: a preset, and single values of them. Returns
// what is wrong, as a sentence, or nothing: a value that nobody reads would be taken for one that had an effect.
std::string readFidelity(const Arguments& arguments, std::string_view command, std::span<const FidelitySetting> read,
                         FidelityValues& values);

}  // namespace handwheel
