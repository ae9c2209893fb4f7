// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/GuideCurve.h"
#include "window/cell/CellCollisions.h"

namespace handwheel {

// The trajectory of the tool centre point along the path that was last requested. A worker computes the trajectory. The
// functions must be called on the window thread.
class PathGuides : public QObject {
  Q_OBJECT

 public:
  PathGuides(JobRunner& jobs, const CellCollisions& collisions, QObject* parent)
      : QObject(parent), m_jobs(jobs), m_collisions(collisions) {}

  // Returns the curve along a path. The result is null while the cell is being prepared, and while the curve is being
  // computed; prepared() is emitted when the curve is ready. The call is cheap if nothing has changed.
  std::shared_ptr<const GuideCurve> of(const std::string& path, const std::shared_ptr<const CellPlans>& plans);
  void clear();

 signals:
  void prepared();

 private:
  bool isKnown(const std::string& path, const std::shared_ptr<const CellPlans>& plans) const;
  void forget();

  JobRunner& m_jobs;
  const CellCollisions& m_collisions;
  std::shared_ptr<const CellPlans> m_plans;  // Plans that the curve was computed with; null: none was requested
  std::shared_ptr<const CellRobot> m_robot;  // Robots that the curve was computed with, with their bases
  std::string m_path;
  std::shared_ptr<const GuideCurve> m_curve;  // Null: being computed
};

}  // namespace handwheel
