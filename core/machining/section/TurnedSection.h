// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/section/SharedLoop.h"

#include <functional>
#include <limits>

namespace handwheel {

// The area that a tool sweeps: a simple closed loop, counter-clockwise. `grown`: mm, an offset by which the area may be
// enlarged to leave a degenerate position.
using SectionCutter = std::function<SectionLoop(double grown)>;

// The part of a section that a cut removed.
struct SectionRemoval {
  double area = 0.0;    // mm²
  double volume = 0.0;  // mm³
  ProfileBox box;       // bounds of the removed area; empty if nothing was removed
  ProfileBox gone;      // bounds of it and of the chips that fell off

  bool isEmpty() const { return box.isEmpty(); }
  void add(const SectionRemoval& other);
};

// The exact half section of a turned part, a region bounded by lines and arcs.
//
// The region lies at r ≥ 0 and includes its pieces on the axis. Its boundary consists of closed loops with the material
// on their left: a counter-clockwise loop encloses a piece of the part, a clockwise one a hollow in it. Each segment
// knows the pass that made it. A cut is exact to 1e-6 mm.
class TurnedSection {
 public:
  static constexpr std::size_t kMostSegments = 200'000;

  TurnedSection() = default;
  // Creates the section of an uncut bar, whose lower end is at z = 0.
  explicit TurnedSection(const StockCylinder& stock);
  // Creates a section with these boundary loops, which must be as described above.
  explicit TurnedSection(const std::vector<SectionLoop>& loops);

  const std::vector<SharedLoop>& loops() const { return m_loops; }
  bool empty() const { return m_loops.empty(); }
  std::size_t size() const;  // number of segments
  // Calls visit(segment) with each segment whose run meets a box, and others of these runs.
  template <class Visit>
  void eachSegment(const ProfileBox& box, Visit visit) const {
    for (const SharedLoop& loop : m_loops) {
      for (const SectionRun::Pointer& run : loop.runs()) {
        if (!run->box.intersects(box)) continue;
        for (const SectionSegment& segment : run->segments) visit(segment);
      }
    }
  }
  double area() const;    // mm²
  double volume() const;  // mm³
  const ProfileBox& box() const { return m_box; }

  // Returns the pieces of a part that was parted off, each with its hollows, from the one in the chuck to the free end.
  std::vector<TurnedSection> pieces() const;

  // Subtracts the area of a cutter and marks the new boundary with the number of the pass. Pieces of the section that
  // the cut separates from the rest fall off, as chips do, if they lie within the heights of the cutter and are not
  // higher than the tool. Returns nothing, and leaves the section as it was, if the result is not sound for any small
  // offset of the cutter. isOfTrailingEdge: marks the new boundary, as in SectionSegment. toolHeight: mm. O(runs + k m)
  // for the k segments that meet the box of a cutter with m segments.
  std::optional<SectionRemoval> subtract(const SectionCutter& cutter, std::uint32_t pass, bool isOfTrailingEdge = false,
                                         double toolHeight = std::numeric_limits<double>::infinity());

  bool contains(const ProfilePoint& p) const;

  // The outer and inner radii at a height. If the height is that of a face, the material on both sides counts only as
  // far as both have it. Nothing if there is no material. O(runs + segments of the runs at the height).
  struct Radii {
    double inner = 0.0, outer = 0.0;  // mm
  };
  std::optional<Radii> radiiAt(double z) const;

  // Returns the heights at which the boundary crosses a radius (mm), in no order. O(segments).
  std::vector<double> heightsAt(double radius) const;

  // Sets samples of a profile to the radii of the section. The profile must be that of the same bar. Returns the
  // samples that changed. O(segments + samples).
  TurnedProfile::Range sample(TurnedProfile& profile, const TurnedProfile::Range& range) const;

 private:
  explicit TurnedSection(std::vector<SharedLoop> loops);
  void findBox();
  bool subtractOnce(const SectionLoop& cutter, double toolHeight, SectionRemoval& removal);
  // Returns the bounds of the chips.
  ProfileBox dropChips(std::size_t unchanged, const ProfileBox& cutter, double toolHeight);

  std::vector<SharedLoop> m_loops;
  ProfileBox m_box;
};

}  // namespace handwheel
