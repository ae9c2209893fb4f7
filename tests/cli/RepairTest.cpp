// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "Shapes.h"

#include <QTest>
#include <sys/stat.h>
#include <unistd.h>

using namespace handwheel;
using Json = nlohmann::json;

namespace {

std::vector<std::string> keysOf(const nlohmann::ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

// The loop of the report with this many edges.
Json loopOf(const Json& report, int edges) {
  for (const Json& loop : report.at("loops")) {
    if (loop.at("edges") == edges) return loop;
  }
  return {};
}

// The box with three holes, repaired with these options besides.
struct Repaired {
  Ran ran;
  Json report;
};
Repaired repairedBox(const QStringList& options) {
  const Bench bench;
  bench.put("a.off", holedBox().off());
  const Ran ran = bench.run(QStringList{"repair", "a.off", "-o", "b.stl", "--report", "r.json"} + options);
  return {ran, bench.json("r.json")};
}

int idOf(int edges) {
  const Bench bench;
  bench.put("a.off", holedBox().off());
  return loopOf(Json::parse(bench.run({"inspect", "a.off", "--json"}).out.toStdString()), edges).at("id");
}

}  // namespace

class RepairTest : public QObject {
  Q_OBJECT

 private slots:
  // The missing top comes back as two triangles, and nothing else changes.
  void closesTheCube() {
    const Bench bench;
    bench.put("a.off", openCube().off());
    const Ran ran = bench.run({"repair", "a.off", "-o", "b.stl", "--fill", "minimal", "--report", "r.json"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.out, QByteArray("1 of 1 holes filled. b.stl is closed, manifold and oriented.\n"));
    const Json report = bench.json("r.json");
    QCOMPARE(report.at("after").at("triangles").get<int>(), 12);
    QCOMPARE(report.at("after").at("vertices").get<int>(), 8);
    QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() - 1.0) < 1e-12);
    QCOMPARE(report.at("after").at("self_intersecting_pairs").get<int>(), 0);
    const Json loop = report.at("loops").at(0);
    QCOMPARE(loop.at("outcome").get<std::string>(), std::string("filled"));
    QCOMPARE(loop.at("method").get<std::string>(), std::string("minimal"));
    QVERIFY(loop.at("reason").is_null());
    QCOMPARE(loop.at("new_faces").get<int>(), 2);
    QCOMPARE(report.at("touched_vertices").get<int>(), 0);
    QVERIFY(report.at("untouched_vertices_identical").get<bool>());
  }

  void reportHasItsKeysInOrder() {
    const Bench bench;
    bench.put("a.off", openCube().off());
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.ply", "--report", "r.json", "--unit", "cm"}).code, 0);
    const auto report = nlohmann::ordered_json::parse(bench.content("r.json").toStdString());
    const std::vector<std::string> expected{
        "input", "output", "before", "after", "loops", "removed_degenerate", "removed_duplicates", "removed_flaps",
        "removed_debris",
        "turned_faces", "merged_vertices", "parted_vertices", "touched_vertices", "untouched_vertices_identical", "unit",
        "lost_attributes", "damage", "seconds"};
    QVERIFY(keysOf(report) == expected);
    const std::vector<std::string> loopKeys{"id", "edges", "outcome", "method", "reason", "new_faces", "ms"};
    QVERIFY(keysOf(report["loops"][0]) == loopKeys);
    QCOMPARE(report["input"].get<std::string>(), std::string("a.off"));
    QCOMPARE(report["unit"].get<std::string>(), std::string("cm"));
    // The unit is a word in the report; nothing is scaled by it.
    QCOMPARE(report["after"]["bounding_box_mm"][1][0].get<double>(), 1.0);
    // "before" and "after" are what inspect says of the two files.
    const auto inspected = [&](const char* name) {
      return nlohmann::ordered_json::parse(bench.run({"inspect", name, "--json"}).out.toStdString());
    };
    QVERIFY(report["before"] == inspected("a.off"));
    QVERIFY(report["after"] == inspected("b.ply"));
    QVERIFY(keysOf(report["after"]) == keysOf(inspected("b.ply")));
  }

  void everyMethodClosesTheCube_data() {
    QTest::addColumn<QString>("method");
    for (const char* method : {"fair", "refined", "ear", "minimal"}) QTest::newRow(method) << method;
  }
  void everyMethodClosesTheCube() {
    QFETCH(QString, method);
    const Bench bench;
    bench.put("a.off", openCube(2.0).off());
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl", "--fill", method, "--report", "r.json"}).code, 0);
    const Json after = bench.json("r.json").at("after");
    QVERIFY(after.at("closed").get<bool>() && after.at("manifold").get<bool>() && after.at("oriented").get<bool>());
    QCOMPARE(after.at("self_intersecting_pairs").get<int>(), 0);
  }

  void soundInputStaysAsItIs() {
    const Bench bench;
    bench.put("a.off", cube(0.3).off());
    const Ran ran = bench.run({"repair", "a.off", "-o", "b.off"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out, QByteArray("0 of 0 holes filled. b.off is closed, manifold and oriented.\n"));
    QCOMPARE(bench.run({"inspect", "b.off", "--json"}).out, bench.run({"inspect", "a.off", "--json"}).out);
  }

  void removesDuplicateAndDegenerateFaces() {
    Shape shape = cube();
    shape.faces.push_back(shape.faces.front());
    shape.faces.push_back({0, 1, 1});
    const Bench bench;
    bench.put("a.off", shape.off());
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl", "--report", "r.json"}).code, 0);
    const Json report = bench.json("r.json");
    QCOMPARE(report.at("removed_duplicates").get<int>(), 1);
    QCOMPARE(report.at("removed_degenerate").get<int>(), 1);
    QCOMPARE(report.at("after").at("triangles").get<int>(), 12);
    QVERIFY(report.at("untouched_vertices_identical").get<bool>());
  }

  void turnsFaces() {
    Shape shape = cube();
    std::swap(shape.faces[7][0], shape.faces[7][1]);
    const Bench bench;
    bench.put("a.off", shape.off());
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl", "--report", "r.json"}).code, 0);
    const Json report = bench.json("r.json");
    QVERIFY(!report.at("before").at("oriented").get<bool>());
    QVERIFY(report.at("after").at("oriented").get<bool>());
    QCOMPARE(report.at("turned_faces").get<int>(), 1);
    QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() - 1.0) < 1e-12);
  }

  // Two cubes that share an edge are parted there, by less than anyone can measure, and say so.
  void partsNonManifoldEdges() {
    Shape both = cube();
    both.add(cube(), {1, 1, 0});
    const Bench bench;
    bench.put("a.off", both.off());
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl", "--report", "r.json"}).code, 0);
    const Json report = bench.json("r.json");
    QCOMPARE(report.at("after").at("components").get<int>(), 2);
    QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() - 2.0) < 1e-5);
    QVERIFY(report.at("parted_vertices").get<int>() > 0);
    QVERIFY(report.at("touched_vertices").get<int>() > 0);
    QVERIFY(report.at("untouched_vertices_identical").get<bool>());
  }

  void keepOpen() {
    const Repaired box = repairedBox({"--keep-open", QString::number(idOf(6))});
    QCOMPARE(box.ran.code, 2);
    QCOMPARE(loopOf(box.report, 4).at("outcome").get<std::string>(), std::string("filled"));
    QCOMPARE(loopOf(box.report, 8).at("outcome").get<std::string>(), std::string("filled"));
    const Json kept = loopOf(box.report, 6);
    QCOMPARE(kept.at("outcome").get<std::string>(), std::string("kept-open"));
    QVERIFY(kept.at("method").is_null());
    QCOMPARE(kept.at("reason").get<std::string>(), std::string("You keep it open."));
    QCOMPARE(box.report.at("after").at("boundary_loops").get<int>(), 1);
    QCOMPARE(box.ran.err, QByteArray("handwheel: Loop " + QByteArray::number(idOf(6)) +
                                     " (6 edges) stays open: you keep it open.\n"));
  }

  void keepOpenTakesAList() {
    const Repaired box = repairedBox({QString("--keep-open=%1,%2").arg(idOf(6)).arg(idOf(4))});
    QCOMPARE(box.ran.code, 2);
    QCOMPARE(box.report.at("after").at("boundary_loops").get<int>(), 2);
    QCOMPARE(loopOf(box.report, 8).at("outcome").get<std::string>(), std::string("filled"));
  }

  void unknownLoopIsRefused() {
    const Bench bench;
    bench.put("a.off", openCube().off());
    const Ran ran = bench.run({"repair", "a.off", "-o", "b.stl", "--keep-open", "7"});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err, QByteArray("handwheel: There is no loop 7 to keep open.\nTry 'handwheel help repair'.\n"));
    QCOMPARE(bench.names(), QStringList{"a.off"});
  }

  void maxHole() {
    const Repaired box = repairedBox({"--max-hole", "6"});
    QCOMPARE(box.ran.code, 2);
    QCOMPARE(loopOf(box.report, 4).at("outcome").get<std::string>(), std::string("filled"));
    QCOMPARE(loopOf(box.report, 6).at("outcome").get<std::string>(), std::string("filled"));
    QCOMPARE(loopOf(box.report, 8).at("reason").get<std::string>(),
             std::string("It has more edges than allowed."));
    QCOMPARE(box.report.at("after").at("boundary_loops").get<int>(), 1);
  }

  void sheetStaysOpen() {
    const Bench bench;
    bench.put("a.off", flatSheet(4).off());
    const Ran ran = bench.run({"repair", "a.off", "-o", "b.stl", "--report", "r.json"});
    QCOMPARE(ran.code, 2);
    QVERIFY(ran.err.contains("outer edge"));
    QVERIFY(ran.err.contains("--fill-rims"));
    const Json loop = bench.json("r.json").at("loops").at(0);
    QCOMPARE(loop.at("outcome").get<std::string>(), std::string("kept-open"));
    QCOMPARE(loop.at("reason").get<std::string>(), std::string("It is the outer edge of an open sheet."));
  }

  // A long channel of two walls at a right angle is a sheet; asked to, its edge is filled to a bar of volume 1·1/2·10.
  void fillRims() {
    const auto at = [](int x, int y) { return std::array<double, 3>{1.0 * x, y == 0 ? 1.0 : 0.0, y == 2 ? 1.0 : 0.0}; };
    const Bench bench;
    bench.put("a.off", grid(10, 2, at, [](int, int) { return false; }).off());
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl"}).code, 2);
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl", "--fill-rims", "--fill", "minimal", "--report", "r.json"}).code, 0);
    QVERIFY(std::abs(std::abs(bench.json("r.json").at("after").at("volume_mm3").get<double>()) - 5.0) < 1e-12);
  }

  void removesDebrisWhenAsked() {
    Shape shape = holedBox();
    shape.add({{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, {{0, 1, 2}}}, {20, 0, 0});
    const Bench bench;
    bench.put("a.off", shape.off());
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl"}).code, 2);
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl", "--remove-debris", "--report", "r.json"}).code, 0);
    const Json report = bench.json("r.json");
    QCOMPARE(report.at("removed_debris").get<int>(), 1);
    QCOMPARE(report.at("after").at("components").get<int>(), 1);
    QCOMPARE(report.at("after").at("bounding_box_mm").at(1).at(0).get<double>(), 10.0);
    QVERIFY(report.at("untouched_vertices_identical").get<bool>());
  }

  void outputMayBeTheInput() {
    const Bench bench;
    bench.put("a.off", openCube().off());
    QCOMPARE(bench.run({"repair", "a.off", "-o", "a.off"}).code, 0);
    QVERIFY(Json::parse(bench.run({"inspect", "a.off", "--json"}).out.toStdString()).at("closed").get<bool>());
    QCOMPARE(bench.names(), QStringList{"a.off"});
  }

  void partialReadsWhatIsThere() {
    const Bench bench;
    QByteArray damaged = openCube().off();
    damaged.replace("10 0\n", "11 0\n").append("3 0 1 99\n");  // one face more, with a vertex that does not exist
    bench.put("a.off", damaged);
    QCOMPARE(bench.run({"repair", "a.off", "-o", "b.stl"}).code, 1);
    QCOMPARE(bench.names(), QStringList{"a.off"});
    const Ran ran = bench.run({"repair", "a.off", "-o", "b.stl", "--partial", "--report", "r.json"});
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.err.contains("99"));
    QVERIFY(bench.json("r.json").at("damage").size() >= 1);
  }

  void missingFolder() {
    const Bench bench;
    bench.put("a.off", openCube().off());
    const Ran ran = bench.run({"repair", "a.off", "-o", "no/such/b.stl"});
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.startsWith("handwheel: no/such/b.stl: "));
    QVERIFY(ran.err.contains("No such file or directory"));
    QCOMPARE(bench.names(), QStringList{"a.off"});
  }

  void readOnlyFolder() {
    if (geteuid() == 0) QSKIP("the superuser may write everywhere");
    const Bench bench;
    bench.put("a.off", openCube().off());
    QCOMPARE(chmod(bench.path().toLocal8Bit(), 0500), 0);
    const Ran ran = bench.run({"repair", "a.off", "-o", "b.stl"});
    QCOMPARE(chmod(bench.path().toLocal8Bit(), 0700), 0);
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.contains("Permission denied"));
    QCOMPARE(bench.names(), QStringList{"a.off"});
  }

  void unknownEndingIsToldBeforeTheWork() {
    const Bench bench;
    const Ran ran = bench.run({"repair", "none.stl", "-o", "b.docx"});
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.contains(".docx"));
  }

  // Without a display and without xvfb-run there is no picture, but the repair is done.
  void noPictureIsNoFailure() {
    const Bench bench;
    bench.put("a.off", openCube().off());
    QProcess process;
    QProcessEnvironment environment = environmentWith("C");
    environment.remove("DISPLAY");
    environment.insert("PATH", bench.path());
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(bench.path());
    process.start(HANDWHEEL_PROGRAM, {"repair", "a.off", "-o", "b.stl", "--screenshot", "s.png"});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 0);
    QCOMPARE(process.readAllStandardError(),
             QByteArray("handwheel: No picture was made: there is no display, and xvfb-run is not installed.\n"));
    QCOMPARE(bench.names(), (QStringList{"a.off", "b.stl"}));
  }

  void bunny() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    const Bench bench;
    const QString scan = data + "/scans/common-3d-test-models/stanford-bunny.obj";
    QCOMPARE(bench.run({"repair", scan, "-o", "b.stl", "--report", "r.json"}).code, 0);
    const Json report = bench.json("r.json");
    QCOMPARE(report.at("loops").size(), std::size_t(5));
    for (const Json& loop : report.at("loops")) QCOMPARE(loop.at("outcome").get<std::string>(), std::string("filled"));
    const Json after = report.at("after");
    QVERIFY(after.at("closed").get<bool>() && after.at("manifold").get<bool>() && after.at("oriented").get<bool>());
    QCOMPARE(after.at("self_intersecting_pairs").get<int>(), 0);
    QCOMPARE(report.at("touched_vertices").get<int>(), 0);
    QVERIFY(report.at("untouched_vertices_identical").get<bool>());
  }
};

QTEST_GUILESS_MAIN(RepairTest)
#include "RepairTest.moc"
