// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "cli/Arguments.h"

#include <span>

namespace handwheel {

// Parses the option --fidelity, which gives a preset, values of single settings, or both. read: the settings that the
// command uses; any other setting is an error, because it would have no effect. Returns the error as a sentence, or
// nothing.
std::string readFidelity(const Arguments& arguments, std::string_view command, std::span<const FidelitySetting> read,
                         FidelityValues& values);

}  // namespace handwheel
