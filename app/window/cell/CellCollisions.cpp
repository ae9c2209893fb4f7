// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellCollisions.h"

#include "document/cell/RobotCellDocument.h"
#include "window/JobRunner.h"
#include "window/cell/CollisionColour.h"
#include "window/documents/DocumentTab.h"

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
  if (!document) return;
  connect(&document->document, &Document::changed, this, &CellCollisions::prepare);
  prepare();
}

bool CellCollisions::isPrepared() const {
  if (!m_scene || m_scene->robot.get() != &cell().robot() || !(m_scene->bodies == cell().bodies())) return false;
  return m_allowed == cell().plans()->allowed && m_scene->standsAs(cell().joints());
}

void CellCollisions::prepare() {
  if (isPrepared()) return;
  m_scene.reset();
  m_parts.jobs.cancelOf(this);
  const auto content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot());
  Job job;
  job.name = tr("Preparing the cell for collisions");
  job.owner = this;
  job.work = [this, content, meshes = m_meshes](Progress) -> Job::Finish {
    Result<CellScene> made = sceneOf(*content, *meshes);
    auto scene = made ? std::make_shared<const CellScene>(std::move(made).value()) : nullptr;
    return [this, content, scene] {
      if (!m_document || content->robot.get() != &cell().robot()) return;
      m_scene = scene;
      m_allowed = content->plans->allowed;
      if (scene && !isPrepared()) return prepare();
      emit prepared();
    };
  };
  m_parts.jobs.start(std::move(job));
}

void CellCollisions::mark(DisplayModel& shown, const JointValues& joints, const Body* moved) const {
  if (!m_scene) return;
  const ArmValues values = m_scene->planned(joints);
  if (!moved) return markColliding(shown, *m_scene, m_scene->scene.allTooNear(values, 0.0, 0.0));
  RobotScene::Nearest nearest = m_scene->scene.nearestTo(collisionBodyOf(*moved->geometry, *m_meshes), moved->pose,
                                                         values, std::numeric_limits<double>::min());
  nearest.owner = moved->id;
  if (nearest.link != kNone) markColliding(shown, *m_scene, std::span(&nearest, 1));
}

}  // namespace handwheel
