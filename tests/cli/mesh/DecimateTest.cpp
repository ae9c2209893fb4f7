// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "LargeInputs.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

namespace {

// A ring in the plane z = 0, from radius 10 to 20, that swings up and down.
Shape wavyRing(int around) {
  return grid(
      around, 12,
      [=](int x, int y) {
        const double u = 2.0 * M_PI * x / around, r = 10.0 + 10.0 * y / 12;
        return std::array<double, 3>{r * std::cos(u), r * std::sin(u), std::sin(3.0 * u)};
      },
      [](int, int) { return false; });
}

nlohmann::json decimateInspected(const Fixture& fixture, const QString& name) {
  return nlohmann::json::parse(fixture.run({"inspect", name, "--json"}).out.toStdString());
}

}  // namespace

class DecimateTest : public QObject {
  Q_OBJECT

 private slots:
  void toACount_data() {
    QTest::addColumn<QString>("output");
    for (const char* name : {"b.stl", "b.ply", "b.off", "b.3mf", "b.handwheel", "a.off"}) QTest::newRow(name) << name;
  }
  void toACount() {
    QFETCH(QString, output);
    const Fixture fixture;
    fixture.put("a.off", wavyRing(60).off());
    const Ran ran = fixture.run({"decimate", "a.off", "-o", output, "--faces", "200"}, "de_DE.UTF-8");
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.out.startsWith("Triangles: 1440 before, "));
    const auto statistics = decimateInspected(fixture, output);
    const int triangles = statistics["triangles"];
    QVERIFY(triangles == 200 || triangles == 199);
    QVERIFY(statistics["manifold"].get<bool>() && statistics["oriented"].get<bool>());
  }

  // The program's own comparison agrees.
  void withinAnError() {
    const Fixture fixture;
    fixture.put("a.off", wavyRing(60).off());
    const Ran ran = fixture.run({"decimate", "a.off", "-o", "b.off", "--error", "0.1"});
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.out.contains("Largest distance found between original and result: 0.0"));
    QVERIFY(ran.out.endsWith("No point is farther away than --error allows.\n"));
    QVERIFY(decimateInspected(fixture, "b.off")["triangles"].get<int>() < 500);
    QCOMPARE(fixture.run({"compare", "b.off", "a.off", "--report", "r.json"}).code, 0);
    QVERIFY(fixture.json("r.json")["largest_distance_mm"].get<double>() <= 0.1);
  }

  // Two sheets 0.01 apart, which cross after a coarse reduction; what made them is named, in text and JSON.
  void crossingsAreSaid() {
    const Fixture fixture;
    fixture.put("a.off", Shape().add(wavyRing(60), {0, 0, 0}).add(wavyRing(60), {0, 0, 0.01}).off());
    const Ran text = fixture.run({"decimate", "a.off", "-o", "b.off", "--faces", "200"});
    QVERIFY(text.err.contains("of triangles intersect that did not before. --no-crossings prevents that."));
    const Ran json = fixture.run({"decimate", "a.off", "-o", "b.off", "--faces", "200", "--json"});
    const auto figures = nlohmann::json::parse(json.out.toStdString());
    QCOMPARE(figures["triangles"].get<int>(), decimateInspected(fixture, "b.off")["triangles"].get<int>());
    QVERIFY(figures["new_self_intersecting_pairs"].get<int>() > 0);
    QVERIFY(figures["distance_mm"].get<double>() > 0.0);
    QVERIFY(decimateInspected(fixture, "b.off")["self_intersecting_pairs"].get<int>() > 0);
    const Ran without = fixture.run({"decimate", "a.off", "-o", "b.off", "--faces", "200", "--no-crossings"});
    QVERIFY(!without.err.contains("intersect that"));
  }

  // The surface in the file is as near as reported, including the rounding to its number type.
  void roundingIsCounted() {
    const Fixture fixture;
    fixture.put("a.off", Shape().add(wavyRing(40), {1e4, 1e4, 1e4}).off());
    const Ran ran = fixture.run({"decimate", "a.off", "-o", "b.stl", "--error", "0.01"});
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.out.endsWith("No point is farther away than --error allows.\n"));
    QCOMPARE(fixture.run({"compare", "b.stl", "a.off", "--report", "r.json"}).code, 0);
    QVERIFY(fixture.json("r.json")["largest_distance_mm"].get<double>() <= 0.01);
    const Ran refused = fixture.run({"decimate", "a.off", "-o", "c.stl", "--error", "0.0005"});
    QCOMPARE(refused.code, 1);
    QVERIFY(refused.err.contains(
        "c.stl: the precision of its numbers moves vertices by up to 0.00084"));  // half of 2⁻¹⁰, three times
    QVERIFY(!fixture.names().contains("c.stl"));
  }

  void bordersStay() {
    const Fixture fixture;
    fixture.put("a.off", wavyRing(60).off());
    const Ran ran = fixture.run({"decimate", "a.off", "-o", "b.off", "--faces", "250", "--keep-borders"});
    QCOMPARE(ran.code, 0);
    const auto length = [&](const QString& name) {
      double sum = 0.0;
      const nlohmann::json inspected = decimateInspected(fixture, name);
      for (const auto& loop : inspected["loops"]) sum += loop["length_mm"].get<double>();
      return sum;
    };
    QVERIFY(std::abs(length("b.off") - length("a.off")) < 1e-9);
  }

  // A cube needs its twelve triangles.
  void whatCannotGo() {
    const Fixture fixture;
    fixture.put("a.off", cube(10).off());
    const Ran ran =
        fixture.run({"decimate", "a.off", "-o", "b.off", "--faces", "6", "--error", "0.01", "--no-crossings"});
    QCOMPARE(ran.code, 2);
    QVERIFY(ran.out.startsWith("Triangles: 12 before, 12 now.\n"));
    QCOMPARE(ran.err.count('\n'), 1);
    QCOMPARE(fixture.content("b.off").isEmpty(), false);
    const Ran alone = fixture.run({"decimate", "a.off", "-o", "b.off", "--error", "0.01"});
    QCOMPARE(alone.code, 2);
    QVERIFY(alone.err.contains("No triangle was removed"));
    QCOMPARE(fixture.run({"decimate", "a.off", "-o", "b.off", "--faces", "6", "--keep-creases", "30"}).code, 2);
    QCOMPARE(decimateInspected(fixture, "b.off")["triangles"].get<int>(), 12);
  }

  // Meshes that OpenMesh does not support are reported with a remedy that works.
  void quadricsOfADefectiveScan() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    const QString scan =
        data + (test::withLargeInputs() ? "/scans/pymeshfix/StanfordBunny.ply" : "/scans/meshlab-samples/conrod.stl");
    const int faces = test::sized(1'000, 5'000);
    const QStringList toFaces{"-o", "b.ply", "--method", "quadric", "--faces", QString::number(faces)};
    const Fixture fixture;
    const Ran refused = fixture.run(QStringList{"decimate", scan} + toFaces);
    QCOMPARE(refused.code, 1);
    QVERIFY2(refused.err.contains("repair the mesh first. --method bounded has no such limit."), refused.err);
    QCOMPARE(fixture.run({"repair", scan, "-o", "a.ply"}).code, 2);
    QCOMPARE(fixture.run(QStringList{"decimate", "a.ply"} + toFaces).code, 0);
    QCOMPARE(decimateInspected(fixture, "b.ply")["triangles"].get<int>(), faces);
  }

  void mistakes() {
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    const auto says = [&](QStringList words, const char* sentence) {
      const Ran ran = fixture.run(QStringList{"decimate", "a.off"} + words);
      return ran.code == 1 && ran.out.isEmpty() && ran.err.startsWith(QByteArray("handwheel: ") + sentence);
    };
    QVERIFY(says({"--faces", "3"}, "The option -o OUT is missing."));
    QVERIFY(says({"-o", "b.off"}, "Give a target: --faces N, --error MM or both."));
    QVERIFY(says({"-o", "b.off", "--faces", "0"}, "Give a target: --faces N, --error MM or both."));
    QVERIFY(says({"-o", "b.off", "--faces", "many"}, "--faces takes a whole number from 0 to 4294967295, not 'many'."));
    for (const char* error : {"0", "-1", "inf", "nan", "1mm"})
      QVERIFY(says({"-o", "b.off", "--error", error}, "--error takes a length from 1e-12 to 1e+12 mm, not "));
    QVERIFY(says({"-o", "b.off", "--faces", "4", "--keep-creases", "181"}, "--keep-creases takes an angle"));
    QCOMPARE(fixture.run({"decimate", "a.off", "-o", "b.docx", "--faces", "4"}).code, 1);
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }
};

HANDWHEEL_TEST(DecimateTest)
#include "DecimateTest.moc"
