// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "tools/mesh/MeshScript.h"

#include <QString>

namespace handwheel {

// A file from which editing steps lead to later states of a mesh. It holds a state with its numbering: the file that
// was opened, or a container that was saved. Other formats renumber vertices and faces.
struct OperationsOrigin {
  QString path;
  HistoryPoint state;
  LengthUnit displayUnit = LengthUnit::Millimetre;
  bool isReplaced = false;  // overwritten by a later state: usable only by those who kept a copy
};

}  // namespace handwheel
