// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

namespace handwheel {

// Plans with the single-query, bi-directional, lazy planner SBL. (Sánchez and Latombe 2001, A single-query
// bi-directional probabilistic roadmap planner with lazy collision checking.) Milestones are free configurations, in
// one tree grown from the start and one from the goal. The motions between them are checked only if they are on a path
// from start to goal, beginning with the longest interval that is not known to be free. If a motion is blocked, the
// milestones beyond it move to the other tree. The checks are proofs (MotionCheck), so that the path is free at all
// points.
PlanResult planBySbl(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                     const PlanSettings& settings, Progress progress = {});

}  // namespace handwheel
