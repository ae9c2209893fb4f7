// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/TouchableSurface.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/contact/GodObject.h"

#include <QtTest>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Two sheets of 100 mm by 50 mm in z = 0, apart by 1 µm along x = 0; cut differently.
TriangleSoup seamedSheet() {
  const auto sheet = [](std::uint32_t rows, double from, double to) {
    return grid(11, rows + 1, false, false, [=](std::uint32_t i, std::uint32_t j) {
      return Vec3(from + (to - from) * i / 10.0, -50.0 + 100.0 * j / rows, 0.0);
    });
  };
  TriangleSoup s = sheet(10, -50.0, -0.0005);
  append(s, sheet(7, 0.0005, 50.0));
  return s;
}

std::multiset<std::uint32_t> numbersIn(const ContactSurface& surface) {
  std::multiset<std::uint32_t> numbers;
  const Box all(Vec3::Constant(-1e3), Vec3::Constant(1e3));
  surface.forEachInBox(all, [&](const ContactTriangle& t) {
    numbers.insert(t.id);
    return true;
  });
  return numbers;
}

// Returns the height at which a tip stops that is pressed down from above at x, y.
double stopAt(const ContactSurface& surface, double x, double y) {
  GodObject god;
  god.place(Vec3(x, y, 1.0));
  return god.follow(surface, Vec3(x, y, -1.0), {}).proxy.z();
}

}  // namespace

class TouchableSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // Each face has its own number, the strips of the seam have others, and none occurs twice.
  void facesKeepTheirNumbers() {
    const TriangleSoup s = seamedSheet();
    std::vector<std::uint32_t> faces;
    for (std::size_t i = 0; i < s.triangles.size(); ++i) faces.push_back(static_cast<std::uint32_t>(3 * i + 5));
    const auto numbers = numbersIn(touchableSurface(s.points, s.triangles, faces));
    QVERIFY(numbers.size() > s.triangles.size());
    for (const std::uint32_t f : faces) QCOMPARE(numbers.count(touchableNumber(f)), std::size_t(1));
    for (const std::uint32_t n : numbers) {
      QCOMPARE(numbers.count(n), std::size_t(1));
      if (n % 2 == 0) QVERIFY(std::find(faces.begin(), faces.end(), n / 2) != faces.end());
    }
  }

  void aTipDoesNotFallIntoASeam() {
    const TriangleSoup s = seamedSheet();
    const ContactSurface surface = touchableSurface(s.points, s.triangles, {});
    for (int i = -45; i <= 45; ++i) QVERIFY(std::abs(stopAt(surface, 0.0, i + 0.123)) < 1e-3);
  }

  // After an edit the tip meets the present surface: nothing where a face was removed, the new height where one moved.
  void editsAreFelt() {
    const TriangleSoup s = cube(10.0, Vec3::Constant(-5.0));
    ContactSurface surface = touchableSurface(s.points, s.triangles, {});
    QVERIFY(std::abs(stopAt(surface, 20.0, 20.0) + 1.0) < 1e-9);  // beside it
    std::vector<std::uint32_t> top;
    std::vector<ContactTriangle> raised;
    for (std::uint32_t f = 0; f < s.triangles.size(); ++f) {
      TrianglePoints corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = s.points[s.triangles[f][k]];
      if (std::any_of(corners.begin(), corners.end(), [](const Vec3& p) { return p.z() < 0.0; })) continue;
      top.push_back(touchableNumber(f));
      for (Vec3& p : corners) p.z() = 0.5;
      raised.push_back({corners, touchableNumber(f)});
    }
    QCOMPARE(top.size(), std::size_t(2));
    surface.update(top, {});
    QCOMPARE(stopAt(surface, 1.0, 2.0), -1.0);
    surface.update({}, raised);
    QVERIFY(std::abs(stopAt(surface, 1.0, 2.0) - 0.5) < 1e-6);
  }

  void nothingIsTouchedInNothing() { QVERIFY(touchableSurface({}, {}, {}).empty()); }
};

HANDWHEEL_TEST(TouchableSurfaceTest)
#include "TouchableSurfaceTest.moc"
