// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"
#include "machining/thread/PartThreads.h"

#include <cstddef>
#include <deque>

namespace handwheel {

// What the edge of a threading tool takes that the grooves before have left.
struct ThreadChip {
  double section = 0.0;  // mm², in the half plane through the axis
  double radius = 0.0;   // mm, of its middle
  double edge = 0.0;     // mm, of the edge that is in the material
  double depth = 0.0;    // mm, the largest change of a radius
};

// The thread grooves of a part while one more is being cut. They are those that it had, and what has been cut since.
// The profile, which is the envelope, does not know them. One thread.
class ThreadsBeingCut {
 public:
  static constexpr std::size_t kMostHelices = 64;  // that are known since the work began; the oldest is forgotten

  explicit ThreadsBeingCut(std::shared_ptr<const PartThreads> threads = nullptr) : m_threads(std::move(threads)) {}

  // Where a tool is in a part: its tip in the half plane of this angle about the axis.
  struct Place {
    ProfilePoint tip{0.0, 0.0};
    double angle = 0.0;  // radian
  };
  // What it would take there. stands: the part does not turn, and the tool has come from this tip, which has room
  // already. O(grooves).
  ThreadChip chipAt(const TurnedProfile& part, const LatheTool& tool, const Place& place,
                    const ProfilePoint* stands = nullptr) const;

  // Takes it, on a helix that the tool follows from its tip at z = from (mm) to the place. The areas of the cut are
  // those of the section on its way about the axis, so that volume = 2π r · area; the edge is that of its last chip.
  struct Cut {
    RemovedMaterial removed;
    double edge = 0.0;  // mm
  };
  Cut cut(const TurnedProfile& part, const LatheTool& tool, const ThreadCut& thread, double from, const Place& place);

 private:
  // A groove by its bottom at each sample that the tool has passed.
  struct Helix {
    ThreadCut thread;
    TurningSide side;
    double nose;  // mm
    ThreadEdge edge;
    std::ptrdiff_t beyond;        // samples before and behind the part, where its flanks still reach that
    std::vector<double> bottoms;  // mm, radius; infinite, in a bore 0, where it did not come

    // That nearest to a height; null: it is too far from the part.
    double* at(double z, double spacing);
    const double* at(double z, double spacing) const { return const_cast<Helix*>(this)->at(z, spacing); }
  };
  Helix& helixOf(const TurnedProfile& part, const LatheTool& tool, const ThreadCut& thread);
  double surfaceAt(const TurnedProfile& part, TurningSide side, double z, double angle) const;

  std::shared_ptr<const PartThreads> m_threads;  // null: none
  std::deque<Helix> m_helices;
};

}  // namespace handwheel
