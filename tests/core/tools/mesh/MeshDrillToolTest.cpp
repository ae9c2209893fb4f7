// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/MeshDrillTool.h"

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "WaitingServices.h"
#include "mesh/structure/MeshValidator.h"
#include "proximity/SelfIntersection.h"
#include "tools/ToolRunner.h"
#include "tools/mesh/MeshPreview.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr double kPlateThick = 4.0, kDrillDiameter = 4.0;  // mm

// Its top is at z = 0.
TriangleSoup drilledPlate(double edge = 30.0) {
  return test::box({-0.5 * edge, -0.5 * edge, -kPlateThick}, {edge, edge, kPlateThick});
}

// A mesh and a drill above it.
struct MeshDrillFixture {
  std::unique_ptr<MeshDocument> document;
  MonotonicClock clock;
  Service simulation{"simulation"};
  ToolRunner runner;
  std::vector<std::string> offers;  // reasons
  MeshDrillTool* tool = nullptr;

  explicit MeshDrillFixture(const TriangleSoup& soup) : document(test::meshDocument(soup)) {
    start(immediateServices(*document));
  }
  MeshDrillFixture(const TriangleSoup& soup, test::WaitingServices& waiting) : document(test::meshDocument(soup)) {
    start(waiting.services());
  }
  ~MeshDrillFixture() { runner.stop(); }

  void start(MeshServices services) {
    auto started =
        std::make_unique<MeshDrillTool>(*document, std::move(services), SimulationServices{clock, simulation},
                                        [this](const char* reason) { offers.emplace_back(reason); });
    tool = started.get();
    runner.start(std::move(started), *document);
    runner.setSetting("diameter", PropertyValue(kDrillDiameter));
    runner.setSetting("feed", PropertyValue(20.0));
  }
  ToolReply event(PointerEvent::Kind what, double x, double y) {
    PointerEvent event;
    event.kind = what;
    event.button = what == PointerEvent::Kind::Hover ? PointerButton::None : PointerButton::First;
    event.ray = {Vec3(x, y, 200.0), -Vec3::UnitZ()};
    return runner.pointer(event);
  }
  std::optional<double> setting(const char* id) const {
    for (const Property& property : tool->settings())
      if (property.id == id) return std::get<double>(property.value);
    return std::nullopt;
  }
  std::string says() const { return tool->actions().front().effect; }
  // Presses, waits until the hole is so deep, and releases.
  bool drill(double x, double y, double depth) {
    if (event(PointerEvent::Kind::Press, x, y) != ToolReply::Used || !tool->isLive()) return false;
    const bool isDeep = QTest::qWaitFor([&] { return setting("hole_depth").value_or(0.0) > depth; }, 30'000);
    return event(PointerEvent::Kind::Release, x, y) == ToolReply::Used && isDeep;
  }
  // Returns the flaw of the mesh; empty: none.
  std::string flaw() const {
    const TriangleSoup soup = document->mesh().compact().soup;
    if (!test::countEdges(soup).sound()) return "edges";
    if (!selfIntersections(soup.points, soup.triangles).value().empty()) return "self-intersections";
    return validate(document->mesh());
  }
};

}  // namespace

class MeshDrillToolTest : public QObject {
  Q_OBJECT

 private slots:
  // Held until the drill is through: the hole is in the triangles as one step, and is a cylinder within 1 % at 16
  // voxels to its diameter. Triangles that it does not meet keep their indices. Undone it is gone, redone it is there
  // again.
  void aHoleThroughAPlate() {
    MeshDrillFixture fixture(drilledPlate());
    QCOMPARE(fixture.setting("voxel"), std::optional(kDrillDiameter / 16.0));
    QCOMPARE(fixture.says(), std::string("drill across the surface"));
    const HalfEdgeMesh before = fixture.document->mesh();
    QVERIFY(fixture.drill(0.113, -0.271, kPlateThick + 1.2 * kDrillDiameter));
    QCOMPARE(fixture.document->history()->count(), 1);
    QCOMPARE(fixture.document->history()->undoText(), QStringLiteral("Drill a hole"));
    QCOMPARE(fixture.flaw(), std::string());
    QVERIFY(fixture.offers.empty());
    const HalfEdgeMesh after = fixture.document->mesh();
    QCOMPARE(test::eulerCharacteristic(after), 0L);  // one handle
    const double gone = test::volume(before.compact().soup) - test::volume(after.compact().soup);
    const double exact = 0.25 * M_PI * kDrillDiameter * kDrillDiameter * kPlateThick;
    QVERIFY2(std::abs(gone / exact - 1.0) < 0.01, QByteArray::number(gone / exact));
    std::size_t kept = 0;
    for (Face f = 0; f < before.faceSlots(); ++f)
      if (after.isLive(f)) {
        QCOMPARE(after.triangle(f), before.triangle(f));
        ++kept;
      }
    QCOMPARE(kept, std::size_t{8});  // those of the four sides
    QVERIFY(fixture.setting("max_thrust").value_or(0.0) > 0.0 && fixture.setting("breakthrough").has_value());
    QVERIFY(std::abs(*fixture.setting("removed") / exact - 1.0) < 0.02);
    fixture.document->history()->undo();
    QVERIFY(test::sameMesh(fixture.document->mesh(), before));
    QVERIFY(!fixture.setting("max_thrust"));  // values of undone steps are no longer shown
    fixture.document->history()->redo();
    QVERIFY(test::sameMesh(fixture.document->mesh(), after));
  }

  // Held again within a hole that is not through, it goes on along it, and the hole has one wall; another beside it
  // begins on the surface. What is discarded leaves nothing.
  void holesInTurn() {
    MeshDrillFixture fixture(test::box({-10.0, -10.0, -12.0}, {20.0, 20.0, 12.0}));
    QVERIFY(fixture.drill(-3.0, 1.0, 3.0));
    QCOMPARE(fixture.document->history()->count(), 1);
    const double one = test::volume(fixture.document->mesh().compact().soup);
    // A ball whose front is 3 mm deep: a cylinder of 1 mm with half the ball before it.
    QVERIFY(one < 4800.0 - 0.95 * (4.0 * M_PI + 16.0 / 3.0 * M_PI));
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, -2.2, 1.3), ToolReply::Used);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed").value_or(0.0) > 1.0; }, 30'000));
    const auto deeper = fixture.tool->hole();
    QVERIFY((deeper->poses[0].position() - Vec3(-3.0, 1.0, deeper->poses[0].position().z())).norm() < 1e-3);
    QVERIFY(deeper->poses[0].position().z() < -0.9);
    fixture.runner.perform("revert");
    QCOMPARE(fixture.document->history()->count(), 1);
    const HalfEdgeMesh before = fixture.document->mesh();
    QVERIFY(fixture.drill(-2.2, 1.3, 4.0));
    QVERIFY(fixture.offers.empty());
    QCOMPARE(fixture.document->history()->count(), 2);
    QCOMPARE(fixture.flaw(), std::string());
    const double two = test::volume(fixture.document->mesh().compact().soup);
    QVERIFY(two < one - 0.95 * 4.0 * 4.0 * M_PI);  // 4 mm of a cylinder, and more
    fixture.document->history()->undo();
    QVERIFY(test::sameMesh(fixture.document->mesh(), before));
    fixture.document->history()->redo();
    QVERIFY(fixture.drill(5.0, -4.0, 3.0));
    QVERIFY((fixture.tool->hole()->poses[0].position() - Vec3(5.0, -4.0, 2.0)).norm() < 1e-3);
    QCOMPARE(fixture.flaw(), std::string());
    QCOMPARE(fixture.document->history()->count(), 3);
    QVERIFY(test::volume(fixture.document->mesh().compact().soup) < two - 20.0);
  }

  // While it goes on, the tiles that are cut are shown by voxels and hidden of the mesh, which is not changed yet.
  void shownWhileItIsDrilled() {
    MeshDrillFixture fixture(drilledPlate(60.0));
    fixture.event(PointerEvent::Kind::Hover, 1.0, 2.0);
    QCOMPARE(fixture.tool->preview().lines.size(), std::size_t{2});
    const HalfEdgeMesh before = fixture.document->mesh();
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 1.0, 2.0), ToolReply::Used);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed").value_or(0.0) > 10.0; }, 30'000));
    const MeshPreview shown = meshPreviewOf(fixture.tool->preview());
    QVERIFY(shown.voxels && shown.previewMesh);
    const auto* state = dynamic_cast<const DrillState*>(shown.voxels.get());
    QVERIFY(state && state->isExact && !state->tiles.empty());
    // Both displayed parts together have the area of a plate with that hole: the sides of the tiles fit, except for a
    // share of a voxel.
    double area = test::area(shown.previewMesh->mesh.compact().soup);
    QVERIFY(area < test::area(before.compact().soup) - 8.0 * 8.0);  // a tile of the top, at least
    for (const auto& [key, piece] : state->surface.pieces()) {
      const VolumeTriangles& fine = piece->fine;
      TriangleSoup soup;
      for (std::size_t i = 0; i + 2 < fine.points.size(); i += 3)
        soup.points.emplace_back(fine.points[i], fine.points[i + 1], fine.points[i + 2]);
      for (std::size_t i = 0; i + 2 < fine.corners.size(); i += 3)
        soup.triangles.push_back({static_cast<std::uint32_t>(fine.corners[i]),
                                  static_cast<std::uint32_t>(fine.corners[i + 1]),
                                  static_cast<std::uint32_t>(fine.corners[i + 2])});
      area += test::area(soup);
    }
    const double plain = test::area(before.compact().soup);
    QVERIFY2(area > 0.99 * plain && area < plain + 150.0, QByteArray::number(area - plain));
    QVERIFY(test::sameMesh(fixture.document->mesh(), before));
    QCOMPARE(fixture.runner.perform("revert"), ToolReply::Used);
    QVERIFY(!meshPreviewOf(fixture.tool->preview()).voxels);
    QCOMPARE(fixture.document->history()->count(), 0);
  }

  // The mesh is prepared by a job, and the hole put into it by another; until then the drill waits, and says so. What
  // is cancelled leaves nothing.
  void waitsForJobs() {
    test::WaitingServices waiting;
    MeshDrillFixture fixture(drilledPlate(), waiting);
    QCOMPARE(fixture.says(), std::string("the mesh is being prepared for the drill"));
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QVERIFY(!fixture.tool->isLive() && fixture.offers.empty());
    while (!waiting.jobs.empty()) waiting.work()();  // jobs of voxels for other diameters are outdated and dropped
    QCOMPARE(fixture.says(), std::string("drill across the surface"));
    QVERIFY(fixture.drill(0.0, 0.0, 1.0));
    QCOMPARE(waiting.changes.size(), std::size_t{1});
    QCOMPARE(fixture.says(), std::string("the hole is being taken from the triangles"));
    QVERIFY(meshPreviewOf(fixture.tool->preview()).voxels);  // still seen
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 5.0, 5.0), ToolReply::Used);
    QVERIFY(!fixture.tool->isLive());
    waiting.changes.front().ended();  // cancelled
    QCOMPARE(fixture.says(), std::string("drill across the surface"));
    QVERIFY(!meshPreviewOf(fixture.tool->preview()).voxels && fixture.offers.empty());
    // If the mesh has changed meanwhile, it stays as it is, and the reason is given.
    HalfEdgeMesh other = test::meshDocument(test::cube(50.0))->mesh();
    const HalfEdgeMesh before = other;
    const std::size_t faces = before.liveFaceCount();
    QVERIFY(fixture.drill(0.0, 0.0, 1.0));
    QCOMPARE(waiting.changes.size(), std::size_t{2});
    waiting.changes.back().apply(other, Progress());
    QCOMPARE(other.liveFaceCount(), faces);
    QVERIFY(test::sameMesh(other, before));
    waiting.changes.back().ended();
    QCOMPARE(fixture.offers, std::vector<std::string>{"the mesh was changed meanwhile"});
  }

  // A twist drill of 60 mm does not come onto a slope through the wall opposite: it would cut with its side.
  void aWallBehindTheDrill() {
    TriangleSoup slope = test::box({-5.0, -5.0, -5.0}, {10.0, 10.0, 10.0});
    for (Vec3& p : slope.points) p = Eigen::AngleAxisd(0.25 * M_PI, Vec3::UnitY()) * p;
    for (const double distance : {25.0, 100.0}) {
      TriangleSoup walled = slope;
      test::append(walled, test::box({distance, -10.0, -5.0}, {5.0, 20.0, 150.0}));
      MeshDrillFixture fixture(walled);
      fixture.runner.setSetting("head", PropertyValue(1.0));
      QVERIFY(fixture.tool->setup().tool.shape == DrillShape::Twist);
      QCOMPARE(fixture.event(PointerEvent::Kind::Press, 3.5, 0.0), ToolReply::Used);
      QCOMPARE(fixture.tool->isLive(), distance > 60.0);
      if (distance < 60.0)
        QCOMPARE(fixture.says(), std::string("the drill would cut sideways here: begin on a free surface"));
    }
  }

  // A mesh that cannot be drilled is refused with a reason before drilling, and a volume is offered.
  void refused_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<QString>("reason");
    QTest::newRow("open") << 0 << "the mesh has holes, so it has no inside: close them first";
    QTest::newRow("two that intersect") << 1 << "triangles of the mesh intersect one another: resolve that first";
    QTest::newRow("inside out") << 2 << "a body is inside out: turn it over first";
    QTest::newRow("none") << 3 << "there are no triangles";
    QTest::newRow("huge") << 4 << "the voxels are too small for a part of this size";
  }
  void refused() {
    QFETCH(int, shape);
    QFETCH(QString, reason);
    TriangleSoup soup = drilledPlate();
    if (shape == 0) soup.triangles.pop_back();
    if (shape == 1) test::append(soup, test::box({2.0, 3.0, -2.0}, {40.0, 5.0, 9.0}));
    if (shape == 2) soup = test::turnedOver(soup);
    if (shape == 3) soup = {};
    if (shape == 4) soup = drilledPlate(1e6);
    MeshDrillFixture fixture(soup);
    QCOMPARE(fixture.says(), reason.toStdString());
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, -5.0, -5.0), ToolReply::Used);
    QVERIFY(!fixture.tool->isLive());
    QCOMPARE(fixture.offers, std::vector<std::string>{reason.toStdString()});
    QCOMPARE(fixture.document->history()->count(), fixture.document->openingSteps());
  }

  // A part that would be gone stays, and it is said why.
  void nothingWouldBeLeft() {
    MeshDrillFixture fixture(test::box({-0.5, -0.5, -1.0}, {1.0, 1.0, 1.0}));
    QVERIFY(fixture.drill(0.1, 0.0, 2.0));
    QCOMPARE(fixture.offers, std::vector<std::string>{"nothing would be left of the mesh"});
    QCOMPARE(fixture.document->history()->count(), fixture.document->openingSteps());
    QCOMPARE(fixture.document->mesh().liveFaceCount(), std::size_t{12});
  }

  // Beside the part the camera has the mouse; the voxel follows the head, and can be chosen within limits of it.
  void settings() {
    MeshDrillFixture fixture(drilledPlate());
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 40.0, 0.0), ToolReply::Ignored);
    fixture.runner.setSetting("voxel", PropertyValue(100.0));
    QCOMPARE(fixture.setting("voxel"), std::optional(kDrillDiameter / 6.0));
    fixture.runner.setSetting("voxel", PropertyValue(0.3));
    fixture.runner.setSetting("voxel", PropertyValue(std::nan("")));
    QCOMPARE(fixture.setting("voxel"), std::optional(0.3));
    QVERIFY(fixture.drill(0.0, 0.0, 1.0) && fixture.tool->hole());
    QCOMPARE(fixture.tool->hole()->volume.voxel(), 0.3);
    fixture.runner.setSetting("head", PropertyValue(3.0));  // a saw, which is thin
    const DrillBit saw = fixture.tool->setup().tool;
    QVERIFY(saw.shape == DrillShape::Saw);
    QCOMPARE(fixture.setting("voxel"), std::optional(std::min(saw.diameter / 16.0, saw.width / 4.0)));
  }
};

HANDWHEEL_TEST(MeshDrillToolTest)
#include "MeshDrillToolTest.moc"
