// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/SnapProxy.h"

#include <limits>

namespace handwheel {
namespace {

// Features that a proxy passes in one tick: more follow in the next. A bound of a tick, not a fidelity setting: each is
// passed exactly, so the proxy is late, but not wrong.
constexpr int kMostHops = 8;

}  // namespace

SnapResult SnapProxy::step(const SnapField& field, const SnapProfile& profile, const Vec3& hand) {
  SnapResult pull;
  pull.proxy = hand;
  pull.distance = profile.distance();
  if (!hand.allFinite()) return pull;
  const Vec3 proxy = m_isHeld ? m_proxy : hand;
  SnapLayer::Reach reach{hand - field.origin(), proxy - field.origin(), profile.distance()};
  reach.fromProxy = std::numeric_limits<double>::infinity();
  // The proxy's own coordinates are rounded, in the scene.
  reach.tie = kQueryRounding * (proxy.cwiseAbs().maxCoeff() + field.origin().cwiseAbs().maxCoeff() + reach.distance);
  reach.held = m_held;

  Hold hold;
  if (profile.distance() > 0.0) hold = capture(field, reach);
  m_isHeld = hold.item != kNone;
  if (!m_isHeld) return pull;
  hold = slide(field.layer(m_dimension), reach, hold);
  hold = descend(field, reach, hold);
  m_held = field.layer(m_dimension).item(hold.item).feature;
  m_proxy = pull.proxy = hold.point + field.origin();

  pull.isCutShort = hold.isCutShort;
  pull.slope = profile.largestSlope();
  pull.features[0] = m_held;
  pull.featureCount = 1;
  const double force = profile.force(hold.handDistance);
  if (force > 0.0) pull.force = (force / hold.handDistance) * (hold.point - reach.hand);
  return pull;
}

// Returns the held feature, at the proxy, while it is in reach of the hand; else the one closest to the proxy, of the
// highest dimension in reach.
SnapLayer::Hold SnapProxy::capture(const SnapField& field, const SnapLayer::Reach& reach) {
  if (m_isHeld) {
    SnapLayer::Reach here = reach;
    here.fromProxy = reach.tie;
    if (const Hold hold = field.layer(m_dimension).nearest(here); hold.item != kNone) return hold;
    // The hand may have left the segment of a curve that held it, and not yet the curve.
    here = reach;
    here.onlyHeld = true;
    const bool isCurve = m_held.kind == SnapKind::Curve;
    if (const Hold hold = isCurve ? field.layer(1).nearest(here) : Hold(); hold.item != kNone) return hold;
  }
  for (std::size_t d = SnapField::kDimensions; d-- > 0;) {
    const Hold hold = field.layer(d).nearest(reach);
    if (hold.item == kNone) continue;
    m_dimension = d;
    return hold;
  }
  return {};
}

// Goes on to neighbours as long as they are closer to the hand. A curve of very short segments is passed in one stride.
SnapLayer::Hold SnapProxy::slide(const SnapLayer& layer, SnapLayer::Reach reach, Hold hold) const {
  for (int hop = 0; hop < kMostHops; ++hop) {
    reach.proxy = hold.point;
    reach.held = layer.item(hold.item).feature;
    const Hold next = layer.nearest(reach);
    if (next.item == kNone || !(next.handDistance < hold.handDistance - reach.tie)) return hold;
    hold = next;
  }
  reach.held = layer.item(hold.item).feature;
  if (reach.held.kind != SnapKind::Curve) return hold;
  reach.onlyHeld = true;
  reach.proxy = reach.hand;
  return layer.nearest(reach);
}

// Goes to features of a lower dimension near the proxy, and on from there.
SnapLayer::Hold SnapProxy::descend(const SnapField& field, SnapLayer::Reach reach, Hold hold) {
  for (std::size_t d = m_dimension; d-- > 0;) {
    reach.proxy = hold.point;
    reach.fromProxy = reach.distance;
    const Hold lower = field.layer(d).nearest(reach);
    if (lower.item == kNone) continue;
    hold = lower;
    m_dimension = d;
  }
  return hold;
}

}  // namespace handwheel
