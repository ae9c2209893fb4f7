// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramObstacles.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"

#include <QtTest>

using namespace handwheel;

namespace {

const LatheTools& shipped() {
  static const LatheTools kShipped = shippedLatheTools();
  return kShipped;
}

// A bar in a chuck that holds 20 mm of it, T1 with a body of the lathe.
struct BodyTrial {
  explicit BodyTrial(double diameter, const char* tool) : bar{diameter, 100.0, 0.0} {
    setup = usualSetup(ProgramDialect::LinuxCnc, bar, 20.0, 0.0);
    setup.tools[1] = programToolOf(toolNamed(shipped(), tool), ProgramDialect::LinuxCnc);
    setup.lathe.emplace();
    setup.lathe->chuck.grip = 20.0;
  }
  std::vector<ProgramCollision> run(const std::string& cuts) const {
    const auto path = runProgram("G7 G21 T1 M6 G43\nG97 S600 M3\n" + cuts + "\nM2\n", setup);
    if (!path) qFatal("%s", path.error().arguments.empty() ? "?" : path.error().arguments.back().c_str());
    ProgramSimulation simulation(TurnedProfile(bar, 0.02), *path, setup);
    simulation.run({});
    return simulation.collisions();
  }
  StockCylinder bar;
  ProgramSetup setup;
};

bool isContact(const std::vector<ProgramCollision>& all, LathePart moving, LathePart struck, std::uint32_t line) {
  return all.size() == 1 && all[0].kind == ProgramCollision::Kind::Contact && all[0].moving == moving &&
         all[0].struck == struck && all[0].line == line;
}

}  // namespace

// Contacts of holder, post and slide in programs. The positions follow from the sections in
// resources/machining/tools.json and LatheCollisions.
class ProgramObstaclesTest : public QObject {
  Q_OBJECT

 private slots:
  // A plunge makes room as wide as the insert, whose trailing edge goes from (0.15, 0.72) beyond the tip 0.781 mm along
  // for each mm outward. The side of the holder, from (8, 4.5) to (20, 23), leaves that room 11.07 mm behind the tip.
  void theHolderMeetsTheWork() {
    const BodyTrial trial(40.0, "right-finishing");
    QVERIFY(trial.run("G0 X44 Z-50\nG1 X18.4 F60\nG0 X44").empty());  // 10.8 mm deep
    QVERIFY(isContact(trial.run("G0 X44 Z-50\nG1 X17.2 F60\nG0 X44"), LathePart::Holder, LathePart::Work, 4));
    BodyTrial bare(40.0, "right-finishing");
    bare.setup.tools[1].body = nullptr;
    QVERIFY(bare.run("G0 X44 Z-50\nG1 X17.2 F60\nG0 X44").empty());
  }

  // Turning along the bar the holder follows where the insert has made room. A plunge as deep makes room for the
  // insert only, which ends 13 mm beyond its tip: the holder has a corner 8 mm out and 15 mm beyond it.
  void theHolderFollowsTheNose() {
    const BodyTrial trial(40.0, "right-roughing");
    QVERIFY(trial.run("G0 X22 Z2\nG1 Z-60 F120\nG0 X44").empty());  // 9 mm deep
    const auto back = trial.run("G0 X44 Z-60\nG1 X22 F60\nG1 Z2 F120");
    QVERIFY(isContact(back, LathePart::Holder, LathePart::Work, 4));
  }

  // A large chuck reaches to the slide of a tool that faces a thin bar, whose tip is far from the jaws: the slide is 70
  // mm out and 45 mm towards the chuck from the tip, the body of the chuck 10 mm behind the lower end.
  void theSlideMeetsTheChuck() {
    BodyTrial trial(12.0, "right-finishing");
    trial.setup.lathe->chuck.diameter = 160.0;
    QVERIFY(trial.run("G0 X14 Z-64\nG1 X10 F60\nG0 X14").empty());
    QVERIFY(isContact(trial.run("G0 X14 Z-66\nG1 X10 F60\nG0 X14"), LathePart::Slide, LathePart::Chuck, 3));
  }

  // The centre stands in the end of the bar; its quill is 30 mm behind, 20 mm in radius. The holder of the roughing
  // tool has a corner 8 mm out and 15 mm beyond the tip.
  void theHolderMeetsTheQuill() {
    BodyTrial trial(12.0, "right-roughing");
    trial.setup.lathe->tailstock.fitting = LatheFitting::Centre;
    trial.setup.lathe->tailstock.position = 100.0;
    QVERIFY(trial.run("G0 X60 Z10\nG0 X22\nG1 X60 F60").empty());
    QVERIFY(isContact(trial.run("G0 X60 Z16\nG0 X22\nG1 X60 F60"), LathePart::Holder, LathePart::Fitting, 4));
    trial.setup.lathe->tailstock.fitting = LatheFitting::None;
    QVERIFY(trial.run("G0 X60 Z16\nG0 X22\nG1 X60 F60").empty());
  }

  // The holder of the threading tool begins 8.5 mm behind its tip. A thread takes nothing of the envelope, so that it
  // meets the bar where the tip is deeper.
  void aThreadHasAHolder() {
    const BodyTrial trial(40.0, "threading-60");
    QVERIFY(trial.run("G0 X23.2 Z15\nG33 Z-20 K1.5\nG0 X60").empty());
    const auto met = trial.run("G0 X22.8 Z15\nG33 Z-20 K1.5\nG0 X60");
    QVERIFY(!met.empty() && met[0].kind == ProgramCollision::Kind::Contact);
    QVERIFY(met[0].moving == LathePart::Holder && met[0].struck == LathePart::Work && met[0].line == 4);
  }

  // A table as text gives the same tools again, bodies included; values that a line does not state follow from its
  // body.
  void tablesWithBodies() {
    for (const ProgramDialect dialect : {ProgramDialect::LinuxCnc, ProgramDialect::Fanuc}) {
      ProgramTools tools;
      int number = 0;
      for (const auto& tool : shipped()) tools[++number] = programToolOf(tool, dialect);
      tools[99] = {0.8, 2, {1.5, -2.0}};
      tools[2].isTurnedOver = tools[99].isTurnedOver = true;
      const auto read = readToolTable(toolTableText(tools), shipped(), dialect);
      QVERIFY(read.hasValue() && read->size() == tools.size());
      for (const auto& [name, tool] : tools) {
        const ProgramTool& again = read->at(name);
        QVERIFY(again.body == tool.body && again.noseRadius == tool.noseRadius);
        QVERIFY(again.orientation == tool.orientation && again.offset == tool.offset);
        QCOMPARE(again.isTurnedOver, tool.isTurnedOver);
      }
      const auto bare = readToolTable("T5 ; boring-12 of mine\nT6 D20 ;drill-20\nT7 ;spoon\n", shipped(), dialect);
      QVERIFY(bare.hasValue() && bare->at(5).body->id == "boring-12" && bare->at(5).noseRadius == 0.4);
      // Outward and towards the chuck.
      QVERIFY(tipDirection(dialect, bare->at(5).orientation) == ProfilePoint(1, -1));
      QVERIFY(bare->at(6).noseRadius == 10.0 && tipDirection(dialect, bare->at(6).orientation) == ProfilePoint(0, -1));
      QVERIFY(!bare->at(7).body);
    }
  }

  // A comment whose first word is nearly the id of a tool is noted on its line; other comments are free.
  void mistypedIdsAreNoted() {
    const auto noted = [](const std::string& comment) {
      std::vector<ToolPath::Note> notes;
      const auto read =
          readToolTable("T1 D0.8\nT2 D0.8 ;" + comment + "\n", shipped(), ProgramDialect::LinuxCnc, &notes);
      if (!read || read->at(2).body || notes.size() > 1) return std::string("wrong");
      return notes.empty() ? std::string() : std::to_string(notes[0].line) + " " + notes[0].text;
    };
    QCOMPARE(noted("right-rouging"),
             std::string("2 'right-rouging' is no tool of the lathe, so only the nose of this one "
                         "is known. Write right-roughing if that is meant."));
    for (const char* const word : {" Right-Roughing of steel", "drill-11", "boring_12", "drill16", "facin", "partin-3"})
      QVERIFY2(!noted(word).empty(), word);
    for (const char* const word :
         {"", "spoon", "facet", "R0.8", "12 mm drill", "CNMG-120408", "upside-down", "left-hand"})
      QCOMPARE(noted(word), std::string());
  }

  void tablesAreRefused() {
    const auto refusal = [](const std::string& text) {
      const auto read = readToolTable(text);
      if (read) return std::string();
      const Error& error = read.error();
      return std::to_string(error.position.value) + ": " + error.arguments.at(1) + ": " + error.arguments.at(2);
    };
    QCOMPARE(refusal("; X1\n\n  T1 P1 X0 Z0 D0.8 Q2\r\n"), std::string());
    QCOMPARE(refusal("T1 D0.8\nT2 D\n"), std::string("2: D: this is not a word of a tool table"));
    QCOMPARE(refusal("T1 D0,8\n"), std::string("1: ,8: this is not a word of a tool table"));
    QCOMPARE(refusal("T1 X2000000\n"), std::string("1: X2000000: this is not a word of a tool table"));
    QCOMPARE(refusal("T1\nX1 Z2\n"), std::string("2: T: the line has no tool number"));
    std::string many;
    for (int i = 0; i <= 1000; ++i) many += "T" + std::to_string(i) + "\n";
    QCOMPARE(refusal(many), std::string("1001: T: there are too many tools"));
  }
};

HANDWHEEL_TEST(ProgramObstaclesTest)
#include "ProgramObstaclesTest.moc"
