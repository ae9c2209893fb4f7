// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/RobotsEdit.h"

#include "document/cell/RobotCellDocument.h"

#include <utility>

namespace handwheel {

RobotsEdit::RobotsEdit(RobotCellSnapshot other, std::vector<BodyEdit::Change> bodies, std::optional<std::size_t> moved)
    : m_robot(std::move(other.robot)),
      m_joints(std::move(other.joints)),
      m_plans(std::move(other.plans)),
      m_moved(moved) {
  if (!bodies.empty()) m_bodies.emplace(std::move(bodies));
}

void RobotsEdit::exchange(Document& document) {
  auto& cell = static_cast<RobotCellDocument&>(document);
  std::swap(cell.m_robot, m_robot);
  std::swap(cell.m_joints, m_joints);
  std::swap(cell.m_plans, m_plans);
  if (m_bodies) m_bodies->exchange(document);
  cell.wasChanged();
}

bool RobotsEdit::absorb(const Edit& later) {
  const auto* const edit = dynamic_cast<const RobotsEdit*>(&later);
  return edit && m_moved && m_moved == edit->m_moved;
}

// Surfaces count where only this edit holds them.
std::size_t RobotsEdit::bytes() const {
  std::size_t sum = sizeof *this + m_plans->bytes() + m_robot->description.size() + (m_bodies ? m_bodies->bytes() : 0);
  for (const auto& surface : m_robot->surfaces) {
    if (surface && surface.use_count() == 1)
      sum += surface->points.size() * sizeof(Vec3) + surface->triangles.size() * sizeof(Triangle);
  }
  return sum;
}

}  // namespace handwheel
