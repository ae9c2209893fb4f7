// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

// A shaft of 40 and 24 mm with a shoulder at 30 mm, of 80 mm: the half section in user units of 1 mm.
const QByteArray kShaftDrawing =
    "<svg width=\"100mm\" height=\"30mm\" viewBox=\"0 0 100 30\"><path d=\"M 0 25 V 5 H 30 V 13 H 80 V 25\"/>"
    "<line id=\"axis\" x1=\"-5\" y1=\"25\" x2=\"95\" y2=\"25\"/></svg>";

}  // namespace

// 'handwheel target': the target shape of a part.
class TargetTest : public QObject {
  Q_OBJECT

 private slots:
  // Every format of meshes will do, archives included.
  void aMeshInAnyFormat() {
    Shape bar;
    constexpr int kCorners = 90;
    for (int i = 0; i < kCorners; ++i) {
      const double a = 2.0 * M_PI * i / kCorners;
      for (const double z : {0.0, 40.0}) bar.points.push_back({10 * std::cos(a), 10 * std::sin(a), z});
    }
    bar.points.push_back({0, 0, 0});
    bar.points.push_back({0, 0, 40});
    for (int i = 0; i < kCorners; ++i) {
      const int a = 2 * i, b = 2 * ((i + 1) % kCorners), low = 2 * kCorners;
      for (const std::array<int, 3>& t :
           {std::array{a, b, b + 1}, {a, b + 1, a + 1}, {b, a, low}, {a + 1, b + 1, low + 1}})
        bar.faces.push_back(t);
    }
    const Fixture fixture;
    fixture.put("bar.off", bar.off());
    const Ran off = fixture.run({"target", "bar.off"});
    QVERIFY2(off.code == 0 && off.out.startsWith("Turned part"), off.err);
    for (const char* name : {"bar.ply", "bar.obj", "bar.3mf"}) {
      QCOMPARE(fixture.run({"convert", "bar.off", name}).code, 0);
      const Ran other = fixture.run({"target", name});
      QVERIFY2(other.code == 0, other.err);
      QCOMPARE(other.out, off.out);
      QVERIFY(fixture.run({"help", "target"}).out.contains(QByteArray(name).mid(3)));
    }
  }

  void listsDimensions() {
    const Fixture fixture;
    fixture.put("shaft.svg", kShaftDrawing);
    const Ran ran = fixture.run({"target", "shaft.svg"});
    QVERIFY2(ran.code == 0, ran.err);
    QVERIFY2(ran.out.contains("cylinder Ø40, Z 0 to 30, length 30"), ran.out);
    QVERIFY2(ran.out.contains("cylinder Ø24, Z 30 to 80, length 50"), ran.out);
    const nlohmann::json json = jsonOf(fixture.run({"target", "shaft.svg", "--json"}));
    QVERIFY(std::abs(json["volume"].get<double>() / (M_PI * (400.0 * 30.0 + 144.0 * 50.0)) - 1.0) < 1e-9);
    QCOMPARE(json["dimensions"].size(), std::size_t{5});
  }

  // Each end is where the other one was.
  void isTurnedEndForEnd() {
    const Fixture fixture;
    fixture.put("shaft.svg", kShaftDrawing);
    const Ran ran = fixture.run({"target", "shaft.svg", "--turn-target"});
    QVERIFY2(ran.code == 0 && ran.err.contains("The end of ⌀40 mm is the free one"), ran.err);
    QVERIFY2(ran.out.contains("cylinder Ø24, Z 0 to 50, length 50"), ran.out);
    QVERIFY2(ran.out.contains("cylinder Ø40, Z 50 to 80, length 30"), ran.out);
  }

  // Converts to every format and back, with the same dimensions.
  void convertsDrawings() {
    const Fixture fixture;
    fixture.put("shaft.svg", kShaftDrawing);
    const nlohmann::json expected = jsonOf(fixture.run({"target", "shaft.svg", "--json"}));
    for (const char* out : {"a.dxf", "a.svg", "a.handwheel"}) {
      const Ran written = fixture.run({"target", "shaft.svg", "-o", out});
      QVERIFY2(written.code == 0, written.err);
      const nlohmann::json back = jsonOf(fixture.run({"target", out, "--json"}));
      QVERIFY2(std::abs(back["volume"].get<double>() / expected["volume"].get<double>() - 1.0) < 1e-9, out);
      QCOMPARE(back["dimensions"].size(), expected["dimensions"].size());
    }
    QCOMPARE(fixture.run({"target", "shaft.svg", "-o", "a.pdf"}).code, 0);
    QVERIFY(fixture.content("a.pdf").startsWith("%PDF-"));
  }

  void measuresAWorkpiece() {
    const Fixture fixture;
    fixture.put("shaft.svg", kShaftDrawing);
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);  // 50 x 100 mm
    const auto over = [&fixture](const QStringList& more) {
      const Ran ran = fixture.run(
          QStringList{"target", "shaft.svg", "--of", "bar.handwheel", "-o", "with.handwheel", "--json"} + more);
      if (ran.code != 0) qWarning("%s", ran.err.constData());
      const nlohmann::json json = jsonOf(ran);
      return std::pair(json["deviation"]["largest_over"]["distance"].get<double>(),
                       json["facing_allowance"].get<double>());
    };
    // Wherever it was drawn, 1 mm is left to be faced. The furthest is the rim of the free end, that far beyond the
    // face of 24 mm; the bar behind the shoulder, which reaches 100 - 1 - 80 mm to the chuck's end, is no part of it.
    const auto [usual, facing] = over({});
    QVERIFY(std::abs(usual - std::hypot(25.0 - 12.0, 1.0)) < 1e-6 && std::abs(facing - 1.0) < 1e-9);
    const auto [asked, more] = over({"--facing", "20"});
    QVERIFY(std::abs(asked - std::hypot(25.0 - 12.0, 20.0)) < 1e-6 && std::abs(more - 20.0) < 1e-9);
    for (const char* const wrong : {"-1", "x", "1e9"})
      QCOMPARE(fixture.run({"target", "shaft.svg", "--of", "bar.handwheel", "--facing", wrong}).code, 1);
    // It can be changed afterwards.
    QCOMPARE(fixture.run({"set", "with.handwheel", "facing_allowance=2.5", "-o", "set.handwheel"}).code, 0);
    QVERIFY(std::abs(jsonOf(fixture.run({"target", "set.handwheel", "--json"}))["lower_end"].get<double>() - 17.5) <
            1e-9);
    const Ran inspected = fixture.run({"inspect", "with.handwheel"});
    QVERIFY2(inspected.out.contains("cylinder Ø50, Z 0 to 100, length 100"), inspected.out);
    QVERIFY2(inspected.out.contains("target shaft.svg: "), inspected.out);
  }

  void exportsWorkpieces() {
    const Fixture fixture;
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    for (const char* out : {"bar.dxf", "bar.svg", "bar.pdf"}) {
      const Ran ran = fixture.run({"convert", "bar.handwheel", out});
      QVERIFY2(ran.code == 0, ran.err);
    }
    QVERIFY(fixture.content("bar.dxf").contains("LINE"));
  }

  void refuses() {
    const Fixture fixture;
    fixture.put("text.dxf", "hello");
    fixture.put("binary.dxf", "AutoCAD Binary DXF\r\n");
    fixture.put("open.svg", "<svg><path d=\"M 0 0 L 5 5\"/></svg>");
    for (const auto& [file, words] : {std::pair{"text.dxf", "text.dxf"},
                                      {"binary.dxf", "binary DXF file"},
                                      {"open.svg", "where the axis is"},
                                      {"none.step", "there is no such file"}}) {
      const Ran ran = fixture.run({"target", file});
      QCOMPARE(ran.code, 1);
      QVERIFY2(ran.err.toLower().contains(QByteArray(words).toLower()), ran.err);
    }
  }
};

HANDWHEEL_TEST(TargetTest)
#include "TargetTest.moc"
