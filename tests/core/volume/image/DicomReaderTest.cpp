// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/DicomReader.h"

#include "ImageBytes.h"
#include "MadeFrames.h"
#include "TestClass.h"

#include <QDir>
#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Result<ImageFile> readSlices(const std::vector<MadeSlice>& slices, DicomChoice choice = DicomChoice::Largest) {
  std::string files;
  for (const MadeSlice& slice : slices) appendDicomFile(dicomOf(slice), files);
  return readDicom(files, choice, {});
}

// Slices one above the other.
std::vector<MadeSlice> stack(const std::vector<double>& heights, MadeSlice like = {}) {
  std::vector<MadeSlice> slices;
  for (const double z : heights) {
    like.origin.z() = z;
    slices.push_back(like);
  }
  return slices;
}

// Returns true if each value is that of its position, except for rounding.
bool hasValues(const ImageVolume& image, const std::function<double(const Vec3&)>& value, double within = 1.01) {
  const auto& size = image.grid().size;
  std::size_t i = 0;
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x, ++i)
        if (std::abs(image.value(i) - value(image.grid().position(Vec3(x, y, z)))) > within) return false;
  return true;
}

}  // namespace

class DicomReaderTest : public QObject {
  Q_OBJECT

 private slots:
  // Slices are in the order of their positions, for any order of the files, and rescaled.
  void aSeries() {
    const Result<ImageFile> read = readSlices(stack({6.0, 2.0, 4.0, 8.0, 0.0}));
    QVERIFY(read.hasValue());
    QVERIFY(read->remarks.empty());
    const ImageGrid& grid = read->image.grid();
    QCOMPARE(grid.size, (std::array<int, 3>{8, 6, 5}));
    QVERIFY((grid.spacing() - Vec3(0.5, 0.5, 2.0)).norm() < 1e-6);
    QVERIFY(hasValues(read->image, MadeSlice().value, 0.01));
    QVERIFY(read->image.isWhole());
  }

  void syntaxes_data() {
    QTest::addColumn<int>("syntax");
    QTest::newRow("implicit") << static_cast<int>(gdcm::TransferSyntax::ImplicitVRLittleEndian);
    QTest::newRow("JPEG lossless") << static_cast<int>(gdcm::TransferSyntax::JPEGLosslessProcess14_1);
    QTest::newRow("JPEG-LS") << static_cast<int>(gdcm::TransferSyntax::JPEGLSLossless);
    QTest::newRow("JPEG 2000") << static_cast<int>(gdcm::TransferSyntax::JPEG2000Lossless);
    QTest::newRow("RLE") << static_cast<int>(gdcm::TransferSyntax::RLELossless);
  }
  void syntaxes() {
    QFETCH(int, syntax);
    MadeSlice slice;
    slice.syntax = static_cast<gdcm::TransferSyntax::TSType>(syntax);
    slice.width = 32;
    slice.height = 24;
    const Result<ImageFile> read = readSlices(stack({0.0, 1.0, 2.0}, slice));
    QVERIFY(read.hasValue());
    QVERIFY(hasValues(read->image, slice.value, 0.01));
  }

  // Slices look where they say: turned ones, and such that follow one another against their normal.
  void turned() {
    MadeSlice slice;
    slice.across = Vec3(0, 1, 0);
    slice.down = Vec3(0, 0, -1);
    std::vector<MadeSlice> slices;
    for (int i = 0; i < 4; ++i) {
      slice.origin = Vec3(3.0 * i, 5.0, -7.0);
      slices.push_back(slice);
    }
    const Result<ImageFile> read = readSlices(slices);
    QVERIFY(read.hasValue());
    QVERIFY(read->remarks.empty());
    QVERIFY(hasValues(read->image, slice.value, 0.01));
  }

  // Each slice may have its own scale.
  void scales() {
    std::vector<MadeSlice> slices = stack({0.0, 1.0, 2.0});
    slices[0].slope = 0.5;
    slices[1].slope = 2.0;
    slices[2].intercept = 0.0;
    const Result<ImageFile> read = readSlices(slices);
    QVERIFY(read.hasValue());
    QVERIFY(hasValues(read->image, MadeSlice().value));
  }

  // Sixteen bits hold the values of all slices but one.
  void oneSliceOfFractions() {
    const auto value = [](const Vec3& p) { return 100.0 * p.x() + 10.0 * p.y() + (p.z() == 2.0 ? 0.25 : 0.0); };
    std::vector<MadeSlice> slices = stack({0.0, 1.0, 2.0, 3.0});
    for (MadeSlice& slice : slices) slice.value = value;
    slices[2].slope = 0.25;
    slices[2].intercept = 0.0;
    const Result<ImageFile> read = readSlices(slices);
    QVERIFY(read.hasValue());
    QVERIFY(!read->image.isWhole());
    QVERIFY(hasValues(read->image, value, 1e-6));
  }

  // The scanner is tilted: each slice is further along y. Nothing is resampled, and positions are correct.
  void tilted() {
    std::vector<MadeSlice> slices = stack({0.0, 2.0, 4.0, 6.0});
    for (MadeSlice& slice : slices) slice.origin.y() = 0.5 * slice.origin.z();
    const Result<ImageFile> read = readSlices(slices);
    QVERIFY(read.hasValue());
    QVERIFY(hasValues(read->image, MadeSlice().value, 0.01));
    QCOMPARE(read->remarks.size(), std::size_t{1});
    QVERIFY(read->remarks.front().kind == ImageRemark::Kind::Tilted);
    QVERIFY(std::abs(read->remarks.front().figures.front() - std::atan(0.5) * 180.0 / M_PI) < 1e-3);
  }

  // A ramp is linear, so what is put between slices is exact.
  void missing() {
    const Result<ImageFile> read = readSlices(stack({0.0, 2.0, 4.0, 8.0, 10.0, 16.0}));
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.grid().size[2], 9);
    QVERIFY(hasValues(read->image, MadeSlice().value, 0.01));
    QVERIFY(hasRemark(*read, ImageRemark::Kind::SlicesMissing));
    QCOMPARE(read->remarks.front().figures.front(), 3.0);
  }
  void uneven() {
    const Result<ImageFile> read = readSlices(stack({0.0, 2.0, 4.0, 5.3, 7.3, 12.1, 14.1}));
    QVERIFY(read.hasValue());
    QVERIFY(hasValues(read->image, MadeSlice().value));
    QVERIFY(hasRemark(*read, ImageRemark::Kind::Uneven));
    QVERIFY(std::abs(read->image.grid().position({0, 0, read->image.grid().size[2] - 1.0}).z() - 14.1) < 1e-6);
    // The smallest distance is that of 1.3 mm.
    QVERIFY(read->image.grid().spacing().z() <= 1.3 && read->image.grid().spacing().z() > 1.2);
    QCOMPARE(read->remarks.front().figures.back(), read->image.grid().spacing().z());
  }
  // Thin slices of the region of interest among thick ones keep their distance, and all of their values: 40 of 1 mm
  // between 20 of 5 mm on either side.
  void thinAmongThick() {
    std::vector<double> heights{0.0};
    for (int i = 0; i < 80; ++i) heights.push_back(heights.back() + (i >= 20 && i < 60 ? 1.0 : 5.0));
    const Result<ImageFile> read = readSlices(stack(heights));
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.grid().size[2], 241);
    QVERIFY(std::abs(read->image.grid().spacing().z() - 1.0) < 1e-9);
    QVERIFY(hasValues(read->image, MadeSlice().value));
  }
  // A pair of slices almost at one position does not make thousands of them.
  void almostOnePosition() {
    std::vector<double> heights;
    for (int i = 0; i < 20; ++i) heights.push_back(5.0 * i);
    heights.push_back(45.01);
    const Result<ImageFile> read = readSlices(stack(heights));
    QVERIFY(read.hasValue());
    QVERIFY(hasRemark(*read, ImageRemark::Kind::Uneven));
    QVERIFY(read->image.grid().size[2] <= 32 * 21 + 65);
    QVERIFY(hasValues(read->image, MadeSlice().value));
  }

  void mixed() {
    MadeSlice other;
    other.series = "1.2.3.5";
    std::vector<MadeSlice> slices = stack({50.0, 52.0}, other);
    for (const MadeSlice& slice : stack({0.0, 1.0, 2.0})) slices.push_back(slice);
    const Result<ImageFile> largest = readSlices(slices), first = readSlices(slices, DicomChoice::OfFirst);
    QVERIFY(largest.hasValue() && first.hasValue());
    QCOMPARE(largest->image.grid().size[2], 3);
    QCOMPARE(first->image.grid().size[2], 2);
    QVERIFY(hasRemark(*largest, ImageRemark::Kind::OtherSeries) && hasRemark(*first, ImageRemark::Kind::OtherSeries));
    QCOMPARE(first->image.grid().origin.z(), 50.0);
  }

  void samePlaceAndUnreadable() {
    std::string files;
    for (const MadeSlice& slice : stack({0.0, 1.0, 1.0, 2.0})) appendDicomFile(dicomOf(slice), files);
    appendDicomFile(std::string(128, '\0') + "DICMnonsense", files);
    const Result<ImageFile> read = readDicom(files, DicomChoice::Largest, {});
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.grid().size[2], 3);
    QVERIFY(hasRemark(*read, ImageRemark::Kind::SamePosition) && hasRemark(*read, ImageRemark::Kind::NotReadable));
  }

  void oneSlice() {
    const Result<ImageFile> read = readSlices(stack({3.0}));
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.grid().size[2], 1);
    QVERIFY(hasValues(read->image, MadeSlice().value, 0.01));
  }

  void refusals() {
    QVERIFY(!readDicom("", DicomChoice::Largest, {}));
    QVERIFY(!readDicom("no DICOM", DicomChoice::Largest, {}));
    std::vector<MadeSlice> bent = stack({0.0, 1.0, 2.0});
    bent[1].origin.x() = 4.0;
    const Result<ImageFile> read = readSlices(bent);
    QVERIFY(!read);
    QCOMPARE(read.error().arguments.back(), std::string("its slices do not lie along one line"));
    QVERIFY(!readSlices(stack({0.0, 1.0, 2.0, 3000.0})));
  }

  // Slices without positions: their locations, or their numbers and the stated distance; which is said.
  void withoutPositions() {
    const auto without = [](const std::vector<std::pair<gdcm::Tag, std::vector<const char*>>>& more) {
      std::string files;
      for (std::size_t i = 0; i < 3; ++i) {
        const double order[] = {1.0, 2.0, 0.0};
        MadeFrames made{.frames = stack({10.0 * order[i]}), .hasGroups = false, .hasPositions = false};
        made.frames.front().value = [&](const Vec3&) { return 5.0 * order[i]; };
        for (const auto& [tag, texts] : more) made.more.emplace_back(tag, texts[i % texts.size()]);
        appendDicomFile(dicomOf(made), files);
      }
      return readDicom(files, DicomChoice::Largest, {});
    };
    const gdcm::Tag location(0x0020, 0x1041), number(0x0020, 0x0013), between(0x0018, 0x0088);
    for (const Result<ImageFile>& read :
         {without({{location, {"-7.5", "-5", "-10"}}}), without({{number, {"8", "9", "5"}}, {between, {"2.5"}}})}) {
      QVERIFY(read.hasValue());
      QVERIFY(hasRemark(*read, ImageRemark::Kind::SpacingAssumed));
      QVERIFY((read->image.grid().spacing() - Vec3(0.5, 0.5, 2.5)).norm() < 1e-9);
      for (int z = 0; z < 3; ++z) QCOMPARE(read->image.value(static_cast<std::size_t>(48 * z)), 5.0 * z);
    }
    QVERIFY(!without({{number, {"1", "2", "3"}}}));
  }

  // Other files are not taken for data sets without a preamble.
  void otherBeginnings() {
    const std::string good = dicomOf(MadeSlice()), plain = good.substr(132);
    QVERIFY(looksLikeDicom(good) && looksLikeDicom(plain));
    for (std::size_t n = 0; n < 38; ++n) QVERIFY(!looksLikeDicom(plain.substr(0, n)));
    QVERIFY(!looksLikeDicom(std::string(1000, '\0')) && !looksLikeDicom("solid ball\nfacet normal 0 0 1\n"));
    QVERIFY(!looksLikeDicom(std::string("\x08\0\x05\0", 4) + std::string(1000, '\x08')));
    QVERIFY(!looksLikeDicom(std::string("\x02\0\0\0UL\x04\0", 8) + std::string(1000, '\0')));
  }

  // Any file results in an image or an error, whatever it does to the library.
  void damaged() {
    MadeSlice slice;
    slice.syntax = gdcm::TransferSyntax::JPEG2000Lossless;
    const std::string good = dicomOf(slice);
    for (std::size_t i = 0; i < 40; ++i) {
      std::string bad = good;
      for (std::size_t k = 0; k < 5; ++k)
        bad[(i * 7919 + k * 104729) % bad.size()] = static_cast<char>(i * 37 + k * 11);
      if (i % 4 == 0) bad.resize(bad.size() * i / 40);
      std::string files;
      appendDicomFile(bad, files);
      appendDicomFile(good, files);
      const Result<ImageFile> read = readDicom(files, DicomChoice::OfFirst, {});
      if (!read) QVERIFY(read.error().code == ErrorCode::LibraryFailed || read.error().code == ErrorCode::OutOfMemory);
    }
  }

  void answersThatMakeNoSense() {
    const Result<ImageFile> good = imageInAnswer(
        "0 0 0 0 0 0 0 0 0 0 0 0\nNRRD0004\ntype: int16\ndimension: 3\nsizes: 1 1 1\n"
        "spacings: 1 1 1\nencoding: raw\n\nab");
    QVERIFY(good.hasValue());
    for (const char* answer : {"", "0 0 0\n", "0 0 0 0 0 0 0 0 0 0 0 -1\nNRRD", "0 0 0 0 0 0 0 0 0 0 0 nan\nNRRD0004\n",
                               "0 0 0 0 0 0 0 0 0 0 0 0\nNRRD0004\n\n"})
      QVERIFY(!imageInAnswer(answer));
  }

  // Twelve slices of a leaning scanner, one of them out of step (its description says 18.5 degrees, 4.22 mm).
  void aHead() {
    const QString folder = qEnvironmentVariable("HANDWHEEL_DATA");
    if (folder.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    std::string files;
    const QDir head(folder + "/anatomy/ct-dicom-ge-head");
    for (const QFileInfo& info : head.entryInfoList({"*.dcm"})) {
      QFile file(info.filePath());
      QVERIFY(file.open(QIODevice::ReadOnly));
      appendDicomFile(file.readAll().toStdString(), files);
    }
    const Result<ImageFile> read = readDicom(files, DicomChoice::Largest, {});
    QVERIFY(read.hasValue());
    QCOMPARE(read->image.grid().size[0], 512);
    QVERIFY(hasRemark(*read, ImageRemark::Kind::Tilted) && hasRemark(*read, ImageRemark::Kind::Uneven));
    QVERIFY(std::abs(read->remarks.front().figures.front() - 18.5) < 0.5);
    const ValueRange values = valuesOf(read->image);
    // The corners outside of the tube, -1500, have no value; CT numbers begin at -1024.
    QVERIFY2(values.least >= -1024.0 && values.least < -900.0 && values.largest > 1000.0,
             qPrintable(QString::number(values.least)));
  }
};

HANDWHEEL_TEST(DicomReaderTest)
#include "DicomReaderTest.moc"
