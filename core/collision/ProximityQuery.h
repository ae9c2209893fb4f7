// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ClosestPoints.h"

namespace handwheel {

// Two moving bodies of a distance query, by their indices.
struct BodyPair {
  std::uint32_t first, second;
  bool operator==(const BodyPair&) const = default;
};

// The closest points of two bodies.
struct NearPair {
  BodyPair bodies;
  ClosestPoints points;
};

// A contact of two bodies that intersect, touch or nearly touch.
struct BodyContact {
  BodyPair bodies;
  std::uint32_t firstPiece, secondPiece;  // indices of the pieces in the bodies
  PieceContact contact;
};

// Repeated distance queries between moving bodies. Examples are the links of a robot and their surroundings. The object
// reuses earlier results. The last distance of a pair of pieces, minus the distance that they may have moved since
// then, is a lower bound of their present distance, which makes most queries unnecessary. Each query tests the last
// closest triangles first.
//
// A body at a pose that is not finite is ignored. The object must not be used on two threads at the same time.
class ProximityQuery {
 public:
  // Prepares queries between some pairs of bodies. pairs: the pairs of bodies that are tested.
  ProximityQuery(std::vector<CollisionBody> bodies, const std::vector<BodyPair>& pairs);

  // Sets the largest error of closest() and findNear() between meshes, mm; at first 0. The distance may exceed the
  // smallest one by this error.
  void setTolerance(double tolerance) { m_tolerance = tolerance; }

  // Sets the pose of a body, which is the identity at first. O(1).
  void place(std::uint32_t body, const Pose& pose);

  // Returns true if the bodies of any pair intersect or touch, or one is inside the other.
  bool isOverlapping();
  // Returns true if any pair is nearer than this distance, mm.
  bool isNearer(double than);
  // Returns the closest points of the nearest pair, or of the pair that penetrates most. Returns nothing if no pair is
  // nearer than `enough`.
  std::optional<NearPair> closest(double enough = std::numeric_limits<double>::infinity());
  // Finds the closest points of every pair of bodies that is nearer than the threshold (mm), in the order of the pairs.
  void findNear(double threshold, std::vector<NearPair>& near);
  // Finds all contacts of the pairs (see addContacts()) in the order of the pairs: all pairs of triangles or solids
  // that intersect, touch or are nearer than the margin (mm). Returns false if the search ended after `most` contacts.
  bool findContacts(double margin, std::size_t most, std::vector<BodyContact>& contacts);

  const QueryCounts& counts() const { return m_counts; }  // since the last resetCounts()
  void resetCounts() { m_counts = {}; }

 private:
  struct Placed {
    CollisionBody body;
    Pose pose = Pose::Identity();
    Vec3 centre = Vec3::Zero();  // centre in the world
    bool isSomewhere = true;
    double travel = 0.0;  // mm: upper bound of the distance that points of the body have moved so far
    double step = 0.0;    // mm: upper bound of this distance in the last call of place()
  };
  struct Pieces {
    std::uint32_t pair;
    std::uint32_t first, second;
    PairHint hint = {};
    double bound = -std::numeric_limits<double>::infinity();  // mm: lower bound of the distance of the pieces
    double travel = 0.0;                                      // mm: travel of both bodies when the bound was computed
  };
  struct Pair {
    BodyPair bodies;
    std::uint32_t begin, end;  // range in m_pieces
  };

  bool isApart(const Pair& pair, double enough);
  double boundOf(const Pieces& pieces);
  double marginOf(const Pair& pair, double enough) const;
  void learn(Pieces& pieces, double bound);
  bool isNearer(Pieces& pieces, double than);
  std::optional<ClosestPoints> look(Pieces& pieces, double enough, double margin);

  std::vector<Placed> m_bodies;
  std::vector<Pair> m_pairs;
  std::vector<Pieces> m_pieces;  // pairs of pieces, sorted by pairs of bodies
  std::vector<std::pair<double, std::uint32_t>> m_order;
  std::vector<PieceContact> m_contacts;  // contacts of a pair of pieces
  double m_tolerance = 0.0;
  std::uint32_t m_last = 0;  // index of the pair of pieces that was nearest
  QueryCounts m_counts;
};

}  // namespace handwheel
