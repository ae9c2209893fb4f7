// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/SrdfReader.h"

#include "xml/Xml.h"
#include "xml/XmlNumbers.h"

#include <algorithm>
#include <new>

namespace handwheel {

namespace {

constexpr XmlLimits kSrdfLimits{kLargestSrdf, 100'000, 64};
constexpr std::size_t kMostDamage = 100;
constexpr double kMetre = 1000.0;  // mm per metre

class Semantics {
 public:
  Semantics(const RobotModel& robot, std::span<const RobotArm> arms, std::size_t arm) : m_robot(robot) {
    if (robot.root == kNone) return;
    m_owners = armsOfLinks(robot, arms);
    const std::vector<std::uint32_t> ofDofs = armsOfDofs(robot, arms);
    const std::string prefix = arms[arm].base == robot.root ? std::string() : arms[arm].name + '_';
    const auto ownName = [&](const std::string& name) {
      return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
    };
    for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
      if (m_owners[i] == arm) m_links.emplace(ownName(robot.links[i].name), i);
    }
    for (std::uint32_t i = 0; i < robot.dofs.size(); ++i) {
      if (ofDofs[i] == arm) m_joints.emplace(ownName(robot.jointOfDof(i).name), i);
    }
    // Other names are those of the model.
    for (std::uint32_t i = 0; i < robot.links.size(); ++i) m_links.emplace(robot.links[i].name, i);
    for (std::uint32_t i = 0; i < robot.dofs.size(); ++i) m_joints.emplace(robot.jointOfDof(i).name, i);
  }

  void read(const XmlElement& element) {
    if (element.name == "disable_collisions") readPair(element, true);
    if (element.name == "enable_collisions") readPair(element, false);
    if (element.name == "disable_default_collisions") readDefault(element);
    if (element.name == "group_state") readState(element);
  }

  RobotSemantics take() { return std::move(m_read); }

 private:
  static std::string valueOf(const XmlElement& element, const char* name) {
    const std::string* value = element.attribute(name);
    return value ? *value : std::string();
  }

  void leaveOut(const XmlElement& element, const std::string& what) {
    if (m_read.damage.size() < kMostDamage) m_read.damage.push_back(malformed(element, what));
  }

  std::uint32_t linkOf(const XmlElement& element, const char* attribute) {
    const auto found = m_links.find(valueOf(element, attribute));
    if (found != m_links.end()) return found->second;
    leaveOut(element, "its link is not in the robot");
    return kNone;
  }

  void readPair(const XmlElement& element, bool isAllowed) {
    const std::uint32_t a = linkOf(element, "link1"), b = linkOf(element, "link2");
    if (a == kNone || b == kNone || a == b) return;
    if (isAllowed)
      m_read.allowed.insert(std::minmax(a, b));
    else
      m_read.allowed.erase(std::minmax(a, b));
  }

  void readDefault(const XmlElement& element) {
    const std::uint32_t link = linkOf(element, "link");
    for (std::uint32_t i = 0; link != kNone && i < m_robot.links.size(); ++i) {
      if (i != link && m_owners[i] == m_owners[link]) m_read.allowed.insert(std::minmax(i, link));
    }
  }

  void readState(const XmlElement& element) {
    RobotSemantics::State state{valueOf(element, "name"), valueOf(element, "group"), {}};
    for (const XmlElement& joint : element.children) {
      if (joint.name != "joint") continue;
      const auto found = m_joints.find(valueOf(joint, "name"));
      const Result<double> value = parseNumber(valueOf(joint, "value"));
      if (found == m_joints.end() || !value) {
        leaveOut(joint, "it is not in the robot, or its value is no number");
        continue;
      }
      const bool isSlide = m_robot.jointOfDof(found->second).kind == JointKind::Prismatic;
      state.values[found->second] = isSlide ? *value * kMetre : *value;
    }
    m_read.states.push_back(std::move(state));
  }

  const RobotModel& m_robot;
  std::vector<std::uint32_t> m_owners;                     // robot of each link
  std::map<std::string, std::uint32_t> m_links, m_joints;  // joints: degrees of freedom
  RobotSemantics m_read;
};

}  // namespace

Result<RobotSemantics> readSrdf(std::string_view bytes, const RobotModel& robot, Progress progress) {
  const RobotArm all{.name = {}, .title = {}, .base = robot.root};
  return readSrdf(bytes, robot, std::span(&all, 1), 0, progress);
}

Result<RobotSemantics> readSrdf(std::string_view bytes, const RobotModel& robot, std::span<const RobotArm> arms,
                                std::size_t arm, Progress progress) {
  try {
    const Result<XmlElement> root = readXml(bytes, kSrdfLimits, progress);
    if (!root) return root.error();
    if (root->name != "robot") return malformed(*root, "a semantic description of a robot was expected");
    Semantics semantics(robot, arms, arm);
    // The order matters: defaults of a link first, excepted pairs last.
    for (const char* name : {"disable_default_collisions", "disable_collisions", "enable_collisions", "group_state"}) {
      for (const XmlElement& element : root->children) {
        if (element.name == name) semantics.read(element);
      }
    }
    return semantics.take();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  }
}

std::set<LinkPair> neighbours(const RobotModel& robot) {
  // Finds the nearest link with a shape for each link, upwards, including itself.
  std::vector<std::uint32_t> shaped(robot.links.size(), kNone);
  const auto hasShape = [&](std::uint32_t link) { return robot.links[link].isSolid(); };
  if (robot.root != kNone && hasShape(robot.root)) shaped[robot.root] = robot.root;
  std::set<LinkPair> pairs;
  for (const std::uint32_t j : robot.order) {
    const Joint& joint = robot.joints[j];
    const std::uint32_t above = shaped[joint.parent];
    if (hasShape(joint.child) && above != kNone) pairs.insert(std::minmax(above, joint.child));
    shaped[joint.child] = hasShape(joint.child) ? joint.child : above;
  }
  return pairs;
}

}  // namespace handwheel
