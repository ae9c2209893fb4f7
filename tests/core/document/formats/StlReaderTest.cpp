// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReadDescription.h"
#include "TestClass.h"

#include <QTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

QByteArray binaryStl(QByteArray header, std::uint32_t announced, int facets, std::uint16_t attribute = 0) {
  Bytes bytes;
  bytes.text(header.leftJustified(80, '\0')).add(announced);
  for (int i = 0; i < facets; ++i) {
    const auto z = static_cast<float>(i);
    bytes.all<float>({0, 0, 1}).all<float>({0, 0, z, 1, 0, z, 0, 1, z}).add(attribute);
  }
  return bytes;
}

const QByteArray kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const QByteArray kSecondFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nendloop\nendfacet\n";
const QString kTwo = "0 0 0, 1 0 0, 0 1 0, 0 0 1, 1 0 1, 0 1 1 | 0 1 2, 3 4 5";

}  // namespace

class StlReaderTest : public QObject {
  Q_OBJECT
 private slots:
  void reads_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("strict");
    QTest::addColumn<QString>("partial");
    const auto row = [](const char* name, const QByteArray& bytes, const QString& strict, const QString& partial = {}) {
      QTest::newRow(name) << bytes << strict << (partial.isNull() ? strict : partial);
    };

    row("binary", binaryStl("", 2, 2), kTwo);
    row("binary that begins with solid", binaryStl("solid part", 2, 2), kTwo);
    row("binary that begins with solid and blanks", binaryStl(QByteArray("solid").leftJustified(80, ' '), 2, 2), kTwo);
    row("binary with colour attribute", binaryStl("", 2, 2, 0x8123), kTwo + " - Colour");
    QByteArray attributes = binaryStl("", 2, 2, 6);
    attributes.insert(184, "second").insert(134, "first.");
    row("binary with bytes of attributes", attributes, kTwo + " - Other");
    row("binary with colour in the header", binaryStl("COLOR=abcd", 2, 2), kTwo + " - Colour");
    row("binary whose header is UTF-16", binaryStl("\xFF\xFEs", 2, 2), kTwo);
    row("more announced than there is", binaryStl("solid x", 3, 2), "DataTruncated(facets,3,2) byte 184",
        kTwo + " ! DataTruncated(facets,3,2) byte 184");
    row("cut within a facet", binaryStl("", 2, 2).chopped(1), "DataTruncated(facets,2,1) byte 134",
        kTriangle + " ! DataTruncated(facets,2,1) byte 134");
    row("fewer announced than there is", binaryStl("", 1, 2), kTwo + " ! CountMismatch(facets,1,2) byte 80");
    row("none announced", binaryStl("", 0, 2), kTwo + " ! CountMismatch(facets,0,2) byte 80");
    row("padding behind", binaryStl("", 1, 1) + QByteArray(50, '\0'),
        kTriangle + " ! CountMismatch(bytes,134,184) byte 134");
    row("something behind", binaryStl("", 1, 1) + "xyz", kTriangle + " ! CountMismatch(bytes,134,137) byte 134");
    row("no facets", binaryStl("", 0, 0), "NoTriangles");
    row("shorter than a header", binaryStl("", 0, 0).left(83), "DataTruncated(bytes,84,83) byte 83");
    row("every count fits no file", binaryStl("", 0xffffffffu, 0), "DataTruncated(facets,4294967295,0) byte 84",
        "NothingReadable byte 84");

    row("text", "solid cube\n" + kFacet + kSecondFacet + "endsolid cube\n", kTwo);
    row("text with a tab before the name", "solid\tcube\n" + kFacet + "endsolid\tcube\n", kTriangle);
    row("text without a name", "solid\n" + kFacet + "endsolid", kTriangle);
    row("text with upper case", "SOLID CUBE\n" + kFacet.toUpper() + "ENDSOLID CUBE\n", kTriangle);
    row("text with Windows lines", QByteArray("solid c\n" + kFacet + "endsolid c\n").replace("\n", "\r\n"), kTriangle);
    row("text with old Mac lines", QByteArray("solid c\n" + kFacet + "endsolid c\n").replace("\n", "\r"), kTriangle);
    row("text in one line", QByteArray("solid a part\n" + kFacet + kSecondFacet + "endsolid\n").replace("\n", " "),
        kTwo);
    row("text with a byte order mark", "\xEF\xBB\xBFsolid c\n" + kFacet + "endsolid c\n", kTriangle);
    row("a name that is no UTF-8", "solid \xE9\xFF\n" + kFacet + "endsolid \xE9\xFF\n", kTriangle);
    row("a name with a NUL", QByteArray("solid a\0b\n", 10) + kFacet + "endsolid\n", kTriangle);
    row("a name with keywords", "solid facet vertex\n" + kFacet + "endsolid facet vertex\n", kTriangle);
    row("two solids", "solid a\n" + kFacet + "endsolid a\nsolid b\n" + kSecondFacet + "endsolid b\n", kTwo);
    row("an empty solid behind", "solid a\n" + kFacet + "endsolid\nsolid b\nendsolid\n", kTriangle);
    row("only an empty solid", "solid a\nendsolid a\n", "NoTriangles");
    row("no endsolid", "solid a\n" + kFacet, kTriangle + " ! TokenUnexpected(endsolid,) line 9");
    row("no endsolid between", "solid a\n" + kFacet + "solid b\n" + kSecondFacet + "endsolid b\n",
        kTwo + " ! TokenUnexpected(endsolid,solid) line 9");
    row("garbled endsolid", "solid a\n" + kFacet + "end solid a\n",
        kTriangle + " ! TokenUnexpected(endsolid,end) line 9");
    row("no solid", kFacet, kTriangle);
    row("normal that is no number", QByteArray("solid\n" + kFacet + "endsolid").replace("0 0 1", "nan -1.#IND x"),
        kTriangle);
    row("no normal", QByteArray("solid\n" + kFacet + "endsolid").replace("normal 0 0 1", ""), kTriangle);
    row("number formats",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex +1 .5 -2.\nvertex 1.e1 1E+02 1e-0003\n"
        "vertex -0 1e-400 -.5E-1\nendloop\nendfacet\nendsolid",
        "1 0.5 -2, 10 100 0.00100000005, 0 0 -0.0500000007 | 0 1 2");
    row("not a number", "solid\n" + QByteArray(kFacet).replace("1 0 0", "1 x 0") + kSecondFacet + "endsolid",
        "NumberMalformed(x) line 5", "0 0 1, 1 0 1, 0 1 1 | 0 1 2 ! NumberMalformed(x) line 5");
    row("decimal comma", "solid\n" + QByteArray(kFacet).replace("1 0 0", "1,5 0 0") + "endsolid",
        "NumberMalformed(1,5) line 5", "NothingReadable line 5");
    row("infinite", "solid\n" + QByteArray(kFacet).replace("1 0 0", "1 inf 0") + kSecondFacet + "endsolid",
        "NumberNotFinite(inf) line 5", "0 0 1, 1 0 1, 0 1 1 | 0 1 2 ! NumberNotFinite(inf) line 5");
    row("beyond single precision", "solid\n" + QByteArray(kFacet).replace("1 0 0", "1e39 0 0") + "endsolid",
        "NumberNotFinite(1e39) line 5", "NothingReadable line 5");
    row("two corners", "solid\n" + QByteArray(kFacet).replace("vertex 1 0 0\n", "") + kSecondFacet + "endsolid",
        "PolygonTooSmall(2) line 2", "0 0 1, 1 0 1, 0 1 1 | 0 1 2 ! PolygonTooSmall(2) line 2");
    row("four corners",
        "solid\n" + QByteArray(kFacet).replace("vertex 0 1 0\n", "vertex 1 1 0\nvertex 0 1 0\n") + "endsolid",
        "0 0 0, 1 0 0, 1 1 0, 0 1 0 | 0 1 2, 0 2 3 ! CountMismatch(vertices,3,4) line 2");
    row("a line of something else", "solid\n" + kFacet + "hello there\n" + kSecondFacet + "endsolid",
        "TokenUnexpected(facet,hello) line 9", kTwo + " ! TokenUnexpected(facet,hello) line 9");
    row("no endfacet", "solid\n" + QByteArray(kFacet).replace("endfacet\n", "") + kSecondFacet + "endsolid",
        "TokenUnexpected(endfacet,facet) line 8", kTwo + " ! TokenUnexpected(endfacet,facet) line 8");
    row("colour", "solid\ncolor 1 0 0\n" + kFacet + "endsolid", kTriangle + " - Colour");
  }

  void reads() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, strict);
    QFETCH(QString, partial);
    QCOMPARE(describe(read(bytes, false, "a.stl")), strict);
    QCOMPARE(describe(read(bytes, true, "a.stl")), partial);
  }

  void facetsWithBadNumbersAreDropped() {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      QByteArray bytes = binaryStl("", 2, 2);
      std::memcpy(bytes.data() + 84 + 12 + 4, &bad, 4);  // y of the first corner
      const QString error = QString("NumberNotFinite(%1) byte 100").arg(bad == bad ? "inf" : "nan");
      QCOMPARE(describe(read(bytes)), error);
      QCOMPARE(describe(read(bytes, true)), "0 0 1, 1 0 1, 0 1 1 | 0 1 2 ! " + error);
    }
  }

  // The normal is not read, whatever it is.
  void normalsDoNotMatter() {
    QByteArray bytes = binaryStl("", 1, 1);
    std::memset(bytes.data() + 84, 0xff, 12);
    QCOMPARE(describe(read(bytes)), kTriangle);
  }

  void coordinatesAreSingle() {
    const auto file = read("solid\n" + QByteArray(kFacet).replace("1 0 0", "0.1 -0.0 1e-45") + "endsolid");
    QVERIFY(file);
    QCOMPARE(file->numbers, NumberType::Float32);
    QVERIFY(file->soup.points[1].x() == static_cast<double>(0.1f));
    QVERIFY(!std::signbit(file->soup.points[1].y()));
    QVERIFY(file->soup.points[1].z() == static_cast<double>(std::numeric_limits<float>::denorm_min()));
  }
};

HANDWHEEL_TEST(StlReaderTest)
#include "StlReaderTest.moc"
