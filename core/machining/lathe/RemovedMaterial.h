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
  // mm, largest distance in r by which the removed material extends beyond all of the tool, where it has no edge
  double beyond = 0.0;

  bool isEmpty() const { return changed.isEmpty(); }
  void add(const RemovedMaterial& other);
  double meanRadius() const { return area > 0.0 ? volume / (2.0 * M_PI * area) : 0.0; }  // mm, by Pappus
};

// Returns the samples of a profile from z = first to last. O(1).
TurnedProfile::Range samplesWithin(const TurnedProfile& profile, double first, double last);

// Removes the material that the sweep covers, and all material behind it on the given side. O(samples under the sweep).
RemovedMaterial cutSection(TurnedProfile& profile, const SectionSweep& sweep, TurningSide side);

// Returns the material that cutSection() would remove.
RemovedMaterial previewCut(const TurnedProfile& profile, const SectionSweep& sweep, TurningSide side);

// The overlap of a sweep with material in which it must not be, such as that of a holder with the part.
struct SectionOverlap {
  double depth = 0.0;           // mm, along r; at most the thickness of the material; 0 or less: no overlap
  ProfilePoint position{0, 0};  // position of the largest depth, (r, z)
};

// Returns the overlap of a sweep with the material of a profile. The material lies on both sides of the axis, since the
// part turns. within: mm, a radius that no material exceeds. O(samples under the sweep), O(1) beyond that radius.
SectionOverlap overlapOf(const TurnedProfile& profile, const SectionSweep& sweep, double within);

// Returns the least distance of two convex sections, mm; 0 if they meet. O(corners of one × those of the other).
double distanceBetween(const RoundedPolygon& a, const RoundedPolygon& b);

}  // namespace handwheel
