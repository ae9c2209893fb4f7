// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceSnapshot.h"

#include "machining/lathe/LatheRun.h"

#include <algorithm>
#include <utility>

namespace handwheel {

TurnedPart TurnedPart::of(TurnedProfile profile, TurningPasses passes, double chord) {
  if (!profile.section()) profile.setSection(SectionSource::fitted(profile));
  TurnedSurface surface(profile, chord, PartThreads::of(passes));
  return {std::move(profile), std::move(surface), std::move(passes)};
}

double TurnedPart::volume() const {
  return volumeOf(section());
}

double TurnedPart::volumeOfSamples() const {
  return profile.volume() - (threads() ? threads()->volume(profile, 0.0, profile.length()) : 0.0);
}

double TurnedPart::volumeOf(const TurnedSection& piece) const {
  return piece.volume() - (threads() ? threads()->volume(profile, piece.box().min().y(), piece.box().max().y()) : 0.0);
}

std::vector<TurnedSection> TurnedPart::partedSince(const TurnedPart* before) const {
  constexpr double kBelow = 1e-3;  // mm
  std::vector<TurnedSection> pieces = section().pieces();
  if (!pieces.empty()) pieces.erase(pieces.begin());  // the one in the chuck
  std::erase_if(pieces, [&](const TurnedSection& piece) {
    return before && !before->section().radiiAt(piece.box().min().y() - kBelow);
  });
  return pieces;
}

bool addCrashes(WorkpieceSnapshot& workpiece, std::span<const LatheCollision> crashes) {
  auto all = workpiece.crashes ? std::make_shared<std::vector<LatheCollision>>(*workpiece.crashes)
                               : std::make_shared<std::vector<LatheCollision>>();
  const std::size_t count = std::min(crashes.size(), LatheRun::kMostCollisions - all->size());
  if (count == 0) return false;
  all->insert(all->end(), crashes.begin(), crashes.begin() + static_cast<std::ptrdiff_t>(count));
  workpiece.crashes = std::move(all);
  return true;
}

}  // namespace handwheel
