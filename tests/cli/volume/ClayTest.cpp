// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

using Position = std::array<double, 3>;

// 40 by 30 by 20 mm from the origin.
Shape clayBlock() {
  Shape block = cube();
  for (Position& p : block.points) p = {40.0 * p[0], 30.0 * p[1], 20.0 * p[2]};
  return block;
}

// Turned, so that no face lies along samples.
Position turnedPosition(const Position& p) {
  const double y = std::cos(0.4) * p[1] - std::sin(0.4) * p[2], z = std::sin(0.4) * p[1] + std::cos(0.4) * p[2];
  return {std::cos(0.5) * p[0] - std::sin(0.5) * y, std::sin(0.5) * p[0] + std::cos(0.5) * y, z};
}

// Returns the lines of a polygonal path; each segment takes the period, s.
QByteArray linesOf(const std::vector<Position>& positions, double period = 1.0, const QByteArray& more = {}) {
  QByteArray lines;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    lines += QByteArray::number(period * static_cast<double>(i), 'g', 12);
    for (const double x : positions[i]) lines += "," + QByteArray::number(x, 'g', 12);
    lines += more + "\n";
  }
  return lines;
}

QByteArray strokesCsv(const std::vector<Position>& positions, double period = 1.0) {
  return "t_s,x_mm,y_mm,z_mm\n" + linesOf(positions, period);
}

double capsule(double radius, const Position& from, const Position& to) {
  const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  return M_PI * radius * radius * length + 4.0 / 3.0 * M_PI * radius * radius * radius;
}

// Returns the report of the command on a part; null and a failed check if it fails.
nlohmann::json sculpt(const Fixture& fixture, const QStringList& words) {
  const Ran ran = fixture.run(QStringList{"clay"} + words + QStringList{"--json"}, "de_DE.UTF-8");
  if (ran.code != 0 || !ran.err.isEmpty()) qWarning("%s", ran.err.constData());
  return ran.code == 0 ? nlohmann::json::parse(ran.out.toStdString()) : nlohmann::json();
}

double figure(const nlohmann::json& report, const char* name) {
  return report.is_object() ? report.at(name).get<double>() : std::nan("");
}

// Voxels on the border count whole; a stroke may end a twentieth of the radius early, as nothing is done for less.
bool isCapsule(double found, double exact, double radius) {
  const double late = M_PI * radius * radius * 0.05 * radius;
  return found > 0.995 * exact - late && found < 1.005 * exact;
}

constexpr double kToolRadius = 3.0;
constexpr Position kStrokeFrom{10.0, 11.0, 8.0},
    kStrokeTo{28.0, 19.0, 12.0};  // along no axis, 5 mm and more within the block

}  // namespace

class ClayTest : public QObject {
  Q_OBJECT

 private slots:
  // A ball along a line takes a cylinder with two half balls out of a block, however the hand is sampled: also where it
  // is there at once.
  void carves_data() {
    QTest::addColumn<double>("period");
    QTest::addColumn<QString>("rate");
    QTest::newRow("as a device") << 1.0 << "1000";
    QTest::newRow("few places") << 1.0 << "20";
    QTest::newRow("at once") << 0.0 << "1000";
  }
  void carves() {
    QFETCH(double, period);
    QFETCH(QString, rate);
    const Fixture fixture;
    fixture.put("a.off", clayBlock().off());
    fixture.put("s.csv", strokesCsv({kStrokeFrom, kStrokeTo}, period));
    const auto report = sculpt(fixture, {"a.off", "--strokes", "s.csv", "--tool", "carve", "--radius", "3", "--voxel",
                                         "0.5", "--rate", rate, "-o", "b.handwheel"});
    const double removed = figure(report, "removed_mm3");
    QVERIFY2(isCapsule(removed, capsule(kToolRadius, kStrokeFrom, kStrokeTo), kToolRadius),
             QByteArray::number(removed));
    QCOMPARE(figure(report, "added_mm3"), 0.0);
    QVERIFY(std::abs(figure(report, "volume_before_mm3") - removed - figure(report, "volume_mm3")) < 1e-6);
    QVERIFY(figure(report, "changed_blocks") > removed / (8.0 * 0.5 * 8.0 * 0.5 * 8.0 * 0.5));
    QVERIFY(figure(report, "computed_s") > 0.0);
    QCOMPARE(figure(report, "time_s"), period);
    QCOMPARE(figure(report, "voxel_mm"), 0.5);
    QCOMPARE(figure(report, "radius_mm"), kToolRadius);
  }

  // The cavity is there in the file, and in one of a mesh.
  void carvedFiles() {
    const Fixture fixture;
    fixture.put("a.off", clayBlock().off());
    fixture.put("s.csv", strokesCsv({kStrokeFrom, kStrokeTo}));
    const auto report = sculpt(fixture, {"a.off", "--strokes", "s.csv", "--tool", "carve", "--radius", "3", "--voxel",
                                         "0.5", "--rate", "20", "-o", "b.handwheel"});
    const double removed = figure(report, "removed_mm3");
    const auto inspected = nlohmann::json::parse(fixture.run({"inspect", "b.handwheel", "--json"}).out.toStdString());
    QCOMPARE(inspected["document"]["voxel"].get<double>(), 0.5);
    QCOMPARE(fixture.run({"remesh", "b.handwheel", "-o", "b.off"}).code, 0);
    const auto mesh = nlohmann::json::parse(fixture.run({"inspect", "b.off", "--json"}).out.toStdString());
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>());
    QCOMPARE(mesh["components"].get<int>(), 2);  // the block, and the cavity in it
    QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / (24000.0 - removed) - 1.0) < 0.01);
  }

  // Beside the part clay comes, and nothing is there to be carved, smoothed or moved.
  void besideThePart() {
    const Fixture fixture;
    fixture.put("a.off", clayBlock().off());
    Position from = kStrokeFrom, to = kStrokeTo;
    for (Position* p : {&from, &to}) (*p)[2] += 40.0;
    fixture.put("s.csv", strokesCsv({from, to}));
    const QStringList words{"a.off", "--strokes", "s.csv", "--radius", "3", "--voxel", "0.5"};
    for (const char* tool : {"carve", "inflate", "smooth", "flatten", "tug", "smudge", "attract", "pinch"}) {
      const auto report = sculpt(fixture, words + QStringList{"--tool", tool, "-o", "b.handwheel"});
      QCOMPARE(figure(report, "changed_blocks"), 0.0);
      QCOMPARE(figure(report, "added_mm3"), 0.0);
      QCOMPARE(figure(report, "removed_mm3"), 0.0);
      QCOMPARE(figure(report, "volume_mm3"), figure(report, "volume_before_mm3"));
    }
    const Ran said = fixture.run(QStringList{"clay"} + words + QStringList{"--tool", "smooth", "-o", "b.handwheel"});
    QCOMPARE(said.code, 0);
    QVERIFY2(said.out.contains("no stroke comes to the material"), said.out);
    const auto report = sculpt(fixture, words + QStringList{"--tool", "add", "-o", "b.stl"});
    const double added = figure(report, "added_mm3");
    QVERIFY2(isCapsule(added, capsule(kToolRadius, from, to), kToolRadius), QByteArray::number(added));
    QCOMPARE(figure(report, "removed_mm3"), 0.0);
    const auto mesh = nlohmann::json::parse(fixture.run({"inspect", "b.stl", "--json"}).out.toStdString());
    QCOMPARE(mesh["components"].get<int>(), 2);
    QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / (24000.0 + added) - 1.0) < 0.01);
  }

  // On either side of the middle the same is removed; by two numbered strokes, between which the hand moves only, and
  // by one that is mirrored, as much as by both.
  void symmetry() {
    const Fixture fixture;
    fixture.put("a.off", clayBlock().off());
    const std::vector<Position> left{{6.0, 8.0, 19.0}, {14.0, 20.0, 17.0}};
    std::vector<Position> right = left;
    for (Position& p : right) p[0] = 40.0 - p[0];
    fixture.put("left.csv", strokesCsv(left));
    fixture.put("right.csv", strokesCsv(right));
    QByteArray both = "t_s,x_mm,y_mm,z_mm,stroke\n" + linesOf(left, 1.0, ",1") + "1.5,20,15,18,0\n";
    for (std::size_t i = 0; i < right.size(); ++i)
      both += QByteArray::number(2 + static_cast<int>(i)) + "," + linesOf({right[i]}).mid(2).trimmed() + ",2\n";
    fixture.put("both.csv", both);
    const auto removed = [&](const char* strokes, const char* output, const QStringList& more = {}) {
      return figure(
          sculpt(fixture,
                 QStringList{"a.off", "--strokes", strokes, "--radius", "2.5", "--voxel", "0.5", "-o", output} + more),
          "removed_mm3");
    };
    const double one = removed("left.csv", "b.vdb"), other = removed("right.csv", "b.handwheel");
    QVERIFY(one > 100.0);
    QVERIFY2(std::abs(one / other - 1.0) < 0.01, QByteArray::number(one / other));
    QVERIFY(std::abs(removed("both.csv", "b.handwheel") / (one + other) - 1.0) < 1e-3);
    QVERIFY(std::abs(removed("left.csv", "b.handwheel", {"--mirror-x"}) / (one + other) - 1.0) < 0.01);
  }

  // Growing and pulling out add material; shrinking and smoothing along an edge remove it: depths below a convex
  // surface are concave, so that no mean of them is larger. The other actions change something.
  void tools_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("where");
    QTest::addColumn<int>("sign");  // 1: material comes; -1: it goes
    QTest::newRow("inflate") << QStringList{"inflate"} << "face" << 1;
    QTest::newRow("shrink") << QStringList{"inflate", "--strength=-0.5"} << "face" << -1;
    QTest::newRow("tug") << QStringList{"tug"} << "out" << 1;
    QTest::newRow("smooth") << QStringList{"smooth", "--strength", "1"} << "edge" << -1;
    QTest::newRow("flatten") << QStringList{"flatten"} << "edge" << 0;
    QTest::newRow("smudge") << QStringList{"smudge"} << "edge" << 0;
    QTest::newRow("attract") << QStringList{"attract"} << "edge" << 0;
    QTest::newRow("pinch") << QStringList{"pinch"} << "edge" << 0;
  }
  void tools() {
    QFETCH(QStringList, words);
    QFETCH(QString, where);
    QFETCH(int, sign);
    const Fixture fixture;
    Shape block = cube(20.0);
    for (Position& p : block.points) p = turnedPosition(p);
    fixture.put("a.off", block.off());
    std::vector<Position> positions{{5.0, 10.0, 20.0}, {15.0, 10.0, 20.0}};
    if (where == "out") positions = {{10.0, 10.0, 20.0}, {10.0, 10.0, 23.0}};
    if (where == "edge") positions = {{5.0, 0.0, 20.0}, {15.0, 0.0, 20.0}};
    for (Position& p : positions) p = turnedPosition(p);
    fixture.put("s.csv", strokesCsv(positions));
    const auto report = sculpt(
        fixture,
        QStringList{"a.off", "--strokes", "s.csv", "--radius", "5", "--voxel", "0.5", "-o", "b.off", "--tool"} + words);
    QVERIFY(figure(report, "changed_blocks") > 0.0);
    const double change = figure(report, "added_mm3") - figure(report, "removed_mm3");
    QVERIFY2(change * sign >= 0.0 && (sign == 0 || change != 0.0), QByteArray::number(change));
    QVERIFY(std::abs(figure(report, "volume_mm3") - figure(report, "volume_before_mm3") - change) < 1e-6);
    const auto mesh = fixture.inspected("b.off");
    QVERIFY(mesh.is_object() && mesh["closed"].get<bool>() && mesh["manifold"].get<bool>());
  }

  // A region masked by a stroke is stored for the next command, and protected; without the mask it changes.
  void masks() {
    const Fixture fixture;
    fixture.put("a.off", clayBlock().off());
    fixture.put("s.csv", strokesCsv({{12.0, 12.0, 19.5}, {26.0, 18.0, 19.5}}));
    const auto masked = sculpt(fixture, {"a.off", "--strokes", "s.csv", "--tool", "mask", "--radius", "6", "--falloff",
                                         "0", "--voxel", "0.5", "-o", "masked.handwheel"});
    QVERIFY(figure(masked, "changed_blocks") > 0.0);
    QCOMPARE(figure(masked, "added_mm3") + figure(masked, "removed_mm3"), 0.0);
    const QStringList carve{"--strokes", "s.csv", "--tool", "carve", "--radius", "1.5", "-o", "b.handwheel"};
    QCOMPARE(figure(sculpt(fixture, QStringList{"masked.handwheel"} + carve), "removed_mm3"), 0.0);
    const auto bare = sculpt(fixture, QStringList{"a.off", "--voxel", "0.5"} + carve);
    QVERIFY(figure(bare, "removed_mm3") > 20.0);
  }

  // Strokes on a layer that has no strength are there all the same: at full strength the part is what it is without
  // layers, to the last voxel.
  void layers() {
    const Fixture fixture;
    fixture.put("a.off", clayBlock().off());
    fixture.put("s.csv", strokesCsv({{12.0, 12.0, 19.5}, {26.0, 18.0, 19.5}}));
    const QStringList carve{"--strokes", "s.csv", "--tool", "carve", "--radius", "2"};
    const auto plain = sculpt(fixture, QStringList{"a.off", "--voxel", "1", "-o", "plain.handwheel"} + carve);
    const auto hidden =
        sculpt(fixture, QStringList{"a.off", "--voxel", "1", "-o", "hidden.handwheel", "--layer", "dents:0"} + carve);
    QVERIFY(figure(plain, "removed_mm3") > 10.0);
    QCOMPARE(figure(hidden, "removed_mm3"), figure(plain, "removed_mm3"));
    QCOMPARE(figure(hidden, "volume_mm3"), figure(hidden, "volume_before_mm3"));
    QCOMPARE(figure(hidden, "layers"), 1.0);
    QCOMPARE(hidden["layer"]["name"].get<std::string>(), std::string("dents"));
    QCOMPARE(hidden["layer"]["strength"].get<double>(), 0.0);
    QVERIFY(hidden["layer"]["blocks"].get<int>() > 0);
    const auto volumeOf = [&](const char* file) {
      const auto reported = nlohmann::json::parse(fixture.run({"inspect", file, "--json"}).out.toStdString());
      return reported["document"]["volume"].get<double>();
    };
    for (const char* strength : {"1", "0.5"}) {
      const QString word = QStringLiteral("layer.1.strength=") + QLatin1String(strength);
      QCOMPARE(
          fixture.run({"set", "hidden.handwheel", word, "-o", QStringLiteral("at%1.handwheel").arg(strength)}).code, 0);
    }
    QCOMPARE(volumeOf("at1.handwheel"), figure(plain, "volume_mm3"));
    const double half = volumeOf("at0.5.handwheel");
    QVERIFY(half > figure(plain, "volume_mm3") && half < figure(plain, "volume_before_mm3"));
    // A second layer; strokes below it, and on one that is weak, are refused.
    const auto second = sculpt(fixture, QStringList{"at1.handwheel", "-o", "two.handwheel", "--layer", "more"} + carve);
    QCOMPARE(figure(second, "layers"), 2.0);
    const auto refused = [&](const char* file, const QStringList& words, const char* says) {
      const Ran ran = fixture.run(QStringList{"clay", file, "-o", "never.handwheel"} + words + carve);
      return ran.code == 1 && ran.err.contains(says) && !fixture.names().contains("never.handwheel");
    };
    QVERIFY(refused("two.handwheel", {"--layer", "dents"}, "is above it"));
    QVERIFY(refused("hidden.handwheel", {}, "takes no strokes"));
    for (const char* word : {":0.5", "a:2", "a:nan", "a:", "a:-0.1"})
      QVERIFY2(refused("a.off", {"--layer", word}, "--layer takes a name"), word);
  }

  // A tool is as large as in the window where nothing is said: a twentieth of the part.
  void usualTool() {
    const Fixture fixture;
    fixture.put("a.off", clayBlock().off());
    fixture.put("s.csv", strokesCsv({kStrokeFrom, kStrokeTo}));
    const auto report = sculpt(fixture, {"a.off", "--strokes", "s.csv", "--voxel", "0.5", "-o", "b.nrrd"});
    QVERIFY(std::abs(figure(report, "radius_mm") - 2.0) < 0.01);
    QVERIFY(std::abs(figure(report, "removed_mm3") / capsule(2.0, kStrokeFrom, kStrokeTo) - 1.0) < 0.03);
    // It can be sculpted again as it is, and its own voxels hold.
    const auto again = sculpt(fixture, {"b.nrrd", "--strokes", "s.csv", "--tool", "add", "-o", "c.handwheel"});
    QVERIFY(std::abs(figure(again, "voxel_mm") - 0.5) < 1e-6);
    QVERIFY(figure(again, "added_mm3") > 0.9 * figure(report, "removed_mm3"));
  }

  void refusals_data() {
    QTest::addColumn<QByteArray>("strokes");
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("says");
    const QByteArray good = strokesCsv({kStrokeFrom, kStrokeTo}), head = "t_s,x_mm,y_mm,z_mm\n";
    const QStringList out{"--strokes", "s.csv", "-o", "b.stl"};
    QTest::newRow("no strokes") << good << QStringList{"-o", "b.stl"} << QByteArray("--strokes FILE is missing");
    QTest::newRow("no output") << good << QStringList{"--strokes", "s.csv"} << QByteArray("-o OUT is missing");
    QTest::newRow("no file") << good << QStringList{"--strokes", "none.csv", "-o", "b.stl"} << QByteArray("none.csv");
    QTest::newRow("no tool") << good << out + QStringList{"--tool", "chisel"} << QByteArray("chisel");
    QTest::newRow("ending") << good << QStringList{"--strokes", "s.csv", "-o", "b.txt"} << QByteArray(".vdb");
    QTest::newRow("strong") << good << out + QStringList{"--strength", "2"} << QByteArray("strength");
    QTest::newRow("radius of nothing") << good << out + QStringList{"--radius", "0"} << QByteArray("radius");
    QTest::newRow("small") << good << out + QStringList{"--radius", "0.5"} << QByteArray("from 0.75 to 250 mm");
    QTest::newRow("large") << good << out + QStringList{"--radius", "251"} << QByteArray("from 0.75 to 250 mm");
    QTest::newRow("empty") << QByteArray() << out << QByteArray("no line of numbers");
    QTest::newRow("head alone") << head << out << QByteArray("no line of numbers");
    QTest::newRow("no head") << linesOf({kStrokeFrom, kStrokeTo}) << out << QByteArray("Line 1");
    QTest::newRow("NaN") << head + "0,1,2,nan\n" << out << QByteArray("Line 2: 'nan'");
    QTest::newRow("infinite") << head + "0,1,2,1e300\n" << out << QByteArray("Line 2: '1e300'");
    QTest::newRow("missing") << head + "0,1,2\n" << out << QByteArray("z_mm is missing");
    QTest::newRow("unsorted") << head + "1,1,2,3\n0,1,2,3\n" << out << QByteArray("Line 3: The time must not decrease");
    QTest::newRow("half a stroke") << QByteArray("t_s,x_mm,y_mm,z_mm,stroke\n0,1,2,3,0.5\n") << out
                                   << QByteArray("Line 2: The number of a stroke");
    QTest::newRow("two columns") << QByteArray("t_s,x_mm,y_mm,z_mm,stroke,stroke\n0,1,2,3,1,1\n") << out
                                 << QByteArray("Line 1: There are two columns stroke");
    QTest::newRow("no number") << QByteArray("t_s,x_mm,y_mm,z_mm,stroke\n0,1,2,3,first\n") << out
                               << QByteArray("Line 2: 'first'");
    QTest::newRow("no stroke") << QByteArray("t_s,x_mm,y_mm,z_mm,stroke\n0,1,2,3,0\n") << out
                               << QByteArray("number its strokes");
    QTest::newRow("an age") << head + "0,1,2,3\n1e9,1,2,4\n" << out << QByteArray("can be followed at this rate");
    QTest::newRow("far") << head + "0,1,2,3\n1,1e9,2,3\n" << out << QByteArray("Check the unit");
    QTest::newRow("all") << strokesCsv({{20.0, 15.0, 10.0}, {21.0, 15.0, 10.0}}) << out + QStringList{"--radius", "60"}
                         << QByteArray("othing is left of the material");
  }
  void refusals() {
    QFETCH(QByteArray, strokes);
    QFETCH(QStringList, words);
    QFETCH(QByteArray, says);
    const Fixture fixture;
    fixture.put("a.off", clayBlock().off());
    fixture.put("s.csv", strokes);
    const Ran ran = fixture.run(QStringList{"clay", "a.off", "--voxel", "0.5"} + words);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains(says), ran.err);
    QVERIFY(!fixture.names().contains("b.stl") && !fixture.names().contains("b.txt"));
  }
};

HANDWHEEL_TEST(ClayTest)
#include "ClayTest.moc"
