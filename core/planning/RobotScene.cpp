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

// Returns the displacement by a joint at this position, rad or mm, in its own frame.
Pose motionOf(const Joint& joint, double position) {
  Pose motion = Pose::Identity();
  if (joint.kind == JointKind::Prismatic)
    motion.translate(position * joint.axis);
  else
    motion.rotate(Eigen::AngleAxisd(position, joint.axis));
  return motion;
}

}  // namespace

RobotScene::RobotScene(const RobotModel& robot, const Pose& base, std::vector<CollisionBody> bodies,
                       const std::vector<std::uint32_t>& dofs, const JointValues& values,
                       const std::set<LinkPair>& allowed) {
  assert(bodies.size() == robot.links.size());
  if (dofs.size() > static_cast<std::size_t>(kMostArmJoints)) {
    m_status = noScene("it has too many joints");
    return;
  }
  std::vector<std::uint32_t> mover(robot.links.size(), kNone);
  std::vector<Pose> pose(robot.links.size(), base);
  m_status = addJoints(robot, dofs, values, mover, pose);
  if (!m_status) return;
  for (std::uint32_t l = 0; l < bodies.size(); ++l) {
    std::vector<CollisionPiece> pieces;
    for (const CollisionPiece& piece : bodies[l].pieces()) pieces.push_back(piece.moved(pose[l]));
    if (!pieces.empty()) m_parts.push_back({l, mover[l], CollisionBody(std::move(pieces)), {}});
  }
  std::stable_sort(m_parts.begin(), m_parts.end(), [](const Part& a, const Part& b) { return a.joint < b.joint; });
  findGroups();
  findReaches();
  findPairs(allowed);
}

Status RobotScene::addJoints(const RobotModel& robot, const std::vector<std::uint32_t>& dofs, const JointValues& values,
                             std::vector<std::uint32_t>& mover, std::vector<Pose>& pose) {
  std::vector<bool> isThere(dofs.size(), false);
  m_joints.resize(dofs.size());
  for (const std::uint32_t j : robot.order) {
    const Joint& joint = robot.joints[j];
    const auto index = static_cast<std::size_t>(std::find(dofs.begin(), dofs.end(), joint.dof) - dofs.begin());
    const bool isMoved = joint.kind != JointKind::Fixed && joint.dof != kNone && index < dofs.size();
    const Pose origin = pose[joint.parent] * joint.origin;
    mover[joint.child] = mover[joint.parent];
    if (!isMoved) {
      pose[joint.child] =
          joint.kind == JointKind::Fixed ? origin : origin * motionOf(joint, jointPosition(joint, values));
      continue;
    }
    if (isThere[index] || std::abs(joint.factor) != 1.0) return noScene("a planned joint moves others with it");
    isThere[index] = true;
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
    moved.joint.before = joint.offset != 0.0 ? origin * motionOf(joint, joint.offset) : origin;
    moved.joint.before.rotate(turn);
    mover[joint.child] = static_cast<std::uint32_t>(index);
    pose[joint.child] = Pose(turn.transpose());
  }
  if (std::find(isThere.begin(), isThere.end(), false) != isThere.end()) return noScene("a planned joint is not in it");
  for (std::size_t i = 0; i < m_joints.size(); ++i)
    if (m_joints[i].parent != kNone && m_joints[i].parent >= i) return noScene("the planned joints are not in order");
  return Done{};
}

void RobotScene::findGroups() {
  for (std::uint32_t begin = 0, end = 0; begin < m_parts.size(); begin = end) {
    Box box;
    for (end = begin; end < m_parts.size() && m_parts[end].joint == m_parts[begin].joint; ++end) {
      const CollisionBody& body = m_parts[end].body;
      box.extend(Vec3(body.centre().array() - body.radius()));
      box.extend(Vec3(body.centre().array() + body.radius()));
    }
    Group group{m_parts[begin].joint, begin, end, box.center(), 0.0};
    for (std::uint32_t p = begin; p < end; ++p) {
      const CollisionBody& body = m_parts[p].body;
      group.radius = std::max(group.radius, (body.centre() - group.centre).norm() + body.radius());
    }
    m_groups.push_back(group);
  }
  std::reverse(m_groups.begin(), m_groups.end());
}

void RobotScene::findReaches() {
  for (const Part& part : m_parts) {
    double far = part.body.centre().norm() + part.body.radius();
    for (std::uint32_t j = part.joint; j != kNone; j = m_joints[j].parent) {
      const ArmJoint& joint = m_joints[j].joint;
      m_joints[j].reach = std::max(m_joints[j].reach, far);
      far += joint.before.translation().norm();
      if (joint.isPrismatic && std::isfinite(joint.lower) && std::isfinite(joint.upper))
        far += std::max(std::abs(joint.lower), std::abs(joint.upper));
    }
  }
}

void RobotScene::findPairs(const std::set<LinkPair>& allowed) {
  // The joints that move a part, the nearest first.
  const auto above = [&](std::uint32_t joint) {
    std::vector<std::uint32_t> all;
    for (; joint != kNone; joint = m_joints[joint].parent) all.push_back(joint);
    return all;
  };
  for (const Group& one : m_groups) {
    for (const Group& other : m_groups) {
      if (one.joint >= other.joint) continue;
      const auto first = above(one.joint), second = above(other.joint);
      const auto common = std::find_first_of(first.begin(), first.end(), second.begin(), second.end());
      for (std::uint32_t a = one.begin; a < one.end; ++a) {
        for (std::uint32_t b = other.begin; b < other.end; ++b) {
          if (!allowed.contains(std::minmax(m_parts[a].link, m_parts[b].link)))
            m_pairs.push_back({a, b, common == first.end() ? kNone : *common});
        }
      }
    }
  }
  groupPairs();
}

void RobotScene::groupPairs() {
  const auto groupOf = [&](std::uint32_t part) {
    const auto found = std::find_if(m_groups.begin(), m_groups.end(),
                                    [&](const Group& each) { return part >= each.begin && part < each.end; });
    return static_cast<std::uint32_t>(found - m_groups.begin());
  };
  m_groupPairs.clear();
  for (std::uint32_t i = 0; i < m_pairs.size(); ++i) {
    const std::uint32_t first = groupOf(m_pairs[i].first), second = groupOf(m_pairs[i].second);
    if (m_groupPairs.empty() || m_groupPairs.back().first != first || m_groupPairs.back().second != second)
      m_groupPairs.push_back({first, second, m_pairs[i].common, i, i});
    m_groupPairs.back().end = i + 1;
  }
}

std::set<LinkPair> RobotScene::alwaysMeeting(int samples) const {
  RandomSequence random(1);
  std::vector<Pair> meeting = m_pairs;
  ArmValues values(size());
  Poses poses;
  for (int i = 0; i < samples && !meeting.empty(); ++i) {
    for (Eigen::Index k = 0; k < size(); ++k) {
      const double far = joint(k).isPrismatic ? 1000.0 : M_PI;
      values[k] = random.between(std::max(joint(k).lower, -far), std::min(joint(k).upper, far));
    }
    posesAt(values, poses);
    std::erase_if(meeting, [&](const Pair& pair) { return pairDistance(pair, poses, 1.0, nullptr) > 0.0; });
  }
  std::set<LinkPair> pairs;
  for (const Pair& pair : meeting) pairs.insert(std::minmax(m_parts[pair.first].link, m_parts[pair.second].link));
  return pairs;
}

std::set<LinkPair> RobotScene::closePairsMeeting(const ArmValues& values) const {
  std::set<LinkPair> pairs;
  Poses poses;
  posesAt(values, poses);
  for (const Pair& pair : m_pairs) {
    if (jointsBetween(pair) > 2 || pairDistance(pair, poses, 1.0, nullptr) > 0.0) continue;
    pairs.insert(std::minmax(m_parts[pair.first].link, m_parts[pair.second].link));
  }
  return pairs;
}

int RobotScene::jointsBetween(const Pair& pair) const {
  int joints = 0;
  for (const std::uint32_t part : {pair.first, pair.second}) {
    for (std::uint32_t j = m_parts[part].joint; j != pair.common; j = m_joints[j].parent) ++joints;
  }
  return joints;
}

int RobotScene::jointsBetween(const LinkPair& links) const {
  for (const Pair& pair : m_pairs) {
    if (LinkPair(std::minmax(m_parts[pair.first].link, m_parts[pair.second].link)) == links) return jointsBetween(pair);
  }
  return 0;
}

void RobotScene::allowPairs(const std::set<LinkPair>& pairs) {
  std::erase_if(m_pairs, [&](const Pair& pair) {
    return pairs.contains(std::minmax(m_parts[pair.first].link, m_parts[pair.second].link));
  });
  groupPairs();
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
  return !m_coupling || m_coupling->isWithin(values, slack);
}

ProximityQuery RobotScene::approachQuery(std::vector<std::uint32_t>& joints) const {
  joints.clear();
  std::vector<CollisionBody> bodies;
  std::vector<const Part*> moved;
  for (const Part& part : m_parts) {
    if (part.joint == kNone) continue;
    joints.push_back(part.joint);
    bodies.push_back(part.body);
    moved.push_back(&part);
  }
  std::vector<BodyPair> pairs;
  for (auto& [owner, body] : m_obstacles.bodies()) {
    const auto number = static_cast<std::uint32_t>(bodies.size());
    bodies.push_back(body);
    for (std::uint32_t i = 0; i < moved.size(); ++i) {
      const auto& leftOut = moved[i]->leftOut;
      if (std::find(leftOut.begin(), leftOut.end(), owner) == leftOut.end()) pairs.push_back({i, number});
    }
  }
  return {std::move(bodies), pairs};
}

ProximityQuery RobotScene::heldQuery(const ArmValues& values, const std::function<HeldRole(const Object&)>& role,
                                     std::uint32_t& held) const {
  Poses poses;
  posesAt(values, poses);
  struct Item {
    Object object;
    CollisionBody body;                      // in the world
    std::span<const std::uint32_t> leftOut;  // owners
  };
  std::vector<Item> items[2];  // held, near
  const auto add = [&](Item item) {
    const HeldRole of = role(item.object);
    if (of != HeldRole::LeftOut) items[of == HeldRole::Held ? 0 : 1].push_back(std::move(item));
  };
  for (const Part& part : m_parts) {
    std::vector<CollisionPiece> pieces;
    for (const CollisionPiece& piece : part.body.pieces()) pieces.push_back(piece.moved(poses.of(part.joint)));
    add({{.link = part.link}, CollisionBody(std::move(pieces)), part.leftOut});
  }
  for (auto& [owner, body] : m_obstacles.bodies()) add({{.owner = owner}, body, {}});
  const auto isAllowed = [](const Item& a, const Item& b) {
    return std::ranges::find(a.leftOut, b.object.owner) != a.leftOut.end();
  };
  std::vector<BodyPair> pairs;
  std::vector<CollisionBody> bodies;
  held = static_cast<std::uint32_t>(items[0].size());
  for (std::uint32_t i = 0; i < held; ++i) {
    for (std::uint32_t j = 0; j < items[1].size(); ++j) {
      const Item &own = items[0][i], &other = items[1][j];
      if (!isAllowed(own, other) && !isAllowed(other, own)) pairs.push_back({i, held + j});
    }
  }
  for (std::vector<Item>& list : items) {
    for (Item& item : list) bodies.push_back(std::move(item.body));
  }
  return {std::move(bodies), pairs};
}

ArmValues byShortestTurn(const RobotScene& scene, const ArmValues& from, ArmValues to) {
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    const ArmJoint& joint = scene.joint(i);
    if (joint.isPrismatic || std::isfinite(joint.lower) || std::isfinite(joint.upper)) continue;
    const double turned = from[i] + std::remainder(to[i] - from[i], 2.0 * M_PI);
    if (std::abs(turned) <= kMostTurn) to[i] = turned;
  }
  return to;
}

}  // namespace handwheel
