// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/thread/PartThreads.h"
#include "mesh/structure/TriangleSoup.h"

#include <memory>
#include <vector>

namespace handwheel {

// The triangles of a turned part, in blocks along the axis. They show outside and bore while the part is cut. A version
// shares the blocks that did not change with the one before. Neighbouring blocks end in the same ring of points, so
// that there is no gap.
class TurnedSurface {
 public:
  static constexpr std::size_t kBlockSamples = 256;

  // chord: mm, tolerance of the triangles. threads: null for none.
  TurnedSurface(const TurnedProfile& profile, double chord, std::shared_ptr<const PartThreads> threads = {});

  // Rebuilds the blocks with these samples. O(changed samples).
  void update(const TurnedProfile& profile, const TurnedProfile::Range& changed);
  // The same with threads that changed in these samples.
  void setThreads(const TurnedProfile& profile, std::shared_ptr<const PartThreads> threads,
                  const TurnedProfile::Range& changed);
  const std::shared_ptr<const PartThreads>& threads() const { return m_threads; }  // null: none

  // Returns the blocks from the lower end to the upper. The first and the last include the flat ends of the part.
  const std::vector<std::shared_ptr<const TriangleSoup>>& blocks() const { return m_blocks; }

 private:
  std::shared_ptr<const TriangleSoup> build(const TurnedProfile& profile, std::size_t block) const;

  double m_chord;
  std::shared_ptr<const PartThreads> m_threads;
  std::shared_ptr<const std::vector<ProfilePoint>> m_circle;  // points of each ring at radius 1, as (x, y)
  std::vector<std::shared_ptr<const TriangleSoup>> m_blocks;
};

}  // namespace handwheel
