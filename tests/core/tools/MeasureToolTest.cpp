// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/MeasureTool.h"

#include "ToolEvents.h"

#include <QTest>

using namespace handwheel;
using test::Kind;

class MeasureToolTest : public QObject {
  Q_OBJECT

 private slots:
  void twoPoints();
  void escStartsAgain();
  void oddPlaces();
};

namespace {

// The plane z = 0, for x up to 10.
std::optional<Vec3> onPlane(const Ray& ray) {
  if (!ray.isUsable() || ray.direction.z() == 0.0) return std::nullopt;
  const Vec3 p = ray.origin - ray.origin.z() / ray.direction.z() * ray.direction;
  return p.x() <= 10.0 ? std::optional(p) : std::nullopt;
}

}  // namespace

void MeasureToolTest::twoPoints() {
  MeasureTool tool(onPlane);
  QVERIFY(!tool.distance() && tool.settings().empty() && tool.preview().lines.empty());
  QCOMPARE(tool.pointer(test::above(Kind::Press, 1, 2)), ToolReply::Used);
  QVERIFY(!tool.distance());
  tool.pointer(test::above(Kind::Hover, 1, 5));
  QCOMPARE(*tool.distance(), 3.0);
  tool.pointer(test::above(Kind::Press, 4, 6));
  tool.pointer(test::above(Kind::Hover, 9, 9));
  QCOMPARE(*tool.distance(), 5.0);
  QCOMPARE(tool.preview().lines, (std::vector<std::vector<Vec3>>{{Vec3(1, 2, 0), Vec3(4, 6, 0)}}));
  const auto settings = tool.settings();
  QCOMPARE(std::get<double>(settings.at(0).value), 5.0);
  QVERIFY(settings[0].quantity == Quantity::Length && !settings[0].editable);
  tool.pointer(test::above(Kind::Press, 0, 0));  // a new first point
  tool.pointer(test::above(Kind::Leave, 0, 0));
  QVERIFY(!tool.distance());
}

void MeasureToolTest::escStartsAgain() {
  MeasureTool tool(onPlane);
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

void MeasureToolTest::oddPlaces() {
  MeasureTool tool(onPlane);
  QCOMPARE(tool.pointer(test::above(Kind::Press, 11, 0)), ToolReply::Ignored);
  QCOMPARE(tool.pointer(test::above(Kind::Press, std::nan(""), 0)), ToolReply::Ignored);
  tool.pointer(test::above(Kind::Press, -1e150, 0));
  tool.pointer(test::above(Kind::Press, 0, 0));
  QCOMPARE(*tool.distance(), 1e150);
  tool.pointer(test::above(Kind::Press, 1e-300, 0));
  tool.pointer(test::above(Kind::Press, 0, 0));
  QCOMPARE(*tool.distance(), 1e-300);
}

QTEST_GUILESS_MAIN(MeasureToolTest)
#include "MeasureToolTest.moc"
