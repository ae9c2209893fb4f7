// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/RobotScene.h"

#include "base/RandomSequence.h"
#include "robot/Kinematics.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace handwheel {

namespace {

Error noScene(std::string reason) {
  return {ErrorCode::ElementMalformed, {"robot", std::move(reason)}, {}, {}};
}

}  // namespace

RobotScene::RobotScene(const RobotModel& robot, const Pose& base, std::vector<CollisionBody> bodies,
                       std::vector<std::uint32_t> dofs, const JointValues& values, const std::set<LinkPair>& allowed)
    : m_base(base) {
  assert(bodies.size() == robot.links.size());
  const auto planned = [&](std::uint32_t dof) { return std::find(dofs.begin(), dofs.end(), dof) - dofs.begin(); };
  if (dofs.size() > static_cast<std::size_t>(kMostArmJoints)) {
    m_status = noScene("it has too many joints");
    return;
  }
  // For each link: the planned joint that moves it, and its pose in that joint's frame.
  std::vector<std::uint32_t> mover(robot.links.size(), kNone);
  std::vector<Pose> pose(robot.links.size(), base);
  std::vector<std::uint32_t> at(dofs.size(), kNone);  // of each planned one in m_joints
  m_joints.resize(dofs.size());
  for (const std::uint32_t j : robot.order) {
    const Joint& joint = robot.joints[j];
    const bool isMoved = joint.kind != JointKind::Fixed && joint.dof != kNone &&
                         planned(joint.dof) < static_cast<std::ptrdiff_t>(dofs.size());
    const Pose origin = pose[joint.parent] * joint.origin;
    mover[joint.child] = mover[joint.parent];
    if (!isMoved) {
      pose[joint.child] = origin;
      if (joint.kind == JointKind::Fixed) continue;
      const double position = jointPosition(joint, values);
      if (joint.kind == JointKind::Prismatic)
        pose[joint.child].translate(position * joint.axis);
      else
        pose[joint.child].rotate(Eigen::AngleAxisd(position, joint.axis));
      continue;
    }
    const auto index = static_cast<std::size_t>(planned(joint.dof));
    if (at[index] != kNone || std::abs(joint.factor) != 1.0) {
      m_status = noScene("a planned joint moves others with it");
      return;
    }
    at[index] = static_cast<std::uint32_t>(index);
    MovedJoint& moved = m_joints[index];
    moved.parent = mover[joint.parent];
    moved.joint.isPrismatic = joint.kind == JointKind::Prismatic;
    if (joint.kind != JointKind::Continuous) {
      moved.joint.lower = joint.limits.lower;
      moved.joint.upper = joint.limits.upper;
    }
    moved.joint.velocity = joint.limits.velocity;
    const Vec3 axis = joint.factor * joint.axis;
    const Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis).toRotationMatrix();
    moved.joint.before = origin;
    if (joint.offset != 0.0) {
      if (moved.joint.isPrismatic)
        moved.joint.before.translate(joint.offset * joint.axis);
      else
        moved.joint.before.rotate(Eigen::AngleAxisd(joint.offset, joint.axis));
    }
    moved.joint.before.rotate(turn);
    mover[joint.child] = static_cast<std::uint32_t>(index);
    pose[joint.child] = Pose(turn.transpose());
  }
  if (std::find(at.begin(), at.end(), kNone) != at.end()) {
    m_status = noScene("a planned joint is not in it");
    return;
  }
  for (const MovedJoint& joint : m_joints) {
    if (joint.parent != kNone && joint.parent >= static_cast<std::uint32_t>(&joint - m_joints.data())) {
      m_status = noScene("the planned joints are not in order");
      return;
    }
  }
  for (std::uint32_t l = 0; l < bodies.size(); ++l) {
    if (!bodies[l].isEmpty()) m_parts.push_back({l, mover[l], pose[l], std::move(bodies[l]), {}});
  }
  // The joints that move a part, the nearest first.
  const auto above = [&](std::uint32_t joint) {
    std::vector<std::uint32_t> all;
    for (; joint != kNone; joint = m_joints[joint].parent) all.push_back(joint);
    return all;
  };
  for (std::uint32_t a = 0; a < m_parts.size(); ++a) {
    for (std::uint32_t b = a + 1; b < m_parts.size(); ++b) {
      if (m_parts[a].joint == m_parts[b].joint) continue;
      if (allowed.contains(std::minmax(m_parts[a].link, m_parts[b].link))) continue;
      const auto first = above(m_parts[a].joint), second = above(m_parts[b].joint);
      const auto common = std::find_first_of(first.begin(), first.end(), second.begin(), second.end());
      m_pairs.push_back({a, b, common == first.end() ? kNone : *common});
    }
  }
}

std::set<LinkPair> RobotScene::alwaysMeeting(int samples) const {
  RandomSequence random(1);
  std::vector<Pair> meeting = m_pairs;
  ArmValues values(size());
  for (int i = 0; i < samples && !meeting.empty(); ++i) {
    for (Eigen::Index k = 0; k < size(); ++k) {
      const double far = joint(k).isPrismatic ? 1000.0 : M_PI;
      values[k] = random.between(std::max(joint(k).lower, -far), std::min(joint(k).upper, far));
    }
    const Places places = placesAt(values);
    std::erase_if(meeting, [&](const Pair& pair) { return pairDistance(pair, places, 1.0, nullptr) > 0.0; });
  }
  std::set<LinkPair> pairs;
  for (const Pair& pair : meeting) pairs.insert(std::minmax(m_parts[pair.first].link, m_parts[pair.second].link));
  return pairs;
}

std::set<LinkPair> RobotScene::closePairsMeeting(const ArmValues& values) const {
  std::set<LinkPair> pairs;
  const Places places = placesAt(values);
  for (const Pair& pair : m_pairs) {
    int joints = 0;  // that move one of them and not the other
    for (const std::uint32_t part : {pair.first, pair.second}) {
      for (std::uint32_t j = m_parts[part].joint; j != pair.common; j = m_joints[j].parent) ++joints;
    }
    if (joints > 2 || pairDistance(pair, places, 1.0, nullptr) > 0.0) continue;
    pairs.insert(std::minmax(m_parts[pair.first].link, m_parts[pair.second].link));
  }
  return pairs;
}

void RobotScene::allowPairs(const std::set<LinkPair>& pairs) {
  std::erase_if(m_pairs, [&](const Pair& pair) {
    return pairs.contains(std::minmax(m_parts[pair.first].link, m_parts[pair.second].link));
  });
}

void RobotScene::addObstacle(const CollisionBody& body, const Pose& pose, std::uint32_t owner) {
  m_obstacles.add(body, pose, owner);
}

void RobotScene::allow(std::uint32_t link, std::uint32_t owner) {
  for (Part& part : m_parts) {
    if (part.link == link) part.leftOut.push_back(owner);
  }
}

bool RobotScene::isWithinLimits(const ArmValues& values, double slack) const {
  for (Eigen::Index i = 0; i < size(); ++i) {
    if (!joint(i).isWithin(values[i], slack)) return false;
  }
  return true;
}

void RobotScene::jointPoses(const ArmValues& values, std::span<Pose> poses) const {
  assert(values.size() == size() && poses.size() == m_joints.size());
  for (std::size_t i = 0; i < m_joints.size(); ++i) {
    const MovedJoint& moved = m_joints[i];
    Pose& pose = poses[i];
    pose = moved.parent == kNone ? moved.joint.before : Pose(poses[moved.parent] * moved.joint.before);
    const double value = values[static_cast<Eigen::Index>(i)];
    if (moved.joint.isPrismatic)
      pose.translate(Vec3(0.0, 0.0, value));
    else
      pose.rotate(Eigen::AngleAxisd(value, Vec3::UnitZ()));
  }
}

RobotScene::Places RobotScene::placesAt(const ArmValues& values) const {
  Places places;
  places.joints.resize(m_joints.size());
  jointPoses(values, places.joints);
  places.parts.reserve(m_parts.size());
  places.centres.reserve(m_parts.size());
  for (const Part& part : m_parts) {
    places.parts.push_back(part.joint == kNone ? part.pose : Pose(places.joints[part.joint] * part.pose));
    places.centres.push_back(places.parts.back() * part.body.centre());
  }
  return places;
}

// From the part towards the base: what the joints nearer to the part may have moved it by adds to its distance from
// the axes of those before.
double RobotScene::speedOf(const ArmValues& rates, std::uint32_t part, std::uint32_t below, double half,
                           const Places& places) const {
  const Part& of = m_parts[part];
  if (of.joint == kNone) return 0.0;
  double speed = 0.0;
  for (std::uint32_t j = of.joint; j != below; j = m_joints[j].parent) {
    const double rate = std::abs(rates[j]);
    if (m_joints[j].joint.isPrismatic) {
      speed += rate;
    } else if (rate > 0.0) {
      const Vec3 away = places.centres[part] - places.joints[j].translation();
      speed += rate * (away.cross(places.joints[j].linear().col(2)).norm() + of.body.radius() + half * speed);
    }
  }
  return speed * (1.0 + kRounding);
}

double RobotScene::travelBound(const ArmValues& values, const ArmValues& spread) const {
  const Places places = placesAt(values);
  double most = 0.0;
  for (std::uint32_t p = 0; p < m_parts.size(); ++p) most = std::max(most, speedOf(spread, p, kNone, 1.0, places));
  return most;
}

RobotScene::Nearest RobotScene::nearestObstacle(const Places& places, double enough, QueryCounts* counts) const {
  Nearest least{enough};
  for (std::size_t p = 0; p < m_parts.size(); ++p) {
    const Part& part = m_parts[p];
    if (part.joint == kNone) continue;  // what stands is as near as the cell makes it
    const auto found = m_obstacles.distance(part.body, places.parts[p], least.distance, part.leftOut, counts);
    if (found.owner != kNone) least = {found.distance, part.link, kNone, found.owner};
  }
  return least;
}

RobotScene::Nearest RobotScene::nearestLinks(const Places& places, double enough, QueryCounts* counts) const {
  Nearest least{enough};
  for (const Pair& pair : m_pairs) {
    if (areApart(pair, places, least.distance)) continue;
    const double distance = pairDistance(pair, places, least.distance, counts);
    if (distance < least.distance) least = {distance, m_parts[pair.first].link, m_parts[pair.second].link, kNone};
  }
  return least;
}

RobotScene::Nearest RobotScene::nearest(const ArmValues& values, double enough, QueryCounts* counts) const {
  const Places places = placesAt(values);
  const Nearest obstacle = nearestObstacle(places, enough, counts);
  const Nearest links = nearestLinks(places, obstacle.distance, counts);
  return links.link == kNone ? obstacle : links;
}

RobotScene::Nearest RobotScene::nearestObstacle(const ArmValues& values, double enough, QueryCounts* counts) const {
  return nearestObstacle(placesAt(values), enough, counts);
}

RobotScene::Nearest RobotScene::tooNear(const ArmValues& values, double clearance, double ownClearance,
                                        QueryCounts* counts) const {
  const Places places = placesAt(values);
  const Nearest obstacle = nearestObstacle(places, clearance, counts);
  const Nearest links = nearestLinks(places, ownClearance, counts);
  if (links.link == kNone) return obstacle;
  if (obstacle.link == kNone) return links;
  return obstacle.distance - clearance < links.distance - ownClearance ? obstacle : links;
}

std::vector<RobotScene::Nearest> RobotScene::allTooNear(const ArmValues& values, double clearance,
                                                        double ownClearance) const {
  const Places places = placesAt(values);
  std::vector<Nearest> all;
  for (std::size_t p = 0; p < m_parts.size(); ++p) {
    const Part& part = m_parts[p];
    if (part.joint == kNone) continue;
    std::vector<std::uint32_t> leftOut = part.leftOut;  // and those that are listed
    for (;;) {
      const auto found = m_obstacles.distance(part.body, places.parts[p], clearance, leftOut);
      if (found.owner == kNone) break;
      all.push_back({found.distance, part.link, kNone, found.owner});
      leftOut.push_back(found.owner);
    }
  }
  for (const Pair& pair : m_pairs) {
    if (areApart(pair, places, ownClearance)) continue;
    const double distance = pairDistance(pair, places, ownClearance, nullptr);
    if (distance < ownClearance) all.push_back({distance, m_parts[pair.first].link, m_parts[pair.second].link, kNone});
  }
  return all;
}

}  // namespace handwheel
