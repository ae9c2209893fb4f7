// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of rigid bodies that share their hierarchies: they are found and felt like the same triangles stored at
// their poses.
#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/contact/GodObject.h"
#include "haptics/contact/TouchableSurface.h"
#include "haptics/scene/SurfaceForce.h"

#include <rapidcheck.h>
#include <QtTest>

#include <algorithm>
#include <set>
#include <vector>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Placed = std::vector<ContactSurface::Placed>;

double placedCoordinate() {
  return 0.01 * *rc::gen::inRange(-1000, 1001);
}
Vec3 placedPoint() {
  return {placedCoordinate(), placedCoordinate(), placedCoordinate()};
}
Pose somePose() {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(1.0 + placedCoordinate(), placedCoordinate(), placedCoordinate(), 0.1)
                      .normalized()
                      .toRotationMatrix();
  pose.translation() = placedPoint();
  return pose;
}

Pose shifted(const Vec3& by) {
  Pose pose = Pose::Identity();
  pose.translation() = by;
  return pose;
}

TrianglePoints cornersAt(const Pose& pose, const TriangleSoup& soup, const Triangle& t) {
  return {pose * soup.points[t[0]], pose * soup.points[t[1]], pose * soup.points[t[2]]};
}

// Returns a number that identifies a triangle.
double markOf(const TrianglePoints& t) {
  return (t[0] + t[1] + t[2]).dot(Vec3(1.0, 10.0, 100.0));
}

std::multiset<double> marksIn(const ContactSurface& surface, const Box& box) {
  std::multiset<double> marks;
  surface.forEachInBox(box, [&](const ContactTriangle& t) {
    marks.insert(markOf(t.corners));
    return true;
  });
  return marks;
}

bool hasBoxAt(const TrianglePoints& t, const Box& box) {
  Box around(t[0]);
  around.extend(t[1]).extend(t[2]);
  return around.intersects(box);
}

// Returns true if one of some points of a triangle is in the box.
bool reaches(const TrianglePoints& t, const Box& box) {
  constexpr int kParts = 8;
  for (int i = 0; i <= kParts; ++i) {
    for (int k = 0; i + k <= kParts; ++k) {
      const Vec3 point = (i * t[0] + k * t[1] + (kParts - i - k) * t[2]) / kParts;
      if (box.contains(point)) return true;
    }
  }
  return false;
}

// Returns a cube of 100 mm twice, side by side: from 0 to 200 along x.
Placed twoCubes(const ContactSurface& cube) {
  return {{cube, Pose::Identity()}, {cube, shifted({100, 0, 0})}};
}

ContactSurface cubeSurface() {
  const TriangleSoup soup = cube(100.0);
  return touchableSurface(soup.points, soup.triangles, {});
}

}  // namespace

class PlacedSurfacesTest : public QObject {
  Q_OBJECT

 private slots:
  // All triangles that reach into a box are found, and none whose boxes do not.
  void findsWhatStandsThere() {
    QVERIFY(rc::check([] {
      const TriangleSoup ball = icosphere(2), block = cube(3.0);
      const ContactSurface surfaces[] = {{ball.points, ball.triangles}, {block.points, block.triangles}};
      Placed bodies;
      std::vector<TrianglePoints> truth;
      for (int i = 0; i < 4; ++i) {
        const Pose pose = somePose();
        const TriangleSoup& soup = i % 2 == 0 ? ball : block;
        bodies.push_back({surfaces[i % 2], pose});
        for (const Triangle& t : soup.triangles) truth.push_back(cornersAt(pose, soup, t));
      }
      const ContactSurface together{std::span<const ContactSurface::Placed>(bodies)};
      Box box(placedPoint());
      box.extend(placedPoint());
      std::multiset<double> least, most;
      for (const TrianglePoints& t : truth) {
        RC_ASSERT(hasBoxAt(t, together.bounds()));
        if (reaches(t, box)) least.insert(markOf(t));
        if (hasBoxAt(t, box)) most.insert(markOf(t));
      }
      const std::multiset<double> all = marksIn(together, box);
      RC_ASSERT(std::includes(all.begin(), all.end(), least.begin(), least.end()));
      RC_ASSERT(std::includes(most.begin(), most.end(), all.begin(), all.end()));
    }));
  }

  // Pressed 5 mm into the top of one cube and drawn over to the other: the top is one plane, and the proxy stays on it.
  void theProxySlidesFromBodyToBody() {
    const Placed cubes = twoCubes(cubeSurface());
    const ContactSurface together{std::span<const ContactSurface::Placed>(cubes)};
    GodObject god;
    god.place(Vec3(30, 50, 110));
    for (double x = 30.0; x < 170.0; x += 0.1) {
      const Contact& contact = god.follow(together, Vec3(x, 50, 95), {});
      QVERIFY(contact.touching);
      QVERIFY2(std::abs(contact.proxy.z() - 100.0) < 1e-4 && std::abs(contact.proxy.x() - x) < 1e-4,
               qPrintable(QString::number(x)));
    }
  }

  // Two walls of two turned bodies make a groove: the proxy is held by both at once, where they meet.
  void aGrooveBetweenBodies() {
    const ContactSurface cube = cubeSurface();
    const Placed bodies{{cube, Pose::Identity()}, {cube, shifted({100, 0, 50})}};
    const ContactSurface together{std::span<const ContactSurface::Placed>(bodies)};
    GodObject god;
    god.place(Vec3(90, 50, 110));
    Contact contact;
    for (int i = 0; i < 10; ++i) contact = god.follow(together, Vec3(103, 50, 96), {});
    QVERIFY(contact.touching);
    QVERIFY((contact.proxy - Vec3(100, 50, 100)).norm() < 1e-4);
  }

  // A body that moves shares its hierarchy, so the version continues; a new scene is another version.
  void bodiesThatMoveAreAVersion() {
    const ContactSurface cube = cubeSurface();
    Placed bodies = twoCubes(cube);
    const ContactSurface before{std::span<const ContactSurface::Placed>(bodies)};
    bodies[1].pose = shifted({300, 0, 0});
    const ContactSurface after(std::span<const ContactSurface::Placed>(bodies), &before);
    const ContactSurface other{std::span<const ContactSurface::Placed>(bodies)};
    QVERIFY(after.isVersionOf(before) && before.isVersionOf(after) && after.version() != before.version());
    QVERIFY(!other.isVersionOf(before));

    SurfaceForce first("surface", {before, 1.0, 0.0, {}}), next("surface", {after, 1.0, 0.0, {}});
    TipState tip;
    tip.isRestart = true;
    tip.position = Vec3(30, 50, 110);
    ForceOut out;
    first.advance(tip, out);
    tip.isRestart = false;
    tip.position = Vec3(30, 50, 97);
    first.advance(tip, out);
    QVERIFY((first.force(tip, 1.0, 1.0) - Vec3(0, 0, 3)).norm() < 1e-4);
    next.follow(first);
    next.advance(tip, out);
    QVERIFY((next.force(tip, 1.0, 1.0) - Vec3(0, 0, 3)).norm() < 1e-4);
  }
};

HANDWHEEL_TEST(PlacedSurfacesTest)
#include "PlacedSurfacesTest.moc"
