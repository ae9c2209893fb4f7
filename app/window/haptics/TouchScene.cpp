// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/TouchScene.h"

#include "haptics/scene/TouchFidelity.h"
#include "haptics/snap/SnapFidelity.h"
#include "window/haptics/HapticSession.h"

#include <algorithm>

namespace handwheel {

namespace {

// mm at the device: what draws from further, as the edges of a large cube would, is in the way.
constexpr double kFarthestSnap = 5.0;

bool isSame(const ForceTerm& a, const ForceTerm& b) {
  return a.target == b.target && a.stiffness == b.stiffness && a.damping == b.damping;
}

}  // namespace

TouchScene::TouchScene(HapticSession& session, QObject* parent) : QObject(parent), m_session(session) {
  connect(&session, &HapticSession::sceneWanted, this, [this] { publish(true); });
  connect(&session, &HapticSession::touchChanged, this, [this] { publish(true); });
  connect(&session, &HapticSession::viewChanged, this, [this] { publish(false); });
}

void TouchScene::setSurface(std::optional<ContactSurface> surface, bool isEdit) {
  if (!surface && !m_surface) return;
  m_surface = std::move(surface);
  publish(!isEdit);
}

void TouchScene::setSnap(std::optional<SnapField> field, double distance, bool isEdit) {
  if (!field && !m_snap) return;
  m_snap = std::move(field);
  m_snapDistance = distance;
  publish(!isEdit);
}

// Neither needs the ramp, which would take the surface away, too: the scene changes over by itself.
void TouchScene::setHolding(bool isHolding) {
  if (std::exchange(m_isHolding, isHolding) != isHolding && m_snap) publish(false);
}

void TouchScene::setSprings(const std::vector<ForceTerm>& terms) {
  if (std::equal(terms.begin(), terms.end(), m_terms.begin(), m_terms.end(), isSame)) return;
  m_terms = terms;
  publish(false);
}

void TouchScene::setFidelity(const FidelityValues& values) {
  const double tolerance = contactOptions(values).tolerance;
  const auto most = static_cast<std::size_t>(values.of(snapFeaturesSetting()));
  if (tolerance == m_contact.tolerance && most == m_mostFeatures) return;
  m_contact.tolerance = tolerance;
  m_mostFeatures = most;
  if (m_surface || m_snap) publish(true);
}

// Stiffnesses are those at the hand: what would be soft in a view from afar is as stiff as in one from near.
void TouchScene::publish(bool isDiscontinuous) {
  if (!m_session.isOpen()) return;
  const WorkspaceMapping mapping = m_session.mappingInScene();
  const TouchSettings& touch = m_session.touch();
  SceneHaptics feel;
  if (m_surface) {
    feel.surface = SurfaceFeel{*m_surface, mapping.sceneStiffness(touch.stiffness),
                               mapping.sceneStiffness(touch.damping), m_contact};
    feel.surface->contact.friction = touch.friction;
  }
  if (m_snap && !m_isHolding) {
    const SnapProfile profile(touch.snapShape, mapping.sceneStiffness(touch.snapStiffness),
                              std::min(m_snapDistance, kFarthestSnap * mapping.scale));
    feel.snap = SnapFeel{*m_snap, profile, touch.snapMethod, m_mostFeatures};
  }
  feel.comesFrom = m_session.camera().towardsViewer();
  for (const ForceTerm& term : m_terms) {
    feel.springs.push_back({term.target, mapping.sceneStiffness(term.stiffness), mapping.sceneStiffness(term.damping)});
  }
  auto scene = std::make_unique<HapticScene>();
  scene->source = std::make_unique<SceneForces>(std::move(feel));
  scene->isDiscontinuous = isDiscontinuous;
  m_session.setScene(std::move(scene));
}

}  // namespace handwheel
