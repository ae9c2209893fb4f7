// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/Geometry.h"

#include <rapidcheck.h>

#include <QTest>
#include <bit>
#include <cmath>
#include <random>

using namespace handwheel;

class GeometryTest : public QObject {
  Q_OBJECT

 private slots:
  void doublesStay();
  void singlesAreTheNearest();
  void zeroHasNoSign();
  void vectors();
};

void GeometryTest::doublesStay() {
  for (double v : {0.1, -1e300, 5e-324, 1.0 / 3.0}) QCOMPARE(rounded(v, NumberType::Float64), v);
}

// No single-precision number is nearer than the one found, and such a number is unchanged.
void GeometryTest::singlesAreTheNearest() {
  QVERIFY(rc::check("rounding to single precision", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const double v = std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random), int(random() % 80) - 40);
    const double r = rounded(v, NumberType::Float32);
    const auto f = static_cast<float>(r);
    RC_ASSERT(static_cast<double>(f) == r);
    for (float beside : {std::nextafter(f, -INFINITY), std::nextafter(f, INFINITY)})
      RC_ASSERT(std::abs(v - r) <= std::abs(v - static_cast<double>(beside)));
    RC_ASSERT(rounded(r, NumberType::Float32) == r);
  }));
  QCOMPARE(rounded(0.1, NumberType::Float32), 0.100000001490116119384765625);  // the single next to 0.1, written out
}

void GeometryTest::zeroHasNoSign() {
  for (NumberType type : {NumberType::Float32, NumberType::Float64}) {
    QCOMPARE(std::bit_cast<std::uint64_t>(rounded(-0.0, type)), std::uint64_t{0});
    QCOMPARE(std::bit_cast<std::uint64_t>(rounded(0.0, type)), std::uint64_t{0});
  }
  // The number is below half of the smallest single-precision one.
  QCOMPARE(std::bit_cast<std::uint64_t>(rounded(-1e-60, NumberType::Float32)), std::uint64_t{0});
  QVERIFY(rounded(-1e-60, NumberType::Float64) == -1e-60);
}

void GeometryTest::vectors() {
  const Vec3 p = rounded(Vec3(0.1, -0.0, 3.0), NumberType::Float32);
  QVERIFY(p == Vec3(rounded(0.1, NumberType::Float32), 0.0, 3.0));
  QVERIFY(!std::signbit(p.y()));
}

HANDWHEEL_TEST(GeometryTest)
#include "GeometryTest.moc"
