// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "HeadScan.h"
#include "LargeInputs.h"
#include "TestClass.h"

#include <QTest>
#include <random>

using namespace handwheel;
using Json = nlohmann::json;

namespace {

constexpr double kRadius = 10.7;

// A can without its lid: the bottom at one height, an edge of so many corners at the other. Some of its edges are 2e-5
// mm long, as scans have them that were cut by a plane; the edge may be frayed, up and down.
Shape openCan(int corners, int shortEdges, double bottom, double top, double fray = 0.0) {
  std::mt19937 random(1);
  std::vector<double> angles;
  for (int i = 0; i < corners - shortEdges; ++i) {
    angles.push_back(2.0 * M_PI * i / (corners - shortEdges));
    if (i < shortEdges) angles.push_back(angles.back() + 2e-5 / kRadius);
  }
  Shape shape;
  for (double a : angles) shape.points.push_back({kRadius * std::cos(a), kRadius * std::sin(a), bottom});
  for (double a : angles) {
    const double z = top + fray * (2.0 * random() / 4294967295.0 - 1.0);
    shape.points.push_back({kRadius * std::cos(a), kRadius * std::sin(a), z});
  }
  shape.points.push_back({0, 0, bottom});
  const int n = static_cast<int>(angles.size());
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    for (std::array<int, 3> t : {std::array{i, j, n + j}, {i, n + j, n + i}, {2 * n, j, i}}) {
      if (top < bottom) std::swap(t[1], t[2]);
      shape.faces.push_back(t);
    }
  }
  return shape;
}

double discArea() {
  return M_PI * kRadius * kRadius;
}

std::size_t filled(const Json& report) {
  return static_cast<std::size_t>(std::count_if(report.at("loops").begin(), report.at("loops").end(),
                                                [](const Json& loop) { return loop.at("outcome") == "filled"; }));
}

}  // namespace

// Loops of thousands of edges, as saws and planes leave them in scans.
class RepairLongLoopsTest : public QObject {
  Q_OBJECT

 private slots:
  void aCutWithVeryShortEdges() {
    const Fixture fixture;
    fixture.put("a.off", openCan(2554, 26, 0, 20).off());
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.off", "--report", "r.json"}).code, 0);
    const Json report = fixture.json("r.json");
    QCOMPARE(report.at("loops").at(0).at("edges").get<int>(), 2554);
    QCOMPARE(filled(report), std::size_t(1));
    QCOMPARE(report.at("after").at("self_intersecting_pairs").get<int>(), 0);
    QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() / (discArea() * 20) - 1.0) < 1e-2);
  }

  // Two cans, mouth to mouth.
  void tornBorders_data() {
    QTest::addColumn<double>("gap");
    QTest::addColumn<int>("parts");
    QTest::newRow("apart") << 0.01 << 2;
    QTest::newRow("one border, torn by rounding") << 1e-5 << 1;
  }
  void tornBorders() {
    QFETCH(double, gap);
    QFETCH(int, parts);
    Shape both = openCan(2200, 0, 0, 20 - gap / 2, gap / 5);
    both.add(openCan(2200, 0, 40, 20 + gap / 2, gap / 5), {0, 0, 0});
    const Fixture fixture;
    fixture.put("a.off", both.off());
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.off", "--report", "r.json"}).code, 0);
    const Json report = fixture.json("r.json");
    QCOMPARE(report.at("before").at("loops").size(), std::size_t(2));
    QCOMPARE(filled(report), std::size_t(2));
    QCOMPARE(report.at("after").at("components").get<int>(), parts);
    QCOMPARE(report.at("after").at("self_intersecting_pairs").get<int>(), 0);
    if (parts == 1)
      QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() / (discArea() * 40) - 1.0) < 1e-3);
  }

  // A scan whose bottom is cut by a plane at four positions, with 2,554 edges each; most of its small loops are torn
  // where the surface crosses itself.
  void scannedHead() {
    if (!QFile::exists(kHeadScan)) QSKIP("head.stl of the package occt-misc is not installed");
    const int sections = test::sized(2, 4);
    // The whole scan has 62 loops. 34 of them are in its first two sections, which have two outlines where the third
    // begins.
    const std::size_t loops = test::sized<std::size_t>(34 + 2, 62);
    const Fixture fixture;
    fixture.put("a.stl", headSections(sections));
    // All holes are closed; but cutting leaves debris.
    const Ran ran = fixture.run({"repair", "a.stl", "-o", "b.stl", "--report", "r.json"});
    QCOMPARE(ran.code, 2);
    const Json report = fixture.json("r.json");
    const int debris = report.at("after").at("debris").get<int>();
    QCOMPARE(report.at("before").at("debris").get<int>(), 0);
    QVERIFY(debris > 1);
    QVERIFY2(ran.err.contains("New: " + QByteArray::number(debris) + " pieces of debris"), ran.err);
    for (const Json& loop : report.at("loops")) QCOMPARE(loop.at("bend_deg").is_null(), loop.at("new_faces") == 0);
    QVERIFY(report.at("loops").size() >= loops);  // and what cutting lays open
    int cuts = 0;
    for (const Json& loop : report.at("loops")) {
      if (loop.at("edges") != 2554) continue;
      ++cuts;
      QCOMPARE(loop.at("outcome").get<std::string>(), std::string("filled"));
    }
    QCOMPARE(cuts, sections);
    // But the outline of a flake beside the head, which is an open sheet; another repair would take it for a hole.
    QVERIFY2(ran.err.contains("1 outer boundary of an open sheet, which the repair has changed, looks like a hole now"),
             ran.err);
    QCOMPARE(filled(report) + 1, report.at("loops").size());
    QVERIFY(report.at("unmodified_vertices_identical").get<bool>());

    fixture.put("k.stl", headSections(test::sized(1, 4)));
    QCOMPARE(fixture.run({"repair", "k.stl", "-o", "c.stl", "--keep-tangles", "--report", "k.json"}).code,
             2);  // the former name
    const Json kept = fixture.json("k.json");
    QCOMPARE(kept.at("replaced_faces").get<int>(), 0);
    QVERIFY(filled(kept) < kept.at("loops").size());
  }
};

HANDWHEEL_TEST(RepairLongLoopsTest)
#include "RepairLongLoopsTest.moc"
