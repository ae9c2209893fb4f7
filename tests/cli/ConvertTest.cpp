// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <QTest>
#include <QtEndian>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

// The nine coordinates of every triangle of a binary STL, read here without the program's code.
std::vector<std::array<float, 9>> trianglesOf(const QByteArray& stl) {
  std::vector<std::array<float, 9>> triangles;
  if (stl.size() < 84) return triangles;
  const auto count = qFromLittleEndian<quint32>(stl.constData() + 80);
  if (stl.size() != 84 + 50 * static_cast<qsizetype>(count)) return triangles;
  for (quint32 i = 0; i < count; ++i) {
    std::array<float, 9> t;
    for (int k = 0; k < 9; ++k) t[k] = qFromLittleEndian<float>(stl.constData() + 84 + 50 * i + 12 + 4 * k);
    triangles.push_back(t);
  }
  return triangles;
}

std::vector<std::array<float, 9>> trianglesOf(const Shape& shape) {
  std::vector<std::array<float, 9>> triangles;
  for (const auto& f : shape.faces) {
    std::array<float, 9> t;
    for (int k = 0; k < 9; ++k) t[k] = static_cast<float>(shape.points[f[k / 3]][k % 3]);
    triangles.push_back(t);
  }
  return triangles;
}

}  // namespace

class ConvertTest : public QObject {
  Q_OBJECT

 private slots:
  // Through every format and back: the same triangles in the same order, defects and all.
  void chainKeepsEveryTriangle() {
    Shape shape = openCube(0.1);
    shape.faces.push_back(shape.faces[2]);  // a duplicate
    shape.faces.push_back({0, 1, 1});       // a degenerate one
    shape.add(moebiusStrip(7), {1.0 / 3.0, 0, 0});
    const Fixture fixture;
    fixture.put("0.off", shape.off());
    const char* names[] = {"0.off", "1.ply", "2.obj", "3.off", "4.ply", "5.stl"};
    for (int i = 0; i + 1 < 6; ++i) {
      const Ran ran = fixture.run({"convert", names[i], names[i + 1]});
      QCOMPARE(ran.code, 0);
      QCOMPARE(ran.out, QByteArray());
      QCOMPARE(ran.err,
               i < 4 ? QByteArray()
                     : QByteArray("handwheel: The coordinates are rounded to the single precision of the format.\n"));
    }
    QCOMPARE(trianglesOf(fixture.content("5.stl")), trianglesOf(shape));
    // Data that never passed through single precision are identical to the last bit.
    QCOMPARE(fixture.run({"inspect", "4.ply", "--json"}).out, fixture.run({"inspect", "0.off", "--json"}).out);
  }

  void saysWhatIsNotKept() {
    const Fixture fixture;
    fixture.put("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
                "property list uchar int vertex_indices\nend_header\n"
                "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
    const Ran ran = fixture.run({"convert", "a.ply", "b.stl"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.err, QByteArray("handwheel: Not kept: colours.\n"));
  }

  // Two pyramids, tip to tip: apart in double precision, and in the file of a document, too. Triangles that a file
  // lists stay as they are.
  void aDocumentStaysManifold() {
    const Fixture fixture;
    fixture.put("a.off",
                "OFF\n8 8 0\n0 0 0\n2 0 0\n0 2 0\n1 1 1\n0 0 2\n0 2 2\n2 0 2\n1 1 1.000000000001\n"
                "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 4 6 5\n3 4 5 7\n3 5 6 7\n3 6 4 7\n");
    QCOMPARE(fixture.run({"convert", "a.off", "a.handwheel"}).code, 0);
    const auto nonManifold = [&](const char* file) {
      if (fixture.run({"convert", file, "b.stl"}).code != 0) return -1;
      const Ran inspected = fixture.run({"inspect", "b.stl", "--json"});
      return nlohmann::json::parse(inspected.out.toStdString()).at("non_manifold_vertices").get<int>();
    };
    QCOMPARE(nonManifold("a.handwheel"), 0);
    QCOMPARE(nonManifold("a.off"), 1);
  }

  void inPlace() {
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    QCOMPARE(fixture.run({"convert", "a.off", "a.off"}).code, 0);
    QCOMPARE(fixture.run({"convert", "a.off", "b.stl"}).code, 0);
    QCOMPARE(trianglesOf(fixture.content("b.stl")), trianglesOf(cube()));
  }

  void errors_data() {
    QTest::addColumn<QString>("in");
    QTest::addColumn<QString>("out");
    QTest::newRow("missing input") << "none.off"
                                   << "b.stl";
    QTest::newRow("unknown ending") << "a.off"
                                    << "b.docx";
    QTest::newRow("no ending") << "a.off"
                               << "b";
    QTest::newRow("missing folder") << "a.off"
                                    << "no/such/b.stl";
  }
  void errors() {
    QFETCH(QString, in);
    QFETCH(QString, out);
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    const Ran ran = fixture.run({"convert", in, out});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err.count('\n'), 1);
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }
};

HANDWHEEL_TEST(ConvertTest)
#include "ConvertTest.moc"
