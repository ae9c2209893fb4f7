// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/RobotScene.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace handwheel {

namespace {

// mm: without a clearance, shapes that meet are too near, and for most shapes only a distance of 0 is known then.
constexpr double kTouching = 1e-9;

struct PlacedBodies {
  std::vector<CollisionBody> bodies;
  std::vector<Pose> poses;
  void add(CollisionBody body, const Pose& pose) {
    bodies.push_back(std::move(body));
    poses.push_back(pose);
  }
};

// Returns the contacts of the first `own` with the others, the deepest first; if there are none, the closest points.
std::vector<ClosestPoints> touchesOf(PlacedBodies placed, std::size_t own, std::size_t most) {
  std::vector<BodyPair> pairs;
  for (std::uint32_t i = 0; i < own; ++i) {
    for (auto j = static_cast<std::uint32_t>(own); j < placed.bodies.size(); ++j) pairs.push_back({i, j});
  }
  ProximityQuery query(std::move(placed.bodies), pairs);
  for (std::uint32_t i = 0; i < placed.poses.size(); ++i) query.place(i, placed.poses[i]);
  std::vector<BodyContact> contacts;
  query.findContacts(0.0, most, contacts);
  std::vector<ClosestPoints> touches;
  touches.reserve(contacts.size());
  for (const BodyContact& each : contacts) touches.push_back(each.contact.points);
  std::stable_sort(touches.begin(), touches.end(),
                   [](const ClosestPoints& a, const ClosestPoints& b) { return a.distance < b.distance; });
  if (!touches.empty()) return touches;
  if (const auto closest = query.closest()) touches.push_back(closest->points);
  return touches;
}

}  // namespace

void RobotScene::jointPoses(const ArmValues& values, std::span<Pose> poses) const {
  assert(values.size() == size() && poses.size() == m_joints.size());
  for (std::size_t i = 0; i < m_joints.size(); ++i) {
    const MovedJoint& moved = m_joints[i];
    Pose& pose = poses[i];
    pose = moved.parent == kNone ? moved.joint.before : Pose(poses[moved.parent] * moved.joint.before);
    const double value = values[static_cast<Eigen::Index>(i)];
    if (moved.joint.isPrismatic) {
      pose.translation() += value * pose.linear().col(2);
    } else {
      const double c = std::cos(value), s = std::sin(value);
      const Vec3 x = pose.linear().col(0), y = pose.linear().col(1);
      pose.linear().col(0) = c * x + s * y;
      pose.linear().col(1) = c * y - s * x;
    }
  }
}

void RobotScene::posesAt(const ArmValues& values, Poses& poses) const {
  jointPoses(values, std::span(poses.joints.data(), m_joints.size()));
}

// From the sphere towards the base: the possible displacement by the outer joints adds to its distance from the axes of
// the inner ones.
double RobotScene::speedOf(const ArmValues& rates, std::uint32_t joint, const Vec3& centre, double radius,
                           std::uint32_t below, double half, const Poses& poses) const {
  if (joint == below) return 0.0;
  const Vec3 at = poses.of(joint) * centre;
  double speed = 0.0;
  for (std::uint32_t j = joint; j != below; j = m_joints[j].parent) {
    const double rate = std::abs(rates[j]);
    if (m_joints[j].joint.isPrismatic) {
      speed += rate;
    } else if (rate > 0.0) {
      const Pose& pose = poses.joints[j];
      const Vec3 away = at - pose.translation();
      speed += rate * (away.cross(Vec3(pose.linear().col(2))).norm() + radius + half * speed);
    }
  }
  return speed * (1.0 + kRounding);
}

double RobotScene::travelBound(const ArmValues& values, const ArmValues& spread) const {
  Poses poses;
  posesAt(values, poses);
  double most = 0.0;
  for (const Part& part : m_parts)
    most = std::max(most, speedOf(spread, part.joint, part.body.centre(), part.body.radius(), kNone, 1.0, poses));
  return most;
}

double RobotScene::travelBound(const ArmValues& from, const ArmValues& to, const ArmValues& spread) const {
  Poses poses;
  posesAt(0.5 * (from + to), poses);
  double most = 0.0;
  for (const Part& part : m_parts) {
    if (part.joint == kNone) continue;
    const Vec3 at = poses.of(part.joint) * part.body.centre();
    // From the part to the base: the displacement by the joints so far towards either end, and their deviation.
    double moved = 0.0, off = 0.0;
    for (std::uint32_t j = part.joint; j != kNone; j = m_joints[j].parent) {
      const double motion = 0.5 * std::abs(to[j] - from[j]), own = std::abs(spread[j]);
      if (m_joints[j].joint.isPrismatic) {
        moved += motion;
        off += own;
        continue;
      }
      const Pose& pose = poses.joints[j];
      const Vec3 away = at - pose.translation();
      const double lever = away.cross(Vec3(pose.linear().col(2))).norm() + part.body.radius() + moved;
      off += own * (lever + off);
      moved += motion * lever;
    }
    most = std::max(most, off);
  }
  return most * (1.0 + kRounding);
}

bool RobotScene::isFreeAround(const ArmValues& values, const ArmValues& spread, double clearance,
                              double ownClearance) const {
  Poses poses;
  posesAt(values, poses);
  const auto travel = [&](const Part& part, std::uint32_t below) {
    return speedOf(spread, part.joint, part.body.centre(), part.body.radius(), below, 1.0, poses);
  };
  const auto isNear = [&](const Part& part) {
    if (part.joint == kNone) return false;
    const double least = std::max(clearance + travel(part, kNone), kTouching);
    return m_obstacles.distance(part.body, poses.of(part.joint), least, part.leftOut).owner != kNone;
  };
  const auto isPairNear = [&](const Pair& pair) {
    const double moved = travel(m_parts[pair.first], pair.common) + travel(m_parts[pair.second], pair.common);
    const double least = std::max(ownClearance + moved, kTouching);
    return pairDistance(pair, poses, least, nullptr) < least;
  };
  return std::ranges::none_of(m_parts, isNear) && std::ranges::none_of(m_pairs, isPairNear);
}

double RobotScene::pairDistance(const Pair& pair, const Poses& poses, double enough, QueryCounts* counts) const {
  const Part &first = m_parts[pair.first], &second = m_parts[pair.second];
  return distanceBetween(first.body, poses.of(first.joint), second.body, poses.of(second.joint), enough, counts);
}

bool RobotScene::areApart(const GroupPair& pair, const Poses& poses, double enough) const {
  const Group &a = m_groups[pair.first], &b = m_groups[pair.second];
  const double least = enough + a.radius + b.radius;
  return (poses.of(a.joint) * a.centre - poses.of(b.joint) * b.centre).squaredNorm() >= least * least;
}

std::span<const std::uint32_t> RobotScene::near(const Group& group, const Poses& poses, double enough,
                                                QueryCounts* counts) const {
  static thread_local std::vector<std::uint32_t> found;  // keeps its memory
  m_obstacles.findNear(poses.of(group.joint) * group.centre, group.radius, enough, found, counts);
  return found;
}

RobotScene::Nearest RobotScene::nearestOf(const Group& group, const Poses& poses, double enough,
                                          QueryCounts* counts) const {
  Nearest least{enough};
  if (group.joint == kNone) return least;  // bodies that do not move are as near as the cell makes it
  const auto obstacles = near(group, poses, enough, counts);
  if (obstacles.empty()) return least;
  for (std::uint32_t p = group.begin; p < group.end; ++p) {
    const Part& part = m_parts[p];
    const auto found =
        m_obstacles.distance(part.body, poses.of(part.joint), least.distance, part.leftOut, obstacles, counts);
    if (found.owner != kNone) least = {found.distance, part.link, kNone, found.owner};
  }
  return least;
}

RobotScene::Nearest RobotScene::nearestOf(const GroupPair& pair, const Poses& poses, double enough,
                                          QueryCounts* counts) const {
  Nearest least{enough};
  if (areApart(pair, poses, enough)) return least;
  for (std::uint32_t i = pair.begin; i < pair.end; ++i) {
    const double distance = pairDistance(m_pairs[i], poses, least.distance, counts);
    if (distance < least.distance)
      least = {distance, m_parts[m_pairs[i].first].link, m_parts[m_pairs[i].second].link, kNone};
  }
  return least;
}

RobotScene::Nearest RobotScene::nearestObstacle(const Poses& poses, double enough, QueryCounts* counts) const {
  Nearest least{enough};
  for (const Group& group : m_groups) {
    const Nearest found = nearestOf(group, poses, least.distance, counts);
    if (found.link != kNone) least = found;
  }
  return least;
}

RobotScene::Nearest RobotScene::nearestLinks(const Poses& poses, double enough, QueryCounts* counts) const {
  Nearest least{enough};
  for (const GroupPair& pair : m_groupPairs) {
    const Nearest found = nearestOf(pair, poses, least.distance, counts);
    if (found.link != kNone) least = found;
  }
  return least;
}

RobotScene::Nearest RobotScene::nearest(const ArmValues& values, double enough, QueryCounts* counts) const {
  Poses poses;
  posesAt(values, poses);
  const Nearest obstacle = nearestObstacle(poses, enough, counts);
  const Nearest links = nearestLinks(poses, obstacle.distance, counts);
  return links.link == kNone ? obstacle : links;
}

RobotScene::Nearest RobotScene::nearestObstacle(const ArmValues& values, double enough, QueryCounts* counts) const {
  Poses poses;
  posesAt(values, poses);
  return nearestObstacle(poses, enough, counts);
}

RobotScene::Nearest RobotScene::nearestTo(const CollisionBody& body, const Pose& pose, const ArmValues& values,
                                          double enough, std::span<const std::uint32_t> without) const {
  Poses poses;
  posesAt(values, poses);
  Nearest least{enough};
  for (const Part& part : m_parts) {
    if (std::ranges::find(without, part.link) != without.end()) continue;
    const double distance = distanceBetween(part.body, poses.of(part.joint), body, pose, least.distance);
    if (distance < least.distance) least = {distance, part.link};
  }
  return least;
}

RobotScene::Nearest RobotScene::tooNear(const ArmValues& values, double clearance, double ownClearance,
                                        QueryCounts* counts) const {
  Poses poses;
  posesAt(values, poses);
  const Nearest obstacle = nearestObstacle(poses, std::max(clearance, kTouching), counts);
  const Nearest links = nearestLinks(poses, std::max(ownClearance, kTouching), counts);
  if (links.link == kNone) return obstacle;
  if (obstacle.link == kNone) return links;
  return obstacle.distance - clearance < links.distance - ownClearance ? obstacle : links;
}

bool RobotScene::isFree(const ArmValues& values, double clearance, double ownClearance, QueryCounts* counts) const {
  Poses poses;
  posesAt(values, poses);
  const auto isBlocked = [&](const auto& of, double distance) {
    return nearestOf(of, poses, std::max(distance, kTouching), counts).link != kNone;
  };
  return std::ranges::none_of(m_groups, [&](const Group& group) { return isBlocked(group, clearance); }) &&
         std::ranges::none_of(m_groupPairs, [&](const GroupPair& pair) { return isBlocked(pair, ownClearance); });
}

void RobotScene::listNear(const Part& part, const Pose& pose, double clearance, std::vector<std::uint32_t> leftOut,
                          std::vector<Nearest>& all) const {
  for (;;) {
    const auto found = m_obstacles.distance(part.body, pose, clearance, leftOut);
    if (found.owner == kNone) return;
    all.push_back({found.distance, part.link, kNone, found.owner});
    leftOut.push_back(found.owner);
  }
}

std::vector<RobotScene::Nearest> RobotScene::overlappingLinks(const ArmValues& values) const {
  Poses poses;
  posesAt(values, poses);
  std::vector<Nearest> all;
  for (const Pair& pair : m_pairs) {
    if (pairDistance(pair, poses, kTouching, nullptr) >= kTouching) continue;
    const Part &first = m_parts[pair.first], &second = m_parts[pair.second];
    ProximityQuery query({first.body, second.body}, {{0, 1}});
    query.place(0, poses.of(first.joint));
    query.place(1, poses.of(second.joint));
    const std::optional<NearPair> deepest = query.closest();
    all.push_back({deepest ? std::min(deepest->points.distance, 0.0) : 0.0, first.link, second.link});
  }
  return all;
}

std::vector<ClosestPoints> RobotScene::touches(const ArmValues& values, const Nearest& nearest, std::size_t most,
                                               const Pose& displacement) const {
  Poses poses;
  posesAt(values, poses);
  PlacedBodies placed;
  const auto addLink = [&](std::uint32_t link) {
    for (const Part& part : m_parts) {
      if (part.link == link) placed.add(part.body, displacement * poses.of(part.joint));
    }
  };
  addLink(nearest.link);
  const std::size_t own = placed.bodies.size();
  if (nearest.otherLink != kNone) {
    addLink(nearest.otherLink);
  } else {
    auto obstacles = m_obstacles.bodies();
    if (auto found = obstacles.extract(nearest.owner)) placed.add(std::move(found.mapped()), Pose::Identity());
  }
  return touchesOf(std::move(placed), own, most);
}

std::vector<ClosestPoints> RobotScene::touches(const ArmValues& values, const CollisionBody& body, const Pose& pose,
                                               std::size_t most, std::span<const std::uint32_t> without) const {
  Poses poses;
  posesAt(values, poses);
  PlacedBodies placed;
  for (const Part& part : m_parts) {
    if (std::ranges::find(without, part.link) == without.end()) placed.add(part.body, poses.of(part.joint));
  }
  const std::size_t own = placed.bodies.size();
  placed.add(body, pose);
  return touchesOf(std::move(placed), own, most);
}

std::vector<RobotScene::Nearest> RobotScene::metWhenMoved(const ArmValues& values, const Pose& displacement,
                                                          const std::function<bool()>& isOver) const {
  Poses poses;
  posesAt(values, poses);
  std::vector<Nearest> all;
  for (const Part& part : m_parts) {
    if (isOver && isOver()) break;
    std::vector<std::uint32_t> leftOut = part.leftOut;
    std::vector<Nearest> here;
    if (part.joint == kNone) listNear(part, poses.world, kTouching, leftOut, here);
    for (const Nearest& each : here) leftOut.push_back(each.owner);
    listNear(part, displacement * poses.of(part.joint), kTouching, std::move(leftOut), all);
  }
  return all;
}

std::vector<RobotScene::Nearest> RobotScene::allTooNear(const ArmValues& values, double clearance,
                                                        double ownClearance) const {
  clearance = std::max(clearance, kTouching);
  ownClearance = std::max(ownClearance, kTouching);
  Poses poses;
  posesAt(values, poses);
  std::vector<Nearest> all;
  for (const Part& part : m_parts) {
    if (part.joint != kNone) listNear(part, poses.of(part.joint), clearance, part.leftOut, all);
  }
  for (const Pair& pair : m_pairs) {
    const double distance = pairDistance(pair, poses, ownClearance, nullptr);
    if (distance < ownClearance) all.push_back({distance, m_parts[pair.first].link, m_parts[pair.second].link, kNone});
  }
  return all;
}

}  // namespace handwheel
