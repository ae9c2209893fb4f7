// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "BuildPaths.h"
#include "TestClass.h"

#include <QImage>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

const QString kShaftExercise = test::sourcePath("resources/samples/exercises/shaft.exercise.json");

nlohmann::json solutionOfShaft() {
  QFile file(kShaftExercise);
  if (!file.open(QIODevice::ReadOnly)) qFatal("an exercise is missing");
  return nlohmann::json::parse(file.readAll().toStdString())["solution"];
}

// The share of blue pixels of a picture in a report.
double blueShare(const QByteArray& html, const QByteArray& name) {
  const auto begin = html.indexOf("base64,", html.indexOf("alt=\"" + name + "\"")) + 7;
  const QImage picture =
      QImage::fromData(QByteArray::fromBase64(html.mid(begin, html.indexOf('"', begin) - begin)), "PNG");
  if (picture.isNull()) qFatal("there is no %s", name.constData());
  int blue = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (qBlue(picture.pixel(x, y)) > qRed(picture.pixel(x, y)) + 50) ++blue;
  return static_cast<double>(blue) / (picture.width() * picture.height());
}

}  // namespace

// The whole procedure of a teacher and a student on the command line.
class ExerciseTest : public QObject {
  Q_OBJECT

 private slots:
  void fromTheDescriptionToTheMarks() {
    const Fixture fixture;
    const auto ran = [&](const QStringList& words) {
      const Ran run = fixture.run(words);
      if (run.code != 0) qWarning("%s", run.err.constData());
      return run.code;
    };
    QCOMPARE(ran({"exercise", kShaftExercise, "-o", "shaft.handwheel"}), 0);
    QCOMPARE(ran({"exercise", "shaft.handwheel", "--student", "-o", "task.handwheel"}), 0);
    QCOMPARE(ran({"exercise", "shaft.handwheel", "--solution", "-o", "model.handwheel"}), 0);
    QCOMPARE(ran({"exercise", "task.handwheel", "--stock", "-o", "bar.handwheel"}), 0);
    QCOMPARE(ran({"exercise", "task.handwheel", "--hand-in", "model.handwheel", "--name", "Ada", "--minutes", "10",
                  "-o", "ada.handwheel"}),
             0);
    QCOMPARE(ran({"exercise", "task.handwheel", "--hand-in", "bar.handwheel", "--name", "=Bob", "-o", "bob.handwheel"}),
             0);
    const Ran marked = fixture.run({"mark", "shaft.handwheel", "bob.handwheel", "ada.handwheel", "--json", "--csv",
                                    "class.csv", "--report", "class.html", "--sort", "-Points"});
    QVERIFY2(marked.code == 0, marked.err);
    const nlohmann::json json = nlohmann::json::parse(marked.out.toStdString());
    QCOMPARE(json["submissions"].size(), std::size_t{2});
    const nlohmann::json& ada = json["submissions"][0];
    QCOMPARE(ada["student"].get<std::string>(), std::string("Ada"));
    QVERIFY2(ada["points"] == ada["of"] && ada["of"] == json["of"], marked.out);
    QCOMPARE(ada["seconds"].get<double>(), 600.0);
    QVERIFY(json["submissions"][1]["points"].get<double>() < ada["points"].get<double>());
    for (const nlohmann::json& mark : ada["marks"]) QVERIFY(!mark["reason"].get<std::string>().empty());
    const QByteArray csv = fixture.content("class.csv");
    QVERIFY2(csv.count('\n') == 3 && csv.contains("'=Bob"), csv);
    const QByteArray html = fixture.content("class.html");
    QVERIFY(html.contains("Ada") && html.contains("=Bob"));
    QCOMPARE(html.count("<h2 style=\"page-break-before: always\">"), 2);  // on paper each begins a page
    // A heading of one word is not broken; eleven criteria with long names are numbered, and named below.
    QVERIFY(html.contains("<th style=\"white-space: nowrap\">Points</th>"));
    QVERIFY(html.contains("<th style=\"white-space: nowrap\">11</th>") && html.contains("The numbered columns"));
    QVERIFY(html.contains("<td>by hand</td>") && ada["made_by"] == "hand");
    // Seven curves of a part that was turned, one of an untouched bar, and a picture of each.
    QCOMPARE(html.count("data:image/png;base64,"), 7 + 1 + 2);
    QVERIFY2(blueShare(html, "work0-picture-0") < 0.01, "what is left of the model solution");
    QVERIFY2(blueShare(html, "work1-picture-0") > 0.1, "what is left of the bar");
    // Force and power are stated as numbers: those that the marks have.
    QCOMPARE(ada["figures"].size(), std::size_t{2});
    for (const nlohmann::json& figure : ada["figures"])
      for (const nlohmann::json& mark : ada["marks"])
        if (mark["figure"] == figure["figure"]) QCOMPARE(figure["measured"], mark["measured"]);
    QVERIFY(html.contains("Largest resultant force: ") && html.contains("Largest motor power: "));
    // The drawing of the target is the target of an exercise again.
    QCOMPARE(ran({"exercise", "shaft.handwheel", "-o", "shaft.dxf"}), 0);
    QCOMPARE(ran({"exercise", "shaft.handwheel", "--import-target", "shaft.dxf", "-o", "drawn.handwheel"}), 0);
    QVERIFY(fixture.run({"exercise", "shaft.handwheel", "--import-target", "none.dxf", "-o", "x.handwheel"}).code != 0);
    // The shaft is as long as its bar of 120 mm: 0.5 mm to be faced are too much, and the program says where it lies.
    const Ran placed = fixture.run({"exercise", "shaft.handwheel", "--import-target", "shaft.dxf", "--facing", "0.5",
                                    "-o", "faced.exercise.json"});
    QVERIFY2(placed.code == 0 && placed.err.contains("does not fit") &&
                 placed.err.contains("0.5 mm behind the free end of the bar, at Z 119.5 mm"),
             placed.err);
    double highest = 0.0;
    const auto faced = nlohmann::json::parse(fixture.content("faced.exercise.json").toStdString());
    for (const auto& segment : faced["task"]["target"]["segments"])
      highest = std::max(highest, segment[1].get<double>());
    QVERIFY(std::abs(highest - 119.5) < 1e-6);
    QVERIFY(fixture.run({"exercise", "shaft.handwheel", "--facing", "1", "-o", "x.handwheel"}).code != 0);
    // Turned end for end, each point is reflected between the same heights; the radii stay.
    const Ran reversed =
        fixture.run({"exercise", "faced.exercise.json", "--turn-target", "-o", "turned.exercise.json"});
    QVERIFY2(reversed.code == 0 && reversed.err.contains("is the free one"), reversed.err);
    const auto other = nlohmann::json::parse(fixture.content("turned.exercise.json").toStdString());
    const auto &first = faced["task"]["target"]["segments"], &after = other["task"]["target"]["segments"];
    QCOMPARE(after.size(), first.size());
    double lowest = highest;
    for (const auto& segment : first) lowest = std::min({lowest, segment[1].get<double>(), segment[3].get<double>()});
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto &a = first[i], &b = after[first.size() - 1 - i];
      QVERIFY(std::abs(a[0].get<double>() - b[2].get<double>()) < 1e-9);
      QVERIFY(std::abs(highest + lowest - a[1].get<double>() - b[3].get<double>()) < 1e-6);
    }
    // The same files give the same marks.
    QCOMPARE(
        fixture.run({"mark", "shaft.handwheel", "bob.handwheel", "ada.handwheel", "--json", "--sort", "-Points"}).out,
        marked.out);
    QCOMPARE(ran({"mark", "shaft.handwheel", "ada.handwheel", "--report", "class.pdf"}), 0);
    QVERIFY(fixture.content("class.pdf").startsWith("%PDF"));

    // No command writes over its input.
    const auto keeps = [&](const char* name, const QStringList& words) {
      const QByteArray before = fixture.content(name);
      return fixture.run(words).code == 1 && fixture.content(name) == before && !before.isEmpty();
    };
    QVERIFY(keeps("ada.handwheel", {"mark", "shaft.handwheel", "--csv", "ada.handwheel", "bob.handwheel"}));
    QVERIFY(keeps("class.csv", {"mark", "shaft.handwheel", "ada.handwheel", "class.csv", "--csv", "class.csv"}));
    for (const char* const purpose : {"--student", "--stock", "--solution"})
      QVERIFY(keeps("shaft.handwheel", {"exercise", "shaft.handwheel", purpose, "-o", "shaft.handwheel"}));
    QVERIFY(keeps("task.handwheel",
                  {"exercise", "task.handwheel", "--hand-in", "bar.handwheel", "--name", "A", "-o", "task.handwheel"}));
    QVERIFY(keeps("bar.handwheel",
                  {"exercise", "task.handwheel", "--hand-in", "bar.handwheel", "--name", "A", "-o", "bar.handwheel"}));
    fixture.put("p.ngc", "G21 G18 G7 S500 M3\nF100\nG0 X44 Z2\nG0 X36\nG1 Z-99\nM2\n");
    QVERIFY(keeps("shaft.handwheel", {"turn", "shaft.handwheel", "--program", "p.ngc", "-o", "shaft.handwheel"}));
    // The chuck of the exercise holds 25 mm of its bar of 120.
    const Ran turned =
        fixture.run({"turn", "shaft.handwheel", "--program", "p.ngc", "-o", "turned.handwheel", "--json"});
    QVERIFY2(turned.code == 0 && turned.err.contains("chuck"), turned.err);
    QVERIFY(nlohmann::json::parse(turned.out.toStdString())["collisions"].get<int>() > 0);
  }

  // The target of the shaft has fillets and sizes of a tenth.
  void aTargetInRoundSizes() {
    const Fixture fixture;
    const Ran run = fixture.run(
        {"exercise", kShaftExercise, "--round-target", "2", "--sharp-corners", "5", "-o", "r.exercise.json"});
    QVERIFY2(run.code == 0, run.err);
    const nlohmann::json segments =
        nlohmann::json::parse(fixture.content("r.exercise.json").toStdString())["task"]["target"]["segments"];
    QVERIFY(segments.size() > 3);
    for (const nlohmann::json& segment : segments) {
      QCOMPARE(std::remainder(segment[0].get<double>(), 1.0), 0.0);
      QCOMPARE(std::remainder(segment[1].get<double>(), 2.0), 0.0);
    }
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "--round-target", "0", "-o", "x.handwheel"}).code, 1);
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "--sharp-corners", "1", "-o", "x.handwheel"}).code, 1);
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "--student", "--round-target", "1", "-o", "x.handwheel"}).code,
             1);
  }

  // Each size once: repeated, nothing is added.
  void theSizesOfATargetAreMarked() {
    const Fixture fixture;
    const auto criteria = [&fixture](const char* file) {
      return nlohmann::json::parse(fixture.content(file).toStdString())["criteria"];
    };
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "-o", "as-it-is.exercise.json"}).code, 0);
    const Ran run = fixture.run({"exercise", kShaftExercise, "--mark-sizes", "-o", "sizes.exercise.json"});
    QVERIFY2(run.code == 0, run.err);
    QVERIFY(criteria("sizes.exercise.json").size() > criteria("as-it-is.exercise.json").size());
    QVERIFY(run.err.isEmpty());
    const Ran again = fixture.run({"exercise", "sizes.exercise.json", "--mark-sizes", "-o", "again.exercise.json"});
    QVERIFY2(again.code == 0 && again.err.contains("No mark was added"), again.err);
    QCOMPARE(criteria("again.exercise.json"), criteria("sizes.exercise.json"));
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "--student", "--mark-sizes", "-o", "x.handwheel"}).code, 1);
  }

  void theStudentsFileHasNoAnswers() {
    const Fixture fixture;
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "--student", "-o", "task.handwheel"}).code, 0);
    const Ran inspected = fixture.run({"inspect", "task.handwheel", "--json"});
    QVERIFY2(inspected.code == 0, inspected.err);
    const nlohmann::json json = nlohmann::json::parse(inspected.out.toStdString());
    QVERIFY2(inspected.out.contains("\"points\"") && !inspected.out.contains("\"force\""), inspected.out);
    const Ran refused = fixture.run({"mark", "task.handwheel", "task.handwheel"});
    QVERIFY2(refused.code == 1 && refused.err.contains("no marking scheme"), refused.err);
    const Ran fixed = fixture.run({"set", "task.handwheel", "title=x", "-o", "x.handwheel"});
    QVERIFY2(fixed.code == 1 && fixed.err.contains("cannot be changed"), fixed.err);
  }

  // A broken file says so, before a student reads that nothing was handed in; and so does work on another version.
  void theTeacherLearnsWhatIsWrongWithAFile() {
    const Fixture fixture;
    nlohmann::json exercise = nlohmann::json::parse([] {
      QFile file(kShaftExercise);
      return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }());
    fixture.put("work.json", QByteArray::fromStdString(exercise["solution"].dump()));
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "--hand-in", "work.json", "--name", "Ada", "-o", "ada.handwheel"})
                 .code,
             0);
    QByteArray bytes = fixture.content("ada.handwheel");
    bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
    fixture.put("broken.handwheel", bytes);
    const Ran broken = fixture.run({"mark", kShaftExercise, "broken.handwheel"});
    QVERIFY2(broken.out.contains("The file is damaged"), broken.out);
    QVERIFY(!fixture.run({"mark", kShaftExercise, "ada.handwheel"}).out.contains("The file is damaged"));
    // Nobody moves twice alike.
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "--hand-in", "work.json", "--name", "Eve", "-o", "eve.handwheel"})
                 .code,
             0);
    const QByteArray both = fixture.run({"mark", kShaftExercise, "ada.handwheel", "eve.handwheel"}).out;
    QVERIFY2(both.contains("the same as that of Ada (ada.handwheel)") && both.contains("that of Eve (eve."), both);
    // Nor do they move alike for the larger part of the time: all passes but the last, a fifth of the time.
    nlohmann::json copied = exercise["solution"];
    nlohmann::json& last = copied["passes"].back()["feed"];
    last = 1.1 * last.get<double>();
    fixture.put("copied.json", QByteArray::fromStdString(copied.dump()));
    QCOMPARE(
        fixture.run({"exercise", kShaftExercise, "--hand-in", "copied.json", "--name", "Bob", "-o", "bob.handwheel"})
            .code,
        0);
    const QByteArray partly = fixture.run({"mark", kShaftExercise, "ada.handwheel", "bob.handwheel"}).out;
    QVERIFY2(partly.contains(" % of the recording is the same as in that of Ada (ada.handwheel)."), partly);
    QVERIFY2(!partly.contains("The recording is the same"), partly);
    // In reverse order, so only the last pass is the same.
    copied = exercise["solution"];
    for (nlohmann::json& pass : copied["passes"])
      if (&pass != &copied["passes"].back()) pass["feed"] = 1.1 * pass["feed"].get<double>();
    fixture.put("own.json", QByteArray::fromStdString(copied.dump()));
    QCOMPARE(
        fixture.run({"exercise", kShaftExercise, "--hand-in", "own.json", "--name", "Cleo", "-o", "cleo.handwheel"})
            .code,
        0);
    const QByteArray own = fixture.run({"mark", kShaftExercise, "ada.handwheel", "cleo.handwheel"}).out;
    QVERIFY2(!own.contains("is the same"), own);
    exercise["criteria"][0]["lower"] = 1.0;
    exercise["criteria"][0]["upper"] = 99.0;
    fixture.put("other.exercise.json", QByteArray::fromStdString(exercise.dump()));
    QVERIFY(fixture.run({"mark", "other.exercise.json", "ada.handwheel"}).out.contains("another version"));
  }

  // The bar of an exercise knows its exercise, so that the window continues it, with the time counted so far.
  void theBarKnowsItsExercise() {
    const Fixture fixture;
    QCOMPARE(fixture.run({"exercise", kShaftExercise, "--stock", "-o", "bar.handwheel"}).code, 0);
    // It stays the bar of the exercise: only its cuts change.
    QCOMPARE(fixture.run({"set", "bar.handwheel", "material=brass", "-o", "bar.handwheel"}).code, 1);
    QCOMPARE(
        fixture.run({"exercise", kShaftExercise, "--hand-in", "bar.handwheel", "--name", "Ada", "-o", "a.handwheel"})
            .code,
        0);
    const Ran marked = fixture.run({"mark", kShaftExercise, "a.handwheel", "--json"});
    QCOMPARE(nlohmann::json::parse(marked.out.toStdString())["submissions"][0]["seconds"].get<double>(), 0.0);
  }

  void workIsDescribedToo() {
    const Fixture fixture;
    nlohmann::json work = solutionOfShaft();
    for (nlohmann::json& pass : work["passes"]) pass["feed"] = 0.8;
    fixture.put("work.json", QByteArray::fromStdString(work.dump()));
    QCOMPARE(
        fixture.run({"exercise", kShaftExercise, "--hand-in", "work.json", "--name", "Cleo", "-o", "cleo.handwheel"})
            .code,
        0);
    const Ran marked = fixture.run({"mark", kShaftExercise, "cleo.handwheel"});
    QVERIFY2(marked.code == 0 && marked.out.contains("Cleo") && marked.out.contains("above the upper limit"),
             marked.out);
  }

  void whatCannotBeMarked() {
    const Fixture fixture;
    fixture.put("junk.handwheel", "not a file of ours");
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    QCOMPARE(fixture
                 .run({"exercise", test::sourcePath("resources/samples/exercises/bush.exercise.json"), "-o",
                       "bush.handwheel"})
                 .code,
             0);
    QCOMPARE(fixture.run({"exercise", "bush.handwheel", "--stock", "-o", "stock.handwheel"}).code, 0);
    QCOMPARE(
        fixture.run({"exercise", "bush.handwheel", "--hand-in", "stock.handwheel", "--name", "A", "-o", "a.handwheel"})
            .code,
        0);
    const Ran marked = fixture.run(
        {"mark", kShaftExercise, "junk.handwheel", "bar.handwheel", "a.handwheel", "none.handwheel", "--json"});
    QCOMPARE(marked.code, 2);
    const nlohmann::json json = nlohmann::json::parse(marked.out.toStdString());
    for (const nlohmann::json& each : json["submissions"]) QVERIFY(each["problem"].is_string());
    QVERIFY(json["submissions"][2]["problem"].get<std::string>().find("another exercise") != std::string::npos);

    QCOMPARE(
        fixture.run({"exercise", "bush.handwheel", "--hand-in", "bar.handwheel", "--name", "A", "-o", "x.handwheel"})
            .code,
        1);
    QCOMPARE(fixture.run({"exercise", "bush.handwheel", "--hand-in", "stock.handwheel", "-o", "x.handwheel"}).code, 1);
    QCOMPARE(fixture.run({"exercise", "bush.handwheel", "--student", "--stock", "-o", "x.handwheel"}).code, 1);
    QCOMPARE(fixture.run({"exercise", "bar.handwheel", "-o", "x.handwheel"}).code, 1);
    QCOMPARE(fixture.run({"exercise", "bush.handwheel"}).code, 1);
    QCOMPARE(fixture.run({"mark", kShaftExercise}).code, 1);
    QCOMPARE(fixture.run({"mark", kShaftExercise, "a.handwheel", "--report", "x.doc"}).code, 1);
    QCOMPARE(fixture.run({"mark", kShaftExercise, "a.handwheel", "--sort", "Shoe size"}).code, 1);
    QVERIFY(!fixture.names().contains("x.handwheel"));
  }

  // Work by hand in the window is a document with its passes. Without a window they are cut again in the bar of the
  // exercise: the same part, and the same marks; also for submissions.
  void workIsTurnedAgain_data() {
    QTest::addColumn<QString>("name");
    for (const char* const name : {"shaft", "bush", "thread-m20"}) QTest::newRow(name) << QString::fromLatin1(name);
  }
  void workIsTurnedAgain() {
    QFETCH(QString, name);
    const Fixture fixture;
    const QString exercise = test::sourcePath("resources/samples/exercises/%1.exercise.json").arg(name);
    const auto json = [&](const QStringList& words) {
      const Ran run = fixture.run(words);
      if (run.code != 0) qWarning("%s", run.err.constData());
      return run.code == 0 ? nlohmann::json::parse(run.out.toStdString()) : nlohmann::json();
    };
    QCOMPARE(fixture.run({"exercise", exercise, "--solution", "-o", "work.handwheel"}).code, 0);
    QVERIFY(json({"turn", exercise, "--recording", "work.handwheel", "-o", "again.handwheel", "--json"})
                .contains("removed_mm3"));
    const nlohmann::json work = json({"turn", "work.handwheel", "--replay", "--json"});
    QVERIFY(work == json({"turn", "again.handwheel", "--replay", "--json"}) && work["same"].get<bool>());
    QCOMPARE(fixture.run({"exercise", exercise, "--hand-in", "again.handwheel", "--name", "Ada", "-o", "ada.handwheel"})
                 .code,
             0);
    QVERIFY(json({"turn", exercise, "--recording", "ada.handwheel", "-o", "third.handwheel", "--json"})
                .contains("removed_mm3"));
    QVERIFY(work == json({"turn", "third.handwheel", "--replay", "--json"}));
    const nlohmann::json marked = json({"mark", exercise, "ada.handwheel", "--json"});
    QCOMPARE(marked["submissions"][0]["points"], marked["submissions"][0]["of"]);

    const Ran nose =
        fixture.run({"turn", exercise, "--recording", "work.handwheel", "--nose", "2", "-o", "x.handwheel"});
    QVERIFY(nose.code == 1 && nose.err.contains("--nose is not for a document"));
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);  // with no passes
    QCOMPARE(fixture.run({"turn", exercise, "--recording", "bar.handwheel", "-o", "x.handwheel"}).code, 2);
    QVERIFY(!fixture.names().contains("x.handwheel"));
  }

  // A lathe that stands has no speed for a recording, which is turned at 500 r/min then: 1 mm/s is a feed of 0.12 mm,
  // and a nose of 1 mm leaves f²/(32 R).
  void aRecordingOnALatheThatStands() {
    const Fixture fixture;
    QFile file(kShaftExercise);
    QVERIFY(file.open(QIODevice::ReadOnly));
    nlohmann::json standing = nlohmann::json::parse(file.readAll().toStdString());
    standing["task"]["spindle_speed"] = 0;
    standing.erase("solution");  // its passes have the speed of the lathe, as those of the faulty works
    standing.erase("faults");
    fixture.put("standing.exercise.json", QByteArray::fromStdString(standing.dump()));
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,20,0,125\n65,20,0,60\n");
    const Ran ran =
        fixture.run({"turn", "standing.exercise.json", "--recording", "p.csv", "-o", "part.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json json = nlohmann::json::parse(ran.out.toStdString());
    QVERIFY2(json["max_force_N"].is_number() && json["max_force_N"].get<double>() > 0.0, ran.out);
    const nlohmann::json outside = json["finish"]["outside"];
    QCOMPARE(outside.size(), std::size_t{1});
    QVERIFY2(std::abs(outside[0]["roughness_um"].get<double>() - 0.45) < 1e-4, ran.out);
  }

  // If an exercise is to be done by hand, no program cuts its bar, nor work begun on it.
  void noProgramWhereItIsToBeDoneByHand() {
    const Fixture fixture;
    QFile file(kShaftExercise);
    QVERIFY(file.open(QIODevice::ReadOnly));
    nlohmann::json byHand = nlohmann::json::parse(file.readAll().toStdString());
    byHand["task"]["programs"] = false;
    fixture.put("hand.exercise.json", QByteArray::fromStdString(byHand.dump()));
    fixture.put("p.ngc", "G21 G18 G7 S500 M3\nF100\nG0 X44 Z2\nG0 X36\nG1 Z-30\nM2\n");
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,20,0,125\n65,20,0,60\n");
    QCOMPARE(fixture.run({"exercise", "hand.exercise.json", "--stock", "-o", "bar.handwheel"}).code, 0);
    for (const char* const work : {"hand.exercise.json", "bar.handwheel"}) {
      const Ran refused = fixture.run({"turn", work, "--program", "p.ngc", "-o", "x.handwheel"});
      QCOMPARE(refused.code, 1);
      QVERIFY2(refused.err.contains(work) && refused.err.contains("done by hand"), refused.err);
      QVERIFY(!fixture.names().contains("x.handwheel"));
    }
    QCOMPARE(fixture.run({"turn", "bar.handwheel", "--recording", "p.csv", "-o", "x.handwheel"}).code, 0);
  }

  // The thread of an exercise is cut on the lathe. Where the teacher allows commands it may be one, and the report says
  // so, as it does of one that was made in a copy of the bar.
  void noThreadByACommand() {
    const Fixture fixture;
    const QString exercise = test::sourcePath("resources/samples/exercises/thread-m20.exercise.json");
    QCOMPARE(fixture.run({"exercise", exercise, "-o", "e.handwheel"}).code, 0);
    const QStringList thread{"--from", "60", "--to", "80", "--pitch", "2.5", "-o", "done.handwheel"};
    QCOMPARE(fixture.run({"exercise", "e.handwheel", "--stock", "-o", "bar.handwheel"}).code, 0);
    const Ran refused = fixture.run(QStringList{"thread", "bar.handwheel"} + thread);
    QCOMPARE(refused.code, 1);
    QVERIFY2(refused.err.contains("does not allow a command") && refused.err.contains("bar.handwheel"), refused.err);
    QVERIFY(!fixture.names().contains("done.handwheel"));
    QCOMPARE(fixture.run({"set", "e.handwheel", "commands=yes", "-o", "e.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"exercise", "e.handwheel", "--stock", "-o", "open.handwheel"}).code, 0);
    QCOMPARE(fixture.run(QStringList{"thread", "open.handwheel"} + thread).code, 0);
    QCOMPARE(
        fixture.run({"exercise", "e.handwheel", "--hand-in", "done.handwheel", "--name", "Ada", "-o", "a.handwheel"})
            .code,
        0);
    const Ran marked = fixture.run({"mark", "e.handwheel", "a.handwheel", "--json"});
    const nlohmann::json made = nlohmann::json::parse(marked.out.toStdString())["submissions"][0]["made_by"];
    QCOMPARE(made.get<std::string>(), std::string("command"));
  }

  // Names of 14 letters head two columns of the table of a class, but not six: a page of A4 has no room for 84 letters
  // beside the cells of a student.
  void namesAsHeadings() {
    const Fixture fixture;
    QFile file(kShaftExercise);
    QVERIFY(file.open(QIODevice::ReadOnly));
    nlohmann::json exercise = nlohmann::json::parse(file.readAll().toStdString());
    nlohmann::json criterion = exercise["criteria"][0];
    criterion["name"] = "Shoulderlength";
    exercise["criteria"] = nlohmann::json::array();
    for (nlohmann::json& step : exercise["steps"]) step["criteria"] = nlohmann::json::array();
    for (const std::size_t count : {std::size_t{2}, std::size_t{6}}) {
      while (exercise["criteria"].size() < count) {
        criterion["id"] = "c" + std::to_string(exercise["criteria"].size());
        exercise["criteria"].push_back(criterion);
      }
      fixture.put("named.exercise.json", QByteArray::fromStdString(exercise.dump()));
      QCOMPARE(fixture.run({"exercise", "named.exercise.json", "--solution", "-o", "work.handwheel"}).code, 0);
      for (const QString name : {"ada", "bob"}) {
        const QStringList handIn{"exercise", "named.exercise.json", "--hand-in", "work.handwheel", "--name", name,
                                 "-o",       name + ".handwheel"};
        QCOMPARE(fixture.run(handIn).code, 0);
      }
      QCOMPARE(
          fixture.run({"mark", "named.exercise.json", "ada.handwheel", "bob.handwheel", "--report", "r.html"}).code, 0);
      const QByteArray html = fixture.content("r.html");
      QCOMPARE(html.contains("nowrap\">Shoulderlength</th>"), count == 2);
      QCOMPARE(html.contains("The numbered columns"), count == 6);
    }
  }

  // One point is written as one.
  void aSinglePoint() {
    const Fixture fixture;
    QFile file(kShaftExercise);
    QVERIFY(file.open(QIODevice::ReadOnly));
    nlohmann::json one = nlohmann::json::parse(file.readAll().toStdString());
    nlohmann::json criterion = one["criteria"][0];
    criterion["points"] = 1;
    one["criteria"] = nlohmann::json::array({criterion});
    for (nlohmann::json& step : one["steps"]) step["criteria"] = nlohmann::json::array();
    fixture.put("one.exercise.json", QByteArray::fromStdString(one.dump()));
    QCOMPARE(fixture.run({"exercise", "one.exercise.json", "--solution", "-o", "work.handwheel"}).code, 0);
    QCOMPARE(fixture
                 .run({"exercise", "one.exercise.json", "--hand-in", "work.handwheel", "--name", "Ada", "-o",
                       "ada.handwheel"})
                 .code,
             0);
    const Ran marked = fixture.run({"mark", "one.exercise.json", "ada.handwheel"});
    QVERIFY2(marked.code == 0 && marked.out.contains("1 of 1 point\n"), marked.out);
  }
};

HANDWHEEL_TEST(ExerciseTest)
#include "ExerciseTest.moc"
