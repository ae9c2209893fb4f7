// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/contact/GodObject.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Path = std::function<Vec3(double)>;        // position of a tip, from 0 to 1
using Ideal = std::function<Vec3(const Vec3&)>;  // proxy of such a tip on the true surface

constexpr int kPathTicks = 4000;

// Returns the error of the force on a tip led along a path into the mesh, against that of the true surface: root of the
// mean square, as a share of the largest.
double errorOf(const TriangleSoup& mesh, const Vec3& from, const Path& path, const Ideal& ideal) {
  const ContactSurface surface(mesh.points, mesh.triangles);
  GodObject god;
  god.place(from);
  double sum = 0.0, peak = 0.0;
  for (int i = 0; i <= kPathTicks; ++i) {
    const Vec3 tip = path(static_cast<double>(i) / kPathTicks);
    const Contact& contact = god.follow(surface, tip, {});
    const Vec3 truth = ideal(tip) - tip;
    sum += ((contact.proxy - tip) - truth).squaredNorm();
    peak = std::max(peak, truth.norm());
  }
  return std::sqrt(sum / (kPathTicks + 1)) / peak;
}

// A surface (u, v) from 0 to 1, in cells.
TriangleSoup sheet(std::uint32_t rows, std::uint32_t columns, const std::function<Vec3(double, double)>& at) {
  return grid(rows + 1, columns + 1, false, false,
              [&](std::uint32_t i, std::uint32_t j) { return at(double(i) / rows, double(j) / columns); });
}

constexpr double kBar = 0.005;  // 0.5 % of the peak

}  // namespace

class GodObjectAccuracyTest : public QObject {
  Q_OBJECT

 private slots:
  void plane() {
    const TriangleSoup mesh = sheet(200, 200, [](double u, double v) { return Vec3(100 * u, 100 * v, 0); });
    const auto path = [](double t) { return Vec3(10 + 70 * t, 20 + 40 * t * t, std::cos(40 * t) - 0.5); };
    QVERIFY(errorOf(mesh, {10, 20, 5}, path,
                    [](const Vec3& tip) { return Vec3(tip.x(), tip.y(), std::max(tip.z(), 0.0)); }) < 1e-6);
  }

  void sphere() {
    const TriangleSoup mesh = moved(icosphere(7), Vec3::Zero(), 38.0);
    const auto path = [](double t) {
      const double a = 5 * t;
      return Vec3((38 + 1.5 * std::cos(30 * t) - 1) * Vec3(std::cos(a), std::sin(a) * 0.8, std::sin(a) * 0.6));
    };
    QVERIFY(errorOf(mesh, {60, 0, 0}, path,
                    [](const Vec3& tip) { return Vec3(tip * std::max(1.0, 38.0 / tip.norm())); }) < kBar);
  }

  // The force after a free phase is independent of earlier contacts to the last digit, so a recording can be felt
  // again.
  void whateverWasBefore() {
    const TriangleSoup mesh = moved(icosphere(4), Vec3::Zero(), 38.0);
    const ContactSurface surface(mesh.points, mesh.triangles);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const auto direction = [&] { return Vec3(any(random), any(random), any(random)).normalized(); };
    for (int k = 0; k < 300; ++k) {
      const Vec3 start = 45.0 * direction(), end = 20.0 * direction();
      GodObject fresh, used;
      fresh.place(start);
      Vec3 tip = 40.0 * start.normalized();
      used.place(tip);
      for (int i = 0; i < 30; ++i) used.follow(surface, tip -= 0.1 * direction() + 0.1 * tip.normalized(), {});
      used.place(start);
      used.follow(surface, start, {});
      fresh.follow(surface, start, {});
      for (int i = 1; i <= 5; ++i) {
        const Vec3 at = start + 0.2 * i * (end - start);
        QCOMPARE(Vec3(used.follow(surface, at, {}).proxy), Vec3(fresh.follow(surface, at, {}).proxy));
      }
    }
  }

  void torus() {
    const TriangleSoup mesh = test::torus(700, 300, 30.0, 10.0);
    const auto onRing = [](const Vec3& p) { return Vec3(Vec3(p.x(), p.y(), 0).normalized() * 30.0); };
    const auto path = [&](double t) {
      const double a = 4 * t, b = 9 * t;
      const Vec3 out(std::cos(a), std::sin(a), 0);
      return Vec3(30 * out + (9 - std::cos(20 * t)) * (std::cos(b) * out + std::sin(b) * Vec3::UnitZ()));
    };
    QVERIFY(errorOf(mesh, {60, 0, 0}, path, [&](const Vec3& tip) {
              const Vec3 ring = onRing(tip);
              return Vec3(ring + (tip - ring) * std::max(1.0, 10.0 / (tip - ring).norm()));
            }) < kBar);
  }

  // Over the edge of a block: held by the top until the tip is beyond the edge, then free.
  void convexEdge() {
    const TriangleSoup mesh = cube(20.0);
    const auto path = [](double t) { return Vec3(10 + 15 * t, 10 + 3 * t, 19); };
    QVERIFY(errorOf(mesh, {10, 10, 25}, path,
                    [](const Vec3& tip) { return tip.x() <= 20.0 ? Vec3(tip.x(), tip.y(), 20) : tip; }) < kBar);
  }

  // In a valley of 90°: on one side, in the bottom, on the other.
  void concaveEdge() {
    const TriangleSoup mesh =
        sheet(200, 50, [](double u, double v) { return Vec3(100 * u - 50, 50 * v, std::abs(100 * u - 50)); });
    const auto path = [](double t) { return Vec3(20 - 40 * t, 10 + 20 * t, -2); };
    QVERIFY(errorOf(mesh, {20, 10, 40}, path, [](const Vec3& tip) {
              // The foot on the plane z = |x| of its side, or the bottom when that lies beyond.
              const double foot = 0.5 * (std::abs(tip.x()) + tip.z());
              const double side = tip.x() < 0 ? -1.0 : 1.0;
              return foot > 0 ? Vec3(side * foot, tip.y(), foot) : Vec3(0, tip.y(), 0);
            }) < 1e-6);
  }

  // Past the middle of a cap of 1,000 slivers, at 0.3 mm and up to 300 mm/s: with as many steps as there are slivers
  // the proxy is nowhere else, to the last digit.
  void aHandNeedsFewerStepsThanThereAre() {
    constexpr std::uint32_t kSlivers = 1000;
    TriangleSoup cap{{Vec3(0, 0, 1)}, {}};
    for (std::uint32_t i = 0; i < kSlivers; ++i) {
      const double angle = 2 * M_PI * i / kSlivers;
      cap.points.emplace_back(20 * std::cos(angle), 20 * std::sin(angle), 0);
      cap.triangles.push_back({0, i + 1, (i + 1) % kSlivers + 1});
    }
    const ContactSurface surface(cap.points, cap.triangles);
    ContactOptions patient;
    patient.maxSteps = 4 * kSlivers;
    GodObject god, other;
    god.place({-10, 0.3, 2});
    other.place({-10, 0.3, 2});
    for (int i = 0; i < 2000; ++i) {
      const Vec3 tip(-10 * std::cos(2 * M_PI * 5 * 1e-3 * i), 0.3, 0);
      QCOMPARE(god.follow(surface, tip, {}).proxy, other.follow(surface, tip, patient).proxy);
      QVERIFY(god.contact().touching);
    }
  }

  // Past the axis of a cone of 60°. Not nearer: many facets then hold the tip equally well, and it sticks to one.
  void cusp() {
    const double slope = std::sqrt(3.0);
    const TriangleSoup mesh = sheet(1600, 60, [&](double u, double v) {
      const double a = 2 * M_PI * u, r = 20 * (1 - v) * (1 - v);
      return Vec3(r * std::cos(a), r * std::sin(a), -slope * r);
    });
    const auto path = [](double t) { return Vec3(-2 + 4 * t, 1, -6); };
    QVERIFY(errorOf(mesh, {-20, 1, -6}, path, [&](const Vec3& tip) {
              const Vec3 out = Vec3(tip.x(), tip.y(), 0).normalized();
              const Vec3 along = (0.5 * out - 0.5 * slope * Vec3::UnitZ());
              const double depth = tip.dot(Vec3(0.5 * slope * out + 0.5 * Vec3::UnitZ()));
              return depth < 0 ? Vec3(tip.dot(along) * along) : tip;
            }) < kBar);
  }
};

HANDWHEEL_TEST(GodObjectAccuracyTest)
#include "GodObjectAccuracyTest.moc"
