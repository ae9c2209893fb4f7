// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ShapingObstacle.h"

#include "document/volume/VolumeDocument.h"

#include <QtGlobal>

namespace handwheel {

const char* shapingObstacle(const VolumeDocument& document) {
  return document.isToBeDrilled() ? QT_TRANSLATE_NOOP("Tool", "this volume is to be drilled, not shaped") : nullptr;
}

}  // namespace handwheel
