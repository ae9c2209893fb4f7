// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Settings of a tool for the parameters of its operation. The ids of the settings are those of the parameters, with
// underscores; each number of a list has a setting of its own: "turn_x".

// Returns the setting with this id. Its value is that of the parameter in `values` or the default, or else the initial
// one of Parameter::property. A list must have a value or a default.
Property settingOf(const OperationValues& values, std::string_view id);
// Sets a value from a setting. Numbers are clamped to the range of the parameter, and rounded if it is whole. Returns
// false and changes nothing for an unknown id or a value of another type.
bool takeSetting(OperationValues& values, std::string_view id, const PropertyValue& value);

}  // namespace handwheel
