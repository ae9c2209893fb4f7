// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ObstacleSet.h"
#include "collision/ProximityQuery.h"
#include "robot/SrdfReader.h"
#include "robot/arm/SerialArm.h"

#include <functional>

namespace handwheel {

// A robot among obstacles, prepared for planning. It has the joints that are planned and the links that they move. The
// other joints do not move. Immutable once filled; any thread.
class RobotScene {
 public:
  // base: pose of the root in the world. bodies: one of each link, may be empty. dofs: planned degrees of freedom of
  // the robot. all values: of the robot; they fix the other joints. allowed: pairs of links.
  RobotScene(const RobotModel& robot, const Pose& base, std::vector<CollisionBody> bodies,
             const std::vector<std::uint32_t>& dofs, const JointValues& values, const std::set<LinkPair>& allowed);
  // Returns the error ElementMalformed {robot, reason} if a planned joint is geared or moves with others, or there are
  // too many.
  Status isSound() const { return m_status; }

  // Returns the pairs of links that meet at each of so many random configurations, as those of closely connected links
  // do. Their collisions mean nothing; allowPairs() excludes them. Deterministic.
  std::set<LinkPair> alwaysMeeting(int samples = 200) const;
  // Returns the pairs of links with at most two planned joints between them that meet at these values, as wrist
  // housings do that are drawn larger than they are.
  std::set<LinkPair> closePairsMeeting(const ArmValues& values) const;
  // Returns the number of joints between two links; 0 also if one has no shape.
  int jointsBetween(const LinkPair& links) const;
  void allowPairs(const std::set<LinkPair>& pairs);

  // owner: a number chosen by the caller.
  void addObstacle(const CollisionBody& body, const Pose& pose, std::uint32_t owner);
  // Ignores collisions of this link with obstacles of this owner.
  void allow(std::uint32_t link, std::uint32_t owner);

  Eigen::Index size() const { return static_cast<Eigen::Index>(m_joints.size()); }
  const ArmJoint& joint(Eigen::Index i) const { return m_joints[static_cast<std::size_t>(i)].joint; }
  bool isWithinLimits(const ArmValues& values, double slack = 1e-9) const;

  // Computes the poses of the frames that the joints move, in the world. poses: as many as there are joints.
  void jointPoses(const ArmValues& values, std::span<Pose> poses) const;

  // The nearest pair and its distance.
  struct Nearest {
    double distance;                  // mm; at most 0: they meet
    std::uint32_t link = kNone;       // kNone: nothing is nearer than asked for
    std::uint32_t otherLink = kNone;  // the nearest object: a link,
    std::uint32_t owner = kNone;      // or an obstacle
  };
  // Returns the least distance of the links from obstacles and each other if it is below `enough`.
  Nearest nearest(const ArmValues& values, double enough, QueryCounts* counts = nullptr) const;
  // Returns the same for the obstacles alone.
  Nearest nearestObstacle(const ArmValues& values, double enough, QueryCounts* counts = nullptr) const;
  // Returns the distance of the links from a body that is none of the obstacles, if it is below `enough`. without:
  // links to ignore.
  Nearest nearestTo(const CollisionBody& body, const Pose& pose, const ArmValues& values, double enough,
                    std::span<const std::uint32_t> without = {}) const;
  // Returns the pair that violates its clearance most: `clearance` for obstacles, `ownClearance` for links and each
  // other. No link: none does.
  Nearest tooNear(const ArmValues& values, double clearance, double ownClearance, QueryCounts* counts = nullptr) const;
  // Returns true if nothing is too near. Faster than tooNear().
  bool isFree(const ArmValues& values, double clearance, double ownClearance, QueryCounts* counts = nullptr) const;
  // Returns all violations: each link with each owner of obstacles, and each pair of links.
  std::vector<Nearest> allTooNear(const ArmValues& values, double clearance, double ownClearance) const;
  // Returns the contacts of a link with the object nearest to it, with the points of the link first, in the world: the
  // contacts of all their triangles and solids (see addContacts()), the deepest first; if none touch, the closest
  // points. Only `most` contacts are examined. displacement: of the robot as a whole, if it is moved with its base.
  std::vector<ClosestPoints> touches(const ArmValues& values, const Nearest& nearest, std::size_t most,
                                     const Pose& displacement = Pose::Identity()) const;
  // Returns the same for all links except `without`, with a body that is none of the obstacles.
  std::vector<ClosestPoints> touches(const ArmValues& values, const CollisionBody& body, const Pose& pose,
                                     std::size_t most, std::span<const std::uint32_t> without = {}) const;
  // Returns all pairs of links that meet, with the depth as a distance below 0 (see ClosestPoints).
  std::vector<Nearest> overlappingLinks(const ArmValues& values) const;
  // Returns the collisions with obstacles after the robot, with its base, is displaced as a whole. Parts that do not
  // move and already meet an obstacle, as a foot its floor, may go on meeting it. isOver: called before each part, ends
  // the search; the result is then partial.
  std::vector<Nearest> metWhenMoved(const ArmValues& values, const Pose& displacement,
                                    const std::function<bool()>& isOver = {}) const;
  // Returns a query of the distances of the moving links from the obstacles. joints: receives the joint that moves each
  // of its first bodies; the others do not move.
  ProximityQuery approachQuery(std::vector<std::uint32_t>& joints) const;
  // Returns the next joint towards the base; kNone: it is the first.
  std::uint32_t parentOf(std::uint32_t joint) const { return m_joints[joint].parent; }
  // Returns an upper bound of the deviation of any point of the robot at these values, if each joint deviates by at
  // most `spread`; mm.
  double travelBound(const ArmValues& values, const ArmValues& spread) const;
  // Returns the same bound for all configurations of a motion, from its middle and the change of the levers to either
  // end.
  double travelBound(const ArmValues& from, const ArmValues& to, const ArmValues& spread) const;
  // Returns true if everything keeps its clearance while each joint deviates from these values by at most `spread`.
  bool isFreeAround(const ArmValues& values, const ArmValues& spread, double clearance, double ownClearance) const;

 private:
  friend class MotionCheck;
  struct MovedJoint {
    ArmJoint joint;
    std::uint32_t parent = kNone;  // in m_joints; kNone: the base
    double reach = 0.0;            // mm: largest distance of a point that it moves from its axis
  };
  struct Part {
    std::uint32_t link;
    std::uint32_t joint;                 // in m_joints; kNone: it does not move
    CollisionBody body;                  // in the frame of the joint, or in the world
    std::vector<std::uint32_t> leftOut;  // owners
  };
  struct Pair {
    std::uint32_t first, second;  // parts
    std::uint32_t common;         // the nearest joint that moves both; kNone: the base
  };
  // The parts that a joint carries, or those that do not move, with a sphere around all of them.
  struct Group {
    std::uint32_t joint;
    std::uint32_t begin, end;  // in m_parts
    Vec3 centre;               // in the frame of the joint
    double radius;
  };
  struct GroupPair {
    std::uint32_t first, second, common;  // groups; common: see Pair
    std::uint32_t begin, end;             // in m_pairs
  };

  int jointsBetween(const Pair& pair) const;

  // The poses of the joint frames at some values, in the world.
  struct Poses {
    std::array<Pose, kMostArmJoints> joints;
    Pose world = Pose::Identity();
    const Pose& of(std::uint32_t joint) const { return joint == kNone ? world : joints[joint]; }
  };
  // Adds the planned joints. mover, pose: receive the planned joint that moves each link, and the pose of the link in
  // that joint's frame; on entry kNone and the pose of the base.
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
  // Returns the obstacles near a group; valid until the next call of this thread.
  std::span<const std::uint32_t> near(const Group& group, const Poses& poses, double enough, QueryCounts* counts) const;
  static constexpr double kRounding =
      1e-9;  // relative to lengths: far above the rounding of sums of poses and distances
  // Lists the obstacles nearer to a part than the clearance, except for owners that are left out.
  void listNear(const Part& part, const Pose& pose, double clearance, std::vector<std::uint32_t> leftOut,
                std::vector<Nearest>& all) const;
  // Returns the largest speed of points in a sphere (in the frame of a joint), relative to the frame of the joint
  // `below`, while the joints move at most at these rates, for `half` of the time before and after these poses.
  double speedOf(const ArmValues& rates, std::uint32_t joint, const Vec3& centre, double radius, std::uint32_t below,
                 double half, const Poses& poses) const;
  // Returns true if the spheres of two groups are at least this far from each other.
  bool areApart(const GroupPair& pair, const Poses& poses, double enough) const;
  double pairDistance(const Pair& pair, const Poses& poses, double enough, QueryCounts* counts) const;

  std::vector<MovedJoint> m_joints;  // parents first
  std::vector<Part> m_parts;         // by joint, those that do not move last
  std::vector<Group> m_groups;       // the farthest from the base first: they collide most often
  std::vector<Pair> m_pairs;         // by groups
  std::vector<GroupPair> m_groupPairs;
  ObstacleSet m_obstacles;
  Status m_status = Done{};
};

}  // namespace handwheel
