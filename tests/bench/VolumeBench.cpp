// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Volumes: a part of 75 x 90 x 63 mm at 0.1 mm is made ready, shaped and felt; holes against their analytic volume and
// work. Where OpenVDB is installed it makes the same level set in the same run.
// Before Qt, whose macros have names of it.
#ifdef HANDWHEEL_HAS_OPENVDB
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#endif

#include "bench/Bars.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/VolumeEdit.h"
#include "document/volume/VolumeKind.h"
#include "simulation/clay/ClayForce.h"
#include "support/MeshShapes.h"
#include "volume/HybridPart.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeShapes.h"
#include "volume/drilling/DrillRun.h"
#include "volume/drilling/DrilledTriangles.h"

using namespace handwheel;

namespace {

bench::Bars bars;

constexpr double kVoxel = 0.1;  // mm

// 20,480 triangles, bumpy, 75 x 90 x 63 mm.
TriangleSoup part() {
  TriangleSoup soup = test::icosphere(5);
  Box box;
  for (Vec3& p : soup.points) {
    p *= 1.0 + 0.05 * std::sin(9.0 * p.x()) * std::sin(8.0 * p.y()) * std::sin(7.0 * p.z());
    box.extend(p);
  }
  for (Vec3& p : soup.points) p = p.cwiseQuotient(box.sizes()).cwiseProduct(Vec3(75.0, 90.0, 63.0));
  return soup;
}

// A ring with a hexagonal outside, 216 x 216 x 93 voxels of 0.1 mm.
TriangleSoup nut() {
  constexpr int kSides = 96;
  TriangleSoup soup;
  const auto ringPoint = [](int i, double z, bool isOuter) {
    const double angle = 2.0 * M_PI * i / kSides, in = std::remainder(angle, M_PI / 3.0);
    const double radius = isOuter ? 9.35 / std::cos(in) : 5.0;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  for (int i = 0; i < kSides; ++i)
    for (const double z : {0.0, 9.3})
      for (const bool isOuter : {false, true}) soup.points.push_back(ringPoint(i, z, isOuter));
  const auto at = [](int i, bool isTop, bool isOuter) {
    return static_cast<std::uint32_t>(4 * (i % kSides) + 2 * isTop + isOuter);
  };
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < kSides; ++i) {
    quad(at(i, false, true), at(i + 1, false, true), at(i + 1, true, true), at(i, true, true));
    quad(at(i, true, false), at(i + 1, true, false), at(i + 1, false, false), at(i, false, false));
    quad(at(i, true, true), at(i + 1, true, true), at(i + 1, true, false), at(i, true, false));
    quad(at(i, false, false), at(i + 1, false, false), at(i + 1, false, true), at(i, false, true));
  }
  return soup;
}

const SparseVolume& ready() {
  static const SparseVolume volume = volumeOfSurface(part(), kVoxel)->volume;
  return volume;
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

#ifdef HANDWHEEL_HAS_OPENVDB
double openVdbSeconds(const TriangleSoup& soup, double voxel) {
  openvdb::initialize();
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  for (const Vec3& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
  for (const Triangle& t : soup.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  return bench::secondsOf(
      [&] { openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points, triangles, 3.0f); });
}
#endif

void makeReady(benchmark::State& state) {
  const TriangleSoup soup = part();
  bench::Fastest volumes, surfaces;
  std::size_t bytes = 0, display = 0;
  for (auto _ : state) {
    std::optional<SparseVolume> volume;
    volumes.add(bench::secondsOf([&] { volume = volumeOfSurface(soup, kVoxel)->volume; }));
    std::optional<VolumeSurface> surface;
    surfaces.add(bench::secondsOf([&] { surface.emplace(*volume); }));
    bytes = volume->bytes();
    display = surface->bytes();
  }
  bars.atMost("75 x 90 x 63 mm, 20,480 triangles, 0.1 mm: ready, s", 3.0, volumes.seconds + surfaces.seconds);
  bars.tell("of it the display, s", surfaces.seconds);
  const double predicted = predictedMakingSeconds(surfaceArea(soup), kVoxel),
               taken = volumes.seconds + surfaces.seconds;
  bars.atMost("the time that was predicted, times off", 10.0, std::max(predicted / taken, taken / predicted));
  bars.atMost("its voxels, MB", 150.0, static_cast<double>(bytes) / 1e6);
  bars.tell("its display, MB", static_cast<double>(display) / 1e6);
#ifdef HANDWHEEL_HAS_OPENVDB
  bars.tell("its voxels against OpenVDB's level set, ratio of seconds", volumes.seconds / openVdbSeconds(soup, kVoxel));
#endif
}
BENCHMARK(makeReady)->Iterations(2)->Unit(benchmark::kMillisecond);

void makeFine(benchmark::State& state) {
  std::optional<Result<SurfaceVolume>> made;
  double seconds = 0.0;
  for (auto _ : state) seconds = bench::secondsOf([&] { made = volumeOfSurface(part(), 0.05); });
  if (!*made) return bars.failed(state, "the same at 0.05 mm", "it was refused");
  bars.tell("the same at 0.05 mm: voxels, s", seconds);
  bars.tell("the same at 0.05 mm: voxels, MB", static_cast<double>((*made)->volume.bytes()) / 1e6);
}
BENCHMARK(makeFine)->Iterations(1)->Unit(benchmark::kMillisecond);

void makeNut(benchmark::State& state) {
  const TriangleSoup soup = nut();
  bench::Fastest fastest;
  for (auto _ : state)
    fastest.add(bench::secondsOf([&] { benchmark::DoNotOptimize(volumeOfSurface(soup, kVoxel).hasValue()); }));
  bars.atMost("nut of 216 x 216 x 93 voxels, s", 0.3, fastest.seconds);
}
BENCHMARK(makeNut)->Iterations(5)->Unit(benchmark::kMillisecond);

// Memory of an undo step that the document does not share: blocks, and pieces of the display; bytes.
struct Unshared {
  std::size_t blocks = 0, pieces = 0;

  Unshared(const VolumeSnapshot& held, const VolumeSnapshot& shown) {
    held.volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
      if (content.block && content.block != shown.volume.content(at).block) blocks += sizeof(VolumeBlock);
    });
    for (const auto& [key, piece] : held.surface.pieces()) {
      const auto other = shown.surface.pieces().find(key);
      if (other != shown.surface.pieces().end() && other->second == piece) continue;
      pieces += piece->bytes();
    }
  }
};

// Dabs along a meridian of the part, each with the pieces that it changes, and undone in the document.
void dabs(benchmark::State& state, ClayAction action, double radius, const char* what, double bar) {
  SparseVolume volume = ready();
  VolumeSurface surface(volume);
  const auto snapshotOfBoth = [&] {
    auto snapshot = std::make_shared<VolumeSnapshot>();
    snapshot->volume = volume;
    snapshot->surface = surface;
    return snapshot;
  };
  VolumeKind kind;
  std::shared_ptr<VolumeSnapshot> before = snapshotOfBoth();
  VolumeDocument document(OpenedFile{&kind, {}, before});
  std::vector<double> seconds, undo, blocks, pieces, predicted;
  int i = 0;
  for (auto _ : state) {
    const double angle = 0.02 * ++i;
    ClayDab dab{action, Vec3(37.0 * std::cos(angle), 44.0 * std::sin(angle), 5.0), radius, 0.5, 1.0};
    dab.displacement = Vec3(0.1 * radius, 0.0, 0.0);
    std::vector<VoxelIndex> changed;
    seconds.push_back(bench::secondsOf([&] {
      changed = applyDab(volume, dab);
      surface.update(volume, changed);
    }));
    const std::shared_ptr<VolumeSnapshot> after = snapshotOfBoth();
    VolumeEdit edit(after, changed.size());
    edit.exchange(document);
    undo.push_back(bench::secondsOf([&] { edit.exchange(document); }));
    edit.exchange(document);
    const Unshared held(*before, *after);
    blocks.push_back(static_cast<double>(held.blocks));
    pieces.push_back(static_cast<double>(held.pieces));
    predicted.push_back(static_cast<double>(edit.bytes()));
    before = after;
  }
  bars.atMost(std::string(what) + ": dab to changed pieces, p99, ms", bar, 1e3 * percentile(seconds, 0.99));
  bars.tell(std::string(what) + ": the same, median, ms", 1e3 * percentile(seconds, 0.5));
  bars.tell(std::string(what) + ": undone in the document, p99, ms", 1e3 * percentile(undo, 0.99));
  bars.tell(std::string(what) + ": blocks that an undo step does not share, median, MB",
            1e-6 * percentile(blocks, 0.5));
  bars.tell(std::string(what) + ": and pieces of the display, median, MB", 1e-6 * percentile(pieces, 0.5));
  bars.tell(std::string(what) + ": both as the history counts them, median, MB", 1e-6 * percentile(predicted, 0.5));
}
void carve(benchmark::State& state) {
  dabs(state, ClayAction::Carve, 5.0, "carve, 100 voxels across", 33.0);
}
void smooth(benchmark::State& state) {
  dabs(state, ClayAction::Smooth, 4.0, "smooth, 80 voxels across", 33.0);
}
void move(benchmark::State& state) {
  dabs(state, ClayAction::Move, 4.0, "move, 80 voxels across", 33.0);
}
void inflate(benchmark::State& state) {
  dabs(state, ClayAction::Inflate, 4.0, "inflate, 80 voxels across", 33.0);
}
void smudge(benchmark::State& state) {
  dabs(state, ClayAction::Smudge, 4.0, "smudge, 80 voxels across", 33.0);
}
BENCHMARK(carve)->Iterations(200)->Unit(benchmark::kMillisecond);
BENCHMARK(smooth)->Iterations(100)->Unit(benchmark::kMillisecond);
BENCHMARK(move)->Iterations(100)->Unit(benchmark::kMillisecond);
BENCHMARK(inflate)->Iterations(100)->Unit(benchmark::kMillisecond);
BENCHMARK(smudge)->Iterations(100)->Unit(benchmark::kMillisecond);

// Moves a drill of 16 voxels in a ball of 256: a step of the path and the surface.
void stamp(benchmark::State& state) {
  SparseVolume volume = ballOfVoxels(12.8, kVoxel);
  VolumeSurface surface(volume);
  DrillBit tool;
  tool.diameter = 1.6;
  std::vector<double> seconds;
  double z = 13.4;
  for (auto _ : state) {
    DrillMove move{{0.3, 0.2, z}, {0.3, 0.2, z - 0.05}};
    z -= 0.05;
    seconds.push_back(bench::secondsOf([&] { surface.update(volume, drill(volume, tool, move).changedBlocks); }));
  }
  bars.atMost("stamp of a drill and its surface at 256 voxels, median, ms", 4.0, 1e3 * percentile(seconds, 0.5));
}
BENCHMARK(stamp)->Iterations(200)->Unit(benchmark::kMillisecond);

// Ticks of a hand that wanders over the part and into it.
void tick(benchmark::State& state) {
  const auto channel = std::make_shared<ClayChannel>();
  auto begin = std::make_shared<ClayState>();
  begin->volume = ready();
  channel->patch.write({begin});
  ClayForce force(channel, {});
  std::vector<double> seconds;
  int i = 0, contacts = 0;
  for (auto _ : state) {
    const double angle = 1e-3 * ++i;
    TipState tip;
    tip.position = Vec3(36.5 * std::cos(angle), 44.0 * std::sin(angle), 2.0 * std::sin(7.0 * angle));
    if (i < 20) tip.position *= 1.2;
    tip.isRestart = i == 1;
    seconds.push_back(bench::secondsOf([&] {
      ForceOut out;
      force.advance(tip, out);
      benchmark::DoNotOptimize(force.force(tip, 1.0, 1.0));
      contacts += out.isContact;
    }));
  }
  if (contacts < i / 10) return bars.failed(state, "servo tick on clay", "the hand touched too little");
  bars.atMost("servo tick on clay at 0.1 mm, p99, us", 20.0, 1e6 * percentile(seconds, 0.99));
  bars.tell("servo tick on clay, share of ticks in contact", static_cast<double>(contacts) / i);
}
BENCHMARK(tick)->Iterations(20000)->Unit(benchmark::kMicrosecond);

// Through a plate of 8 mm by a ball of 4 mm: voxels to the diameter, error of volume and of work.
void holes(benchmark::State& state) {
  const double exact = M_PI * 4.0 * 8.0;
  for (auto _ : state)
    for (const double across : {8.0, 12.0, 16.0, 24.0, 32.0}) {
      SparseVolume volume =
          volumeOfSurface(test::moved(test::cube(10.0), Vec3(-5.0, -5.0, -10.0)), 4.0 / across)->volume;
      DrillSetup setup;
      setup.tool.diameter = 4.0;
      DrillRun run(volume, setup);
      for (int i = 0; i <= 800; ++i) run.move({0.013, -0.021, 2.5 - 0.02 * i}, Vec3::UnitZ(), 0.001 * i);
      const double hole = exact * 10.0 / 8.0;
      const double error = std::abs(run.removed() / hole - 1.0);
      const double work = std::abs(run.energy() / (1e-3 * setup.material.energy * hole) - 1.0);
      const std::string what = "hole at " + std::to_string(static_cast<int>(across)) + " voxels across: error of ";
      const double bar = across >= 16.0 ? 0.01 : std::numeric_limits<double>::infinity();
      bars.atMost(what + "volume", bar, error);
      bars.atMost(what + "work", bar, work);
      if (across != 16.0) continue;
      // The front leaves the plate, 10 mm deep, when the centre is 8 mm down.
      const double late = run.breakthrough() ? 1e3 * (*run.breakthrough() - 10.5 / 20.0) : std::nan("");
      bars.atMost("breakthrough flagged after, ms", 20.0, late);
    }
}
BENCHMARK(holes)->Iterations(1)->Unit(benchmark::kMillisecond);

double volumeOf(const HalfEdgeMesh& mesh) {
  double six = 0.0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    const TrianglePoints p = mesh.points(f);
    six += p[0].dot(p[1].cross(p[2]));
  }
  return six / 6.0;
}

// A block of 300 mm at 0.1 mm, with voxels near a ball of 3 mm only: what they take, and the cycles that make them.
void holeInALargePart(benchmark::State& state) {
  const TriangleSoup block = test::box({-150.0, -150.0, -300.0}, {300.0, 300.0, 300.0});
  for (auto _ : state) {
    Result<HybridPart> part = HybridPart::of(block, 0.1);
    if (!part) return bars.failed(state, "voxels near the drill", "they were refused");
    DrillSetup setup;
    setup.tool.diameter = 3.0;
    DrillRun run(*part, setup);
    DrillRecord record;
    record.setup = setup;
    std::vector<double> seconds;
    for (int i = 0; i <= 2000; ++i) {
      record.poses.push_back(DrillPose::of({0.013, -0.021, 2.0 - 0.01 * i}, Vec3::UnitZ(), 0.001 * i));
      seconds.push_back(bench::secondsOf([&] { move(run, record.poses[record.poses.size() - 1]); }));
    }
    bars.atMost("0.1 mm on 300 mm, voxels near the drill, MB", 10.0,
                static_cast<double>(part->figures().mostBytes) / 1e6);
    bars.tell("the same, voxels of the whole part as predicted, MB",
              predictedVolumeBytes(surfaceArea(block), 0.1) / 1e6);
    bars.tell("the same, cycle, p99, ms", 1e3 * percentile(seconds, 0.99));
    bars.tell("the same, longest cycle, ms", 1e3 * percentile(seconds, 1.0));
    DrilledTriangles joined;
    const double join = bench::secondsOf([&] { joined = drilledTriangles(block, *part, record, NumberType::Float64); });
    if (joined.problem != SubtractionProblem::None) return bars.failed(state, "hole in triangles", "it was refused");
    // 18 mm below the top is the centre of the ball at the end.
    const double exact = M_PI * 2.25 * 18.0 + 2.0 / 3.0 * M_PI * 3.375;
    const double missing = std::pow(300.0, 3.0) - volumeOf(joined.mesh);
    bars.atMost("the same, hole in the triangles: error of volume", 0.01, std::abs(missing / exact - 1.0));
    bars.tell("the same, hole in the triangles, ms", 1e3 * join);
  }
}
BENCHMARK(holeInALargePart)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return bars.print();
}
