// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/MeshReport.h"

#include <string>

namespace handwheel {

// Puts blanks in front of a text so that it is this wide. A longer one stays as it is.
std::string rightAligned(const std::string& text, std::size_t width);

// Formats the report as an aligned table for people. Numbers have six digits and a decimal point in every locale.
std::string readableText(const MeshReport& report);

}  // namespace handwheel
