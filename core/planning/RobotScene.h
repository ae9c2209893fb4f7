// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ObstacleSet.h"
#include "collision/ProximityQuery.h"
#include "robot/SrdfReader.h"
#include "robot/arm/SerialArm.h"

#include <functional>

namespace handwheel {

// A robot among obstacles, prepared for planning. It has the joints that are planned, and what they move. The other
// joints stand. Immutable once filled; any thread.
class RobotScene {
 public:
  // base: of the root in the world. bodies: of each link, may be empty. dofs: of the robot, that are planned; all
  // values: of the robot, of which those of the others count. allowed: pairs of links.
  RobotScene(const RobotModel& robot, const Pose& base, std::vector<CollisionBody> bodies,
             const std::vector<std::uint32_t>& dofs, const JointValues& values, const std::set<LinkPair>& allowed);
  // Error ElementMalformed {robot, reason}: a planned joint is geared or moves with others, or there are too many.
  Status isSound() const { return m_status; }

  // The pairs of links that meet however the joints stand, as those of which one hangs closely on the other: at each of
  // so many random places. Their collisions tell nothing; allowPairs() leaves them out. Deterministic.
  std::set<LinkPair> alwaysMeeting(int samples = 200) const;
  // The pairs of links with at most two planned joints between them that meet at these values, as housings of wrists do
  // that are drawn larger than they are.
  std::set<LinkPair> closePairsMeeting(const ArmValues& values) const;
  // How many joints move one of two links against the other; 0 also where one has no shape.
  int jointsBetween(const LinkPair& links) const;
  void allowPairs(const std::set<LinkPair>& pairs);

  // owner: a number of the caller's.
  void addObstacle(const CollisionBody& body, const Pose& pose, std::uint32_t owner);
  // Collisions of this link with obstacles of this owner do not count.
  void allow(std::uint32_t link, std::uint32_t owner);

  Eigen::Index size() const { return static_cast<Eigen::Index>(m_joints.size()); }
  const ArmJoint& joint(Eigen::Index i) const { return m_joints[static_cast<std::size_t>(i)].joint; }
  bool isWithinLimits(const ArmValues& values, double slack = 1e-9) const;

  // The poses of the frames that the joints move, in the world. poses: as many as there are joints.
  void jointPoses(const ArmValues& values, std::span<Pose> poses) const;

  // What is nearest, and how near.
  struct Nearest {
    double distance;                  // mm; at most 0: they meet
    std::uint32_t link = kNone;       // kNone: nothing is nearer than asked for
    std::uint32_t otherLink = kNone;  // what it is nearest to: a link,
    std::uint32_t owner = kNone;      // or an obstacle
  };
  // The least distance of the links from obstacles and each other where it is below `enough`.
  Nearest nearest(const ArmValues& values, double enough, QueryCounts* counts = nullptr) const;
  // The same of the obstacles alone.
  Nearest nearestObstacle(const ArmValues& values, double enough, QueryCounts* counts = nullptr) const;
  // The distance of the links from a body that is none of the obstacles, where it is below `enough`. without: links
  // that do not count.
  Nearest nearestTo(const CollisionBody& body, const Pose& pose, const ArmValues& values, double enough,
                    std::span<const std::uint32_t> without = {}) const;
  // What meets, or is nearer than it may be: of obstacles nearer than `clearance`, of links to each other
  // `ownClearance`; the one that is nearer by most. No link: nothing is.
  Nearest tooNear(const ArmValues& values, double clearance, double ownClearance, QueryCounts* counts = nullptr) const;
  // Whether nothing is. Quicker than to ask what is.
  bool isFree(const ArmValues& values, double clearance, double ownClearance, QueryCounts* counts = nullptr) const;
  // All that is: each link with each owner of obstacles, and each pair of links.
  std::vector<Nearest> allTooNear(const ArmValues& values, double clearance, double ownClearance) const;
  // Where a link touches what it is nearest to, with the points of the link first, in the world: the contacts of all
  // their triangles and solids (see addContacts()), the deepest first; where none touch, the closest points. Of so many
  // that are looked at. way: of the robot as a whole, where it is moved with its base.
  std::vector<ClosestPoints> touches(const ArmValues& values, const Nearest& nearest, std::size_t most,
                                     const Pose& way = Pose::Identity()) const;
  // The same of all links but these with a body that is none of the obstacles.
  std::vector<ClosestPoints> touches(const ArmValues& values, const CollisionBody& body, const Pose& pose,
                                     std::size_t most, std::span<const std::uint32_t> without = {}) const;
  // All pairs of links that meet, with the depth as a distance below 0 (see ClosestPoints).
  std::vector<Nearest> overlappingLinks(const ArmValues& values) const;
  // What meets obstacles with the robot moved as a whole, its base, too, while these stand. Parts that stand and meet
  // an obstacle where they are, as a foot its floor, may go on meeting it. isOver: asked before each part, ends the
  // search; what was found by then is returned.
  std::vector<Nearest> metWhenMoved(const ArmValues& values, const Pose& way,
                                    const std::function<bool()>& isOver = {}) const;
  // A query of how near what the joints move is to the obstacles. joints: which joint moves each of its first bodies;
  // the others stand.
  ProximityQuery approachQuery(std::vector<std::uint32_t>& joints) const;
  // The joint next to this one on the way to the base; kNone: it is the first.
  std::uint32_t parentOf(std::uint32_t joint) const { return m_joints[joint].parent; }
  // How far a point of the robot can be from where it is at these values, when each joint is off by at most so much;
  // mm.
  double travelBound(const ArmValues& values, const ArmValues& spread) const;
  // The same from any place of a motion, by its middle and by how much levers change to either end.
  double travelBound(const ArmValues& from, const ArmValues& to, const ArmValues& spread) const;
  // Whether everything keeps its clearance wherever each joint is, off these values by at most so much.
  bool isFreeAround(const ArmValues& values, const ArmValues& spread, double clearance, double ownClearance) const;

 private:
  friend class MotionCheck;
  struct MovedJoint {
    ArmJoint joint;
    std::uint32_t parent = kNone;  // in m_joints; kNone: the base
    double reach = 0.0;            // mm: how far a point that it moves can be from its axis
  };
  struct Part {
    std::uint32_t link;
    std::uint32_t joint;                 // in m_joints; kNone: it stands
    CollisionBody body;                  // in the frame of the joint, or in the world
    std::vector<std::uint32_t> leftOut;  // owners
  };
  struct Pair {
    std::uint32_t first, second;  // parts
    std::uint32_t common;         // the nearest joint that moves both; kNone: the base
  };
  // The parts that a joint carries, or those that stand, with a sphere around all of them.
  struct Group {
    std::uint32_t joint;
    std::uint32_t begin, end;  // in m_parts
    Vec3 centre;               // in the frame of the joint
    double radius;
  };
  struct GroupPair {
    std::uint32_t first, second, common;  // groups; as in Pair
    std::uint32_t begin, end;             // in m_pairs
  };

  int jointsBetween(const Pair& pair) const;

  // Where the frames of the joints are at some values, in the world.
  struct Places {
    std::array<Pose, kMostArmJoints> joints;
    Pose world = Pose::Identity();
    const Pose& of(std::uint32_t joint) const { return joint == kNone ? world : joints[joint]; }
  };
  // Adds the planned joints. mover, pose: of each link the planned joint that moves it, and its pose in that joint's
  // frame; on entry kNone and the pose of the base.
  Status addJoints(const RobotModel& robot, const std::vector<std::uint32_t>& dofs, const JointValues& values,
                   std::vector<std::uint32_t>& mover, std::vector<Pose>& pose);
  void findPairs(const std::set<LinkPair>& allowed);
  void findGroups();
  void findReaches();
  void groupPairs();
  void placesAt(const ArmValues& values, Places& places) const;
  Nearest nearestObstacle(const Places& places, double enough, QueryCounts* counts) const;
  Nearest nearestLinks(const Places& places, double enough, QueryCounts* counts) const;
  // The least distance of a group from the obstacles, or of two groups from each other, where it is below `enough`.
  Nearest nearestOf(const Group& group, const Places& places, double enough, QueryCounts* counts) const;
  Nearest nearestOf(const GroupPair& pair, const Places& places, double enough, QueryCounts* counts) const;
  // The obstacles near a group; until the next call of this thread.
  std::span<const std::uint32_t> near(const Group& group, const Places& places, double enough,
                                      QueryCounts* counts) const;
  static constexpr double kRounding = 1e-9;  // of lengths: sums of poses and distances are off by far less
  // The obstacles nearer to a part than this, but for owners that are left out.
  void listNear(const Part& part, const Pose& pose, double clearance, std::vector<std::uint32_t> leftOut,
                std::vector<Nearest>& all) const;
  // How fast points in a sphere (in the frame of a joint) move at most, relative to the frame of the joint `below`,
  // while the joints move at most at these rates, for `half` of the time before and after they are at these places.
  double speedOf(const ArmValues& rates, std::uint32_t joint, const Vec3& centre, double radius, std::uint32_t below,
                 double half, const Places& places) const;
  // Whether the spheres of two groups are so far from each other.
  bool areApart(const GroupPair& pair, const Places& places, double enough) const;
  double pairDistance(const Pair& pair, const Places& places, double enough, QueryCounts* counts) const;

  std::vector<MovedJoint> m_joints;  // parents first
  std::vector<Part> m_parts;         // by joint, those that stand last
  std::vector<Group> m_groups;       // the farthest from the base first: they meet most
  std::vector<Pair> m_pairs;         // by groups
  std::vector<GroupPair> m_groupPairs;
  ObstacleSet m_obstacles;
  Status m_status = Done{};
};

}  // namespace handwheel
