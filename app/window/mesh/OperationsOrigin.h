// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "tools/mesh/MeshScript.h"

#include <QString>

namespace handwheel {

// A file from which editing steps lead to later states of a mesh. It is the file that was opened, or a container that
// was saved. Only these preserve the numbering of vertices and faces; saving in another format renumbers them.
struct OperationsOrigin {
  QString path;
  HistoryPoint state;
  LengthUnit displayUnit = LengthUnit::Millimetre;
  bool isReplaced = false;  // the file was overwritten by a later state; only a copy of it is usable
};

}  // namespace handwheel
