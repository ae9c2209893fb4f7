// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPasses.h"
#include "machining/thread/ThreadGroove.h"

#include <limits>
#include <memory>

namespace handwheel {

// The threads of a turned part, as grooves in its profile. The profile itself has no grooves; it is the envelope of the
// threaded surface. Objects are immutable and may be used on any thread.
class PartThreads {
 public:
  static constexpr std::size_t kMostGrooves = 64;  // largest number; grooves within other grooves do not count

  // Returns the threads that passes cut, or null if no pass cuts a thread.
  static std::shared_ptr<const PartThreads> of(const TurningPasses& passes);

  // Returns the threads of a part after one more pass. `before` may be null, and so may the result.
  static std::shared_ptr<const PartThreads> with(const std::shared_ptr<const PartThreads>& before,
                                                 const TurningPass& pass);

  const std::vector<ThreadGroove>& grooves() const { return m_grooves; }

  // Returns a groove that changes a side between two heights (mm), given the radii (mm) of the profile at these
  // heights. Returns null if no groove changes the side.
  const ThreadGroove* between(TurningSide side, double low, double high, double radiusLow, double radiusHigh) const;

  // Returns the radius (mm) of a side of the part at a height and an angle, given the radius of the profile and of the
  // other side of the wall. A groove never goes through the wall.
  double radius(TurningSide side, double radius, double otherSide, double z, double angle) const;

  // Returns the volume that the grooves remove from the profile, mm³, with a relative error below 1e-4.
  // low, high: heights between which the grooves count, mm.
  double volume(const TurnedProfile& profile, double low = -std::numeric_limits<double>::infinity(),
                double high = std::numeric_limits<double>::infinity()) const;

 private:
  void add(const TurningPass& pass);

  std::vector<ThreadGroove> m_grooves;
  bool m_isOutside = false, m_isBore = false;  // sides that have grooves
};

}  // namespace handwheel
