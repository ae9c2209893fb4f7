// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/Transforming.h"

using namespace handwheel;

namespace {

// 100 mm square below, 50 mm above, 10 mm high: the underside is the largest base. A spike of its own reaches this far
// below it.
TriangleSoup frustumOverSpike(double depth) {
  TriangleSoup part = test::cube();
  for (Vec3& p : part.points) {
    const double side = p.z() > 0.5 ? 50.0 : 100.0;
    p = Vec3(side * (p.x() - 0.5), side * (p.y() - 0.5), 10.0 * p.z());
  }
  TriangleSoup spike = test::turnedOver(test::tetrahedron());
  for (Vec3& p : spike.points) p.z() = 1.0 - depth - p.z();
  test::append(part, spike);
  return part;
}

// A unit sphere cut flat below, where its circle has this radius. Its facets have less than a ten-thousandth of its
// area each.
TriangleSoup sphereOnDisc(double radius) {
  constexpr std::uint32_t n = 200, rings = 200;
  const double from = -std::acos(radius), step = (M_PI / 2.0 - from) / rings;
  TriangleSoup s = test::grid(n, rings, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / n, v = from + step * j;
    return Vec3(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
  });
  const auto low = static_cast<std::uint32_t>(s.points.size()), high = low + 1;
  s.points.insert(s.points.end(), {Vec3(0, 0, std::sin(from)), Vec3(0, 0, 1)});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = i * rings, b = (i + 1) % n * rings;
    s.triangles.push_back({low, b, a});
    s.triangles.push_back({high, a + rings - 1, b + rings - 1});
  }
  return s;
}

}  // namespace

// The tolerances of the face on which a part rests: a case just below and one just above each.
class FlatBaseToleranceTest : public QObject {
  Q_OBJECT

 private slots:
  void flatness();
  void leastShare();
};

// If the spike extends too far, the part rests on its top, upside down.
void FlatBaseToleranceTest::flatness() {
  const auto isUpright = [](double depth) {
    const auto pose = ontoLargestFlatFace(buildMesh(frustumOverSpike(depth)).mesh);
    if (!pose) qFatal("a frustum has a base");
    return (pose->linear() * Vec3::UnitZ()).z() > 0.0;
  };
  const double limit = tolerance::kFlatBaseFlatness * std::sqrt(100.0 * 100.0 + 100.0 * 100.0 + 10.0 * 10.0);
  QVERIFY(isUpright(0.98 * limit));
  QVERIFY(!isUpright(1.02 * limit));
}

// The disc has πr², the whole 2π(1 + √(1 - r²)) + πr²: 4π but for r⁴ / 16 of that.
void FlatBaseToleranceTest::leastShare() {
  const auto rests = [](double share) {
    return bool(ontoLargestFlatFace(buildMesh(sphereOnDisc(2.0 * std::sqrt(share))).mesh));
  };
  QVERIFY(!rests(0.98 * tolerance::kFlatBaseShare));
  QVERIFY(rests(1.02 * tolerance::kFlatBaseShare));
}

HANDWHEEL_TEST(FlatBaseToleranceTest)
#include "FlatBaseToleranceTest.moc"
