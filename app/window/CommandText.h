// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/Repair.h"

#include <QString>

namespace handwheel {

// The command lines that do without a window what the user just did in it. Names are quoted for a shell.
QString inspectCommand(const QString& path);
QString repairCommand(const QString& path, const RepairOptions& options);
QString convertCommand(const QString& from, const QString& to);

// "scan.stl" becomes "scan-repaired.stl" beside it.
QString repairedName(const QString& path);

}  // namespace handwheel
