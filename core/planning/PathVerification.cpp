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

// Returns shares of a motion between which no joint moves by more than the step (for slides a metre counts as a
// radian), and one more.
std::vector<double> marksOf(const RobotScene& scene, ArmValues displacement, double step, double also) {
  for (Eigen::Index k = 0; k < displacement.size(); ++k) displacement[k] *= scene.joint(k).isPrismatic ? 1e-3 : 1.0;
  constexpr double kMostMarks = 1e5;
  const auto parts =
      static_cast<std::size_t>(std::clamp(std::ceil(displacement.cwiseAbs().maxCoeff() / step), 1.0, kMostMarks));
  std::vector<double> shares{also};
  for (std::size_t k = 0; k <= parts; ++k) shares.push_back(static_cast<double>(k) / static_cast<double>(parts));
  std::sort(shares.begin(), shares.end());
  return shares;
}

}  // namespace

VerifiedPath verified(const RobotScene& scene, const JointPath& path, const MotionCheckSettings& settings, double step,
                      Progress progress, std::span<const double> offs) {
  VerifiedPath result;
  const std::size_t motions = path.size() == 1 ? 1 : std::max<std::size_t>(path.size(), 1) - 1;
  for (std::size_t i = 0; i < motions && !progress.cancelled(); ++i) {
    progress.set(static_cast<double>(i) / static_cast<double>(motions));
    const ArmValues &from = path[i], &to = path[std::min(i + 1, path.size() - 1)];
    const MotionCheckSettings check = i < offs.size() ? widened(settings, offs[i]) : settings;
    MotionCheck motion(scene, from, to, check);
    motion.run(progress);
    result.steps += motion.steps();
    result.certified.push_back(motion.state() == MotionCheck::State::Free);
    if (result.certified.back() || progress.cancelled()) continue;
    CollisionList list(result.collisions);
    const ArmValues displacement = to - from;
    if (displacement.allFinite()) {
      double before = -1.0;
      for (const double share : marksOf(scene, displacement, step, motion.blockedAt())) {
        if (progress.cancelled()) break;
        constexpr double kTouch = 1e-9;  // mm: touching the clearance is listed, too
        ++result.steps;
        for (const RobotScene::Nearest& each :
             scene.allTooNear(from + share * displacement, check.clearance + kTouch, check.ownClearance + kTouch))
          list.add(i, share, before, each);
        before = share;
      }
    }
    if (list.isEmpty()) list.add(i, motion.blockedAt(), -1.0, motion.blockedBy());
  }
  return result;
}

}  // namespace handwheel
