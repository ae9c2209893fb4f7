// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/GrindingContact.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace handwheel {

namespace {

constexpr GrindingHold kInSlide{500.0, 1.0, 500.0}, kInHand{20.0, 0.2, 60.0};

// Returns the height of the side that the tool works on, with the material below: r outside, -r in the bore.
double heightOf(const TurnedProfile& profile, TurningSide side, std::size_t i) {
  return side == TurningSide::Outside ? profile.radius(i) : -profile.inner(i);
}

// Returns the depth of the tool in the piece between two samples along r, at its middle.
double radialDepth(const TurnedProfile& profile, TurningSide side, const std::vector<SectionSweep>& tool,
                   std::size_t i) {
  const double z = 0.5 * (profile.z(i) + profile.z(i + 1));
  const double height = 0.5 * (heightOf(profile, side, i) + heightOf(profile, side, i + 1));
  double deepest = 0.0;
  for (const SectionSweep& section : tool) {
    if (z < section.first() || z > section.last()) continue;
    const double edge = side == TurningSide::Outside ? section.lowest(z) : -section.highest(z);
    deepest = std::max(deepest, height - edge);
  }
  return deepest;
}

}  // namespace

GrindingContact grindingContact(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& tip) {
  TurnedProfile::Range below;
  std::vector<SectionSweep> sections;
  for (const RoundedPolygon& section : tool.cutting) {
    sections.emplace_back(section, tip, tip);
    if (sections.back().empty()) return {};
    below.extend(samplesWithin(profile, sections.back().first(), sections.back().last()));
  }
  double sum = 0.0;
  std::size_t count = 0;
  ProfilePoint normals(0.0, 0.0);
  for (std::size_t i = below.first; i + 1 < below.last; ++i) {
    if (!profile.hasMaterial(i) || !profile.hasMaterial(i + 1)) continue;
    const double depth = radialDepth(profile, tool.side, sections, i);
    if (!(depth > 0.0)) continue;
    const double rise = heightOf(profile, tool.side, i + 1) - heightOf(profile, tool.side, i);
    const ProfilePoint normal = ProfilePoint(profile.spacing(), -rise).normalized();
    sum += depth * normal.x();  // sin α: the angle between the depth, which is along r, and the surface
    normals += normal;
    ++count;
  }
  if (count == 0) return {};
  normals.normalize();
  if (tool.side == TurningSide::Bore) normals.x() = -normals.x();
  return {sum / static_cast<double>(count), normals};
}

double pressedDepth(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                    const ProfilePoint& to) {
  double deepest = 0.0;
  for (const RoundedPolygon& section : tool.cutting) {
    const SectionSweep sweep(section, from, to);
    if (sweep.empty()) continue;
    const TurnedProfile::Range below = samplesWithin(profile, sweep.first(), sweep.last());
    for (std::size_t i = below.first; i < below.last; ++i) {
      const double z = profile.z(i), low = sweep.lowest(z), high = sweep.highest(z);
      if (!profile.hasMaterial(i) || !(low < profile.radius(i) && high > profile.inner(i))) continue;
      deepest =
          std::max(deepest, tool.side == TurningSide::Outside ? profile.radius(i) - low : high - profile.inner(i));
    }
  }
  return deepest;
}

GrindingHold holdOf(const LatheTool& tool) {
  return tool.kind == LatheToolKind::GrindingDisk ? kInSlide : kInHand;
}

double grindingForce(const GrindingContact& contact, const GrindingHold& hold, const ProfilePoint& velocity) {
  if (contact.isEmpty() || !velocity.allFinite()) return 0.0;
  return std::clamp(hold.stiffness * contact.depth - hold.damping * velocity.dot(contact.normal), 0.0, hold.most);
}

}  // namespace handwheel
