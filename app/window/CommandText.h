// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"
#include "document/formats/MeshFormat.h"
#include "mesh/Repair.h"

#include <QString>

namespace handwheel {

// The command lines that do without a window what the user just did in it. They work in any folder: paths stand whole,
// and are quoted for a shell.
QString inspectCommand(const QString& path, const ReadOptions& options);
QString repairCommand(const QString& path, const RepairOptions& options);
QString compareCommand(const QString& mesh, const QString& scan);
QString convertCommand(const QString& from, const QString& to);
// Gives the properties that differ their present values. Empty when none differs and both paths are the same.
QString setCommand(const QString& from, const std::vector<Property>& before, const std::vector<Property>& now,
                   const QString& to);
// The same for a document that was new. kind: id
QString newCommand(const std::string& kind, const std::vector<Property>& before, const std::vector<Property>& now,
                   const QString& to);

// "scan.stl" becomes "scan-repaired.stl" beside it.
QString repairedName(const QString& path);

}  // namespace handwheel
