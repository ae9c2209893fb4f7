// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ClosestPoints.h"
#include "collision/PieceTree.h"

namespace handwheel {

// A best-first traversal of the bounding volume trees of two pieces. All coordinates are in the frame of the first. Its
// distances are those to the surfaces of meshes.
class PairTraversal {
 public:
  struct Leaves {
    std::uint32_t first = kNone, second = kNone;
  };
  // pose: of the second piece in the frame of the first. Both trees, and the counts, must outlive it.
  PairTraversal(const PieceTree& a, const PieceTree& b, const Pose& pose, QueryCounts& counts);

  // The closest points of two leaves.
  struct Nearest {
    double distance;  // mm, less the margins; measured from the surfaces
    bool isMeeting;   // the shapes meet within the margins
    Leaves leaves;
    Vec3 first, second;  // points of the shapes within the margins
  };
  // Returns the closest points below `enough`, or nothing if no pair is nearer. The leaves of the hint are tested
  // first. The search ends at the first distance below `stop`, and ignores improvements of no more than the tolerance.
  std::optional<Nearest> nearest(double enough, const Leaves& hint,
                                 double stop = -std::numeric_limits<double>::infinity(), double tolerance = 0.0);

  // Returns true if the bounds of the whole pieces do not prove that they are apart.
  bool mayMeet();
  // Returns the leaves that meet, at most `most`; one of them is the hint, if it still meets. The margins do not count.
  std::vector<Leaves> meeting(std::size_t most, const Leaves& hint);
  // Returns the pairs of leaves that are nearer than `enough` or meet, with the margins; each once, at most `most`.
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
  double m_least = 0.0;  // least distance of the shapes so far
  double m_stop = 0.0;
  double m_tolerance = 0.0;
  std::optional<Nearest> m_found;
  std::vector<Nearest> m_within;
  double m_reach = 0.0;  // limit of the distance of listed shapes; 0: only those that meet
  std::size_t m_most = 0;
};

}  // namespace handwheel
