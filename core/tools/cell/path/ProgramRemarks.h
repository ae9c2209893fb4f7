// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathExport.h"

#include <QStringList>

namespace handwheel {

// What a person has to know of a program that was opened. Sentences say what of it the path may do otherwise, and what
// to do about it. tool: the tool's centre point that it was read for, CellPlans::tool.
QStringList programRemarks(const ProgramPath& read, const Pose& tool);

}  // namespace handwheel
