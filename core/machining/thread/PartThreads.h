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
  static constexpr std::size_t kMostGrooves = 64;  // limit; the grooves of earlier passes are within the last ones

  // Returns the threads of passes, or null if no pass cuts a thread.
  static std::shared_ptr<const PartThreads> of(const TurningPasses& passes);

  // Returns the threads of a part, which may be null, after one more pass.
  static std::shared_ptr<const PartThreads> with(const std::shared_ptr<const PartThreads>& before,
                                                 const TurningPass& pass);

  const std::vector<ThreadGroove>& grooves() const { return m_grooves; }

  // Returns the groove that changes a side between two heights (mm), with these radii (mm) of the profile; null: none
  // does.
  const ThreadGroove* between(TurningSide side, double low, double high, double radiusLow, double radiusHigh) const;

  // Returns the radius (mm) of a side of the part at a height and an angle, given the radius of the profile and of the
  // other side of the wall. A groove never goes through the wall.
  double radius(TurningSide side, double radius, double otherSide, double z, double angle) const;

  // Returns the volume that the grooves remove from the profile, mm³, with a relative error below 1e-4.
  double volume(const TurnedProfile& profile) const;

 private:
  void add(const TurningPass& pass);

  std::vector<ThreadGroove> m_grooves;
  bool m_isOutside = false, m_isBore = false;  // sides that have grooves
};

}  // namespace handwheel
