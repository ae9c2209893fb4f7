// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ClosestPoints.h"

#include "AnyBodies.h"
#include "TestClass.h"
#include "TriangleOracle.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

std::optional<ClosestPoints> closest(const CollisionPiece& a, const CollisionPiece& b, double enough = kFar) {
  PairHint hint;
  QueryCounts counts;
  return closestPoints(a, a.pose, b, b.pose, enough, hint, counts);
}

bool meet(const CollisionPiece& a, const CollisionPiece& b) {
  PairHint hint;
  QueryCounts counts;
  return areMeeting(a, a.pose, b, b.pose, hint, counts);
}

CollisionPiece meshOf(const TriangleSoup& soup, const Pose& pose) {
  return CollisionPiece::ofMesh(pose, std::make_shared<const CollisionMesh>(soup));
}

Pose at(double x, double y, double z) {
  return Pose(Eigen::Translation3d(x, y, z));
}

TriangleSoup anySoup(int triangles, double size) {
  TriangleSoup soup;
  for (int i = 0; i < triangles; ++i) {
    const Vec3 centre = anyPosition(20.0);
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (int k = 0; k < 3; ++k) soup.points.push_back(centre + anyPosition(size));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

// Returns points of the surface of a solid, with all its corners and much of its rims.
std::vector<Vec3> pointsOf(const CollisionPiece& piece) {
  std::vector<Vec3> points;
  const Vec3& h = piece.half;
  for (int i = 0; i < 720; ++i) {
    const double turn = M_PI * i / 360.0;
    if (piece.kind == CollisionPiece::Kind::Cylinder) {
      for (const double z : {-h.z(), h.z()}) points.emplace_back(h.x() * std::cos(turn), h.x() * std::sin(turn), z);
    } else if (piece.kind == CollisionPiece::Kind::Block && i < 8) {
      points.emplace_back(i & 1 ? h.x() : -h.x(), i & 2 ? h.y() : -h.y(), i & 4 ? h.z() : -h.z());
    } else if (piece.kind == CollisionPiece::Kind::Ball) {
      points.push_back(h.x() * (anyPosition(1.0) + Vec3(1e-3, 0, 0)).normalized());
    }
  }
  for (Vec3& p : points) p = piece.pose * p;
  return points;
}

}  // namespace

class ClosestPointsTest : public QObject {
  Q_OBJECT

 private slots:
  void knownOnes() {
    const auto isOf = [](const std::optional<ClosestPoints>& found, double distance, const Vec3& first,
                         const Vec3& second) {
      return found && std::abs(found->distance - distance) < 1e-9 && (found->first - first).norm() < 1e-9 &&
             (found->second - second).norm() < 1e-9;
    };
    const CollisionPiece ball = CollisionPiece::sphere(Vec3::Zero(), 10.0);
    QVERIFY(isOf(closest(ball, CollisionPiece::sphere({100, 0, 0}, 5.0)), 85.0, {10, 0, 0}, {95, 0, 0}));
    QVERIFY(isOf(closest(ball, CollisionPiece::box(at(0, 40, 0), {20, 20, 20})), 20.0, {0, 10, 0}, {0, 30, 0}));
    QVERIFY(isOf(closest(CollisionPiece::cylinder(at(0, 0, -30), 4.0, 20.0), ball), 10.0, {0, 0, -20}, {0, 0, -10}));
    QVERIFY(isOf(closest(ball, meshOf(boxSoup({5, 5, 5}), at(0, 0, 25))), 10.0, {0, 0, 10}, {0, 0, 20}));
    // Corner to corner, and an edge across an edge.
    QVERIFY(isOf(closest(CollisionPiece::box(at(0, 0, 0), {2, 2, 2}), CollisionPiece::box(at(4, 5, 6), {2, 2, 2})),
                 std::sqrt(4.0 + 9.0 + 16.0), {1, 1, 1}, {3, 4, 5}));
    Pose turned = at(0, 0, 10);
    turned.rotate(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()) * Eigen::AngleAxisd(M_PI / 4, Vec3::UnitX()));
    Pose flat = Pose(Eigen::AngleAxisd(M_PI / 4, Vec3::UnitX()));
    const auto crossed = closest(CollisionPiece::box(turned, {20, 2, 2}), meshOf(boxSoup({10, 1, 1}), flat));
    QVERIFY(isOf(crossed, 10.0 - 2.0 * M_SQRT2, {0, 0, 10.0 - M_SQRT2}, {0, 0, M_SQRT2}));
    QVERIFY((crossed->normal - Vec3::UnitZ()).norm() < 1e-9);
    // Only what is nearer than asked for is found.
    QVERIFY(!closest(ball, CollisionPiece::sphere({100, 0, 0}, 5.0), 85.0));
    QVERIFY(!closest(CollisionPiece::box(turned, {20, 2, 2}), meshOf(boxSoup({10, 1, 1}), flat), 7.0));
  }

  void depths() {
    const CollisionPiece ball = CollisionPiece::sphere({0, 0, 9}, 2.0);
    const CollisionPiece block = CollisionPiece::box(Pose::Identity(), {100, 100, 20});
    const auto inBlock = closest(ball, block);
    QVERIFY(inBlock && std::abs(inBlock->distance + 3.0) < 1e-12 && inBlock->normal == Vec3::UnitZ());
    QVERIFY((inBlock->first - Vec3(0, 0, 7)).norm() < 1e-12 && (inBlock->second - Vec3(0, 0, 10)).norm() < 1e-12);
    const auto outOfBlock = closest(block, ball);
    QVERIFY(outOfBlock && std::abs(outOfBlock->distance + 3.0) < 1e-12 && outOfBlock->normal == -Vec3::UnitZ());
    // A piece inside a closed mesh, whole and in part.
    const CollisionPiece hollow = meshOf(boxSoup({50, 50, 10}), Pose::Identity());
    for (const double z : {9.0, 7.0, 11.0}) {
      const auto in = closest(CollisionPiece::sphere({0, 0, z}, 2.0), hollow);
      QVERIFY(in && std::abs(in->distance - (z - 12.0)) < 1e-9 && (in->normal - Vec3::UnitZ()).norm() < 1e-9);
    }
    const auto little = closest(meshOf(boxSoup({1, 1, 1}), at(3, 2, 7)), hollow);
    QVERIFY(little && std::abs(little->distance + 4.0) < 1e-9 && (little->normal - Vec3::UnitZ()).norm() < 1e-9);
    const auto around = closest(hollow, meshOf(boxSoup({1, 1, 1}), at(3, 2, 7)));
    QVERIFY(around && std::abs(around->distance + 4.0) < 1e-9 && (around->normal + Vec3::UnitZ()).norm() < 1e-9);
    const auto across = closest(meshOf(boxSoup({1, 1, 1}), at(3, 2, 10.5)), hollow);
    QVERIFY(across && std::abs(across->distance + 0.5) < 1e-9 && (across->normal - Vec3::UnitZ()).norm() < 1e-9);
  }

  // Convex and apart: the plane across the line of the closest points separates the two, and no other points give such
  // a plane.
  void solidsAreApartByPlanes() {
    QVERIFY(rc::check([] {
      const CollisionPiece a = anyPiece(50.0), b = anyPiece(50.0);
      const auto found = closest(a, b);
      RC_ASSERT(found && meet(a, b) == (found->distance <= 0.0));
      RC_ASSERT(std::abs(found->normal.norm() - 1.0) < 1e-12);
      RC_ASSERT((found->first - found->second - found->distance * found->normal).norm() < 1e-7);
      if (found->distance <= 0.0) return;
      RC_ASSERT(std::abs(distanceFromPiece(a, found->first)) < 1e-7);
      RC_ASSERT(std::abs(distanceFromPiece(b, found->second)) < 1e-7);
      for (const Vec3& p : pointsOf(a)) RC_ASSERT(found->normal.dot(p - found->first) > -1e-5);
      for (const Vec3& p : pointsOf(b)) RC_ASSERT(found->normal.dot(p - found->second) < 1e-5);
    }));
  }

  // Pieces that meet: moved along the normal by the depth, all points of the first are beyond those of the second; and
  // boxes have no shorter displacement along their faces.
  void depthsLeadOut() {
    QVERIFY(rc::check([] {
      const CollisionPiece a = anyPiece(8.0), b = anyPiece(8.0);
      const auto found = closest(a, b);
      RC_ASSERT(found.has_value());
      if (found->distance > 0.0) return;
      double least = kFar, most = -kFar;
      for (const Vec3& p : pointsOf(a)) least = std::min(least, found->normal.dot(p));
      for (const Vec3& p : pointsOf(b)) most = std::max(most, found->normal.dot(p));
      RC_ASSERT(least - found->distance >= most - 1e-6);
      if (a.kind != CollisionPiece::Kind::Block || b.kind != CollisionPiece::Kind::Block) return;
      for (const CollisionPiece* piece : {&a, &b}) {
        for (Eigen::Index i = 0; i < 6; ++i) {
          const Vec3 n = (i < 3 ? 1.0 : -1.0) * piece->pose.linear().col(i % 3);
          double low = kFar, high = -kFar;
          for (const Vec3& p : pointsOf(a)) low = std::min(low, n.dot(p));
          for (const Vec3& p : pointsOf(b)) high = std::max(high, n.dot(p));
          RC_ASSERT(-found->distance <= high - low + 1e-9);
        }
      }
    }));
  }

  // Triangles of any shape and size against every pair of their features.
  void meshesByEveryPair() {
    QVERIFY(rc::check([] {
      const double size = std::pow(10.0, evenly(-7.0, 1.5));
      const TriangleSoup a = anySoup(*rc::gen::inRange(1, 12), size), b = anySoup(*rc::gen::inRange(1, 12), size);
      const Pose poseA = anyPose(30.0), poseB = anyPose(30.0);
      const CollisionPiece first = meshOf(a, poseA), second = meshOf(b, poseB);
      const double exact = surfaceDistance(a, poseA, b, poseB);
      const auto found = closest(first, second);
      RC_ASSERT(found.has_value());
      if (exact == 0.0) {
        RC_ASSERT(found->distance <= 1e-12 && meet(first, second));
        return;
      }
      RC_ASSERT(std::abs(found->distance - exact) < 1e-9 && !meet(first, second));
      RC_ASSERT(distanceFromSurface(found->first, a, poseA) < 1e-9);
      RC_ASSERT(distanceFromSurface(found->second, b, poseB) < 1e-9);
      RC_ASSERT((found->first - found->second - exact * found->normal).norm() < 1e-8);
      PairHint hint;
      QueryCounts counts;
      const double than = evenly(0.5, 1.5) * exact;
      const double bound = distanceBound(first, poseA, second, poseB, than, 2.0 * than, hint, counts);
      RC_ASSERT((bound < than) == (exact < than));
      if (exact >= than) RC_ASSERT(bound <= exact + 1e-9);
    }));
  }

  // A sphere, a box and a cylinder against triangles.
  void solidsToTriangles() {
    QVERIFY(rc::check([] {
      const CollisionPiece solid = anyPiece(20.0);
      const TriangleSoup soup = anySoup(*rc::gen::inRange(1, 8), 15.0);
      const Pose pose = anyPose(50.0);
      const auto found = closest(solid, meshOf(soup, pose));
      RC_ASSERT(found.has_value());
      if (found->distance <= 0.0) return;
      RC_ASSERT(std::abs(distanceFromPiece(solid, found->first)) < 1e-7);
      RC_ASSERT(distanceFromSurface(found->second, soup, pose) < 1e-7);
      RC_ASSERT((found->first - found->second - found->distance * found->normal).norm() < 1e-7);
      // No point of the triangles is nearer to the solid.
      for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Corners t = cornersOf(soup, i, pose);
        for (int k = 0; k < 100; ++k) {
          const double u = evenly(0.0, 1.0), v = evenly(0.0, 1.0 - u);
          const Vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
          RC_ASSERT(distanceFromPiece(solid, p) >= found->distance - 1e-7);
        }
      }
    }));
  }

  void extremes() {
    const CollisionPiece none = meshOf({}, Pose::Identity());
    QVERIFY(!closest(none, CollisionPiece::sphere(Vec3::Zero(), 1.0)));
    QVERIFY(!closest(none, none) && !meet(none, CollisionPiece::box(Pose::Identity(), {1, 1, 1})));
    // Degenerate shapes: flat, needle-like, a point.
    const CollisionPiece plate = CollisionPiece::box(at(0, 0, 5), {10, 10, 0});
    const auto flat = closest(plate, CollisionPiece::box(Pose::Identity(), {10, 10, 0}));
    QVERIFY(flat && std::abs(flat->distance - 5.0) < 1e-9);
    const auto point = closest(CollisionPiece::sphere({0, 0, 9}, 0.0), plate);
    QVERIFY(point && std::abs(point->distance - 4.0) < 1e-12);
    for (const double scale : {1e-7, 1e9}) {
      const auto scaled = closest(CollisionPiece::box(at(3 * scale, 0, 0), Vec3::Constant(2 * scale)),
                                  meshOf(boxSoup(Vec3::Constant(scale)), Pose::Identity()));
      QVERIFY(scaled && std::abs(scaled->distance - scale) < 1e-9 * scale);
    }
    // At the same position: any direction out, and a finite depth.
    for (const CollisionPiece& piece :
         {CollisionPiece::sphere(Vec3::Zero(), 1.0), CollisionPiece::box(Pose::Identity(), {2, 2, 2}),
          CollisionPiece::cylinder(Pose::Identity(), 1.0, 2.0), meshOf(boxSoup({1, 1, 1}), Pose::Identity())}) {
      const auto same = closest(piece, piece);
      QVERIFY(same && same->distance <= 0.0 && same->distance >= -2.0 - 1e-9);
      QVERIFY(same->first.allFinite() && same->second.allFinite() && std::abs(same->normal.norm() - 1.0) < 1e-12);
    }
  }

 private:
  static double distanceFromPiece(const CollisionPiece& piece, const Vec3& point) {
    const Vec3 p = piece.pose.inverse() * point;
    if (piece.kind == CollisionPiece::Kind::Ball) return p.norm() - piece.half.x();
    if (piece.kind == CollisionPiece::Kind::Block) return (p - p.cwiseMax(-piece.half).cwiseMin(piece.half)).norm();
    const double across = std::max(0.0, std::hypot(p.x(), p.y()) - piece.half.x());
    return std::hypot(across, std::max(0.0, std::abs(p.z()) - piece.half.z()));
  }
};

HANDWHEEL_TEST(ClosestPointsTest)
#include "ClosestPointsTest.moc"
