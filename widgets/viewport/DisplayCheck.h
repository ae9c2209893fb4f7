// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace handwheel {

// Why no window can be drawn to off screen, in English for the log; empty when the X display and GLX are there. VTK
// itself would end the program.
std::string displayProblem();

}  // namespace handwheel
