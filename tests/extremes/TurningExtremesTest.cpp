// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/WorkpieceShape.h"
#include "machining/TurnedOutline.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

constexpr StockCylinder kExtremeBar{40.0, 100.0, 0.0};

struct CuttingSetup {
  const char* name;
  TurningSide side;
  TurningMethod method;
};

constexpr CuttingSetup kCuttings[] = {{"outside, trimmed", TurningSide::Outside, TurningMethod::Trim},
                                      {"bore, trimmed", TurningSide::Bore, TurningMethod::Trim},
                                      {"outside, by control points", TurningSide::Outside, TurningMethod::Poles},
                                      {"bore, by control points", TurningSide::Bore, TurningMethod::Poles}};

// A tube, so that both sides have a surface: radii 10 and 20.
TurnedProfile tube(double spacing) {
  TurnedProfile part(kExtremeBar, spacing);
  for (std::size_t i = 0; i < part.size(); ++i) part.limitInner(i, 10.0);
  return part;
}

TurningPass passOf(const CuttingSetup& cutting, double nose) {
  TurningPass pass;
  pass.side = cutting.side;
  pass.method = cutting.method;
  pass.noseRadius = nose;
  return pass;
}

// The centre of a nose that is this deep in the wall of the tube.
ProfilePoint noseAt(const CuttingSetup& cutting, double nose, double depth, double z) {
  return cutting.side == TurningSide::Bore ? ProfilePoint(10.0 - nose + depth, z)
                                           : ProfilePoint(20.0 + nose - depth, z);
}

bool isSound(const TurnedProfile& part) {
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (!(part.inner(i) >= 0.0 && part.inner(i) <= part.radius(i) && part.radius(i) <= 20.0)) return false;
  }
  return true;
}

bool isClosedSurface(const TurnedProfile& part) {
  TriangleSoup all;
  const TurnedSurface surface(part, 0.05);
  for (const auto& block : surface.blocks()) {
    const auto base = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), block->points.begin(), block->points.end());
    for (const Triangle& t : block->triangles) all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return findBoundaryLoops(buildMesh(all).mesh).empty();
}

}  // namespace

class TurningExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void ways_data() {
    QTest::addColumn<int>("setup");
    for (int i = 0; i < 4; ++i) QTest::addRow("%s", kCuttings[i].name) << i;
  }

  // Depth 0 takes nothing; 1e-9 mm takes that, moved control points up to as much again.
  void depths_data() { ways_data(); }
  void depths() {
    QFETCH(int, setup);
    const CuttingSetup& how = kCuttings[setup];
    for (const double depth : {0.0, -1e-9, 1e-9, 2e-9, 1e-6}) {
      TurnedProfile part = tube(0.1);
      const TurnedProfile before = part;
      const ProfilePoint from = noseAt(how, 2.0, depth, part.z(300)), to = noseAt(how, 2.0, depth, part.z(700));
      const TurnedProfile::Range changed = cut(part, passOf(how, 2.0), from, to);
      QVERIFY(isSound(part));
      QCOMPARE(changed.isEmpty(), !(depth > 0.0));
      const double taken =
          how.side == TurningSide::Bore ? part.inner(500) - before.inner(500) : before.radius(500) - part.radius(500);
      const double slack = 1e-13 + (how.method == TurningMethod::Poles ? std::max(depth, 0.0) : 0.0);
      QVERIFY2(std::abs(taken - std::max(depth, 0.0)) <= slack, qPrintable(QString::number(taken)));
    }
  }

  // To the axis and through it, and out through the wall: radii stay in order, the rest is parted and its surface
  // closed.
  void toAndThroughTheAxis_data() { ways_data(); }
  void toAndThroughTheAxis() {
    QFETCH(int, setup);
    const CuttingSetup& how = kCuttings[setup];
    for (const double beyond : {0.0, 1e-9, 3.0, 100.0}) {
      TurnedProfile part(kExtremeBar, 0.1);
      if (how.side == TurningSide::Bore) part = tube(0.1);
      const double depth = (how.side == TurningSide::Bore ? 10.0 : 20.0) + beyond;
      const ProfilePoint end = noseAt(how, 2.0, depth, part.z(500));
      const TurningPass pass = passOf(how, 2.0);
      cut(part, pass, noseAt(how, 2.0, -1.0, part.z(500)), end);
      cut(part, pass, end, end);
      QVERIFY(isSound(part));
      QVERIFY(!part.hasMaterial(500));
      // Moved control points may leave a ring of the bar beside the cut.
      const std::size_t most = how.method == TurningMethod::Poles ? 3 : 2;
      QVERIFY(part.pieces().size() >= 2 && part.pieces().size() <= most);
      QCOMPARE(outlinesOf(part).size(), part.pieces().size());
      QVERIFY(isClosedSurface(part));
      QVERIFY(std::isfinite(part.volume()) && part.volume() >= 0.0 && std::isfinite(part.area()));
    }
  }

  // No coordinate and no size that is no number changes anything.
  void noNumber_data() { ways_data(); }
  void noNumber() {
    QFETCH(int, setup);
    TurnedProfile part = tube(0.5);
    const TurnedProfile before = part;
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -HUGE_VAL}) {
      for (int k = 0; k < 4; ++k) {
        ProfilePoint a(15.0, 50.0), b(15.0, 60.0);
        (k < 2 ? a : b)[k % 2] = bad;
        QVERIFY(cut(part, passOf(kCuttings[setup], 1.0), a, b).isEmpty());
      }
      QVERIFY(cut(part, passOf(kCuttings[setup], bad), {15.0, 50.0}, {15.0, 60.0}).isEmpty());
    }
    QCOMPARE(part.volume(), before.volume());
    cut(part, passOf(kCuttings[setup], 1.0), {15.0, 1e300}, {15.0, -1e308});
    QVERIFY(isSound(part));
    QVERIFY(before.volume() >= part.volume());
  }

  // 100,000 passes in one document: each leaves the ones before as they are, all are saved, read and cut once more to
  // the same part, bit for bit.
  void manyPasses() {
    WorkpieceSnapshot workpiece;
    workpiece.chord = 1.0;
    constexpr int kPasses = 100'000;
    for (int i = 0; i < kPasses; ++i) {
      TurningPass pass;
      pass.noseRadius = 0.5;
      const double z = 0.5 * (i * 83LL % 200), r = 25.0 - 10.0 * i / kPasses;
      pass.path = {{r + 0.5, z}};
      pass.times = {0.0};
      workpiece.part = withPass(workpiece, std::move(pass), 0.5);
    }
    QVERIFY(workpiece.part->passes.size() > 90'000);
    const WorkpieceKind kind;
    Container container;
    kind.save(workpiece, container);
    (*container.manifest)["kind"] = "workpiece";
    const auto bytes = writeContainer(container, Compression::None);
    QVERIFY(bytes);
    const auto read = readContainer(*bytes);
    QVERIFY(read && read->damage.empty());
    std::vector<Error> damage;
    const auto loaded = kind.load(read->container, damage, {});
    QVERIFY(loaded && damage.empty());
    const TurnedPart& part = *static_cast<const WorkpieceSnapshot&>(**loaded).part;
    QVERIFY(part.profile == workpiece.part->profile);
    QCOMPARE(part.passes.size(), workpiece.part->passes.size());
    TurnedProfile again(workpiece.stock, 0.5);
    for (const auto& pass : part.passes) cut(again, *pass);
    QVERIFY(again == part.profile);
  }

  // A profile of 100,000 samples: cut, shown, and made a solid; and one of as many as there can be.
  void manySamples() {
    for (const double spacing : {1e-3, 1e-9}) {
      WorkpieceSnapshot workpiece;
      TurningPass pass;
      pass.path = {{21.0, 110.0}, {21.0, 40.0}};
      pass.times = {0.0, 1.0};
      workpiece.part = withPass(workpiece, pass, spacing);
      const TurnedProfile& profile = workpiece.part->profile;
      QCOMPARE(profile.size(), spacing == 1e-3 ? std::size_t{100'001} : TurnedProfile::kMostSamples);
      const auto triangles = placedTriangles(workpiece, {});
      QVERIFY(triangles && triangles->triangles.size() < 1'000'000);
      QVERIFY(checkedStep(workpiece, {}));
    }
  }
};

HANDWHEEL_TEST(TurningExtremesTest)
#include "TurningExtremesTest.moc"
