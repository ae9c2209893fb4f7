// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/GodObject.h"
#include "haptics/servo/ForceSource.h"
#include "haptics/snap/SnapProxy.h"
#include "haptics/snap/SnapSum.h"

#include <optional>
#include <vector>

namespace handwheel {

// A touchable surface with its contact parameters.
struct SurfaceFeel {
  ContactSurface surface;
  double stiffness = 0.5;  // N/mm: fidelity setting contact.stiffness
  double damping = 0.0;    // N·s/mm, along the normal
  ContactOptions contact;
};

// How snap forces are computed: by SnapProxy or by SnapSum.
enum class SnapMethod { Proxy, Sum };

// Snap features that attract the tip, with force profile and method. By the proxy method, facets attract only as long
// as the surface is not touched.
struct SnapFeel {
  SnapField field;
  SnapProfile profile;
  SnapMethod method = SnapMethod::Proxy;
  std::size_t most = SnapSum::kMost;  // features that act at once by the sum method
};

// A spring and damper between the tip and a point. A tool requests it (He 2008, section 4.1.4).
struct SpringFeel {
  Vec3 target = Vec3::Zero();  // mm
  double stiffness = 0.0;      // N/mm
  double damping = 0.0;        // N·s/mm
};

// All haptic content of a scene: surface, snap features and springs. What is absent costs nothing.
struct SceneHaptics {
  std::optional<SurfaceFeel> surface;
  std::optional<SnapFeel> snap;
  std::vector<SpringFeel> springs;
  // The direction (unit length, towards the viewer) from which the tip is assumed to approach when it appears, or when
  // a surface appears. So it rests on the surface that is visible there, not inside the solid. Zero: it appears where
  // it is.
  Vec3 comesFrom = Vec3::Zero();
};

// Sums the contact, snap and spring forces of a scene. If the sum would be stiffer than the loop allows, all springs
// are softened by the same factor, so that the direction stays. A successor continues from the feature that was held
// and, on the same surface, from its proxy, moved outside if an edit has covered it. The change of the forces of
// springs and features is then blended in linearly within kChangeOver: for example a target that is caught, or a
// feature that is released.
class SceneForces : public ForceSource {
 public:
  explicit SceneForces(SceneHaptics feel);

  static constexpr double kChangeOver = 0.1;  // s

  void tick(const TipState& tip, ForceOut& out) noexcept override;
  void follow(const ForceSource& previous) noexcept override;

  const Contact& contact() const { return m_god.contact(); }
  const SnapResult& pull() const { return m_pull; }

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

  SceneHaptics m_feel;
  GodObject m_god;
  SnapProxy m_snapProxy;
  SnapSum m_snapSum;
  SnapResult m_pull;
  bool m_isPlaced = false;
  // The force of springs and features, N: in the previous tick, and the excess when this scene followed another.
  Vec3 m_pulled = Vec3::Zero();
  Vec3 m_gap = Vec3::Zero();
  double m_gapTime = 0.0;  // s until it is none
  bool m_hasFollowed = false;
};

}  // namespace handwheel
