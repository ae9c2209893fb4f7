// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HapticDevices.h"
#include "SelectFixture.h"
#include "TestClass.h"
#include "haptics/contact/TouchableSurface.h"
#include "haptics/device/SimulatedDevice.h"
#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/servo/ServoLoop.h"
#include "tools/MeasureTool.h"
#include "tools/mesh/MakeFaceTool.h"
#include "tools/mesh/NearFeatures.h"
#include "tools/mesh/boundary/BoundaryTool.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kStiffness = 0.3, kDistance = 4.0;  // N/mm and mm: k and ls of the snapTargets
constexpr double kGrip = 0.3;                        // N/mm, of the hand
constexpr int kTicks = 8000;                         // the loop has measured itself, the ramp is over, the hand rests

// Two plates as the fixture has them, with squares of 10 mm: the upper one is at z = 50. A simulated hand holds a
// device over them, whose servo loop and safety chain are those of the program.
struct HandFixture {
  SelectFixture select{moved(plates(), Vec3::Zero(), 10.0)};
  HalfEdgeMesh mesh = select.document->mesh();
  ContactSurface surface;
  VirtualClock clock;
  Service service{"servo"};
  SimulatedDevice* device = nullptr;
  std::unique_ptr<ServoLoop> loop;

  explicit HandFixture(const Vec3& hand) {
    HalfEdgeMesh::Compact all = mesh.compact();
    surface = touchableSurface(std::move(all.soup.points), std::move(all.soup.triangles), all.faceOf);
    SimulatedDeviceSettings settings = simulatedDevice();
    settings.grip = {kGrip, 0.003, 0.0, 20.0};
    auto made = std::make_unique<SimulatedDevice>(settings, PoseTrajectory(), clock);
    device = made.get();
    device->setTarget({0.0, hand});
    if (!device->open(Progress())) qFatal("the simulated device does not open");
    loop = std::make_unique<ServoLoop>(std::move(made), ServoSettings(), clock, service);
  }
  void feel(const Tool& tool, bool isDiscontinuous) {
    const Vec3 tip = loop->latest().tip.position;
    MeshHaptics feel;
    feel.surface = TouchedSurface{surface, 0.5, 0.0, {}};
    feel.snap =
        SnapAttraction{SnapField(nearFeatures(mesh, surface, tool.snapTargets(), tip, 16.0 * kDistance).features),
                       SnapProfile(SnapShape::Quadratic, kStiffness, kDistance), SnapMethod::Proxy};
    feel.comesFrom = Vec3::UnitZ();
    auto scene = std::make_unique<HapticScene>();
    scene->renderer = std::make_unique<SceneForces>(forceSources(std::move(feel)));
    scene->isDiscontinuous = isDiscontinuous;
    loop->setScene(std::move(scene));
  }
  const ServoSample& run(int ticks) {
    loop->runTicks(static_cast<std::uint64_t>(ticks));
    return loop->latest();
  }
};

// Returns the resting distance of a hand that aims at a distance d from the attracting feature: g (d - x) = 2 k x (ls -
// x) / ls.
double restingDistance(double d) {
  const double a = 2.0 * kStiffness / kDistance, b = kGrip + 2.0 * kStiffness, c = kGrip * d;
  return (b - std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

}  // namespace

class SnapTargetsTest : public QObject {
  Q_OBJECT

 private slots:
  void whatToolsWant() {
    const auto document = meshDocument(plates());
    const MeshServices services = immediateServices(*document);
    QVERIFY(
        (BoundaryTool(*document, services).snapTargets() == SnapTargets{.borderPoints = true, .borderEdges = true}));
    QVERIFY((MakeFaceTool(*document, services).snapTargets() == SnapTargets{.borderPoints = true}));
    SelectTool select(*document, services);
    for (const auto& [mode, wanted] :
         {std::pair(kClick, SnapTargets{.borderEdges = true, .faces = true}),
          std::pair(kBrush, SnapTargets{.faces = true}), std::pair(kLasso, SnapTargets{}),
          std::pair(kConnected, SnapTargets{.faces = true}), std::pair(kAngle, SnapTargets{.faces = true})}) {
      select.setSetting("mode", mode);
      QVERIFY(select.snapTargets() == wanted);
    }
    MeasureTool measure({[](const Ray&) { return std::nullopt; }, [](const SurfacePoint&) { return std::nullopt; }});
    for (const double mode : {0.0, 1.0, 2.0, 3.0}) {
      measure.setSetting("mode", mode);
      QVERIFY(measure.snapTargets() ==
              (mode < 2.0 ? SnapTargets{.corners = true, .edges = true} : SnapTargets{.faces = true}));
    }
  }

  // A hand beside an open edge is drawn to it by the profile's force, and its button selects that edge's loop.
  void anEdgeDrawsTheHand() {
    const Vec3 hand(35, -1, 52), onEdge(35, 0, 50);
    HandFixture fixture(hand);
    fixture.run(1);
    fixture.feel(fixture.select.tool, true);
    const ServoSample rest = fixture.run(kTicks);
    const double x = restingDistance((hand - onEdge).norm());
    QVERIFY(rest.felt.isHeld && (rest.felt.held - onEdge).norm() < 1e-3);
    QVERIFY(std::abs((rest.tip.position - onEdge).norm() - x) < 1e-3);
    const Vec3 force = 2.0 * kStiffness * x * (kDistance - x) / kDistance * (onEdge - hand).normalized();
    QVERIFY((rest.sent.force - force).norm() < 1e-3 * force.norm());
    fixture.select.click(rest.felt.proxy.x(), rest.felt.proxy.y());
    QVERIFY(fixture.select.faces().empty());
    QCOMPARE(fixture.select.tool.selection().loops.size(), 1u);
    QCOMPARE(fixture.mesh.position(*fixture.select.tool.selection().loops.begin()).z(), 50.0);
  }

  // Above a face the nearest point of the face draws it, and its button selects that face.
  void aFaceDrawsTheHand() {
    const Vec3 hand(37, 43, 52.5), onFace(37, 43, 50);
    HandFixture fixture(hand);
    fixture.run(1);
    fixture.feel(fixture.select.tool, true);
    const ServoSample rest = fixture.run(kTicks);
    const double x = restingDistance(2.5);  // 1 mm
    QVERIFY(!rest.felt.isHeld && !rest.felt.isContact && (rest.felt.proxy - onFace).norm() < 1e-3);
    QVERIFY(std::abs(rest.tip.position.z() - 50.0 - x) < 1e-3);
    QVERIFY((rest.sent.force - Vec3(0, 0, -kGrip * (2.5 - x))).norm() < 1e-3);
    fixture.select.click(rest.felt.proxy.x(), rest.felt.proxy.y());
    QVERIFY(fixture.select.tool.selection().loops.empty());
    QCOMPARE(fixture.select.faces(), std::vector<Face>{upper(3, 4)});
  }

  // Features gathered anew at the current tip attract it as before, from the first tick on.
  void gatheredAnewNothingLeaps() {
    HandFixture fixture({35, -1, 52});
    fixture.run(1);
    fixture.feel(fixture.select.tool, true);
    const Vec3 before = fixture.run(kTicks).sent.force;
    Vec3 last = before;
    for (int i = 0; i < 500; ++i) {
      fixture.device->setTarget({0.0, {35 + 0.002 * i, -1, 52}});
      if (i % 16 == 0) fixture.feel(fixture.select.tool, false);
      const Vec3 sent = fixture.run(1).sent.force;
      QVERIFY((sent - last).norm() < 0.005 && sent.norm() > 0.8 * before.norm());
      last = sent;
    }
  }

  // A tool that is taken up where its magnet is strong: 0.59 N at 2.24 mm come by the ramp.
  void aToolThatIsTakenUpLetsNothingLeap() {
    HandFixture fixture({35, -1, 52});
    fixture.run(kTicks);
    fixture.feel(fixture.select.tool, true);
    Vec3 last = Vec3::Zero();
    double largest = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3 sent = fixture.run(1).sent.force;
      largest = std::max(largest, (sent - last).norm());
      last = sent;
    }
    QVERIFY(last.norm() > 0.3);
    QVERIFY(largest < 0.005);
  }
};

HANDWHEEL_TEST(SnapTargetsTest)
#include "SnapTargetsTest.moc"
