// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathExport.h"

#include <QStringList>

namespace handwheel {

// Returns remarks for the user about a robot program that was opened. The remarks tell how the path may differ from the
// program, and name the remedies. tool: the tool centre point that the program was read for (CellPlans::tool).
QStringList programRemarks(const ProgramPath& read, const Pose& tool);

}  // namespace handwheel
