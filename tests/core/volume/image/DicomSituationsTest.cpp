// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageBytes.h"
#include "LPhantom.h"
#include "MadeFrames.h"
#include "TestClass.h"
#include "volume/image/DicomReader.h"
#include "volume/image/ImageToVolume.h"

#include <gdcmReader.h>
#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using made_frames::putCount;

// Returns a file whose data set was changed.
std::string altered(const std::string& file, const std::function<void(gdcm::DataSet&)>& change) {
  std::istringstream in(file);
  gdcm::Reader reader;
  reader.SetStream(in);
  if (!reader.Read()) return {};
  change(reader.GetFile().GetDataSet());
  gdcm::Writer writer;
  writer.CheckFileMetaInformationOff();
  writer.SetFile(reader.GetFile());
  std::ostringstream out;
  writer.SetStream(out);
  return writer.Write() ? out.str() : std::string();
}

void putPixels(gdcm::DataSet& data, const std::string& bytes) {
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetVR(gdcm::VR::OW);
  pixels.SetByteValue(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  data.Replace(pixels);
}

Result<ImageFile> readFiles(const std::vector<std::string>& each) {
  std::string files;
  for (const std::string& file : each) appendDicomFile(file, files);
  return readDicom(files, DicomChoice::Largest, {});
}

MadeSlice smallSlice(double z = 0.0) {
  MadeSlice slice;
  slice.width = 4;
  slice.height = 2;
  slice.origin.z() = z;
  slice.intercept = 0.0;
  slice.value = [](const Vec3& p) { return std::round(2.0 * p.x() + 20.0 * p.y() + p.z()); };
  return slice;
}

// The section of the phantom across an axis at a height above its corner, mm².
double sectionOf(int axis, double height) {
  constexpr std::array<double, 3> kLengths{30.0, 22.0, 14.0};
  const auto k = static_cast<std::size_t>(axis);
  double area = 0.0;
  // In the corner the other two bars lie flat, and the corner is counted once; beyond it is the bar along the axis.
  if (height > 0.0 && height < 8.0) area = 8.0 * (kLengths[(k + 1) % 3] + kLengths[(k + 2) % 3] - 8.0);
  if (height >= 8.0 && height < kLengths[k]) area = 64.0;
  const double off = height - kLPhantomBall[axis];
  return area + std::max(0.0, M_PI * (16.0 - off * off));
}

}  // namespace

// Situations that people report of other programs, with values by hand.
class DicomSituationsTest : public QObject {
  Q_OBJECT

 private slots:
  // Three neighbouring slices are missing, anywhere in the phantom. What the phantom has across the gap on both sides
  // is filled exactly; what begins or ends in it, and only that, is as linear sections between the neighbours have it.
  void gaps_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<bool>("isFrames");
    for (int axis = 0; axis < 3; ++axis)
      for (const bool isFrames : {false, true}) QTest::addRow("%d %d", axis, isFrames) << axis << isFrames;
  }
  void gaps() {
    QFETCH(int, axis);
    QFETCH(bool, isFrames);
    constexpr double kSliceStep = 2.0;
    constexpr int kMissing = 3;
    Eigen::Matrix3d axes;
    for (int k = 0; k < 3; ++k) axes.col(k) = Vec3::Unit((axis + 1 + k) % 3);
    std::vector<MadeSlice> all;
    for (int i = 0; i < 32; ++i) {
      MadeSlice slice;
      slice.across = axes.col(0);
      slice.down = axes.col(1);
      slice.width = slice.height = 64;
      slice.spacing = 1.0;
      slice.origin = Vec3(-22, -22, -22) + (22.0 - 21.0 + kSliceStep * i) * axes.col(2);
      slice.origin[axis] = -21.0 + kSliceStep * i;
      slice.value = lPhantom;
      all.push_back(slice);
    }
    const auto volumeOf = [&](const std::vector<MadeSlice>& slices, Result<ImageFile>& read) {
      std::vector<std::string> files;
      if (isFrames)
        files.push_back(dicomOf(MadeFrames{.frames = slices}));
      else
        for (const MadeSlice& slice : slices) files.push_back(dicomOf(slice));
      read = readFiles(files);
      const Result<SparseVolume> volume = read ? volumeOfImage(read->image, {500.0, 1e9}, 1.0) : read.error();
      return volume ? volume->enclosed() : 0.0;
    };
    Result<ImageFile> read = Error{};
    const double whole = volumeOf(all, read);
    QVERIFY(std::abs(whole / kLPhantomVolume - 1.0) < 0.06);
    for (const std::size_t first : {9u, 10u, 12u, 14u, 17u, 19u}) {
      std::vector<MadeSlice> kept = all;
      const auto at = kept.begin() + static_cast<std::ptrdiff_t>(first);
      kept.erase(at, at + kMissing);
      const double filled = volumeOf(kept, read);
      QVERIFY(read.hasValue() && hasRemark(*read, ImageRemark::Kind::SlicesMissing));
      QCOMPARE(read->remarks.front().figures, (std::vector<double>{kMissing, (kMissing + 1) * kSliceStep}));
      QCOMPARE(read->image.grid().size[2], static_cast<int>(all.size()));
      const double low = all[first - 1].origin[axis], high = all[first + kMissing].origin[axis];
      // The neighbours' sections, and the integral of the true ones over the gap.
      const double below = sectionOf(axis, low), above = sectionOf(axis, high);
      double inGap = 0.0;
      constexpr int kSteps = 800;
      for (int i = 0; i < kSteps; ++i)
        inGap += sectionOf(axis, low + (i + 0.5) * (high - low) / kSteps) * (high - low) / kSteps;
      const double expected = whole - inGap + 0.5 * (below + above) * (high - low);
      // One voxel of 1 mm around the phantom's surface has about 0.5 of its area; sections change by a half of that.
      QVERIFY2(std::abs(filled - expected) < 0.03 * kLPhantomVolume + 0.25 * std::abs(above - below) * (high - low),
               QByteArray::number(filled) + " for " + QByteArray::number(expected) + " at " + QByteArray::number(low));
    }
  }

  // Several moments of each slice, in files of any order: the first moment is read everywhere, not a mixture.
  void moments() {
    std::vector<std::string> files;
    for (const int phase : {2, 1, 3})
      for (int z = 0; z < 4; ++z) {
        MadeSlice slice = smallSlice(2.0 * z);
        slice.value = [phase](const Vec3&) { return 100.0 * phase; };
        files.push_back(altered(dicomOf(slice), [&](gdcm::DataSet& data) {
          putText(data, {0x0020, 0x0100}, gdcm::VR::IS, std::to_string(phase));
        }));
      }
    // Slice by slice in turn, so that each position begins with another moment.
    for (std::size_t turn = 0; turn < 4; ++turn) std::swap(files[turn], files[(4 * turn + turn) % files.size()]);
    const Result<ImageFile> read = readFiles(files);
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.grid().size[2], 4);
    for (const double value : valuesIn(read->image)) QCOMPARE(value, 100.0);
    QCOMPARE(read->remarks.front().figures, std::vector<double>{8.0});
  }

  // A localizer across the slices, and slices of another size, are in the same series: the largest stack is read.
  void strangersInASeries() {
    std::vector<std::string> files;
    MadeSlice scout = smallSlice(3.0);
    scout.across = Vec3::UnitY();
    scout.down = -Vec3::UnitZ();
    files.push_back(dicomOf(scout));
    MadeSlice wide = smallSlice(40.0);
    wide.width = 8;
    files.push_back(dicomOf(wide));
    for (int z = 0; z < 3; ++z) files.push_back(dicomOf(smallSlice(2.0 * z)));
    const Result<ImageFile> read = readFiles(files);
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.grid().size, (std::array<int, 3>{4, 2, 3}));
    QVERIFY(hasRemark(*read, ImageRemark::Kind::OtherSeries));
    QCOMPARE(read->image.value(23), std::round(3.0 + 10.0 + 4.0));
  }

  // Pixels without a value are no bone, although their number is the largest: it is 63536 without a sign, and is the
  // number of bits of -2000 with one.
  void padding() {
    for (const std::uint16_t isSigned : {0, 1}) {
      const std::string file = altered(dicomOf(smallSlice()), [&](gdcm::DataSet& data) {
        putCount(data, {0x0028, 0x0103}, gdcm::VR::US, isSigned);
        putCount(data, {0x0028, 0x0120}, isSigned != 0 ? gdcm::VR::SS : gdcm::VR::US, std::uint16_t{63536});
        putPixels(data, bytesOfNumbers<std::uint16_t>({63536, 7, 9, 63536, 24, 1000, 5, 63536}));
      });
      const Result<ImageFile> read = readFiles({file});
      QVERIFY(read.hasValue());
      QCOMPARE(valuesIn(read->image), (std::vector<double>{5, 7, 9, 5, 24, 1000, 5, 5}));
    }
  }

  // Twelve bits in sixteen: the others may hold anything, such as an overlay; numbers have the sign of their bit 11.
  void usedBits() {
    const std::string file = altered(dicomOf(smallSlice()), [](gdcm::DataSet& data) {
      putCount(data, {0x0028, 0x0101}, gdcm::VR::US, std::uint16_t{12});
      putCount(data, {0x0028, 0x0102}, gdcm::VR::US, std::uint16_t{11});
      putPixels(data, bytesOfNumbers<std::uint16_t>({0x1001, 0xf7ff, 0x0800, 0x1fff, 0, 1, 2, 0xf003}));
    });
    const Result<ImageFile> read = readFiles({file});
    QVERIFY(read.hasValue());
    QCOMPARE(valuesIn(read->image), (std::vector<double>{1, 2047, -2048, -1, 0, 1, 2, 3}));
  }

  // Two pixels of twelve bits in three bytes (PS3.5, D).
  void packedBits() {
    const std::string file = altered(dicomOf(smallSlice()), [](gdcm::DataSet& data) {
      for (const auto& [element, count] :
           {std::pair(0x0100, 12), std::pair(0x0101, 12), std::pair(0x0102, 11), std::pair(0x0103, 0)})
        putCount(data, {0x0028, static_cast<std::uint16_t>(element)}, gdcm::VR::US, static_cast<std::uint16_t>(count));
      std::string bytes;
      const std::vector<int> numbers{0x123, 0xabc, 0x001, 0xfff, 7, 8, 9, 10};
      for (std::size_t i = 0; i < numbers.size(); i += 2) {
        const int both = numbers[i] | numbers[i + 1] << 12;
        for (int k = 0; k < 3; ++k) bytes += static_cast<char>(both >> 8 * k & 255);
      }
      putPixels(data, bytes);
    });
    const Result<ImageFile> read = readFiles({file});
    QVERIFY(read.hasValue());
    QCOMPARE(valuesIn(read->image), (std::vector<double>{0x123, 0xabc, 0x001, 0xfff, 7, 8, 9, 10}));
  }
};

HANDWHEEL_TEST(DicomSituationsTest)
#include "DicomSituationsTest.moc"
