// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ClosestPoints.h"
#include "collision/PieceTree.h"

namespace handwheel {

// A best-first traversal of the bounding volume trees of two pieces. All coordinates are in the frame of the first
// piece. For meshes, distances are measured from the surfaces. The margin of a piece is the radius of a sphere and 0
// for other pieces (PieceTree::margin()). A hint is a pair of leaves that an earlier traversal found.
class PairTraversal {
 public:
  struct Leaves {
    std::uint32_t first = kNone, second = kNone;
  };
  // Prepares a traversal of two trees. They and the counts must outlive this object. pose: the pose of the second piece
  // in the frame of the first.
  PairTraversal(const PieceTree& a, const PieceTree& b, const Pose& pose, QueryCounts& counts);

  // The closest points of two leaves.
  struct Nearest {
    double distance;  // mm, after subtracting the margins
    bool isMeeting;   // the shapes intersect even without the margins
    Leaves leaves;
    Vec3 first, second;  // points of the shapes without the margins
  };
  // Returns the closest points below `enough`, or nothing if no pair is nearer. The leaves of the hint are tested
  // first. The search ends at the first distance below `stop`, and ignores improvements of no more than the tolerance.
  std::optional<Nearest> nearest(double enough, const Leaves& hint,
                                 double stop = -std::numeric_limits<double>::infinity(), double tolerance = 0.0);

  // Returns false if the bounds of the whole pieces prove that the pieces are apart.
  bool mayMeet();
  // Returns the pairs of leaves that intersect without the margins, at most `most`. The hint is one of them if it still
  // intersects.
  std::vector<Leaves> meeting(std::size_t most, const Leaves& hint);
  // Returns the pairs of leaves that intersect or are nearer than `enough`, with the margins. Each pair is listed once,
  // and there are at most `most`.
  const std::vector<Nearest>& within(double enough, std::size_t most);

 private:
  void descend(int a, int b, double bound);
  void look(std::uint32_t a, std::uint32_t b);
  bool mayBeWithin(int a, int b);
  void collect(int a, int b);
  void collectAll(double reach, std::size_t most);
  bool isSplitFirst(int a, int b) const;
  double boundOf(int a, int b);
  bool isValid(const Leaves& leaves) const;

  const PieceTree &m_a, &m_b;
  const Pose m_pose;
  const Eigen::Matrix3d m_turn;
  const Vec3 m_shift;
  QueryCounts& m_counts;
  const double m_margin;
  double m_least = 0.0;  // mm: least distance of the shapes so far
  double m_stop = 0.0;
  double m_tolerance = 0.0;
  std::optional<Nearest> m_found;
  std::vector<Nearest> m_within;
  double m_reach = 0.0;  // mm: limit of the distance of listed shapes; 0: only shapes that intersect
  std::size_t m_most = 0;
};

}  // namespace handwheel
