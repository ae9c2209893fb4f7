// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReadDescription.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const QByteArray kBody = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

struct BinaryForm {
  std::endian order;
  bool colourCounts;
};

QByteArray binaryOff(BinaryForm form, int faces = 1) {
  Bytes bytes(form.order);
  bytes.text("OFF BINARY\n").all<std::uint32_t>({3, static_cast<std::uint32_t>(faces), 0});
  bytes.all<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  for (int i = 0; i < faces; ++i) {
    bytes.all<std::uint32_t>({3, 0, 1, 2});
    if (form.colourCounts) bytes.add<std::uint32_t>(0);
  }
  return bytes;
}

}  // namespace

class OffReaderTest : public QObject {
  Q_OBJECT
 private slots:
  void readsText_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("strict");
    QTest::addColumn<QString>("partial");
    const auto row = [](const char* name, const QByteArray& bytes, const QString& strict, const QString& partial = {}) {
      QTest::newRow(name) << bytes << strict << (partial.isNull() ? strict : partial);
    };
    const QByteArray plain = "OFF\n3 1 0\n" + kBody;

    row("triangle", plain, kTriangle);
    row("counts beside the keyword", "OFF 3 1 0\n" + kBody, kTriangle);
    row("counts glued to the keyword", "  OFF3 1 0 # yes\n" + kBody, kTriangle);
    row("no number of edges", "OFF\n3 1\n" + kBody, kTriangle);
    row("no keyword", "3 1 0\n" + kBody, kTriangle);
    row("lower case", "off\n3 1 0\n" + kBody, kTriangle);
    row("Windows lines", QByteArray(plain).replace("\n", "\r\n"), kTriangle);
    row("old Mac lines", QByteArray(plain).replace("\n", "\r"), kTriangle);
    row("byte order mark", "\xEF\xBB\xBF" + plain, kTriangle);
    row("comments", "# a\nOFF # b\n# c\n\n3 1 0 # d\n0 0 0 # e\n# f\n1 0 0\n0 1 0\n3 0 1 2 # g\n#", kTriangle);
    row("vertices on one line", "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n", kTriangle);
    row("vertices on lines of two numbers", "OFF\n4 1 0\n0 0\n0 1 0 0 0 1 0 5\n5 5\n3 0 1 2\n",
        "0 0 0, 1 0 0, 0 1 0, 5 5 5 | 0 1 2");
    row("normals", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n", kTriangle + " - Normals");
    row("colours", "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n", kTriangle + " - Colour");
    // MeshLab writes normals before colours; the manual of Geomview has them the other way round.
    for (const char* const keyword : {"NCOFF", "CNOFF"}) {
      row(keyword,
          QByteArray(keyword) +
              "\n3 1 0\n0 0 0 0 0 1 9 9 9 255\n1 0 0 0 0 1 9 9 9 255\n0 1 0 0 0 1 9 9 9 255\n3 0 1 2\n",
          kTriangle + " - Colour Normals");
    }
    for (const char* const keyword : {"NCSTOFF", "STNCOFF", "CSTNOFF"})
      row(keyword, QByteArray(keyword) + "\n3 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n",
          kTriangle + " - Colour Normals TextureCoordinates");
    row("an attribute twice", "NNOFF\n3 1 0\n" + kBody, "HeaderMalformed(OFF) line 1");
    row("texture", "STOFF\n3 1 0\n0 0 0 0 1\n1 0 0 0 1\n0 1 0 0 1\n3 0 1 2\n", kTriangle + " - TextureCoordinates");
    row("everything",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1 0 1\n1 0 0 0 0 1 1 0 0 1 0 1\n0 1 0 0 0 1 1 0 0 1 0 1\n3 0 1 2\n",
        kTriangle + " - Colour Normals TextureCoordinates");
    row("colours not announced", "OFF 3 1 0\n0 0 0 0.6 0.6 0.6\n1 0 0 0.6 0.6 0.6\n0 1 0 0.6 0.6 0.6\n3 0 1 2\n",
        kTriangle + " - Colour");
    row("face colours", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1.0 0.5 0.5 0.75\n", kTriangle + " - Colour");
    row("face colour index", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n", kTriangle + " - Colour");
    row("quad", "OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "0 0 0, 1 0 0, 1 1 0, 0 1 0 | 0 1 2, 0 2 3");
    row("points and lines", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n1 0\n2 0 1\n3 0 1 2\n", kTriangle + " - Lines Points");

    row("four dimensions", "4OFF\n3 1 0\n0 0 0 1\n", "TypeUnknown(4OFF) line 1");
    row("any dimension", "nOFF\n3\n3 1 0\n", "TypeUnknown(nOFF) line 1");
    row("colours in four dimensions", "C4OFF\n3 1 0\n", "TypeUnknown(C4OFF) line 1");
    row("not OFF at all", "hello\n3 1 0\n", "HeaderMalformed(OFF) line 1");
    row("keyword only", "OFF\n", "TokenUnexpected(the number of vertices,) line 2");
    row("one count", "OFF\n3\n", "TokenUnexpected(the number of faces,) line 3");
    row("negative count", "OFF\n-3 1 0\n" + kBody, "TokenUnexpected(the number of vertices,-3) line 2");
    row("count that is no number", "OFF\nx 1 0\n" + kBody, "TokenUnexpected(the number of vertices,x) line 2");
    row("no faces", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "NoTriangles");
    row("count beyond the file", "OFF\n353535235358 1 0\n" + kBody, "DataTruncated(vertices,353535235358,4) line 7",
        "NothingReadable line 7");
    row("more faces than there are", QByteArray(plain).replace("3 1 0", "3 3 0"), "DataTruncated(faces,3,1) line 7",
        kTriangle + " ! DataTruncated(faces,3,1) line 7");
    row("fewer faces than there are", plain + "3 2 1 0\n", kTriangle + " ! CountMismatch(bytes,36,44) line 7");
    row("index beyond", "OFF\n3 2 0\n" + kBody + "3 0 1 3\n", "IndexOutOfRange(3,3) line 7",
        kTriangle + " ! IndexOutOfRange(3,3) line 7");
    row("negative index", "OFF\n3 2 0\n" + kBody + "3 0 1 -1\n", "IndexOutOfRange(-1,3) line 7",
        kTriangle + " ! IndexOutOfRange(-1,3) line 7");
    row("face cut short", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n3 0 1 2\n",
        "TokenUnexpected(a whole number,) line 6", kTriangle + " ! TokenUnexpected(a whole number,) line 6");
    row("face without corners", "OFF\n3 2 0\n" + kBody + "0\n", "PolygonTooSmall(0) line 7",
        kTriangle + " ! PolygonTooSmall(0) line 7");
    row("face of two thousand million corners", "OFF\n3 2 0\n" + kBody + "2000000000 0 1 2\n",
        "TokenUnexpected(a whole number,) line 7", kTriangle + " ! TokenUnexpected(a whole number,) line 7");
    row("number with an X", "OFF\n4 2 0\n0 X 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 1 2 3\n", "NumberMalformed(X) line 3",
        kTriangle + " ! NumberMalformed(X) line 3; VertexUnreadable(0) line 7");
    row("not finite", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 inf 0\n3 0 1 2\n", "NumberNotFinite(inf) line 6",
        kTriangle + " ! NumberNotFinite(inf) line 6");
  }

  void readsText() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, strict);
    QFETCH(QString, partial);
    QCOMPARE(describe(read(bytes, false, "a.off")), strict);
    QCOMPARE(describe(read(bytes, true, "a.off")), partial);
  }

  void readsBinary_data() {
    QTest::addColumn<bool>("big");
    QTest::addColumn<bool>("colourCounts");
    QTest::newRow("big-endian") << true << true;
    QTest::newRow("little-endian") << false << true;
    QTest::newRow("big-endian without colour counts") << true << false;
    QTest::newRow("little-endian without colour counts") << false << false;
  }

  void readsBinary() {
    QFETCH(bool, big);
    QFETCH(bool, colourCounts);
    const BinaryForm form{big ? std::endian::big : std::endian::little, colourCounts};
    QCOMPARE(describe(read(binaryOff(form))), kTriangle);
    QCOMPARE(describe(read(binaryOff(form, 2))), kTriangle + ", 0 1 2");
    const auto file = read(binaryOff(form));
    QVERIFY(file);
    QCOMPARE(file->numbers, NumberType::Float32);

    const QByteArray whole = binaryOff(form, 3);
    const QString cut = QString("DataTruncated(faces,3,2) byte %1").arg(whole.size() - 1);
    QCOMPARE(describe(read(whole.chopped(1))), cut);
    QCOMPARE(describe(read(whole.chopped(1), true)), kTriangle + ", 0 1 2 ! " + cut);
    QCOMPARE(describe(read(whole.left(11 + 12 + 35))), QString("DataTruncated(vertices,3,2) byte 58"));
    QCOMPARE(describe(read(whole.left(22))), QString("DataTruncated(bytes,23,22) byte 22"));
  }

  void binaryAttributes() {
    const QByteArray coloured = Bytes(std::endian::big)
                                    .text("OFF BINARY\n")
                                    .all<std::uint32_t>({3, 1, 0})
                                    .all<float>({0, 0, 0, 1, 0, 0, 0, 1, 0})
                                    .all<std::uint32_t>({3, 0, 1, 2, 4})
                                    .all<float>({1, 0, 0, 1});
    QCOMPARE(describe(read(coloured)), kTriangle + " - Colour");
    const QByteArray normals = Bytes(std::endian::big)
                                   .text("NOFF BINARY\n")
                                   .all<std::uint32_t>({3, 1, 0})
                                   .all<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1})
                                   .all<std::uint32_t>({3, 0, 1, 2, 0});
    QCOMPARE(describe(read(normals)), kTriangle + " - Normals");
    QCOMPARE(describe(read(binaryOff({std::endian::big, true}) + "abc")),
             kTriangle + " ! CountMismatch(bytes,79,82) byte 79");
  }
};

HANDWHEEL_TEST(OffReaderTest)
#include "OffReaderTest.moc"
