// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <vector>

using namespace handwheel;

namespace {

struct ToolPosition {
  double x, y, z;
};

// Returns the tool positions at the waypoints of a path, from the table of its program.
std::vector<ToolPosition> toolPositions(const QByteArray& table) {
  std::vector<ToolPosition> positions;
  const QList<QByteArray> lines = table.trimmed().split('\n');
  qsizetype x = -1;
  for (const QByteArray& line : lines) {
    if (line.startsWith('#')) continue;
    const QList<QByteArray> words = line.split(',');
    if (x < 0) {
      x = words.indexOf("x_mm");
      continue;
    }
    positions.push_back({words.at(x).toDouble(), words.at(x + 1).toDouble(), words.at(x + 2).toDouble()});
  }
  return positions;
}

// Makes a hand motion along these positions at 40 mm/s that shakes across them, along x, by this amplitude in mm, once
// every 50 mm.
QByteArray shakingHand(const std::vector<ToolPosition>& positions, double amplitude) {
  QByteArray hand = "t_s,x_mm,y_mm,z_mm\n";
  double along = 0.0;
  for (std::size_t i = 1; i < positions.size(); ++i) {
    const ToolPosition a = positions[i - 1], b = positions[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
    for (double travel = 0.0; travel < length; travel += 0.5, along += 0.5) {
      const double share = travel / length;
      hand += QByteArray::number(along / 40.0);
      for (const double value : {a.x + share * (b.x - a.x) + amplitude * std::sin(2.0 * M_PI * along / 50.0),
                                 a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)})
        hand += "," + QByteArray::number(value);
      hand += "\n";
    }
  }
  return hand;
}

}  // namespace

// A robot follows the recorded paths of hands.
class TeleopTest : public QObject {
  Q_OBJECT

 private slots:
  // The hand goes 300 mm ahead, into the box: the robot stops before it and is pulled back there.
  void followsAHand() {
    const PlannedCell cell;
    QByteArray hand = "t_s,x_mm,y_mm,z_mm\n";
    for (int i = 0; i <= 100; ++i) hand += QByteArray::number(0.02 * i) + "," + QByteArray::number(3.0 * i) + ",0,0\n";
    cell.put("hand.csv", hand);
    const Ran ran = cell.run({"teleop", "cell.handwheel", "--path", "hand.csv", "-o", "out.csv", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json report = jsonOf(ran.out);
    QCOMPARE(report["steps"].get<int>(), 101);
    QVERIFY(report["min_clearance_mm"].get<double>() > 0.0);
    QVERIFY(report["blocked_s"].get<double>() > 0.5);
    QVERIFY(report["behind_max_mm"].get<double>() > 100.0);
    QVERIFY(report["max_force_N"].get<double>() <= 5.0 + 1e-9);
    QCOMPARE(cell.read("out.csv").count('\n'), 102);
    cell.put("bad.csv", "t_s,x_mm\n0,0\n");
    QCOMPARE(cell.run({"teleop", "cell.handwheel", "--path", "bad.csv"}).code, 1);
  }

  // Three hands along the edge of a block, the same but for how much they shake: the table says it of the first two
  // as it is, and the fixture takes most of the last one away.
  void threeHandsAlongAPath() {
    const PlannedCell cell;
    cell.run({"configuration", "irb120", "--add", "home", "--joints", "joint_2=0.2,joint_5=0.6", "-o", "c.handwheel"});
    cell.run({"body", "c.handwheel", "--add", "box:120,200,100", "--at", "420,0,50", "--name", "block", "-o",
              "c.handwheel"});
    const Ran planned = cell.run({"process", "c.handwheel", "--part", "block", "--near", "360,0,100", "--free",
                                  "--standoff", "20", "--name", "edge", "-o", "c.handwheel"});
    QVERIFY2(planned.code == 0, planned.err);
    QCOMPARE(cell.run({"post", "c.handwheel", "edge", "--controller", "csv", "-o", "edge.csv"}).code, 0);
    const std::vector<ToolPosition> positions = toolPositions(cell.read("edge.csv"));
    QVERIFY(positions.size() >= 2);
    cell.put("a.csv", shakingHand(positions, 8.0));
    cell.put("b.csv", shakingHand(positions, 4.0));
    const QStringList words{"teleop", "c.handwheel", "--follow", "edge"};
    const Ran ran =
        cell.run(words + QStringList{"--eyes", "a.csv", "--force", "b.csv", "--fixture", "b.csv", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json report = jsonOf(ran.out);
    const auto rms = [&](const char* help) { return report[help]["rms_mm"].get<double>(); };
    for (const char* help : {"eyes", "force", "fixture"}) QVERIFY(report[help]["complete"].get<bool>());
    // A wave's effective value, but where the path itself goes along x.
    QVERIFY2(rms("eyes") > 0.6 * 8.0 / std::sqrt(2.0) && rms("eyes") < 1.05 * 8.0 / std::sqrt(2.0), ran.out);
    QVERIFY2(std::abs(rms("force") - 0.5 * rms("eyes")) < 0.1 * rms("eyes"), ran.out);
    QVERIFY2(rms("fixture") < 0.25 * rms("force"), ran.out);
    QVERIFY(report["fixture"]["max_mm"].get<double>() < 1.0);  // 10 mm times 0.4 to the third: 0.64
    const Ran table = cell.run(words + QStringList{"--eyes", "a.csv", "--fixture", "b.csv"});
    QCOMPARE(table.out.count('\n'), 2);
    QVERIFY(table.out.startsWith("eyes"));
    const nlohmann::json one = jsonOf(cell.run(words + QStringList{"--path", "a.csv", "--json"}).out);
    QCOMPARE(one["following"]["rms_mm"].get<double>(), rms("eyes"));
    QCOMPARE(cell.run({"teleop", "c.handwheel", "--follow", "nothing", "--path", "a.csv"}).code, 1);
    QCOMPARE(cell.run({"teleop", "c.handwheel", "--eyes", "a.csv"}).code, 1);
    QCOMPARE(cell.run(words + QStringList{"--path", "a.csv", "--snap", "-1"}).code, 1);
  }
};

HANDWHEEL_TEST(TeleopTest)
#include "TeleopTest.moc"
