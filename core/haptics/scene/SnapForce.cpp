// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/SnapForce.h"

namespace handwheel {

SnapForce::SnapForce(std::string id, SnapAttraction attraction)
    : ForceSource(std::move(id)), m_attraction(std::move(attraction)), m_sum(m_attraction.most) {}

void SnapForce::follow(const ForceSource& previous) noexcept {
  if (const auto* other = dynamic_cast<const SnapForce*>(&previous)) m_proxy = other->m_proxy;
}

ForceBounds SnapForce::advance(const TipState& tip, ForceOut& out) noexcept {
  if (tip.isRestart) m_proxy.release();
  const SnapAttraction& by = m_attraction;
  m_pull = by.method == SnapMethod::Proxy ? m_proxy.step(by.field, by.profile, tip.position)
                                          : m_sum.step(by.field, by.profile, tip.position);
  if (by.method == SnapMethod::Proxy) {
    // On a surface that is touched, the snap force is left out: it would make the surface harder than intended. The
    // force stays continuous: where the tip meets the surface, the snap force is zero.
    if (isHeldBy(SnapKind::Facet) && out.isContact) {
      m_pull.force.setZero();
      m_pull.slope = 0.0;
    }
    out.isHeld = isHeldBy(SnapKind::Point) || isHeldBy(SnapKind::Segment);
    out.held = m_pull.proxy;
  }
  if (!out.isContact) out.proxy = m_pull.proxy;
  return {m_pull.slope, 0.0};
}

Vec3 SnapForce::force(const TipState&, double stiffness, double) noexcept {
  return stiffness * m_pull.force;
}

bool SnapForce::isHeldBy(SnapKind kind) const {
  return m_pull.featureCount > 0 && m_pull.features[0].kind == kind;
}

}  // namespace handwheel
