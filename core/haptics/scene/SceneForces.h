// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"

namespace handwheel {

// Sums the forces and torques of a scene, which is a list of force sources. If the sum would be stiffer than the loop
// allows, the stiffnesses of all sources are reduced by the same factor, so that the direction stays. When a scene
// follows another, each source continues from the source with the same id. The change of the attractions is then
// blended in linearly within kChangeOver, for example when a target is caught or a feature is released.
class SceneForces : public ForceRenderer {
 public:
  // The sources of surfaces must precede the sources that depend on contact with them.
  explicit SceneForces(ForceSources sources) : m_sources(std::move(sources)) {}

  static constexpr double kChangeOver = 0.1;  // s

  void tick(const TipState& tip, ForceOut& out) noexcept override;
  void follow(const ForceRenderer& previous) noexcept override;

  // Returns the source with this id and type, or null if there is none. It is for tests and displays.
  template <class Source>
  const Source* source(std::string_view id) const {
    return dynamic_cast<const Source*>(find(id));
  }

 private:
  // The sum of the attractions in the previous tick, and its excess over the new sum when this scene followed another.
  struct Blend {
    Vec3 last = Vec3::Zero();
    Vec3 gap = Vec3::Zero();
  };
  const ForceSource* find(std::string_view id) const;
  Vec3 blended(Blend& blend, const Vec3& attraction, bool isFirst, double byHand) const;

  ForceSources m_sources;
  bool m_hasTicked = false;
  Blend m_force;           // N
  Blend m_torque;          // N·mm
  double m_gapTime = 0.0;  // s, time until the gaps are zero
  bool m_hasFollowed = false;
};

}  // namespace handwheel
