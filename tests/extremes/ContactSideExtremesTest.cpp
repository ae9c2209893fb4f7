// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExtremeRows.h"
#include "TestClass.h"
#include "haptics/contact/GodObject.h"

#include <random>

using namespace handwheel;

namespace {

constexpr std::size_t kWindingMost = 6000;  // triangles: the winding number looks at each
constexpr int kSides = 6, kTicks = 120;

// Returns the winding number of the surface around a point, from the solid angles of its triangles (van Oosterom and
// Strackee 1983): 0 outside of a closed surface, 1 inside, and never in between, however near.
double windingAround(const TriangleSoup& soup, const Vec3& p) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Vec3 a = soup.points[t[0]] - p, b = soup.points[t[1]] - p, c = soup.points[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double volume = a.dot(b.cross(c));
    sum += std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2.0 * std::numbers::pi);
}

// Returns true if the size is that of a hand, within six orders of magnitude.
bool isOrdinary(double diagonal) {
  return diagonal > 1e-6 && diagonal < 1e8;
}

}  // namespace

// A tip that is led through every extreme mesh, to and fro.
class ContactSideExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void everywhere_data() { test::everyMesh(); }
  void everywhere();
};

// The force is a number, and no more than the distance from the tip to the proxy in the previous tick: it may stay
// there. The proxy never comes to the inside of a closed surface.
void ContactSideExtremesTest::everywhere() {
  QFETCH(test::ExtremeMesh, extreme);
  const TriangleSoup soup = extreme.soup();
  const ContactSurface surface(soup.points, soup.triangles);
  const bool isClosed = extreme.loops == 0 && extreme.oriented && extreme.sound && isOrdinary(surface.diagonal()) &&
                        soup.triangles.size() <= kWindingMost;
  const Vec3 middle = surface.bounds().isEmpty() ? Vec3(Vec3::Zero()) : Vec3(surface.bounds().center());
  const double far = isOrdinary(surface.diagonal()) ? 0.75 * surface.diagonal() : 1.0;
  std::mt19937 random(3);
  std::normal_distribution<double> number;
  for (int side = 0; side < kSides; ++side) {
    const double x = number(random), y = number(random);
    const Vec3 out = far * Vec3(x, y, number(random)).normalized();
    GodObject god;
    god.place(middle + out);
    Vec3 before = middle + out;
    for (int i = 0; i <= kTicks; ++i) {
      const Vec3 tip = middle + out * std::cos(2.0 * std::numbers::pi * i / kTicks);
      const Contact& contact = god.follow(surface, tip, {});
      QVERIFY(contact.proxy.allFinite() && std::isfinite(contact.depth));
      QVERIFY(contactForce(contact, tip, Vec3::Zero(), 0.5, 0.0).allFinite());
      if (!isOrdinary(surface.diagonal())) continue;
      QVERIFY(contact.depth <= (tip - before).norm() + 64.0 * surface.skin());
      if (isClosed) QVERIFY(windingAround(soup, contact.proxy) < 0.5);
      before = contact.proxy;
    }
  }
}

HANDWHEEL_TEST(ContactSideExtremesTest)
#include "ContactSideExtremesTest.moc"
