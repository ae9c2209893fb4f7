// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/TurnedPartDisplay.h"

namespace handwheel {

DisplayModel displayOf(const TurnedSurface& surface, double base) {
  DisplayModel model;
  for (std::size_t b = 0; b < surface.blocks().size(); ++b) {
    DisplayPart part;
    // The last one has the name of an uncut bar, which stays in view until the shape of that one is built.
    part.name = b + 1 < surface.blocks().size() ? "block." + std::to_string(b) : std::string("stock");
    part.soup = surface.blocks()[b];
    part.pose.translation().z() = base;
    model.parts.push_back(std::move(part));
  }
  return model;
}

}  // namespace handwheel
