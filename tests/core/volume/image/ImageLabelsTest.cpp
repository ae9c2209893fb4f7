// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageLabels.h"

#include "ClosedSurface.h"
#include "ImageBytes.h"
#include "LPhantom.h"
#include "MadeImages.h"
#include "TestClass.h"
#include "volume/image/ImageToVolume.h"
#include "volume/image/NrrdReader.h"
#include "volume/segment/SegmentToVolume.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The samples of a cuboid of 12 × 9 × 6 mm have the label 1, 3 its half to the left, and 2 those of a ball within both.
double labelAt(const Vec3& p) {
  if ((p - Vec3(1, 1, 1)).norm() < 2.4) return 2.0;
  if (std::abs(p.x()) > 6.0 || std::abs(p.y()) > 4.5 || std::abs(p.z()) > 3.0) return 0.0;
  return p.x() > 0.0 ? 3.0 : 1.0;
}

ImageVolume labelImage(const Eigen::Matrix3d& turn, const Vec3& spacing) {
  ImageGrid grid{{24, 26, 28}, Vec3::Zero(), turn * spacing.asDiagonal()};
  grid.origin = Vec3(0.13, 0.21, 0.17) - grid.steps * Vec3(11.5, 12.5, 13.5);
  return imageOf<std::int16_t>(grid, labelAt);
}

}  // namespace

class ImageLabelsTest : public QObject {
  Q_OBJECT

 private slots:
  void recognised() {
    const Eigen::Matrix3d plain = Eigen::Matrix3d::Identity();
    QVERIFY(looksLikeLabels(labelImage(plain, {1, 1, 1})));
    const ImageGrid grid{{40, 40, 40}, Vec3(-20, -10, -10), plain};
    // A CT has values below 0, and a smooth image has values between; an image of one value has no regions.
    QVERIFY(!looksLikeLabels(imageOf<std::int16_t>(grid, lPhantom)));
    QVERIFY(!looksLikeLabels(imageOf<std::int16_t>(grid, [](const Vec3& p) { return p.x() > 0 ? 1000 : -1000; })));
    QVERIFY(!looksLikeLabels(imageOf<float>(grid, [](const Vec3& p) { return p.x() > 0 ? 0.5 : 0.0; })));
    QVERIFY(!looksLikeLabels(imageOf<std::int16_t>(grid, [](const Vec3&) { return 0; })));
    // Noise of 8 bits.
    unsigned int state = 1;
    QVERIFY(!looksLikeLabels(imageOf<std::int16_t>(grid, [&](const Vec3&) {
      state = state * 1664525u + 1013904223u;
      return state >> 24;
    })));
  }

  void regions() {
    ImageVolume image = labelImage(Eigen::Matrix3d::Identity(), {0.5, 0.75, 1.0});
    markLabels(image, {{2.0, "ball\n\xff"}, {7.0, "none"}});
    QCOMPARE(image.labels().size(), std::size_t{3});
    const std::vector<LabelRegion> regions = regionsOf(image);
    std::array<std::size_t, 4> counts{};
    for (std::size_t i = 0; i < image.grid().count(); ++i) ++counts[static_cast<std::size_t>(image.value(i))];
    for (std::size_t k = 0; k < 3; ++k) {
      QCOMPARE(regions[k].label.value, static_cast<double>(k + 1));
      QCOMPARE(regions[k].samples, counts[k + 1]);
      QVERIFY(std::abs(regions[k].volume - 0.375 * static_cast<double>(counts[k + 1])) < 1e-9);
    }
    QCOMPARE(regions[1].label.name, std::string("ball\xef\xbf\xbd"));
    QCOMPARE(regions[0].label.name, std::string());
    QCOMPARE(rangeOfLabels(image).least, 1.0);
  }

  // At the usual voxel the volume of a label is that of its samples, beside whatever labels.
  void volumes_data() {
    QTest::addColumn<double>("label");
    for (const int label : {1, 2, 3}) QTest::addRow("%d", label) << static_cast<double>(label);
  }
  void volumes() {
    QFETCH(double, label);
    ImageVolume image = labelImage(Eigen::Matrix3d::Identity(), {1, 1, 1});
    markLabels(image, {});
    const double samples = regionsOf(image)[static_cast<std::size_t>(label) - 1].volume;
    const Result<SparseVolume> volume = volumeOfImage(image, {label, label}, std::nullopt);
    QVERIFY(volume.hasValue());
    QCOMPARE(volume->enclosed(), samples);
    QCOMPARE(volume->material(), samples);
    // The same by painting: what the segment has, at whatever values.
    Segment segment({label, label});
    const VoxelIndex middle(12, 13, 14);
    segment.setBrick(image.grid().size, middle, std::make_shared<SegmentBrick>(segment.filledBrick(image, middle)));
    QVERIFY(!segment.isByRangeAlone());
    const Result<SparseVolume> painted = volumeOfSegment(image, segment, std::nullopt);
    QVERIFY(painted.hasValue());
    QCOMPARE(painted->enclosed(), samples);
  }

  // In a grid that is turned, or with other voxels, the volume is within a quarter of a sample around the surface. The
  // surfaces are known: half a cuboid is 12 × 9 × 6 / 2 mm³ less what the ball takes of it.
  void turned() {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    ImageVolume image = labelImage(turn, {0.8, 0.7, 0.6});
    markLabels(image, {});
    const std::vector<LabelRegion> regions = regionsOf(image);
    const double ball = 4.0 / 3.0 * M_PI * 2.4 * 2.4 * 2.4, area = 4.0 * M_PI * 2.4 * 2.4;
    for (const double voxel : {0.5, 0.25, 0.9}) {
      const Result<SparseVolume> volume = volumeOfImage(image, {2.0, 2.0}, voxel);
      QVERIFY(volume.hasValue());
      QVERIFY2(std::abs(volume->enclosed() - ball) < 0.25 * 0.7 * area, QByteArray::number(volume->enclosed()));
      // Nothing of the other labels' common border counts as label 2, which lies between them by number alone.
      const Result<SparseVolume> left = volumeOfImage(image, {3.0, 3.0}, voxel);
      QVERIFY(left.hasValue());
      QVERIFY2(std::abs(left->enclosed() / regions[2].volume - 1.0) < 0.06, QByteArray::number(left->enclosed()));
    }
  }

  // The keys of 3D Slicer name the labels; those of other layers are not of these values.
  void slicer() {
    const std::string head =
        "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 3 1 1\n"
        "space directions: (1,0,0) (0,1,0) (0,0,1)\nkinds: domain domain domain\nencoding: raw\n"
        "Segment0_ID:=Segment_1\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=left femur\n"
        "Segment1_LabelValue:=2\nSegment1_Layer:=0\nSegment1_Name:=tibia: both\n"
        "Segment2_LabelValue:=1\nSegment2_Layer:=1\nSegment2_Name:=skin\n\n";
    const Result<ImageFile> read = readNrrd(head + std::string("\0\1\2", 3), {});
    QVERIFY(read.hasValue());
    QVERIFY(read->hasLabels);
    QCOMPARE(read->labels, (std::vector<ImageLabel>{{1.0, "left femur"}, {2.0, "tibia: both"}}));
  }

  // Layers of 3D Slicer, as an axis without a direction: the first, or the last, as other programs write them. Their
  // numbers are reused from layer to layer; segments overlap in one sample.
  void layers() {
    const std::string keys =
        "type: uchar\ndimension: 4\nspace: left-posterior-superior\nencoding: raw\n"
        "Segment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=a\n"
        "Segment1_LabelValue:=2\nSegment1_Layer:=0\nSegment1_Name:=b\n"
        "Segment2_LabelValue:=1\nSegment2_Layer:=1\nSegment2_Name:=c\n";
    const std::string first =
        "NRRD0004\n" + keys +
        "sizes: 2 4 2 1\nspace directions: none (2,0,0) (0,3,0) (0,0,5)\nkinds: list domain domain domain\n\n";
    const std::string last =
        "NRRD0004\n" + keys +
        "sizes: 4 2 1 2\nspace directions: (2,0,0) (0,3,0) (0,0,5) none\nkinds: domain domain domain list\n\n";
    const std::string layer0("\1\1\2\0\0\0\0\0", 8), layer1("\0\1\0\1\1\0\0\0", 8);
    std::string beside;
    for (std::size_t i = 0; i < 8; ++i) beside += {layer0[i], layer1[i]};
    for (const std::string& file : {first + beside, last + layer0 + layer1}) {
      Result<ImageFile> read = readNrrd(file, {});
      QVERIFY(read.hasValue());
      QVERIFY((read->image.grid().spacing() - Vec3(2, 3, 5)).norm() < 1e-12);
      QCOMPARE(valuesIn(read->image), (std::vector<double>{1, 3, 2, 3, 3, 0, 0, 0}));
      QCOMPARE(read->labels, (std::vector<ImageLabel>{{1.0, "a"}, {2.0, "b"}, {3.0, "c"}}));
      QCOMPARE(read->remarks.size(), std::size_t{1});
      QVERIFY(read->remarks.front().kind == ImageRemark::Kind::Overlap);
      QCOMPARE(read->remarks.front().figures, std::vector<double>{1.0});
      markLabels(read->image, read->labels);
      QCOMPARE(regionsOf(read->image)[2].volume, 3 * 30.0);  // three samples of 30 mm³
    }
  }

  // 80 × 80 samples of which each has a value of its own are no labels; the first layer is read as an image.
  void tooManyValuesOfLayers() {
    std::string file =
        "NRRD0004\ntype: ushort\ndimension: 4\nspace: left-posterior-superior\nencoding: raw\nendian: little\n"
        "Segment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=a\n"
        "sizes: 80 80 1 2\nspace directions: (1,0,0) (0,1,0) (0,0,1) none\nkinds: domain domain domain list\n\n";
    for (int layer = 0; layer < 2; ++layer)
      for (int i = 0; i < 80 * 80; ++i) file += {static_cast<char>(i & 0xff), static_cast<char>(i >> 8)};
    const Result<ImageFile> read = readNrrd(file, {});
    QVERIFY(read.hasValue());
    QVERIFY(!read->hasLabels);
    const std::vector<double> values = valuesIn(read->image);
    QCOMPARE(values.size(), std::size_t{80 * 80});
    for (std::size_t i = 0; i < values.size(); ++i) QCOMPARE(values[i], static_cast<double>(i));
  }
};

HANDWHEEL_TEST(ImageLabelsTest)
#include "ImageLabelsTest.moc"
