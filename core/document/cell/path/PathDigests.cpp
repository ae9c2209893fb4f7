// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/path/PathDigests.h"

#include "document/cell/CellArms.h"
#include "document/cell/path/PathBasis.h"
#include "scene/PrimitiveGeometry.h"

#include <QCryptographicHash>
#include <algorithm>

namespace handwheel {

namespace {

// Digest of a sequence of values; texts and lists are added with their sizes, so that no two sequences give the same
// bytes.
class Digest {
 public:
  void add(std::uint64_t number) { addBytes(&number, sizeof number); }
  template <class Number>
  void addNumber(Number number) {
    number += Number(0);  // -0 is 0
    addBytes(&number, sizeof number);
  }
  void add(const std::string& text) {
    add(std::uint64_t{text.size()});
    addBytes(text.data(), text.size());
  }
  void add(const Pose& pose) {
    for (Eigen::Index i = 0; i < 12; ++i) addNumber(pose.matrix()(i / 4, i % 4));
  }
  void add(const JointValues& joints) {
    add(static_cast<std::uint64_t>(joints.size()));
    for (const double value : joints) addNumber(value);
  }
  template <class Number>
  void addSurface(const TriangleSoup& soup) {
    std::vector<Number> block;
    add(std::uint64_t{soup.points.size()});
    for (const Vec3& point : soup.points) {
      for (const double value : point) block.push_back(static_cast<Number>(value) + Number(0));
      if (block.size() >= kBlock) flush(block);
    }
    flush(block);
    add(std::uint64_t{soup.triangles.size()});
    addBytes(soup.triangles.data(), soup.triangles.size() * sizeof soup.triangles[0]);
  }
  std::string text() const { return m_hash.result().toHex().toStdString(); }

 private:
  static constexpr std::size_t kBlock = 3 * 4096;

  template <class Number>
  void flush(std::vector<Number>& block) {
    addBytes(block.data(), block.size() * sizeof(Number));
    block.clear();
  }
  void addBytes(const void* bytes, std::size_t size) {
    m_hash.addData(QByteArrayView(static_cast<const char*>(bytes), static_cast<qsizetype>(size)));
  }

  QCryptographicHash m_hash{QCryptographicHash::Sha256};
};

std::string ofRobots(const CellRobot& robot) {
  Digest digest;
  digest.add(robot.description);
  for (const RobotArm& arm : robot.arms) {
    digest.add(arm.name);
    digest.add(arm.title);
    digest.add(std::uint64_t{arm.base});
    digest.add(std::uint64_t{arm.flange});
  }
  // Shapes other than meshes are in the description. Meshes are stored in single precision.
  for (std::size_t i = 0; i < robot.surfaces.size(); ++i) {
    if (!std::holds_alternative<MeshShape>(robot.model.shapes[i])) continue;
    digest.add(std::uint64_t{robot.surfaces[i] ? 1u : 0u});
    if (robot.surfaces[i]) digest.addSurface<float>(*robot.surfaces[i]);
  }
  return digest.text();
}

std::string ofBodies(const BodySet& bodies) {
  Digest digest;
  for (const BodyPointer& body : bodies) {
    digest.add(std::uint64_t{body->id});
    digest.add(body->carrier);
    digest.add(body->pose);
    if (const auto* primitive = dynamic_cast<const PrimitiveGeometry*>(body->geometry.get())) {
      digest.add(std::string(primitive->description().id));
      for (const double value : primitive->dimensions()) digest.addNumber(value);
    } else {
      digest.add(std::string("surface"));
      digest.addSurface<double>(*body->geometry->surface());
    }
  }
  return digest.text();
}

// Digest of what proofs leave out: pairs, and shapes that could not be read.
std::string ofLeftOut(const CellPlans& plans) {
  Digest digest;
  for (const auto& [first, second] : plans.allowed) {
    digest.add(first);
    digest.add(second);
  }
  if (plans.missingAs.empty()) return digest.text();
  digest.add(std::string("missing"));
  for (const auto& [part, by] : plans.missingAs) {
    digest.add(part);
    digest.add(by);
  }
  return digest.text();
}

std::string ofPath(const RobotPath& path) {
  Digest digest;
  digest.add(path.arm);
  digest.add(std::uint64_t{path.waypoints.size()});
  for (const Waypoint& waypoint : path.waypoints) {
    digest.add(waypoint.joints);
    digest.add(waypoint.name);
    digest.add(std::uint64_t{waypoint.isCritical ? 1u : 0u});
    digest.add(static_cast<std::uint64_t>(waypoint.motion));
    digest.addNumber(waypoint.speed);
    digest.addNumber(waypoint.blend);
  }
  for (const auto& [robot, base] : path.bases) {
    digest.add(robot);
    digest.add(base);
  }
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const auto& target = path.waypoints[i].target;
    if (!target) continue;
    digest.add(std::uint64_t{i});
    digest.add(target->name);
    digest.add(target->inTool);
  }
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    if (path.waypoints[i].configuration.empty()) continue;
    digest.add(std::uint64_t{i});
    digest.add(path.waypoints[i].configuration);
  }
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const auto& frame = path.waypoints[i].frame;
    if (!frame) continue;
    digest.add(std::string("frame"));
    digest.add(std::uint64_t{i});
    digest.add(frame->name);
    digest.add(frame->inTool);
  }
  const auto addLines = [&](std::size_t i, const std::vector<ProgramLine>& lines) {
    for (const ProgramLine& line : lines) {
      digest.add(std::uint64_t{i});
      digest.add(line.text);
      digest.add(std::uint64_t{line.mayGrip ? 1u : 0u});
    }
  };
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const Waypoint& waypoint = path.waypoints[i];
    addLines(i, waypoint.lines);
    if (waypoint.corner <= 0.0 && waypoint.seconds <= 0.0 && !waypoint.keepsCarried) continue;
    digest.add(std::uint64_t{i});
    digest.addNumber(waypoint.corner);
    digest.addNumber(waypoint.seconds);
    digest.add(std::uint64_t{waypoint.keepsCarried ? 1u : 0u});
  }
  addLines(path.waypoints.size(), path.head);
  return digest.text();
}

// Empty if no waypoint was planned to a target or read in a frame, as in proofs that were stored before these counted.
std::string ofTargets(const CellPlans& plans, const RobotPath& path) {
  const auto targets = targetsOf(plans, path);
  if (targets.empty()) return {};
  Digest digest;
  for (const auto& [target, frame] : targets) {
    digest.add(target.pose);
    digest.add(std::uint64_t{target.body});
    digest.add(frame.pose);
    digest.add(std::uint64_t{frame.body});
    digest.add(frame.link);
  }
  return digest.text();
}

// Empty if no waypoint is at a configuration, as above.
std::string ofConfigurations(const RobotCellSnapshot& cell, const RobotPath& path) {
  const auto configurations = configurationsOf(*cell.robot, *cell.plans, path);
  if (configurations.empty()) return {};
  Digest digest;
  for (const std::vector<double>& values : configurations) {
    digest.add(std::uint64_t{values.size()});
    for (const double value : values) digest.addNumber(value);
  }
  return digest.text();
}

// Empty for the rates that proofs were made with before these could be set.
std::string ofRates(const AssumedRates& rates) {
  if (rates == AssumedRates()) return {};
  Digest digest;
  for (const double value : {rates.turning, rates.sliding, rates.timeToSpeed, rates.timeToRamp})
    digest.addNumber(value);
  return digest.text();
}

// The values of the joints that the path sets do not count.
std::string ofJoints(const RobotCellSnapshot& cell, const std::string& arm) {
  JointValues others = cell.joints;
  for (const std::uint32_t dof : plannedDofs(*cell.robot, arm)) others[dof] = 0.0;
  Digest digest;
  digest.add(others);
  return digest.text();
}

template <class Value>
std::string ofValue(const Value& value) {
  Digest digest;
  if constexpr (std::is_same_v<Value, double>)
    digest.addNumber(value);
  else
    digest.add(value);
  return digest.text();
}

}  // namespace

PathDigests::PathDigests(std::shared_ptr<const RobotCellSnapshot> cell, const PathDigests* former)
    : m_cell(std::move(cell)),
      m_robots(former && former->m_cell->robot == m_cell->robot ? former->m_robots : ofRobots(*m_cell->robot)),
      m_bodies(former && former->m_cell->bodies == m_cell->bodies ? former->m_bodies : ofBodies(m_cell->bodies)),
      m_allowed(ofLeftOut(*m_cell->plans)) {}

BasisDigests PathDigests::of(const RobotPath& path) const {
  const CellPlans& plans = *m_cell->plans;
  return {m_robots,
          ofPath(path),
          ofJoints(*m_cell, path.arm),
          m_bodies,
          m_allowed,
          ofValue(toolOf(*m_cell->robot, plans, path.arm)),
          ofValue(plans.clearanceOf(path)),
          ofTargets(plans, path),
          ofConfigurations(*m_cell, path),
          ofRates(plans.rates)};
}

BasisChange changeBetween(const BasisDigests& then, const BasisDigests& now) {
  const auto differs = std::mismatch(then.begin(), then.end(), now.begin());
  if (differs.first == then.end()) return BasisChange::Nothing;
  return static_cast<BasisChange>(1 + (differs.first - then.begin()));
}

}  // namespace handwheel
