// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

using namespace handwheel;

namespace {

using Point = std::pair<double, double>;
using Curve = std::vector<Point>;

double twiceArea(const Curve& curve) {
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto& [x, y] = curve[i];
    const auto& [nextX, nextY] = curve[(i + 1) % curve.size()];
    sum += x * nextY - y * nextX;
  }
  return sum;
}

// The closed polylines of a DXF, group by group.
std::vector<Curve> dxfCurves(const QByteArray& text) {
  const QList<QByteArray> lines = text.split('\n');
  std::vector<Curve> curves;
  bool isVertex = false;
  for (qsizetype i = 0; i + 1 < lines.size(); i += 2) {
    if (lines[i] == "0") isVertex = lines[i + 1] == "VERTEX";
    if (lines[i] == "0" && lines[i + 1] == "POLYLINE") curves.emplace_back();
    if (isVertex && lines[i] == "10") curves.back().emplace_back(lines[i + 1].toDouble(), 0.0);
    if (isVertex && lines[i] == "20") curves.back().back().second = lines[i + 1].toDouble();
  }
  return curves;
}

}  // namespace

class SectionTest : public QObject {
  Q_OBJECT

 private slots:
  // A section of the 1 mm cube at half its height.
  void statistics_data() {
    QTest::addColumn<QString>("plane");
    QTest::addColumn<QByteArray>("length");
    QTest::addColumn<QByteArray>("area");
    QTest::newRow("x") << "x=0.5" << QByteArray("4") << QByteArray("1");
    QTest::newRow("z") << "z=0.25" << QByteArray("4") << QByteArray("1");
    QTest::newRow("a diagonal") << "2,2,0=0.70710678118654757" << QByteArray("4.82843") << QByteArray("1.41421");
  }
  void statistics() {
    QFETCH(QString, plane);
    QFETCH(QByteArray, length);
    QFETCH(QByteArray, area);
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    const Ran ran = fixture.run({"section", "a.off", "--plane", plane, "-o", "b.svg"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out, "Outlines: 1 closed, 0 open.\nLength: " + length + " mm.\nArea: " + area + " mm\xc2\xb2.\n");
  }

  void drawings() {
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    QCOMPARE(fixture.run({"section", "a.off", "--plane", "z=0.5", "-o", "b.dxf"}).code, 0);
    const std::vector<Curve> curves = dxfCurves(fixture.content("b.dxf"));
    QCOMPARE(curves.size(), std::size_t(1));
    QVERIFY(std::abs(twiceArea(curves[0]) - 2.0) < 1e-12);
    QVERIFY(fixture.content("b.dxf").contains("$INSUNITS\n70\n4\n") && fixture.content("b.dxf").endsWith("0\nEOF\n"));

    QCOMPARE(fixture.run({"section", "a.off", "--plane", "z=0.5", "-o", "b.svg"}, "de_DE.UTF-8").code, 0);
    QXmlStreamReader svg(fixture.content("b.svg"));
    QString path;
    while (!svg.atEnd()) {
      svg.readNext();
      if (!svg.isStartElement()) continue;
      if (svg.name() == u"svg") QCOMPARE(svg.attributes().value("width"), u"1mm");
      if (svg.name() == u"svg") QCOMPARE(svg.attributes().value("viewBox"), u"0 -1 1 1");
      if (svg.name() == u"path") path = svg.attributes().value("d").toString();
    }
    QVERIFY2(!svg.hasError(), qPrintable(svg.errorString()));
    Curve curve;
    const QRegularExpression coordinates("[ML]([-0-9.e]+),([-0-9.e]+)");
    for (auto i = coordinates.globalMatch(path); i.hasNext();) {
      const auto found = i.next();
      curve.emplace_back(found.captured(1).toDouble(), found.captured(2).toDouble());
    }
    QVERIFY(std::abs(twiceArea(curve) + 2.0) < 1e-12);  // Y points down
    QVERIFY(path.contains('Z'));
  }

  void openOutlinesAndNothing() {
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    const Ran open = fixture.run({"section", "a.off", "--plane", "x=0.5", "-o", "b.svg"});
    QCOMPARE(open.code, 2);
    QVERIFY(open.out.startsWith("Outlines: 0 closed, 1 open.\n") && !open.out.contains("Area"));
    QVERIFY(open.err.contains("An outline is open") && fixture.names().contains("b.svg"));
    const Ran beside = fixture.run({"section", "a.off", "--plane", "x=7", "-o", "b.svg"});
    QCOMPARE(beside.code, 2);
    QVERIFY(beside.err.contains("The plane does not intersect the mesh."));
  }

  void wrongWords_data() {
    QTest::addColumn<QStringList>("words");
    for (const char* plane : {"z", "z=", "z=nan", "w=1", "1,2=3", "0,0,0=1", "1,2,3,4=5", "z=1mm", "inf,0,0=1"}) {
      QTest::newRow(plane) << QStringList{"--plane", plane, "-o", "b.svg"};
    }
    QTest::newRow("none") << QStringList{"-o", "b.svg"};
    QTest::newRow("no drawing") << QStringList{"--plane", "z=1"};
    QTest::newRow("pdf") << QStringList{"--plane", "z=1", "-o", "b.pdf"};
    QTest::newRow("no file") << QStringList{"--plane", "z=1", "-o", "none/b.svg"};
  }
  void wrongWords() {
    QFETCH(QStringList, words);
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    const Ran ran = fixture.run(QStringList{"section", "a.off"} + words);
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.startsWith("handwheel: ") && ran.out.isEmpty());
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }
};

HANDWHEEL_TEST(SectionTest)
#include "SectionTest.moc"
