// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/TurnedPartDisplay.h"

#include <optional>

namespace handwheel {

// A part that is shown at one moment after another, as while it is played. The triangles of a moment are made only
// where it differs from the moment before, so that a step costs what it cuts. Calls must not overlap; they may be made
// on any thread.
class PlayedPart {
 public:
  // chord: largest distance of the triangles from the surface, mm; base: z of the lower end of the part, mm.
  PlayedPart(double chord, double base) : m_chord(chord), m_base(base) {}

  // Returns the display of the part with its threads (null: none); pieces that were parted off are in their group.
  // O(samples), and the triangles of the blocks that changed.
  DisplayModel at(const TurnedProfile& part, const std::shared_ptr<const PartThreads>& threads);

 private:
  double m_chord, m_base;
  std::optional<TurnedProfile> m_part;  // the part of m_surface; none: nothing was shown yet
  std::optional<TurnedSurface> m_surface;
  double m_largest = 0.0;  // mm, radius that the surface was begun with
  PartedBlock m_parted;
};

}  // namespace handwheel
