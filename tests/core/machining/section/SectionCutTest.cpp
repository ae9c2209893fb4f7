// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SectionCut.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/measure/ProfileMeasure.h"
#include "machining/section/SectionOutline.h"
#include "machining/section/SectionSource.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

namespace {

using namespace handwheel;

constexpr StockCylinder kBar{40.0, 100.0, 0.0};

// A bare nose with the edges of a tool that turns the outside towards the chuck.
TurningPass noseOf(double radius, ProfilePoint edges = {-1, -1}, TurningSide side = TurningSide::Outside) {
  TurningPass nose;
  nose.noseRadius = radius;
  nose.edges = edges;
  nose.side = side;
  nose.isExact = true;
  return nose;
}

double removedBy(TurnedSection& section, const TurningPass& how, const std::vector<ProfilePoint>& tip,
                 std::uint32_t pass = 0) {
  const double before = section.volume();
  const ProfilePoint toCentre = -how.noseRadius * how.edges;
  for (std::size_t i = 1; i < tip.size(); ++i) {
    const ProfileSegment move{tip[i - 1] + toCentre, tip[i] + toCentre, 0.0};
    if (!cutMove(section, how, move, move, pass)) return std::nan("");
  }
  return before - section.volume();
}

double volumeOfCylinder(double radius, double length) {
  return M_PI * radius * radius * length;
}

class SectionCutTest : public QObject {
  Q_OBJECT

  std::uint64_t work = 10 * kWorkOfAPass;

 private slots:
  // A face of 1 mm: π 20² 1 = 1256.637 mm³, with a point and with noses, inwards and outwards, past the axis or to it.
  void facing_data() {
    QTest::addColumn<double>("nose");
    for (const double nose : {0.0, 0.2, 0.4, 0.8, 1.2}) QTest::addRow("%g", nose) << nose;
  }
  void facing() {
    QFETCH(double, nose);
    const TurningPass tool = noseOf(nose);
    const double past = -2.0 * nose;
    for (const auto& path : {std::vector<ProfilePoint>{{22, 99}, {past, 99}, {past, 102}},
                             std::vector<ProfilePoint>{{past, 103}, {past, 99}, {22, 99}, {22, 103}}}) {
      TurnedSection section(kBar);
      QVERIFY(std::abs(removedBy(section, tool, path) - volumeOfCylinder(20, 1)) < 1e-6);
      QCOMPARE(section.loops().size(), std::size_t{1});
      QVERIFY(std::abs(section.box().max().y() - 99.0) < 1e-9);
    }
  }

  // A boss of Ø20, 3 mm high: the trailing edge leaves a cylinder, and a shoulder that lies where the tip was.
  void facingToABoss() {
    TurnedSection section(kBar);
    QVERIFY(std::abs(removedBy(section, noseOf(0.0), {{22, 97}, {10, 97}, {10, 102}}) -
                     (volumeOfCylinder(20, 3) - volumeOfCylinder(10, 3))) < 1e-6);
    QCOMPARE(section.heightsAt(15.0).size(), std::size_t{2});  // the end in the chuck, and the shoulder
    const auto radii = section.radiiAt(98.0);
    QVERIFY(radii && std::abs(radii->outer - 10.0) < 1e-9);
  }

  // A nose leaves its radius in the corner at the shoulder, and nothing at the end of the boss.
  void facingToABossWithANose() {
    for (const double nose : {0.4, 1.2}) {
      TurnedSection section(kBar);
      // By Pappus: a square without a quarter of a disc.
      const double square = nose * nose, quarter = 0.25 * M_PI * square;
      const double moment = square * 0.5 * nose - quarter * nose * (1.0 - 4.0 / (3.0 * M_PI));
      const double corner = 2.0 * M_PI * (10.0 * (square - quarter) + moment);
      QVERIFY(std::abs(removedBy(section, noseOf(nose), {{23, 97}, {10, 97}, {10, 102}}) -
                       (volumeOfCylinder(20, 3) - volumeOfCylinder(10, 3) - corner)) < 1e-6);
    }
  }

  // A tool with its tip away from the chuck faces a collar on the chuck's side: 1 mm of a collar between Z 50 and 60.
  void facingAtTheChucksSide() {
    TurnedSection section(kBar);
    const TurningPass blade = noseOf(0.0, {-1, -1});
    removedBy(section, blade, {{10, 105}, {10, 60}, {22, 60}});
    const TurningPass left = noseOf(0.0, {-1, 1});
    // A recess from Z 30 to 50 down to Ø20, left by moves along the axis.
    removedBy(section, left, {{22, 30}, {10, 30}, {10, 50}, {22, 50}}, 1);
    const double recess = volumeOfCylinder(20, 20) - volumeOfCylinder(10, 20);
    QVERIFY(std::abs(kBarVolume() - section.volume() - recess - (volumeOfCylinder(20, 40) - volumeOfCylinder(10, 40))) <
            1e-6);
    QVERIFY(std::abs(removedBy(section, left, {{22, 51}, {10, 51}, {10, 49}}, 2) -
                     (volumeOfCylinder(20, 1) - volumeOfCylinder(10, 1))) < 1e-6);
  }

  // The bottom of a bore is faced from the axis outwards: Ø20, from Z 80 to 79.
  void facingInABore() {
    TurnedSection section(kBar);
    const TurningPass bar = noseOf(0.0, {1, -1}, TurningSide::Bore);
    QVERIFY(std::abs(removedBy(section, bar, {{10, 105}, {10, 80}, {0, 80}}) - volumeOfCylinder(10, 20)) < 1e-6);
    QVERIFY(std::abs(removedBy(section, bar, {{0, 80}, {0, 79}, {10, 79}}, 1) - volumeOfCylinder(10, 1)) < 1e-6);
    QVERIFY(std::abs(section.radiiAt(79.5)->inner - 10.0) < 1e-9);
  }

  // A plunge into the middle of the bar is no facing: a point leaves nothing behind it, a nose a groove of its width.
  void plunging() {
    TurnedSection section(kBar);
    QVERIFY(std::abs(removedBy(section, noseOf(0.0), {{22, 50}, {15, 50}, {22, 50}})) < 1e-9);
    const double nose = 0.4;
    const double groove = removedBy(section, noseOf(nose), {{22, 50}, {15, 50}, {22, 50}}, 1);
    // A half disc below a rectangle, by Pappus: the centroid of a half disc is 4 R / 3π below its centre.
    const double half = 0.5 * M_PI * nose * nose * 2.0 * M_PI * (15.0 + nose - 4.0 * nose / (3.0 * M_PI));
    const double expected = half + 2.0 * nose * M_PI * (400.0 - (15.0 + nose) * (15.0 + nose));
    QVERIFY(std::abs(groove - expected) < 1e-6 * expected);
  }

  // A way through air is no depth: 1 mm into a bar whose end is 7 mm away, from 12 mm above it, a point leaves nothing.
  void aShallowPlungeFromFarAway() {
    for (const double start : {21.0, 31.0}) {
      TurnedSection section(kBar);
      QVERIFY(std::abs(removedBy(section, noseOf(0.0), {{start, 93}, {19, 93}, {start, 93}})) < 1e-9);
    }
  }

  // A tube of 2 mm is faced by 5 mm, although it is thinner than that: the tool goes through it.
  void facingATube() {
    TurnedSection section(kBar);
    removedBy(section, noseOf(0.0, {1, -1}, TurningSide::Bore), {{18, 105}, {18, 50}, {0, 50}});
    const double wall = volumeOfCylinder(20, 5) - volumeOfCylinder(18, 5);
    QVERIFY(std::abs(removedBy(section, noseOf(0.0), {{22, 95}, {10, 95}, {10, 105}}, 1) - wall) < 1e-6);
  }

  // A move faces the same in one, and in pieces: along a line, and along a quarter of a circle that begins radially.
  void facingInPieces_data() {
    QTest::addColumn<double>("bulge");
    QTest::newRow("line") << 0.0;
    QTest::newRow("concave") << std::tan(M_PI / 8.0);
    QTest::newRow("convex") << -std::tan(M_PI / 8.0);
  }
  void facingInPieces() {
    QFETCH(double, bulge);
    const ProfileSegment move{{21, 97.3}, bulge == 0.0 ? ProfilePoint(11.5, 97.3) : ProfilePoint(13, 89.3), bulge};
    for (const double nose : {0.0, 0.4}) {
      TurnedSection whole(kBar);
      QVERIFY(cutMove(whole, noseOf(nose), move, move, 0).has_value());
      for (const int count : {2, 3, 7, 16, 40}) {
        TurnedSection section(kBar);
        for (int i = 0; i < count; ++i) {
          const ProfileSegment piece = move.piece(static_cast<double>(i) / count, (i + 1.0) / count);
          QVERIFY(cutMove(section, noseOf(nose), piece, move, 0).has_value());
        }
        QVERIFY(std::abs(section.volume() - whole.volume()) < 1e-6);
      }
    }
  }

  // A ball of 20 mm at the end of a bar of Ø24: its far side has the programmed shape, and one arc is one segment.
  void theFarSideOfABall() {
    TurnedSection section(kBar);
    const TurningPass point = noseOf(0.0);
    removedBy(section, point, {{12, 105}, {12, 60}, {22, 60}});
    const ProfileSegment ball = arcAround({0, 90}, 10, 0.5 * M_PI, -std::atan2(8.0, 6.0));
    const ProfileSegment toTheBall{{0, 103}, {0, 100}, 0.0};
    QVERIFY(cutMove(section, point, toTheBall, toTheBall, 1).has_value());
    for (int i = 0; i < 40; ++i) {
      const ProfileSegment piece = ball.piece(i / 40.0, (i + 1) / 40.0);
      QVERIFY(cutMove(section, point, piece, ball, 1).has_value());
    }
    removedBy(section, point, {{6, 82}, {6, 70}, {14, 70}}, 1);
    // The ball above Z 82 without its cap below: π (r² h - h³/3) from -8 to 10, then the neck and the shaft.
    const double cut = M_PI * ((100.0 * 10.0 - 1000.0 / 3.0) + (100.0 * 8.0 - 512.0 / 3.0));
    const double expected = volumeOfCylinder(20, 60) + volumeOfCylinder(12, 10) + volumeOfCylinder(6, 12) + cut;
    QVERIFY(std::abs(section.volume() - expected) < 1e-3);
    const auto outline = outlineOf(section, 1e-3, 0.0);
    QVERIFY(bool(outline));
    int arcs = 0;
    for (const ProfileSegment& segment : outline->segments()) {
      if (!segment.isArc()) continue;
      ++arcs;
      QVERIFY(std::abs(segment.radius() - 10.0) < 1e-6);
    }
    QCOMPARE(arcs, 1);
  }

  // A blade of 3 mm with corners of 0.2: its groove is 3 mm wide, and each corner leaves R² (1 - π/4).
  void aBladeIsAsWideAsItIs() {
    TurningPass pass;
    pass.tool = toolNamed(shippedLatheTools(), "parting-3");
    pass.path = {{22, 80}, {15, 80}, {22, 80}};
    pass.times = {0, 1, 2};
    TurnedSection section(kBar);
    const auto removal = cutPass(section, pass, 0, work);
    QVERIFY(removal.has_value());
    // The centroid of what a corner leaves is 0.2234 R above the bottom.
    const double corners = 2.0 * 0.04 * (1.0 - 0.25 * M_PI) * 2.0 * M_PI * 15.0447;
    QVERIFY(std::abs(removal->volume - (3.0 * M_PI * (400.0 - 225.0) - corners)) < 1e-3);
    std::vector<double> walls = section.heightsAt(18.0);
    std::sort(walls.begin(), walls.end());
    QCOMPARE(walls.size(), std::size_t{4});
    QVERIFY(std::abs(walls[1] - 80.0) < 1e-9 && std::abs(walls[2] - 83.0) < 1e-9);
  }

  // Parted off, the part is two pieces as long as the cut leaves them.
  void partingOff() {
    TurningPass pass;
    pass.tool = toolNamed(shippedLatheTools(), "parting-3");
    pass.path = {{22, 60}, {-1, 60}};
    pass.times = {0, 1};
    TurnedSection section(kBar);
    QVERIFY(cutPass(section, pass, 0, work).has_value());
    const std::vector<TurnedSection> pieces = section.pieces();
    QCOMPARE(pieces.size(), std::size_t{2});
    QVERIFY(std::abs(pieces[0].box().max().y() - 60.0) < 1e-9);
    QVERIFY(std::abs(pieces[1].box().min().y() - 63.0) < 1e-9);
  }

  // Faced and then drilled, a bore is open; drilled and then faced as well.
  void facesAndBoresInAnyOrder() {
    TurningPass drill;
    drill.tool = toolNamed(shippedLatheTools(), "drill-12");
    drill.side = TurningSide::Bore;
    drill.path = {{0, 105}, {0, 70}, {0, 105}};
    drill.times = {0, 1, 2};
    for (const bool isFacedFirst : {true, false}) {
      TurnedSection section(kBar);
      if (isFacedFirst) removedBy(section, noseOf(0.4), {{22, 99}, {-0.8, 99}, {-0.8, 102}});
      QVERIFY(cutPass(section, drill, 1, work).has_value());
      if (!isFacedFirst) removedBy(section, noseOf(0.4), {{22, 99}, {-0.8, 99}, {-0.8, 102}}, 2);
      QCOMPARE(section.loops().size(), std::size_t{1});
      // The point of 118° is 3.6052 mm high.
      const double hole = volumeOfCylinder(6, 99.0 - 73.6052) + volumeOfCylinder(6, 3.6052) / 3.0;
      QVERIFY(std::abs(section.volume() - (volumeOfCylinder(20, 99) - hole)) < 1e-3);
      QVERIFY(bool(outlineOf(section, 1e-3, 0.0)));
    }
  }

  // An undercut behind a shoulder, which no radius over the axis can say: a T-shaped tool in a groove.
  void anUndercut() {
    TurningPass pass;
    const std::array<ProfilePoint, 4> foot{ProfilePoint(0, 0), ProfilePoint(2, 0), ProfilePoint(2, 6),
                                           ProfilePoint(0, 6)};
    const std::array<ProfilePoint, 4> stem{ProfilePoint(0, 2), ProfilePoint(20, 2), ProfilePoint(20, 4),
                                           ProfilePoint(0, 4)};
    LatheTool tool;
    tool.cutting = {RoundedPolygon(foot, 0.0), RoundedPolygon(stem, 0.0)};
    pass.tool = std::make_shared<const LatheTool>(tool);
    TurnedSection section(kBar);
    // Along the end face inwards beside the bar, then into it along the axis.
    pass.path = {{10, 101}, {10, 96}};
    pass.times = {0, 1};
    QVERIFY(cutPass(section, pass, 0, work).has_value());
    QVERIFY(!section.contains({11.0, 97.0}));
    QVERIFY(section.contains({14.0, 97.0}));
    QVERIFY(section.contains({9.0, 97.0}));
  }

  // The samples of a section are its radii; the face lies where the tool was, not at a sample.
  void samples() {
    TurnedProfile part(kBar, 0.013);
    const TurningPass point = noseOf(0.0);
    const ProfileSegment turning{{15, 105}, {15, 60.0051}, 0.0};
    QVERIFY(cutExactly(part, point, turning, turning, 0).has_value());
    for (std::size_t i = 0; i < part.size(); ++i) QCOMPARE(part.radius(i), part.z(i) < 60.0051 ? 20.0 : 15.0);
    QVERIFY(part.section());
    QVERIFY(std::abs(part.section()->section().volume() - volumeOfCylinder(20, 60.0051) -
                     volumeOfCylinder(15, 39.9949)) < 1e-6);
  }

  // A roughing insert leaves a shoulder that leans by 5°, tangent to its nose of 0.8 mm. It is a face that can be
  // measured at each radius.
  void aLeaningShoulder() {
    TurnedProfile part(kBar, 0.013);
    TurningPass pass;
    pass.isExact = true;
    pass.tool = toolNamed(shippedLatheTools(), "right-roughing");
    pass.path = {{16, 102}, {16, 50}};
    pass.times = {0, 1};
    cut(part, std::make_shared<const TurningPass>(pass), 0);
    const double five = M_PI / 36;
    for (const double radius : {17.5, 18.5, 19.9}) {
      const double height = 50.8 - (0.8 - std::sin(five) * (radius - 16.8)) / std::cos(five);
      const auto face = measureFace(part, TurningSide::Outside, radius, 50.0, 1.0);
      QVERIFY(face && std::abs(*face - height) < 1e-4);
    }
  }

  // A bar that bends lets the tool leave lines whose slopes differ by millionths, with specks of the nose between them:
  // one cylinder for a drawing, and a sound outline.
  void aBentBarHasASoundOutline() {
    TurnedSection section(kBar);
    TurningPass pass;
    pass.noseRadius = 0.8;
    for (int i = 0; i <= 20; ++i) {
      pass.path.emplace_back(14.8 + 1e-6 * i * i, 102.0 - 2.0 * i);
      pass.times.push_back(i);
    }
    QVERIFY(cutPass(section, pass, 0, work).has_value());
    QVERIFY(section.size() > 20);
    const auto outline = outlineOf(section, 1e-3, 0.0);
    QVERIFY(bool(outline));
    QVERIFY(outline->segments().size() <= 7);
    const double moved = std::abs(outline->volume() - section.volume());
    QVERIFY(moved < 2.0 * M_PI * 14.0 * 40.0 * 2e-4);
  }

 private:
  static double kBarVolume() { return volumeOfCylinder(20, 100); }
};

}  // namespace

HANDWHEEL_TEST(SectionCutTest)
#include "SectionCutTest.moc"
