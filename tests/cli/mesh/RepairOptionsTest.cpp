// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;
using Json = nlohmann::json;

namespace {

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
  const Fixture fixture;
  fixture.put("a.off", holedBox().off());
  const Ran ran = fixture.run(QStringList{"repair", "a.off", "-o", "b.stl", "--report", "r.json"} + options);
  return {ran, fixture.json("r.json")};
}

int idOf(int edges) {
  const Fixture fixture;
  fixture.put("a.off", holedBox().off());
  return loopOf(Json::parse(fixture.run({"inspect", "a.off", "--json"}).out.toStdString()), edges).at("id");
}

}  // namespace

class RepairOptionsTest : public QObject {
  Q_OBJECT

 private slots:
  // A setting that no repair reads would wrongly seem to have an effect.
  void refusesSettingsThatItDoesNotRead() {
    const Fixture fixture;
    fixture.put("a.off", holedBox().off());
    for (const char* unread : {"servo.rate=500", "mesh.decimation_error=1e-3", "draft,snap.radius=1"}) {
      const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--fidelity", unread});
      QCOMPARE(ran.code, 1);
      QVERIFY2(ran.err.contains("repair does not use the setting"), ran.err);
      for (const char* id :
           {"mesh.near_weld", "mesh.fill_method", "mesh.fill_continuity", "mesh.patch_density", "mesh.piece_edges"})
        QVERIFY2(ran.err.contains(id), id);
    }
  }

  void keepOpen() {
    const Repaired box = repairedBox({"--keep-open", QString::number(idOf(6))});
    QCOMPARE(box.ran.code, 2);
    QCOMPARE(loopOf(box.report, 4).at("outcome").get<std::string>(), std::string("filled"));
    QCOMPARE(loopOf(box.report, 8).at("outcome").get<std::string>(), std::string("filled"));
    const Json kept = loopOf(box.report, 6);
    QCOMPARE(kept.at("outcome").get<std::string>(), std::string("kept-open"));
    QVERIFY(kept.at("method").is_null());
    QCOMPARE(kept.at("reason").get<std::string>(), std::string("It is marked to be kept open."));
    QCOMPARE(box.report.at("after").at("boundary_loops").get<int>(), 1);
    QCOMPARE(box.ran.out, QByteArray("2 of 3 holes filled, 1 kept open. b.stl: not closed, manifold, oriented, free of "
                                     "self-intersections, one piece.\n"));
    QCOMPARE(box.ran.err,
             QByteArray("handwheel: Hole " + QByteArray::number(idOf(6) + 1) + " (id " + QByteArray::number(idOf(6)) +
                        ", 6 edges) stays open: it is marked to be kept open.\n"));
  }

  void keepOpenTakesAList() {
    const Repaired box = repairedBox({QString("--keep-open=%1,%2").arg(idOf(6)).arg(idOf(4))});
    QCOMPARE(box.ran.code, 2);
    QCOMPARE(box.report.at("after").at("boundary_loops").get<int>(), 2);
    QCOMPARE(loopOf(box.report, 8).at("outcome").get<std::string>(), std::string("filled"));
  }

  void unknownLoopIsRefused() {
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--keep-open", "7"});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err, QByteArray("handwheel: There is no loop 7 to keep open; 'handwheel inspect' lists them.\nTry "
                                 "'handwheel help repair'.\n"));
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }

  void maxHole() {
    const Repaired box = repairedBox({"--max-hole", "6"});
    QCOMPARE(box.ran.code, 2);
    QCOMPARE(loopOf(box.report, 4).at("outcome").get<std::string>(), std::string("filled"));
    QCOMPARE(loopOf(box.report, 6).at("outcome").get<std::string>(), std::string("filled"));
    QCOMPARE(loopOf(box.report, 8).at("reason").get<std::string>(), std::string("It has more edges than allowed."));
    QCOMPARE(box.report.at("after").at("boundary_loops").get<int>(), 1);
  }

  void sheetStaysOpen() {
    const Fixture fixture;
    fixture.put("a.off", flatSheet(4).off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--report", "r.json"});
    QCOMPARE(ran.code, 2);
    QVERIFY(ran.err.contains("outer boundary"));
    QVERIFY(ran.err.contains("1 outer boundary of an open sheet stays open. --open-sheets back"));
    QVERIFY(ran.err.contains("--open-sheets fill"));
    QVERIFY(ran.out.contains("No holes"));
    const Json loop = fixture.json("r.json").at("loops").at(0);
    QCOMPARE(loop.at("outcome").get<std::string>(), std::string("kept-open"));
    QCOMPARE(loop.at("reason").get<std::string>(), std::string("It is the outer boundary of an open sheet."));
  }

  // A long channel of two walls at a right angle is a sheet; asked to, it gets a back, or its edge is filled to a bar
  // of volume 1·1/2·10.
  void fillRims() {
    const auto at = [](int x, int y) { return std::array<double, 3>{1.0 * x, y == 0 ? 1.0 : 0.0, y == 2 ? 1.0 : 0.0}; };
    const Fixture fixture;
    fixture.put("a.off", grid(10, 2, at, [](int, int) { return false; }).off());
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.stl"}).code, 2);
    // The former name.
    const Ran backed = fixture.run({"repair", "a.off", "-o", "b.stl", "--rims", "back", "--report", "r.json"});
    QCOMPARE(backed.code, 0);
    QVERIFY2(backed.out.startsWith("No holes, 1 of 1 outer boundary closed. "), backed.out.constData());
    QCOMPARE(fixture.json("r.json").at("loops").at(0).at("method").get<std::string>(), std::string("backed"));
    QCOMPARE(
        fixture
            .run({"repair", "a.off", "-o", "b.stl", "--open-sheets", "fill", "--fill", "minimal", "--report", "r.json"})
            .code,
        0);
    QVERIFY(std::abs(std::abs(fixture.json("r.json").at("after").at("volume_mm3").get<double>()) - 5.0) < 1e-12);
  }

  // A flat square of 10 × 10 cells of 1 becomes a box of any thickness.
  void thickness() {
    const Fixture fixture;
    fixture.put("a.off", flatSheet(10).off());
    for (const auto& [asked, said] : {std::pair(0.125, "0.125 mm"), {2.0, "2.00 mm"}}) {
      const Ran ran = fixture.run({"repair", "a.off", "-o", "b.ply", "--open-sheets", "back", "--thickness",
                                   QString::number(asked), "--report", "r.json"});
      QCOMPARE(ran.code, 0);
      QVERIFY2(ran.out.contains(QByteArray("sheets thickened by ") + said), qPrintable(ran.out));
      const Json report = fixture.json("r.json");
      QCOMPARE(report.at("sheets_thickened").get<int>(), 1);
      QCOMPARE(report.at("sheets_left_open").get<int>(), 0);
      QCOMPARE(report.at("sheet_thickness_mm").at("least").get<double>(), asked);
      QCOMPARE(report.at("sheet_thickness_mm").at("largest").get<double>(), asked);
      QCOMPARE(report.at("sheet_thickness_mm").at("vertices").get<int>(), 11 * 11);
      QCOMPARE(report.at("sheet_thickness_mm").at("thin_vertices").get<int>(), 0);
      QCOMPARE(report.at("options").at("thickness_mm").get<double>(), asked);
      const Json box = report.at("after").at("bounding_box_mm");
      QCOMPARE(box.at(1).at(2).get<double>() - box.at(0).at(2).get<double>(), asked);
      QVERIFY(std::abs(report.at("after").at("volume_mm3").get<double>() - 10 * 10 * asked) < 1e-9);
    }
    QCOMPARE(fixture.run({"edit", "a.off", "back 0 --thickness 0.1", "-o", "c.ply"}).code, 0);
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.ply", "--open-sheets", "back", "--thickness", "0"}).code, 1);
  }

  // A flake behind the middle of the sheet leaves room for less: at how many vertices is in report and text.
  void saysWhereTheThicknessIsNotReached() {
    Shape shape = flatSheet(10);
    Shape flake;
    flake.points = {{5.1, 5.1, -0.5}, {5.3, 5.1, -3.0}, {5.1, 5.3, -3.0}};
    flake.faces = {{0, 1, 2}};
    shape.add(flake, {0, 0, 0});
    const Fixture fixture;
    fixture.put("a.off", shape.off());
    const Ran ran = fixture.run({"edit", "a.off", "back 0 --thickness 2", "-o", "c.ply"});
    QCOMPARE(ran.code, 0);
    QVERIFY2(ran.out.contains("thinner than requested at "), qPrintable(ran.out));
    QVERIFY2(ran.out.contains(" of 121 vertices"), qPrintable(ran.out));
  }

  // One of two sheets is so far from the origin that single precision cannot represent the thickness.
  void saysWhichSheetsStayOpen() {
    Shape shape = flatSheet(4);
    shape.add(flatSheet(4), {1e6, 1e6, 1e6});
    const Fixture fixture;
    fixture.put("a.off", shape.off());
    const Ran far = fixture.run(
        {"repair", "a.off", "-o", "b.stl", "--open-sheets", "back", "--thickness", "0.001", "--report", "r.json"});
    QCOMPARE(far.code, 2);
    QVERIFY2(
        far.out.contains("sheets: 1 of 2 thickened by 0.00100 mm; 1 sheet left open: the numbers of the file cannot"),
        qPrintable(far.out));
    QVERIFY2(far.err.contains("stays open: the numbers of the file cannot show such a thickness"), qPrintable(far.err));
    QCOMPARE(fixture.json("r.json").at("sheets_thickened").get<int>(), 1);
    QCOMPARE(fixture.json("r.json").at("sheets_left_open").get<int>(), 1);
    const Ran edited = fixture.run({"edit", "a.off", "back 0,1 --thickness 0.001 --numbers single", "-o", "c.off"});
    QCOMPARE(edited.code, 2);
    QVERIFY2(edited.err.contains("1 of 2 thickened"), qPrintable(edited.err));
  }

  void removesDebrisWhenAsked() {
    Shape shape = holedBox();
    shape.add({{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, {{0, 1, 2}}}, {20, 0, 0});
    const Fixture fixture;
    fixture.put("a.off", shape.off());
    const Ran kept = fixture.run({"repair", "a.off", "-o", "b.stl", "--open-sheets", "keep"});
    QCOMPARE(kept.code, 2);
    QVERIFY2(!kept.err.contains("New:"), kept.err);  // it was there before, whether a report is written or not
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.stl", "--remove-debris", "--report", "r.json"}).code, 0);
    const Json report = fixture.json("r.json");
    QCOMPARE(report.at("removed_debris").get<int>(), 1);
    QCOMPARE(report.at("after").at("components").get<int>(), 1);
    QCOMPARE(report.at("after").at("bounding_box_mm").at(1).at(0).get<double>(), 10.0);
    QVERIFY(report.at("unmodified_vertices_identical").get<bool>());
  }

  // Two cubes that pass through each other: each is sound, and together they are not what one wants to print.
  void crossingsAreReportedAndCut() {
    const Fixture fixture;
    fixture.put("a.off", cube(2).add(cube(2), {1.1, 0.9, 1.3}).off());
    const Ran repaired = fixture.run({"repair", "a.off", "-o", "b.off"});
    QCOMPARE(repaired.code, 2);
    QVERIFY(repaired.err.contains("The surface intersects itself: "));
    const Ran cut = fixture.run({"repair", "a.off", "-o", "b.off", "--cut-crossings", "--report", "r.json"});
    QCOMPARE(cut.code, 0);
    QCOMPARE(cut.err, QByteArray("handwheel: 1 body lies inside another; --unite removes what lies inside.\n"));
    QCOMPARE(fixture.json("r.json").at("cut_crossings").get<int>(), 1);
    QCOMPARE(fixture.json("r.json").at("after").at("self_intersecting_pairs").get<int>(), 0);
    // All of both is still there, what they share twice.
    QVERIFY(std::abs(fixture.json("r.json").at("after").at("volume_mm3").get<double>() - 16.0) < 1e-9);
  }

  // The common part of both bodies occurs once. Separate bodies stay as they are.
  void bodiesAreUnited() {
    const Fixture fixture;
    fixture.put("a.off", cube(2).add(cube(2), {1.1, 0.9, 1.3}).off());
    const Ran united = fixture.run({"repair", "a.off", "-o", "b.off", "--unite", "--report", "r.json"});
    QCOMPARE(united.code, 0);
    QCOMPARE(united.err, QByteArray());
    const Json after = fixture.json("r.json").at("after");
    QCOMPARE(after.at("self_intersecting_pairs").get<int>(), 0);
    QCOMPARE(after.at("components").get<int>(), 1);
    QVERIFY(std::abs(after.at("volume_mm3").get<double>() - (16.0 - 0.9 * 1.1 * 0.7)) < 1e-9);
    QVERIFY(fixture.json("r.json").at("inner_faces").get<int>() > 0);
    QVERIFY(united.out.contains("bodies that intersect united"));
    QCOMPARE(fixture.run({"edit", "a.off", "-o", "c.off", "unite"}).code, 0);
    QCOMPARE(fixture.run({"repair", "c.off", "-o", "d.off", "--unite", "--report", "s.json"}).code, 0);
    QCOMPARE(fixture.json("s.json").at("inner_faces").get<int>(), 0);
    QVERIFY(fixture.run({"repair", "c.off", "-o", "d.off", "--unite"}).err.contains("No bodies were united"));
    QVERIFY(std::abs(fixture.json("s.json").at("after").at("volume_mm3").get<double>() - (16.0 - 0.9 * 1.1 * 0.7)) <
            1e-9);
  }

  // Single precision is coarse far from the origin.
  void roundingIsReported() {
    const Fixture fixture;
    fixture.put("near.off", cube().off());
    fixture.put("far.off", Shape().add(cube(), {1e6 + 0.01, 0, 0}).off());
    QCOMPARE(fixture.run({"repair", "near.off", "-o", "b.stl"}).err, QByteArray());
    QCOMPARE(fixture.run({"repair", "far.off", "-o", "b.off"}).err, QByteArray());
    const Ran ran = fixture.run({"repair", "far.off", "-o", "b.stl", "--report", "r.json"});
    QVERIFY(ran.err.contains("moved vertices by up to 0.01 mm"));
    QVERIFY(std::abs(fixture.json("r.json").at("rounding_moved_mm").get<double>() - 0.01) < 1e-9);
  }

  void noFolderForTheReport() {
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    for (const char* beside : {"--report", "--screenshot"}) {
      const Ran ran = fixture.run({"repair", "a.off", "-o", "a.off", beside, "none/r.png"});
      QCOMPARE(ran.code, 1);
      QVERIFY(ran.err.contains("There is no folder none for none/r.png."));
      QCOMPARE(fixture.content("a.off"), openCube().off());
    }
  }

  void partialReadsWhatIsThere() {
    const Fixture fixture;
    QByteArray damaged = openCube().off();
    damaged.replace("10 0\n", "11 0\n").append("3 0 1 99\n");  // one face more, with a vertex that does not exist
    fixture.put("a.off", damaged);
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.stl"}).code, 1);
    QCOMPARE(fixture.names(), QStringList{"a.off"});
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--partial", "--report", "r.json"});
    QCOMPARE(ran.code, 0);
    QVERIFY(ran.err.contains("99"));
    QVERIFY(fixture.json("r.json").at("damage").size() >= 1);
  }

  // The list ends after a thousand positions and gives the number of the others.
  void countsWhatIsNotListed() {
    const Fixture fixture;
    QByteArray damaged = openCube().off();
    damaged.replace("10 0\n", "1511 0\n");
    for (int i = 0; i < 1501; ++i) damaged += "3 0 1 99\n";
    fixture.put("a.off", damaged);
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--partial", "--report", "r.json"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.err.count('\n'), 1001);
    QVERIFY(ran.err.endsWith("handwheel: Damage at 501 further places.\n"));
    QCOMPARE(fixture.json("r.json").at("damage").size(), std::size_t(1001));
  }

  // The open end of a tube of 48 sides, each turned by 7.5° from the next, gets a lid at a right angle: that is said. A
  // ball that is closed where a cap was cut off goes on as it did: nothing is said.
  void patchesThatBendMoreThanTheirSurroundings() {
    const Fixture fixture;
    constexpr int kSides = 48, kRings = 12;
    Shape tube, ball;
    for (int k = 0; k <= kRings; ++k) {
      for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * M_PI * i / kSides, polar = M_PI - (M_PI - 0.4) * (k + 1) / (kRings + 1);
        tube.points.push_back({10.0 * std::cos(angle), 10.0 * std::sin(angle), 2.0 * k});
        ball.points.push_back({10.0 * std::sin(polar) * std::cos(angle), 10.0 * std::sin(polar) * std::sin(angle),
                               10.0 * std::cos(polar)});
      }
    }
    tube.points.push_back({0.0, 0.0, 0.0});
    ball.points.push_back({0.0, 0.0, -10.0});
    for (int i = 0; i < kSides; ++i) {
      const int next = (i + 1) % kSides;
      tube.faces.push_back({kSides * (kRings + 1), next, i});
      for (int k = 0; k < kRings; ++k) {
        const int a = kSides * k + i, b = kSides * k + next;
        tube.faces.push_back({a, b, b + kSides});
        tube.faces.push_back({a, b + kSides, a + kSides});
      }
    }
    ball.faces = tube.faces;
    fixture.put("tube.off", tube.off());
    fixture.put("ball.off", ball.off());
    const Ran lid = fixture.run({"repair", "tube.off", "-o", "a.off"});
    QCOMPARE(lid.code, 0);
    QVERIFY2(lid.err.contains("check its patch: the patch bends by 90°, its surroundings by at most 8°"), lid.err);
    // The first of many such patches are named; the report has all.
    Shape many;
    for (int i = 0; i < 13; ++i) many.add(tube, {25.0 * (i % 4), 25.0 * (i / 4), 0.0});
    fixture.put("many.off", many.off());
    const Ran lids = fixture.run({"repair", "many.off", "-o", "c.off"});
    QCOMPARE(lids.err.count("check its patch"), 10);
    QVERIFY2(lids.err.contains("Check 3 further patches, too: --report FILE has the bends of all."), lids.err);
    const Ran cap = fixture.run({"repair", "ball.off", "-o", "b.off"});
    QCOMPARE(cap.code, 0);
    QCOMPARE(cap.err, QByteArray());
  }
};

HANDWHEEL_TEST(RepairOptionsTest)
#include "RepairOptionsTest.moc"
