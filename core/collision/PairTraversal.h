// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ClosestPoints.h"
#include "collision/PieceTree.h"

namespace handwheel {

// A best-first traversal of the bounding volume trees of two pieces. All in the frame of the first. Its distances are
// those to the surfaces of meshes.
class PairTraversal {
 public:
  struct Leaves {
    std::uint32_t first = kNone, second = kNone;
  };
  // pose: of the second piece in the frame of the first. Both trees, and the counts, outlive it.
  PairTraversal(const PieceTree& a, const PieceTree& b, const Pose& pose, QueryCounts& counts);

  // The closest points below `enough`. The hint is looked at first. None: nothing is nearer.
  struct Nearest {
    double distance;  // mm, less the margins; from the surfaces
    bool isMeeting;   // the shapes within the margins do
    Leaves leaves;
    Vec3 first, second;  // of the shapes within the margins
  };
  // From the first on that is below `stop` no closer ones are looked for, nor those closer by no more than the
  // tolerance.
  std::optional<Nearest> nearest(double enough, const Leaves& hint,
                                 double stop = -std::numeric_limits<double>::infinity(), double tolerance = 0.0);

  // Whether the bounds of the whole pieces do not say that they are apart.
  bool mayMeet();
  // The leaves that meet, at most so many; one of them: that which met last time, if it still does. The margins do not
  // count.
  std::vector<Leaves> meeting(std::size_t most, const Leaves& hint);
  // The pairs of leaves nearer than `enough`, or that meet, with the margins; each once, at most so many.
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
  double m_least = 0.0;  // of the shapes
  double m_stop = 0.0;
  double m_tolerance = 0.0;
  std::optional<Nearest> m_found;
  std::vector<Nearest> m_within;
  double m_reach = 0.0;  // of the shapes, that are listed below it; 0: those that meet
  std::size_t m_most = 0;
};

}  // namespace handwheel
