// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/lathe/RoundedPolygon.h"

namespace handwheel {

// The material that a cut removes.
struct RemovedMaterial {
  TurnedProfile::Range changed;
  double area = 0.0;    // mm², in the half plane through the axis
  double volume = 0.0;  // mm³
  double depth = 0.0;   // mm, the largest change of a radius
  double beyond = 0.0;  // mm: how far what leaves reaches past all of the section, where there is no edge

  bool isEmpty() const { return changed.isEmpty(); }
  void add(const RemovedMaterial& other);
  double meanRadius() const { return area > 0.0 ? volume / (2.0 * M_PI * area) : 0.0; }  // mm, by Pappus
};

// The samples of a profile from z = first to last. O(1).
TurnedProfile::Range samplesWithin(const TurnedProfile& profile, double first, double last);

// Removes what the sweep covers, and all that is on that side of it. O(samples under the sweep).
RemovedMaterial cutSection(TurnedProfile& profile, const SectionSweep& sweep, TurningSide side);

// What cutSection() would remove.
RemovedMaterial previewCut(const TurnedProfile& profile, const SectionSweep& sweep, TurningSide side);

// How deep a sweep is in material where it must not be, as a holder or a jaw. At most 0: it is not. The material lies
// on both sides of the axis, as the part turns. within: mm, a radius that no material exceeds. O(samples under the
// sweep), O(1) beyond that radius.
struct SectionOverlap {
  double depth = 0.0;        // mm: how far in r, at most to the other side of the material
  ProfilePoint place{0, 0};  // where it is deepest, (r, z)
};
SectionOverlap overlapOf(const TurnedProfile& profile, const SectionSweep& sweep, double within);

// How far two convex sections are apart, at least; 0 where they meet. mm. O(corners of one × those of the other).
double distanceBetween(const RoundedPolygon& a, const RoundedPolygon& b);

}  // namespace handwheel
