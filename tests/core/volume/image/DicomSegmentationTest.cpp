// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageBytes.h"
#include "LPhantom.h"
#include "MadeSegmentation.h"
#include "TestClass.h"
#include "volume/image/DicomReader.h"
#include "volume/image/ImageLabels.h"
#include "volume/image/ImageToVolume.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kBetween = 2.0;  // mm

bool isInBox(const Vec3& p, const Vec3& low, const Vec3& high) {
  return (p.array() > low.array()).all() && (p.array() < high.array()).all();
}

// Two parts of the phantom: the bar to the left, and what the bar to the head has beyond it; and a box far above.
std::vector<MadeSegment> segmentsOfPhantom() {
  return {{"bar to the left",
           [](const Vec3& p) {
             return isInBox(p, {0, 0, 0}, {30, 8, 8});
           }},
          {"bar to the head",
           [](const Vec3& p) {
             return isInBox(p, {0, 0, 8}, {8, 8, 14});
           }},
          {"box", [](const Vec3& p) {
             return isInBox(p, {-12, 6, 24}, {-4, 12, 28});
           }}};
}
constexpr std::array<double, 3> kVolumes{30.0 * 8.0 * 8.0, 8.0 * 8.0 * 6.0, 8.0 * 6.0 * 4.0};
const std::array<Vec3, 3> kMiddles{Vec3(15, 4, 4), Vec3(4, 4, 11), Vec3(-8, 9, 26)};

// Pixels of 1 × 2 mm whose borders are those of the phantom: each segment has whole samples.
std::vector<MadeSlice> slicesOf(const Eigen::Matrix3d& axes) {
  MadeSlice slice;
  slice.across = axes.col(0);
  slice.down = axes.col(1);
  slice.spacing = 1.0;
  slice.downSpacing = 2.0;
  slice.width = 97;
  slice.height = 49;
  std::vector<MadeSlice> slices;
  constexpr int kHalf = 24;
  // The middle of the grid is that of a sample of 1, 2 and 2 mm along its axes.
  const Vec3 middle = (axes * Vec3(0.5, 1, 1)).cwiseAbs();
  for (int i = -kHalf; i <= kHalf; ++i) {
    slice.origin = middle + kBetween * i * axes.col(2) - 48.0 * slice.across - 2.0 * kHalf * slice.down;
    slices.push_back(slice);
  }
  return slices;
}

Result<ImageFile> readAlone(const std::string& file, DicomChoice choice = DicomChoice::OfFirst) {
  std::string files;
  appendDicomFile(file, files);
  Result<ImageFile> read = readDicom(files, choice, {});
  if (read) markLabels(read->image, read->labels);
  return read;
}

// Returns what is wrong with the labels of a segmentation: names, volumes, positions.
QByteArray problemOf(const Result<ImageFile>& read, std::size_t labels = 3) {
  if (!read) return read.error().arguments.back().c_str();
  if (!read->hasLabels) return "no labels";
  if (!(read->image.grid().steps.determinant() > 0.0)) return "a wrong hand";
  const std::vector<LabelRegion> regions = regionsOf(read->image);
  if (regions.size() != labels) return "number of labels";
  for (std::size_t i = 0; i < labels; ++i) {
    if (regions[i].label.name != segmentsOfPhantom()[i].name) return "a name";
    if (std::abs(regions[i].volume - kVolumes[i]) > 1e-6) return "volume: " + QByteArray::number(regions[i].volume);
    const auto number = static_cast<double>(i + 1);
    const Result<SparseVolume> volume = volumeOfImage(read->image, {number, number}, 1.0);
    if (!volume || std::abs(volume->enclosed() - kVolumes[i]) > 0.06 * kVolumes[i]) return "a volume of voxels";
    const VoxelIndex at = ((kMiddles[i] - volume->origin()) / volume->voxel()).array().round().cast<int>();
    if (volume->sample(at) <= 0) return "a position";
  }
  return {};
}

}  // namespace

// Segmentations in DICOM come out as label maps: names, volumes and positions of their segments are those of a phantom.
class DicomSegmentationTest : public QObject {
  Q_OBJECT

 private slots:
  void orientations_data() {
    QTest::addColumn<int>("number");
    for (int i = 0; i < 24; ++i) QTest::addRow("%d", i) << i;
  }
  void orientations() {
    QFETCH(int, number);
    const Eigen::Matrix3d axes = turnsOfCube()[static_cast<std::size_t>(number)];
    using Kind = MadeSegmentation::Kind;
    MadeSegmentation made{.slices = slicesOf(axes), .segments = segmentsOfPhantom(), .between = kBetween};
    made.kind = std::array{Kind::Binary, Kind::Fractional, Kind::LabelMap}[static_cast<std::size_t>(number) % 3];
    made.hasEmptyFrames = number % 2 == 0;
    if (number % 4 == 0) std::reverse(made.slices.begin(), made.slices.end());
    const Result<ImageFile> read = readAlone(dicomOf(made));
    QCOMPARE(problemOf(read), QByteArray());
    QVERIFY(read->remarks.empty());
  }

  // Frames that are left out are empty, however few are left, and whether or not the distance of slices is stated.
  void sparse() {
    MadeSegmentation made{.slices = slicesOf(Eigen::Matrix3d::Identity()), .segments = segmentsOfPhantom()};
    QCOMPARE(problemOf(readAlone(dicomOf(made))), QByteArray());
    // Slices may be thinner than their distance.
    for (const double share : {0.25, 0.5, 1.0}) {
      made.thickness = share * kBetween;
      QCOMPARE(problemOf(readAlone(dicomOf(made))), QByteArray());
    }
    // Only two slices have any sample; the stated distance is that between slices, not that of the two.
    made.segments = {{"bar to the left",
                      [](const Vec3& p) {
                        return isInBox(p, {0, 0, 0}, {30, 8, 2});
                      }},
                     {"two", [](const Vec3& p) {
                        return isInBox(p, {0, 0, 20}, {30, 8, 22});
                      }}};
    made.between = kBetween;
    const Result<ImageFile> read = readAlone(dicomOf(made));
    QVERIFY(read.hasValue());
    for (const LabelRegion& region : regionsOf(read->image)) QCOMPARE(region.volume, 30.0 * 8.0 * 2.0);
    QCOMPARE(read->image.grid().size[2], 11);
  }

  // Samples in several segments are said; the last of these has them.
  void overlapping() {
    MadeSegmentation made{.slices = slicesOf(Eigen::Matrix3d::Identity()), .between = kBetween};
    made.segments = {{"a",
                      [](const Vec3& p) {
                        return isInBox(p, {0, 0, 0}, {8, 8, 8});
                      }},
                     {"b", [](const Vec3& p) {
                        return isInBox(p, {4, 0, 0}, {12, 8, 8});
                      }}};
    const Result<ImageFile> read = readAlone(dicomOf(made));
    QVERIFY(read.hasValue());
    QVERIFY(hasRemark(*read, ImageRemark::Kind::Overlap));
    QCOMPARE(read->remarks.front().figures.front(), 4.0 * 8.0 * 8.0 / 4.0);  // samples of 4 mm³
    QCOMPARE(regionsOf(read->image)[1].volume, 512.0);
  }

  // Beside an image, a folder opens the image, even if the segmentation has more frames; the file of the segmentation
  // opens that.
  void besideAnImage() {
    std::vector<MadeSlice> slices = slicesOf(Eigen::Matrix3d::Identity());
    slices.resize(4);
    const std::string labels =
        dicomOf(MadeSegmentation{.slices = slicesOf(Eigen::Matrix3d::Identity()), .segments = segmentsOfPhantom()});
    std::string files;
    appendDicomFile(labels, files);
    for (const MadeSlice& slice : slices) appendDicomFile(dicomOf(slice), files);
    const Result<ImageFile> image = readDicom(files, DicomChoice::Largest, {});
    QVERIFY(image && !image->hasLabels && image->image.grid().size[2] == 4);
    const Result<ImageFile> own = readDicom(files, DicomChoice::OfFirst, {});
    QVERIFY(own && own->hasLabels);
    QCOMPARE(problemOf(readAlone(labels, DicomChoice::Largest)), QByteArray());
  }

  // Files without an image are refused by what they hold.
  void otherObjects() {
    const auto reasonOf = [](const char* identifier, std::uint16_t colours) {
      gdcm::Writer writer;
      gdcm::DataSet& data = writer.GetFile().GetDataSet();
      putText(data, {0x0008, 0x0016}, gdcm::VR::UI, identifier);
      putText(data, {0x0008, 0x0018}, gdcm::VR::UI, "1.2.3.4.5.8");
      if (colours > 0) made_frames::putCount(data, {0x0028, 0x0002}, gdcm::VR::US, colours);
      writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
      std::ostringstream stream;
      writer.SetStream(stream);
      const Result<ImageFile> read = writer.Write() ? readAlone(stream.str()) : Error{};
      return read ? std::string() : read.error().arguments.back();
    };
    QCOMPARE(reasonOf("1.2.840.10008.5.1.4.1.1.481.3", 0),
             std::string("it holds contours of regions (an RT structure set), not an image"));
    QCOMPARE(reasonOf("1.2.840.10008.5.1.4.1.1.88.33", 0),
             std::string("it holds a plan, a report or another object without an image"));
    QCOMPARE(reasonOf("1.2.840.10008.5.1.4.1.1.7", 3), std::string("it holds a colour image, not one in grey"));
    QCOMPARE(reasonOf("1.2.840.10008.5.1.4.1.1.7", 1), std::string("the file contains no image in grey"));
  }
};

HANDWHEEL_TEST(DicomSegmentationTest)
#include "DicomSegmentationTest.moc"
