// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/KindUi.h"

namespace handwheel {

// Opens the main window with the files named on the command line and runs until it is closed.
int runWindow(int argc, char** argv, const KindSet& kinds);

}  // namespace handwheel
