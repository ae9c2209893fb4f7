// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NiftiReader.h"

#include "ImageBytes.h"
#include "TestClass.h"
#include "volume/image/Inflate.h"

#include <QtTest>
#include <cmath>
#include <cstring>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A file by the offsets of nifti1.h, in either order of bytes.
class NiftiBytes {
 public:
  explicit NiftiBytes(std::endian order = std::endian::little) : m_order(order), m_bytes(352, '\0') {
    put<std::int32_t>(0, 348);
    put<float>(108, 352.0f);
    m_bytes.replace(344, 4, std::string("n+1\0", 4));
    put<float>(76, 1.0f);
  }
  template <class Number>
  NiftiBytes& put(std::size_t at, Number number) {
    std::string bytes;
    appendNumber(bytes, number, m_order);
    m_bytes.replace(at, bytes.size(), bytes);
    return *this;
  }
  NiftiBytes& size(std::initializer_list<int> sizes) {
    put<std::int16_t>(40, static_cast<std::int16_t>(sizes.size()));
    std::size_t at = 42;
    for (const int n : sizes) put<std::int16_t>(at, static_cast<std::int16_t>(n)), at += 2;
    return *this;
  }
  NiftiBytes& spacing(float x, float y, float z) { return put(80, x).put(84, y).put(88, z); }
  template <class Number>
  NiftiBytes& samples(int type, const std::vector<Number>& numbers) {
    put<std::int16_t>(70, static_cast<std::int16_t>(type));
    put<std::int16_t>(72, static_cast<std::int16_t>(8 * sizeof(Number)));
    m_bytes += bytesOfNumbers(numbers, m_order);
    return *this;
  }
  const std::string& bytes() const { return m_bytes; }

 private:
  std::endian m_order;
  std::string m_bytes;
};

const std::vector<std::int16_t> kNiftiSamples{0, 1, -2, 3, 300, -1000};
const std::vector<double> kNiftiValues(kNiftiSamples.begin(), kNiftiSamples.end());

NiftiBytes small(std::endian order = std::endian::little) {
  return NiftiBytes(order).size({2, 3, 1}).spacing(0.5f, 2.0f, 4.0f);
}

}  // namespace

class NiftiReaderTest : public QObject {
  Q_OBJECT

 private slots:
  // Without a form, positions follow from the spacings; NIfTI has the opposite x and y.
  void plainAndPacked() {
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      const std::string bytes = small(order).samples(4, kNiftiSamples).bytes();
      for (const std::string& each : {bytes, packed(bytes, true)}) {
        QVERIFY(looksLikeNifti(each));
        const Result<ImageFile> file = readNifti(each);
        QVERIFY(file.hasValue());
        QCOMPARE(valuesIn(file->image), kNiftiValues);
        QCOMPARE(file->image.grid().position({1, 1, 0}), Vec3(-0.5, -2.0, 0.0));
        QVERIFY(file->remarks.empty());
      }
    }
  }

  void types() {
    const auto check = [](int type, auto numbers, const std::vector<double>& expected) {
      const Result<ImageFile> file =
          readNifti(NiftiBytes().size({3}).spacing(1.0f, 1.0f, 1.0f).samples(type, numbers).bytes());
      QVERIFY(file.hasValue());
      QCOMPARE(valuesIn(file->image), expected);
    };
    check(2, std::vector<std::uint8_t>{1, 2, 255}, {1, 2, 255});
    check(256, std::vector<std::int8_t>{1, -2, -128}, {1, -2, -128});
    check(512, std::vector<std::uint16_t>{1, 2, 65535}, {1, 2, 65535});
    check(8, std::vector<std::int32_t>{1, -2, 100000}, {1, -2, 100000});
    check(768, std::vector<std::uint32_t>{1, 2, 100000}, {1, 2, 100000});
    check(1024, std::vector<std::int64_t>{1, -2, 100000}, {1, -2, 100000});
    check(16, std::vector<float>{1.5f, -2.0f, 1e5f}, {1.5, -2.0, 1e5});
    check(64, std::vector<double>{1.5, -2.0, 1e5}, {1.5, -2.0, 1e5});
  }

  void scaled() {
    const auto scaledBy = [](float slope, float intercept) {
      return readNifti(small().put(112, slope).put(116, intercept).samples(4, kNiftiSamples).bytes());
    };
    QCOMPARE(valuesIn(scaledBy(2.0f, -1024.0f)->image), (std::vector<double>{-1024, -1022, -1028, -1018, -424, -3024}));
    QCOMPARE(valuesIn(scaledBy(0.0f, 5.0f)->image), kNiftiValues);  // "nothing is scaled"
    QCOMPARE(valuesIn(scaledBy(0.5f, 0.25f)->image), (std::vector<double>{0.25, 0.75, -0.75, 1.75, 150.25, -499.75}));
  }

  // The rows of the sform map to positions; it has priority over the qform.
  void sform() {
    NiftiBytes bytes = small();
    bytes.put<std::int16_t>(252, 1).put<std::int16_t>(254, 1);
    const float rows[3][4] = {{0.5f, 0.1f, 0.0f, 10.0f}, {0.0f, 2.0f, -0.3f, 20.0f}, {0.0f, 0.2f, 4.0f, 30.0f}};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t k = 0; k < 4; ++k) bytes.put(280 + 16 * r + 4 * k, rows[r][k]);
    const Result<ImageFile> file = readNifti(bytes.samples(4, kNiftiSamples).bytes());
    QVERIFY(file.hasValue());
    QVERIFY((file->image.grid().position({1, 2, 1}) - Vec3(-10.7, -23.7, 34.4)).norm() < 1e-5);
  }

  // A quarter turn about z: b = c = 0, d = a = cos 45°. With qfac -1 the third axis is turned round.
  void qform() {
    for (const float qfac : {1.0f, -1.0f}) {
      NiftiBytes bytes = small();
      bytes.put<std::int16_t>(252, 1).put(264, static_cast<float>(std::sqrt(0.5))).put(268, 7.0f).put(76, qfac);
      const Result<ImageFile> file = readNifti(bytes.samples(4, kNiftiSamples).bytes());
      QVERIFY(file.hasValue());
      // (x, y, z) there is (-2 j, 0.5 i, ±4 k), and 7 further along x.
      QVERIFY((file->image.grid().position({1, 1, 1}) - Vec3(-5.0, -0.5, 4.0 * static_cast<double>(qfac))).norm() <
              1e-5);
    }
  }

  // A half turn about (1, 0, -1): b = -d = sqrt(1/2) in single precision, whose squares add up to less than 1. It takes
  // x to -z, y to -y and z to -x.
  void halfTurn() {
    const auto part = static_cast<float>(std::sqrt(0.5));
    NiftiBytes bytes = small();
    bytes.put<std::int16_t>(252, 1).put(256, part).put(264, -part).put(268, 7.0f).put(76, 1.0f);
    const Result<ImageFile> file = readNifti(bytes.samples(4, kNiftiSamples).bytes());
    QVERIFY(file.hasValue());
    // (x, y, z) there is (7 - 4 k, -2 j, -0.5 i).
    QVERIFY((file->image.grid().position({100, 200, 100}) - Vec3(393.0, 400.0, -50.0)).norm() < 1e-9);
  }

  void inTime() {
    const Result<ImageFile> file =
        readNifti(NiftiBytes().size({2, 1, 1, 3}).spacing(1, 1, 1).samples(4, kNiftiSamples).bytes());
    QVERIFY(file.hasValue());
    QCOMPARE(valuesIn(file->image), (std::vector<double>{0, 1}));
    QVERIFY(hasRemark(*file, ImageRemark::Kind::FirstOfSeveral));
  }

  // Files that nibabel has written: of NIfTI-2, in either order of bytes, by sform and by qform. The map is x' = 5 - 2
  // y, y' = x / 2 - 7, z' = 3 + 4 z, whose first two axes are opposite to those of images.
  void secondVersion() {
    for (const char* text :
         {"H4sIAAAAAAACA5NhYmDI0zZi4OWS4mJhEGBgZoAAJigN4zMSSeMHH+wh9AMozeAAoQQcUOUxaQUmbOYMbsCEReyMdX3avAXPoO4X"
          "gfpb5gCE5nBAU34AlQtT/wCH/2UOYBeHhS/C/FfMxPqCkeHff2YGHUaJPwAQQJ0pLAIAAA==",
          "H4sIAAAAAAACA2NgYJLJ0zZi4OWS4mJgYRBggABmKM2ExmckksYA9h+g9AMI7QAVdxBAk8dBQ52jgMof1ABrWNg/WzAvrd76jIMI"
          "hH9ABhoOHKjqDqDpg6mHhR86gJmDDmDhi24+MEpfEeuP//8YmBl1/kgAAF2A2G4sAgAA"}) {
      const std::string bytes = QByteArray::fromBase64(text).toStdString();
      for (const std::string& each : {bytes, *inflated(bytes, 1000)}) {
        QVERIFY(looksLikeNifti(each));
        const Result<ImageFile> file = readNifti(each);
        QVERIFY(file.hasValue());
        QCOMPARE(valuesIn(file->image), kNiftiValues);
        QVERIFY(file->hasLabels);
        const ImageGrid& grid = file->image.grid();
        QVERIFY((grid.position({0, 0, 0}) - Vec3(-5, 7, 3)).norm() < 1e-6);
        QVERIFY((grid.position({1, 2, 1}) - Vec3(-1, 6.5, 7)).norm() < 1e-6);
        readDamaged(each, [](const std::string& other) { return readNifti(other); });
      }
    }
  }

  void refusals() {
    QVERIFY(!readNifti(small().samples<std::int16_t>(4, {1, 2}).bytes()));
    QVERIFY(!readNifti(small().samples(128, kNiftiSamples).bytes()));
    QVERIFY(!readNifti(NiftiBytes().size({-2, 3, 1}).samples(4, kNiftiSamples).bytes()));
    QVERIFY(!readNifti(NiftiBytes().size({30000, 30000, 30000}).samples(4, kNiftiSamples).bytes()));
    QVERIFY(!readNifti(small().put(108, 1e30f).samples(4, kNiftiSamples).bytes()));
    QVERIFY(!readNifti(small().put(108, std::nanf("")).samples(4, kNiftiSamples).bytes()));
    QVERIFY(
        !readNifti(small().put<std::int16_t>(254, 1).samples(4, kNiftiSamples).bytes()));  // a map to a single position
    QVERIFY(!readNifti("\x1f\x8b\x08"));
    QVERIFY(!readNifti(""));
    std::string pair = small().samples(4, kNiftiSamples).bytes();
    pair.replace(344, 4, std::string("ni1\0", 4));
    QVERIFY(readNifti(pair).error().code == ErrorCode::Unsupported);
  }

  void damaged() {
    const std::string bytes = small().samples(4, kNiftiSamples).bytes();
    readDamaged(bytes, [](const std::string& each) { return readNifti(each); });
    readDamaged(packed(bytes, true), [](const std::string& each) { return readNifti(each); });
  }

  // A sform and a qform that contradict each other: the sform counts, which is said. Forms for different spaces may
  // differ, as long as neither is mirrored.
  void contradictions() {
    const auto read = [](int sform, float x, float shift) {
      NiftiBytes bytes = small();
      bytes.put<std::int16_t>(252, 1).put<std::int16_t>(254, static_cast<std::int16_t>(sform));
      bytes.put(280, x).put(292, shift).put(300, 2.0f).put(320, 4.0f);
      return readNifti(bytes.samples(4, kNiftiSamples).bytes());
    };
    QVERIFY(!hasRemark(*read(1, 0.5f, 0.0f), ImageRemark::Kind::Contradiction));
    QVERIFY(!hasRemark(*read(4, 0.5f, 50.0f), ImageRemark::Kind::Contradiction));
    for (const auto& file : {read(1, 0.5f, 50.0f), read(1, -0.5f, 0.0f), read(4, -0.5f, 0.0f)})
      QVERIFY(hasRemark(*file, ImageRemark::Kind::Contradiction));
    QCOMPARE(read(1, -0.5f, 0.0f)->image.grid().position({1, 0, 0}), Vec3(0.5, 0.0, 0.0));
    // A sform that is stated but empty.
    const Result<ImageFile> empty = readNifti(
        small().put<std::int16_t>(252, 1).put<std::int16_t>(254, 2).put(268, 7.0f).samples(4, kNiftiSamples).bytes());
    QVERIFY(empty.hasValue());
    QCOMPARE(empty->image.grid().position({1, 1, 0}), Vec3(-7.5, -2.0, 0.0));
  }

  // Names of labels are in an extension between header and samples.
  void namesOfLabels() {
    std::string table =
        "<?xml version=\"1.0\"?><CaretExtension><VolumeInformation Index=\"0\"><LabelTable>"
        "<Label Key=\"1\" Red=\"1\">spleen</Label><Label Key=\"300\"><![CDATA[kidney left]]></Label>"
        "</LabelTable></VolumeInformation></CaretExtension>";
    table.resize(504, '\0');
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      std::string bytes =
          small(order).put(108, 864.0f).samples(4, std::vector<std::int16_t>{0, 1, 1, 0, 300, 0}).bytes();
      std::string extension("\1\0\0\0", 4);
      appendNumber<std::int32_t>(extension, 512, order);
      appendNumber<std::int32_t>(extension, 0, order);
      bytes.replace(348, 4, extension + table);
      for (const std::string& each : {bytes, packed(bytes, true)}) {
        const Result<ImageFile> file = readNifti(each);
        QVERIFY(file.hasValue());
        QVERIFY(file->hasLabels);
        QCOMPARE(file->labels, (std::vector<ImageLabel>{{1.0, "spleen"}, {300.0, "kidney left"}}));
        QCOMPARE(file->image.value(4), 300.0);
      }
      readDamaged(bytes.substr(0, 600), [](const std::string& damaged) { return readNifti(damaged); });
    }
  }
};

HANDWHEEL_TEST(NiftiReaderTest)
#include "NiftiReaderTest.moc"
