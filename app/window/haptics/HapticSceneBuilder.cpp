// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/HapticSceneBuilder.h"

#include "haptics/scene/SceneForces.h"
#include "haptics/scene/TouchFidelity.h"
#include "haptics/snap/SnapFidelity.h"
#include "window/haptics/HapticSession.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <limits>

namespace handwheel {

namespace {

// mm at the device: an attraction from further away, such as by the edges of a large cube, would be in the way.
constexpr double kFarthestSnap = 5.0;

bool isSameSpring(const DeviceSpring& a, const DeviceSpring& b) {
  return a.target == b.target && a.stiffness == b.stiffness && a.damping == b.damping &&
         a.turn.coeffs() == b.turn.coeffs() && a.turning == b.turning;
}

}  // namespace

HapticSceneBuilder::HapticSceneBuilder(HapticSession& session, QObject* parent) : QObject(parent), m_session(session) {
  connect(&session, &HapticSession::sceneRequested, this, [this] { publish(true); });
  connect(&session, &HapticSession::touchChanged, this, [this] { publish(true); });
  connect(&session, &HapticSession::viewChanged, this, [this] { publish(false); });
  // The first scene of a recording is noted, too: when all who describe it know that one has begun.
  connect(
      &session, &HapticSession::recordingStarted, this, [this] { publish(false); }, Qt::QueuedConnection);
}

bool HapticSceneBuilder::has(const std::string& id) const {
  return std::any_of(m_sources.begin(), m_sources.end(), [&](const auto& source) { return source.first == id; });
}

void HapticSceneBuilder::setSource(const std::string& id, MakeSource make, bool isEdit) {
  if (!make && !has(id)) return;
  std::erase_if(m_sources, [&](const auto& source) { return source.first == id; });
  if (make) m_sources.emplace_back(id, std::move(make));
  publish(!isEdit);
}

void HapticSceneBuilder::setSurface(std::optional<ContactSurface> surface, bool isEdit, Describe describe) {
  m_describeSurface = std::move(describe);
  if (!surface) return setSource(kSurfaceSource, {}, isEdit);
  const auto make = [surface = *std::move(surface)](const TouchContext& context) {
    const TouchedSurface touched{surface, context.mapping.sceneStiffness(context.touch.stiffness),
                                 context.mapping.sceneStiffness(context.touch.damping), context.contact};
    return std::make_unique<SurfaceForce>(kSurfaceSource, touched, context.comesFrom);
  };
  setSource(kSurfaceSource, make, isEdit);
}

void HapticSceneBuilder::setSnap(std::optional<SnapField> field, double distance, bool isEdit) {
  if (!field) return setSource(kSnapSource, {}, isEdit);
  const auto make = [this, field = *std::move(field), distance](const TouchContext& context) {
    if (m_isHolding || !context.touch.isSnapping) return std::unique_ptr<SnapForce>();
    const SnapProfile profile(context.touch.snapShape, context.mapping.sceneStiffness(context.touch.snapStiffness),
                              std::min(distance, kFarthestSnap * context.mapping.scale));
    return std::make_unique<SnapForce>(kSnapSource,
                                       SnapAttraction{field, profile, context.touch.snapMethod, context.snapFeatures});
  };
  setSource(kSnapSource, make, isEdit);
}

// Neither needs the ramp, which would take the surface away, too: the scene blends attractions by itself.
void HapticSceneBuilder::setHolding(bool isHolding) {
  if (std::exchange(m_isHolding, isHolding) != isHolding && has(kSnapSource)) publish(false);
}

void HapticSceneBuilder::setSprings(const std::vector<DeviceSpring>& terms) {
  if (std::equal(terms.begin(), terms.end(), m_terms.begin(), m_terms.end(), isSameSpring)) return;
  m_terms = terms;
  if (terms.empty()) return setSource(kSpringSource, {}, true);
  const auto make = [this, terms](const TouchContext& context) {
    const WorkspaceMapping& mapping = context.mapping;
    // For a device whose maker states no limit, the stiffness that the tool asks for.
    const double stated = m_session.capabilities().maxAngularStiffness;
    const double stiffest = stated > 0.0 ? stated : std::numeric_limits<double>::infinity();
    std::vector<Spring> springs;
    for (const DeviceSpring& term : terms) {
      springs.push_back({term.target, mapping.sceneStiffness(term.stiffness), mapping.sceneStiffness(term.damping),
                         term.turn, std::min(term.turning, stiffest) / mapping.forceGain});
    }
    return std::make_unique<SpringForce>(kSpringSource, std::move(springs));
  };
  setSource(kSpringSource, make, true);
}

void HapticSceneBuilder::setFidelity(const FidelityValues& values) {
  const double tolerance = contactOptions(values).tolerance;
  const auto features = static_cast<std::size_t>(values.of(snapFeaturesSetting()));
  if (tolerance == m_contact.tolerance && features == m_snapFeatures) return;
  m_contact.tolerance = tolerance;
  m_snapFeatures = features;
  if (!m_sources.empty()) publish(true);
}

// Stiffnesses are those at the hand: what would be soft in a view from afar is as stiff as in one from near. Nothing is
// described for a scene that would be dropped: descriptions go on from the ones before.
void HapticSceneBuilder::publish(bool isDiscontinuous) {
  if (!m_session.isOpen() || m_session.isTesting()) return;
  const WorkspaceMapping mapping = m_session.mappingInScene();
  TouchContext context{mapping, m_session.touch(), m_contact, m_snapFeatures, m_session.camera().towardsViewer()};
  context.contact.friction = context.touch.friction;
  ForceSources sources;
  for (const auto& [id, make] : m_sources) {
    if (std::unique_ptr<ForceSource> source = make(context)) sources.push_back(std::move(source));
  }
  // Attractions depend on whether a surface is touched.
  std::stable_partition(sources.begin(), sources.end(), [](const auto& source) { return !source->isAttraction(); });
  const std::string note = m_session.recorder() ? noteOf(context, sources) : "{}";
  auto scene = std::make_unique<HapticScene>();
  scene->renderer = std::make_unique<SceneForces>(std::move(sources));
  scene->isDiscontinuous = isDiscontinuous;
  m_session.setScene(std::move(scene), note);
}

// A JSON object with a member for each source. Only surfaces say what they are made of, so that they can be felt again:
// cli/mesh/RecordedScenes.h reads it.
std::string HapticSceneBuilder::noteOf(const TouchContext& context, const ForceSources& sources) const {
  QJsonObject note;
  for (const auto& source : sources) {
    QJsonObject own;
    if (source->id() == kSurfaceSource) {
      if (m_describeSurface) own = m_describeSurface();
      own["stiffness"] = context.mapping.sceneStiffness(context.touch.stiffness);
      own["damping"] = context.mapping.sceneStiffness(context.touch.damping);
      own["friction"] = context.contact.friction;
      own["tolerance"] = context.contact.tolerance;
      own["from"] = QJsonArray{context.comesFrom.x(), context.comesFrom.y(), context.comesFrom.z()};
    }
    note[QString::fromStdString(source->id())] = own;
  }
  return QJsonDocument(note).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace handwheel
