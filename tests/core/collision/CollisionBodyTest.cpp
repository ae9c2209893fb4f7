// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/CollisionBody.h"

#include "AnyBodies.h"
#include "TestClass.h"

#include <QtTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

double between(const CollisionPiece& a, const CollisionPiece& b, double enough = 1e9) {
  return distanceBetween(CollisionBody({a}), Pose::Identity(), CollisionBody({b}), Pose::Identity(), enough);
}

}  // namespace

class CollisionBodyTest : public QObject {
  Q_OBJECT

 private slots:
  void knownDistances() {
    const Pose at = Pose(Eigen::Translation3d(100.0, 0.0, 0.0));
    const CollisionPiece ball = CollisionPiece::sphere(Vec3::Zero(), 10.0);
    QVERIFY(std::abs(between(ball, CollisionPiece::sphere({100, 0, 0}, 5.0)) - 85.0) < 1e-9);
    QVERIFY(std::abs(between(ball, CollisionPiece::box(at, {20, 20, 20})) - 80.0) < 1e-9);
    QVERIFY(std::abs(between(ball, CollisionPiece::cylinder(at, 15.0, 8.0)) - 75.0) < 1e-9);
    const CollisionPiece block = CollisionPiece::box(Pose::Identity(), {20, 20, 20});
    QVERIFY(std::abs(between(block, CollisionPiece::box(at, {30, 10, 10})) - 75.0) < 1e-3);
    const auto mesh = std::make_shared<const CollisionMesh>(boxSoup({10, 10, 10}));
    QVERIFY(mesh->isClosed());
    QVERIFY(std::abs(between(CollisionPiece::ofMesh(at, mesh), block) - 80.0) < 1e-3);
    QVERIFY(std::abs(between(CollisionPiece::ofMesh(at, mesh), CollisionPiece::ofMesh(Pose::Identity(), mesh)) - 80.0) <
            1e-9);
    QVERIFY(std::abs(between(ball, CollisionPiece::ofMesh(at, mesh)) - 80.0) < 1e-3);
  }

  // A body inside another meets it, even if their surfaces do not.
  void insideOfAnother() {
    const CollisionPiece small = CollisionPiece::sphere({3, 2, 1}, 1.0);
    const auto hollow = std::make_shared<const CollisionMesh>(boxSoup({50, 50, 50}));
    const auto little = std::make_shared<const CollisionMesh>(boxSoup({1, 1, 1}));
    QVERIFY(between(small, CollisionPiece::box(Pose::Identity(), {100, 100, 100})) <= 0.0);
    QVERIFY(between(small, CollisionPiece::cylinder(Pose::Identity(), 50.0, 100.0)) <= 0.0);
    QVERIFY(between(small, CollisionPiece::ofMesh(Pose::Identity(), hollow)) <= 0.0);
    QVERIFY(between(CollisionPiece::ofMesh(Pose::Identity(), little),
                    CollisionPiece::ofMesh(Pose::Identity(), hollow)) <= 0.0);
    // An open box has no inside.
    TriangleSoup open = boxSoup({50, 50, 50});
    open.triangles.pop_back();
    QVERIFY(between(small, CollisionPiece::ofMesh(Pose::Identity(), std::make_shared<const CollisionMesh>(open))) >
            40.0);
  }

  // Each shell of a mesh counts: one of several that is inside, and one that is closed beside an open one.
  void eachShell() {
    const auto together = [](const std::vector<std::pair<TriangleSoup, Vec3>>& shells) {
      TriangleSoup all;
      for (const auto& [soup, at] : shells) {
        const auto first = static_cast<std::uint32_t>(all.points.size());
        for (const Vec3& p : soup.points) all.points.push_back(p + at);
        for (const Triangle& t : soup.triangles) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      }
      return CollisionPiece::ofMesh(Pose::Identity(), std::make_shared<const CollisionMesh>(all));
    };
    TriangleSoup open = boxSoup({5, 5, 5});
    open.triangles.pop_back();
    const CollisionPiece room = together({{open, {300, 0, 0}}, {boxSoup({50, 50, 50}), {0, 0, 0}}});
    QVERIFY(between(CollisionPiece::sphere({3, 2, 1}, 1.0), room) <= 0.0);
    const CollisionPiece parts = together({{boxSoup({1, 1, 1}), {200, 0, 0}}, {boxSoup({1, 1, 1}), {10, 0, 0}}});
    QVERIFY(between(parts, room) <= 0.0 && between(room, parts) <= 0.0);
    const CollisionPiece outside = together({{boxSoup({1, 1, 1}), {200, 0, 0}}, {boxSoup({1, 1, 1}), {60, 0, 0}}});
    QVERIFY(std::abs(between(outside, room) - 9.0) < 1e-9);
    // Nothing is inside of an open shell.
    QVERIFY(std::abs(between(CollisionPiece::sphere({300, 0, 0}, 1.0), room) - 4.0) < 1e-9);
  }

  // No two points of the pieces are nearer to each other than the distance; and it does not depend on the order.
  void neverTooLarge() {
    QVERIFY(rc::check([] {
      const CollisionPiece a = anyPiece(50.0), b = anyPiece(50.0);
      const double distance = between(a, b);
      RC_ASSERT(std::abs(distance - between(b, a)) < 1e-3);
      for (int i = 0; i < 50; ++i) {
        const double apart = (a.pose * anyPointOf(a) - b.pose * anyPointOf(b)).norm();
        RC_ASSERT(apart >= distance - 1e-9);
      }
      // A tolerance changes nothing below it.
      const double enough = evenly(0.1, 60.0), bounded = between(a, b, enough);
      if (distance < enough)
        RC_ASSERT(std::abs(bounded - distance) < 1e-3);
      else
        RC_ASSERT(bounded >= enough - 1e-9 && bounded <= distance + 1e-3);
    }));
  }

  // The bounding spheres contain their pieces.
  void bounds() {
    QVERIFY(rc::check([] {
      std::vector<CollisionPiece> pieces;
      for (int i = *rc::gen::inRange(1, 6); i > 0; --i) pieces.push_back(anyPiece(50.0));
      const CollisionBody body(pieces);
      for (const CollisionPiece& piece : pieces) {
        for (int i = 0; i < 20; ++i) {
          const Vec3 p = piece.pose * anyPointOf(piece);
          RC_ASSERT((p - piece.centre).norm() <= piece.radius + 1e-9);
          RC_ASSERT((p - body.centre()).norm() <= body.radius() + 1e-9);
        }
      }
    }));
  }

  // Callers that only ask whether bodies meet pass the smallest limit, whose square is 0.
  void smallestLimit() {
    const TriangleSoup box = boxSoup({20, 20, 20});
    const auto mesh = CollisionPiece::ofMesh(Pose::Identity(), std::make_shared<const CollisionMesh>(box));
    const CollisionPiece pieces[] = {mesh, CollisionPiece::box(Pose::Identity(), Vec3::Constant(10.0)),
                                     CollisionPiece::cylinder(Pose::Identity(), 10.0, 10.0),
                                     CollisionPiece::sphere(Vec3::Zero(), 10.0)};
    constexpr double kSmallest = std::numeric_limits<double>::min();
    for (const CollisionPiece& a : pieces) {
      for (const CollisionPiece& b : pieces) {
        const Pose over(Eigen::Translation3d(3.0, 4.0, 5.0)), beside(Eigen::Translation3d(60.0, 0.0, 0.0));
        QVERIFY(distanceBetween(CollisionBody({a}), Pose::Identity(), CollisionBody({b}), over, kSmallest) <= 0.0);
        QVERIFY(distanceBetween(CollisionBody({a}), Pose::Identity(), CollisionBody({b}), beside, kSmallest) > 0.0);
      }
    }
  }

  void nothing() {
    const CollisionBody none;
    QVERIFY(std::isinf(distanceBetween(none, Pose::Identity(), none, Pose::Identity())));
    TriangleSoup broken = boxSoup({1, 1, 1});
    broken.points[0].x() = std::nan("");
    const CollisionMesh mesh(broken);
    QVERIFY(!mesh.isClosed() && mesh.bounds().sizes().allFinite());
    const CollisionMesh empty((TriangleSoup()));
    QVERIFY(empty.bounds().isEmpty());
    const CollisionPiece piece =
        CollisionPiece::ofMesh(Pose::Identity(), std::make_shared<const CollisionMesh>(TriangleSoup()));
    QVERIFY(between(piece, CollisionPiece::sphere(Vec3::Zero(), 1.0), 5.0) >= 5.0);
  }
};

HANDWHEEL_TEST(CollisionBodyTest)
#include "CollisionBodyTest.moc"
