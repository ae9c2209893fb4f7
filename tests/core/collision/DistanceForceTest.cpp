// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/DistanceForce.h"

#include "AnyBodies.h"
#include "TestClass.h"
#include "TriangleOracle.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kReach = 10.0, kStiffness = 0.5;

CollisionBody meshBody(const TriangleSoup& soup) {
  return CollisionBody({CollisionPiece::ofMesh(Pose::Identity(), std::make_shared<const CollisionMesh>(soup))});
}

// Returns the force on the first body, from all the others.
DistanceWrench forceOn(const std::vector<CollisionBody>& bodies, const std::vector<Pose>& poses, const Vec3& reference,
                       const DistanceForceSettings& settings = {}) {
  std::vector<BodyPair> pairs;
  for (std::uint32_t i = 1; i < bodies.size(); ++i) pairs.push_back({0, i});
  ProximityQuery query(bodies, pairs);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) query.place(i, poses[i]);
  std::vector<NearPair> near;
  query.findNear(settings.reach, near);
  return distanceForce(near, reference, settings);
}

Pose at(const Vec3& position) {
  return Pose(Eigen::Translation3d(position));
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI;
}

bool isAs(const Vec3& found, const Vec3& exact) {
  return degreesBetween(found, exact) <= 0.1 && std::abs(found.norm() - exact.norm()) <= 0.01 * exact.norm();
}

// Returns the side of a tube about z, with so many flat faces: its corners lie on the radius, the first one at this
// angle.
TriangleSoup tubeSide(int faces, double radius, double halfLength, double first) {
  TriangleSoup soup;
  for (int i = 0; i < 2 * faces; ++i) {
    const double angle = first + 2.0 * M_PI * (i / 2) / faces;
    soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), i % 2 ? halfLength : -halfLength);
  }
  const auto corners = static_cast<std::uint32_t>(2 * faces);
  for (std::uint32_t i = 0; i < corners; i += 2) {
    const std::uint32_t next = (i + 2) % corners;
    soup.triangles.push_back({i, next, i + 1});
    soup.triangles.push_back({i + 1, next, next + 1});
  }
  return soup;
}

// Returns a ball of 4 n² triangles, with bumps of this share of its radius.
TriangleSoup bumpyBall(int n, double radius, double bumps = 0.1) {
  TriangleSoup soup;
  const auto point = [&](double u, double v) {
    const Vec3 d(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    return Vec3(radius * (1.0 + bumps * std::sin(5 * d.x() + 1) * std::sin(4 * d.y() + 2)) * d);
  };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i < 2 * n; ++i) soup.points.push_back(point(M_PI * i / n, M_PI * (1.0 * j / n - 0.5)));
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(2 * n * j + i % (2 * n)); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < 2 * n; ++i) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

}  // namespace

class DistanceForceTest : public QObject {
  Q_OBJECT

 private slots:
  void balls() {
    const CollisionBody ball({CollisionPiece::sphere(Vec3::Zero(), 5.0)});
    const Vec3 direction = Vec3(1.0, 2.0, -2.0) / 3.0;
    for (double distance = -9.0; distance < 12.0; distance += 0.75) {
      const Vec3 position = (distance + 10.0) * direction, reference(3.0, 1.0, 2.0);
      const DistanceWrench found = forceOn({ball, ball}, {at(position), Pose::Identity()}, reference);
      const Vec3 exact = kStiffness * std::max(0.0, kReach - distance) * direction;
      QVERIFY((found.force - exact).norm() < 1e-12);
      QVERIFY((found.torque - (position - 5.0 * direction - reference).cross(exact)).norm() < 1e-9);
    }
  }

  // Its lowest corner is pushed up.
  void boxOnPlane() {
    TriangleSoup plane;
    plane.points = {{-500, -500, 0}, {500, -500, 0}, {500, 500, 0}, {-500, 500, 0}};
    plane.triangles = {{0, 1, 2}, {0, 2, 3}};
    Pose pose = at({7, 8, 15});
    pose.rotate(Eigen::AngleAxisd(0.1, Vec3::UnitX()) * Eigen::AngleAxisd(-0.05, Vec3::UnitY()));
    const TriangleSoup box = boxSoup({20, 10, 8});
    Vec3 lowest(0, 0, 1e9);
    for (const Vec3& p : box.points) lowest = (pose * p).z() < lowest.z() ? Vec3(pose * p) : lowest;
    const DistanceWrench found = forceOn({meshBody(box), meshBody(plane)}, {pose, Pose::Identity()}, Vec3(1, 2, 3));
    const Vec3 exact(0, 0, kStiffness * (kReach - lowest.z()));
    QVERIFY(isAs(found.force, exact));
    QVERIFY(isAs(found.torque, (lowest - Vec3(1, 2, 3)).cross(exact)));
  }

  // A round peg in a square hole of four walls: each wall pushes by its distance below the reach, and in the middle the
  // forces cancel.
  void pegInHole() {
    const CollisionBody peg({CollisionPiece::cylinder(Pose::Identity(), 10.0, 60.0)});
    std::vector<CollisionBody> bodies = {peg};
    std::vector<Pose> poses = {Pose::Identity()};
    for (int i = 0; i < 4; ++i) {
      bodies.push_back(meshBody(boxSoup({10, 40, 20})));
      poses.push_back(Pose(Eigen::AngleAxisd(i * M_PI / 2, Vec3::UnitZ())) * at({25, 0, 0}));  // 5 mm away
    }
    QVERIFY(forceOn(bodies, poses, Vec3::Zero()).force.norm() < 1e-6);
    poses[0] = at({2.0, -1.0, 0.0});
    const Vec3 exact(-kStiffness * 2.0 * 2.0, kStiffness * 2.0 * 1.0, 0.0);
    QVERIFY(isAs(forceOn(bodies, poses, Vec3::Zero()).force, exact));
    // Meshes alone, with eight sides: their corners lie on the walls' normals.
    TriangleSoup prism;
    for (int i = 0; i < 16; ++i)
      prism.points.emplace_back(10 * std::cos(i / 2 * M_PI / 4), 10 * std::sin(i / 2 * M_PI / 4), i % 2 ? 30 : -30);
    for (std::uint32_t i = 0; i < 8; ++i) {
      const std::uint32_t next = (2 * i + 2) % 16;
      prism.triangles.push_back({2 * i, next, 2 * i + 1});
      prism.triangles.push_back({2 * i + 1, next, next + 1});
    }
    bodies[0] = meshBody(prism);
    QVERIFY(isAs(forceOn(bodies, poses, Vec3::Zero()).force, exact));
  }

  // A round peg beside the axis of a round hole, both with flat faces. The exact answer for these: a corner of a convex
  // peg is nearest to a face of the convex hole around it, the one with the least height over the axis, less the offset
  // from the axis and the support of the peg. For round ones, at an offset e from the axis: a support of the peg is
  // between r cos(pi/n) and r, a height of the hole is R cos(pi/m), and some face is within pi/m of the direction of
  // the offset. So the distance R - r - e is missed by R (1 - cos(pi/m)) or r (1 - cos(pi/n)) at most; the cosine of
  // the force with that direction is at least cos(pi/m) - (1 - cos(pi/n)) r/e; and the lever about the peg's own axis,
  // 0 for round ones, is at most r sin(pi/n).
  void roundPegInARoundHole() {
    constexpr double kPeg = 10.0, kHole = 12.5;
    for (const int faces : {16, 48, 128}) {
      const int m = faces, n = faces + 1;
      const double holeCosine = std::cos(M_PI / m), pegCosine = std::cos(M_PI / n);
      QVERIFY(rc::check([&] {
        const double firstOfHole = evenly(0.0, 1.0), firstOfPeg = evenly(0.0, 1.0), angle = evenly(0.0, 6.0);
        const double off = evenly(0.5, kHole * holeCosine - kPeg - 0.05);
        const Vec3 direction(std::cos(angle), std::sin(angle), 0.0);
        const TriangleSoup peg = tubeSide(n, kPeg, 15.0, firstOfPeg);
        double least = 1e9, second = 1e9;
        Vec3 normal;
        for (int j = 0; j < m; ++j) {
          const double turn = firstOfHole + (2 * j + 1) * M_PI / m;
          const Vec3 outwards(std::cos(turn), std::sin(turn), 0.0);
          double support = -1e9;
          for (const Vec3& corner : peg.points) support = std::max(support, outwards.dot(corner));
          const double distance = kHole * holeCosine - off * outwards.dot(direction) - support;
          if (distance < least) normal = outwards;
          second = std::min(second, std::max(distance, least));
          least = std::min(distance, least);
        }
        const Pose pose = anyPose(5.0), held = pose * at(off * direction);
        const std::vector<CollisionBody> bodies = {meshBody(peg), meshBody(tubeSide(m, kHole, 40.0, firstOfHole))};
        const DistanceWrench found = forceOn(bodies, {held, pose}, held.translation());
        const double size = found.force.norm(), exact = kStiffness * (kReach - least);
        RC_ASSERT(std::abs(size - exact) <= 1e-6 * exact);
        RC_ASSERT(second - least < 1e-6 || degreesBetween(found.force, pose.linear() * -normal) <= 0.1);
        const double smooth = kStiffness * (kReach - (kHole - kPeg - off));
        RC_ASSERT(size <= smooth + kStiffness * kHole * (1.0 - holeCosine) + 1e-9);
        RC_ASSERT(size >= smooth - kStiffness * kPeg * (1.0 - pegCosine) - 1e-9);
        const double cosine = holeCosine - (1.0 - pegCosine) * kPeg / off;
        RC_ASSERT(found.force.dot(pose.linear() * -direction) >= (cosine - 1e-9) * size);
        RC_ASSERT(std::abs(found.torque.dot(pose.linear().col(2))) <= (kPeg * std::sin(M_PI / n) + 1e-6) * size);
      }));
    }
  }

  // Balls of triangles against round ones. Every direction is within t of a corner of such a ball, t the tilt of its
  // facets: its support is between r cos t and r. The distance D cos a - h - h', taken at the direction of the force,
  // is not below that at the centres' line, so 1 - cos a is at most (r + r')/D (1 - cos t), and a at most t. It is not
  // above the distance of round ones by more than (r + r')(1 - cos t).
  void nearTheSmoothShape() {
    constexpr double kFirst = 20.0, kSecond = 30.0;
    for (const int n : {8, 16, 48}) {
      const std::vector<CollisionBody> bodies = {meshBody(bumpyBall(n, kFirst, 0.0)),
                                                 meshBody(bumpyBall(n, kSecond, 0.0))};
      const double cosTilt = 2.0 * std::cos(M_PI / (2 * n)) - 1.0;
      const double apart = (kFirst + kSecond) * (1.0 - cosTilt);  // mm
      QVERIFY(rc::check([&] {
        Pose a = anyPose(0.0);
        const Pose b = anyPose(5.0);
        const double smooth = evenly(0.1, 6.0);
        const Vec3 direction = (anyPosition(1.0) + Vec3(1e-3, 0, 0)).normalized();
        a.translation() = b.translation() + (kFirst + kSecond + smooth) * direction;
        const DistanceWrench found = forceOn(bodies, {a, b}, a.translation());
        const double exact = kStiffness * (kReach - smooth), size = found.force.norm();
        RC_ASSERT(size <= exact + 1e-9 && size >= std::max(0.0, exact - kStiffness * apart) - 1e-9);
        RC_ASSERT(size == 0.0 || found.force.dot(direction) >= cosTilt * size);
      }));
    }
  }

  // The gradient of the energy that every pair of triangles gives, without the program.
  void gradientOfTheEnergy() {
    const TriangleSoup first = bumpyBall(3, 20.0), second = bumpyBall(4, 30.0);
    const std::vector<CollisionBody> bodies = {meshBody(first), meshBody(second)};
    const auto energy = [&](const Pose& a, const Pose& b) {
      const double nearer = std::max(0.0, kReach - surfaceDistance(first, a, second, b));
      return 0.5 * kStiffness * nearer * nearer;
    };
    int compared = 0;
    QVERIFY(rc::check([&] {
      Pose a = anyPose(0.0);
      const Pose b = anyPose(5.0);
      a.translation() = b.translation() + evenly(49.0, 58.0) * (anyPosition(1.0) + Vec3(1e-3, 0, 0)).normalized();
      const DistanceWrench found = forceOn(bodies, {a, b}, a.translation());
      const double exact = energy(a, b);
      if (exact >= 0.5 * kStiffness * kReach * kReach) return;  // they meet
      RC_ASSERT(std::abs(found.energy - exact) <= 1e-6);
      constexpr double kStep = 1e-5, kTurn = 1e-6;
      Vec3 force, torque;
      double bend = 0.0, twist = 0.0;  // there is no gradient at a change of the closest feature
      for (Eigen::Index k = 0; k < 3; ++k) {
        const Vec3 axis = Vec3::Unit(k);
        Pose turned = a, back = a;
        turned.linear() = Eigen::AngleAxisd(kTurn, axis) * a.linear();
        back.linear() = Eigen::AngleAxisd(-kTurn, axis) * a.linear();
        const double ahead = energy(at(kStep * axis) * a, b), behind = energy(at(-kStep * axis) * a, b);
        const double left = energy(turned, b), right = energy(back, b);
        force[k] = -(ahead - behind) / (2.0 * kStep);
        torque[k] = -(left - right) / (2.0 * kTurn);
        bend = std::max(bend, std::abs(ahead + behind - 2.0 * exact) / kStep);
        twist = std::max(twist, std::abs(left + right - 2.0 * exact) / kTurn);
      }
      if (force.norm() < 0.1 || bend > 5e-4 * force.norm() || twist > 0.01 * force.norm()) return;
      ++compared;
      RC_ASSERT(isAs(found.force, force));
      RC_ASSERT((found.torque - torque).norm() <= 0.01 * torque.norm() + 0.02 * force.norm());
    }));
    QVERIFY(compared > 30);
  }

  // Nothing leaps at the reach, nothing acts beyond it, and nothing grows without bound.
  void limits() {
    const CollisionBody ball({CollisionPiece::sphere(Vec3::Zero(), 5.0)});
    const auto sizeAt = [&](double distance) {
      return forceOn({ball, ball}, {at({distance + 10.0, 0, 0}), Pose::Identity()}, Vec3::Zero()).force.norm();
    };
    QVERIFY(sizeAt(kReach) == 0.0 && sizeAt(kReach + 1e-9) == 0.0 && sizeAt(1e9) == 0.0);
    QVERIFY(sizeAt(kReach - 1e-6) > 0.0 && sizeAt(kReach - 1e-6) < 1e-6);
    // A small body deep in a large one, whole, of every kind.
    const CollisionBody little({CollisionPiece::sphere(Vec3::Zero(), 1.0)});
    for (const CollisionBody& large :
         {CollisionBody({CollisionPiece::sphere(Vec3::Zero(), 500.0)}), meshBody(boxSoup({500, 500, 500})),
          CollisionBody({CollisionPiece::cylinder(Pose::Identity(), 500.0, 1000.0)})}) {
      for (const Vec3& position : {Vec3(0, 0, 0), Vec3(480, 3, 2), Vec3(499.5, 3, 2)}) {
        const DistanceWrench found = forceOn({little, large}, {at(position), Pose::Identity()}, Vec3(1e6, 0, 0));
        QVERIFY(found.force.allFinite() && found.torque.allFinite());
        QVERIFY(found.force.norm() <= kStiffness * 20.0 + 1e-9 && found.force.norm() > 0.0);
      }
    }
    // Many of them together.
    const std::vector<CollisionBody> many(200, little);
    QVERIFY(forceOn(many, std::vector<Pose>(200, Pose::Identity()), Vec3::Zero()).force.norm() <= 20.0 + 1e-9);
    Pose nowhere = Pose::Identity();
    nowhere.linear()(0, 0) = std::nan("");
    QVERIFY(forceOn({ball, ball}, {nowhere, Pose::Identity()}, Vec3::Zero()).force.isZero(0.0));
    QVERIFY(forceOn({ball, CollisionBody()}, {Pose::Identity(), nowhere}, Vec3::Zero()).force.isZero(0.0));
    NearPair broken;
    broken.points.distance = std::nan("");
    QVERIFY(distanceForce(std::span(&broken, 1), Vec3::Zero(), {}).force.isZero(0.0));
    // Half the torque share gives half the torque.
    DistanceForceSettings half;
    half.torqueShare = 0.5;
    const std::vector<Pose> poses = {at({12, 0, 0}), Pose::Identity()};
    const DistanceWrench whole = forceOn({ball, ball}, poses, Vec3(0, 9, 0));
    QVERIFY(whole.torque.norm() > 1.0);
    QVERIFY((forceOn({ball, ball}, poses, Vec3(0, 9, 0), half).torque - 0.5 * whole.torque).norm() < 1e-12);
  }
};

HANDWHEEL_TEST(DistanceForceTest)
#include "DistanceForceTest.moc"
