// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/HeldApproach.h"

#include "document/cell/BodyCarriers.h"
#include "document/cell/RobotCellDocument.h"

#include <cmath>

namespace handwheel {

namespace {

using Object = RobotScene::Object;
using Role = RobotScene::HeldRole;

// Returns the body that an object of a scene is; nothing if it is a link of a robot.
std::optional<BodyId> bodyOf(const CellScene& scene, const Object& object) {
  if (object.link != kNone) return scene.bodyOfLink(object.link);
  return CellScene::linkOfOwner(object.owner) == kNone ? std::optional<BodyId>(object.owner) : std::nullopt;
}

// Returns the link of a robot that carries an object of a scene, or is that object; kNone: a body that no link carries.
std::uint32_t carryingLink(const CellScene& scene, const Object& object) {
  const auto id = bodyOf(scene, object);
  const BodyPointer body = id ? scene.bodies.withId(*id) : nullptr;
  if (body) return carrierOf(*body, scene.robot->model);
  return object.link != kNone ? object.link : CellScene::linkOfOwner(object.owner);
}

}  // namespace

HeldForce forceOnBody(const CellScene& scene, const JointValues& joints, BodyId body,
                      const DistanceForceSettings& settings) {
  const BodyPointer own = scene.bodies.withId(body);
  const std::uint32_t carrier = own ? carrierOf(*own, scene.robot->model) : kNone;
  const auto role = [&](const Object& object) {
    const auto id = bodyOf(scene, object);
    if (id && *id == body) return Role::Held;
    if (carrier == kNone) return Role::Near;
    // A link that always meets the body would push it without end.
    const auto isSame = [&](std::uint32_t link) { return scene.bodyOfLink(link) == body; };
    for (const auto& [a, b] : scene.alwaysMeeting) {
      if (object.link != kNone && ((isSame(a) && b == object.link) || (isSame(b) && a == object.link)))
        return Role::LeftOut;
    }
    return carryingLink(scene, object) == carrier ? Role::LeftOut : Role::Near;
  };
  std::uint32_t held = 0;
  ProximityQuery query = scene.scene.heldQuery(scene.planned(joints), role, held);
  return {std::move(query), held, settings};
}

HeldForce forceOnRobot(const CellScene& scene, const JointValues& joints, const DistanceForceSettings& settings) {
  const auto role = [](const Object& object) { return object.link != kNone ? Role::Held : Role::Near; };
  std::uint32_t held = 0;
  ProximityQuery query = scene.scene.heldQuery(scene.planned(joints), role, held);
  HeldForce force(std::move(query), held, settings);
  force.leaveOutTouching();
  return force;
}

HeldApproach::HeldApproach(const RobotCellDocument& document, HeldApproachServices services)
    : m_document(document), m_services(std::move(services)) {}

void HeldApproach::hold(BodyId body) {
  release();
  m_held = Held{.body = body};
}

void HeldApproach::holdRobot(std::size_t robot) {
  release();
  m_held = Held{.robot = robot};
}

void HeldApproach::release() {
  m_held.reset();
  m_felt = {};
}

// A scene from before the last change has the bodies elsewhere.
void HeldApproach::prepare() {
  if (m_held->force && m_held->settings == settings()) return;
  m_held->force.reset();
  const auto scene = m_services.scene ? m_services.scene(m_held->robot) : nullptr;
  if (!scene || scene->robot.get() != &m_document.robot() || !(scene->bodies == m_document.bodies()) ||
      !scene->areUnplannedJointsAt(m_document.joints()))
    return;
  const DistanceForceSettings law = settings().law(m_services.tolerance);
  m_held->force = m_held->body ? forceOnBody(*scene, m_document.joints(), *m_held->body, law)
                               : forceOnRobot(*scene, m_document.joints(), law);
  m_held->settings = settings();
}

const HeldForce::Felt& HeldApproach::follow(const Pose& displacement, const Vec3& reference) {
  m_felt = {};
  if (!m_held || !settings().isFelt) return m_felt;
  prepare();
  if (m_held->force) m_felt = m_held->force->at(displacement, reference);
  return m_felt;
}

std::vector<Property> HeldApproach::figures() const {
  if (!std::isfinite(m_felt.distance)) return {};
  return {clearanceProperty(m_felt.distance)};
}

}  // namespace handwheel
