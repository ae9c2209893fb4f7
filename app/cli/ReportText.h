// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/MeshReport.h"

#include <string>

namespace handwheel {

// Pads a text with blanks on the left to this width, in bytes. A longer text is returned unchanged.
std::string rightAligned(const std::string& text, std::size_t width);

// Formats the report as an aligned table for people. Numbers have six digits and a decimal point in every locale.
std::string readableText(const MeshReport& report);

}  // namespace handwheel
