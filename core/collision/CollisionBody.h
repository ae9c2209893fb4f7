// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionMesh.h"

#include <limits>
#include <span>
#include <vector>

namespace handwheel {

// A piece of a rigid body, at a pose in the frame of the body.
struct CollisionPiece {
  enum class Kind { Ball, Block, Cylinder, Mesh };

  static CollisionPiece sphere(const Vec3& centre, double radius);
  static CollisionPiece box(const Pose& pose, const Vec3& size);                   // full sizes, mm, centred
  static CollisionPiece cylinder(const Pose& pose, double radius, double length);  // mm, along z, centred
  static CollisionPiece ofMesh(const Pose& pose, std::shared_ptr<const CollisionMesh> mesh);

  Kind kind = Kind::Ball;
  Pose pose = Pose::Identity();
  // Radius in x of a sphere; half sizes of a block; radius in x and half length in z of a cylinder; mm.
  Vec3 half = Vec3::Zero();
  std::shared_ptr<const CollisionMesh> mesh = {};
  // Bounding sphere in the frame of the body, and bounding box in the frame of the piece; mm.
  Vec3 centre = Vec3::Zero();  // in the frame of the body
  double radius = 0.0;
  Vec3 boxCentre = Vec3::Zero(), boxHalf = Vec3::Zero();

  CollisionPiece moved(const Pose& by) const;
};

// A rigid body for collision queries. It consists of pieces with a bounding sphere. Copies share the meshes.
class CollisionBody {
 public:
  CollisionBody() = default;
  explicit CollisionBody(std::vector<CollisionPiece> pieces);

  std::span<const CollisionPiece> pieces() const { return m_pieces; }
  bool isEmpty() const { return m_pieces.empty(); }
  const Vec3& centre() const { return m_centre; }
  double radius() const { return m_radius; }  // mm

 private:
  std::vector<CollisionPiece> m_pieces;
  Vec3 m_centre = Vec3::Zero();
  double m_radius = 0.0;
};

// Counts of the work that queries have done.
struct QueryCounts {
  std::uint64_t bounds = 0;  // pairs of pieces whose bounds were compared
  std::uint64_t exact = 0;   // pairs of pieces whose distance was computed
  // Pairs of bounding volumes in the pieces that were compared; not counted by distanceBetween()
  std::uint64_t volumes = 0;
  std::uint64_t pairs = 0;  // pairs of triangles or solids that were compared; not counted by distanceBetween()
};

// Returns the distance of two bodies (mm) if it is below `enough`; otherwise `enough` or a larger lower bound of the
// distance. The result is at most 0 if the bodies intersect or touch, or one is inside the other. It is never too
// large, except for rounding. O(pairs of pieces). May be called on any thread.
double distanceBetween(const CollisionBody& a, const Pose& poseA, const CollisionBody& b, const Pose& poseB,
                       double enough = std::numeric_limits<double>::infinity(), QueryCounts* counts = nullptr);

}  // namespace handwheel
