// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellImport.h"
#include "document/cell/CellReach.h"
#include "document/cell/RobotCellDocument.h"
#include "document/cell/RobotCellKind.h"
#include "document/scene/BodyChanges.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <memory>

namespace handwheel::test {

// The document of a cell with a built-in robot. scene() prepares the cell for planning when it is called.
class ArmCell {
 public:
  explicit ArmCell(const char* id = "irb120") : ArmCell(*libraryTable(id)) {}
  explicit ArmCell(const DhTable& table) {
    OpenedFile opened;
    opened.kind = &m_kind;
    opened.content = cellOf(table);
    m_document = std::make_unique<RobotCellDocument>(std::move(opened));
    m_resting = m_document->plans()->allowed;
  }

  RobotCellDocument& document() { return *m_document; }
  RobotCellSnapshot content() const { return static_cast<const RobotCellSnapshot&>(*m_document->snapshot()); }
  std::shared_ptr<const CellScene> scene() {
    const RobotCellSnapshot now = content();
    const bool isSame = m_scene && m_scene->bodies == now.bodies;
    if (!isSame) m_scene = std::make_shared<const CellScene>(std::move(sceneOf(now, m_meshes)).value());
    return m_scene;
  }
  void stand(std::initializer_list<double> list) {
    JointValues joints(static_cast<Eigen::Index>(list.size()));
    std::copy(list.begin(), list.end(), joints.begin());
    if (auto edit = document().jointEdit(joints)) document().commit("Stand", std::move(edit));
  }
  BodyId addBox(const Vec3& size, const Vec3& at, const Vec3& turn = Vec3::Zero()) {
    Body box{.name = "box" + std::to_string(document().bodies().size() + 1),
             .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {size.x(), size.y(), size.z()})};
    box.pose = poseOf(at, turn);
    const std::string name = box.name;
    document().commit("Add", std::move(addBodyEdit(document().bodies(), std::move(box))).value());
    return document().bodies().withName(name)->id;
  }
  Pose tool() { return toolPose(document().robot(), *document().plans(), document().joints()); }
  int steps() { return document().history()->count(); }
  // Replaces the plans. Pairs of links that touch at rest may still touch.
  void plan(CellPlans plans) {
    plans.allowed.insert(m_resting.begin(), m_resting.end());
    if (auto edit = document().plansEdit(std::move(plans))) document().commit("Plan", std::move(edit));
  }

 private:
  RobotCellKind m_kind;
  std::unique_ptr<RobotCellDocument> m_document;
  std::set<std::pair<std::string, std::string>> m_resting;
  CollisionMeshes m_meshes;
  std::shared_ptr<const CellScene> m_scene;
};

}  // namespace handwheel::test
