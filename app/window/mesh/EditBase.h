// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "tools/mesh/MeshSteps.h"

#include <QString>

namespace handwheel {

// A file that holds a state of a mesh with all its numbers, from which steps lead to later ones: the one that was
// opened, and each container that was saved. Other formats renumber what they hold.
struct EditBase {
  QString path;
  HistoryPoint state;
  LengthUnit displayUnit = LengthUnit::Millimetre;
  bool isReplaced = false;  // by a later state: only who has kept it can begin with it
};

}  // namespace handwheel
