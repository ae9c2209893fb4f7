// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NrrdReader.h"

#include "ImageBytes.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const std::string kHead =
    "NRRD0004\n# made by hand\ntype: short\ndimension: 3\nsizes: 2 3 2\n"
    "space: left-posterior-superior\nspace directions: (0.5,0,0) (0,0.6,0) (0,0.1,1.5)\nspace origin: (1,2,-3)\n"
    "who:=somebody\n";
const std::vector<std::int16_t> kSamples{0, 1, -2, 3, 4, 5, 6, -7, 8, 300, 10, -1000};
const std::vector<double> kValues(kSamples.begin(), kSamples.end());

Result<ImageFile> read(const std::string& bytes, std::map<std::string, std::string> files = {}) {
  return readNrrd(bytes, beside(std::move(files)));
}

}  // namespace

class NrrdReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void encodings_data() {
    QTest::addColumn<QByteArray>("fields");
    QTest::addColumn<QByteArray>("data");
    const auto row = [](const char* name, const QByteArray& fields, const std::string& data) {
      QTest::newRow(name) << fields << QByteArray(data.data(), static_cast<int>(data.size()));
    };
    const std::string little = bytesOfNumbers(kSamples);
    row("raw", "endian: little\nencoding: raw\n", little);
    row("big", "endian: big\nencoding: raw\n", bytesOfNumbers(kSamples, std::endian::big));
    row("gzip", "endian: little\nencoding: gzip\n", packed(little, true));
    row("text", "encoding: ascii\n", "0 1 -2\n3 4 5 6\t-7 8 300 10 -1000");
    row("from behind", "endian: little\nencoding: raw\nbyte skip: -1\n", "whatever" + little);
    row("skipped", "endian: little\nencoding: raw\nline skip: 2\nbyteskip: 3\n", "a line\nb\n123" + little);
    row("skipped when unpacked", "endian: little\nencoding: gz\nbyte skip: 3\n", packed("123" + little, true));
  }
  void encodings() {
    QFETCH(QByteArray, fields);
    QFETCH(QByteArray, data);
    const Result<ImageFile> attached = read(kHead + fields.toStdString() + "\n" + data.toStdString());
    const Result<ImageFile> detached =
        read(kHead + fields.toStdString() + "data file: a.raw\n", {{"a.raw", data.toStdString()}});
    for (const Result<ImageFile>* file : {&attached, &detached}) {
      QVERIFY(file->hasValue());
      const ImageVolume& image = file->value().image;
      QCOMPARE(valuesIn(image), kValues);
      QCOMPARE(image.grid().origin, Vec3(1, 2, -3));
      QCOMPARE(image.grid().position({1, 2, 1}), Vec3(1.5, 3.3, -1.5));
      QVERIFY(image.isWhole() && file->value().remarks.empty());
    }
  }

  // All types of numbers are read, under all of their names.
  void types() {
    const auto check = [](const char* name, const std::string& data, const std::vector<double>& expected) {
      const Result<ImageFile> file = read(std::string("NRRD0001\ndimension: 3\nsizes: 3 1 1\nspacings: 1 1 1\ntype: ") +
                                          name + "\nendian: little\nencoding: raw\n\n" + data);
      QVERIFY2(file.hasValue(), name);
      QCOMPARE(valuesIn(file->image), expected);
    };
    check("signed char", bytesOfNumbers<std::int8_t>({-1, 2, -128}), {-1, 2, -128});
    check("uint8_t", bytesOfNumbers<std::uint8_t>({1, 2, 255}), {1, 2, 255});
    check("signed short int", bytesOfNumbers<std::int16_t>({1, -2, -3000}), {1, -2, -3000});
    check("unsigned short", bytesOfNumbers<std::uint16_t>({1, 2, 65535}), {1, 2, 65535});
    check("int", bytesOfNumbers<std::int32_t>({1, -2, 100000}), {1, -2, 100000});
    check("unsigned int", bytesOfNumbers<std::uint32_t>({1, 2, 100000}), {1, 2, 100000});
    check("long long", bytesOfNumbers<std::int64_t>({1, -2, 100000}), {1, -2, 100000});
    check("uint64", bytesOfNumbers<std::uint64_t>({1, 2, 100000}), {1, 2, 100000});
    check("float", bytesOfNumbers<float>({1.5f, -2.25f, 1e6f}), {1.5, -2.25, 1e6});
    check("double", bytesOfNumbers<double>({1.5, -2.25, 1e6}), {1.5, -2.25, 1e6});
  }

  // Positions from the right, the front and the head are ours with two signs reversed; units count.
  void spaces() {
    const Result<ImageFile> file = read(
        "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 1 1 2\nspace: RAS\nspace directions: ( 1, 0, 0 ) (0,2,0) "
        "(0,0,3)\nspace origin: (10,20,30)\nspace units: \"cm\" \"cm\" \"cm\"\nencoding: raw\n\n\1\2");
    QVERIFY(file.hasValue());
    QCOMPARE(file->image.grid().origin, Vec3(-100, -200, 300));
    QCOMPARE(file->image.grid().steps.col(1), Vec3(0, -20, 0));
  }

  void axes() {
    const Result<ImageFile> colours = read(
        "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 2 1 1\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
        "encoding: raw\n\n\1\2\3\4\5\6");
    QVERIFY(colours.hasValue());
    QCOMPARE(valuesIn(colours->image), (std::vector<double>{1, 4}));
    QVERIFY(hasRemark(*colours, ImageRemark::Kind::FirstOfSeveral));
    // Images one after the other: the first is read.
    const Result<ImageFile> film =
        read("NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 1 1 3\nspacings: 1 1 1 nan\nencoding: raw\n\n\1\2\3\4\5\6");
    QVERIFY(film.hasValue());
    QCOMPARE(valuesIn(film->image), (std::vector<double>{1, 2}));
    QVERIFY(hasRemark(*film, ImageRemark::Kind::FirstOfSeveral));
    const Result<ImageFile> flat = read("NRRD0001\ntype: uchar\ndimension: 2\nsizes: 2 1\nencoding: raw\n\n\1\2");
    QVERIFY(flat.hasValue());
    QCOMPARE(flat->image.grid().size, (std::array<int, 3>{2, 1, 1}));
    QVERIFY(hasRemark(*flat, ImageRemark::Kind::NoSpacing));
    // Numbers that are none count as the least value.
    const Result<ImageFile> odd =
        read("NRRD0001\ntype: float\ndimension: 3\nsizes: 3 1 1\nspacings: 1 1 1\nencoding: txt\n\n4.5 nan -2.5");
    QVERIFY(odd.hasValue());
    QCOMPARE(valuesIn(odd->image), (std::vector<double>{4.5, -2.5, -2.5}));
    QVERIFY(hasRemark(*odd, ImageRemark::Kind::NotNumbers));
  }

  void refusals_data() {
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray start = "NRRD0004\ntype: short\n";
    QTest::newRow("another") << QByteArray("NRRX0004\n\n");
    QTest::newRow("no sizes") << start + "dimension: 3\nencoding: raw\n\n";
    QTest::newRow("a word") << start + "dimension: 3\nsizes: 2 x 2\nencoding: raw\n\n";
    QTest::newRow("negative") << start + "dimension: 3\nsizes: 2 -2 2\nencoding: raw\n\n";
    QTest::newRow("too many") << start + "dimension: 3\nsizes: 65000 65000 65000\nencoding: raw\n\n";
    QTest::newRow("too long") << start + "dimension: 3\nsizes: 99999999999 1 1\nencoding: raw\n\n";
    QTest::newRow("a bomb") << start + "dimension: 3\nsizes: 1000 1000 1000\nencoding: gzip\n\n\x1f\x8b";
    QTest::newRow("short") << start + "dimension: 3\nsizes: 2 2 2\nencoding: raw\n\n123";
    QTest::newRow("encoding") << start + "dimension: 3\nsizes: 1 1 1\nencoding: bzip2\n\n12";
    QTest::newRow("five axes") << start + "dimension: 5\nsizes: 1 1 1 1 1\nencoding: raw\n\n12";
    QTest::newRow("flat") << start +
                                 "dimension: 3\nsizes: 1 1 1\nspace directions: (1,0,0) (1,0,0) (0,0,1)\n"
                                 "encoding: raw\n\n12";
    QTest::newRow("type") << QByteArray("NRRD0004\ntype: block\ndimension: 3\nsizes: 1 1 1\nencoding: raw\n\n12");
    QTest::newRow("missing data") << start + "dimension: 3\nsizes: 1 1 1\nencoding: raw\ndata file: b.raw\n";
    QTest::newRow("a list") << start + "dimension: 3\nsizes: 1 1 1\nencoding: raw\ndata file: LIST\n";
    QTest::newRow("no field") << start + "nonsense\n\n";
  }
  void refusals() {
    QFETCH(QByteArray, bytes);
    QVERIFY(!read(bytes.toStdString()));
  }

  void damaged() {
    readDamaged(kHead + "endian: little\nencoding: gzip\n\n" + packed(bytesOfNumbers(kSamples), true),
                [](const std::string& bytes) { return read(bytes); });
  }
};

HANDWHEEL_TEST(NrrdReaderTest)
#include "NrrdReaderTest.moc"
