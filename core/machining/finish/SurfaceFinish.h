// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "machining/TurnedProfile.h"

#include <cstdint>

namespace handwheel {

// How the surface was left at a sample of a profile.
struct FinishMark {
  static constexpr float kDrawn = 3.2f;  // µm Ra, of a bar before anything has touched it: bright drawn steel
  static constexpr float kUnknown = -1.0f;
  static constexpr std::uint32_t kNoPass = 0xffff'ffff;

  float roughness = kDrawn;      // µm Ra; below 0: not known; infinite of an edge without a nose radius
  float feed = 0.0f;             // mm per revolution, at which the last pass went by; 0 where it is not known
  std::uint32_t pass = kNoPass;  // that took material off last, by its place among those of the part

  // Whether a pass has left it, and it is known how.
  bool isKnown() const { return pass != kNoPass && roughness >= 0.0f; }
  bool operator==(const FinishMark&) const = default;
};

// The surface finish along a turned part, outside and in the bore. It has a mark for each sample of its profile. A copy
// shares its pages with the original, as that of the profile does.
class SurfaceFinish {
 public:
  // Of a bar that was not cut. samples: of the profile.
  explicit SurfaceFinish(std::size_t samples = 0);
  // Of a part of which nothing is known.
  static SurfaceFinish unknown(const TurnedProfile& profile);

  std::size_t size() const { return m_outer.size(); }
  FinishMark at(TurningSide side, std::size_t i) const;  // that of a bar where there is no such sample
  void set(TurningSide side, std::size_t i, const FinishMark& mark);

  bool operator==(const SurfaceFinish& other) const;  // bit for bit; O(samples)

 private:
  PagedArray<FinishMark> m_outer;
  PagedArray<FinishMark> m_bore;  // empty until one is set
};

}  // namespace handwheel
