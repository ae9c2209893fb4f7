// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathVerification.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

bool isSamePair(const RobotScene::Nearest& a, const RobotScene::Nearest& b) {
  return a.link == b.link && a.otherLink == b.otherLink && a.owner == b.owner;
}

// The collisions of a motion that is not free, point by point.
class CollisionList {
 public:
  explicit CollisionList(std::vector<PathCollision>& all) : m_all(all), m_begin(all.size()) {}

  void add(std::size_t motion, double share, double before, const RobotScene::Nearest& nearest) {
    for (std::size_t i = m_begin; i < m_all.size(); ++i) {
      PathCollision& open = m_all[i];
      if (open.to != before || !isSamePair(open.deepest, nearest)) continue;
      open.to = share;
      if (nearest.distance < open.deepest.distance) {
        open.deepest = nearest;
        open.deepestAt = share;
      }
      return;
    }
    m_all.push_back({motion, share, share, nearest, share});
  }
  bool isEmpty() const { return m_all.size() == m_begin; }

 private:
  std::vector<PathCollision>& m_all;
  std::size_t m_begin;
};

}  // namespace

VerifiedPath verified(const RobotScene& scene, const JointPath& path, const MotionCheckSettings& check, double step,
                      Progress progress) {
  VerifiedPath result;
  for (std::size_t i = 1; i < path.size() && !progress.cancelled(); ++i) {
    progress.set(static_cast<double>(i - 1) / static_cast<double>(path.size() - 1));
    MotionCheck motion(scene, path[i - 1], path[i], check);
    while (motion.state() == MotionCheck::State::Open && !progress.cancelled()) motion.step();
    result.steps += motion.steps();
    result.certified.push_back(motion.state() == MotionCheck::State::Free);
    if (result.certified.back() || progress.cancelled()) continue;
    CollisionList list(result.collisions);
    ArmValues way = path[i] - path[i - 1];
    for (Eigen::Index k = 0; k < way.size(); ++k) way[k] *= scene.joint(k).isPrismatic ? 1e-3 : 1.0;
    const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(way.cwiseAbs().maxCoeff() / step)));
    double before = -1.0;
    for (std::size_t k = 0; k <= parts && !progress.cancelled(); ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(parts);
      const ArmValues values = path[i - 1] + share * (path[i] - path[i - 1]);
      constexpr double kTouch = 1e-9;  // mm: what is as near as it may be is listed, too
      const RobotScene::Nearest nearest = scene.tooNear(values, check.clearance + kTouch, check.ownClearance + kTouch);
      ++result.steps;
      if (nearest.link != kNone) list.add(i - 1, share, before, nearest);
      before = share;
    }
    if (list.isEmpty()) list.add(i - 1, motion.blockedAt(), -1.0, motion.blockedBy());
  }
  return result;
}

}  // namespace handwheel
