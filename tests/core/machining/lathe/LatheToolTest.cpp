// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheTool.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"

#include <QtTest>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

using namespace handwheel;

namespace {

constexpr StockCylinder kRod{40.0, 100.0, 0.0};

double radiusAtZ(const TurnedProfile& part, double z) {
  return part.radius(static_cast<std::size_t>(std::lround(z / part.spacing())));
}

}  // namespace

class LatheToolTest : public QObject {
  Q_OBJECT

 private slots:
  void theShippedToolsAreComplete() {
    const LatheTools tools = shippedLatheTools();
    std::set<LatheToolKind> kinds;
    std::set<std::string> ids;
    for (const auto& tool : tools) {
      kinds.insert(tool->kind);
      QVERIFY2(ids.insert(tool->id).second, tool->id.c_str());
      QVERIFY(toolNamed(tools, tool->id) == tool);
      QVERIFY(latheToolKindNamed(idOf(tool->kind)) == tool->kind);
      QVERIFY(QByteArray(titleOf(tool->kind)).size() > 0);
    }
    QCOMPARE(kinds.size(), kLatheToolKinds);
    QVERIFY(!toolNamed(tools, "no such tool"));
    QVERIFY(!latheToolKindNamed("spoon"));
  }

  // The tip of each tool is where its orientation says: the section touches both lines through it, and the nose is
  // round.
  void tipsAndNoses() {
    for (const auto& tool : shippedLatheTools()) {
      double leastR = 1e9, largestR = -1e9, leastZ = 1e9, largestZ = -1e9;
      for (const RoundedPolygon& section : tool->cutting) {
        const SectionSweep still(section, {0, 0}, {0, 0});
        leastR = std::min(leastR, still.least()), largestR = std::max(largestR, still.largest());
        leastZ = std::min(leastZ, still.first()), largestZ = std::max(largestZ, still.last());
      }
      const bool isInner = tool->side == TurningSide::Bore && tool->kind != LatheToolKind::Drill;
      if (tool->kind != LatheToolKind::Drill) QVERIFY2(std::abs(isInner ? largestR : leastR) < 1e-3, tool->id.c_str());
      const int o = tool->orientation;
      if (o == 2 || o == 3 || o == 7) QVERIFY2(std::abs(leastZ) < 1e-3, tool->id.c_str());
      if (o == 1 || o == 4 || o == 5) QVERIFY2(std::abs(largestZ) < 1e-3, tool->id.c_str());
      if (tool->kind == LatheToolKind::GrindingDisk || tool->isAbrasive()) continue;
      const RoundedPolygon& nose = tool->cutting.front();
      QCOMPARE(nose.radius(), tool->noseRadius);
      const ProfilePoint centre = tool->noseCentre();
      const bool isThere = std::any_of(nose.corners().begin(), nose.corners().end(),
                                       [&](const ProfilePoint& p) { return (p - centre).norm() < 1e-3; });
      QVERIFY2(isThere, tool->id.c_str());
    }
  }

  // A right tool leaves a cylinder and a square shoulder with the fillet of its nose.
  void aShoulderByARightTool() {
    const LatheTools tools = shippedLatheTools();
    const auto tool = toolNamed(tools, "right-roughing");
    TurnedProfile part(kRod, 0.01);
    cutWithTool(part, *tool, {16.0, 105.0}, {16.0, 60.0});
    for (const double z : {61.0, 75.0, 99.0}) QVERIFY(std::abs(radiusAtZ(part, z) - 16.0) < 1e-3);
    // The fillet: r - tip = R - sqrt(R² - (R - z)²) over the nose.
    const double height = 0.8 - std::sqrt(0.8 * 0.8 - 0.5 * 0.5);
    QVERIFY(std::abs(radiusAtZ(part, 60.3) - (16.0 + height)) < 1e-3);
    QCOMPARE(radiusAtZ(part, 59.9), 20.0);
    // The left tool comes from the other side.
    TurnedProfile left(kRod, 0.01);
    cutWithTool(left, *toolNamed(tools, "left-roughing"), {16.0, 20.0}, {16.0, 40.0});
    QVERIFY(std::abs(radiusAtZ(left, 30.0) - 16.0) < 1e-3);
    QVERIFY(std::abs(radiusAtZ(left, 39.7) - (16.0 + height)) < 1e-3);
    QCOMPARE(radiusAtZ(left, 40.1), 20.0);
  }

  void aHoleByADrillAndABoringBar() {
    const LatheTools tools = shippedLatheTools();
    TurnedProfile part(kRod, 0.01);
    cutWithTool(part, *toolNamed(tools, "drill-16"), {0.0, 110.0}, {0.0, 50.0});
    // A cylinder to where the point begins, then its cone of 118°.
    const double cone = 8.0 / std::tan(59.0 * M_PI / 180.0);
    const auto innerAt = [&](double z) {
      return part.inner(static_cast<std::size_t>(std::lround(z / part.spacing())));
    };
    QVERIFY(std::abs(innerAt(90.0) - 8.0) < 1e-9);
    QVERIFY(std::abs(innerAt(50.0 + 0.5 * cone) - 4.0) < 0.02);
    QCOMPARE(innerAt(49.9), 0.0);
    cutWithTool(part, *toolNamed(tools, "boring-12"), {10.0, 105.0}, {10.0, 80.0});
    QVERIFY(std::abs(innerAt(90.0) - 10.0) < 1e-3);
    QVERIFY(std::abs(innerAt(79.9) - 8.0) < 1e-9);
    QCOMPARE(part.radius(0), 20.0);
  }

  void parting() {
    TurnedProfile part(kRod, 0.05);
    const auto blade = toolNamed(shippedLatheTools(), "parting-3");
    cutWithTool(part, *blade, {22.0, 50.0}, {-0.3, 50.0});
    QCOMPARE(part.pieces().size(), std::size_t{2});
    QVERIFY(std::abs(blade->width() - 3.0) < 1e-9);
  }

  // Perpendicular to the motion of the edge, on the side without material: outside, in a bore, facing; and zero if an
  // edge plunges evenly.
  void theDirectionOfThePassiveForce() {
    const LatheTools tools = shippedLatheTools();
    const ProfilePoint toChuck(0.0, -2.0), away(0.0, 0.1), in(-0.3, 0.0), out(1.0, 0.0);
    const auto is = [&](const char* id, const ProfilePoint& direction, const ProfilePoint& expected) {
      return (toolNamed(tools, id)->passiveDirection(direction) - expected).norm() < 1e-12;
    };
    QVERIFY(is("right-roughing", toChuck, {1.0, 0.0}) && is("left-roughing", away, {1.0, 0.0}));
    QVERIFY(is("facing", in, {0.0, 1.0}) && is("facing", out, {0.0, 1.0}) && is("left-finishing", in, {0.0, -1.0}));
    QVERIFY(is("boring-12", toChuck, {-1.0, 0.0}) && is("boring-12", out, {0.0, 1.0}));
    QVERIFY(is("parting-3", in, {0.0, 0.0}) && is("threading-60", in, {0.0, 0.0}) && is("threading-60", toChuck, out));
    QVERIFY(is("right-roughing", {-1.0, -1.0}, {0.0, 0.0}) && is("drill-10", toChuck, {0.0, 0.0}));
    QVERIFY(is("right-roughing", {0.0, 0.0}, {0.0, 0.0}));
    // In any direction: perpendicular to it, and no longer than 1.
    for (double angle = 0.0; angle < 6.28; angle += 0.1) {
      const ProfilePoint direction(std::cos(angle), std::sin(angle));
      for (const auto& tool : tools) {
        const ProfilePoint passive = tool->passiveDirection(direction);
        QVERIFY(std::abs(passive.dot(direction)) < 1e-12 && passive.norm() <= 1.0 + 1e-12);
      }
    }
  }

  void jsonKeepsTools() {
    for (const auto& tool : shippedLatheTools()) {
      const Result<LatheTool> back = latheToolFrom(toJson(*tool));
      QVERIFY(back.hasValue());
      QVERIFY(*back == *tool);
    }
  }

  void hostileTools() {
    using nlohmann::json;
    const json good = toJson(*shippedLatheTools().front());
    const auto refused = [&](const char* key, const json& value) {
      json bad = good;
      bad[key] = value;
      return !latheToolFrom(bad);
    };
    QVERIFY(refused("id", "") && refused("kind", "spoon") && refused("kind", 3));
    QVERIFY(refused("nose_radius", -1.0) && refused("nose_radius", 1e300) && refused("orientation", 0));
    QVERIFY(refused("orientation", 10) && refused("entering_angle", 0.0) && refused("rake", 90.0));
    QVERIFY(refused("cutting", json::array()) && refused("cutting", 3) && refused("holder", json(100, json::object())));
    QVERIFY(refused("cutting", {{{"corners", {{1, 2}, {3}}}}}) && refused("cutting", {{{"corners", {{1, 1e9}}}}}));
    QVERIFY(refused("cutting", {{{"corners", json(13, json{1, 2})}}}));
    QVERIFY(!latheToolFrom(json()) && !latheToolFrom(json::array({1})));
  }
};

HANDWHEEL_TEST(LatheToolTest)
#include "LatheToolTest.moc"
