// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;
using Json = nlohmann::json;

namespace {

std::vector<std::string> keysOf(const nlohmann::ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

}  // namespace

class RepairTest : public QObject {
  Q_OBJECT

 private:
  // A repair of the result of a repair writes the same file, unless the first said that a sheet looks like a hole now.
  static void isDoneInOneGo(const Fixture& fixture, const QString& scan) {
    if (fixture.run({"repair", scan, "-o", "once.stl"}).err.contains("which the repair has changed")) return;
    fixture.run({"repair", "once.stl", "-o", "twice.stl"});
    QVERIFY(!fixture.content("once.stl").isEmpty());
    QVERIFY2(fixture.content("twice.stl") == fixture.content("once.stl"), qPrintable(scan));
  }

 private slots:
  // The missing top comes back as two triangles, and nothing else changes.
  void closesTheCube() {
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--fill", "minimal", "--report", "r.json"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(
        ran.out,
        QByteArray("1 of 1 hole filled. b.stl: closed, manifold, oriented, free of self-intersections, one piece.\n"));
    const Json report = fixture.json("r.json");
    QCOMPARE(report.at("after").at("triangles").get<int>(), 12);
    QCOMPARE(report.at("after").at("vertices").get<int>(), 8);
    QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() - 1.0) < 1e-12);
    QCOMPARE(report.at("after").at("self_intersecting_pairs").get<int>(), 0);
    const Json loop = report.at("loops").at(0);
    QCOMPARE(loop.at("outcome").get<std::string>(), std::string("filled"));
    QCOMPARE(loop.at("method").get<std::string>(), std::string("minimal"));
    QVERIFY(loop.at("reason").is_null());
    QCOMPARE(loop.at("new_faces").get<int>(), 2);
    QCOMPARE(report.at("modified_vertices").get<int>(), 0);
    QVERIFY(report.at("unmodified_vertices_identical").get<bool>());
  }

  void reportHasItsKeysInOrder() {
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.ply", "--report", "r.json", "--unit", "cm"}).code, 0);
    const auto report = nlohmann::ordered_json::parse(fixture.content("r.json").toStdString());
    const std::vector<std::string> expected{
        "input", "output", "options", "before", "after", "loops", "loop_counts", "removed_degenerate",
        "removed_duplicates", "removed_flaps", "removed_debris", "reoriented_faces", "reoriented_bodies",
        "sheets_thickened", "sheets_left_open", "sheet_thickness_mm", "merged_vertices", "removed_layers",
        "stitched_cracks", "smoothed_vertices", "measured_noise_mm", "cut_crossings", "cut_faces", "inner_faces",
        "replaced_faces", "farthest_removed_vertex", "lost_loops", "non_orientable_cuts", "separated_vertices",
        "separation_incomplete", "intersection_removal_incomplete", "rounding_moved_mm", "modified_vertices",
        "unmodified_vertices_identical", "unit", "lost_attributes", "damage", "seconds",
        // The former keys.
        "turned_faces", "turned_bodies", "removed_part", "one_sided_cuts", "parted_vertices", "parting_cut_short",
        "cutting_cut_short", "touched_vertices", "untouched_vertices_identical"};
    QVERIFY(keysOf(report) == expected);
    const std::vector<std::string> loopKeys{"id",       "sheet_boundary",  "edges",  "outcome",
                                            "method",   "substitute",      "reason", "new_faces",
                                            "bend_deg", "bend_around_deg", "ms",     "rim"};
    QVERIFY(keysOf(report["loops"][0]) == loopKeys);
    QVERIFY(report["modified_vertices"] == report["touched_vertices"]);
    QVERIFY(report["options"]["rims"] == "keep" && report["options"]["open_sheets"] == "keep");
    QVERIFY(report["loop_counts"]["sheet_edges"] == report["loop_counts"]["sheet_boundaries"]);
    QCOMPARE(report["input"].get<std::string>(), std::string("a.off"));
    QCOMPARE(report["unit"].get<std::string>(), std::string("cm"));
    // The unit is a word in the report; nothing is scaled by it.
    QCOMPARE(report["after"]["bounding_box_mm"][1][0].get<double>(), 1.0);
    // "before" and "after" are what inspect says of the two files, but for the doubt about their unit.
    const auto inspected = [&](const char* name) {
      auto json = nlohmann::ordered_json::parse(fixture.run({"inspect", name, "--json"}).out.toStdString());
      json.erase("unit_doubtful");
      return json;
    };
    QVERIFY(report["before"] == inspected("a.off"));
    QVERIFY(report["after"] == inspected("b.ply"));
    QVERIFY(keysOf(report["after"]) == keysOf(inspected("b.ply")));
  }

  // 3MF says in which unit its numbers are: a cube of 2 m must not arrive as one of 2 mm.
  void unitOfAThreeMf() {
    const Fixture fixture;
    fixture.put("a.off", cube(2.0).off());
    for (const auto& [unit, millimetres] :
         {std::pair("mm", 2.0), std::pair("cm", 20.0), std::pair("m", 2000.0), std::pair("in", 50.8)}) {
      QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.3mf", "--unit", unit}).code, 0);
      const Json read = Json::parse(fixture.run({"inspect", "b.3mf", "--json"}).out.toStdString());
      QVERIFY(std::abs(read.at("bounding_box_mm").at(1).at(0).get<double>() - millimetres) < 1e-9);
    }
  }

  void everyMethodClosesTheCube_data() {
    QTest::addColumn<QString>("method");
    for (const char* method : {"fair", "refined", "ear", "minimal", "area", "dihedral", "ridge"})
      QTest::newRow(method) << method;
  }

  void everyMethodClosesTheCube() {
    QFETCH(QString, method);
    const Fixture fixture;
    fixture.put("a.off", openCube(2.0).off());
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.stl", "--fill", method, "--report", "r.json"}).code, 0);
    const Json after = fixture.json("r.json").at("after");
    QVERIFY(after.at("closed").get<bool>() && after.at("manifold").get<bool>() && after.at("oriented").get<bool>());
    QCOMPARE(after.at("self_intersecting_pairs").get<int>(), 0);
  }

  void soundInputStaysAsItIs() {
    const Fixture fixture;
    fixture.put("a.off", cube(0.3).off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.off"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out,
             QByteArray("No holes. b.off: closed, manifold, oriented, free of self-intersections, one piece.\n"));
    QCOMPARE(fixture.run({"inspect", "b.off", "--json"}).out, fixture.run({"inspect", "a.off", "--json"}).out);
  }

  void removesDuplicateAndDegenerateFaces() {
    Shape shape = cube();
    shape.faces.push_back(shape.faces.front());
    shape.faces.push_back({0, 1, 1});
    const Fixture fixture;
    fixture.put("a.off", shape.off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--report", "r.json"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out, QByteArray("No holes. b.stl: closed, manifold, oriented, free of self-intersections, one piece.\n"
                                 "Also: 1 degenerate triangle removed, 1 duplicate triangle removed.\n"));
    const Json report = fixture.json("r.json");
    QCOMPARE(report.at("removed_duplicates").get<int>(), 1);
    QCOMPARE(report.at("removed_degenerate").get<int>(), 1);
    QCOMPARE(report.at("after").at("triangles").get<int>(), 12);
    QVERIFY(report.at("unmodified_vertices_identical").get<bool>());
  }

  // Left as it is unless it is asked for; but such a part is not sound, and the exit code says so. Two cubes of which
  // one has a corner in the other.
  void whatPassesThroughItselfIsNotSound() {
    const Fixture fixture;
    fixture.put("a.off", cube().add(cube(), {0.41, 0.27, 0.33}).off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.off"});
    QCOMPARE(ran.code, 2);
    QVERIFY(ran.out.contains("b.off: closed, manifold, oriented, "));
    QVERIFY(ran.out.contains(" self-intersections, 2 pieces.\n"));
    QVERIFY(ran.err.contains("The surface intersects itself"));
    const Ran cut = fixture.run({"repair", "a.off", "-o", "b.ply", "--cut-crossings"});
    QCOMPARE(cut.code, 0);
    QVERIFY(cut.out.contains("b.ply: closed, manifold, oriented, free of self-intersections, 2 pieces.\n"));
  }

  void nothingButFacesWithoutArea() {
    const Fixture fixture;
    fixture.put("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.ply"});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err, QByteArray("handwheel: a.off: no triangle has an area, so there is nothing to repair.\n"));
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }

  void saysWhatIsNotKept() {
    const Fixture fixture;
    fixture.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    const Ran ran = fixture.run({"repair", "a.obj", "-o", "b.ply", "--report", "r.json"});
    QCOMPARE(ran.code, 2);
    QVERIFY(ran.err.startsWith("handwheel: Not kept: normals.\n"));
    QCOMPARE(fixture.json("r.json").at("lost_attributes").at(0).get<std::string>(), std::string("normals"));
  }

  void turnsFaces() {
    Shape shape = cube();
    std::swap(shape.faces[7][0], shape.faces[7][1]);
    const Fixture fixture;
    fixture.put("a.off", shape.off());
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.stl", "--report", "r.json"}).code, 0);
    const Json report = fixture.json("r.json");
    QVERIFY(!report.at("before").at("oriented").get<bool>());
    QVERIFY(report.at("after").at("oriented").get<bool>());
    QCOMPARE(report.at("reoriented_faces").get<int>(), 1);
    QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() - 1.0) < 1e-12);
  }

  // Two cubes that share an edge are parted there, by less than anyone can measure, and say so.
  void partsNonManifoldEdges() {
    Shape both = cube();
    both.add(cube(), {1, 1, 0});
    const Fixture fixture;
    fixture.put("a.off", both.off());
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.stl", "--report", "r.json"}).code, 0);
    const Json report = fixture.json("r.json");
    QCOMPARE(report.at("after").at("components").get<int>(), 2);
    QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() - 2.0) < 1e-5);
    QVERIFY(report.at("separated_vertices").get<int>() > 0);
    QVERIFY(report.at("modified_vertices").get<int>() > 0);
    QVERIFY(report.at("unmodified_vertices_identical").get<bool>());
  }

  // A hole, and an edge with four triangles.
  void againChangesNothing() {
    Shape both = openCube();
    both.add(cube(), {1, 1, 0});
    const Fixture fixture;
    fixture.put("a.off", both.off());
    isDoneInOneGo(fixture, "a.off");
  }

  void againChangesNothingOfScans() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    const Fixture fixture;
    for (const char* scan : {"geogram-data/SaraPezzini.obj", "admesh/conveyor.stl", "meshlab-rangemaps/lato180.ply",
                             "comodo/lego_figure_head.stl"})
      isDoneInOneGo(fixture, data + "/scans/" + scan);
  }

  void bunny() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    const Fixture fixture;
    const QString scan = data + "/scans/common-3d-test-models/stanford-bunny.obj";
    QCOMPARE(fixture.run({"repair", scan, "-o", "b.stl", "--report", "r.json"}).code, 0);
    const Json report = fixture.json("r.json");
    QCOMPARE(report.at("loops").size(), std::size_t(5));
    for (const Json& loop : report.at("loops")) QCOMPARE(loop.at("outcome").get<std::string>(), std::string("filled"));
    const Json after = report.at("after");
    QVERIFY(after.at("closed").get<bool>() && after.at("manifold").get<bool>() && after.at("oriented").get<bool>());
    QCOMPARE(after.at("self_intersecting_pairs").get<int>(), 0);
    QCOMPARE(report.at("modified_vertices").get<int>(), 0);
    QVERIFY(report.at("unmodified_vertices_identical").get<bool>());
  }

  // The shell of a conveyor, open below, gets no lid of 1 by 1.5 m that nobody asked for.
  void conveyor() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    const Fixture fixture;
    const Ran ran = fixture.run({"repair", data + "/scans/admesh/conveyor.stl", "-o", "b.stl"});
    QCOMPARE(ran.code, 2);
    QVERIFY(ran.err.contains("1 outer boundary of an open sheet stays open."));
  }

  // A range map with holes, islands in them and flakes at its border: its holes are filled, and then it is thickened.
  void rangeMap() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    const Fixture fixture;
    const QString scan = data + "/scans/meshlab-rangemaps/lato180.ply";
    fixture.run({"repair", scan, "-o", "b.ply", "--open-sheets", "back", "--report", "r.json"});
    const Json report = fixture.json("r.json"), after = report.at("after");
    QVERIFY(after.at("closed").get<bool>());
    QCOMPARE(after.at("self_intersecting_pairs").get<int>(), 0);
    QVERIFY(after.at("volume_mm3").get<double>() > 0.0);
    QVERIFY(after.at("non_manifold_vertices").get<int>() <= report.at("before").at("non_manifold_vertices").get<int>());
    const Json thickness = report.at("sheet_thickness_mm");
    QVERIFY(thickness.at("vertices").get<int>() > 40'000);
    QVERIFY(thickness.at("thin_vertices").get<int>() < thickness.at("vertices").get<int>() / 100);
  }
};

HANDWHEEL_TEST(RepairTest)
#include "RepairTest.moc"
