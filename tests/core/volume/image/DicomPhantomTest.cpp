// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageBytes.h"
#include "LPhantom.h"
#include "MadeFrames.h"
#include "TestClass.h"
#include "volume/image/DicomReader.h"
#include "volume/image/ImageToVolume.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kApart = 2.4;  // mm

// Slices of the phantom with these axes, which cover it. tilt: shift of a slice along its columns, per mm of height.
std::vector<MadeSlice> slicesOfPhantom(const Eigen::Matrix3d& axes, double tilt = 0.0) {
  MadeSlice slice;
  slice.across = axes.col(0);
  slice.down = axes.col(1);
  slice.spacing = 1.5;
  slice.downSpacing = 2.0;
  slice.value = lPhantom;
  slice.width = 40;
  slice.height = 36;
  constexpr int kCount = 25;
  const Vec3 middle(8.0, 4.0, 2.0);
  std::vector<MadeSlice> slices;
  for (int i = 0; i < kCount; ++i) {
    const double height = kApart * (i - kCount / 2);
    slice.origin = middle + height * (axes.col(2) + tilt * axes.col(1)) - 29.0 * slice.across - 35.0 * slice.down;
    slices.push_back(slice);
  }
  return slices;
}

// Returns the slices in another order: every eleventh one.
std::vector<MadeSlice> shuffled(const std::vector<MadeSlice>& slices) {
  std::vector<MadeSlice> other;
  for (std::size_t i = 0; i < slices.size(); ++i) other.push_back(slices[11 * i % slices.size()]);
  return other;
}

std::vector<MadeSlice> reversed(std::vector<MadeSlice> slices) {
  std::reverse(slices.begin(), slices.end());
  return slices;
}

Result<ImageFile> readOne(const std::string& file) {
  std::string files;
  appendDicomFile(file, files);
  return readDicom(files, DicomChoice::OfFirst, {});
}

Result<ImageFile> readEach(const std::vector<MadeSlice>& slices) {
  std::string files;
  for (const MadeSlice& slice : slices) appendDicomFile(dicomOf(slice), files);
  return readDicom(files, DicomChoice::OfFirst, {});
}

// Returns what is wrong with an image of these slices: each pixel must be a sample at its position.
QByteArray problemOf(const Result<ImageFile>& read, const std::vector<MadeSlice>& slices, int count) {
  if (!read) return read.error().arguments.empty() ? "an error" : read.error().arguments.back().c_str();
  const ImageGrid& grid = read->image.grid();
  if (grid.size[2] != count) return "slices: " + QByteArray::number(grid.size[2]);
  if (!(grid.steps.determinant() > 0.0)) return "a wrong hand";
  const Eigen::Matrix3d inverse = grid.steps.inverse();
  for (const MadeSlice& slice : slices)
    for (int y = 0; y < slice.height; ++y)
      for (int x = 0; x < slice.width; ++x) {
        const Vec3 at = inverse * (slice.position(x, y) - grid.origin), whole = at.array().round();
        if ((at - whole).norm() > 1e-3) return "a position that is not a sample";
        for (Eigen::Index k = 0; k < 3; ++k)
          if (whole[k] < 0.0 || whole[k] >= grid.size[static_cast<std::size_t>(k)]) return "a position outside";
        const std::size_t index = static_cast<std::size_t>(whole.x()) +
                                  static_cast<std::size_t>(grid.size[0]) *
                                      (static_cast<std::size_t>(whole.y()) +
                                       static_cast<std::size_t>(grid.size[1]) * static_cast<std::size_t>(whole.z()));
        // Numbers are stored as integers.
        if (std::abs(read->image.value(index) - slice.value(slice.position(x, y))) > slice.slope) return "a value";
      }
  return {};
}

// The volume of the phantom, and the points within it, are those of its definition.
QByteArray problemOfVolume(const ImageVolume& image) {
  const Result<SparseVolume> volume = volumeOfImage(image, {500.0, 1e9}, 1.0);
  if (!volume) return "no volume";
  // Samples cut off sharp edges.
  if (std::abs(volume->enclosed() / kLPhantomVolume - 1.0) > 0.08)
    return "volume: " + QByteArray::number(volume->enclosed());
  const auto isIn = [&](const Vec3& p) {
    const VoxelIndex at = ((p - volume->origin()) / volume->voxel()).array().round().cast<int>();
    return volume->sample(at) > 0;
  };
  for (const Vec3& p : {Vec3(27, 4, 4), Vec3(4, 19, 4), Vec3(4, 4, 11), kLPhantomBall})
    if (!isIn(p)) return "a bar is missing";
  for (const Vec3& p : {Vec3(33, 4, 4), Vec3(4, 25, 4), Vec3(4, 4, 17), Vec3(-4, 4, 4), Vec3(4, -4, 4), Vec3(4, 4, -4)})
    if (isIn(p)) return "a bar is too long";
  return {};
}

}  // namespace

// A phantom without any symmetry, in each orientation that the axes of an image can have: each sample comes out at its
// position, with its value.
class DicomPhantomTest : public QObject {
  Q_OBJECT

 private slots:
  void orientations_data() {
    QTest::addColumn<int>("number");
    for (int i = 0; i < 24; ++i) QTest::addRow("%d", i) << i;
  }
  void orientations() {
    QFETCH(int, number);
    const Eigen::Matrix3d axes = turnsOfCube()[static_cast<std::size_t>(number)];
    const std::vector<MadeSlice> slices = slicesOfPhantom(axes);
    const auto count = static_cast<int>(slices.size());
    const Result<ImageFile> series = readEach(shuffled(slices));
    QCOMPARE(problemOf(series, slices, count), QByteArray());
    QCOMPARE(problemOfVolume(series->image), QByteArray());
    QVERIFY(series->remarks.empty());
    for (const auto& frames : {slices, reversed(slices), shuffled(slices)})
      for (const bool isShared : {true, false}) {
        const Result<ImageFile> one = readOne(dicomOf(MadeFrames{.frames = frames, .isOrientationShared = isShared}));
        QCOMPARE(problemOf(one, slices, count), QByteArray());
        QVERIFY(one->remarks.empty());
      }
    const Result<ImageFile> backwards = readOne(dicomOf(MadeFrames{.frames = reversed(slices)}));
    QCOMPARE(problemOfVolume(backwards->image), QByteArray());
  }

  // A leaning scanner: positions are sheared, by tan(15°) here.
  void tilted_data() { orientations_data(); }
  void tilted() {
    QFETCH(int, number);
    const double tilt = std::tan(15.0 * M_PI / 180.0);
    const std::vector<MadeSlice> slices = slicesOfPhantom(turnsOfCube()[static_cast<std::size_t>(number)], tilt);
    for (const Result<ImageFile>& image :
         {readEach(shuffled(slices)), readOne(dicomOf(MadeFrames{.frames = shuffled(slices)}))}) {
      QCOMPARE(problemOf(image, slices, static_cast<int>(slices.size())), QByteArray());
      QCOMPARE(problemOfVolume(image->image), QByteArray());
      QVERIFY(hasRemark(*image, ImageRemark::Kind::Tilted));
      QVERIFY(std::abs(image->remarks.front().figures.front() - 15.0) < 0.01);
    }
  }

  void gaps_data() { orientations_data(); }
  void gaps() {
    QFETCH(int, number);
    const std::vector<MadeSlice> all = slicesOfPhantom(turnsOfCube()[static_cast<std::size_t>(number)]);
    std::vector<MadeSlice> kept = all;
    for (const int i : {20, 9, 8, 3}) kept.erase(kept.begin() + i);
    for (const Result<ImageFile>& image :
         {readEach(shuffled(kept)), readOne(dicomOf(MadeFrames{.frames = reversed(kept)}))}) {
      QCOMPARE(problemOf(image, kept, static_cast<int>(all.size())), QByteArray());
      QVERIFY(hasRemark(*image, ImageRemark::Kind::SlicesMissing));
      QCOMPARE(image->remarks.front().figures.front(), 4.0);
    }
  }

  // Each frame has its own slope and intercept.
  void scales() {
    std::vector<MadeSlice> slices = slicesOfPhantom(Eigen::Matrix3d::Identity());
    for (std::size_t i = 0; i < slices.size(); ++i) {
      slices[i].slope = i % 2 == 0 ? 2.0 : 0.5;
      slices[i].intercept = i % 3 == 0 ? -1000.0 : -500.0;
    }
    const Result<ImageFile> image = readOne(dicomOf(MadeFrames{.frames = reversed(slices), .isScaleShared = false}));
    QCOMPARE(problemOf(image, slices, static_cast<int>(slices.size())), QByteArray());
  }

  // Frames of several files are one image, and so are frames of files without functional groups.
  void severalFiles() {
    const std::vector<MadeSlice> slices = slicesOfPhantom(Eigen::Matrix3d::Identity());
    const std::vector<MadeSlice> low(slices.begin(), slices.begin() + 11), high(slices.begin() + 11, slices.end());
    std::string files;
    appendDicomFile(dicomOf(MadeFrames{.frames = high}), files);
    appendDicomFile(dicomOf(MadeFrames{.frames = reversed(low)}), files);
    const Result<ImageFile> image = readDicom(files, DicomChoice::OfFirst, {});
    QCOMPARE(problemOf(image, slices, static_cast<int>(slices.size())), QByteArray());
  }

  // Several frames at a position, such as moments or echoes: the first of each is read.
  void severalMoments() {
    const std::vector<MadeSlice> slices = slicesOfPhantom(Eigen::Matrix3d::Identity());
    std::vector<MadeSlice> frames = slices;
    for (MadeSlice slice : slices) {
      slice.value = [](const Vec3&) { return 7.0; };
      frames.push_back(slice);
    }
    const Result<ImageFile> image = readOne(dicomOf(MadeFrames{.frames = frames}));
    QCOMPARE(problemOf(image, slices, static_cast<int>(slices.size())), QByteArray());
    QVERIFY(hasRemark(*image, ImageRemark::Kind::SamePosition));
  }

  // Frames without positions get the stated distance, which is said. The position of the first frame is used.
  void withoutPositions_data() { orientations_data(); }
  void withoutPositions() {
    QFETCH(int, number);
    const std::vector<MadeSlice> slices = slicesOfPhantom(turnsOfCube()[static_cast<std::size_t>(number)]);
    const auto count = static_cast<int>(slices.size());
    MadeFrames made{.frames = slices, .hasGroups = false, .thickness = kApart};
    for (const double between : {kApart, -kApart, 0.0}) {
      made.between = between == 0.0 ? std::optional<double>() : between;
      made.thickness = between == 0.0 ? kApart : 1.0;
      // A distance below 0 is that of frames against the normal.
      made.frames = between < 0.0 ? reversed(slices) : slices;
      const Result<ImageFile> image = readOne(dicomOf(made));
      QCOMPARE(problemOf(image, slices, count), QByteArray());
      QVERIFY(hasRemark(*image, ImageRemark::Kind::SpacingAssumed));
      QCOMPARE(image->remarks.front().figures.front(), kApart);
    }
  }

  // A secondary capture may state nothing about positions but a distance, or nothing at all.
  void captures() {
    const std::vector<MadeSlice> slices = slicesOfPhantom(Eigen::Matrix3d::Identity());
    MadeFrames made{.frames = slices, .hasGroups = false, .hasPositions = false, .hasOrientation = false};
    const Result<ImageFile> refused = readOne(dicomOf(made));
    QVERIFY(!refused);
    QCOMPARE(refused.error().arguments.back(), std::string("its slices have neither positions nor a stated distance"));
    made.between = kApart;
    const Result<ImageFile> image = readOne(dicomOf(made));
    QVERIFY(image && hasRemark(*image, ImageRemark::Kind::SpacingAssumed));
    QVERIFY((image->image.grid().spacing() - Vec3(1.5, 2.0, kApart)).norm() < 1e-9);
    QCOMPARE(image->image.grid().size[2], static_cast<int>(slices.size()));
    made.hasSpacing = false;
    const Result<ImageFile> without = readOne(dicomOf(made));
    QVERIFY(without && hasRemark(*without, ImageRemark::Kind::NoSpacing));
  }

  // A dose has the distances of its frames from the first (GridFrameOffsetVector), and a scale of its own.
  void dose() {
    std::vector<MadeSlice> slices = slicesOfPhantom(Eigen::Matrix3d::Identity());
    MadeFrames made{.frames = reversed(slices), .hasGroups = false};
    std::string offsets;
    for (std::size_t i = 0; i < slices.size(); ++i)
      offsets += (i > 0 ? "\\" : "") + std::to_string(-kApart * static_cast<double>(i));
    made.more.emplace_back(gdcm::Tag(0x3004, 0x000c), offsets);
    const Result<ImageFile> image = readOne(dicomOf(made));
    QCOMPARE(problemOf(image, slices, static_cast<int>(slices.size())), QByteArray());
    QVERIFY(image->remarks.empty());
  }
};

HANDWHEEL_TEST(DicomPhantomTest)
#include "DicomPhantomTest.moc"
