// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellReachOutline.h"

#include "document/cell/CellReach.h"
#include "document/cell/RobotCellDocument.h"
#include "robot/arm/ReachSection.h"
#include "viewport/Viewport.h"
#include "viewport/path/PathLayer.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"

namespace handwheel {

namespace {

constexpr double kSameDirection = 0.9998;  // cosine of about a degree: the plane need not follow each move

}  // namespace

CellReachOutline::CellReachOutline(const WindowContext& parts, CellCollisions& collisions, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_collisions(collisions),
      m_layer(std::make_shared<PathLayer>()),
      m_action(tr("Show the r&each of the arm"), this) {
  prepare(m_action, "showReach", nullptr,
          tr("Show what the tool's centre point reaches within the joint limits, in the upright plane of the tool"));
  m_action.setCheckable(true);
  parts.viewport.addLayer(m_layer);
  connect(&m_action, &QAction::toggled, this, &CellReachOutline::look);
  connect(&m_collisions, &CellCollisions::prepared, this, &CellReachOutline::look);
}

CellReachOutline::~CellReachOutline() {
  m_parts.viewport.removeLayer(*m_layer);
}

void CellReachOutline::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_parts.jobs.cancelOf(this);
  m_document = document;
  m_scene.reset();
  m_layer->setLines(nullptr);
  m_action.setEnabled(document != nullptr);
  if (document) connect(&document->document, &Document::changed, this, &CellReachOutline::look);
  look();
}

void CellReachOutline::setVisible(bool isVisible) {
  m_layer->setVisible(isVisible);
}

// Anew where robot, tool or plane have changed.
void CellReachOutline::look() {
  if (!m_document || !m_action.isChecked()) {
    m_parts.jobs.cancelOf(this);
    m_scene.reset();
    return m_layer->setLines(nullptr);
  }
  const auto scene = m_collisions.scene();
  if (!scene) return;
  const auto& cell = static_cast<const RobotCellDocument&>(m_document->document);
  const Pose& tool = cell.plans()->tool;
  const Pose base = basePose(scene->robot->model, scene->plannedArm());
  const Pose toBase = base.inverse(Eigen::Isometry);
  Vec3 direction = (toBase * toolPose(cell.robot(), *cell.plans(), cell.joints())).translation();
  direction.z() = 0.0;
  direction = direction.norm() > 1e-6 ? Vec3(direction.normalized()) : Vec3::UnitX();
  const bool isSame = m_scene && m_scene->robot == scene->robot && m_scene->armNumber == scene->armNumber &&
                      m_tool.matrix() == tool.matrix() && m_direction.dot(direction) > kSameDirection;
  if (isSame) return;
  m_scene = scene;
  m_tool = tool;
  m_direction = direction;
  m_parts.jobs.cancelOf(this);
  Job job;
  job.name = tr("Finding the reach of the arm");
  job.document = &m_document->document;
  job.owner = this;
  job.lane = Job::Lane::Looking;
  job.isUnasked = true;
  job.work = [this, scene, tool, direction, base,
              start = scene->planned(cell.joints())](Progress progress) -> Job::Finish {
    const auto outlines = reachSection(scene->armFromBase(), tool, start, direction, {}, progress);
    auto lines = std::make_shared<std::vector<PathLine>>();
    for (const std::vector<Vec3>& outline : outlines) {
      lines->push_back({{}, PathLine::Look::Feed});
      for (const Vec3& point : outline) lines->back().points.push_back(base * point);
    }
    return [this, scene, lines] {
      if (m_document && m_scene == scene) m_layer->setLines(lines->empty() ? nullptr : lines);
    };
  };
  m_parts.jobs.start(std::move(job));
}

}  // namespace handwheel
