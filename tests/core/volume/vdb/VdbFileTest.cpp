// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/vdb/VdbFile.h"

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>

#include "TestClass.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"

#include <QtTest>
#include <cmath>
#include <sstream>

using namespace handwheel;

namespace {

constexpr double kRadius = 6.0, kVoxel = 0.3;
const openvdb::Vec3f kCentre(3.1f, -50.2f, 7.7f);

openvdb::FloatGrid::Ptr sphere() {
  return openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(static_cast<float>(kRadius), kCentre,
                                                                  static_cast<float>(kVoxel));
}

std::string fileOf(const openvdb::GridPtrVec& grids) {
  std::ostringstream stream;
  openvdb::io::Stream(stream).write(grids);
  return stream.str();
}

Vec3 outwards(int i) {
  return Vec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i + 1.0)).normalized();
}

}  // namespace

// OpenVDB itself writes what is read, and reads what is written.
class VdbFileTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { openvdb::initialize(); }

  void aLevelSet() {
    openvdb::GridPtrVec grids{openvdb::Int32Grid::create(3), sphere()};
    const Result<VdbVolume> read = readVdb(fileOf(grids), {});
    QVERIFY(read.hasValue());
    QVERIFY(!read->isFog);
    QCOMPARE(read->otherGrids, std::size_t{1});
    const double expected = 4.0 / 3.0 * M_PI * std::pow(kRadius, 3);
    QVERIFY(std::abs(read->volume.material() / expected - 1.0) < 0.01);
    const VolumeSampler sampler(read->volume);
    const Vec3 centre(kCentre.x(), kCentre.y(), kCentre.z());
    for (int i = 0; i < 200; ++i) {
      const double radius = kRadius + 2.0 * kVoxel * std::sin(5.0 * i);
      QVERIFY(std::abs(sampler.depthAt(centre + radius * outwards(i)).depth - (kRadius - radius)) <
              0.02 * kVoxel + 0.01);
    }
  }

  void aFog() {
    const openvdb::FloatGrid::Ptr fog = sphere();
    openvdb::tools::sdfToFogVolume(*fog);  // from 0 at the surface to 1 three voxels inside
    const Result<VdbVolume> read = readVdb(fileOf({fog}), {});
    QVERIFY(read.hasValue());
    QVERIFY(read->isFog);
    const double expected = 4.0 / 3.0 * M_PI * std::pow(kRadius - 1.5 * kVoxel, 3);
    QVERIFY(std::abs(read->volume.material() / expected - 1.0) < 0.02);
  }

  void written() {
    const SparseVolume ball = ballOfVoxels(kRadius, kVoxel);
    const Result<std::string> file = vdbOf(ball, {});
    QVERIFY(file.hasValue());
    std::istringstream stream(*file);
    const auto grids = openvdb::io::Stream(stream, false).getGrids();
    QCOMPARE(grids->size(), std::size_t{1});
    const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(grids->front());
    QVERIFY(grid && grid->getGridClass() == openvdb::GRID_LEVEL_SET);
    QCOMPARE(grid->voxelSize().x(), kVoxel);
    for (int i = 0; i < 200; ++i) {
      const VoxelIndex at =
          ((kRadius + 4.0 * kVoxel * std::sin(5.0 * i)) / kVoxel * outwards(i)).array().round().cast<int>();
      const double expected = std::clamp(ball.centre(at).norm() - kRadius, -3.0 * kVoxel, 3.0 * kVoxel);
      const float value = grid->tree().getValue(openvdb::Coord(at.x(), at.y(), at.z()));
      QVERIFY(std::abs(static_cast<double>(value) - expected) < 0.01);
    }
    QVERIFY(grid->tree().getValue(openvdb::Coord(0, 0, 0)) < 0.0f);
    const Result<VdbVolume> back = readVdb(*file, {});
    QVERIFY(back.hasValue());
    QCOMPARE(back->volume.material(), ball.material());
  }

  void refusals() {
    const auto reason = [](const openvdb::GridPtrVec& grids) {
      const Result<VdbVolume> read = readVdb(fileOf(grids), {});
      return read ? std::string() : read.error().arguments.back();
    };
    QCOMPARE(reason({openvdb::Int32Grid::create(3)}), std::string("it has no grid of floats"));
    const openvdb::FloatGrid::Ptr long_ = sphere();
    long_->transform().preScale(openvdb::Vec3d(1.0, 1.0, 2.0));
    QCOMPARE(reason({long_}), std::string("its voxels are not cubes along the axes"));
    QCOMPARE(reason({openvdb::FloatGrid::create(1.0f)}), std::string("it bounds no material"));
    const openvdb::FloatGrid::Ptr huge = sphere();
    huge->tree().addTile(3, openvdb::Coord(8192, 0, 0), -1.0f, true);
    huge->tree().addTile(3, openvdb::Coord(16384, 0, 0), -1.0f, true);
    QCOMPARE(reason({huge}), std::string("it is too large"));
    QVERIFY(!readVdb("", {}));
    QVERIFY(!readVdb(" BDV", {}));
  }

  // Any file results in a volume or an error, whatever it does to the library.
  void damaged() {
    const std::string good = fileOf({sphere()});
    for (std::size_t i = 0; i < 16; ++i) {
      std::string bad = good;
      for (std::size_t k = 0; k < 4; ++k)
        bad[(i * 7919 + k * 104729) % (i % 2 == 0 ? 600 : bad.size())] = static_cast<char>(i * 37 + k * 11);
      if (i % 5 == 0) bad.resize(bad.size() * i / 16);
      const Result<VdbVolume> read = readVdb(bad, {});
      if (!read) QVERIFY(read.error().code == ErrorCode::LibraryFailed || read.error().code == ErrorCode::OutOfMemory);
    }
  }
};

HANDWHEEL_TEST(VdbFileTest)
#include "VdbFileTest.moc"
