// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/MeasureTool.h"

#include "TestClass.h"
#include "ToolEvents.h"

#include <QTest>

using namespace handwheel;
using test::Kind;

class MeasureToolTest : public QObject {
  Q_OBJECT

 private slots:
  void twoPoints();
  void threePoints();
  void twoFaces();
  void wall();
  void modes();
  void escStartsAgain();
  void oddPoints();
  void whatHoldsTheTipIsMeasured();
};

namespace {

// The plane z = 0, for x up to 10; beyond 5 it counts as a slope of 45°.
std::optional<SurfacePoint> onPlane(const Ray& ray) {
  if (!ray.isUsable() || ray.direction.z() == 0.0) return std::nullopt;
  const Vec3 p = ray.origin - ray.origin.z() / ray.direction.z() * ray.direction;
  const Vec3 normal = p.x() > 5.0 ? Vec3(1, 0, 1).normalized() : Vec3(Vec3::UnitZ());
  return p.x() <= 10.0 ? std::optional(SurfacePoint{p, normal}) : std::nullopt;
}

// Below the plane a slab as thick as x says; none on the left.
std::optional<WallThickness> slab(const SurfacePoint& at) {
  const double x = at.point.x();
  if (x < 0.0) return std::nullopt;
  return WallThickness{x, at.point - x * Vec3::UnitZ(), 0.5 * x, at.point - 0.25 * x * Vec3::UnitZ()};
}

MeasureTool toolIn(MeasureTool::Mode mode) {
  MeasureTool tool({onPlane, slab});
  tool.setSetting("mode", static_cast<double>(mode));
  return tool;
}

double figure(const MeasureTool& tool, std::string_view id) {
  const std::vector<Property> all = tool.settings();
  const Property* property = test::propertyNamed(all, id);
  return property ? std::get<double>(property->value) : std::nan("");
}

bool isNear(double a, double b) {
  return std::abs(a - b) < 1e-12;
}

}  // namespace

void MeasureToolTest::twoPoints() {
  MeasureTool tool({onPlane, {}});
  QVERIFY(!tool.distance() && tool.settings().size() == 1 && tool.preview().lines.empty());
  QCOMPARE(tool.pointer(test::above(Kind::Press, 1, 2)), ToolReply::Used);
  QVERIFY(!tool.distance());
  tool.pointer(test::above(Kind::Hover, 1, 5));
  QCOMPARE(*tool.distance(), 3.0);
  tool.pointer(test::above(Kind::Press, 4, 6));
  tool.pointer(test::above(Kind::Hover, 9, 9));
  QCOMPARE(*tool.distance(), 5.0);
  QCOMPARE(tool.preview().lines, (std::vector<std::vector<Vec3>>{{Vec3(1, 2, 0), Vec3(4, 6, 0)}}));
  const auto settings = tool.settings();
  QCOMPARE(std::get<double>(settings.at(1).value), 5.0);
  QVERIFY(settings[1].quantity == Quantity::Length && !settings[1].editable);
  tool.pointer(test::above(Kind::Press, 0, 0));  // a new first point
  tool.pointer(test::above(Kind::Leave, 0, 0));
  QVERIFY(!tool.distance());
}

void MeasureToolTest::threePoints() {
  MeasureTool tool = toolIn(MeasureTool::Mode::PointAngle);
  tool.pointer(test::above(Kind::Press, 3, 1));
  tool.pointer(test::above(Kind::Press, 1, 1));
  QVERIFY(!tool.angle() && tool.preview().lines.size() == 1);
  tool.pointer(test::above(Kind::Hover, 1, 4));
  QVERIFY(isNear(*tool.angle(), M_PI / 2));
  tool.pointer(test::above(Kind::Press, 0, 1));
  tool.pointer(test::above(Kind::Hover, 2, 2));
  QVERIFY(isNear(*tool.angle(), M_PI) && isNear(figure(tool, "angle"), M_PI) && !tool.distance());
  // Thousandths of a second of arc, where a cosine would give none.
  tool.pointer(test::above(Kind::Press, 9, 0));
  tool.pointer(test::above(Kind::Press, 0, 0));
  tool.pointer(test::above(Kind::Press, 9, 9e-9));
  QVERIFY(std::abs(*tool.angle() - 1e-9) < 1e-20);
  // The arc lies in the angle, at one distance from the corner.
  tool.pointer(test::above(Kind::Press, 2, 0));
  tool.pointer(test::above(Kind::Press, 0, 0));
  tool.pointer(test::above(Kind::Press, 0, 3));
  const ToolPreview preview = tool.preview();
  QCOMPARE(preview.lines.size(), std::size_t{2});
  QCOMPARE(preview.lines[0], (std::vector<Vec3>{Vec3(2, 0, 0), Vec3(0, 0, 0), Vec3(0, 3, 0)}));
  for (const Vec3& p : preview.lines[1]) {
    QVERIFY(isNear(p.norm(), preview.lines[1][0].norm()) && p.x() > -1e-12 && p.y() > -1e-12 && p.z() == 0.0);
  }
  // A side without length has no angle.
  for (int i = 0; i < 3; ++i) tool.pointer(test::above(Kind::Press, 2, 2));
  QVERIFY(!tool.angle());
}

void MeasureToolTest::twoFaces() {
  MeasureTool tool = toolIn(MeasureTool::Mode::FaceAngle);
  tool.pointer(test::above(Kind::Press, 1, 1));
  tool.pointer(test::above(Kind::Press, 6, 1));
  QVERIFY(isNear(*tool.angle(), 0.75 * M_PI));  // normals 45° apart: the body encloses 135°
  QCOMPARE(tool.preview().lines.size(), std::size_t{2});
  tool.pointer(test::above(Kind::Press, 1, 1));
  tool.pointer(test::above(Kind::Press, 4, 2));
  QVERIFY(isNear(*tool.angle(), M_PI));  // one plane
  MeasureTool walls({[](const Ray& ray) -> std::optional<SurfacePoint> {
                       return SurfacePoint{ray.origin, ray.origin.x() < 0.0 ? -Vec3::UnitX() : Vec3(Vec3::UnitX())};
                     },
                     slab});
  walls.setSetting("mode", 2.0);
  walls.pointer(test::above(Kind::Press, -1, 1));
  walls.pointer(test::above(Kind::Press, 1, 1));
  QVERIFY(isNear(*walls.angle(), 0.0));  // opposite sides
}

void MeasureToolTest::wall() {
  MeasureTool tool = toolIn(MeasureTool::Mode::Thickness);
  tool.pointer(test::above(Kind::Hover, 4, 1));
  QVERIFY(isNear(figure(tool, "thickness"), 4.0) && isNear(figure(tool, "ball"), 2.0));
  const ToolPreview preview = tool.preview();
  QCOMPARE(preview.lines.at(0), (std::vector<Vec3>{Vec3(4, 1, 0), Vec3(4, 1, -4)}));
  for (const Vec3& p : preview.lines.at(1)) QVERIFY(isNear((p - Vec3(4, 1, -1)).norm(), 1.0));
  tool.pointer(test::above(Kind::Press, 2, 1));
  tool.pointer(test::above(Kind::Hover, 4, 1));
  QVERIFY(isNear(figure(tool, "thickness"), 2.0));  // the clicked points stay
  tool.pointer(test::above(Kind::Press, -2, 1));
  QVERIFY(!tool.thickness() && tool.preview().lines.empty() && tool.settings().size() == 1);
}

// If nothing is known but points, only points are measured. Another mode begins anew.
void MeasureToolTest::modes() {
  MeasureTool points({onPlane, {}}), all({onPlane, slab});
  QCOMPARE(points.settings()[0].choices.size(), std::size_t{2});
  QCOMPARE(all.settings()[0].choices.size(), std::size_t{4});
  points.setSetting("mode", 3.0);
  QCOMPARE(std::get<double>(points.settings()[0].value), 0.0);
  for (const double odd : {-1.0, 4.0, std::nan("")}) all.setSetting("mode", odd);
  all.setSetting("mode", true);
  all.setSetting("unknown", 1.0);
  QCOMPARE(std::get<double>(all.settings()[0].value), 0.0);
  all.pointer(test::above(Kind::Press, 1, 1));
  all.setSetting("mode", 1.0);
  QCOMPARE(all.perform("revert"), ToolReply::Finished);
}

void MeasureToolTest::escStartsAgain() {
  MeasureTool tool({onPlane, {}});
  tool.pointer(test::above(Kind::Press, 1, 2));
  QCOMPARE(tool.perform("revert"), ToolReply::Used);
  QCOMPARE(tool.perform("revert"), ToolReply::Finished);
  QCOMPARE(tool.perform("commit"), ToolReply::Finished);
  QCOMPARE(tool.perform("unknown"), ToolReply::Ignored);
  tool.pointer(test::above(Kind::Press, 1, 2));
  tool.documentChanged();
  tool.pointer(test::above(Kind::Hover, 1, 5));
  QVERIFY(!tool.distance());
}

void MeasureToolTest::oddPoints() {
  MeasureTool tool({onPlane, {}});
  QCOMPARE(tool.pointer(test::above(Kind::Press, 11, 0)), ToolReply::Ignored);
  QCOMPARE(tool.pointer(test::above(Kind::Press, std::nan(""), 0)), ToolReply::Ignored);
  tool.pointer(test::above(Kind::Press, -1e150, 0));
  tool.pointer(test::above(Kind::Press, 0, 0));
  QCOMPARE(*tool.distance(), 1e150);
  tool.pointer(test::above(Kind::Press, 1e-300, 0));
  tool.pointer(test::above(Kind::Press, 0, 0));
  QCOMPARE(*tool.distance(), 1e-300);
}

// A corner that attracts the tip is a point even if the ray misses the surface; for faces the ray is used.
void MeasureToolTest::whatHoldsTheTipIsMeasured() {
  MeasureTool tool({onPlane, slab});
  PointerEvent event = test::above(Kind::Press, 11, 0);
  event.held = Vec3(11, 0, 3);
  QCOMPARE(tool.pointer(event), ToolReply::Used);
  event.held = Vec3(11, 4, 0);
  tool.pointer(event);
  QCOMPARE(*tool.distance(), 5.0);
  tool.setSetting("mode", static_cast<double>(MeasureTool::Mode::FaceAngle));
  QCOMPARE(tool.pointer(event), ToolReply::Ignored);
}

HANDWHEEL_TEST(MeasureToolTest)
#include "MeasureToolTest.moc"
