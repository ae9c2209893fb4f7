// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/TurnedPartDisplay.h"

namespace handwheel {

DisplayModel displayOf(const TurnedSurface& surface, double base) {
  DisplayModel model;
  for (std::size_t b = 0; b < surface.blocks().size(); ++b) {
    DisplayPart part;
    part.name = "block." + std::to_string(b);
    part.group = kStockGroup;
    part.soup = surface.blocks()[b];
    part.pose.translation().z() = base;
    model.parts.push_back(std::move(part));
  }
  return model;
}

}  // namespace handwheel
