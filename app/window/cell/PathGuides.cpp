// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/PathGuides.h"

#include "document/cell/CellArms.h"
#include "tools/cell/path/PathCheck.h"
#include "window/JobRunner.h"

namespace handwheel {

// Bodies do not change where a path leads.
bool PathGuides::isKnown(const std::string& path, const std::shared_ptr<const CellPlans>& plans) const {
  if (!m_plans || path != m_path) return false;
  if (const auto scene = m_collisions.scene(); scene && scene->robot != m_robot) return false;
  if (m_plans == plans) return true;
  const RobotPath *const before = m_plans->path(path), *const now = plans->path(path);
  return before && now && *before == *now && m_plans->arm == plans->arm &&
         m_plans->tool.matrix() == plans->tool.matrix();
}

std::shared_ptr<const GuideCurve> PathGuides::of(const std::string& path,
                                                 const std::shared_ptr<const CellPlans>& plans) {
  if (isKnown(path, plans)) {
    m_plans = plans;
    return m_curve;
  }
  const auto scene = m_collisions.scene();
  const RobotPath* const asked = plans->path(path);
  if (!scene || !asked || armNumber(*scene->robot, asked->arm) != scene->armNumber) return nullptr;
  m_jobs.cancelOf(this);
  m_plans = plans;
  m_robot = scene->robot;
  m_path = path;
  m_curve.reset();
  Job job;
  job.name = tr("Finding the curve along %1").arg(QString::fromStdString(path));
  job.owner = this;
  job.lane = Job::Lane::Looking;
  job.isUnasked = true;
  job.failed = [this](const Error&) { forget(); };  // it is found when it is next asked for
  job.work = [this, scene, plans, path](Progress progress) -> Job::Finish {
    auto curve = std::make_shared<const GuideCurve>(toolCurve(*scene, *plans, *plans->path(path), progress));
    return [this, plans, path, curve] {
      const RobotPath *const found = plans->path(path), *const wanted = m_plans ? m_plans->path(path) : nullptr;
      if (path != m_path || !wanted || !(*found == *wanted)) return;
      m_curve = curve;
      emit prepared();
    };
  };
  m_jobs.start(std::move(job));
  return nullptr;
}

void PathGuides::clear() {
  m_jobs.cancelOf(this);
  forget();
}

void PathGuides::forget() {
  m_plans.reset();
  m_robot.reset();
  m_curve.reset();
}

}  // namespace handwheel
