// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPasses.h"
#include "machining/thread/ThreadGroove.h"

#include <memory>

namespace handwheel {

// The threads of a turned part: grooves in its profile, which is their envelope. Immutable; any thread.
class PartThreads {
 public:
  static constexpr std::size_t kMostGrooves = 64;  // that are kept; those of the passes before are within the last ones

  // Null for passes that cut no thread.
  static std::shared_ptr<const PartThreads> of(const TurningPasses& passes);

  // Those of a part, which may be null, after one more pass.
  static std::shared_ptr<const PartThreads> with(const std::shared_ptr<const PartThreads>& before,
                                                 const TurningPass& pass);

  const std::vector<ThreadGroove>& grooves() const { return m_grooves; }

  // The groove that changes a side between two heights (mm), whose radii (mm) are these; null: none does.
  const ThreadGroove* between(TurningSide side, double low, double high, double radiusLow, double radiusHigh) const;

  // The radius (mm) of a side of the part at a height and an angle, where the profile has the radius and, beyond the
  // wall, the radius of the other side. A groove never goes through the wall.
  double radius(TurningSide side, double radius, double otherSide, double z, double angle) const;

  // What the grooves take from the profile, mm³, with a relative error below 1e-4.
  double volume(const TurnedProfile& profile) const;

 private:
  void add(const TurningPass& pass);

  std::vector<ThreadGroove> m_grooves;
  bool m_isOutside = false, m_isBore = false;  // which sides have grooves
};

}  // namespace handwheel
