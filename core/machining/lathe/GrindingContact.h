// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"

namespace handwheel {

// The mean depth of an abrasive tool in a part. It is averaged over the contact surface (He 2008, section 5.1.1.1).
struct GrindingContact {
  double depth = 0.0;         // mm, mean depth along the normals (He 2008, eq. 5-1 and 5-2); 0: no contact
  ProfilePoint normal{0, 0};  // unit vector, mean of the normals out of the material (He 2008, eq. 5-4), (r, z)
  bool isEmpty() const { return !(depth > 0.0); }
};

// Returns the contact of a tool whose tip is at this point. Each piece of the surface between two samples below the
// tool contributes to the contact. O(samples below the tool).
GrindingContact grindingContact(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& tip);

// Returns the depth (mm along r, from the surface on the side of the tool) that a tool would reach if its tip moved
// straight between two positions. Unlike the depth of a cut, which is at most the thickness of the work, it also counts
// the travel beyond the axis. 0: no contact. O(samples below the tool).
double pressedDepth(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                    const ProfilePoint& to);

// The stiffness and the largest force with which a tool is held. A slide holds a disk; a hand holds a file or paper.
struct GrindingHold {
  double stiffness = 0.0;  // N/mm
  double damping = 0.0;    // N·s/mm
  double most = 0.0;       // N
  // Returns the depth at the largest force, mm. A hand or a slide cannot press the tool deeper.
  double deepest() const { return stiffness > 0.0 ? most / stiffness : 0.0; }
};
GrindingHold holdOf(const LatheTool& tool);

// Returns the force (N) that pushes the tool out of the material along the mean normal. F = k d − ζ V (He 2008, eq.
// 5-3), where k, ζ and d are the stiffness, the damping and the depth, and V is the speed of the tool out of the
// material. The force never pulls, and never exceeds the largest force of the hold. velocity: the velocity of the tool,
// mm/s.
double grindingForce(const GrindingContact& contact, const GrindingHold& hold, const ProfilePoint& velocity);

// Friction along the motion of the surface, as a fraction of grindingForce(); a usual value between abrasives and metal
inline constexpr double kGrindingFriction = 0.4;

}  // namespace handwheel
