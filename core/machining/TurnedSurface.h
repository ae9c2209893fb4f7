// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/thread/PartThreads.h"
#include "mesh/structure/TriangleSoup.h"

#include <memory>
#include <vector>

namespace handwheel {

// The triangles of a turned part, in blocks along the axis. They show the outside and the bore while the part is cut. A
// copy and the original share the blocks that neither has changed. Neighbouring blocks end in the same ring of points,
// so that there is no gap.
class TurnedSurface {
 public:
  static constexpr std::size_t kBlockSamples = 256;

  // chord: the largest distance of the triangles from the surface, mm. threads: the threads of the part; null for none.
  TurnedSurface(const TurnedProfile& profile, double chord, std::shared_ptr<const PartThreads> threads = {});

  // Rebuilds the blocks that contain the changed samples. O(changed samples).
  void update(const TurnedProfile& profile, const TurnedProfile::Range& changed);
  // Sets the threads of the part and rebuilds the blocks that contain the changed samples.
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
