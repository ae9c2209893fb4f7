// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "globe/document/GlobeSurface.h"
#include "haptics/scene/ForceSource.h"
#include "simulation/Simulation.h"

#include <array>
#include <optional>

namespace handwheel::test {

// The points of a globe near the tip. The servo loop knows no other points of a globe that is being dented; the
// simulation updates them.
struct GlobePatch {
  static constexpr std::size_t kMost = 256;
  static constexpr double kChord = 2.0 * kGlobeReach;  // chord of the unit sphere

  Vec3 centre = Vec3::Zero();  // direction around which the points lie
  double radius = 0.0;         // mm
  std::size_t count = 0;
  std::array<std::uint32_t, kMost> numbers{};
  std::array<double, kMost> dents{};

  // Returns the height of the surface in the direction of p, or nothing if p is too far from the centre of the patch.
  std::optional<double> heightTowards(const Vec3& p) const;
};

GlobePatch patchAround(const GlobeSurface& surface, const Vec3& p);

using DentChannel = SimulationChannel<GlobePatch>;

inline constexpr const char* kGlobeSource = "globe";

// The contact force of a globe. It is a spring from the tip to the surface above it.
class GlobeForce : public ForceSource {
 public:
  // pose: the pose of the globe in the scene. stiffness: N/mm in the scene. channel: the channel of the simulation that
  // changes the surface; null: there is none.
  GlobeForce(GlobeSurface surface, const Pose& pose, double stiffness, std::shared_ptr<DentChannel> channel);

  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;

 private:
  GlobeSurface m_surface;
  Pose m_pose;
  double m_stiffness;
  std::shared_ptr<DentChannel> m_channel;
  Vec3 m_proxy = Vec3::Zero();
  bool m_isTouching = false;
};

}  // namespace handwheel::test
