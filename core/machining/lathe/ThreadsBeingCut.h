// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"
#include "machining/thread/PartThreads.h"

#include <cstddef>
#include <deque>

namespace handwheel {

// The chip that a threading tool cuts in addition to the existing grooves.
struct ThreadChip {
  double section = 0.0;  // mm², section in the half plane through the axis
  double radius = 0.0;   // mm, mean radius
  double edge = 0.0;     // mm, length of the edge in the material
  double depth = 0.0;    // mm, the largest change of a radius
};

// The thread grooves of a part while one more is being cut. They are the grooves that the part had, and the grooves
// that were cut since. The profile, which is the envelope, does not contain them. An object may be used by one thread
// at a time.
class ThreadsBeingCut {
 public:
  static constexpr std::size_t kMostHelices = 64;  // largest number of new helices; the oldest is forgotten

  explicit ThreadsBeingCut(std::shared_ptr<const PartThreads> threads = nullptr) : m_threads(std::move(threads)) {}

  // The position of a tool in a part: its tip, in the half plane of this angle about the axis.
  struct ToolPosition {
    ProfilePoint tip{0.0, 0.0};
    double angle = 0.0;  // rad
  };
  // Returns the chip that a tool would take at this position. stands: null if the part turns. If the part is at rest,
  // the position from which the tip comes, which must be free of material. O(grooves).
  ThreadChip chipAt(const TurnedProfile& part, const LatheTool& tool, const ToolPosition& position,
                    const ProfilePoint* stands = nullptr) const;

  // Cuts along the helix that the tip follows from z = from (mm) to the position. The removed areas are areas of the
  // half section, so that volume = 2π r · area. The edge of the result is the edge of the last chip.
  struct Cut {
    RemovedMaterial removed;
    double edge = 0.0;  // mm
  };
  Cut cut(const TurnedProfile& part, const LatheTool& tool, const ThreadCut& thread, double from,
          const ToolPosition& position);

 private:
  // A groove, stored as its bottom at each sample that the tool has passed.
  struct Helix {
    ThreadCut thread;
    TurningSide side;
    double nose;  // mm
    ThreadEdge edge;
    std::ptrdiff_t beyond;        // number of samples beyond each end of the part at which flanks still reach the part
    std::vector<double> bottoms;  // mm, radius; infinite (in a bore 0) where the tool did not cut

    // Returns the bottom nearest to a height, or null if the height is too far from the part.
    double* at(double z, double spacing);
    const double* at(double z, double spacing) const { return const_cast<Helix*>(this)->at(z, spacing); }
  };
  Helix& helixOf(const TurnedProfile& part, const LatheTool& tool, const ThreadCut& thread);
  double surfaceAt(const TurnedProfile& part, TurningSide side, double z, double angle) const;

  std::shared_ptr<const PartThreads> m_threads;  // null: none
  std::deque<Helix> m_helices;
};

}  // namespace handwheel
