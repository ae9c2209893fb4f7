// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/RobotTree.h"

#include "robot/UrdfValues.h"

#include <cmath>
#include <map>
#include <string_view>

namespace handwheel {

namespace {

// Returns the unit of a joint's position, in metres or radians.
double unitOf(const Joint& joint) {
  return joint.kind == JointKind::Prismatic ? kMillimetresPerMetre : 1.0;
}

class Tree {
 public:
  Tree(RobotModel& robot, const RobotInputPositions& positions) : m_robot(robot), m_positions(positions) {}

  Status follow(std::span<const MimicJoint> following);
  Status findParents();
  Status findRoot();
  Status findOrder();
  void numberDofs();

 private:
  // The source of a joint's motion: position = factor · position of the leader + offset; metres, radians.
  struct Motion {
    enum class State { Unknown, Sought, Known } state = State::Unknown;
    std::uint32_t leader = kNone;
    double factor = 0.0, offset = 0.0;
  };

  Status resolve(std::uint32_t joint, const std::map<std::uint32_t, const MimicJoint*>& following);
  Status joinLeader(std::uint32_t joint, const MimicJoint& own);
  Error wrong(std::uint32_t joint, std::string what) const {
    return {ErrorCode::ElementMalformed,
            {"joint " + m_robot.joints[joint].name, std::move(what)},
            m_positions.joints[joint],
            {}};
  }

  RobotModel& m_robot;
  const RobotInputPositions& m_positions;
  std::map<std::string_view, std::uint32_t> m_numbers;
  std::vector<Motion> m_motions;  // per joint
};

Status Tree::follow(std::span<const MimicJoint> following) {
  const auto count = static_cast<std::uint32_t>(m_robot.joints.size());
  for (std::uint32_t j = 0; j < count; ++j) m_numbers[m_robot.joints[j].name] = j;
  std::map<std::uint32_t, const MimicJoint*> byJoint;
  for (const MimicJoint& f : following) byJoint[f.joint] = &f;
  m_motions.resize(count);
  for (std::uint32_t j = 0; j < count; ++j) {
    if (const Status status = resolve(j, byJoint); !status) return status;
  }
  return Done{};
}

// Follows the chain of leaders to the first that follows no other, and back.
Status Tree::resolve(std::uint32_t joint, const std::map<std::uint32_t, const MimicJoint*>& following) {
  std::vector<const MimicJoint*> chain;
  for (std::uint32_t j = joint; m_motions[j].state != Motion::State::Known;) {
    if (m_motions[j].state == Motion::State::Sought) return wrong(j, "it mimics itself");
    m_motions[j].state = Motion::State::Sought;
    const auto own = following.find(j);
    if (own == following.end()) {
      const bool moves = m_robot.joints[j].kind != JointKind::Fixed;
      m_motions[j] = {Motion::State::Known, moves ? j : kNone, moves ? 1.0 : 0.0, 0.0};
      break;
    }
    chain.push_back(own->second);
    const auto leader = m_numbers.find(own->second->leader);
    if (leader == m_numbers.end())
      return Error{ErrorCode::ReferenceMissing, {"the joint", own->second->leader}, m_positions.joints[j], {}};
    j = leader->second;
  }
  for (; !chain.empty(); chain.pop_back()) {
    if (const Status status = joinLeader(chain.back()->joint, *chain.back()); !status) return status;
  }
  return Done{};
}

Status Tree::joinLeader(std::uint32_t joint, const MimicJoint& own) {
  const Motion leader = m_motions[m_numbers.at(own.leader)];
  const Motion motion{Motion::State::Known, leader.leader, own.multiplier * leader.factor,
                      own.multiplier * leader.offset + own.offset};
  if (!(std::abs(motion.factor) <= kLargestLength && std::abs(motion.offset) <= kLargestLength))
    return wrong(joint, "its mimic factor or offset is too large");
  m_motions[joint] = motion;
  return Done{};
}

Status Tree::findParents() {
  for (std::uint32_t j = 0; j < m_robot.joints.size(); ++j) {
    Link& child = m_robot.links[m_robot.joints[j].child];
    if (child.parentJoint != kNone) return wrong(j, "link " + child.name + " already has a parent joint");
    child.parentJoint = j;
  }
  return Done{};
}

Status Tree::findRoot() {
  for (std::uint32_t link = 0; link < m_robot.links.size(); ++link) {
    if (m_robot.links[link].parentJoint != kNone) continue;
    if (m_robot.root != kNone) {
      const std::string what = "no joint links it with " + m_robot.links[m_robot.root].name;
      return Error{
          ErrorCode::ElementMalformed, {"link " + m_robot.links[link].name, what}, m_positions.links[link], {}};
    }
    m_robot.root = link;
  }
  if (m_robot.root != kNone) return Done{};
  std::uint32_t j = 0;  // after as many steps upwards as there are joints it is in a cycle
  for (std::size_t i = 0; i < m_robot.joints.size(); ++i) j = m_robot.links[m_robot.joints[j].parent].parentJoint;
  return wrong(j, "it belongs to a closed loop of joints");
}

// Depth first, so that the joints of an arm are consecutive.
Status Tree::findOrder() {
  std::vector<std::vector<std::uint32_t>> jointsBelow(m_robot.links.size());
  for (std::uint32_t j = 0; j < m_robot.joints.size(); ++j) jointsBelow[m_robot.joints[j].parent].push_back(j);
  std::vector<std::uint32_t> open(jointsBelow[m_robot.root].rbegin(), jointsBelow[m_robot.root].rend());
  std::vector<bool> reached(m_robot.joints.size());
  while (!open.empty()) {
    const std::uint32_t j = open.back();
    open.pop_back();
    m_robot.order.push_back(j);
    reached[j] = true;
    const auto& below = jointsBelow[m_robot.joints[j].child];
    open.insert(open.end(), below.rbegin(), below.rend());
  }
  for (std::uint32_t j = 0; j < reached.size(); ++j) {
    if (!reached[j]) return wrong(j, "it belongs to a closed loop of joints");
  }
  return Done{};
}

void Tree::numberDofs() {
  std::vector<std::uint32_t> dofOf(m_robot.joints.size(), kNone);
  for (std::uint32_t j : m_robot.order) {
    if (m_motions[j].leader != j) continue;
    dofOf[j] = static_cast<std::uint32_t>(m_robot.dofs.size());
    m_robot.dofs.push_back(j);
  }
  for (std::uint32_t j = 0; j < m_robot.joints.size(); ++j) {
    Joint& joint = m_robot.joints[j];
    const Motion& motion = m_motions[j];
    joint.offset = motion.offset * unitOf(joint);
    if (motion.leader == kNone || motion.factor == 0.0) continue;
    joint.dof = dofOf[motion.leader];
    joint.factor = motion.factor * unitOf(joint) / unitOf(m_robot.joints[motion.leader]);
  }
}

}  // namespace

Status buildKinematicTree(RobotModel& robot, std::span<const MimicJoint> following,
                          const RobotInputPositions& positions) {
  Tree tree(robot, positions);
  for (const auto step : {&Tree::findParents, &Tree::findRoot, &Tree::findOrder}) {
    if (const Status status = (tree.*step)(); !status) return status;
  }
  if (const Status status = tree.follow(following); !status) return status;
  tree.numberDofs();
  return Done{};
}

}  // namespace handwheel
