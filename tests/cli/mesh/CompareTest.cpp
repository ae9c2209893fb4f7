// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "BuildPaths.h"
#include "TestClass.h"

#include <QImage>
#include <QTest>
#include <QXmlStreamReader>

using namespace handwheel;

namespace {

// A flat sheet of 4 × 4, and the same by so much higher.
Shape sheetAt(double height) {
  return Shape().add(flatSheet(4), {0, 0, height});
}

}  // namespace

class CompareTest : public QObject {
  Q_OBJECT

 private slots:
  void statistics() {
    const Fixture fixture;
    fixture.put("high.off", sheetAt(0.5).off());
    fixture.put("low.off", sheetAt(0).off());
    const Ran ran = fixture.run({"compare", "high.off", "low.off", "--report", "r.json"}, "de_DE.UTF-8");
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.err, QByteArray());
    QVERIFY(ran.out.contains("Largest distance found either way: 0.5\n"));
    QVERIFY(QRegularExpression("RMS +0\\.5 +0\\.5\n").match(ran.out).hasMatch());
    QVERIFY(QRegularExpression("Mean +0\\.5 +-0\\.5\n").match(ran.out).hasMatch());
    const auto json = fixture.json("r.json");
    QCOMPARE(json["mesh_from_scan"]["vertices"].get<int>(), 25);
    QCOMPARE(json["mesh_from_scan"]["samples"].get<int>(), 200000);
    QVERIFY(std::abs(json["mesh_from_scan"]["area_mm2"].get<double>() - 16.0) < 1e-12);
    QVERIFY(std::abs(json["mesh_from_scan"]["rms_mm"].get<double>() - 0.5) < 1e-9);
    QVERIFY(std::abs(json["scan_from_mesh"]["mean_mm"].get<double>() + 0.5) < 1e-9);
    QCOMPARE(json["mesh_from_scan"]["percentiles_mm"]["99"].get<double>(), 0.5);
    QCOMPARE(json["mesh_from_scan"]["histogram"].size(), std::size_t{50});
  }

  void itselfIsNoDistanceAway() {
    const Fixture fixture;
    fixture.put("a.off", holedBox().off());
    QCOMPARE(fixture.run({"convert", "a.off", "a.handwheel"}).code, 0);
    const Ran ran = fixture.run({"compare", "a.off", "a.handwheel", "--samples", "1000", "--report", "r.json"});
    QCOMPARE(ran.code, 0);
    QVERIFY(fixture.json("r.json")["largest_distance_mm"].get<double>() < 1e-12);
    QCOMPARE(fixture.json("r.json")["mesh_from_scan"]["samples"].get<int>(), 1000);
  }

  void pageStandsAlone() {
    const Fixture fixture;
    fixture.put("a<&.off", cube(2).off());
    fixture.put("b.off", cube(1).off());
    QCOMPARE(fixture.run({"compare", "a<&.off", "b.off", "--report", "r.html"}).code, 0);
    const QByteArray page = fixture.content("r.html");
    QVERIFY(page.contains("a&lt;&amp;.off"));
    QCOMPARE(page.count("src="), 1);
    QVERIFY(page.contains("src=\"data:image/png;base64,") && !page.contains("href="));
    QXmlStreamReader xml(page);
    int bars = 0, pictures = 0, cells = 0;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      pictures += xml.name() == u"svg";
      bars += xml.name() == u"rect";
      cells += xml.name() == u"td";
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(pictures, 2);
    QCOMPARE(bars, 100);
    QVERIFY(cells > 20 && cells % 3 == 0);
    // The corner opposite to the shared one is √3 away.
    QVERIFY(page.contains("1.73205 at 2, 2, 2"));
  }

  void printed() {
    const Fixture fixture;
    fixture.put("a.off", cube(2).off());
    fixture.put("b.off", cube(1).off());
    const Ran ran = fixture.run({"compare", "a.off", "b.off", "--report", "r.pdf"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.err, QByteArray());
    const QByteArray pdf = fixture.content("r.pdf");
    QVERIFY(pdf.startsWith("%PDF-"));
    QVERIFY(pdf.trimmed().endsWith("%%EOF"));
    QCOMPARE(pdf.count("/Subtype /Image"), 3);  // histograms, and the mesh in colours
    QVERIFY(pdf.contains("/FontFile2"));
  }

  // Without a display and without xvfb-run the figures are written all the same.
  void withoutPicture() {
    const Fixture fixture;
    fixture.put("a.off", cube(2).off());
    fixture.put("b.off", cube(1).off());
    QProcess process;
    process.setWorkingDirectory(fixture.path());
    QProcessEnvironment environment = environmentWith("C");
    environment.remove("DISPLAY");
    environment.insert("PATH", "/nonexistent");
    process.setProcessEnvironment(environment);
    process.start(test::programPath(), {"compare", "a.off", "b.off", "--report", "r.html"});
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 0);
    QCOMPARE(process.readAllStandardError(),
             QByteArray("handwheel: No picture was made: there is no display, and xvfb-run is not installed.\n"));
    QVERIFY(fixture.content("r.html").contains("1.73205"));
    QVERIFY(!fixture.content("r.html").contains("src="));
  }

  // A cube within one of twice its size: each side at least that far away, so only colours of one sign.
  void deviationMap() {
    const Fixture fixture;
    fixture.put("a.off", Shape().add(cube(1), {0.5, 0.5, 0.5}).off());
    fixture.put("b.off", cube(2).off());
    QCOMPARE(fixture.run({"picture", "a.off", "map.png", "--scan", "b.off", "--range", "0.5"}).code, 0);
    const QImage map(fixture.path() + "/map.png");
    QCOMPARE(map.size(), QSize(1600, 1200));
    for (const QPoint& side : {QPoint(400, 300), QPoint(1200, 300), QPoint(400, 900), QPoint(1200, 900)}) {
      const QColor middle = map.pixelColor(side);
      QVERIFY2(middle.blue() > middle.red() + 60, qPrintable(middle.name()));
    }
    for (const char* range : {"0", "-1", "nan", "x"}) {
      QCOMPARE(fixture.run({"picture", "a.off", "n.png", "--scan", "b.off", "--range", range}).code, 1);
    }
    QCOMPARE(fixture.run({"picture", "a.off", "n.png", "--scan", "missing.off"}).code, 1);
    QCOMPARE(fixture.names(), (QStringList{"a.off", "b.off", "map.png"}));
  }

  void mistakes() {
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    fixture.put("a.html", cube().off());
    fixture.put("none.off", "OFF\n0 0 0\n");
    const auto says = [&](const QStringList& words, const char* sentence) {
      const Ran ran = fixture.run(words);
      return ran.code == 1 && ran.out.isEmpty() && ran.err.startsWith(QByteArray("handwheel: ") + sentence);
    };
    QVERIFY(says({"compare", "a.off"}, "The command compare needs FILE SCAN."));
    QVERIFY(says({"compare", "a.off", "a.off", "--samples", "-1"}, "--samples takes a number from 0 to 4000000."));
    QVERIFY(says({"compare", "a.off", "a.off", "--samples", "4000001"}, "--samples takes a number from 0 to 4000000."));
    QVERIFY(says({"compare", "a.off", "a.off", "--report", "r.txt"},
                 "--report takes a name that ends in .html, .pdf or .json."));
    QVERIFY(says({"compare", "a.off", "a.html", "--report", "./a.html"},
                 "FILE and SCAN cannot be the report too: ./a.html."));
    QCOMPARE(fixture.run({"compare", "a.off", "none.off"}).code, 1);
    QCOMPARE(fixture.run({"compare", "a.off", "missing.off"}).code, 1);
    QCOMPARE(fixture.run({"compare", "a.off", "a.off", "--report", "no/such/r.html"}).code, 1);
    QCOMPARE(fixture.names(), (QStringList{"a.html", "a.off", "none.off"}));
  }
};

HANDWHEEL_TEST(CompareTest)
#include "CompareTest.moc"
