// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "machining/TurnedProfile.h"

#include <cstdint>

namespace handwheel {

// The finish of the surface at a sample of a profile.
struct FinishMark {
  static constexpr float kDrawn = 3.2f;  // µm Ra of bright drawn steel, the bar before the first cut
  static constexpr float kUnknown = -1.0f;
  static constexpr std::uint32_t kNoPass = 0xffff'ffff;

  float roughness = kDrawn;      // µm Ra; below 0: not known; infinite for an edge without a nose radius
  float feed = 0.0f;             // mm per revolution, feed of the last pass; 0: not known
  std::uint32_t pass = kNoPass;  // index in the part of the pass that removed material last

  // Returns true if a pass has left the surface and its roughness is known.
  bool isKnown() const { return pass != kNoPass && roughness >= 0.0f; }
  bool operator==(const FinishMark&) const = default;
};

// The surface finish along a turned part, outside and in the bore. It has a mark for each sample of its profile. Like
// the copy of a profile, a copy shares its pages with the original.
class SurfaceFinish {
 public:
  // Creates the finish of an uncut bar. samples: the number of samples of the profile.
  explicit SurfaceFinish(std::size_t samples = 0);
  // Returns an unknown finish for all samples of a part.
  static SurfaceFinish unknown(const TurnedProfile& profile);

  std::size_t size() const { return m_outer.size(); }
  FinishMark at(TurningSide side, std::size_t i) const;  // the mark of a bar if there is no such sample
  void set(TurningSide side, std::size_t i, const FinishMark& mark);

  bool operator==(const SurfaceFinish& other) const;  // compares bit for bit; O(samples)

 private:
  PagedArray<FinishMark> m_outer;
  PagedArray<FinishMark> m_bore;  // empty until a mark is set
};

}  // namespace handwheel
