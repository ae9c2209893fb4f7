// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellCollisions.h"

#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "window/JobRunner.h"
#include "window/cell/CollisionColour.h"
#include "window/documents/DocumentTab.h"

#include <QElapsedTimer>
#include <algorithm>
#include <limits>

namespace handwheel {

CellCollisions::CellCollisions(const WindowContext& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_meshes(std::make_shared<CollisionMeshes>()) {}

const RobotCellDocument& CellCollisions::cell() const {
  return static_cast<const RobotCellDocument&>(m_document->document);
}

void CellCollisions::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_parts.jobs.cancelOf(this);
  m_document = document;
  m_scene.reset();
  m_others.clear();
  if (!document) return;
  connect(&document->document, &Document::changed, this, &CellCollisions::prepare);
  prepare();
}

// Clients that hear of a change before this object may ask for the scene with joint values that it does not have.
bool CellCollisions::isOfPresentRobots() const {
  return m_document && m_scene && m_scene->robot.get() == &cell().robot();
}

std::shared_ptr<const CellScene> CellCollisions::scene() const {
  const bool isUsable = isOfPresentRobots() && m_scene->armNumber == activeArmNumber(cell().robot(), *cell().plans());
  return isUsable ? m_scene : nullptr;
}

std::shared_ptr<const CellScene> CellCollisions::sceneFor(std::size_t arm) const {
  if (arm == activeArmNumber(cell().robot(), *cell().plans())) return scene();
  const auto found = std::find_if(m_others.begin(), m_others.end(), [&](const auto& other) {
    return other && other->armNumber == arm && other->areUnplannedJointsAt(cell().joints());
  });
  return isReady() && found != m_others.end() ? *found : nullptr;
}

bool CellCollisions::isPrepared() const {
  if (!isOfPresentRobots()) return false;
  return m_scene->holdsFor(*std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot()), *m_plans);
}

bool CellCollisions::areOthersPrepared() const {
  return m_others.size() + 1 == cell().robot().arms.size() &&
         std::all_of(m_others.begin(), m_others.end(),
                     [&](const auto& scene) { return !scene || scene->areUnplannedJointsAt(cell().joints()); });
}

// The other robots stand elsewhere for each other whenever one has moved, which does not change the scene of the one
// that is planned for.
void CellCollisions::prepare() {
  const bool isMain = !isPrepared();
  if (!isMain && areOthersPrepared()) return;
  if (isMain) {
    m_scene.reset();
    m_others.clear();
  }
  m_parts.jobs.cancelOf(this);
  const auto content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot());
  Job job;
  job.name = tr("Preparing the cell for collisions");
  job.document = &m_document->document;
  job.owner = this;
  job.lane = Job::Lane::Looking;
  job.isUnasked = true;
  job.failed = [this](const Error&) { m_isUnderWay = false; };
  job.work = [this, content, known = m_scene, meshes = m_meshes](Progress progress) -> Job::Finish {
    const auto sceneFor = [&](std::size_t arm) {
      Result<CellScene> made = sceneOf(*content, *meshes, arm);
      return made ? std::make_shared<const CellScene>(std::move(made).value()) : nullptr;
    };
    const std::size_t active = activeArmNumber(*content->robot, *content->plans);
    const auto scene = known ? known : sceneFor(active);
    std::vector<std::shared_ptr<const CellScene>> others;
    for (std::size_t arm = 0; arm < content->robot->arms.size(); ++arm) {
      if (progress.cancelled()) return {};
      if (arm != active) others.push_back(sceneFor(arm));
    }
    return [this, content, scene, others = std::move(others)] {
      m_isUnderWay = false;
      if (!m_document || content->robot.get() != &cell().robot()) return;
      m_scene = scene;
      m_others = others;
      m_plans = content->plans;
      if (scene && !(isPrepared() && areOthersPrepared())) return prepare();
      emit prepared();
    };
  };
  m_isUnderWay = true;
  m_parts.jobs.start(std::move(job));
}

void CellCollisions::prepareIfIdle() {
  if (m_document && !m_isUnderWay) prepare();
}

// One of another robot, if only that is where it was not.
std::shared_ptr<const CellScene> CellCollisions::sceneMoving(const JointValues& joints) const {
  const auto isMoving = [&](const auto& scene) { return scene && scene->areUnplannedJointsAt(joints); };
  const auto found = std::find_if(m_others.begin(), m_others.end(), isMoving);
  return m_scene->areUnplannedJointsAt(joints) || found == m_others.end() ? m_scene : *found;
}

std::vector<CellCollision> CellCollisions::mark(DisplayModel& shown, const JointValues& joints,
                                                const Body* moved) const {
  std::vector<CellCollision> found;
  if (!isOfPresentRobots()) return found;
  const CollisionBody body = moved ? collisionBodyOf(*moved->geometry, *m_meshes) : CollisionBody();
  const auto markOf = [&](const std::shared_ptr<const CellScene>& scene) {
    CellCollision here{scene, scene->planned(joints), {}};
    if (moved) {
      here.without = scene->ownLinksOf(moved->id);
      RobotScene::Nearest nearest =
          scene->scene.nearestTo(body, moved->pose, here.values, std::numeric_limits<double>::min(), here.without);
      nearest.owner = moved->id;
      if (nearest.link != kNone) here.pairs.push_back(nearest);
      here.moved = body;
      here.movedPose = moved->pose;
    } else {
      here.pairs = scene->scene.allTooNear(here.values, 0.0, 0.0);
    }
    markColliding(shown, *scene, here.pairs);
    if (!here.pairs.empty()) found.push_back(std::move(here));
  };
  // If nothing is dragged any robot may collide.
  const std::shared_ptr<const CellScene> first = moved ? m_scene : sceneMoving(joints);
  markOf(first);
  for (const auto& other : m_others) {
    if (other && other != first && other->areUnplannedJointsAt(joints)) markOf(other);
  }
  return found;
}

std::vector<CellCollision> CellCollisions::markMoved(DisplayModel& shown, std::size_t robot,
                                                     const Pose& displacement) const {
  constexpr qint64 kMostMs = 8;  // half of a frame
  const auto scene = sceneFor(robot);
  if (!scene) return {};
  QElapsedTimer since;
  since.start();
  CellCollision found{scene, scene->planned(cell().joints()), {}, displacement};
  found.pairs = scene->scene.metWhenMoved(found.values, displacement, [&] { return since.elapsed() >= kMostMs; });
  markColliding(shown, *scene, found.pairs);
  return {std::move(found)};
}

}  // namespace handwheel
