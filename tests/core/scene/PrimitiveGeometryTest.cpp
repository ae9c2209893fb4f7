// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/PrimitiveGeometry.h"

#include "MeshChecks.h"
#include "Surfaces.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

std::shared_ptr<const PrimitiveGeometry> made(Primitive primitive, std::vector<double> dimensions) {
  auto geometry = PrimitiveGeometry::make(primitive, std::move(dimensions));
  return geometry ? *geometry : nullptr;
}

}  // namespace

class PrimitiveGeometryTest : public QObject {
  Q_OBJECT

 private slots:
  void boundsFollowTheDimensions() {
    const auto isAround = [](const GeometryPointer& geometry, const Vec3& half) {
      return geometry->bounds().isApprox(Box(-half, half), 1e-12);
    };
    QVERIFY(isAround(made(Primitive::Cuboid, {2, 4, 6}), {1, 2, 3}));
    QVERIFY(isAround(made(Primitive::Cylinder, {5, 8}), {5, 5, 4}));
    QVERIFY(isAround(made(Primitive::Sphere, {7}), {7, 7, 7}));
    QVERIFY(isAround(made(Primitive::Cone, {5, 8}), {5, 5, 4}));
  }

  void aConeIsClosedAndHasItsApexAtTheTop() {
    const auto cone = made(Primitive::Cone, {10, 30});
    const TriangleSoup& soup = *cone->surface();
    QVERIFY(countEdges(soup).sound());
    const double exact = std::numbers::pi * 100 * 30 / 3;  // inscribed, so a little less
    QVERIFY(volumeOf(soup) < exact && volumeOf(soup) > 0.99 * exact);
    for (const Vec3& p : soup.points) {
      if (p.z() > 14.999) QVERIFY(std::hypot(p.x(), p.y()) < 1e-3);
    }
  }

  void extremeDimensions() {
    for (const PrimitiveDescription& each : primitives()) {
      for (unsigned bits = 0; bits < 1u << each.dimensions.size(); ++bits) {
        std::vector<double> dimensions;
        for (std::size_t i = 0; i < each.dimensions.size(); ++i)
          dimensions.push_back(bits >> i & 1u ? PrimitiveGeometry::kLargestSize : PrimitiveGeometry::kLeastSize);
        const auto geometry = made(each.primitive, dimensions);
        QVERIFY(geometry);
        QVERIFY(!geometry->surface()->triangles.empty());
        QVERIFY(geometry->surface()->triangles.size() < 200'000);
        for (const Vec3& p : geometry->surface()->points) QVERIFY(p.allFinite());
      }
    }
  }

  void dimensionsAreChecked() {
    for (const PrimitiveDescription& each : primitives()) {
      QCOMPARE(&each, &primitives()[static_cast<std::size_t>(each.primitive)]);
      const std::size_t count = each.dimensions.size();
      for (double wrong : {0.0, -1.0, 2e6, std::nan(""), double(INFINITY)}) {
        std::vector<double> dimensions(count, 1.0);
        dimensions.back() = wrong;
        const auto refused = PrimitiveGeometry::make(each.primitive, dimensions);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::ValueOutOfRange);
        QCOMPARE(refused.error().arguments[0], each.dimensions.back().id);
      }
      for (std::size_t other : {count - 1, count + 1}) {
        const auto refused = PrimitiveGeometry::make(each.primitive, std::vector<double>(other, 1.0));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::CountMismatch);
      }
    }
  }
};

HANDWHEEL_TEST(PrimitiveGeometryTest)
#include "PrimitiveGeometryTest.moc"
