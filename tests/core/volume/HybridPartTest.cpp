// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/HybridPart.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshErrors.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeSampler.h"
#include "volume/drilling/DrillBits.h"
#include "volume/drilling/DrillRun.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A plate whose top is at z = 0, around the z axis; mm.
TriangleSoup plateOf(double edge, double thickness) {
  return box({-0.5 * edge, -0.5 * edge, -thickness}, {edge, edge, thickness});
}

TriangleSoup turnedBlock() {
  TriangleSoup block = box({-5.0, -4.0, -3.0}, {10.0, 8.0, 6.0});
  const Eigen::AngleAxisd turn(0.7123, Vec3(0.3, 0.8, 0.5).normalized());
  for (Vec3& p : block.points) p = turn * p;
  return block;
}

TriangleSoup ballOf(double radius) {
  return moved(icosphere(4), Vec3(0.1, -0.2, -radius), radius);
}

// A block whose top is missing, which is closed by a flat lid.
TriangleSoup openBlockOf(double edge) {
  TriangleSoup block = cube(edge);
  std::erase_if(block.triangles, [&](const Triangle& t) {
    return block.points[t[0]].z() == edge && block.points[t[1]].z() == edge && block.points[t[2]].z() == edge;
  });
  return block;
}

std::vector<VoxelIndex> allTiles(const HybridPart& part) {
  std::vector<VoxelIndex> tiles;
  const VoxelIndex count = (part.extent().max() / HybridPart::kTile).array().ceil().matrix().cast<int>();
  for (int z = 0; z < count.z(); ++z)
    for (int y = 0; y < count.y(); ++y)
      for (int x = 0; x < count.x(); ++x) tiles.emplace_back(x, y, z);
  return tiles;
}

bool isSameContent(const SparseVolume::Content& a, const SparseVolume::Content& b) {
  if (!a.block || !b.block) return !a.block && !b.block && a.isFull == b.isFull;
  return a.block->depths == b.block->depths;
}

// Returns the number of blocks of one volume that differ in another.
std::size_t differences(const SparseVolume& volume, const SparseVolume& other) {
  std::size_t count = 0;
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
    if (!isSameContent(content, other.content(at))) ++count;
  });
  return count;
}

struct PlacedHead {
  Vec3 position;
  double time;
};

// Returns a straight path between the positions, at 1 kHz, with so many cycles for each segment.
std::vector<PlacedHead> headPath(const std::vector<Vec3>& positions, int cycles) {
  std::vector<PlacedHead> path{{positions.front(), 0.0}};
  for (std::size_t i = 1; i < positions.size(); ++i)
    for (int k = 1; k <= cycles; ++k)
      path.push_back({positions[i - 1] + static_cast<double>(k) / cycles * (positions[i] - positions[i - 1]),
                      1e-3 * static_cast<double>(path.size())});
  return path;
}

// Drills along the same path in a whole volume and in a part, and compares them cycle by cycle. axis: to the shank.
struct DrilledTwice {
  SparseVolume whole, before;
  HybridPart part;
  double removed = 0.0, most = 0.0;  // mm³; N, the largest thrust
  double difference = 0.0;           // the largest of any figure of a cycle, as a share of 1 and its own size
  std::optional<double> breakthrough, ofPart;
  std::size_t mostBlocks = 0;

  DrilledTwice(const TriangleSoup& soup, double voxel, const DrillSetup& setup, const std::vector<PlacedHead>& path,
               const Vec3& axis = Vec3::UnitZ())
      : whole(volumeOfSurface(soup, voxel)->volume), before(whole), part(*HybridPart::of(soup, voxel)) {
    DrillRun one(whole, setup), other(part, setup);
    for (const PlacedHead& head : path) {
      const DrillTick a = one.move(head.position, axis, head.time), b = other.move(head.position, axis, head.time);
      compare(a.removed, b.removed);
      compare(a.thrust, b.thrust);
      for (Eigen::Index k = 0; k < 3; ++k) {
        compare(a.force[k], b.force[k]);
        compare(a.torque[k], b.torque[k]);
      }
    }
    compare(one.energy(), other.energy());
    removed = other.removed();
    most = other.maxThrust();
    breakthrough = one.breakthrough();
    ofPart = other.breakthrough();
  }

  void compare(double a, double b) {
    difference = std::max(difference, std::abs(a - b) / (1.0 + std::abs(a)));
    if (std::isnan(a) || std::isnan(b)) difference = std::numeric_limits<double>::infinity();
  }
  // Blocks that were cut in the whole volume and are others in the part; what was not cut is tried by seamless().
  std::size_t otherBlocks() const {
    std::size_t count = 0;
    before.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
      const SparseVolume::Content cut = whole.content(at);
      if (!isSameContent(content, cut) && !isSameContent(cut, part.left().content(at))) ++count;
    });
    return count;
  }
};

}  // namespace

class HybridPartTest : public QObject {
  Q_OBJECT

 private slots:
  // All tiles together are the volume that is made at once, block by block and sample by sample; given back, nothing
  // is left. So are tiles that were made one by one, in another order.
  void seamless_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("voxel");
    const char* const names[] = {"ball", "turned block", "plate", "torus", "open block"};
    for (int shape = 0; shape < 5; ++shape)
      for (const double voxel : {0.31, 0.1}) {
        if (voxel < 0.2 && shape != 1) continue;
        QTest::addRow("%s at %g", names[shape], voxel) << shape << voxel;
      }
  }
  void seamless() {
    QFETCH(int, shape);
    QFETCH(double, voxel);
    const TriangleSoup soup = shape == 0   ? ballOf(7.0)
                              : shape == 1 ? turnedBlock()
                              : shape == 2 ? plateOf(17.0, 2.0)
                              : shape == 3 ? moved(torus(48, 24), Vec3(1.0, 2.0, 3.0), 3.0)
                                           : openBlockOf(9.0);
    const SparseVolume whole = volumeOfSurface(soup, voxel)->volume;
    HybridPart part = *HybridPart::of(soup, voxel);
    QVERIFY(part.left().isEmpty());
    QCOMPARE(part.left().origin(), whole.origin());
    const std::vector<VoxelIndex> tiles = allTiles(part);
    part.make(tiles);
    QVERIFY(part.isExact());
    QCOMPARE(part.blockCount(), whole.blockCount());
    QCOMPARE(differences(whole, part.left()), std::size_t{0});
    QCOMPARE(differences(part.left(), whole), std::size_t{0});
    QCOMPARE(part.left().material(), whole.material());
    QCOMPARE(part.figures().blocksMade, whole.blockCount());
    part.make({});
    QVERIFY(part.left().isEmpty());
    QCOMPARE(part.blockCount(), std::size_t{0});
    for (auto tile = tiles.rbegin(); tile != tiles.rend(); ++tile) {
      part.make(std::span(&*tile, 1));
      for (int i = 0; i < 64; ++i) {
        const VoxelIndex block = 4 * *tile + VoxelIndex(i & 3, i >> 2 & 3, i >> 4);
        QVERIFY(isSameContent(part.left().content(block), whole.content(block)));
      }
    }
    QVERIFY(part.figures().blocksMade >= 2 * whole.blockCount());
  }

  // A depth is that of the whole volume wherever it is asked for, in the part, at its sides, beside it, and nowhere.
  void depths() {
    const TriangleSoup soup = turnedBlock();
    const SparseVolume whole = volumeOfSurface(soup, 0.3)->volume;
    const VolumeSampler sampler(whole);
    HybridPart part = *HybridPart::of(soup, 0.3);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 343; ++i) {
      const Vec3 position = 2.7 * Vec3(i % 7 - 3, i / 7 % 7 - 3, i / 49 - 3) + Vec3(0.013, 0.021, 0.017);
      QCOMPARE(part.depthBefore(position), sampler.depthAt(position).depth);
    }
    for (const Vec3& position : {Vec3(kNan, 0.0, 0.0), Vec3(0.0, 1e300, 0.0), Vec3(0.0, 0.0, -1e7)})
      QCOMPARE(part.depthBefore(position), sampler.depthAt(position).depth);
  }

  // Drilled as the whole volume is: thrust, torque, what is removed, breakthrough and what is left.
  void drilledAsTheWhole_data() {
    QTest::addColumn<QString>("shape");
    QTest::addColumn<QString>("tool");
    QTest::addColumn<double>("erosion");
    constexpr double kAll = std::numeric_limits<double>::infinity();
    QTest::newRow("plate, ball") << "plate"
                                 << "ball:4" << kAll;
    QTest::newRow("plate, eroded") << "plate"
                                   << "ball:4" << 2.0;
    QTest::newRow("plate, twist") << "plate"
                                  << "twist:3" << kAll;
    QTest::newRow("ball, burr") << "ball"
                                << "burr:3" << kAll;
    QTest::newRow("block, twist") << "block"
                                  << "twist:4" << kAll;
    QTest::newRow("block, saw") << "block"
                                << "saw:6:1.2" << kAll;
  }
  void drilledAsTheWhole() {
    QFETCH(QString, shape);
    QFETCH(QString, tool);
    QFETCH(double, erosion);
    const TriangleSoup soup = shape == "plate" ? plateOf(30.0, 4.0) : shape == "ball" ? ballOf(6.0) : turnedBlock();
    DrillSetup setup;
    setup.tool = *drillBitOf(tool.toStdString());
    setup.erosion = erosion;
    // Down through all of it; a saw goes across, its axis along y.
    const bool isSaw = tool.startsWith("saw");
    const std::vector<PlacedHead> path =
        isSaw ? headPath({{-12.0, 0.03, 1.0}, {12.0, 0.03, 1.0}}, 300)
              : headPath({{0.013, -0.021, 9.0}, {0.013, -0.021, -17.0}, {0.013, -0.021, 9.0}}, 400);
    const DrilledTwice drilled(soup, 0.25, setup, path, isSaw ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ()));
    QVERIFY(drilled.part.isExact());
    QVERIFY2(drilled.difference < 1e-9, QByteArray::number(drilled.difference));
    QVERIFY(drilled.removed > 1.0 && drilled.most > 0.0);
    QVERIFY(drilled.breakthrough && drilled.breakthrough == drilled.ofPart);
    QCOMPARE(drilled.otherBlocks(), std::size_t{0});
    // The hole of a head that goes through a plate: its section times the thickness.
    if (shape == "plate" && std::isinf(erosion)) {
      const double radius = setup.tool.radius(), exact = M_PI * radius * radius * 4.0;
      QVERIFY2(std::abs(drilled.removed / exact - 1.0) < 0.015, QByteArray::number(drilled.removed / exact));
    }
  }

  // A drill that leaves takes its voxels with it, but for those that it cut. It comes back to a hole that is still
  // there, and takes nothing from it; beside it, it goes on as in the whole volume.
  void leavesAndComesBack() {
    DrillSetup setup;
    setup.tool.diameter = 3.0;
    const TriangleSoup soup = plateOf(60.0, 5.0);
    const Vec3 first(-20.0, 0.01, 3.0), down(0.0, 0.0, -6.0), second(20.0, 0.01, 3.0);
    const std::vector<Vec3> positions{first,
                                      first + down,
                                      first,
                                      second,
                                      second + down,
                                      second,
                                      first,
                                      first + down,
                                      first,
                                      first + Vec3(1.0, 0.0, 0.0),
                                      first + down + Vec3(1.0, 0.0, 0.0)};
    const DrilledTwice drilled(soup, 0.2, setup, headPath(positions, 150));
    QVERIFY2(drilled.difference < 1e-9, QByteArray::number(drilled.difference));
    QCOMPARE(drilled.otherBlocks(), std::size_t{0});
    const std::size_t all = drilled.before.blockCount(), most = drilled.part.figures().mostBlocks;
    QVERIFY2(5 * most < all, qPrintable(QString("%1 of %2").arg(most).arg(all)));
    QVERIFY(drilled.part.figures().blocksMade > most);

    HybridPart part = *HybridPart::of(soup, 0.2);
    DrillRun run(part, setup);
    for (const PlacedHead& head : headPath({first, first + down, first, first + Vec3(0.0, 0.0, 100.0)}, 150))
      run.move(head.position, Vec3::UnitZ(), head.time);
    const double removed = run.removed();
    QVERIFY(removed > 0.0);
    // Only the blocks along the hole are kept, fewer than those of a box around it. They count, and so do their cut
    // states.
    QVERIFY(part.left().blockCount() > 0);
    QVERIFY(part.bytes() > part.left().bytes() + part.left().blockCount() * 3 * sizeof(int));
    QVERIFY(part.bytes() < part.figures().mostBytes);
    part.left().forEach([&](const VoxelIndex& at, const SparseVolume::Content&) {
      const Vec3 middle = part.left().centre(8 * at) + Vec3::Constant(3.5 * 0.2);
      const Vec3 away = middle - first;
      QVERIFY(std::hypot(away.x(), away.y()) < 1.5 + 0.2 * (6.1 + 4.0));
    });
    for (const PlacedHead& head : headPath({first + Vec3(0.0, 0.0, 100.0), first, first + down}, 150))
      run.move(head.position, Vec3::UnitZ(), 1.0 + head.time);
    QCOMPARE(run.removed(), removed);
  }

  // The same hole in a plate a hundred times as large takes the same memory. Both grids lie alike at the hole: the
  // sides are 80 mm apart, which are 10 tiles of 32 voxels of 0.25 mm.
  void memoryIsThatOfTheHole() {
    DrillSetup setup;
    setup.tool.diameter = 4.0;
    const std::vector<PlacedHead> path =
        headPath({{0.013, -0.021, 4.0}, {0.013, -0.021, -9.0}, {0.013, -0.021, 9.0}}, 200);
    std::vector<HybridPart::Figures> figures;
    std::vector<double> removed;
    for (const double edge : {24.0, 184.0}) {
      HybridPart part = *HybridPart::of(plateOf(edge, 4.0), 0.25);
      DrillRun run(part, setup);
      for (const PlacedHead& head : path) run.move(head.position, Vec3::UnitZ(), head.time);
      QVERIFY(part.isExact() && run.breakthrough());
      figures.push_back(part.figures());
      removed.push_back(run.removed());
    }
    QVERIFY2(std::abs(removed[0] / removed[1] - 1.0) < 1e-6, QByteArray::number(removed[0] / removed[1]));
    QCOMPARE(figures[1].blocksMade, figures[0].blocksMade);
    QCOMPARE(figures[1].mostBlocks, figures[0].mostBlocks);
    QVERIFY(figures[1].mostBytes < 1.2 * static_cast<double>(figures[0].mostBytes));
  }

  // 0.1 mm on a part of 300 mm, whose voxels would be more than 500 MB: with a drill of 3 mm not one in fifty of that.
  void fineVoxelsOnALargePart() {
    const TriangleSoup soup = box({-150.0, -150.0, -300.0}, {300.0, 300.0, 300.0});
    constexpr double kVoxel = 0.1;
    QVERIFY(predictedVolumeBytes(surfaceArea(soup), kVoxel) > 500e6);
    HybridPart part = *HybridPart::of(soup, kVoxel);
    DrillSetup setup;
    setup.tool.diameter = 3.0;
    DrillRun run(part, setup);
    for (const PlacedHead& head : headPath({{0.013, -0.021, 2.0}, {0.013, -0.021, -2.0}}, 100))
      run.move(head.position, Vec3::UnitZ(), head.time);
    // A cylinder of 2 mm with half a ball before it.
    const double exact = M_PI * 2.25 * 2.0 + 2.0 / 3.0 * M_PI * std::pow(1.5, 3);
    QVERIFY2(std::abs(run.removed() / exact - 1.0) < 0.01, QByteArray::number(run.removed() / exact));
    QVERIFY2(part.figures().mostBytes < 10'000'000, QByteArray::number(qulonglong(part.figures().mostBytes)));
  }

  // Beside the part, at an invalid position, or with a head that cannot drill, no voxel is made.
  void nothingIsMade() {
    HybridPart part = *HybridPart::of(plateOf(20.0, 4.0), 0.25);
    DrillSetup setup;
    setup.tool.diameter = 2.0;
    DrillRun run(part, setup);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const PlacedHead& head : headPath({{40.0, 0.0, 5.0}, {40.0, 0.0, -20.0}, {0.0, 60.0, -20.0}}, 100))
      QCOMPARE(run.move(head.position, Vec3::UnitZ(), head.time).thrust, 0.0);
    run.move({kNan, 0.0, 0.0}, Vec3::UnitZ(), 1.0);
    run.move(Vec3::Zero(), Vec3(kNan, 0.0, 0.0), 1.0);
    run.move(Vec3::Zero(), Vec3::UnitZ(), kNan);
    QVERIFY(!run.breakthrough());
    QCOMPARE(run.removed(), 0.0);
    QCOMPARE(part.figures().blocksMade, std::size_t{0});
    QVERIFY(std::isfinite(run.move({1e300, 0.0, 0.0}, Vec3::UnitZ(), 2.0).thrust));
    QCOMPARE(part.figures().blocksMade, std::size_t{0});
    setup.tool.diameter = 2.0 * 501.0 * 0.25;  // more than drill() takes
    DrillRun wide(part, setup);
    wide.move({0.0, 0.0, 500.0}, Vec3::UnitZ(), 0.0);
    QCOMPARE(wide.move({0.0, 0.0, 499.0}, Vec3::UnitZ(), 1.0).removed, 0.0);
    QCOMPARE(part.figures().blocksMade, std::size_t{0});
  }

  // A part that may differ from the whole volume reports it: overlapping bodies, a wide curved hole, a wall that is
  // lost between voxels. Far from these it is certain.
  void whatIsNotExact() {
    TriangleSoup overlapping = box({0.0, 0.0, 0.0}, {10.0, 10.0, 10.0});
    append(overlapping, box({5.0, 5.0, 5.0}, {10.0, 10.0, 10.0}));
    append(overlapping, box({40.0, 40.0, 40.0}, {10.0, 10.0, 10.0}));
    HybridPart part = *HybridPart::of(overlapping, 0.3);
    QVERIFY(part.isExact());
    std::vector<VoxelIndex> tiles = allTiles(part);
    part.make(std::span(&tiles.back(), 1));
    QVERIFY(part.isExact());
    part.make(tiles);
    QVERIFY(!part.isExact());

    TriangleSoup bowl = ballOf(8.0);
    std::erase_if(bowl.triangles, [&](const Triangle& t) {
      const Vec3 p = (bowl.points[t[0]] + bowl.points[t[1]] + bowl.points[t[2]]) / 3.0 + Vec3(0.0, 0.0, 8.0);
      return p.z() > 3.0 + 0.04 * (p.x() * p.x() - p.y() * p.y());
    });
    QVERIFY(!HybridPart::of(bowl, 0.3)->isExact());

    // A fin of 2 µm above a block, upright and oblique to the grid: hardly a voxel is in it.
    TriangleSoup fin = box({0.0, 0.0, 0.0}, {30.0, 0.002, 30.0});
    const Eigen::AngleAxisd turn(0.4, Vec3::UnitZ());
    const Vec3 corner(2.0, 2.0, 30.0);
    for (Vec3& p : fin.points) p = turn * p + corner;
    TriangleSoup finned = box({0.0, 0.0, 0.0}, {40.0, 40.0, 20.0});
    append(finned, fin);
    HybridPart away = *HybridPart::of(finned, 0.5), along = away;
    DrillRun beside(away, DrillSetup()), inFin(along, DrillSetup());
    for (const PlacedHead& head : headPath({{30.0, 32.0, 24.0}, {30.0, 32.0, 18.0}}, 50))
      beside.move(head.position, Vec3::UnitZ(), head.time);
    QVERIFY(beside.removed() > 0.0 && away.isExact());
    for (const PlacedHead& head : headPath({corner + Vec3(0.0, 0.0, 18.0), corner + turn * Vec3(25.0, 0.0, 18.0)}, 50))
      inFin.move(head.position, Vec3::UnitZ(), head.time);
    QVERIFY(!along.isExact());
  }

  // A hand that moves to and fro beside a small lost wall does not increase the loss: each tile counts once, however
  // often it is made.
  void judgedOnce() {
    TriangleSoup fin = box({0.0, 0.0, 0.0}, {8.0, 0.002, 8.0});
    const Eigen::AngleAxisd turn(0.4, Vec3::UnitZ());
    for (Vec3& p : fin.points) p = turn * p + Vec3(4.0, 4.0, 24.0);
    TriangleSoup finned = box({0.0, 0.0, 0.0}, {40.0, 40.0, 20.0});
    append(finned, fin);
    HybridPart part = *HybridPart::of(finned, 0.5);
    const std::vector<VoxelIndex> all = allTiles(part);
    part.make(all);
    QVERIFY(part.isExact());  // a part in a hundred of the surface
    for (int i = 0; i < 200; ++i) {
      part.hold(Box(Vec3(4.0, 4.0, 26.0), Vec3(10.0, 8.0, 30.0)));
      part.make({});
      part.hold(Box(Vec3(30.0, 30.0, 2.0), Vec3(32.0, 32.0, 4.0)));
      part.make({});
    }
    QVERIFY(part.isExact());
  }

  void refused() {
    QVERIFY(HybridPart::of({}, 0.3).error().code == MeshError::NoTriangles);
    QVERIFY(HybridPart::of(turnedOver(cube(5.0)), 0.3).error().code == VolumeErrors::NothingInside);
    for (const double voxel : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
      QVERIFY(HybridPart::of(cube(5.0), voxel).error().code == ErrorCode::ValueOutOfRange);
    QVERIFY(HybridPart::of(cube(5.0), 1e-9).error().code == VolumeErrors::TooFine);
    TriangleSoup nowhere = cube(5.0);
    nowhere.points[3].x() = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(HybridPart::of(nowhere, 0.3).error().code == ErrorCode::NumberNotFinite);
    // Cancelled, whatever the surface encloses.
    JobState state;
    state.cancelled = true;
    for (const TriangleSoup& soup : {cube(5.0), turnedOver(cube(5.0))})
      QVERIFY(HybridPart::of(soup, 0.3, Progress(state)).error().code == ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(HybridPartTest)
#include "HybridPartTest.moc"
