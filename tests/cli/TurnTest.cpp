// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

// Along the bar at 21 mm beside the axis, in 3 s.
const QByteArray kPath = "t_s,x_mm,y_mm,z_mm\n0,0,21,20\n1,0,21,30\n2,21,0,50\n3,-21,0,60\n";

nlohmann::json reported(const Ran& ran) {
  return nlohmann::json::parse(ran.out.toStdString());
}

}  // namespace

// 'handwheel turn': a recorded path cuts a bar, and its passes can be repeated.
class TurnTest : public QObject {
  Q_OBJECT

 private slots:
  // A nose of 1 mm leaves a radius of 20 mm from z = 20 to 60, between two quarters of its circle: the removed volume
  // by Pappus' theorem. Turned on from any side it is the same, whatever the angle of the path.
  void cutsAlongAPath() {
    const Bench bench;
    bench.put("p.csv", kPath);
    QCOMPARE(bench.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const Ran ran = bench.run({"turn", "bar.handwheel", "--path", "p.csv", "-o", "part.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json json = reported(ran);
    QCOMPARE(json["passes"].get<int>(), 1);
    // At the ends the nose leaves min(25, 21 - sqrt(1 - x²)), which is 21 at x = 1, then the bar.
    double ends = 0.0;
    for (int i = 0; i < 100000; ++i) {
      const double x = (i + 0.5) / 100000;
      const double r = 21.0 - std::sqrt(1.0 - x * x);
      ends += 2.0 * M_PI * (625.0 - r * r) / 100000;
    }
    const double expected = M_PI * (625.0 - 400.0) * 40.0 + ends;
    QVERIFY2(std::abs(json["removed"].get<double>() / expected - 1.0) < 2e-3, ran.out);

    const Ran resized = bench.run({"set", "part.handwheel", "diameter=60", "-o", "x.handwheel"});
    QCOMPARE(resized.code, 1);
    QVERIFY2(resized.err.contains("The bar was cut already"), resized.err);
    const Ran again = bench.run({"turn", "part.handwheel", "--replay", "--json"});
    QCOMPARE(again.code, 0);
    QVERIFY(reported(again)["same"].get<bool>());
    QCOMPARE(bench.run({"convert", "part.handwheel", "part.step"}).code, 0);
    QCOMPARE(bench.run({"convert", "part.handwheel", "part.stl"}).code, 0);
    const Ran inspected = bench.run({"inspect", "part.stl", "--json"});
    QCOMPARE(reported(inspected)["holes"].size(), std::size_t{0});
  }

  // The same path gives the same bytes, and a second pass adds to the first.
  void isReproducible() {
    const Bench bench;
    bench.put("p.csv", kPath);
    bench.put("q.csv", "t_s,x_mm,y_mm,z_mm\n0,24,0,70\n1,12,0,90\n");
    QCOMPARE(bench.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    QByteArray first;
    for (int i = 0; i < 2; ++i) {
      QCOMPARE(bench.run({"turn", "bar.handwheel", "--path", "p.csv", "-o", "a.handwheel"}).code, 0);
      QCOMPARE(bench.run({"turn", "a.handwheel", "--path", "q.csv", "-o", "b.handwheel", "--nose-radius", "2.5"}).code,
               0);
      const QByteArray bytes = bench.content("b.handwheel");
      QVERIFY(!bytes.isEmpty() && (i == 0 || bytes == first));
      first = bytes;
    }
    const Ran again = bench.run({"turn", "b.handwheel", "--replay"});
    QCOMPARE(again.code, 0);
    QVERIFY(again.out.contains("Passes: 2.") && again.out.contains("give the same part"));
  }

  void mistakes() {
    const Bench bench;
    bench.put("p.csv", kPath);
    bench.put("bad.csv", "t_s,x_mm\n0,1\n");
    bench.put("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    QCOMPARE(bench.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const auto refuses = [&](const QStringList& words, const char* part) {
      const Ran ran = bench.run(words);
      return ran.code == 1 && ran.err.contains(part);
    };
    QVERIFY(refuses({"turn", "bar.handwheel"}, "--path P.csv or --replay"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "p.csv"}, "-o OUT is missing"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--replay", "-o", "x.handwheel"}, "leave out -o"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "p.csv", "-o", "x.handwheel", "--nose-radius", "0"},
                    "--nose-radius"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "bad.csv", "-o", "x.handwheel"}, "bad.csv"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "none.csv", "-o", "x.handwheel"}, "none.csv"));
    QVERIFY(refuses({"turn", "a.off", "--path", "p.csv", "-o", "x.handwheel"}, "no workpiece"));
    QVERIFY(!bench.names().contains("x.handwheel"));
  }
};

HANDWHEEL_TEST(TurnTest)
#include "TurnTest.moc"
