// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

namespace {

nlohmann::json editInspected(const Fixture& fixture, const QString& name) {
  return nlohmann::json::parse(fixture.run({"inspect", name, "--json"}).out.toStdString());
}

}  // namespace

class EditTest : public QObject {
  Q_OBJECT

 private slots:
  // An open cube moved, turned by a right angle about its middle and closed: its volume and position follow.
  void stepByStep() {
    const Fixture fixture;
    fixture.put("a.off", openCube(2.0).off());
    const Ran ran = fixture.run(
        {"edit", "a.off", "place --move 1,0,0.5 --turn 0,0,90", "fill 0 --fill minimal", "-o", "b.off"}, "de_DE.UTF-8");
    QCOMPARE(ran.err,
             QByteArray("handwheel: The file: closed, manifold, oriented, free of self-intersections, one piece.\n"));
    QCOMPARE(ran.out, QByteArray("Triangles: 10 before, 12 now.\n"));
    QCOMPARE(ran.code, 0);
    QVERIFY(std::abs(editInspected(fixture, "b.off")["volume_mm3"].get<double>() - 8.0) < 1e-12);
    QCOMPARE(fixture.names(), (QStringList{"a.off", "b.off"}));
  }

  void aFileOfSteps() {
    const Fixture fixture;
    fixture.put("a.off", cube(2.0).add(tetrahedron(), {5, 0, 0}).off());
    fixture.put("s.steps", "# takes the tetrahedron away\n\n  delete 12-15\r\nplace --scale 0.5\n");
    const Ran ran = fixture.run({"edit", "a.off", "corner", "--steps", "s.steps", "-o", "b.off"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(fixture.run({"edit", "a.off", "delete 12-15", "place --scale 0.5", "corner", "-o", "c.off"}).code, 0);
    QCOMPARE(fixture.content("b.off"), fixture.content("c.off"));
    QVERIFY(std::abs(editInspected(fixture, "b.off")["volume_mm3"].get<double>() - 1.0) < 1e-12);
  }

  // A container keeps every number, so that what one run did is gone on with by another.
  void goesOnFromAContainer() {
    const Fixture fixture;
    fixture.put("a.off", openCube(2.0).add(openCube(1.0), {5, 0, 0}).off());
    QCOMPARE(fixture.run({"convert", "a.off", "a.handwheel"}).code, 0);
    const QString first = "keep-open 1", second = "fill 0", third = "delete 3,20-21", fourth = "unit in";
    QCOMPARE(fixture.run({"edit", "a.handwheel", first, second, third, fourth, "-o", "b.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"edit", "a.handwheel", first, second, "-o", "c.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"edit", "c.handwheel", third, fourth, "-o", "c.handwheel"}).code, 0);
    QCOMPARE(fixture.content("b.handwheel"), fixture.content("c.handwheel"));
    QVERIFY(fixture.content("a.handwheel") != fixture.content("b.handwheel"));
  }

  // Figures from before saving need not hold for the rounded file: a third is not representable in single precision.
  void roundingIsReported() {
    const Fixture fixture;
    fixture.put("a.off", cube(2.0).off());
    const char* warning = "single precision of the format moved vertices by up to";
    QVERIFY(fixture.run({"edit", "a.off", "place --scale 0.3333", "-o", "b.stl"}).err.contains(warning));
    QVERIFY(!fixture.run({"edit", "a.off", "place --scale 0.3333", "-o", "b.ply"}).err.contains(warning));
    QVERIFY(!fixture.run({"edit", "a.off", "place --scale 0.5", "-o", "b.stl"}).err.contains(warning));
  }

  // The state of a file in the same words, whichever command tells it; the self-intersections are part of it.
  void oneStateInTheSameWords() {
    const Fixture fixture;
    fixture.put("a.off", cube(2.0).add(cube(2.0), {1.1, 1.2, 0.9}).off());
    const nlohmann::json inspected = editInspected(fixture, "a.off");
    const int pairs = inspected["self_intersecting_pairs"];
    QVERIFY(pairs > 0);
    const QByteArray state =
        "closed, manifold, oriented, " + QByteArray::number(pairs) + " self-intersections, 2 pieces";
    QCOMPARE(QByteArray::fromStdString(inspected["state"].get<std::string>()), state);
    QVERIFY(fixture.run({"inspect", "a.off"}).out.contains("\nState                     " + state + "\n"));
    QVERIFY(fixture.run({"edit", "a.off", "corner", "-o", "b.off"}).err.contains("The file: " + state + "."));
    const Ran repaired = fixture.run({"repair", "a.off", "-o", "c.off"});
    QVERIFY2(repaired.out.contains("c.off: " + state + ".\n"), repaired.out.constData());
    QCOMPARE(repaired.code, 2);
  }

  void anotherMesh() {
    const Fixture fixture;
    fixture.put("a.off", cube(2.0).off());
    fixture.put("the other.off", Shape().add(tetrahedron(), {5, 0, 0}).off());
    QCOMPARE(fixture.run({"edit", "a.off", "add the other.off", "-o", "b.off"}).code, 0);
    QCOMPARE(editInspected(fixture, "b.off")["triangles"].get<int>(), 16);
    const Ran ran = fixture.run({"edit", "a.off", "add none.off", "-o", "c.off"});
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.contains("none.off"));
  }

  void whatChangesNothing() {
    const Fixture fixture;
    fixture.put("a.off", cube(2.0).off());
    const Ran ran = fixture.run({"edit", "a.off", "debris", "corner", "-o", "b.off"});
    QCOMPARE(ran.code, 2);
    QCOMPARE(ran.err,
             QByteArray("handwheel: The file: closed, manifold, oriented, free of self-intersections, one piece.\n"
                        "handwheel: Step 1, 'debris' changed nothing: no piece is far smaller than the largest.\n"
                        "handwheel: Step 2, 'corner' changed nothing: it is already in place.\n"));
    QCOMPARE(ran.out, QByteArray("Triangles: 12 before, 12 now.\n"));
    QCOMPARE(fixture.run({"edit", "a.off", "near-vertices", "-o", "b.off"}).err.split('\n').at(1),
             QByteArray("handwheel: Step 1, 'near-vertices' changed nothing: no two vertices can be merged so that an "
                        "open edge closes and none gets a third triangle."));
    QCOMPARE(
        fixture.run({"edit", "a.off", "bridge 3,9", "-o", "b.off"}).err.split('\n').at(1),
        QByteArray("handwheel: Step 1, 'bridge 3,9' changed nothing: there is no open edge, or a triangle would flip, "
                   "intersect another or double an edge."));
  }

  void mistakes_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const QStringList& words, const char* message) {
      QTest::newRow(qPrintable(words.join(' '))) << words << QByteArray("handwheel: ") + message + "\n";
    };
    row({"-o", "b.off"}, "No step is given. Give steps, or a file of steps with --steps.\nTry 'handwheel help edit'.");
    row({"flat"}, "The option -o OUT is missing.\nTry 'handwheel help edit'.");
    const char* advice = "'handwheel help edit' lists the steps; loops are numbered as in 'handwheel inspect'.";
    const auto wrong = [&](const QStringList& words, const QByteArray& where, const char* what) {
      row(words + QStringList{"-o", "b.off"},
          (where + ": the step cannot be done: " + what + ". " + advice).constData());
    };
    wrong({"corner", "fly away"}, "Step 2, 'fly away'", "there is no step 'fly'");
    wrong({"fill 1"}, "Step 1, 'fill 1'", "there is no loop 1, only 0 to 0");
    wrong({"corner", "--steps", "s.steps"}, "s.steps, line 3", "there is no triangle 99, only 0 to 9");
  }
  void mistakes() {
    QFETCH(QStringList, words);
    QFETCH(QByteArray, message);
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    fixture.put("s.steps", "# one\ndelete 3\ndelete 99\n");
    const Ran ran = fixture.run(QStringList{"edit", "a.off"} + words);
    QCOMPARE(ran.err, message);
    QCOMPARE(ran.out, QByteArray());
    QCOMPARE(ran.code, 1);
    QCOMPARE(fixture.names(), (QStringList{"a.off", "s.steps"}));
  }

  void onlyMeshes() {
    const Fixture fixture;
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const Ran ran = fixture.run({"edit", "bar.handwheel", "flat", "-o", "b.handwheel"});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err, QByteArray("handwheel: bar.handwheel is not a mesh: only meshes can be edited by steps.\n"));
    fixture.put("a.off", cube().off());
    QCOMPARE(fixture.run({"edit", "a.off", "flat", "-o", "b.docx"}).code, 1);
    QCOMPARE(fixture.names(), (QStringList{"a.off", "bar.handwheel"}));
  }

  // Every step that the program knows stands on the page.
  void help() {
    const QByteArray page = Fixture().run({"help", "edit"}).out;
    for (const char* verb : {"place",          "flat",           "axes",          "centre",
                             "corner",         "delete",         "fill",          "keep-open",
                             "no-longer-open", "repair",         "back",          "cut-and-close",
                             "debris",         "degenerates",    "duplicates",    "split-nonmanifold",
                             "two-sides",      "near-vertices",  "cut-crossings", "decimate",
                             "bridge",         "join",           "face",          "pull",
                             "smooth-edge",    "stroke",         "subdivide",     "level-back",
                             "smooth-noise",   "subdivide-mesh", "add",           "unit",
                             "refine"})
      QVERIFY2(QRegularExpression(QString("\n  (.*[,;|] )?%1\\b").arg(verb)).match(page).hasMatch(), verb);
  }
};

HANDWHEEL_TEST(EditTest)
#include "EditTest.moc"
