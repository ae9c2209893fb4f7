// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/RawImageReader.h"

#include "ImageBytes.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

class RawImageReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void described() {
    const std::string data = "abc" + bytesOfNumbers<std::uint16_t>({0, 1000, 40000, 7}, std::endian::big);
    const Result<ImageFile> file = readRawImage(
        R"({"raw": "a.raw", "size": [2, 1, 2], "spacing": [0.5, 1, 2], "type": "uint16", "endian": "big", "skip": 3,
            "origin": [1, 2, 3], "directions": [[0, 1, 0], [0, 0, 1], [1, 0, 0]], "slope": 2, "intercept": -1000})",
        beside({{"a.raw", data}}));
    QVERIFY(file.hasValue());
    QCOMPARE(valuesIn(file->image), (std::vector<double>{-1000, 1000, 79000, -986}));
    QCOMPARE(file->image.grid().position({1, 0, 1}), Vec3(3.0, 2.5, 3.0));
    QVERIFY(file->remarks.empty());
  }

  void recognised() {
    QVERIFY(looksLikeRawImage(R"( {"type": "int8", "size": [1, 1, 1], "raw": "a"})"));
    QVERIFY(!looksLikeRawImage(R"({"type": "eggs", "raw": true})"));
    QVERIFY(!looksLikeRawImage("solid raw size type"));
  }

  void refusals_data() {
    QTest::addColumn<QByteArray>("description");
    QTest::newRow("no JSON") << QByteArray("{\"raw\": ");
    QTest::newRow("no object") << QByteArray("[1]");
    QTest::newRow("no file") << QByteArray(R"({"size": [1, 1, 1], "type": "int8"})");
    QTest::newRow("another file") << QByteArray(R"({"raw": "b", "size": [1, 1, 1], "type": "int8"})");
    QTest::newRow("no size") << QByteArray(R"({"raw": "a", "type": "int8"})");
    QTest::newRow("two sizes") << QByteArray(R"({"raw": "a", "size": [1, 1], "type": "int8"})");
    QTest::newRow("half a size") << QByteArray(R"({"raw": "a", "size": [1, 1, 0.5], "type": "int8"})");
    QTest::newRow("too many") << QByteArray(R"({"raw": "a", "size": [60000, 60000, 60000], "type": "int8"})");
    QTest::newRow("short") << QByteArray(R"({"raw": "a", "size": [1, 1, 9], "type": "int8"})");
    QTest::newRow("type") << QByteArray(R"({"raw": "a", "size": [1, 1, 1], "type": "int9"})");
    QTest::newRow("order") << QByteArray(R"({"raw": "a", "size": [1, 1, 1], "type": "int8", "endian": "middle"})");
    QTest::newRow("slope") << QByteArray(R"({"raw": "a", "size": [1, 1, 1], "type": "int8", "slope": "steep"})");
    QTest::newRow("flat") << QByteArray(R"({"raw": "a", "size": [1, 1, 1], "type": "int8", "spacing": [1, 0, 1]})");
    QTest::newRow("skip") << QByteArray(R"({"raw": "a", "size": [1, 1, 1], "type": "int8", "skip": 99})");
  }
  void refusals() {
    QFETCH(QByteArray, description);
    QVERIFY(!readRawImage(description.toStdString(), beside({{"a", "12"}})));
  }
};

HANDWHEEL_TEST(RawImageReaderTest)
#include "RawImageReaderTest.moc"
