// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReadDescription.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const QByteArray kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const QByteArray kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const QString kSquarePoints = "0 0 0, 1 0 0, 1 1 0, 0 1 0 | ";

}  // namespace

class ObjReaderTest : public QObject {
  Q_OBJECT
 private slots:
  void reads_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("strict");
    QTest::addColumn<QString>("partial");
    const auto row = [](const char* name, const QByteArray& bytes, const QString& strict, const QString& partial = {}) {
      QTest::newRow(name) << bytes << strict << (partial.isNull() ? strict : partial);
    };

    row("triangle", kVertices + "f 1 2 3\n", kTriangle);
    row("no line end", kVertices + "f 1 2 3", kTriangle);
    row("Windows lines", QByteArray(kVertices + "f 1 2 3\n").replace("\n", "\r\n"), kTriangle);
    row("old Mac lines", QByteArray(kVertices + "f 1 2 3\n").replace("\n", "\r"), kTriangle);
    row("blanks and tabs", "  v\t0  0 0 \nv 1 0 0\n\n\t\nv 0 1 0\n f  1\t2 3  \n", kTriangle);
    row("byte order mark", "\xEF\xBB\xBF" + kVertices + "f 1 2 3\n", kTriangle);
    row("comments", "# v 9 9 9\n" + kVertices + "#x\nf 1 2 3 # 4 5\n", kTriangle);
    row("negative indices", kVertices + "f -3 -2 -1\nv 5 5 5\nf -4 -3 -2\n",
        "0 0 0, 1 0 0, 0 1 0, 5 5 5 | 0 1 2, 0 1 2");
    row("texture corners", kVertices + "vt 0 0\nf 1/1 2/1 3/1\n", kTriangle + " - TextureCoordinates");
    row("normal corners", kVertices + "vn 0 0 1\nf 1//1 2//1 3//-1\n", kTriangle + " - Normals");
    row("all corners", kVertices + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n",
        kTriangle + " - Normals TextureCoordinates");
    row("empty corners", kVertices + "f 1// 2/ 3//\n", kTriangle);
    row("quad", kSquare + "f 1 2 3 4\n", kSquarePoints + "0 1 2, 0 2 3");
    row("faces before vertices", "f 1 2 3\n" + kVertices, kTriangle);
    row("old face word", kVertices + "fo 1 2 3\n", kTriangle);
    row("continued line", kVertices + "f 1 \\\n2\\\n 3\nf 1 2 \\\r\n3\n", kTriangle + ", 0 1 2");
    row("blanks behind the backslash", kVertices + "f 1 \\ \n2\\\t \r\n 3\n", kTriangle);
    row("continued lost line", kVertices + "g a \\\nf 1 2 3\nf 1 2 3\n", kTriangle + " - Groups");
    row("comment that ends in a backslash", kVertices + "# C:\\\nf 1 2 3\n", kTriangle);
    row("backslash within a line", kVertices + "mtllib a\\ b.mtl\nf 1 2 3\n", kTriangle + " - Materials");
    row("groups and materials", "mtllib a.mtl\no x\ng y\ns 1\nusemtl z\n" + kVertices + "f 1 2 3\n",
        kTriangle + " - Materials Groups");
    row("smoothing groups", "s off\n" + kVertices + "s 1\nf 1 2 3\n", kTriangle + " - Groups");
    row("smoothing off", "s off\n" + kVertices + "s 0\nf 1 2 3\n", kTriangle);
    row("lines and points", kVertices + "l 1 2\np 3\nf 1 2 3\n", kTriangle + " - Lines Points");
    row("curves", kVertices + "vp 0 1\ncstype bspline\ncurv 0 1 1 2 3\nend\nf 1 2 3\n", kTriangle + " - Curves");
    row("colour", "v 0 0 0 1 0.5 0\nv 1 0 0 nan nan nan\nv 0 1 0 1 1 1 1\nf 1 2 3\n", kTriangle + " - Colour");
    row("weight one", "v 0 0 0 1\nv 1 0 0 1.0\nv 0 1 0 1\nf 1 2 3\n", kTriangle);
    row("weight", "v 0 0 0 1\nv 1 0 0 0.5\nv 0 1 0 1\nf 1 2 3\n", kTriangle + " - Other");
    row("unknown statement", kVertices + "foo 1\nf 1 2 3\n",
        kTriangle + " ! TokenUnexpected(a statement of the format,foo) line 4");
    row("number formats", "v +1 .5 -2.\nv 1.e1 1E+02 1e-0003\nv -0 1e-400 -.5E-1\nf 1 2 3\n",
        "1 0.5 -2, 10 100 0.001, 0 0 -0.05 | 0 1 2");
    row("repeated corner", kVertices + "f 1 2 2\n", "0 0 0, 1 0 0, 0 1 0 | 0 1 1");

    row("number with an X", "v 0 X0 0\n" + kVertices + "f 1 2 3\nf 2 3 4\n", "NumberMalformed(X0) line 1",
        kTriangle + " ! NumberMalformed(X0) line 1; VertexUnreadable(1) line 5");
    row("not finite", "v 0 nan 0\nv 1.#INF 0 0\nv 1 -inf 0\nv 1e309 0 0\n" + kVertices + "f -3 -2 -1\n",
        "NumberNotFinite(nan) line 1",
        kTriangle +
            " ! NumberNotFinite(nan) line 1; NumberNotFinite(1.#INF) line 2; NumberNotFinite(-inf) line 3; "
            "NumberNotFinite(1e309) line 4");
    row("two coordinates", kVertices + "v 1 2\nf 1 2 3\n", "TokenUnexpected(a number,) line 4",
        kTriangle + " ! TokenUnexpected(a number,) line 4");
    row("index nought", kVertices + "f 0 1 2\nf 1 2 3\n", "IndexOutOfRange(0,3) line 4",
        kTriangle + " ! IndexOutOfRange(0,3) line 4");
    row("index beyond", kVertices + "f 1 2 4\nf 1 2 3\n", "IndexOutOfRange(4,3) line 4",
        kTriangle + " ! IndexOutOfRange(4,3) line 4");
    row("negative index beyond", kVertices + "f -4 1 2\nf 1 2 3\n", "IndexOutOfRange(-4,3) line 4",
        kTriangle + " ! IndexOutOfRange(-4,3) line 4");
    row("index of twenty digits", kVertices + "f 1 2 99999999999999999999\nf 1 2 3\n",
        "TokenUnexpected(a vertex number,99999999999999999999) line 4",
        kTriangle + " ! TokenUnexpected(a vertex number,99999999999999999999) line 4");
    row("smallest index", kVertices + "f 1 2 -9223372036854775808\nf 1 2 3\n",
        "IndexOutOfRange(-9223372036854775808,3) line 4",
        kTriangle + " ! IndexOutOfRange(-9223372036854775808,3) line 4");
    row("corner that is no number", kVertices + "f 1 b 3\nf 1 2 3\n", "TokenUnexpected(a vertex number,b) line 4",
        kTriangle + " ! TokenUnexpected(a vertex number,b) line 4");
    row("corner with a letter behind", kVertices + "f 1 2/x 3\nf 1 2 3\n",
        "TokenUnexpected(a vertex number,2/x) line 4", kTriangle + " ! TokenUnexpected(a vertex number,2/x) line 4");
    row("two corners", kVertices + "f 1 2\nf 1 2 3\n", "PolygonTooSmall(2) line 4",
        kTriangle + " ! PolygonTooSmall(2) line 4");
    row("no corners", kVertices + "f\nf 1 2 3\n", "PolygonTooSmall(0) line 4",
        kTriangle + " ! PolygonTooSmall(0) line 4");
    row("points only", kVertices, "NoTriangles");
    row("comment only", "# nothing\n", "NoTriangles");
  }

  void reads() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, strict);
    QFETCH(QString, partial);
    QCOMPARE(describe(read(bytes, false, "a.obj")), strict);
    QCOMPARE(describe(read(bytes, true, "a.obj")), partial);
  }

  void coordinatesAreDouble() {
    const auto file = read("v 0.1 -0.0 4.9e-324\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QVERIFY(file);
    QCOMPARE(file->numbers, NumberType::Float64);
    QVERIFY(file->soup.points[0].x() == 0.1);
    QVERIFY(!std::signbit(file->soup.points[0].y()));
    QVERIFY(file->soup.points[0].z() == std::numeric_limits<double>::denorm_min());
  }
};

HANDWHEEL_TEST(ObjReaderTest)
#include "ObjReaderTest.moc"
