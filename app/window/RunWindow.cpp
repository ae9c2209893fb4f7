// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/RunWindow.h"
namespace handwheel { int runWindow(int, char**) { return 1; } }
