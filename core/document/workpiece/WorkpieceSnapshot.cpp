// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceSnapshot.h"

namespace handwheel {

TurnedPart TurnedPart::of(TurnedProfile profile, TurningPasses passes, double chord) {
  TurnedSurface surface(profile, chord, PartThreads::of(passes));
  return {std::move(profile), std::move(surface), std::move(passes)};
}

double TurnedPart::volume() const {
  return profile.volume() - (threads() ? threads()->volume(profile) : 0.0);
}

std::shared_ptr<const std::vector<LatheCollision>> allCrashes(const WorkpieceSnapshot& workpiece) {
  const auto ofPasses = workpiece.part ? workpiece.part->crashes : nullptr;
  if (!ofPasses || !workpiece.crashes) return ofPasses ? ofPasses : workpiece.crashes;
  auto all = std::make_shared<std::vector<LatheCollision>>(*workpiece.crashes);
  all->insert(all->end(), ofPasses->begin(), ofPasses->end());
  return all;
}

}  // namespace handwheel
