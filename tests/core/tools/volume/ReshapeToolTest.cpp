// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ReshapeTool.h"

#include "ClosedSurface.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "document/volume/LayerSteps.h"
#include "document/volume/VolumeKind.h"
#include "mesh/search/LargestDistance.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "proximity/SelfIntersection.h"
#include "tools/ToolRunner.h"
#include "tools/volume/VoxelizeOperations.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>
#include <deque>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;
using Change = ReshapeTool::Change;

namespace {

constexpr double kRadius = 10.0, kVoxel = 0.5;  // mm

double ball(double radius) {
  return 4.0 / 3.0 * M_PI * radius * radius * radius;
}

// Returns the volume of the intersection of two balls of a radius whose centres are this far apart.
double lens(double radius, double apart) {
  return M_PI / 12.0 * (4.0 * radius + apart) * (2.0 * radius - apart) * (2.0 * radius - apart);
}

SparseVolume ballAt(const Vec3& centre, double radius) {
  return volumeOfSurface(moved(icosphere(4), centre, radius), kVoxel)->volume;
}

// A document of a volume with the tool on it. Jobs wait until they are run.
struct Fixture {
  VolumeKind kind;
  std::unique_ptr<VolumeDocument> document;
  ToolRunner runner;
  std::vector<OtherBody> others;
  std::deque<std::pair<ReshapeServices::Job, std::function<void()>>> waiting;
  std::vector<Error> failures;
  int files = 0;

  Fixture(const SparseVolume& volume, Change change) {
    auto content = std::make_shared<VolumeSnapshot>();
    content->volume = volume;
    content->surface = VolumeSurface(volume);
    document = std::make_unique<VolumeDocument>(OpenedFile{&kind, {}, std::move(content)});
    start(change);
  }
  void start(Change change) {
    ReshapeServices services;
    services.run = [this](ReshapeServices::Job job, std::function<void()> stopped) {
      waiting.clear();
      waiting.emplace_back(std::move(job), std::move(stopped));
    };
    services.cancel = [this] { waiting.clear(); };
    services.bodies = [this] { return others; };
    services.addFile = [this] { ++files; };
    services.failed = [this](const Error& error) { failures.push_back(error); };
    runner.start(std::make_unique<ReshapeTool>(*document, std::move(services), change), *document);
  }
  void work() {
    while (!waiting.empty()) {
      const auto job = std::move(waiting.front().first);
      waiting.pop_front();
      runner.deliver(job.work({}));
    }
  }
  void set(const char* id, PropertyValue value) { runner.setSetting(id, value); }
  const SparseVolume& volume() const { return document->volume()->volume; }
  double material() const { return volume().material(); }
  std::optional<double> figure(std::string_view id) const {
    for (const Property& property : runner.tool()->settings())
      if (property.id == id) return std::get<double>(property.value);
    return {};
  }
  bool isProposed() const { return runner.tool()->preview().ofKind != nullptr; }
};

bool isNear(double value, double expected, double share = 0.02) {
  return std::abs(value / expected - 1.0) < share;
}

}  // namespace

class ReshapeToolTest : public QObject {
  Q_OBJECT

 private slots:
  // Shells and moved surfaces have the volumes of geometry; what is shown is what is committed, as one step.
  void wallsOfABall() {
    Fixture fixture(ballOfVoxels(kRadius, kVoxel), Change::Shell);
    fixture.set("wall", 2.0);
    QVERIFY(!fixture.isProposed());
    fixture.work();
    QVERIFY(fixture.isProposed());
    QVERIFY(isNear(fixture.material(), ball(kRadius)));
    QVERIFY(isNear(*fixture.figure("after"), ball(kRadius) - ball(kRadius - 2.0)));
    QCOMPARE(fixture.runner.perform("commit"), ToolReply::Used);
    QVERIFY(isNear(fixture.material(), ball(kRadius) - ball(kRadius - 2.0)));
    QVERIFY(isClosedManifold(surfaceOf(fixture.volume())));
    QCOMPARE(fixture.document->history()->index(), 1);
    QVERIFY(fixture.waiting.empty() && !fixture.isProposed());  // no shell of the shell
    fixture.document->history()->undo();
    QVERIFY(isNear(fixture.material(), ball(kRadius)));

    for (const double distance : {1.5, -1.5}) {
      fixture.set("change", static_cast<double>(Change::Offset));
      fixture.set("distance", distance);
      fixture.work();
      QVERIFY(isNear(*fixture.figure("after"), ball(kRadius + distance)));
    }
  }

  // Work on a drilling exercise is not changed as a whole: nothing is computed, and it says why.
  void refusedInAnExercise() {
    Fixture fixture(ballOfVoxels(kRadius, kVoxel), Change::Smooth);
    QVERIFY(!fixture.waiting.empty());
    const nlohmann::json exercise = {{"subject", "drilling"}, {"task", nlohmann::json::object()}};
    fixture.document->assign({std::make_shared<const nlohmann::json>(exercise),
                              std::make_shared<const nlohmann::json>(nlohmann::json::object())},
                             false);
    const auto before = fixture.document->volume();
    for (int i = 0; i < ReshapeTool::kChanges; ++i) {
      fixture.start(static_cast<Change>(i));
      QVERIFY(fixture.waiting.empty() && !fixture.isProposed());
      const ToolAction commit = fixture.runner.tool()->actions().front();
      QVERIFY(!commit.enabled);
      QCOMPARE(commit.reason, std::string("this volume is to be drilled, not shaped"));
      QCOMPARE(fixture.runner.perform("commit"), ToolReply::Ignored);
      QVERIFY(fixture.waiting.empty());
    }
    QCOMPARE(fixture.document->volume(), before);
    QCOMPARE(fixture.document->history()->count(), 0);
  }

  // Layers of clay are applied by a change of the whole volume, and come back when it is undone.
  void appliesLayers() {
    Fixture fixture(ballOfVoxels(kRadius, kVoxel), Change::Shell);
    fixture.document->commit("layer", withNewLayer(*fixture.document->volume(), "first").edit());
    QVERIFY(fixture.document->volume()->layers);
    fixture.set("wall", 2.0);
    fixture.work();
    QCOMPARE(fixture.runner.perform("commit"), ToolReply::Used);
    QVERIFY(isNear(fixture.material(), ball(kRadius) - ball(kRadius - 2.0)));
    QVERIFY(!fixture.document->volume()->layers);
    fixture.document->history()->undo();
    QVERIFY(fixture.document->volume()->layers);
  }

  // The three combinations with a ball beside, against the volume of the lens that both have.
  void combined() {
    static constexpr double kApart = 9.0;
    Fixture fixture(ballOfVoxels(kRadius, kVoxel), Change::Boolean);
    QVERIFY(fixture.waiting.empty());
    QCOMPARE(fixture.runner.perform("commit"), ToolReply::Ignored);  // with nothing
    QCOMPARE(fixture.runner.perform("file"), ToolReply::Used);
    QCOMPARE(fixture.files, 1);
    fixture.others.push_back({"1", "far", [](const SparseVolume&, Progress) -> Result<SparseVolume> {
                                return ballAt(Vec3(0, 0, 100), 3.0);
                              }});
    fixture.others.push_back({"2", "near", [](const SparseVolume&, Progress) -> Result<SparseVolume> {
                                return ballAt(Vec3(kApart, 0, 0), kRadius);
                              }});
    fixture.set("with", 1.0);
    const double common = lens(kRadius, kApart);
    const double expected[] = {2.0 * ball(kRadius) - common, ball(kRadius) - common, common};
    for (int how = 0; how < 3; ++how) {
      fixture.set("how", static_cast<double>(how));
      fixture.work();
      QVERIFY(isNear(*fixture.figure("after"), expected[how]));
    }
    // Nothing in common: that is refused, and nothing is there to commit.
    fixture.set("with", 0.0);
    fixture.work();
    QCOMPARE(fixture.failures.size(), std::size_t{1});
    QVERIFY(fixture.failures[0].code == VolumeErrors::NothingLeft);
    QVERIFY(!fixture.isProposed());
  }

  // The chosen body stays the displayed one, even if those before it have gone; the first one that appears is proposed.
  void bodiesComeAndGo() {
    Fixture fixture(ballOfVoxels(kRadius, kVoxel), Change::Boolean);
    const auto offer = [&](const char* key, double radius) {
      fixture.others.push_back({key, key, [radius](const SparseVolume&, Progress) -> Result<SparseVolume> {
                                  return ballAt(Vec3(0, 0, 100), radius);
                                }});
    };
    offer("a", 3.0);
    fixture.set("with", std::string("a"));
    QVERIFY(!fixture.waiting.empty());
    fixture.work();
    QVERIFY(isNear(*fixture.figure("difference"), ball(3.0), 0.05));
    offer("b", 5.0);
    offer("c", 7.0);
    fixture.set("with", 0.0);  // now all three are shown
    fixture.others.erase(fixture.others.begin());
    fixture.set("with", 1.0);
    fixture.work();
    QVERIFY(isNear(*fixture.figure("difference"), ball(5.0), 0.05));
    fixture.others.clear();
    fixture.set("with", std::string("b"));
    fixture.work();
    QVERIFY(isNear(*fixture.figure("difference"), ball(5.0), 0.05));
  }

  // The slider of debris: parts go by their size, the largest never; what goes is shown.
  void debris() {
    SparseVolume volume = ballOfVoxels(kRadius, kVoxel);
    for (const auto& [x, radius] : {std::pair{16.0, 3.0}, std::pair{24.0, 1.5}}) {
      const SparseVolume other = ballAt(Vec3(x, 0, 0), radius);
      volume = *makeBoolean(volume, other, OperationValues(booleanOperation()), {});
    }
    Fixture fixture(volume, Change::Debris);
    fixture.set("below", 1.0);
    fixture.work();
    QVERIFY(!fixture.runner.tool()->actions().front().enabled);
    QCOMPARE(fixture.runner.perform("commit"), ToolReply::Ignored);
    const std::pair<double, double> expected[] = {{1.0, 0.0}, {4.5, 1.0}, {8.0, 2.0}, {100.0, 2.0}};
    for (const auto& [below, gone] : expected) {
      fixture.set("below", below);
      fixture.work();
      QCOMPARE(*fixture.figure("parts"), 3.0);
      QCOMPARE(*fixture.figure("gone"), gone);
      QCOMPARE(fixture.runner.tool()->preview().parts.empty(), gone == 0.0);
    }
    fixture.set("below", 4.5);
    fixture.work();
    const auto shown = fixture.runner.tool()->preview().parts.front().soup;
    for (const Vec3& p : shown->points) QVERIFY(std::abs((p - Vec3(24, 0, 0)).norm() - 1.5) < kVoxel);
    fixture.runner.perform("commit");
    QVERIFY(isNear(fixture.material(), ball(kRadius) + ball(3.0)));
  }

  // A slot that a ball of the radius does not get into is filled; smoothing takes off at corners.
  void gapsAndSmoothing() {
    const TriangleSoup left = moved(cube(10.0), Vec3(0, 0, 0)), right = moved(cube(10.0), Vec3(11, 0, 0));
    SparseVolume blocks = volumeOfSurface(left, kVoxel)->volume;
    const SparseVolume second = volumeOfSurface(right, kVoxel)->volume;
    blocks = *makeBoolean(blocks, second, OperationValues(booleanOperation()), {});
    Fixture fixture(blocks, Change::Gaps);
    fixture.set("radius", 2.0);
    fixture.work();
    QVERIFY(*fixture.figure("after") > 2000.0 + 80.0 && *fixture.figure("after") < 2000.0 + 105.0);
    fixture.set("change", static_cast<double>(Change::Smooth));
    fixture.work();
    const double once = *fixture.figure("after");
    QVERIFY(once < blocks.enclosed() && once > 0.97 * blocks.enclosed());
    fixture.set("passes", 4.0);
    fixture.work();
    QVERIFY(*fixture.figure("after") < once);
  }

  // Applied before it is made: it is committed once it is. Undo takes a proposal back first. Results of settings, of a
  // document or of a tool that have changed meanwhile count for nothing.
  void whatComesLate() {
    Fixture fixture(ballOfVoxels(kRadius, kVoxel), Change::Offset);
    fixture.set("distance", 1.0);
    QCOMPARE(fixture.runner.perform("commit"), ToolReply::Used);
    QCOMPARE(fixture.document->history()->index(), 0);
    QVERIFY(!fixture.runner.tool()->actions().front().enabled);
    fixture.work();
    QCOMPARE(fixture.document->history()->index(), 1);
    fixture.set("distance", 2.0);
    fixture.work();
    QCOMPARE(fixture.runner.undo(), ToolReply::Used);
    QVERIFY(!fixture.isProposed());
    QCOMPARE(fixture.document->history()->index(), 1);
    QCOMPARE(fixture.runner.undo(), ToolReply::Ignored);

    fixture.set("distance", 3.0);
    auto old = fixture.waiting.front().first.work;
    fixture.document->history()->undo();
    fixture.runner.deliver(old({}));
    QVERIFY(!fixture.isProposed());
    fixture.work();
    QVERIFY(isNear(*fixture.figure("after"), ball(kRadius + 3.0)));

    fixture.set("distance", 2.0);
    old = fixture.waiting.front().first.work;
    QCOMPARE(fixture.runner.perform("revert"), ToolReply::Finished);
    fixture.runner.stop();
    fixture.start(Change::Smooth);
    fixture.runner.deliver(old({}));
    QVERIFY(!fixture.isProposed());
    // A person cancels the job: nothing is proposed until something is asked for.
    const auto stopped = fixture.waiting.front().second;
    fixture.waiting.clear();
    fixture.runner.deliver(stopped);
    QVERIFY(fixture.runner.tool()->actions().front().enabled);
    fixture.runner.perform("commit");
    fixture.work();
    QCOMPARE(fixture.document->history()->index(), 1);
  }

  // A vertex is inserted at a point that is too far, or the mesh is made again: it stays closed and free of
  // intersections, and is within the distance that is reported. Between plates, the nearest point is often on another
  // plate, and some vertices cannot be inserted.
  void remeshedWithinTheDistance_data() {
    QTest::addColumn<bool>("isOfPlates");
    QTest::addColumn<double>("error");
    for (const double error : {0.05, 0.15}) {
      QTest::addRow("two bodies, %g", error) << false << error;
      QTest::addRow("plates, %g", error) << true << error;
    }
  }
  void remeshedWithinTheDistance() {
    QFETCH(bool, isOfPlates);
    QFETCH(double, error);
    TriangleSoup bodies;
    if (isOfPlates) {
      const auto turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
      for (int i = 0; i < 6; ++i) append(bodies, moved(cube(), Vec3(0.1, 0.2, 0.3 + 1.37 * i)));
      for (Vec3& p : bodies.points) p = turn * Vec3(12.0 * p.x(), 12.0 * p.y(), p.z());
    } else {
      for (const double x : {0.1, 22.0}) append(bodies, moved(bumpySphere(4), Vec3(x, 0.2, 0.3), 10.0));
    }
    const SparseVolume volume = volumeOfSurface(bodies, 0.5)->volume;
    const HalfEdgeMesh surface = buildMesh(surfaceOf(volume)).mesh;
    OperationValues values(remeshOperation());
    values.setValid("error", error);
    const auto made = remesh(volume, values, {});
    QVERIFY(made.hasValue());
    QVERIFY(made->mesh.liveFaceCount() < surface.liveFaceCount() / 2);
    QVERIFY(validate(made->mesh).empty());
    const TriangleSoup soup = made->mesh.compact().soup;
    QVERIFY(isClosedManifold(soup));
    QVERIFY(selfIntersections(soup.points, soup.triangles)->empty());
    QVERIFY(*made->largestDistance <= error);
    // The bound of a fresh proof is at most this much above the distance.
    const double distance = *largestDistance(made->mesh, surface) / (1.0 + kLargestDistanceSlack);
    QVERIFY2(distance <= *made->largestDistance, qPrintable(QString::number(distance / error)));
  }

  // The prediction is approximately the result: on round and on flat surfaces, for all three goals.
  void predictedTriangles() {
    for (const bool isRound : {true, false}) {
      const SparseVolume volume =
          isRound ? ballOfVoxels(kRadius, 0.25) : volumeOfSurface(moved(cube(15.0), Vec3(0.1, 0.2, 0.3)), 0.25)->volume;
      const VolumeSurface surface(volume);
      OperationValues values(remeshOperation());
      QCOMPARE(predictRemesh(surface, values).triangles, static_cast<double>(surface.triangleCount()));
      values.setValid("faces", 500.0);
      QCOMPARE(predictRemesh(surface, values).triangles, 500.0);
      values.reset("faces");
      values.setValid("error", 0.1);
      const double predicted = predictRemesh(surface, values).triangles;
      QVERIFY(predictRemesh(surface, values).seconds > 0.0);
      const auto made = remesh(volume, values, {});
      QVERIFY(made.hasValue());
      const auto faces = static_cast<double>(made->mesh.liveFaceCount());
      QVERIFY2(predicted > faces / 2.0 && predicted < 2.0 * faces,
               qPrintable(QStringLiteral("%1 of %2").arg(predicted).arg(faces)));
    }
  }
};

HANDWHEEL_TEST(ReshapeToolTest)
#include "ReshapeToolTest.moc"
