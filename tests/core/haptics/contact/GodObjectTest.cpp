// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/GodObject.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "proximity/ClosestPoint.h"

#include <rapidcheck.h>
#include <QtTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

ContactSurface surfaceOf(const TriangleSoup& s) {
  return {s.points, s.triangles};
}

// A floor at z = 0 of 200 mm, in cells of 1 mm with crossing diagonals.
TriangleSoup floorOf(const std::function<double(double, double)>& height = [](double, double) { return 0.0; }) {
  return grid(201, 201, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double x = i - 100.0, y = j - 100.0;
    return Vec3(x, y, height(x, y));
  });
}

// Leads the tip in straight steps, each no longer than this.
void lead(GodObject& god, const ContactSurface& surface, const Vec3& from, const Vec3& to, double step,
          const ContactOptions& options = {}) {
  const int n = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step)));
  for (int i = 0; i <= n; ++i) god.follow(surface, from + (to - from) * (double(i) / n), options);
}

// Returns the triangles of a floor that are not at height 0, as an edit that raises them.
std::vector<ContactTriangle> raisedIn(const TriangleSoup& soup) {
  std::vector<ContactTriangle> raised;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    const auto& [a, b, c] = soup.triangles[i];
    const TrianglePoints corners = {soup.points[a], soup.points[b], soup.points[c]};
    if (corners[0].z() + corners[1].z() + corners[2].z() != 0.0) raised.push_back({corners, i});
  }
  return raised;
}

}  // namespace

class GodObjectTest : public QObject {
  Q_OBJECT

 private slots:
  void isTheTipInFreeSpace() {
    const ContactSurface floor = surfaceOf(floorOf());
    GodObject god;
    god.place({0, 0, 5});
    const Contact& contact = god.follow(floor, {3, 4, 1}, {});
    QVERIFY(!contact.touching);
    QCOMPARE(contact.proxy, Vec3(3, 4, 1));
    QCOMPARE(contactForce(contact, {3, 4, 1}, {0, 0, -100}, 1.0, 0.01), Vec3(0, 0, 0));
  }

  // F = k (Pp - Ph) - ζ V: on a floor, k times the depth upwards, less the damping of the speed away from it.
  void pressesOnAFloor() {
    const ContactSurface floor = surfaceOf(floorOf());
    GodObject god;
    god.place({0.3, 0.2, 5});
    const Vec3 tip(0.3, 0.2, -2);
    const Contact& contact = god.follow(floor, tip, {});
    QVERIFY(contact.touching);
    QVERIFY((contact.proxy - Vec3(0.3, 0.2, 0)).norm() < 2 * floor.skin());
    QVERIFY((contact.normal - Vec3::UnitZ()).norm() < 1e-6);
    QVERIFY((contactForce(contact, tip, {50, 0, -10}, 0.5, 0.01) - Vec3(0, 0, 1.1)).norm() < 1e-5);
    // Leaving so fast that the damper would pull: no force instead.
    QVERIFY(contactForce(contact, tip, {0, 0, 1000}, 0.5, 0.01).norm() < 1e-12);
    // Leads the tip out again.
    god.follow(floor, {0.3, 0.2, 0.1}, {});
    QVERIFY(!god.contact().touching);
  }

  void slidesWithoutLag() {
    const ContactSurface floor = surfaceOf(floorOf());
    GodObject god;
    god.place({-50, 0.37, 5});
    lead(god, floor, {-50, 0.37, 5}, {-50, 0.37, -1}, 0.1);
    for (double x = -50; x < 50; x += 0.1) {
      const Contact& contact = god.follow(floor, {x, 0.37 + 0.1 * x, -1}, {});
      QVERIFY((contact.proxy - Vec3(x, 0.37 + 0.1 * x, 0)).norm() < 1e-6 * floor.diagonal());
    }
  }

  // In the corner of a room the proxy goes into the corner, and slides out of it along one wall.
  void goesIntoConcaveCorners() {
    TriangleSoup room = turnedOver(cube(10.0));
    const ContactSurface walls = surfaceOf(room);
    for (const bool turned : {false, true}) {
      if (turned) room = turnedOver(room);
      GodObject god;
      god.place({5, 5, 5});
      lead(god, walls, {5, 5, 5}, {-1, -1, -1}, 0.05);
      QVERIFY(god.contact().proxy.norm() < 1e-6 * walls.diagonal());
      lead(god, walls, {-1, -1, -1}, {-1, -1, 4}, 0.05);
      QVERIFY((god.contact().proxy - Vec3(0, 0, 4)).norm() < 1e-6 * walls.diagonal());
      lead(god, walls, {-1, -1, 4}, {-1, 6, 4}, 0.05);
      QVERIFY((god.contact().proxy - Vec3(0, 6, 4)).norm() < 1e-6 * walls.diagonal());
    }
  }

  // Around the edge of a cube it stays on the face that it came from until the tip is past the edge.
  void slidesOverConvexEdges() {
    const ContactSurface box = surfaceOf(cube(10.0));
    GodObject god;
    god.place({5, 5, 12});
    lead(god, box, {5, 5, 12}, {5, 5, 9}, 0.1);
    lead(god, box, {5, 5, 9}, {9.9, 5, 9}, 0.1);
    QVERIFY((god.contact().proxy - Vec3(9.9, 5, 10)).norm() < 1e-6 * box.diagonal());
    lead(god, box, {9.9, 5, 9}, {11, 5, 9}, 0.1);
    QVERIFY(!god.contact().touching);
  }

  void neverGoesThroughAThinWall() {
    TriangleSoup plate = moved(floorOf(), {0, 0, 0.01});
    append(plate, turnedOver(floorOf()));
    const ContactSurface wall = surfaceOf(plate);
    GodObject god;
    god.place({0, 0, 3});
    for (const double step : {0.001, 1.0, 10.0, 60.0}) {
      lead(god, wall, {0.1, 0.2, 3}, {0.3, 0.4, -60}, step);
      QVERIFY(god.contact().proxy.z() > 0.01);
      lead(god, wall, {0.3, 0.4, -60}, {0.1, 0.2, 3}, step);
      QVERIFY(!god.contact().touching);
    }
    god.place({0, 0, -3});
    lead(god, wall, {0, 0, -3}, {0, 0, 3}, 0.1);
    QVERIFY(god.contact().proxy.z() < 0.0);
  }

  // A tip that wanders anywhere, fast and slow, never gets the proxy into a closed part.
  void neverEnters() {
    QVERIFY(rc::check([] {
      const int levels = *rc::gen::inRange(0, 5);
      TriangleSoup ball = bumpySphere(levels);
      const auto turned = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0u, 20u << (2 * levels)));
      for (const std::uint32_t i : turned) std::swap(ball.triangles[i][1], ball.triangles[i][2]);  // typical for scans
      const ContactSurface surface = surfaceOf(ball);
      GodObject god;
      Vec3 tip(2, 0, 0);
      god.place(tip);
      const ContactOptions options{.friction = *rc::gen::element(0.0, 0.3)};
      for (int i = 0; i < 500; ++i) {
        const double step = *rc::gen::element(1e-9, 1e-4, 0.01, 0.3, 3.0);
        const auto number = rc::gen::map(rc::gen::inRange(-1000, 1001), [](int n) { return 0.001 * n; });
        tip += step * Vec3(*number, *number, *number);
        if (tip.norm() > 2) tip *= 0.5;
        const Vec3 proxy = god.follow(surface, tip, options).proxy;
        // Each ray from the middle meets the surface once: outside, the continued ray meets nothing.
        int met = 0;
        for (const Triangle& t : ball.triangles) {
          const Vec3 &a = ball.points[t[0]], &b = ball.points[t[1]], &c = ball.points[t[2]];
          const double u = proxy.dot(b.cross(c)), v = proxy.dot(c.cross(a)), w = proxy.dot(a.cross(b));
          if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) continue;
          met += a.dot(b.cross(c)) / (u + v + w) > 1.0 ? 1 : 0;  // beyond the proxy
        }
        RC_ASSERT(met == 0);
      }
    }));
  }

  // At rest, no point of the surface around it is nearer to the tip.
  void restsWhereTheTipIsNearest() {
    const TriangleSoup ball = bumpySphere(4);
    const ContactSurface surface = surfaceOf(ball);
    GodObject god;
    god.place({2, 0, 0});
    int compared = 0;
    for (int i = 0; i <= 2000; ++i) {
      const double angle = 0.003 * i;
      const Vec3 tip = 0.75 * Vec3(std::cos(angle), std::sin(angle) * std::cos(0.3 * angle), std::sin(0.3 * angle));
      const Contact& contact = god.follow(surface, tip, {});
      if (i % 50 != 0 || !contact.touching) continue;
      for (const Triangle& t : ball.triangles) {
        const Vec3 q = closestOnTriangle(contact.proxy, ball.points[t[0]], ball.points[t[1]], ball.points[t[2]]);
        if ((q - contact.proxy).norm() > 1e-4) continue;  // the triangles that it touches
        ++compared;
        for (const std::uint32_t v : t) {
          const Vec3 there = q + 1e-3 * (ball.points[v] - q);
          QVERIFY((there - tip).norm() >= contact.depth - 1e-6);
        }
      }
    }
    QVERIFY(compared >= 40);  // at least one in each of 41 ticks, but for the first
  }

  // Coulomb friction on a floor: held while the tangential force is below µ times the normal one, then µ N against the
  // motion.
  void isHeldByFriction() {
    const ContactSurface floor = surfaceOf(floorOf());
    const ContactOptions rough{.friction = 0.4};
    GodObject god;
    god.place({0, 0.3, 1});
    lead(god, floor, {0, 0.3, 1}, {0, 0.3, -2}, 0.1, rough);
    lead(god, floor, {0, 0.3, -2}, {0.79, 0.3, -2}, 0.1, rough);
    QVERIFY((god.contact().proxy - Vec3(0, 0.3, 0)).norm() < 1e-5);
    lead(god, floor, {0.79, 0.3, -2}, {20, 0.3, -2}, 0.1, rough);
    const Vec3 force = contactForce(god.contact(), {20, 0.3, -2}, Vec3::Zero(), 0.5, 0.0);
    QVERIFY((force - Vec3(-0.4, 0, 1.0)).norm() < 1e-5);
  }

  // Nothing depends on the unit, and hardly anything on the position.
  void isTheSameAtAnyScale() {
    const TriangleSoup ball = bumpySphere(4);
    const auto path = [](int i) {
      const double a = 0.002 * i;
      return Vec3(0.8 * Vec3(std::cos(a), std::sin(a) * std::cos(0.5 * a), std::sin(a) * std::sin(0.5 * a)));
    };
    const auto run = [&](double scale, const Vec3& shift, int i) {
      const ContactSurface surface = surfaceOf(moved(ball, shift, scale));
      GodObject god;
      god.place(scale * Vec3(2, 0, 0) + shift);
      for (int k = 0; k < i; ++k) god.follow(surface, scale * path(k) + shift, {});
      return Vec3((god.contact().proxy - shift) / scale);
    };
    const Vec3 truth = run(1.0, Vec3::Zero(), 500);
    for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) QVERIFY((run(scale, Vec3::Zero(), 500) - truth).norm() < 1e-6);
    QVERIFY((run(100.0, Vec3(1e7, -1e7, 1e7), 500) - truth).norm() < 1e-6);
  }

  void ignoresATipThatIsNoNumber() {
    const ContactSurface floor = surfaceOf(floorOf());
    GodObject god;
    god.place({0, 0, 1});
    const Vec3 proxy = god.follow(floor, {0, 0, -1}, {}).proxy;
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200})
      QCOMPARE(god.follow(floor, {bad, 0, -1}, {}).proxy, proxy);
    QVERIFY(god.follow(floor, {0, 0, -1.5}, {}).touching);
  }

  void bearsTrianglesWithoutArea() {
    TriangleSoup soup = floorOf();
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back({0.5, 0.5, 0.5});
    soup.triangles.push_back({n, n, n});
    soup.triangles.push_back({0, n, n});
    soup.triangles.push_back({0, 1, 1});
    const ContactSurface surface = surfaceOf(soup);
    GodObject god;
    god.place({0.5, 0.5, 2});
    lead(god, surface, {0.5, 0.5, 2}, {0.5, 0.5, -1}, 0.1);
    QVERIFY((god.contact().proxy - Vec3(0.5, 0.5, 0)).norm() < 1e-5);
    god.place({0, 0, 0});
    QVERIFY(!god.follow({}, {1, 2, 3}, {}).touching);  // an empty surface
  }

  // Also if more triangles lie in between than are looked at at once.
  void isLiftedThroughFineTriangles() {
    const auto fine = [](double height) {
      TriangleSoup soup = grid(201, 201, false, false, [&](std::uint32_t i, std::uint32_t j) {
        const double x = 0.02 * i - 2.0, y = 0.02 * j - 2.0;
        return Vec3(x, y, std::max(0.0, height * (1.0 - std::hypot(x, y))));
      });
      const auto n = static_cast<std::uint32_t>(soup.points.size());
      for (const Vec3& p : {Vec3(100, 0, 0), Vec3(101, 0, 0), Vec3(100, 1, 0)}) soup.points.push_back(p);
      soup.triangles.push_back({n, n + 1, n + 2});  // far away, so that the model is large
      return soup;
    };
    const TriangleSoup flat = fine(0.0), bump = fine(0.8);
    ContactSurface surface = surfaceOf(flat);
    GodObject god;
    god.place({0.05, 0.03, 1});
    lead(god, surface, {0.05, 0.03, 1}, {0.05, 0.03, -1}, 0.1);
    surface.update({}, raisedIn(bump));
    god.surfaceChanged(surface);
    const Contact& contact = god.follow(surface, {0.05, 0.03, -1}, {});
    const double height = 0.8 * (1.0 - std::hypot(contact.proxy.x(), contact.proxy.y()));  // height of the bump there
    QVERIFY(contact.touching && contact.proxy.z() > std::max(0.0, height) - 1e-4);
  }

  // A bump that an edit raises under the tip lifts the proxy onto it.
  void isLiftedByAnEdit() {
    const TriangleSoup flat = floorOf();
    const TriangleSoup bump = floorOf([](double x, double y) { return std::max(0.0, 1.0 - 0.1 * std::hypot(x, y)); });
    ContactSurface surface = surfaceOf(flat);
    GodObject god;
    god.place({0.2, 0.3, 1});
    lead(god, surface, {0.2, 0.3, 1}, {0.2, 0.3, -1}, 0.1);
    std::vector<ContactTriangle> changed = raisedIn(bump);
    surface.update({}, changed);
    god.surfaceChanged(surface);
    const Contact& contact = god.follow(surface, {0.2, 0.3, -1}, {});
    QVERIFY(contact.proxy.z() > 0.9);
    // The proxy falls back when the bump is removed.
    for (ContactTriangle& t : changed)
      for (Vec3& corner : t.corners) corner.z() = 0.0;
    surface.update({}, changed);
    god.surfaceChanged(surface);
    QVERIFY(std::abs(god.follow(surface, {0.2, 0.3, -1}, {}).proxy.z()) < 1e-5);
  }
};

HANDWHEEL_TEST(GodObjectTest)
#include "GodObjectTest.moc"
