// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

// The columns of a recording that the window exports.
const QByteArray kRecordingColumns =
    "t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us,buttons,sent_x,sent_y,"
    "sent_z,safety,tick,hip_qw,hip_qx,hip_qy,hip_qz,torque_x,torque_y,torque_z,sent_torque_x,sent_torque_y,"
    "sent_torque_z,hip_vx,hip_vy,hip_vz,period_s,stiffness_limit,damping_limit,restart,in_scene,event,scene\n";

// A row of it: the hand is 3 mm further in than the tool.
QByteArray row(int tick, double x, double z, int buttons, const QByteArray& event = {}) {
  const auto n = [](double value) { return QByteArray::number(value); };
  return n(0.001 * tick) + "," + n(x - 3) + ",0," + n(z) + "," + n(x) + ",0," + n(z) + ",0,0,0,1,5," + n(buttons) +
         ",0,0,0,0," + n(tick) + ",1,0,0,0,0,0,0,0,0,0,0,0,0,0.001,1,0,0,1," + event + ",\n";
}

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
    const Fixture fixture;
    fixture.put("p.csv", kPath);
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const Ran ran = fixture.run({"turn", "bar.handwheel", "--path", "p.csv", "-o", "part.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json json = reported(ran);
    QCOMPARE(json.size(), std::size_t{8});
    QCOMPARE(json["time_s"].get<double>(), 3.0);
    QVERIFY(json["max_force_N"].get<double>() > 0.0 && json["profile_error_mm"].is_null());
    // At the ends the nose leaves min(25, 21 - sqrt(1 - x²)), which is 21 at x = 1, then the bar.
    double ends = 0.0;
    for (int i = 0; i < 100000; ++i) {
      const double x = (i + 0.5) / 100000;
      const double r = 21.0 - std::sqrt(1.0 - x * x);
      ends += 2.0 * M_PI * (625.0 - r * r) / 100000;
    }
    const double expected = M_PI * (625.0 - 400.0) * 40.0 + ends;
    QVERIFY2(std::abs(json["removed_mm3"].get<double>() / expected - 1.0) < 2e-3, ran.out);

    const Ran resized = fixture.run({"set", "part.handwheel", "diameter=60", "-o", "x.handwheel"});
    QCOMPARE(resized.code, 1);
    QVERIFY2(resized.err.contains("The bar was cut already"), resized.err);
    const Ran again = fixture.run({"turn", "part.handwheel", "--replay", "--json"});
    QCOMPARE(again.code, 0);
    QVERIFY(reported(again)["same"].get<bool>());
    QCOMPARE(fixture.run({"convert", "part.handwheel", "part.step"}).code, 0);
    QCOMPARE(fixture.run({"convert", "part.handwheel", "part.stl"}).code, 0);
    const Ran inspected = fixture.run({"inspect", "part.stl", "--json"});
    QCOMPARE(reported(inspected)["holes"].size(), std::size_t{0});
  }

  // The same path gives the same bytes, and a second pass adds to the first.
  void isReproducible() {
    const Fixture fixture;
    fixture.put("p.csv", kPath);
    fixture.put("q.csv", "t_s,x_mm,y_mm,z_mm\n0,24,0,70\n1,12,0,90\n");
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    QByteArray first;
    for (int i = 0; i < 2; ++i) {
      QCOMPARE(fixture.run({"turn", "bar.handwheel", "--path", "p.csv", "-o", "a.handwheel"}).code, 0);
      QCOMPARE(
          fixture.run({"turn", "a.handwheel", "--path", "q.csv", "-o", "b.handwheel", "--nose-radius", "2.5"}).code, 0);
      const QByteArray bytes = fixture.content("b.handwheel");
      QVERIFY(!bytes.isEmpty() && (i == 0 || bytes == first));
      first = bytes;
    }
    const Ran again = fixture.run({"turn", "b.handwheel", "--replay"});
    QCOMPARE(again.code, 0);
    QVERIFY(again.out.contains("Passes: 2.") && again.out.contains("give the same part"));
  }

  // On the side "Bore" a nose of 1 mm goes down the axis at 10 mm: a hole of 11 mm, and below it the nose. It removes
  // everything between it and the axis, so the volume is that of a solid of revolution.
  void aRecordingOfABore() {
    const Fixture fixture;
    QByteArray table = kRecordingColumns + row(0, 10, 110, 0, "tool turn bore");
    for (int i = 0; i <= 50; ++i) table += row(1 + i, 10, 110.0 - i, i == 50 ? 0 : 1);
    fixture.put("bore.csv", table);
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const Ran ran = fixture.run({"turn", "bar.handwheel", "--recording", "bore.csv", "-o", "part.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const double deep = 100.0 - 61.0;  // the button was let go behind z = 61
    const double expected = M_PI * (121.0 * deep + 100.0 + 20.0 * M_PI / 4.0 + 2.0 / 3.0);
    QVERIFY2(std::abs(reported(ran)["removed_mm3"].get<double>() / expected - 1.0) < 2e-3, ran.out);
    QVERIFY(reported(ran)["max_force_N"].get<double>() > 0.0);
  }

  // Each press of the first button is a pass of the tool, which was where its tip was shown; other rows only move, and
  // so do those of other tools and buttons. The same as paths, one for each press, give the same part.
  void aRecordingIsTurned() {
    const Fixture fixture;
    QByteArray table = kRecordingColumns;
    table += row(0, 30, 10, 0, "tool measure") + row(1, 10, 10, 1) + row(2, 10, 10, 0, "tool turn");
    table += row(3, 27, 20, 0) + row(4, 27, 20, 1) + row(5, 24, 20, 1) + row(6, 24, 40, 3) + row(7, 27, 40, 0);
    table += row(8, 15, 50, 2);
    table += row(9, 27, 60, 1) + row(10, 22, 60, 1) + row(11, 27, 60, 0);
    table += row(12, 28, 80, 1) + row(13, 28, 85, 1) + row(14, 28, 85, 0);  // beside the bar
    fixture.put("session.csv", table);
    fixture.put("first.csv", "t_s,x_mm,y_mm,z_mm\n0.004,27,0,20\n0.005,24,0,20\n0.006,24,0,40\n");
    fixture.put("second.csv", "t_s,x_mm,y_mm,z_mm\n0.009,27,0,60\n0.01,22,0,60\n");
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const Ran ran = fixture.run({"turn", "bar.handwheel", "--path", "session.csv", "-o", "part.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    QCOMPARE(reported(fixture.run({"turn", "part.handwheel", "--replay", "--json"}))["passes"].get<int>(), 2);
    QCOMPARE(fixture.run({"turn", "bar.handwheel", "--path", "first.csv", "-o", "one.handwheel"}).code, 0);
    const Ran paths = fixture.run({"turn", "one.handwheel", "--path", "second.csv", "-o", "two.handwheel", "--json"});
    QVERIFY2(paths.code == 0, paths.err);
    // Each run reports only its own removal.
    const Ran one = fixture.run({"turn", "bar.handwheel", "--path", "first.csv", "-o", "one.handwheel", "--json"});
    const double apart = reported(one)["removed_mm3"].get<double>() + reported(paths)["removed_mm3"].get<double>();
    QVERIFY(std::abs(reported(ran)["removed_mm3"].get<double>() - apart) < 1e-6 * apart);

    // The Lathe tool is moved by its levers, which no recording has.
    fixture.put("lathe.csv",
                kRecordingColumns + row(0, 27, 20, 0, "tool lathe") + row(1, 27, 20, 1) + row(2, 24, 20, 1));
    const Ran lathe = fixture.run({"turn", "bar.handwheel", "--recording", "lathe.csv", "-o", "x.handwheel"});
    QCOMPARE(lathe.code, 1);
    QVERIFY2(lathe.err.contains("lathe.csv") && lathe.err.contains("Lathe tool"), lathe.err);

    fixture.put("less.csv", table.replace("proxy_x", "a").replace("buttons", "b"));
    const Ran less = fixture.run({"turn", "bar.handwheel", "--path", "less.csv", "-o", "x.handwheel"});
    QCOMPARE(less.code, 1);
    QVERIFY2(less.err.contains("less.csv") && less.err.contains("buttons, proxy_x."), less.err);
    QVERIFY(!fixture.names().contains("x.handwheel"));
  }

  // 1 mm/s at 600 r/min, a nose of 1 mm: f²/(32 R) of 0.1 mm.
  void theFinishIsReported() {
    const Fixture fixture;
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,24,0,105\n80,24,0,25\n");
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const Ran ran =
        fixture.run({"turn", "bar.handwheel", "--path", "p.csv", "--spindle", "600", "-o", "part.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json outside = reported(ran)["finish"]["outside"];
    QCOMPARE(outside.size(), std::size_t{1});
    QVERIFY(std::abs(outside[0]["roughness_um"].get<double>() - 0.3125) < 1e-4);
    const Ran inspected = fixture.run({"inspect", "part.handwheel", "--json"});
    QVERIFY(reported(inspected)["document"]["finish"]["outside"] == outside);
    QVERIFY(fixture.run({"inspect", "part.handwheel"}).out.contains("outside Ra 0.31"));
  }

  // With control points a taper approximates the swept shape of the nose, the better the closer they are:
  // ControlPointCutTest. The method is kept with the pass, so that it is replayed as it was.
  void byControlPoints() {
    const Fixture fixture;
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,27,0,10\n10,20,0,80\n11,28,0,80\n");
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const QStringList words = {"turn", "bar.handwheel", "--recording", "p.csv", "--nose", "4", "--json"};
    QCOMPARE(fixture.run(words + QStringList{"-o", "exact.handwheel"}).code, 0);
    double last = std::numeric_limits<double>::infinity();
    for (const char* resolution : {"10", "1"}) {
      const Ran ran = fixture.run(words + QStringList{"--method", "poles", "--resolution", resolution, "--target",
                                                      "exact.handwheel", "-o", "near.handwheel"});
      QVERIFY2(ran.code == 0, ran.err);
      const double error = reported(ran)["profile_error_mm"].get<double>();
      QVERIFY2(error > 1e-6 && error < last, ran.out);
      last = error;
      QVERIFY(reported(fixture.run({"turn", "near.handwheel", "--replay", "--json"}))["same"].get<bool>());
    }
    const auto refuses = [&](const QStringList& more, const char* part) {
      const Ran ran = fixture.run(words + QStringList{"-o", "x.handwheel"} + more);
      return ran.code == 1 && ran.err.contains(part) && !fixture.names().contains("x.handwheel");
    };
    QVERIFY(refuses({"--method", "spoon"}, "--method is trim or poles."));
    QVERIFY(refuses({"--resolution", "1"}, "--resolution is of --method poles."));
    for (const char* resolution : {"0", "0.049", "10.1", "nan"})
      QVERIFY(refuses({"--method", "poles", "--resolution", resolution}, "from 0.05 to 10."));
    fixture.put("p.ngc", "G21 G18 G7 S500 M3\nF100\nG0 X44 Z2\nM2\n");
    const Ran program =
        fixture.run({"turn", "bar.handwheel", "--program", "p.ngc", "--method", "poles", "-o", "x.handwheel"});
    QVERIFY2(program.code == 1 && program.err.contains("--method is of --recording R."), program.err);
  }

  // A path beside the part is no pass, of a bar and of a part.
  void aPathThatTouchesNothingIsNoPass() {
    const Fixture fixture;
    fixture.put("p.csv", kPath);
    fixture.put("beside.csv", "t_s,x_mm,y_mm,z_mm\n0,27,0,20\n1,27,0,80\n");
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"turn", "bar.handwheel", "--path", "p.csv", "-o", "part.handwheel"}).code, 0);
    for (const char* name : {"bar.handwheel", "part.handwheel"}) {
      const Ran ran = fixture.run({"turn", name, "--path", "beside.csv", "-o", "x.handwheel"});
      QCOMPARE(ran.code, 2);
      QVERIFY2(ran.err.contains("The path does not touch the part"), ran.err);
      QVERIFY(!fixture.names().contains("x.handwheel"));
    }
  }

  // Passes that are lost of the work that is repeated are reported.
  void damageOfTheRecordedWorkIsSaid() {
    const Fixture fixture;
    fixture.put("p.csv", kPath);
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"turn", "bar.handwheel", "--path", "p.csv", "-o", "part.handwheel"}).code, 0);
    const Ran whole = fixture.run({"turn", "bar.handwheel", "--recording", "part.handwheel", "-o", "again.handwheel"});
    QVERIFY2(whole.code == 0 && !whole.err.contains("missing"), whole.err);
    QByteArray damaged = fixture.content("part.handwheel");
    damaged.replace("workpiece/path/", "workpiece/pXth/");  // in the local header and in the directory
    fixture.put("damaged.handwheel", damaged);
    const Ran ran = fixture.run({"turn", "bar.handwheel", "--recording", "damaged.handwheel", "-o", "x.handwheel"});
    QVERIFY2(ran.code == 2 && ran.err.contains("'workpiece/path/0000' is missing"), ran.err);
    QVERIFY(!fixture.names().contains("x.handwheel"));
  }

  // Units, and six digits: 25² π · 100 mm³ and 2 · 25² π + 50 π · 100 mm².
  void isInspectedWithUnits() {
    const Fixture fixture;
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const Ran ran = fixture.run({"inspect", "bar.handwheel"});
    QVERIFY2(ran.out.contains("  diameter: 50 mm\n") && ran.out.contains("  volume: 196350 mm³\n"), ran.out);
    QVERIFY2(ran.out.contains("  area: 19635 mm²\n"), ran.out);
  }

  void theUsageSaysWhatGoesTogether() {
    const Fixture fixture;
    const Ran ran = fixture.run({"turn", "--help"});
    QVERIFY2(ran.out.startsWith("Usage: handwheel turn STOCK (--program P.ngc | --recording R) -o OUT "), ran.out);
  }

  void mistakes() {
    const Fixture fixture;
    fixture.put("p.csv", kPath);
    fixture.put("bad.csv", "t_s,x_mm\n0,1\n");
    fixture.put("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const auto refuses = [&](const QStringList& words, const char* part) {
      const Ran ran = fixture.run(words);
      return ran.code == 1 && ran.err.contains(part);
    };
    QVERIFY(refuses({"turn", "bar.handwheel"}, "--program P.ngc, --recording R and --replay"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "p.csv"}, "-o OUT is missing"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--replay", "-o", "x.handwheel"}, "leave out -o"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "p.csv", "-o", "x.handwheel", "--nose-radius", "0"},
                    "--nose takes"));
    for (const char* radius : {"0.049", "50.1"})  // limits of the window
      QVERIFY(refuses({"turn", "bar.handwheel", "--path", "p.csv", "-o", "x.handwheel", "--nose-radius", radius},
                      "from 0.05 to 50."));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "bad.csv", "-o", "x.handwheel"}, "bad.csv"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "bad.csv", "-o", "x.handwheel"}, "y_mm, z_mm"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--path", "none.csv", "-o", "x.handwheel"}, "none.csv"));
    QVERIFY(refuses({"turn", "a.off", "--path", "p.csv", "-o", "x.handwheel"}, "not a workpiece"));
    QCOMPARE(fixture.run({"convert", "a.off", "mesh.handwheel"}).code, 0);
    QVERIFY(refuses({"turn", "bar.handwheel", "--recording", "mesh.handwheel", "-o", "x.handwheel"},
                    "mesh.handwheel: This is no work on a lathe: give a workpiece"));
    QVERIFY(refuses({"turn", "bar.handwheel", "--recording", "bar.handwheel", "--spacing", "0.1", "-o", "x.handwheel"},
                    "--spacing is not for a document"));
    QVERIFY(!fixture.names().contains("x.handwheel"));
  }
};

HANDWHEEL_TEST(TurnTest)
#include "TurnTest.moc"
