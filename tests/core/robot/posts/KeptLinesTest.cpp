// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyProgram.h"
#include "TestClass.h"
#include "base/Units.h"
#include "robot/posts/PostErrors.h"

#include <QTest>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr const char* kRapidMove = "MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n";
constexpr const char* kKrlMove = "PTP {A1 0,A2 -90,A3 90,A4 0,A5 30,A6 0}\n";
constexpr const char* kUrMove = "movej([0,0,0,0,0,0])\n";

// Returns a program with two positions, of which each has this text after J6.
std::string fanuc(const std::string& first, const std::string& second, const std::string& option = {}) {
  const auto position = [](const char* number, const std::string& more) {
    return std::string("P[") + number +
           "]{\n   GP1:\n\tUF : 0, UT : 1,\n\tJ1= 0 deg, J2= 0 deg, J3= 0 deg,\n\tJ4= 0 deg, J5= 30 deg, J6= 0 deg" +
           more + "\n};\n";
  };
  return "/PROG A\n/MN\n 1:J P[1] 50% FINE ;\n 2:J P[2] 50% FINE" + option + " ;\n/POS\n" + position("1", first) +
         position("2", second) + "/END\n";
}

// Returns what is written for a program that was read; empty if that differs.
std::string writtenBack(const char* post, const ReadMotions& read) {
  const RobotProgram program = programWith(*read, post);
  const std::string text = postCalled(post)->write(program);
  return checkWritten(*postCalled(post), program, text) ? text : std::string();
}

}  // namespace

// Tests what a path keeps of a program beside its motions, what it leaves out, and what is refused.
class KeptLinesTest : public QObject {
  Q_OBJECT

 private slots:
  // A byte-order mark and the ends of lines say nothing; bytes that are no UTF-8 are Latin-1.
  void bytes() {
    const std::string mark = "\xef\xbb\xbf";
    for (const auto& [post, move] : {std::pair("rapid", kRapidMove), {"krl", kKrlMove}, {"urscript", kUrMove}}) {
      const auto read = readBy(post, mark + move);
      QVERIFY2(read.hasValue() && read->size() == 1 && (*read)[0].line == 1, post);
    }
    QVERIFY(readBy("fanuc", mark + fanuc("", "")).hasValue());
    const auto spread = readBy(
        "rapid", std::string("PROC main()\r\n") + kRapidMove + "WaitUntil di1=1\r\n AND di2=1;\r\n\x01\r\nENDPROC\r\n");
    QVERIFY(spread.hasValue());
    QCOMPARE((*spread)[0].lines[0].text, std::string("WaitUntil di1=1  AND di2=1"));
    const std::string write = "TPWrite \"gr\xfc\xdf; x\";\n! k\xf6rper\n";
    const auto latin = readBy("rapid", "PROC main()\n" + write + kRapidMove + "ENDPROC\n");
    QVERIFY(latin.hasValue());
    QCOMPARE((*latin)[0].before[0].text, std::string("TPWrite \"gr\xc3\xbc\xc3\x9f; x\""));
    QCOMPARE((*latin)[0].before[1].text, std::string("k\xc3\xb6rper"));
    const auto unicode = readBy("rapid", "PROC main()\n! k\xc3\xb6rper\n" + std::string(kRapidMove) + "ENDPROC\n");
    QCOMPARE((*unicode)[0].before[0].text, std::string("k\xc3\xb6rper"));
  }

  // A file of a path may have 10,000 lines, and not one more.
  void tooManyLines() {
    const auto withComments = [](std::size_t count) {
      std::string text = "PROC main()\n" + std::string(kRapidMove);
      for (std::size_t i = 0; i < count; ++i) text += "! c\n";
      return readBy("rapid", text + kRapidMove + "ENDPROC\n");
    };
    QVERIFY(withComments(10'000).hasValue());
    QCOMPARE(refusedLine(withComments(10'001)), std::uint64_t{2 + 10'001});
  }

  // Nobody knows which of two positions with one number a controller takes.
  void positionsTwice() {
    std::string text = fanuc("", "");
    const std::size_t second = text.find("P[2]{");
    QCOMPARE(refusedLine(readBy("fanuc", text.replace(second, 4, "P[1]"))), std::uint64_t{3});
  }

  // Recursion of targets ends before the stack does.
  void nestedTargets() {
    const auto nested = [](int depth) {
      std::string text = "PROC main()\nConfL\\Off;\nMoveL ", end;
      for (int i = 0; i < depth; ++i) {
        text += "Offs(";
        end += ",0,0,1)";
      }
      return readBy("rapid", text + "[[300,0,500],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]" + end +
                                 ",v100,fine,tool0;\nENDPROC\n");
    };
    QVERIFY(nested(16).hasValue());
    QCOMPARE(refusedLine(nested(17)), std::uint64_t{3});
    QCOMPARE(refusedLine(nested(100'000)), std::uint64_t{3});
  }

  // External axes stay where they are, or the program is refused.
  void externalAxes() {
    const auto rapid = [](const char* first, const char* second) {
      const auto move = [](const char* axes) {
        return "MoveAbsJ [[0,0,0,0,30,0],[" + std::string(axes) + "]],v100,fine,tool0;\n";
      };
      return readBy("rapid", "PROC main()\n" + move(first) + move(second) + "ENDPROC\n");
    };
    const char* const kNone = "9E9,9E9,9E9,9E9,9E9,9E9";
    const char* const kThere = "1500,9E9,9E9,9E9,9E9,9E9";
    QVERIFY(rapid(kNone, kNone)->front().before.empty());
    QVERIFY(rapid(kNone, "0,0,0,0,0,0")->front().before.empty());
    QCOMPARE(refusedLine(rapid(kNone, kThere)), std::uint64_t{3});
    QCOMPARE(refusedLine(rapid(kThere, "1501,9E9,9E9,9E9,9E9,9E9")), std::uint64_t{3});
    const auto stands = rapid(kThere, kThere);
    QVERIFY(stands.hasValue());
    QCOMPARE(stands->front().before.size(), std::size_t{1});
    QVERIFY(writtenBack("rapid", stands).find(",[1500,9E9,9E9,9E9,9E9,9E9]]") != std::string::npos);
    const auto krl = [](const char* first, const char* second) {
      const auto move = [](const char* axes) {
        return "PTP {A1 0,A2 -90,A3 90,A4 0,A5 30,A6 0" + std::string(axes) + "}\n";
      };
      return readBy("krl", "DEF p()\n" + move(first) + move(second) + "END\n");
    };
    QVERIFY(krl("", ",E1 9E9,E2 9E9")->front().before.empty());
    QVERIFY(krl("", ",E1 0.0,E2 0.0")->front().before.empty());
    QCOMPARE(refusedLine(krl("", ",E1 1000")), std::uint64_t{3});
    QCOMPARE(refusedLine(krl(",E1 1000", ",E1 0.0")), std::uint64_t{3});
    QVERIFY(writtenBack("krl", krl(",E1 1000,E2 0", "")).find("A6 0.0000000,E1 1000,E2 0}") != std::string::npos);
    QVERIFY(readBy("fanuc", fanuc("", "\n GP2:\n UF : 0, UT : 1,\n J1= 0 deg")).hasValue() == false);
    QCOMPARE(refusedLine(readBy("fanuc", fanuc(", E1= 1000.000 mm", ", E1= 900.000 mm"))), std::uint64_t{4});
    const std::string group = ", E1= 1000.000 mm\n   GP2:\n\tUF : 0, UT : 1,\n\tJ1= 5.000 deg";
    const std::string ls = writtenBack("fanuc", readBy("fanuc", fanuc(group, group)));
    QVERIFY(ls.find("J6 = 0.000000 deg, E1= 1000 mm") != std::string::npos);
    QVERIFY(ls.find("GP2:\n    UF : 0, UT : 1, J1= 5.000 deg") != std::string::npos);
    QVERIFY(ls.find("DEFAULT_GROUP\t= 1,1,*,*,*;") != std::string::npos);
    // Other languages have other names for axes.
    RobotProgram program = programOf("irb120");
    program.language = "krl";
    program.head = krl(",E1 1000", "")->front().before;
    for (const auto& post : posts()) QCOMPARE(post->refusals(program).empty(), post->id() == std::string_view("krl"));
  }

  // Handlers of errors and traps are not in a path; those that may move the robot are refused.
  void handlers() {
    const auto handled = [](const std::string& handler) {
      return readBy("rapid", std::string("MODULE m\nPROC main()\n") + kRapidMove + "ERROR\n" + handler +
                                 "\nENDPROC\nTRAP t\nn:=1;\nENDTRAP\nENDMODULE\n");
    };
    for (const char* const harmless :
         {"RETRY;", "IF ERRNO=ERR_WAIT_MAXTIME THEN\n TPWrite \"late\"; RETRY;\nELSE\n RAISE;\nENDIF",
          "TEST ERRNO\nCASE ERR_A,ERR_B:\n n:=2; TRYNEXT;\nDEFAULT:\n RETURN;\nENDTEST", "IF ERRNO=ERR_A RETRY;"}) {
      const auto read = handled(harmless);
      QVERIFY2(read.hasValue(), harmless);
      QCOMPARE(read->size(), std::size_t{1});
      QCOMPARE(read->front().leftOut.front(), std::size_t{4});
      QCOMPARE(read->front().leftOut.size(), std::size_t{2});
    }
    for (const std::string& moving :
         {std::string(kRapidMove), "IF ERRNO=1 THEN " + std::string(kRapidMove), std::string("StartMove;"),
          std::string("n:=home();"), std::string("away;"), std::string("IF home() THEN\nENDIF"),
          "IF ERRNO=ERR_A " + std::string(kRapidMove)})
      QCOMPARE(refusedLine(handled(moving)), std::uint64_t{5});
    QVERIFY(!readBy("rapid", std::string("PROC main()\n") + kRapidMove + "ENDPROC\nTRAP t\n" + kRapidMove + "ENDTRAP\n")
                 .hasValue());
    const auto options = readBy("fanuc", fanuc("", "", " ACC80"));
    QCOMPARE(options->front().leftOut, (std::vector<std::size_t>{4}));
    // A comment within a statement stays beside it.
    const auto within =
        readBy("rapid", std::string("PROC main()\n") + kRapidMove + "SetDO do1, ! grip now\n 1;\nENDPROC\n");
    QVERIFY(within.hasValue());
    QCOMPARE((*within)[0].lines.size(), std::size_t{2});
    QCOMPARE((*within)[0].lines[0].text, std::string("grip now"));
    QVERIFY((*within)[0].lines[1].mayGrip);
  }

  // Statements that change the course of a motion or its frame, by the manuals.
  void changedMotions_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("statement");
    QTest::addColumn<bool>("isRead");
    const auto row = [](const char* post, const char* statement, bool isRead) {
      QTest::addRow("%s", statement) << QByteArray(post) << QByteArray(statement) << isRead;
    };
    for (const char* const each :
         {"SingArea\\Wrist;", "SingArea\\LockAxis4;", "SingArea;", "SoftAct 1,50;", "EOffsSet e;", "EOffsOn;",
          "PDispOn p1,tool0;", "CorrCon id;", "MotionSup\\Off;", "ActUnit a;", "IndAMove a,1\\ToAbsNum:=1,5;"})
      row("rapid", each, false);
    for (const char* const each : {"SingArea\\Off;", "AccSet 50,50;"}) row("rapid", each, true);
    for (const char* const each :
         {"$ORI_TYPE=#JOINT", "$ORI_TYPE=#CONSTANT", "$CIRC_TYPE=#PATH", "$IPO_MODE=#TCP", "$TECH[1].MODE=#CYCLE",
          "$STIFFNESS.STRATEGY=20", "$ACT_TOOL=3", "$ACT_BASE=3", "$ASYNC_AXIS='B0001'", "$TORQUE_AXIS=1",
          "$ROBROOT=$NULLFRAME", "$ORI_TYPE=#VAR #JOINT", "$NEW_NAME=1"})
      row("krl", each, false);
    for (const char* const each : {"$ORI_TYPE=#VAR", "$IPO_MODE=#BASE", "$CIRC_TYPE=#BASE", "$ADVANCE=3", "$OV_PRO=50",
                                   "$ACC.CP=2", "$FLAG[3]=TRUE", "$TIMER[1]=0", "$BWDSTART=FALSE", "$H_POS=XHOME"})
      row("krl", each, true);
    for (const char* const each : {"1: SOFTFLOAT[1] ;", "1: UTOOL[1]=PR[1] ;", "1: P[2]=P[1] ;", "1: GUNFORCE=1 ;"})
      row("fanuc", each, false);
    for (const char* const each : {"1: PAYLOAD[1] ;", "1: OVERRIDE=50% ;"}) row("fanuc", each, true);
    for (const char* const each : {"servoj([0,0,0,0,0,0])", "speedj([0,0,0,0,0,0])", "force_mode(p[0,0,0,0,0,0])",
                                   "track_conveyor_linear(p[1,0,0,0,0,0],1)", "path_offset_enable()"})
      row("urscript", each, false);
    for (const char* const each : {"set_payload(1)", "set_gravity([0,0,9.82])"}) row("urscript", each, true);
  }
  void changedMotions() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, statement);
    QFETCH(const bool, isRead);
    const std::string text = statement.toStdString() + "\n";
    const auto read = post == "rapid"   ? readBy("rapid", text + kRapidMove)
                      : post == "krl"   ? readBy("krl", text + kKrlMove)
                      : post == "fanuc" ? readBy("fanuc", fanuc("", "").insert(8, "/MN\n" + text))
                                        : readBy("urscript", text + kUrMove);
    QCOMPARE(read.hasValue(), isRead);
    if (!read) QVERIFY(read.error().code == PostError::StatementUnread);
  }

  // Bases by numbers are on the controller: axes are the same in any base, and poses are refused.
  void krlBases() {
    const std::string tool = "$TOOL={X 0,Y 0,Z 0,A 0,B 0,C 0}\n", line = "LIN {X 500,Y 100,Z 600,A 0,B 90,C 0}\n";
    for (const char* const base : {"BAS(#BASE,3)", "bas (#base,3)", "BAS(#FRAMES)", "BAS(#EX_BASE,1)", "FDAT_ACT=FP1",
                                   "FDAT_ACT={TOOL_NO 1,BASE_NO 3,IPO_FRAME #BASE}", "$BASE=BASE_DATA[3]"}) {
      const std::string text = std::string(base) + "\n" + tool + kKrlMove;
      QVERIFY2(readBy("krl", text).hasValue(), base);
      QVERIFY2(refusedLine(readBy("krl", text + line)) == 4, base);
      QVERIFY2(readBy("krl", text + "$BASE=$NULLFRAME\n" + line).hasValue(), base);
    }
  }

  // A post that loses or changes a line is found out.
  void writtenLinesAreCompared() {
    const auto read = readBy("urscript", "x = 1\n" + std::string(kUrMove) + "sleep(0.5)\n" + kUrMove);
    QVERIFY(read.hasValue());
    const std::string text = writtenBack("urscript", read);
    QVERIFY(!text.empty());
    const RobotProgram program = programWith(*read, "urscript");
    for (const auto& [from, to] : {std::pair("sleep(0.5)", "sleep(0.6)"), {"sleep(0.5)", ""}, {"x = 1", "x = 2"}}) {
      std::string changed = text;
      changed.replace(changed.find(from), std::string_view(from).size(), to);
      const auto check = checkWritten(*postCalled("urscript"), program, changed);
      QVERIFY(!check.hasValue() && check.error().code == PostError::MotionDiffers);
    }
  }
};

HANDWHEEL_TEST(KeptLinesTest)
#include "KeptLinesTest.moc"
