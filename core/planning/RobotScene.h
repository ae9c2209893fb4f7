// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ObstacleSet.h"
#include "collision/ProximityQuery.h"
#include "robot/SrdfReader.h"
#include "robot/arm/SerialArm.h"

#include <functional>

namespace handwheel {

// A robot among obstacles, prepared for planning. It contains the planned joints and all links; the other joints do not
// move. After the last change its const functions may be called on any thread.
class RobotScene {
 public:
  // Prepares a robot without obstacles. base: the pose of the root in the world. bodies: the collision body of each
  // link, which may be empty. dofs: the degrees of freedom that are planned. values: all joint values of the robot,
  // which fix the other joints. allowed: the pairs of links whose collisions are ignored.
  RobotScene(const RobotModel& robot, const Pose& base, std::vector<CollisionBody> bodies,
             const std::vector<std::uint32_t>& dofs, const JointValues& values, const std::set<LinkPair>& allowed);
  // Returns the error ElementMalformed {robot, reason} if a planned joint is geared, if it moves other joints, or if
  // there are too many planned joints.
  Status isSound() const { return m_status; }

  // Returns the pairs of links that intersect at every random configuration, as closely connected links do. Such
  // collisions are meaningless and can be excluded by allowPairs(). The result is deterministic. samples: the number of
  // configurations.
  std::set<LinkPair> alwaysMeeting(int samples = 200) const;
  // Returns the pairs of links with at most two planned joints between them that intersect at these values. Examples
  // are wrist housings that are drawn larger than they are.
  std::set<LinkPair> closePairsMeeting(const ArmValues& values) const;
  // Returns the number of planned joints between two links. The result is 0 if the pair is not checked for collisions,
  // for example because a link has no shape.
  int jointsBetween(const LinkPair& links) const;
  void allowPairs(const std::set<LinkPair>& pairs);

  // Adds an obstacle. owner: a number chosen by the caller to identify it.
  void addObstacle(const CollisionBody& body, const Pose& pose, std::uint32_t owner);
  // Ignores collisions of this link with obstacles of this owner.
  void allow(std::uint32_t link, std::uint32_t owner);

  Eigen::Index size() const { return static_cast<Eigen::Index>(m_joints.size()); }
  const ArmJoint& joint(Eigen::Index i) const { return m_joints[static_cast<std::size_t>(i)].joint; }
  bool isWithinLimits(const ArmValues& values, double slack = 1e-9) const;
  // Sets the coupling of the planned arm, which must have at least three joints. As its limits are linear in the
  // joints, a motion between two configurations within them is within them, too.
  void setCoupling(const std::optional<AxisCoupling>& coupling) { m_coupling = coupling; }
  bool isCouplingWithin(const ArmValues& values) const { return !m_coupling || m_coupling->isWithin(values); }

  // Computes the poses of the frames that the joints move, in the world. poses: one element for each joint.
  void jointPoses(const ArmValues& values, std::span<Pose> poses) const;

  // The nearest pair and its distance.
  struct Nearest {
    double distance;                  // mm; at most 0: the objects intersect or touch
    std::uint32_t link = kNone;       // kNone: no pair is near enough
    std::uint32_t otherLink = kNone;  // the nearest object, if it is a link
    std::uint32_t owner = kNone;      // the nearest object, if it is an obstacle
  };
  // Returns the least distance of the links from obstacles and from each other, if it is below `enough`.
  Nearest nearest(const ArmValues& values, double enough, QueryCounts* counts = nullptr) const;
  // Returns the least distance of the links from obstacles, if it is below `enough`.
  Nearest nearestObstacle(const ArmValues& values, double enough, QueryCounts* counts = nullptr) const;
  // Returns the least distance of the links from a body that is not one of the obstacles, if it is below `enough`.
  // without: the links to ignore.
  Nearest nearestTo(const CollisionBody& body, const Pose& pose, const ArmValues& values, double enough,
                    std::span<const std::uint32_t> without = {}) const;
  // Returns the pair that violates its clearance most, or a result without a link if there is no violation. clearance:
  // mm, between links and obstacles. ownClearance: mm, between links.
  Nearest tooNear(const ArmValues& values, double clearance, double ownClearance, QueryCounts* counts = nullptr) const;
  // Returns true if no pair violates its clearance. Faster than tooNear().
  bool isFree(const ArmValues& values, double clearance, double ownClearance, QueryCounts* counts = nullptr) const;
  // Returns all pairs that violate their clearance: links with owners of obstacles, and pairs of links.
  std::vector<Nearest> allTooNear(const ArmValues& values, double clearance, double ownClearance) const;
  // Returns the contacts of the link and the other object in `nearest`, in the world, with the points of the link
  // first. These are the contacts of all their triangles and solids (see addContacts()), sorted by depth, the deepest
  // first; or the closest points if there is no contact. Only `most` contacts are examined. displacement: the
  // displacement of the whole robot, if it is moved with its base.
  std::vector<ClosestPoints> touches(const ArmValues& values, const Nearest& nearest, std::size_t most,
                                     const Pose& displacement = Pose::Identity()) const;
  // Returns the contacts of all links except `without` with a body that is not one of the obstacles. most: the number
  // of contacts that are examined.
  std::vector<ClosestPoints> touches(const ArmValues& values, const CollisionBody& body, const Pose& pose,
                                     std::size_t most, std::span<const std::uint32_t> without = {}) const;
  // Returns all pairs of links that intersect or touch, with their depth as a distance of at most 0 (see
  // ClosestPoints).
  std::vector<Nearest> overlappingLinks(const ArmValues& values) const;
  // Returns the collisions with obstacles after the robot is displaced as a whole, with its base. Parts that do not
  // move and already touch an obstacle, such as a foot on a floor, may continue to touch it. isOver: a function that is
  // called before each part; if it returns true, the search ends, and the result is incomplete.
  std::vector<Nearest> metWhenMoved(const ArmValues& values, const Pose& displacement,
                                    const std::function<bool()>& isOver = {}) const;
  // Returns a query of the distances of the moving links from the obstacles. joints: receives the joint that moves each
  // of the query's first bodies; the other bodies do not move.
  ProximityQuery approachQuery(std::vector<std::uint32_t>& joints) const;
  // An object of the scene: a link, or all obstacles of an owner.
  struct Object {
    std::uint32_t link = kNone, owner = kNone;
  };
  enum class HeldRole { Held, Near, LeftOut };
  // Returns a query of the distances between the objects that a hand holds and those near them, at these values. The
  // poses of its bodies are displacements. Pairs in which a collision is ignored are not tested (see allow()). role:
  // the role of each object. held: receives the number of held objects, which are the query's first bodies.
  ProximityQuery heldQuery(const ArmValues& values, const std::function<HeldRole(const Object&)>& role,
                           std::uint32_t& held) const;
  // Returns the next joint towards the base; kNone for the first joint.
  std::uint32_t parentOf(std::uint32_t joint) const { return m_joints[joint].parent; }
  // Returns an upper bound of the deviation of any point of the robot at these values, if each joint deviates by at
  // most `spread`; mm.
  double travelBound(const ArmValues& values, const ArmValues& spread) const;
  // Returns an upper bound of the deviation of any point of the robot for all configurations of a straight motion, if
  // each joint deviates by at most `spread`; mm. The bound is computed from the middle of the motion and the change of
  // the points' distances from the joint axes towards its ends.
  double travelBound(const ArmValues& from, const ArmValues& to, const ArmValues& spread) const;
  // Returns true if all pairs keep their clearance while each joint deviates from these values by at most `spread`.
  bool isFreeAround(const ArmValues& values, const ArmValues& spread, double clearance, double ownClearance) const;

 private:
  friend class MotionCheck;
  struct MovedJoint {
    ArmJoint joint;
    std::uint32_t parent = kNone;  // index in m_joints; kNone: the base
    double reach = 0.0;            // mm: largest distance from the axis of a point that the joint moves
  };
  struct Part {
    std::uint32_t link;
    std::uint32_t joint;                 // index in m_joints; kNone: the part does not move
    CollisionBody body;                  // in the frame of the joint, or in the world for a part that does not move
    std::vector<std::uint32_t> leftOut;  // owners of obstacles to ignore
  };
  struct Pair {
    std::uint32_t first, second;  // parts
    std::uint32_t common;         // the nearest joint that moves both parts; kNone: the base
  };
  // The parts that a joint carries, or the parts that do not move, with a sphere around them.
  struct Group {
    std::uint32_t joint;
    std::uint32_t begin, end;  // range in m_parts
    Vec3 centre;               // in the frame of the joint
    double radius;
  };
  struct GroupPair {
    std::uint32_t first, second, common;  // indices of the groups; common: see Pair
    std::uint32_t begin, end;             // range in m_pairs
  };

  int jointsBetween(const Pair& pair) const;

  // The poses of the joint frames at given joint values, in the world.
  struct Poses {
    std::array<Pose, kMostArmJoints> joints;
    Pose world = Pose::Identity();
    const Pose& of(std::uint32_t joint) const { return joint == kNone ? world : joints[joint]; }
  };
  // Adds the planned joints. mover, pose: on entry kNone and the pose of the base for each link; they receive the
  // planned joint that moves each link, and the pose of the link in the frame of this joint.
  Status addJoints(const RobotModel& robot, const std::vector<std::uint32_t>& dofs, const JointValues& values,
                   std::vector<std::uint32_t>& mover, std::vector<Pose>& pose);
  void findPairs(const std::set<LinkPair>& allowed);
  void findGroups();
  void findReaches();
  void groupPairs();
  void posesAt(const ArmValues& values, Poses& poses) const;
  Nearest nearestObstacle(const Poses& poses, double enough, QueryCounts* counts) const;
  Nearest nearestLinks(const Poses& poses, double enough, QueryCounts* counts) const;
  // Returns the least distance of a group from the obstacles, or of two groups from each other, if it is below
  // `enough`.
  Nearest nearestOf(const Group& group, const Poses& poses, double enough, QueryCounts* counts) const;
  Nearest nearestOf(const GroupPair& pair, const Poses& poses, double enough, QueryCounts* counts) const;
  // Returns the obstacles near a group. The result is valid until the next call on the same thread.
  std::span<const std::uint32_t> near(const Group& group, const Poses& poses, double enough, QueryCounts* counts) const;
  // Allowance for rounding, relative to lengths; far larger than the rounding errors of poses and distances.
  static constexpr double kRounding = 1e-9;
  // Lists the obstacles nearer to a part than the clearance, except those of the owners in leftOut.
  void listNear(const Part& part, const Pose& pose, double clearance, std::vector<std::uint32_t> leftOut,
                std::vector<Nearest>& all) const;
  // Returns an upper bound of the speed of points in a sphere around `centre` (in the frame of `joint`), relative to
  // the frame of the joint `below`. The bound holds while the joints move at most at these rates, for the time `half`
  // before and after these poses.
  double speedOf(const ArmValues& rates, std::uint32_t joint, const Vec3& centre, double radius, std::uint32_t below,
                 double half, const Poses& poses) const;
  // Returns true if the spheres of two groups are at least this far from each other.
  bool areApart(const GroupPair& pair, const Poses& poses, double enough) const;
  double pairDistance(const Pair& pair, const Poses& poses, double enough, QueryCounts* counts) const;

  std::vector<MovedJoint> m_joints;  // parents first
  std::vector<Part> m_parts;         // sorted by joint; parts that do not move are the last
  std::vector<Group> m_groups;       // the farthest from the base first, because they collide most often
  std::vector<Pair> m_pairs;         // sorted by groups
  std::vector<GroupPair> m_groupPairs;
  ObstacleSet m_obstacles;
  std::optional<AxisCoupling> m_coupling;
  Status m_status = Done{};
};

// Returns the joint values `to`, with whole turns added to or removed from joints without limits so that each turns by
// at most half a turn from `from`.
ArmValues byShortestTurn(const RobotScene& scene, const ArmValues& from, ArmValues to);

}  // namespace handwheel
