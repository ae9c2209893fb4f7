// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ForceSource.h"
#include "haptics/GodObject.h"
#include "haptics/SnapProxy.h"
#include "haptics/SnapSum.h"

#include <optional>
#include <vector>

namespace handwheel {

// A surface that can be touched, and how it feels.
struct SurfaceFeel {
  ContactSurface surface;
  double stiffness = 0.5;  // N/mm: fidelity setting contact.stiffness
  double damping = 0.0;    // N·s/mm, along the normal
  ContactOptions contact;
};

enum class SnapMethod { Proxy, Sum };

// Features that draw the tip to them; by the proxy method, facets only as long as the surface is not touched.
struct SnapFeel {
  SnapField field;
  SnapProfile profile;
  SnapMethod method = SnapMethod::Proxy;
  std::size_t most = SnapSum::kMost;  // features that pull at once by the sum
};

// A spring and damper between the tip and a place, as a tool asks for it (He 2008, section 4.1.4).
struct SpringFeel {
  Vec3 target = Vec3::Zero();  // mm
  double stiffness = 0.0;      // N/mm
  double damping = 0.0;        // N·s/mm
};

// Everything that can be felt in a scene; what is absent costs nothing.
struct SceneFeel {
  std::optional<SurfaceFeel> surface;
  std::optional<SnapFeel> snap;
  std::vector<SpringFeel> springs;
  // From where a tip comes that appears anew, or to which a surface appears: a direction of length 1, towards the
  // viewer. It comes to rest on the surface that is seen there, and not within what is solid. Zero: it appears where it
  // is.
  Vec3 comesFrom = Vec3::Zero();
};

// The sum of the forces of a scene. Where it would be stiffer than the loop can carry, all of its springs are softened
// alike, so that its direction stays. One that follows another goes on from the feature that was held and, on the same
// surface, from its proxy, lifted where an edit has buried it. What springs and features then pull otherwise than
// before comes within kChangeOver, in proportion to time: a target that is caught, a feature that is let go.
class SceneForces : public ForceSource {
 public:
  explicit SceneForces(SceneFeel feel);

  static constexpr double kChangeOver = 0.1;  // s

  void tick(const TipState& tip, ForceOut& out) noexcept override;
  void follow(const ForceSource& previous) noexcept override;

  const Contact& contact() const { return m_god.contact(); }
  const SnapPull& pull() const { return m_pull; }

 private:
  void touch(const TipState& tip);
  Vec3 entryOf(const Vec3& tip) const;
  void snap(const TipState& tip);
  bool isHeldBy(SnapKind kind) const;
  double slope() const;
  double pullSlope() const;
  double springDamping() const;
  Vec3 springForce(const Vec3& tip) const;
  Vec3 changedOver(const Vec3& pulled, double slope, const TipState& tip);

  SceneFeel m_feel;
  GodObject m_god;
  SnapProxy m_snapProxy;
  SnapSum m_snapSum;
  SnapPull m_pull;
  bool m_isPlaced = false;
  // What springs and features pull, N: in the tick before, and how much more that was when this scene followed another.
  Vec3 m_pulled = Vec3::Zero();
  Vec3 m_gap = Vec3::Zero();
  double m_gapTime = 0.0;  // s until it is none
  bool m_hasFollowed = false;
};

}  // namespace handwheel
