// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReadDescription.h"
#include "TestClass.h"

#include <QTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const QByteArray kFloatVertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const QByteArray kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const QByteArray kRows = "0 0 0\n1 0 0\n0 1 0\n";

QByteArray text(const QByteArray& elements, const QByteArray& body) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

Bytes binary(std::endian order, const QByteArray& elements) {
  Bytes bytes(order);
  bytes.text("ply\nformat binary_" + QByteArray(order == std::endian::big ? "big" : "little") + "_endian 1.0\n");
  return bytes.text(elements + "end_header\n");
}

Bytes binaryTriangle(std::endian order, const QByteArray& elements = kFloatVertices + kFaces) {
  Bytes bytes = binary(order, elements);
  return bytes.all<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}).add<std::uint8_t>(3).all<std::int32_t>({0, 1, 2});
}

}  // namespace

class PlyReaderTest : public QObject {
  Q_OBJECT
 private slots:
  // Lost properties without a name of ours keep that of the file, once. An empty one says that there are more: no plain
  // word.
  void namesWhatIsLost() {
    const QByteArray vertices =
        QByteArray(kFloatVertices)
            .replace("element vertex 3\n", "element vertex 3\nproperty uchar red\nproperty float quality\n");
    const QByteArray faces = QByteArray(kFaces) + "property int flags\nproperty float quality\nproperty int \x1b[31m\n";
    const QByteArray bytes = text(vertices + faces, "1 2 0 0 0\n1 2 1 0 0\n1 2 0 1 0\n3 0 1 2 5 6 7\n");
    const auto file = readMesh({bytes.data(), static_cast<std::size_t>(bytes.size())}, "a.ply", {});
    QVERIFY(file.hasValue());
    QCOMPARE(file->lostOther, (std::vector<std::string>{"quality", "flags", ""}));
    QVERIFY(!file->hasUnit);
  }

  // The first five have their names; that there are more is said even so.
  void namesTheFirstOfManyLosses_data() {
    QTest::addColumn<int>("count");
    QTest::newRow("five") << 5;
    QTest::newRow("six") << 6;
  }
  void namesTheFirstOfManyLosses() {
    QFETCH(int, count);
    QByteArray properties, values;
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i) {
      const QByteArray name = "p" + QByteArray::number(i);
      properties += "property int " + name + "\n";
      values += " 7";
      names.push_back(i < 5 ? name.toStdString() : std::string());
    }
    const QByteArray bytes = text(kFloatVertices + kFaces + properties, kRows + "3 0 1 2" + values + "\n");
    const auto file = readMesh({bytes.data(), static_cast<std::size_t>(bytes.size())}, "a.ply", {});
    QVERIFY(file.hasValue());
    QCOMPARE(file->lostOther, names);
  }

  void readsText_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("strict");
    QTest::addColumn<QString>("partial");
    const auto row = [](const char* name, const QByteArray& bytes, const QString& strict, const QString& partial = {}) {
      QTest::newRow(name) << bytes << strict << (partial.isNull() ? strict : partial);
    };
    const QByteArray plain = text(kFloatVertices + kFaces, kRows + "3 0 1 2\n");

    row("triangle", plain, kTriangle);
    row("Windows lines", QByteArray(plain).replace("\n", "\r\n"), kTriangle);
    row("old Mac lines", QByteArray(plain).replace("\n", "\r"), kTriangle);
    row("white space", QByteArray(plain).replace(" ", " \t ").replace("\n", " \n\n"), kTriangle);
    row("comments", QByteArray(plain).replace("element", "comment element\nobj_info x\nelement"), kTriangle);
    row("vertex_index", QByteArray(plain).replace("indices", "index"), kTriangle);
    row("list of another name", QByteArray(plain).replace("vertex_indices", "corners"), kTriangle);
    row("double", QByteArray(plain).replace("float", "double"), kTriangle);
    row("polygon",
        text(QByteArray(kFloatVertices).replace("3", "4") + kFaces, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"),
        "0 0 0, 1 0 0, 1 1 0, 0 1 0 | 0 1 2, 0 2 3");
    row("unknown elements",
        text("element camera 1\nproperty float f\n" + kFloatVertices +
                 "element edge 2\nproperty int a\nproperty int b\n" + kFaces,
             "3.5\n" + kRows + "0 1\n1 2\n3 0 1 2\n"),
        kTriangle + " - Lines Other");
    row("more properties",
        text("element vertex 3\nproperty uchar red\nproperty float x\nproperty float nx\nproperty float z\n"
             "property list uchar float weights\nproperty float y\nelement face 1\nproperty uchar flags\n"
             "property list uchar float texcoord\nproperty list uchar int vertex_indices\n",
             "255 0 1 0 0 0\n255 1 1 0 2 5 nan 0\n255 0 1 0 0 1\n7 2 0.5 0.5 3 0 1 2\n"),
        kTriangle + " - Colour Normals TextureCoordinates Other");
    row("elements without rows",
        text(kFloatVertices + "element edge 0\nproperty int a\n" + kFaces, kRows + "3 0 1 2\n"), kTriangle);
    row("element without properties",
        text("element nothing 9999999999\n" + kFloatVertices + kFaces, kRows + "3 0 1 2\n"), kTriangle);
    row("faces before vertices", text(kFaces + kFloatVertices, "3 0 1 2\n" + kRows), kTriangle);
    // 0 1 2 3 is two triangles, the second turned; then a strip of one; a repeated corner stays, as written.
    row("strips",
        text(QByteArray(kFloatVertices).replace("3", "4") +
                 "element tristrips 1\nproperty list int int vertex_indices\n",
             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n12 0 1 2 3 -1 -1 3 2 1 -1 0 0\n"),
        "PolygonTooSmall(2) line 14", "0 0 0, 1 0 0, 0 1 0, 1 1 0 | 0 1 2, 2 1 3, 3 2 1 ! PolygonTooSmall(2) line 14");
    row("strip with repeated corner",
        text(kFloatVertices + "element tristrips 1\nproperty list int int vertex_indices\n", kRows + "5 0 1 2 2 -1\n"),
        "0 0 0, 1 0 0, 0 1 0 | 0 1 2, 2 1 2");

    // Rows that run on over lines, as most programs read them: their properties tell where they end.
    row("all on one line", text(kFloatVertices + kFaces, "0 0 0 1 0 0 0 1 0 3 0 1 2\n"), kTriangle);
    row("a number per line", text(kFloatVertices + kFaces, "0\n0\n0\n1\n0\n0\n0\n1\n0\n3\n0\n1\n2"), kTriangle);
    row("only vertices on one line", text(kFloatVertices + kFaces, "0 0 0 1 0 0 0 1 0\n3 0 1 2\n"), kTriangle);
    row("all on one line, not finite",
        text(kFloatVertices + QByteArray(kFaces).replace("1", "2"), "0 0 0 1 nan 0 0 1 0 3 0 2 2 3 0 1 2\n"),
        "NumberNotFinite(nan) line 10",
        "0 0 0, 0 1 0 | 0 1 1 ! NumberNotFinite(nan) line 10; VertexUnreadable(1) line 10");
    row("64 bits", QByteArray(plain).replace("int vertex", "int64 vertex").replace("uchar", "uint64"), kTriangle);

    row("no end_header", "ply\nformat ascii 1.0\nelement vertex 3\n", "HeaderMalformed(end_header) line 4");
    row("no format", "ply\nelement vertex 0\nend_header\n", "HeaderMalformed(format) line 3");
    row("unknown format", "ply\nformat binary 1.0\nend_header\n", "TypeUnknown(binary) line 2");
    row("unknown type", QByteArray(plain).replace("float y", "half y"), "TypeUnknown(half) line 5");
    row("unknown word", QByteArray(plain).replace("element face", "elephant face"),
        "TokenUnexpected(end_header,elephant) line 7");
    row("property of nothing", "ply\nformat ascii 1.0\nproperty float x\nend_header\n",
        "HeaderMalformed(element) line 3");
    row("negative count", QByteArray(plain).replace("vertex 3", "vertex -3"), "TokenUnexpected(a count,-3) line 3");
    row("no z", QByteArray(plain).replace("float z", "float w"), "HeaderMalformed(property z) line 9");
    row("no corners", QByteArray(plain).replace("list uchar int vertex_indices", "int vertex_indices"),
        "HeaderMalformed(property vertex_indices) line 9");
    row("header only", "ply\nformat ascii 1.0\nend_header\n", "NoTriangles");
    row("points only", text(kFloatVertices, kRows), "NoTriangles");

    row("fewer faces than announced", QByteArray(plain).replace("face 1", "face 3"), "DataTruncated(faces,3,1) line 14",
        kTriangle + " ! DataTruncated(faces,3,1) line 14");
    row("vertices that never come", QByteArray(plain).replace("vertex 3", "vertex 4000000000000"),
        "TokenUnexpected(the end of the line,2) line 13", "NothingReadable line 13");
    row("more faces than announced", plain + "3 2 1 0\n",
        kTriangle + QString(" ! CountMismatch(bytes,%1,%2) line 14").arg(plain.size()).arg(plain.size() + 8));
    row("index beyond", QByteArray(plain).replace("face 1", "face 2") + "3 0 1 3\n", "IndexOutOfRange(3,3) line 14",
        kTriangle + " ! IndexOutOfRange(3,3) line 14");
    row("negative index", QByteArray(plain).replace("face 1", "face 2") + "3 0 1 -1\n", "IndexOutOfRange(-1,3) line 14",
        kTriangle + " ! IndexOutOfRange(-1,3) line 14");
    row("two corners", QByteArray(plain).replace("face 1", "face 2") + "2 0 1\n", "PolygonTooSmall(2) line 14",
        kTriangle + " ! PolygonTooSmall(2) line 14");
    row("negative list", QByteArray(plain).replace("face 1", "face 2") + "-3 0 1\n",
        "TokenUnexpected(a count,-3) line 14", kTriangle + " ! TokenUnexpected(a count,-3) line 14");
    row("list that is longer than its line", QByteArray(plain).replace("face 1", "face 2") + "2000000000 0 1 2\n",
        "TokenUnexpected(a whole number,) line 14", kTriangle + " ! TokenUnexpected(a whole number,) line 14");
    row("a row too long", QByteArray(plain).replace("face 1", "face 2") + "3 0 1 2 9\n",
        "TokenUnexpected(the end of the line,9) line 14",
        kTriangle + " ! TokenUnexpected(the end of the line,9) line 14");
    row("a row too short", QByteArray(plain).replace("1 0 0", "1 0"), "TokenUnexpected(a number,) line 11",
        "NothingReadable line 11");
    row("a bad row, then too few", QByteArray(plain).replace("face 1", "face 3") + "3 0 x 2\n",
        "TokenUnexpected(a whole number,x) line 14",
        kTriangle + " ! TokenUnexpected(a whole number,x) line 14; DataTruncated(faces,3,2) line 15");
    row("not finite", QByteArray(plain).replace("1 0 0", "1 nan 0"), "NumberNotFinite(nan) line 11",
        "NothingReadable line 11");
    row("beyond single precision", QByteArray(plain).replace("1 0 0", "1e39 0 0"), "NumberNotFinite(1e39) line 11",
        "NothingReadable line 11");
  }

  void readsText() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, strict);
    QFETCH(QString, partial);
    QCOMPARE(describe(read(bytes)), strict);
    QCOMPARE(describe(read(bytes, true)), partial);
  }

  void readsBinary_data() {
    QTest::addColumn<bool>("big");
    QTest::newRow("little-endian") << false;
    QTest::newRow("big-endian") << true;
  }

  void readsBinary() {
    QFETCH(bool, big);
    const std::endian order = big ? std::endian::big : std::endian::little;
    const QByteArray plain = binaryTriangle(order);
    QCOMPARE(describe(read(plain)), kTriangle);
    QCOMPARE(describe(read(plain + "\r\n")), kTriangle);

    // Every type of number, for coordinates and for lists.
    QCOMPARE(describe(read(binary(order, QByteArray(kFloatVertices).replace("float", "double") +
                                             "element face 1\nproperty list uint ushort vertex_index\n")
                               .all<double>({0, 0, 0, 1, 0, 0, 0, 1, 0})
                               .add<std::uint32_t>(3)
                               .all<std::uint16_t>({0, 1, 2}))),
             kTriangle);
    QCOMPARE(describe(read(binary(order,
                                  "element vertex 3\nproperty int8 x\nproperty uint16 y\nproperty int32 z\n"
                                  "element face 1\nproperty list int16 uint8 vertex_index\n")
                               .add<std::int8_t>(-1)
                               .add<std::uint16_t>(65535)
                               .add<std::int32_t>(-2000000000)
                               .add<std::int8_t>(1)
                               .add<std::uint16_t>(0)
                               .add<std::int32_t>(0)
                               .add<std::int8_t>(0)
                               .add<std::uint16_t>(1)
                               .add<std::int32_t>(0)
                               .add<std::int16_t>(3)
                               .all<std::uint8_t>({0, 1, 2}))),
             QString("-1 65535 -2e+09, 1 0 0, 0 1 0 | 0 1 2"));

    // Lists before, between and behind.
    QCOMPARE(describe(read(binary(order, "element camera 1\nproperty list uchar double m\nproperty short k\n" +
                                             kFloatVertices +
                                             "property list uchar short w\nelement face 1\nproperty uchar red\n"
                                             "property list uchar float texcoord\n"
                                             "property list uchar int vertex_indices\nproperty int flags\n")
                               .add<std::uint8_t>(2)
                               .all<double>({1, 2})
                               .add<std::int16_t>(7)
                               .all<float>({0, 0, 0})
                               .add<std::uint8_t>(0)
                               .all<float>({1, 0, 0})
                               .add<std::uint8_t>(2)
                               .all<std::int16_t>({5, 6})
                               .all<float>({0, 1, 0})
                               .add<std::uint8_t>(0)
                               .add<std::uint8_t>(9)
                               .add<std::uint8_t>(1)
                               .add<float>(0.5f)
                               .add<std::uint8_t>(3)
                               .all<std::int32_t>({0, 1, 2})
                               .add<std::int32_t>(4))),
             kTriangle + " - Colour TextureCoordinates Other");

    const int body = static_cast<int>(plain.indexOf("end_header\n")) + 11;
    QCOMPARE(describe(read(plain + "more")),
             kTriangle + QString(" ! CountMismatch(bytes,%1,%2) byte %1").arg(plain.size()).arg(plain.size() + 4));
    QCOMPARE(describe(read(plain.chopped(1))), QString("DataTruncated(faces,1,0) byte %1").arg(plain.size() - 13));
    QCOMPARE(describe(read(plain.left(body + 25))), QString("DataTruncated(vertices,3,2) byte %1").arg(body + 24));

    QByteArray nan = plain;
    std::memset(nan.data() + body + 12, 0xff, 4);
    QCOMPARE(describe(read(nan)), QString("NumberNotFinite(nan) byte %1").arg(body + 12));
  }

  void stripsInBinary() {
    const QByteArray bytes =
        binary(std::endian::little, QByteArray(kFloatVertices).replace("3", "4") +
                                        "element tristrips 1\nproperty list int int vertex_indices\n")
            .all<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})
            .all<std::int32_t>({8, 0, 1, 2, 3, -1, 3, 2, 1});
    QCOMPARE(describe(read(bytes)), QString("0 0 0, 1 0 0, 0 1 0, 1 1 0 | 0 1 2, 2 1 3, 3 2 1"));
  }

  void aListLongerThanTheFile() {
    const QByteArray header = kFloatVertices + "element face 2\nproperty list int int vertex_indices\n";
    const QByteArray bytes = binary(std::endian::little, header)
                                 .all<float>({0, 0, 0, 1, 0, 0, 0, 1, 0})
                                 .all<std::int32_t>({3, 0, 1, 2})
                                 .all<std::int32_t>({2147483647, 0});
    QCOMPARE(describe(read(bytes)), QString("DataTruncated(faces,2,1) byte %1").arg(bytes.size() - 8));
    QCOMPARE(describe(read(bytes, true)),
             kTriangle + QString(" ! DataTruncated(faces,2,1) byte %1").arg(bytes.size() - 8));
  }

  // A line feed may be the first byte of the data; only the header's other lines tell.
  void headersEndWithTheirLine() {
    const QByteArray elements = kFloatVertices + kFaces;
    const QByteArray body = QByteArray(binaryTriangle(std::endian::little))
                                .mid(binary(std::endian::little, elements).operator QByteArray().size());
    QByteArray header = binary(std::endian::little, elements);
    QCOMPARE(describe(read(QByteArray(header).replace("\n", "\r\n") + body)), kTriangle);
    QCOMPARE(describe(read(QByteArray(header).replace("end_header\n", "end_header\r\n") + body)), kTriangle);
    QCOMPARE(describe(read(QByteArray(header).replace("\n", "\r") + body)), kTriangle);
    QCOMPARE(describe(read(QByteArray(header).replace("end_header\n", "end_header \n") + body)), kTriangle);

    header = QByteArray(header).replace("property float x", "property char x").replace("\n", "\r");
    const QByteArray ten = Bytes()
                               .add<std::int8_t>('\n')
                               .all<float>({0, 0})
                               .add<std::int8_t>(1)
                               .all<float>({0, 0})
                               .add<std::int8_t>(0)
                               .all<float>({1, 0})
                               .add<std::uint8_t>(3)
                               .all<std::int32_t>({0, 1, 2});
    QCOMPARE(describe(read(header + ten)), QString("10 0 0, 1 0 0, 0 1 0 | 0 1 2"));
  }

  void numberTypes() {
    const QByteArray rows = "0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const auto single = read(text(kFloatVertices + kFaces, rows));
    QVERIFY(single);
    QCOMPARE(single->numbers, NumberType::Float32);
    QVERIFY(single->soup.points[0].x() == static_cast<double>(0.1f));
    const auto twice = read(text(QByteArray(kFloatVertices).replace("float", "double") + kFaces, rows));
    QVERIFY(twice);
    QCOMPARE(twice->numbers, NumberType::Float64);
    QVERIFY(twice->soup.points[0].x() == 0.1);
    const auto mixed = read(text(QByteArray(kFloatVertices).replace("float z", "double z") + kFaces, rows));
    QVERIFY(mixed);
    QCOMPARE(mixed->numbers, NumberType::Float64);
  }
};

HANDWHEEL_TEST(PlyReaderTest)
#include "PlyReaderTest.moc"
