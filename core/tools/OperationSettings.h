// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Settings of a tool for the parameters of its operation. Their ids are those of the parameters with underscores; each
// number of a list is a setting of its own: "turn_x".

// Returns the setting with this id. Without a value or a default it is as the parameter describes it; a list must have
// one.
Property settingOf(const OperationValues& values, std::string_view id);
// Sets a value from a setting: numbers are clamped to the range, and rounded if they are whole. Returns false and
// changes nothing for an unknown id or a value of another type.
bool takeSetting(OperationValues& values, std::string_view id, const PropertyValue& value);

}  // namespace handwheel
