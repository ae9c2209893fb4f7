// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr const char* kLanguages[] = {"rapid", "krl", "fanuc", "urscript"};

// An arm like an IRB 120 whose sixth joint has no limits.
QByteArray spinner() {
  const double a[] = {0, 270, 70, 0, 0, 0}, d[] = {290, 0, 0, 302, 0, 72}, alpha[] = {-90, 0, -90, 90, -90, 0},
               theta[] = {0, -90, 0, 0, 0, 180};
  nlohmann::json table = {{"name", "spinner"}, {"joints", nlohmann::json::array()}};
  for (std::size_t i = 0; i < 6; ++i) {
    table["joints"].push_back({{"name", "joint_" + std::to_string(i + 1)},
                               {"a", a[i]},
                               {"d", d[i]},
                               {"alpha", alpha[i]},
                               {"theta", theta[i]},
                               {"velocity", 200}});
    if (i < 5) table["joints"].back().update({{"lower", -160}, {"upper", 160}});
  }
  return QByteArray::fromStdString(table.dump());
}

// A rail with an upright axis on it.
constexpr const char* kRail =
    R"(<robot name="rail"><link name="base"/><link name="cart"/>
<link name="arm"><collision><origin xyz="0.2 0 0"/><geometry><box size="0.4 0.05 0.05"/></geometry></collision></link>
<joint name="slide" type="prismatic"><parent link="base"/><child link="cart"/><axis xyz="1 0 0"/>
<limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
<joint name="turn" type="revolute"><parent link="cart"/><child link="arm"/><axis xyz="0 0 1"/>
<limit lower="-3" upper="3" velocity="1" effort="1"/></joint></robot>)";

void add(const PlannedCell& cell, const QString& from, const char* name, const char* joints) {
  const Ran ran = cell.run({"configuration", from, "--add", name, "--joints", joints, "-o", "own.handwheel"});
  QVERIFY2(ran.code == 0, ran.err);
}

}  // namespace

// Joints without limits, and slides, from the plan to the program.
class JointKindsTest : public QObject {
  Q_OBJECT

 private slots:
  // From 3.0 to -3.0 rad over half a turn, 2 pi - 6 = 0.283 rad, and on to -2.5, 0.5 rad further: 3, 3.283 and 3.783 in
  // programs, 171.887, 188.113 and 216.761 degrees.
  void byTheShortestTurn() {
    const PlannedCell cell;
    cell.put("spin.dh.json", spinner());
    add(cell, "spin.dh.json", "a", "joint_5=0.5,joint_6=3.0");
    add(cell, "own.handwheel", "b", "joint_5=0.5,joint_6=-3.0");
    add(cell, "own.handwheel", "c", "joint_5=0.5,joint_6=-2.5");
    for (const char* const planner : {"sbl", "rrtconnect", "prm"}) {
      const Ran planned = cell.run({"plan", "own.handwheel", "--from", "a", "--to", "c", "--via", "b", "--name", "way",
                                    "--planner", planner, "-o", "planned.handwheel", "--json"});
      QVERIFY2(planned.code == 0, planned.err);
      QVERIFY(std::abs(jsonOf(planned.out)["length_rad"].get<double>() - (2.0 * M_PI - 5.5)) < 1e-9);
    }
    const auto lengthOf = [&](const QString& path) {
      return jsonOf(cell.run({"verify", "planned.handwheel", path, "--json"}).out)["length_rad"].get<double>();
    };
    QVERIFY(std::abs(lengthOf("way") - (2.0 * M_PI - 5.5)) < 1e-9);
    const Ran optimised = cell.run({"optimise-path", "planned.handwheel", "way", "-o", "planned.handwheel"});
    QVERIFY2(optimised.code == 0, optimised.err);
    QVERIFY(std::abs(lengthOf("way") - (2.0 * M_PI - 5.5)) < 1e-6);
    for (const char* const language : kLanguages) {
      const Ran written = cell.run({"post", "planned.handwheel", "way", "--controller", language, "-o", language});
      QVERIFY2(written.code == 0, written.err);
      const QByteArray text = cell.read(language);
      const bool isRadians = QByteArray(language) == "urscript";
      QVERIFY2(text.contains(isRadians ? "3.2831853" : "188.1126"), text);
      QVERIFY2(text.contains(isRadians ? "3.7831853" : "216.7605"), text);
    }
  }

  // Refused before the path is looked for: there is no such path. CSV and JSON have the slide in mm, reports, too.
  void rails() {
    const PlannedCell cell;
    cell.put("rail.urdf", kRail);
    add(cell, "rail.urdf", "a", "slide=-500,turn=0.5");
    add(cell, "own.handwheel", "b", "slide=750,turn=-0.5");
    for (const char* const language : kLanguages) {
      const Ran refused = cell.run({"post", "own.handwheel", "none", "--controller", language, "-o", language});
      QVERIFY2(refused.code != 0 && refused.err.contains("6 joints") && !refused.err.contains("none"), refused.err);
      QVERIFY(cell.read(language).isEmpty());
    }
    const Ran planned = cell.run(
        {"plan", "own.handwheel", "--from", "a", "--to", "b", "--name", "way", "-o", "own.handwheel", "--json"});
    QVERIFY2(planned.code == 0, planned.err);
    QVERIFY(std::abs(jsonOf(planned.out)["length_mm"].get<double>() - 1250.0) < 1e-6);
    QVERIFY(std::abs(jsonOf(planned.out)["length_rad"].get<double>() - 1.0) < 1e-9);
    const Ran told = cell.run({"verify", "own.handwheel", "way"});
    QVERIFY2(told.out.contains("1 rad, 1250 mm of slides"), told.out);
    QCOMPARE(cell.run({"post", "own.handwheel", "way", "--controller", "csv", "-o", "way.csv"}).code, 0);
    const QList<QByteArray> rows = cell.rowsOf("way.csv");
    QVERIFY2(rows[0].contains(",q1_mm,q2_deg,"), rows[0]);
    QVERIFY2(rows[1].contains(",-500.000000000,28.647889757,"), rows[1]);
    QVERIFY2(rows[2].contains(",750.000000000,-28.647889757,"), rows[2]);
    QCOMPARE(cell.run({"post", "own.handwheel", "way", "--controller", "json", "-o", "way.json"}).code, 0);
    const nlohmann::json json = jsonOf(cell.read("way.json"));
    QVERIFY(json["q_units"] == nlohmann::json::array({"mm", "deg"}));
    QVERIFY(json["motions"][1]["q_mm_deg"][0] == 750.0 && !json["motions"][1].contains("q_deg"));
  }
};

HANDWHEEL_TEST(JointKindsTest)
#include "JointKindsTest.moc"
