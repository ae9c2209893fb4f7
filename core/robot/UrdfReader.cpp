// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfReader.h"

#include "robot/UrdfJoints.h"
#include "robot/UrdfShapes.h"
#include "xml/Xml.h"

#include <map>
#include <new>

namespace handwheel {

namespace {

constexpr XmlLimits kLimits{std::size_t{16} << 20, 100'000, 64};

bool isOfXacro(const XmlElement& element) {
  return element.name.starts_with("xacro:");
}

Status readLinks(const XmlElement& root, ImportedRobot& read, UrdfShapes& shapes,
                 std::map<std::string, std::uint32_t>& numbers, std::vector<InputPosition>& positions) {
  for (const XmlElement& element : root.children) {
    if (isOfXacro(element)) {
      return Error{
          ErrorCode::Unsupported, {"a xacro file that is not expanded to URDF"}, InputPosition::line(element.line), {}};
    }
    if (element.name != "link") continue;
    const std::string* name = element.attribute("name");
    if (!name || name->empty()) return malformed(element, "it has no name");
    if (!numbers.try_emplace(*name, read.robot.links.size()).second)
      return malformed(element, "there are two of that name");
    Link& link = read.robot.links.emplace_back();
    link.name = *name;
    positions.push_back(InputPosition::line(element.line));
    shapes.readInto(link, element);
  }
  if (read.robot.links.empty()) return malformed(root, "it has no links");
  return Done{};
}

Result<ImportedRobot> readRobot(const XmlElement& root) {
  ImportedRobot read;
  if (const std::string* name = root.attribute("name")) read.robot.name = *name;
  UrdfShapes shapes(read);
  shapes.collectMaterials(root);
  std::map<std::string, std::uint32_t> links;
  RobotInputPositions positions;
  if (const Status status = readLinks(root, read, shapes, links, positions.links); !status) return status.error();
  UrdfJoints joints(read.robot, links, positions, shapes);
  for (const XmlElement& element : root.children) {
    if (element.name != "joint") continue;
    if (const Status status = joints.read(element); !status) return status.error();
  }
  const Status status = buildKinematicTree(read.robot, joints.following(), positions);
  if (!status) return status.error();
  return read;
}

}  // namespace

Result<ImportedRobot> readUrdf(std::string_view bytes, Progress progress) {
  try {
    const Result<XmlElement> root = readXml(bytes, kLimits, progress);
    if (!root) return root.error();
    if (root->name != "robot") return malformed(*root, "a robot description was expected");
    return readRobot(*root);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  }
}

bool looksLikeUrdf(std::string_view head) {
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == head.npos || head[first] != '<') return false;
  constexpr std::string_view kTag = "<robot";
  const std::size_t tag = head.find(kTag);
  if (tag == head.npos || tag + kTag.size() == head.size()) return false;
  return std::string_view(" \t\r\n>").find(head[tag + kTag.size()]) != std::string_view::npos;
}

}  // namespace handwheel
