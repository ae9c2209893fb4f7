// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/MetaImageReader.h"

#include "ImageBytes.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const std::string kMetaHead =
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nOffset = 1 2 -3\n"
    "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nElementSpacing = 0.5 0.6 1.5\nDimSize = 2 3 1\n";
const std::vector<std::int16_t> kMetaSamples{0, 1, -2, 3, 300, -1000};
const std::vector<double> kMetaValues(kMetaSamples.begin(), kMetaSamples.end());

Result<ImageFile> readMeta(const std::string& bytes, std::map<std::string, std::string> files = {}) {
  return readMetaImage(bytes, beside(std::move(files)));
}

}  // namespace

class MetaImageReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void encodings_data() {
    QTest::addColumn<QByteArray>("fields");
    QTest::addColumn<QByteArray>("data");
    const auto row = [](const char* name, const QByteArray& fields, const std::string& data) {
      QTest::newRow(name) << fields << QByteArray(data.data(), static_cast<int>(data.size()));
    };
    const std::string little = bytesOfNumbers(kMetaSamples);
    row("plain", "BinaryDataByteOrderMSB = False\nElementType = MET_SHORT\n", little);
    row("big", "ElementByteOrderMSB = True\nElementType = MET_SHORT\n", bytesOfNumbers(kMetaSamples, std::endian::big));
    row("packed", "CompressedData = True\nCompressedDataSize = 30\nElementType = MET_SHORT\n", packed(little, false));
    row("text", "BinaryData = False\nElementType = MET_SHORT\n", "0 1 -2 3 300 -1000\n");
    row("float", "ElementType = MET_FLOAT\n", bytesOfNumbers<float>({0, 1, -2, 3, 300, -1000}));
    row("behind a header", "HeaderSize = 4\nElementType = MET_SHORT\n", "abcd" + little);
    row("from behind", "HeaderSize = -1\nElementType = MET_SHORT\n", "abcdefg" + little);
  }
  void encodings() {
    QFETCH(QByteArray, fields);
    QFETCH(QByteArray, data);
    const Result<ImageFile> local =
        readMeta(kMetaHead + fields.toStdString() + "ElementDataFile = LOCAL\n" + data.toStdString());
    const Result<ImageFile> apart =
        readMeta(kMetaHead + fields.toStdString() + "ElementDataFile = b.raw\r\n", {{"b.raw", data.toStdString()}});
    for (const Result<ImageFile>* file : {&local, &apart}) {
      QVERIFY(file->hasValue());
      const ImageVolume& image = file->value().image;
      QCOMPARE(valuesIn(image), kMetaValues);
      QCOMPARE(image.grid().origin, Vec3(1, 2, -3));
      // The first axis of the samples goes along y, the second back along x.
      QCOMPARE(image.grid().position({1, 2, 0}), Vec3(1 - 1.2, 2.5, -3));
      QVERIFY(file->value().remarks.empty());
    }
  }

  void channels() {
    const Result<ImageFile> file = readMeta(
        "NDims = 3\nDimSize = 2 1 1\nElementNumberOfChannels = 2\nElementType = MET_UCHAR\nElementDataFile = "
        "LOCAL\n\1\2\3\4");
    QVERIFY(file.hasValue());
    QCOMPARE(valuesIn(file->image), (std::vector<double>{1, 3}));
    QVERIFY(hasRemark(*file, ImageRemark::Kind::FirstOfSeveral) && hasRemark(*file, ImageRemark::Kind::NoSpacing));
  }

  void inTime() {
    const Result<ImageFile> file = readMeta(
        "NDims = 4\nDimSize = 2 1 1 2\nElementSpacing = 1 1 1 1\nElementType = MET_UCHAR\nElementDataFile = "
        "LOCAL\n\1\2\3\4");
    QVERIFY(file.hasValue());
    QCOMPARE(valuesIn(file->image), (std::vector<double>{1, 2}));
    QVERIFY(hasRemark(*file, ImageRemark::Kind::FirstOfSeveral));
  }

  void refusals_data() {
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray start = "ObjectType = Image\nNDims = 3\n", end = "ElementDataFile = LOCAL\n12";
    QTest::newRow("another") << QByteArray("solid\n");
    QTest::newRow("a tube") << QByteArray("ObjectType = Tube\nNDims = 3\n") + end;
    QTest::newRow("no data") << start + "DimSize = 1 1 1\nElementType = MET_SHORT\n";
    QTest::newRow("no size") << start + "ElementType = MET_SHORT\n" + end;
    QTest::newRow("a size of 0") << start + "DimSize = 1 0 1\nElementType = MET_SHORT\n" + end;
    QTest::newRow("half a size") << start + "DimSize = 1 1.5 1\nElementType = MET_SHORT\n" + end;
    QTest::newRow("too many") << start + "DimSize = 60000 60000 60000\nElementType = MET_SHORT\n" + end;
    QTest::newRow("short") << start + "DimSize = 1 2 1\nElementType = MET_SHORT\n" + end;
    QTest::newRow("type") << start + "DimSize = 1 1 1\nElementType = MET_OTHER\n" + end;
    QTest::newRow("no file") << start + "DimSize = 1 1 1\nElementType = MET_SHORT\nElementDataFile = a.raw\n";
    QTest::newRow("files") << start + "DimSize = 1 1 1\nElementType = MET_SHORT\nElementDataFile = a%03d 1 2 1\n";
    QTest::newRow("a bomb") << start + "DimSize = 1000 1000 1000\nCompressedData = True\nElementType = MET_SHORT\n" +
                                   end;
    QTest::newRow("five axes") << QByteArray("NDims = 5\n") + end;
    QTest::newRow("no field") << start + "nonsense\n" + end;
  }
  void refusals() {
    QFETCH(QByteArray, bytes);
    QVERIFY(!readMeta(bytes.toStdString()));
  }

  // 8 TB by its header: refused before anything of it is unpacked.
  void moreThanTheMemory() {
    const Result<ImageFile> file = readMeta(
        "NDims = 3\nDimSize = 1000 1000 1000\nElementNumberOfChannels = 1000\nElementType = MET_DOUBLE\n"
        "CompressedData = True\nElementDataFile = LOCAL\n" +
        packed(std::string(1000, '\0'), true));
    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::FileTooLarge);
    QCOMPARE(file.error().arguments.at(0), "bytes of the unpacked image");
    QCOMPARE(file.error().arguments.at(1), "8000000000000");
  }

  void damaged() {
    readDamaged(kMetaHead + "CompressedData = True\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
                    packed(bytesOfNumbers(kMetaSamples), false),
                [](const std::string& bytes) { return readMeta(bytes); });
  }
};

HANDWHEEL_TEST(MetaImageReaderTest)
#include "MetaImageReaderTest.moc"
