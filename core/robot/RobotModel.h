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

// The limit of the position of every joint; rad, mm. It keeps dependent values finite.
inline constexpr double kFarthestTravel = 1e9;

// The limit of revolute joints in paths, in both directions (about 160 turns); rad. It keeps motions short enough to be
// proven free.
inline constexpr double kMostTurn = 1e3;

// The limits of a joint's position, velocity and effort.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();  // rad, mm
  double upper = std::numeric_limits<double>::infinity();
  std::optional<double> velocity = {};  // rad/s, mm/s; nothing if the file gives no limit, or 0
  std::optional<double> effort = {};    // N·m, N; nothing if the file gives no limit, or 0

  bool areClosed() const { return lower == upper; }  // true if the joint cannot move
};

// A joint between two links. Its position is factor · value(dof) + offset, so that one degree of freedom may move
// several joints.
struct Joint {
  std::string name;
  JointKind kind = JointKind::Fixed;
  std::uint32_t parent = kNone;    // link
  std::uint32_t child = kNone;     // link
  Pose origin = Pose::Identity();  // pose of the child in the parent at position 0
  Vec3 axis = Vec3::UnitX();       // in the child's frame, of unit length
  JointLimits limits = {};
  std::uint32_t dof = kNone;  // kNone: the joint stays at `offset`
  double factor = 1.0;        // unit of the joint per unit of the degree of freedom
  double offset = 0.0;        // rad, mm

  // Returns the allowed value nearest to a given value. The result is never beyond kFarthestTravel, nor beyond
  // kMostTurn for a revolute joint with limits. The reader accepts only joints that have an allowed value.
  double nearest(double value) const {
    const double most = kind == JointKind::Revolute ? kMostTurn : kFarthestTravel;
    return std::min(std::max({std::min(value, limits.upper), limits.lower, -most}), most);
  }
};

// A box as the shape of a link.
struct BoxShape {
  Vec3 size;  // full sizes, mm; centred
  bool operator==(const BoxShape&) const = default;
};
// A cylinder as the shape of a link.
struct CylinderShape {
  double radius, length;  // mm; along z, centred
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
  Vec3 scale;        // factors for the coordinates in the file, which are in metres
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
  std::uint32_t parentJoint = kNone;  // kNone for the root
  std::vector<PlacedShape> visuals;
  std::vector<PlacedShape> collisions;
  // Elements of the shapes that could not be read ("capsule"; empty: there was none). Nothing is known of them.
  std::vector<std::string> unreadVisuals = {};
  std::vector<std::string> unreadCollisions = {};

  bool isSolid() const { return !collisions.empty() || !unreadCollisions.empty(); }  // It has collision shapes
};

// A robot, or several robots of a cell (RobotArms.h). It is a tree of links connected by joints. The names of links are
// unique, and so are the names of joints. After reading, it is not changed and may be used on any thread.
struct RobotModel {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Shape> shapes;         // each shape once, even if it is used several times
  std::vector<std::uint32_t> order;  // all joints, each after the one that moves its parent
  std::vector<std::uint32_t> dofs;   // for each degree of freedom: the joint that defines its name, kind and limits
  std::uint32_t root = kNone;        // index of the root link

  const Joint& jointOfDof(std::size_t dof) const { return joints[dofs[dof]]; }
};

// One value per degree of freedom; rad, mm.
using JointValues = Eigen::VectorXd;

// Finds a link by its name. Returns kNone if there is no such link. O(links).
std::uint32_t linkNamed(const RobotModel& robot, std::string_view name);

// Finds the link to which a tool is attached. Candidates are leaves; fixed links without shapes ("tool0", "flange")
// that at least half of the degrees of freedom move are preferred, since fingers may move beside them. Among these the
// function chooses the link that most degrees of freedom move, then the one at the end of most joints, then the first
// in the file.
std::uint32_t toolLink(const RobotModel& robot);

// Finds the degree of freedom nearest to a link in its chain of joints. Returns kNone for a link that cannot move.
std::uint32_t dofMoving(const RobotModel& robot, std::uint32_t link);

// Clamps joint values to their limits, and revolute and continuous joints also to ±kMostTurn, the range in paths and
// their files. A continuous joint that no other joint follows is not clamped beyond kMostTurn: whole turns are removed,
// so that its value is within -π…π. Values must be finite. O(joints).
JointValues withinLimits(const RobotModel& robot, JointValues values);

// Returns the joint values `to`, with whole turns added to or removed from continuous joints so that each turns by at
// most half a turn from `from`. Joints that other joints follow stay the same. O(joints).
JointValues byShortestTurn(const RobotModel& robot, const JointValues& from, JointValues to);

// Returns the rest values of the joints: zero, or the limit nearest to it.
JointValues restValues(const RobotModel& robot);

}  // namespace handwheel
