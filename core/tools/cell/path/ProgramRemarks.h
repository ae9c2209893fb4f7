// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathExport.h"

#include <QStringList>

namespace handwheel {

// Returns remarks for the user about a program that was opened. They name the points in which the path may differ from
// it, and the remedies. tool: the tool centre point that it was read for, CellPlans::tool.
QStringList programRemarks(const ProgramPath& read, const Pose& tool);

}  // namespace handwheel
