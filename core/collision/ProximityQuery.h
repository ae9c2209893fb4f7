// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ClosestPoints.h"

namespace handwheel {

// Two moving bodies of a distance query, by their numbers.
struct BodyPair {
  std::uint32_t first, second;
  bool operator==(const BodyPair&) const = default;
};

// The closest points of two bodies.
struct NearPair {
  BodyPair bodies;
  ClosestPoints points;
};

// A place where two bodies touch, or nearly.
struct BodyContact {
  BodyPair bodies;
  std::uint32_t firstPiece, secondPiece;  // of the bodies
  PieceContact contact;
};

// Repeated distance queries between moving bodies. Between two bodies, or the links of a robot and what stands around
// it. It keeps what it found for the next time: the distance that a pair of pieces had, less the way that both may have
// moved since, is a lower bound that mostly needs no look at all; and where a look is needed, the last closest
// triangles are looked at first.
//
// A body at a pose that is no number is nowhere: nothing is near to it. One thread at a time.
class ProximityQuery {
 public:
  // pairs: those that count.
  ProximityQuery(std::vector<CollisionBody> bodies, const std::vector<BodyPair>& pairs);

  // mm that what closest() and findNear() find of meshes may be further apart than what is nearest. 0 until it is set.
  void setTolerance(double tolerance) { m_tolerance = tolerance; }

  // A body stands at the origin until it is placed. O(1).
  void place(std::uint32_t body, const Pose& pose);

  // Whether any pair meets, or has one inside of the other.
  bool isOverlapping();
  // Whether any pair is nearer than so much; mm.
  bool isNearer(double than);
  // The closest points of the nearest pair, or of the one deepest in each other; none: nothing is nearer than `enough`.
  std::optional<NearPair> closest(double enough = std::numeric_limits<double>::infinity());
  // Those of every pair of bodies that is nearer than the threshold (mm); in the order of the pairs.
  void findNear(double threshold, std::vector<NearPair>& near);
  // All contacts of the pairs (see addContacts()): every two triangles or solids nearer than the margin (mm), or that
  // meet; in the order of the pairs. Returns whether these are all: the search ends with the first `most`.
  bool findContacts(double margin, std::size_t most, std::vector<BodyContact>& contacts);

  const QueryCounts& counts() const { return m_counts; }  // since the last
  void resetCounts() { m_counts = {}; }

 private:
  struct Placed {
    CollisionBody body;
    Pose pose = Pose::Identity();
    Vec3 centre = Vec3::Zero();  // of it in the world
    bool isSomewhere = true;
    double travel = 0.0;  // mm: the way of its points so far, at most,
    double step = 0.0;    // and of the last time that it was placed
  };
  struct Pieces {
    std::uint32_t pair;
    std::uint32_t first, second;
    PairHint hint = {};
    double bound = -std::numeric_limits<double>::infinity();  // mm: no nearer than this they were
    double travel = 0.0;                                      // of both bodies then
  };
  struct Pair {
    BodyPair bodies;
    std::uint32_t begin, end;  // in m_pieces
  };

  bool isApart(const Pair& pair, double enough);
  double boundOf(const Pieces& pieces);
  double marginOf(const Pair& pair, double enough) const;
  void learn(Pieces& pieces, double bound);
  bool isNearer(Pieces& pieces, double than);
  std::optional<ClosestPoints> look(Pieces& pieces, double enough, double margin);

  std::vector<Placed> m_bodies;
  std::vector<Pair> m_pairs;
  std::vector<Pieces> m_pieces;  // pairs of pieces, by pairs of bodies
  std::vector<std::pair<double, std::uint32_t>> m_order;
  std::vector<PieceContact> m_contacts;  // of a pair of pieces
  double m_tolerance = 0.0;
  std::uint32_t m_last = 0;  // pair of pieces that was nearest
  QueryCounts m_counts;
};

}  // namespace handwheel
