// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace handwheel {

// The types of joints.
enum class JointKind {
  Fixed,
  Revolute,
  Continuous,  // revolute without limits
  Prismatic,
};

// The limit of every joint's position, so that dependent values stay finite; rad, mm.
inline constexpr double kFarthestTravel = 1e9;

// The limit of revolute joints in paths, ± from 0 (150 turns), so that motions are short enough to be proven; rad.
inline constexpr double kMostTurn = 1e3;

// The limits of a joint's position, velocity and effort.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();  // rad, mm
  double upper = std::numeric_limits<double>::infinity();
  std::optional<double> velocity = {};  // rad/s, mm/s; none if the file gives none, or 0
  std::optional<double> effort = {};    // N m, N; likewise

  bool areClosed() const { return lower == upper; }  // the joint cannot move
};

// A joint between two links. Its position is factor · value(dof) + offset: one degree of freedom may move several
// joints.
struct Joint {
  std::string name;
  JointKind kind = JointKind::Fixed;
  std::uint32_t parent = kNone;    // link
  std::uint32_t child = kNone;     // link
  Pose origin = Pose::Identity();  // pose of the child in the parent at position 0
  Vec3 axis = Vec3::UnitX();       // in the child's frame, of unit length
  JointLimits limits = {};
  std::uint32_t dof = kNone;  // none: the joint stays at offset
  double factor = 1.0;        // from the unit of the degree of freedom to the joint's
  double offset = 0.0;        // rad, mm

  // Returns the nearest allowed value: none beyond kFarthestTravel, and for a revolute joint with limits none beyond
  // kMostTurn. The reader accepts only joints that have such a value.
  double nearest(double value) const {
    const double most = kind == JointKind::Revolute ? kMostTurn : kFarthestTravel;
    return std::min(std::max({std::min(value, limits.upper), limits.lower, -most}), most);
  }
};

// A box as the shape of a link.
struct BoxShape {
  Vec3 size;  // mm, centred
  bool operator==(const BoxShape&) const = default;
};
// A cylinder as the shape of a link.
struct CylinderShape {
  double radius, length;  // mm, along z, centred
  bool operator==(const CylinderShape&) const = default;
};
// A sphere as the shape of a link.
struct SphereShape {
  double radius;  // mm
  bool operator==(const SphereShape&) const = default;
};
// A triangle mesh in a file as the shape of a link.
struct MeshShape {
  std::string file;  // the name in the description: "package://name/part.stl"
  Vec3 scale;        // factor of the numbers in the file, which are metres
  bool operator==(const MeshShape&) const = default;
};
using Shape = std::variant<BoxShape, CylinderShape, SphereShape, MeshShape>;

using ShapeColour = std::array<float, 3>;  // sRGB, 0…1

// A shape at a pose in a link.
struct PlacedShape {
  std::uint32_t shape = kNone;     // index in RobotModel::shapes
  Pose origin = Pose::Identity();  // in the frame of the link
  std::optional<ShapeColour> colour;
};

// A link with its visual and collision shapes.
struct Link {
  std::string name;
  std::uint32_t parentJoint = kNone;  // none for the root
  std::vector<PlacedShape> visuals;
  std::vector<PlacedShape> collisions;
};

// A robot, or several of a cell (RobotArms.h): a tree of links connected by joints. Names of links are unique, so are
// those of joints. Immutable once read; any thread.
struct RobotModel {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Shape> shapes;         // each once, even if it is used several times
  std::vector<std::uint32_t> order;  // all joints, each after the one that moves its parent
  std::vector<std::uint32_t> dofs;   // per degree of freedom: the joint that gives it name, kind and limits
  std::uint32_t root = kNone;        // link

  const Joint& jointOfDof(std::size_t dof) const { return joints[dofs[dof]]; }
};

// One value per degree of freedom; rad, mm.
using JointValues = Eigen::VectorXd;

// Finds a link by its name. Returns kNone if there is no such link. O(links).
std::uint32_t linkNamed(const RobotModel& robot, std::string_view name);

// Finds the link to which a tool is attached. This is a leaf, if possible a fixed one without a body ("tool0",
// "flange") behind at least half of the degrees of freedom, since there may be fingers that move beside it; of these
// the one that most of them move, then the one at the end of most joints, then the first in the file.
std::uint32_t toolLink(const RobotModel& robot);

// Finds the degree of freedom nearest to a link in its chain of joints. kNone for links that cannot move.
std::uint32_t dofMoving(const RobotModel& robot, std::uint32_t link);

// Clamps joint values to their limits, revolute joints to ±kMostTurn, too: the range in paths and their files.
// Continuous joints keep their turns, as a path may be wound up; those that no other follows lose them beyond
// kMostTurn, and are then within -π…π. Values must be finite. O(joints).
JointValues withinLimits(const RobotModel& robot, JointValues values);

// Returns the values to reach by the shortest turn: whole turns of continuous joints that no other follows are removed.
// O(joints).
JointValues byShortestTurn(const RobotModel& robot, const JointValues& from, JointValues to);

// Returns the rest values of the joints: zero, or the limit nearest to it.
JointValues restValues(const RobotModel& robot);

}  // namespace handwheel
