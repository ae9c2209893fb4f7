// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyProgram.h"
#include "TestClass.h"
#include "base/Units.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr const char* kNoExternal = ",[9E9,9E9,9E9,9E9,9E9,9E9]]";

std::string jointTarget(int first) {
  return "[[" + std::to_string(first) + ",0,0,0,30,0]" + kNoExternal;
}

// Returns the first joint of each motion, degrees; empty if the program is refused.
std::vector<int> firstJoints(const ReadMotions& read) {
  std::vector<int> all;
  if (!read) return all;
  for (const ParsedMotion& motion : *read)
    all.push_back(static_cast<int>(std::lround(motion.joints->coeff(0) / kRadiansPerDegree)));
  return all;
}

std::vector<std::string> lineTexts(const std::vector<ProgramLine>& lines) {
  std::vector<std::string> texts;
  for (const ProgramLine& line : lines) texts.push_back(line.text);
  return texts;
}

ReadMotions readWith(const std::string& data, const std::string& text) {
  RobotProgram program = programOf("irb120");
  program.data = data;
  return readBy("krl", text, program);
}

RobotProgram programCalled(const std::string& name, const std::vector<ParsedMotion>& motions, const char* language) {
  RobotProgram program = programWith(motions, language);
  program.name = name;
  return program;
}

// Returns how often a text has a part.
int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

// Tests the names of programs: their scopes, what they declare, and signals, by the manuals of the languages.
class ProgramNamesTest : public QObject {
  Q_OBJECT

 private slots:
  // Data of a routine hide those of the module, and LOCAL data are those of their module.
  void rapidScopes() {
    const std::string local = "CONST jointtarget p10:=";
    QCOMPARE(
        firstJoints(readBy("rapid", "MODULE m\nPROC main()\na;\nb;\na;\nENDPROC\nPROC a()\n" + local + jointTarget(7) +
                                        ";\nMoveAbsJ p10,v100,fine,tool0;\nENDPROC\nPROC b()\n" + local +
                                        jointTarget(50) + ";\nMoveAbsJ p10,v100,fine,tool0;\nENDPROC\nENDMODULE\n")),
        (std::vector<int>{7, 50, 7}));
    QCOMPARE(firstJoints(readBy("rapid", "MODULE a\nLOCAL " + local + jointTarget(7) +
                                             ";\nPROC main()\nMoveAbsJ p10,v100,fine,tool0;\nsub;\nENDPROC\nENDMODULE\n"
                                             "MODULE b\nLOCAL " +
                                             local + jointTarget(40) +
                                             ";\nPROC sub()\nMoveAbsJ p10,v100,fine,tool0;\nENDPROC\nENDMODULE\n")),
             (std::vector<int>{7, 40}));
    // All modules see what one shares; two different values of one name are none.
    const std::string other = "ENDMODULE\nMODULE b\n" + local + jointTarget(40) + ";\nENDMODULE\n";
    const std::string main = "PROC main()\nMoveAbsJ p10,v100,fine,tool0;\nENDPROC\n";
    QCOMPARE(firstJoints(readBy("rapid", "MODULE a\n" + main + other)), (std::vector<int>{40}));
    QCOMPARE(refusedLine(readBy("rapid", "MODULE a\n" + local + jointTarget(7) + ";\n" + main + other)),
             std::uint64_t{4});
    // The tools of two routines: 100 mm and nothing before the flange.
    const auto tool = [](int length) {
      return "PERS tooldata t:=[TRUE,[[0,0," + std::to_string(length) +
             "],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\nMoveAbsJ " + jointTarget(0) + ",v100,fine,t;\nENDPROC\n";
    };
    const auto tools = readBy("rapid", "PROC main()\nx; y;\nENDPROC\nPROC x()\n" + tool(100) + "PROC y()\n" + tool(0));
    QVERIFY(tools.hasValue());
    QCOMPARE((*tools)[0].tool->translation().z(), 100.0);
    QCOMPARE((*tools)[1].tool->translation().z(), 0.0);
    // A variable or a parameter of the routine hides the constant of the module: nobody knows its number.
    const std::string pose = "[[300,0,500],[1,0,0,0],[0,0,0,0]" + std::string(kNoExternal);
    const std::string move = "ConfL\\Off;\nMoveL Offs(" + pose + ",0,0,h),v100,fine,tool0;\nENDPROC\n";
    const std::string constant = "CONST num h:=5;\n";
    QVERIFY(readBy("rapid", constant + "PROC main()\n" + move).hasValue());
    QVERIFY(!readBy("rapid", constant + "PROC main()\nVAR num h:=5;\n" + move).hasValue());
    QVERIFY(!readBy("rapid", constant + "PROC main(\\num h)\n" + move).hasValue());
    // Two routines of one name, in different modules.
    const std::string sub = "LOCAL PROC sub()\nMoveAbsJ " + jointTarget(1) + ",v100,fine,tool0;\nENDPROC\n";
    QVERIFY(
        !readBy("rapid", "MODULE a\n" + sub + "PROC main()\nsub;\nENDPROC\nENDMODULE\nMODULE b\n" + sub + "ENDMODULE\n")
             .hasValue());
  }

  // Written modules declare what their lines name, each name once.
  void rapidDeclarations() {
    const auto rewritten = [](const std::string& text, const std::string& name) {
      const auto read = readBy("rapid", text);
      if (!read) return std::string();
      const RobotProgram program = programCalled(name, *read, "rapid");
      const std::string written = postCalled("rapid")->write(program);
      return checkWritten(*postCalled("rapid"), program, written) ? written : std::string("differs");
    };
    const std::string move = "MoveAbsJ " + jointTarget(0) + ",v100,fine,tool0;\n";
    // Variables of one name in two routines are two.
    const std::string two = rewritten("MODULE m\nPROC main()\na;\nb;\nENDPROC\nPROC a()\nVAR num i;\ni:=1;\n" + move +
                                          "ENDPROC\nPROC b()\nVAR num i;\ni:=2;\n" + move + "ENDPROC\nENDMODULE\n",
                                      "dup");
    QCOMPARE(countOf(two, "VAR num i;"), 1);
    QCOMPARE(countOf(two, "VAR num i_2;"), 1);
    QCOMPARE(countOf(two, " i:=1;"), 1);
    QCOMPARE(countOf(two, " i_2:=2;"), 1);
    // Own names beside those of the lines.
    const std::string beside = rewritten("MODULE m\nVAR num p_tool;\nVAR num p_frame;\nVAR num p;\nPROC main()\n" +
                                             move + "p:=1;\n" + move + "ENDPROC\nENDMODULE\n",
                                         "p");
    QCOMPARE(countOf(beside, " p_tool:="), 0);
    QCOMPARE(countOf(beside, "PROC p()"), 0);
    QVERIFY(!beside.empty());
    // Targets, zones and records that lines name are declared, too; others are not.
    const std::string named = rewritten(
        "MODULE m\nRECORD part\nnum x; ! of it\nENDRECORD\nVAR part q;\nTASK PERS zonedata zz:=[FALSE,5,5,5,1,5,1];\n"
        "CONST robtarget p1:=[[300,0,500],[0,0,1,0],[0,0,0,0]" +
            std::string(kNoExternal) + ";\nCONST robtarget p2:=[[300,0,500],[0,0,1,0],[0,0,0,0]" + kNoExternal +
            ";\nVAR num z0;\nTASK PERS num n:=1;\nPROC rec2()\n" + move +
            "q.x:=p1.trans.x;\nz0:=zz.pzone_tcp;\nn:=2;\n" + move + "ENDPROC\nENDMODULE\n",
        "rec");
    QCOMPARE(countOf(named, "CONST robtarget p1:="), 1);
    QCOMPARE(countOf(named, "CONST robtarget p2:="), 0);
    QCOMPARE(countOf(named, "TASK PERS zonedata zz:="), 1);
    QCOMPARE(countOf(named, "TASK PERS num n:=1;"), 1);
    QCOMPARE(countOf(named, "ENDRECORD\n"), 1);
    QVERIFY(named.find("RECORD part") < named.find("VAR part q;"));
  }

  // A local variable of one function is not that of another one.
  void urScopes() {
    const std::string main = "def main():\n q = [0,-1.5,1.5,0,1,0]\n movej(q)\n f()\n movej(q)\nend\nmain()\n";
    const auto f = [](const std::string& word) {
      return "def f():\n " + word + "q = [1,-1.5,1.5,0,1,0]\n movej(q)\nend\n";
    };
    QCOMPARE(refusedLine(readBy("urscript", f("local ") + main)), std::uint64_t{2});
    QCOMPARE(refusedLine(readBy("urscript", f("") + main)), std::uint64_t{2});
    const std::string inside = "def f():\n local q = [1,-1.5,1.5,0,1,0]\n movej(q)\nend\ndef main():\n f()\n ";
    QVERIFY(readBy("urscript", inside + "movej([0,0,0,0,0,0])\nend\nmain()\n").hasValue());
    QCOMPARE(refusedLine(readBy("urscript", inside + "movej(q)\nend\nmain()\n")), std::uint64_t{7});
    // A global one is the same everywhere.
    const auto global = readBy("urscript", "global q = [0,0,0,0,0,0]\n" + f("") + "movej(q)\nf()\nmovej(q)\n");
    QVERIFY(global.hasValue());
    QCOMPARE((*global)[0].joints->coeff(0), 0.0);
    QCOMPARE((*global)[2].joints->coeff(0), 1.0);
  }

  // An assignment to a signal switches an output; nobody knows what a name is that is declared nowhere.
  void krlSignals_data() {
    QTest::addColumn<QByteArray>("declarations");
    QTest::addColumn<QByteArray>("statement");
    QTest::addColumn<QByteArray>("data");
    QTest::addColumn<bool>("mayGrip");
    const auto row = [](const char* declarations, const char* statement, const char* data, bool mayGrip) {
      QTest::addRow("%s %s %s", declarations, statement, data)
          << QByteArray(declarations) << QByteArray(statement) << QByteArray(data) << mayGrip;
    };
    row("SIGNAL GRIP $OUT[5]", "GRIP=TRUE", "", true);
    row("SIGNAL GRIP $OUT[5]", "grip = N==1", "", true);
    row("", "GRIP=TRUE", "DEFDAT P\nSIGNAL GRIP $OUT[5]\nENDDAT\n", true);
    row("", "GRIP=TRUE", "DEFDAT $CONFIG PUBLIC\nGLOBAL SIGNAL GRIP $OUT[5] TO $OUT[8]\nENDDAT\n", true);
    row("", "GRIP=TRUE", "", true);
    row("DECL BOOL A,GRIP", "GRIP=TRUE", "", false);
    row("", "GRIP=TRUE", "DEFDAT $CONFIG PUBLIC\nBOOL GRIP=FALSE\nENDDAT\n", false);
    row("DECL INT N[3]", "N[1]=2", "", false);
    row("", "$OUT[5]=TRUE", "", true);
    row("", "$OUT_C[5]=TRUE", "", true);
    row("", "$OV_PRO=50", "", false);
  }
  void krlSignals() {
    QFETCH(const QByteArray, declarations);
    QFETCH(const QByteArray, statement);
    QFETCH(const QByteArray, data);
    QFETCH(const bool, mayGrip);
    const std::string axes = "PTP {A1 0,A2 -90,A3 90,A4 0,A5 30,A6 0}\n";
    const auto read = readWith(data.toStdString(), "DEF p()\n" + declarations.toStdString() + "\n" + axes +
                                                       statement.toStdString() + "\n" + axes + "END\n");
    QVERIFY(read.hasValue());
    QCOMPARE((*read)[0].lines.size(), std::size_t{1});
    QCOMPARE((*read)[0].lines[0].mayGrip, mayGrip);
  }

  // Declarations that lines need come from the data of the program. Programs cannot declare values.
  void krlDeclarations() {
    const std::string data =
        "DEFDAT d\nDECL INT n=1,unused=2\nSTRUC PART REAL X,INT Y\nDECL PART Q={X 1.5,Y 2}\nDECL INT A[2]\nA[1]=7\n"
        "ENDDAT\nDEFDAT $CONFIG PUBLIC\nINT everywhere=3\nENDDAT\n";
    const std::string axes = "PTP {A1 0,A2 -90,A3 90,A4 0,A5 30,A6 0}\n";
    const auto read = readWith(data, "DEF d()\n" + axes + "n=n+1\nQ.X=everywhere\nA[2]=A[1]\n" + axes + "END\n");
    QVERIFY(read.hasValue());
    std::vector<std::string> head = lineTexts(read->front().before);
    QCOMPARE(head.size(), std::size_t{7});
    const auto at = [&](const char* text) { return std::ranges::find(head, text) - head.begin(); };
    QVERIFY(at("STRUC PART REAL X,INT Y") < at("DECL PART Q"));
    QVERIFY(at("DECL PART Q") < at("Q={X 1.5,Y 2}") && at("Q={X 1.5,Y 2}") < 7);
    QVERIFY(at("DECL INT n") < at("n=1") && at("n=1") < 7);
    QVERIFY(at("DECL INT A[2]") < at("A[1]=7") && at("A[1]=7") < 7);
    const RobotProgram program = programCalled("d", *read, "krl");
    const std::string written = postCalled("krl")->write(program);
    QVERIFY(checkWritten(*postCalled("krl"), program, written).hasValue());
    QVERIFY(written.find("DEF n()") == written.npos);
    RobotProgram other = program;
    other.name = "n";
    QVERIFY(postCalled("krl")->write(other).find("DEF n_path()") != std::string::npos);
  }

  void namesOfTexts() {
    QCOMPARE(namesIn("a.b:=Foo(\"c d\")+$OUT[x1]\\Time:=2e3"), (std::vector<std::string>{"a", "foo", "$out", "x1"}));
  }
};

HANDWHEEL_TEST(ProgramNamesTest)
#include "ProgramNamesTest.moc"
