// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyProgram.h"
#include "TestClass.h"
#include "base/Units.h"
#include "robot/posts/PostErrors.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr const char* kPose = "[[300,0,500],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
constexpr const char* kHome = "CONST jointtarget home:=[[0,10,20,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];";

// Returns the pose of the cell's tool after a motion that was read, in the base.
Pose inBase(const RobotProgram& program, const ParsedMotion& motion) {
  return program.frame * *motion.pose;
}

bool areEqual(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < 1e-9;
}

Pose turnedAt(const Vec3& at, double angle) {
  return Pose(Eigen::Translation3d(at) * Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

}  // namespace

// Tests programs of controllers in the style of people: no statement that may move the robot is skipped.
class ProgramReadersTest : public QObject {
  Q_OBJECT

 private slots:
  void severalStatementsInOneLine() {
    const RobotProgram program = programOf("irb120");
    const std::string text =
        std::string("MODULE m ") + kHome + " PROC main() MoveAbsJ home,v100,fine,tool0; MoveL " + kPose +
        ",\n v100,\n z10,tool0; TPWrite \"MoveL; nothing\"; MoveAbsJ home,vmax,fine,tool0; ENDPROC "
        "ENDMODULE";
    const auto read = postCalled("rapid")->read(text, program);
    QVERIFY(read.hasValue());
    QCOMPARE(read->size(), std::size_t{3});
    QVERIFY((*read)[1].pose && (*read)[1].line == 1 && (*read)[2].line == 3);
    QCOMPARE((*read)[1].blend, 10.0);
    const auto script = postCalled("urscript")
                            ->read("def p(): ; movej([0,0,0,0,0,0]); movel(p[0.3,0,0.5,0,0,0]) ; end\np()\n", program);
    QVERIFY(script.hasValue());
    QCOMPARE(script->size(), std::size_t{2});
  }

  // Procedures in the order of their calls, as often as they are called; those that nobody calls do nothing.
  void calls() {
    const RobotProgram program = programOf("irb120");
    const auto joints = [](int first) {
      return "MoveAbsJ [[" + std::to_string(first) + ",0,0,0,30,0],[9E9]],vmax,fine,tool0;\n";
    };
    const std::string text = "MODULE m\nPROC unused()\n" + joints(9) + "ENDPROC\nLOCAL PROC Second()\n" + joints(2) +
                             "ERROR\n RETRY;\nENDPROC\nFUNC num f(num x)\n RETURN x;\nENDFUNC\nPROC main()\n" +
                             joints(1) + "second;\n" + joints(3) + "SECOND;\nENDPROC\nENDMODULE\n";
    const auto read = postCalled("rapid")->read(text, program);
    QVERIFY(read.hasValue());
    std::vector<int> order;
    for (const ParsedMotion& motion : *read)
      order.push_back(static_cast<int>(std::lround((*motion.joints)[0] / kRadiansPerDegree)));
    QCOMPARE(order, (std::vector<int>{1, 2, 3, 2}));
    const auto script =
        postCalled("urscript")
            ->read(
                "def main():\n def up():\n  movej([0.5,0,0,0,0,0])\n end\n movej([0,0,0,0,0,0])\n up()\n "
                "up()\nend\nmain()\n",
                program);
    QVERIFY(script.hasValue());
    QCOMPARE(script->size(), std::size_t{3});
    QCOMPARE((*script)[2].joints->coeff(0), 0.5);
    // Each calls the next twice: 2^30 motions, or none at all.
    for (const std::string& inside : {joints(0), std::string()}) {
      std::string doubling = "MODULE m\n";
      for (int i = 0; i < 30; ++i) {
        const std::string next = i == 29 ? inside : "p" + std::to_string(i + 1) + ";\n";
        doubling += "PROC p" + std::to_string(i) + "()\n" + next + next + "ENDPROC\n";
      }
      QVERIFY(!postCalled("rapid")->read(doubling + "ENDMODULE\n", program).hasValue());
    }
    // A few calls, each of which has a long text to examine.
    const std::string calculation = "n:=" + std::string(100'000, '1') + ";\n";
    std::string often = "MODULE m\nPROC long()\n" + calculation + "ENDPROC\nPROC main()\n";
    for (int i = 0; i < 10'000; ++i) often += "long;\n";
    QVERIFY(!postCalled("rapid")->read(often + joints(0) + "ENDPROC\nENDMODULE\n", program).hasValue());
  }

  // The pose of a waypoint, by the definition of each language: the frame, then the pose, then back along the tool that
  // the program names and forth along that of the cell.
  void toolsAndFrames() {
    const RobotProgram program = programOf("irb120");
    const Pose pose(Eigen::Translation3d(300, 0, 500));
    const Pose tool = turnedAt({0, 0, 100}, 0.5 * M_PI), user = turnedAt({1000, 0, 0}, 0.5 * M_PI),
               object(Eigen::Translation3d(0, 20, 0));
    const auto led = [&](const Pose& frame, const Pose& used) {
      return Pose(frame * pose * used.inverse(Eigen::Isometry) * program.tool);
    };
    const std::string half = "0.70710678118654752";
    const std::string data = "PERS tooldata grip:=[TRUE,[[0,0,100],[" + half + ",0,0," + half +
                             "]],[1,[0,0,1],[1,0,0,0],0,0,0]];\nPERS wobjdata table:=[FALSE,TRUE,\"\",[[1000,0,0],[" +
                             half + ",0,0," + half + "]],[[0,20,0],[1,0,0,0]]];\n";
    const auto rapid = [&](const std::string& ending) {
      return postCalled("rapid")->read(data + "MoveL " + kPose + ",v100,fine," + ending + ";\n", program);
    };
    QVERIFY(areEqual(inBase(program, rapid("tool0")->front()), led(Pose::Identity(), Pose::Identity())));
    QVERIFY(areEqual(inBase(program, rapid("GRIP")->front()), led(Pose::Identity(), tool)));
    QVERIFY(areEqual(inBase(program, rapid("grip\\WObj:=table")->front()), led(user * object, tool)));
    for (const char* const unknown : {"other", "grip\\WObj:=other", "", "grip\\Corr"})
      QVERIFY(!rapid(unknown).hasValue());

    const auto krl = [&](const std::string& before) {
      return postCalled("krl")->read(before + "\nLIN {X 300,Y 0,Z 500,A 0,B 0,C 0}\n", program);
    };
    QVERIFY(areEqual(inBase(program, krl("")->front()), led(program.frame, program.tool)));
    QVERIFY(areEqual(
        inBase(program, krl("$TOOL={X 0,Y 0,Z 100,A 90,B 0,C 0}\n$BASE={X 1000,Y 0,Z 0,A 90,B 0,C 0}")->front()),
        led(user, tool)));
    QVERIFY(areEqual(inBase(program, krl("$BASE=$NULLFRAME")->front()), led(Pose::Identity(), program.tool)));
    for (const char* const unknown :
         {"$TOOL=TOOL_DATA[2]", "$BASE=BASE_DATA[1]", "BAS(#FRAMES)", "BAS(#TOOL,3)", "FDAT_ACT=FP1",
          "$BASE={X 1,Y 0,Z 0,A 0,B 0,C 0}:OFFS", "$IPO_MODE=#TCP", "$ORI_TYPE=#CONSTANT", "$ROBROOT=$NULLFRAME"})
      QVERIFY2(!krl(unknown).hasValue(), unknown);
    // Axes do not depend on them.
    QVERIFY(postCalled("krl")->read("BAS(#TOOL,3)\nPTP {A1 0,A2 0,A3 0,A4 0,A5 0,A6 0}", program).hasValue());

    const auto script = postCalled("urscript")
                            ->read("set_tcp(p[0,0,0.1,0,0,1.5707963267948966])\nmovel(p[0.3,0,0.5,0,0,0])\n", program);
    QVERIFY(areEqual(inBase(program, script->front()), led(Pose::Identity(), tool)));

    // The world of this arm is 290 mm above its foot, at axis 2 (drawing of the maker: H1 of an IRB 120).
    const auto fanuc = [&](const std::string& frames, const std::string& more = {}) {
      return postCalled("fanuc")->read(
          "/MN\n 1:L P[1] 100mm/sec FINE" + more + " ;\n/POS\nP[1]{\n GP1:\n " + frames +
              ", CONFIG : 'N U T, 0, 0, 0',\n X = 300 mm, Y = 0 mm, Z = 500 mm,\n W = 0 "
              "deg, P = 0 deg, R = 0 deg\n GP2:\n UF : 0, UT : 1,\n J1 = 5 deg\n};\n/END\n",
          program);
    };
    const Pose world(Eigen::Translation3d(0, 0, 290));
    QVERIFY(areEqual(inBase(program, fanuc("UF : 0, UT : 1")->front()), led(world, program.tool)));
    QVERIFY(areEqual(inBase(program, fanuc("UF : 0, UT : 0")->front()), led(world, Pose::Identity())));
    QVERIFY(!fanuc("UF : 2, UT : 1").hasValue());
    for (const char* const option : {" CNT50", " ACC80", " PTH ACC100"})
      QVERIFY2(fanuc("UF : 0, UT : 1", option).hasValue(), option);
    for (const char* const option :
         {" Wjnt", " Offset,PR[1]", " Tool_Offset,PR[2]", " INC", " Skip,LBL[1]", " TB 0.1sec,CALL A"})
      QVERIFY2(!fanuc("UF : 0, UT : 1", option).hasValue(), option);
  }

  void passedOver_data() {
    addColumns();
    for (const char* const each : {"AccSet 50,50;", "SetDO do1,1;", "WaitTime 0.5;", "ConfL\\Off;", "count:=count+1;",
                                   "TPWrite \"a; MoveL b\";", "VAR num count:=0;", "n:=(Abs(x)+1)*Round(y\\Dec:=1);",
                                   "part.n{2}.x:=1;", "WaitUntil (a AND (NOT b));", "TPWrite \"pick()\";"})
      QTest::newRow(each) << QByteArray("rapid") << QByteArray(each);
    for (const char* const each :
         {"INI", "$OUT[3]=TRUE", "WAIT SEC 0.5", "DECL INT I", "FOR I=1 TO 6\n$VEL_AXIS[I]=60\nENDFOR", "COUNT=COUNT+1",
          "$ADVANCE=3", "N=(ABS(A)+1)*2", "INTERRUPT OFF 3",
          "GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )\nINTERRUPT ON 3"})
      QTest::newRow(each) << QByteArray("krl") << QByteArray(each);
    for (const char* const each : {"2:  WAIT   1.00(sec) ;", "2:  DO[1]=ON ;", "2:  R[1]=5 ;", "2:  ! CALL nothing ;",
                                   "2:  UTOOL_NUM=1 ;", "2: ;", "2:  !J P[9] 50% FINE ;"})
      QTest::newRow(each) << QByteArray("fanuc") << QByteArray(each);
    for (const char* const each :
         {"sleep(0.5)", "set_standard_digital_out(1, True)", "x = 5", "global y = [1, 2]", "textmsg(\"movel(\")",
          "set_payload(1.5)", "x = (sin(y) + 1) * 2", "p = get_actual_tcp_pose()"})
      QTest::newRow(each) << QByteArray("urscript") << QByteArray(each);
  }
  void passedOver() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, statement);
    const auto read = postCalled(post.toStdString())->read(withMotion(post, statement), programOf("irb120"));
    QVERIFY(read.hasValue());
    QCOMPARE(read->size(), std::size_t{1});
  }

  // Each with its line.
  void refused_data() {
    addColumns();
    for (const char* const each :
         {"TriggL p1,v100,trig1,z10,tool0;",
          "SearchL di1,sp,p1,v100,tool0;",
          "IF di1=1 THEN",
          "FOR i FROM 1 TO 3 DO",
          "WHILE TRUE DO",
          "GOTO again;",
          "TEST n",
          "other_procedure;",
          "move_it p1;",
          "PDispSet frame1;",
          "home.robax.rax_1:=5;",
          "RETURN;",
          "%\"late\"%;",
          "CallByVar \"p\",1;",
          "IF flag THEN n:=1; MoveAbsJ home,v100,fine,tool0; ELSE n:=2; MoveAbsJ home,v100,fine,tool0; ENDIF n:=3;",
          "WHILE n<5 DO n:=n+1; MoveAbsJ home,v100,fine,tool0; ENDWHILE n:=0;",
          "IF .5<n THEN n:=1;",
          "ok:=pick();",
          "n:=2*Pick (x);",
          "SetDO do1,pick();",
          "WaitUntil pick();",
          "VAR num n:=pick();",
          "MoveAbsJ home,v100,fine,tool0\\WObj:=wobj0,pick();"})
      QTest::newRow(each) << QByteArray("rapid") << QByteArray(each);
    for (const char* const each :
         {"GOTO M1", "SUB1()", "TRIGGER WHEN DISTANCE=0 DELAY=0 DO $OUT[1]=TRUE", "LOOP", "IF $IN[1]==TRUE THEN",
          "IF TRUE THEN\nHALT\nENDIF", "FOR I=1 TO 6\nHALT\nENDFOR", "WHILE A==B", "SWITCH N", "REPEAT", "RETURN",
          "N=GO()", "N=1+GO (2)", "$OUT[1]=GO()", "WAIT FOR GO()", "IF GO() THEN\nENDIF",
          "GLOBAL INTERRUPT DECL 4 WHEN $IN[1]==TRUE DO away()", "INTERRUPT ON 4",
          "INTERRUPT DECL 3 WHEN $IN[1]==TRUE DO IR_STOPM()"})
      QTest::newRow(each) << QByteArray("krl") << QByteArray(each);
    for (const char* const each :
         {"2:  CALL OTHER ;", "2:  IF R[1]=1,JMP LBL[1] ;", "2:  JMP LBL[2] ;", "2:  FOR R[1]=1 TO 3 ;",
          "2:  PR[1]=LPOS ;", "2:  OFFSET CONDITION PR[1] ;", "2:  UFRAME[1]=PR[1] ;", "2:  SELECT R[1]=1,CALL A ;",
          "2:J P[1:go!] 50% FINE Offset,PR[1] ;", "2:  R[1]=5 ! ; CALL A ;", "2:  WAIT DI[1]=ON TIMEOUT,LBL[2] ;",
          "2:  WAIT DI[1]=ON Timeout, LBL[2] ;"})
      QTest::newRow(each) << QByteArray("fanuc") << QByteArray(each);
    for (const char* const each :
         {"if x == 1:", "while True:", "for i in [1,2]:", "force_mode(p[0,0,0,0,0,0])", "other()",
          "thread t():", "halt", "return 1", "freedrive_mode()", "ok = pick()", "global ok = 1 + pick ()",
          "sleep(pick())", "movej([0,0,0,0,0,0],a=pick())", "movel([0,0,0,0,0,0],\n a=1.2, r=0.05)"})
      QTest::newRow(each) << QByteArray("urscript") << QByteArray(each);
  }
  void refused() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, statement);
    const auto read = postCalled(post.toStdString())->read(withMotion(post, statement), programOf("irb120"));
    QVERIFY(!read.hasValue());
    QVERIFY(read.error().code == PostError::StatementUnread);
    QCOMPARE(read.error().position.value, std::uint64_t{2});
  }

  // Zones by the manuals of the languages, in mm; below 0: refused with its line, as an exact stop would be a guess.
  void zones_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("text");  // with a motion in its second line, the first one
    QTest::addColumn<double>("zone");
    const auto rapid = [](const char* zone, double size, const char* data = "") {
      QTest::addRow("rapid %s %s", zone, data)
          << QByteArray("rapid") << QByteArray(kHome) + data + "\nMoveAbsJ home,v100," + zone + ",tool0;" << size;
    };
    rapid("fine", 0.0);
    rapid("z0", 0.3);
    rapid("Z10", 10.0);
    rapid("z200", 200.0);
    rapid("[FALSE,80,120,120,12,120,12]", 80.0);
    rapid("[TRUE,0,0,0,0,0,0]", 0.0);
    rapid("z10\\Z:=8", 8.0);
    constexpr const char* kBig = "CONST zonedata big:=[FALSE,80,120,120,12,120,12];";
    rapid("big", 80.0, kBig);
    rapid("BIG", 80.0, kBig);
    rapid("z10", 80.0, "PERS zonedata z10:=[FALSE,80,120,120,12,120,12];");
    rapid("stop", 0.0, "LOCAL CONST zonedata stop:=[TRUE,0,0,0,0,0,0];");
    rapid("big", -1.0);
    rapid("z11", -1.0);
    rapid("z10+5", -1.0);
    rapid("fine\\Inpos:=inpos50", -1.0);
    rapid("big", -1.0, "CONST zonedata big:=other;");
    rapid("big", -1.0, "CONST zonedata big:=[FALSE,2*size,1,1,1,1,1];");
    rapid("big", -1.0, "CONST zonedata big:=[FALSE,8,1,1,1,1,1]; CONST zonedata big:=[FALSE,9,1,1,1,1,1];");
    const auto script = [](const char* motion, double size) {
      QTest::addRow("%s", motion) << QByteArray("urscript") << QByteArray("\n") + motion << size;
    };
    script("movej([0,0,0,0,0,0])", 0.0);
    script("movej([0,0,0,0,0,0],1.2,0.5,0,0.05)", 50.0);
    script("movej([0,0,0,0,0,0],1.2,0.5,0,r=0.05)", 50.0);
    script("movel(p[0.3,0,0.5,0,0,0], a=1.2, r=0.05, v=0.5)", 50.0);
    script("movep(p[0.3,0,0.5,0,0,0], 1.2, 0.5, 0.05)", 50.0);
    script("movej([0,0,0,0,0,0],1.2,0.5,0)", 0.0);
    script("movej([0,0,0,0,0,0],r=zone)", -1.0);
    script("movej([0,0,0,0,0,0],1.2,0.5,0,zone)", -1.0);
    script("movej([0,0,0,0,0,0],r=0.05*2)", -1.0);
    script("movej([0,0,0,0,0,0],r=-0.05)", -1.0);
    const auto krl = [](const char* before, const char* motion, double size) {
      QTest::addRow("%s %s", before, motion) << QByteArray("krl") << QByteArray(before) + "\n" + motion << size;
    };
    constexpr const char* kLine = "LIN {X 300,Y 0,Z 500,A 0,B 0,C 0}";
    constexpr const char* kRounded = "LIN {X 300,Y 0,Z 500,A 0,B 0,C 0} C_DIS";
    krl("$APO.CDIS=5", kLine, 0.0);
    krl("$APO.CDIS=5", kRounded, 5.0);
    krl("$APO.CPTP=50", kLine, 0.0);
    for (const char* const before : {"", "$APO.CDIS=SIZE", "$APO.CDIS=2*3", "$APO.CDIS=-5", "BAS(#CP_PARAMS,0.1)"})
      krl(before, kRounded, -1.0);
    krl("$APO.CDIS=5", "PTP {A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0} C_PTP", -1.0);
    krl("$APO.CDIS=5", "PTP {X 300,Y 0,Z 500,A 0,B 0,C 0} C_DIS", -1.0);
    krl("$APO.CDIS=5", "LIN {X 300,Y 0,Z 500,A 0,B 0,C 0} C_VEL", -1.0);
    krl("$APO.CDIS=5", "LIN {X 300,Y 0,Z 500,A 0,B 0,C 0} C_DIS C_ORI", -1.0);
  }
  void zones() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, text);
    QFETCH(const double, zone);
    const auto read = postCalled(post.toStdString())->read(text.toStdString(), programOf("irb120"));
    QCOMPARE(read.hasValue(), zone >= 0.0);
    if (read) {
      QCOMPARE(read->size(), std::size_t{1});
      QCOMPARE((*read)[0].blend, zone);
    } else {
      QVERIFY(read.error().code == PostError::StatementUnread);
      QCOMPARE(read.error().position.value, std::uint64_t{2});
    }
  }

  // The zone in effect may differ from the one that was set first: a branch or the controller may have set another.
  void zonesThatMayChange() {
    for (const char* const between : {"IF $IN[1] THEN\n$APO.CDIS=50\nENDIF", "$APO={CDIS 50.0}", "BAS(#INITMOV,0)"}) {
      const std::string text = std::string("$APO.CDIS=5\n") + between + "\nLIN {X 300,Y 0,Z 500,A 0,B 0,C 0} C_DIS\n";
      QVERIFY2(!postCalled("krl")->read(text, programOf("irb120")).hasValue(), between);
    }
    const std::string assigned = std::string(kHome) +
                                 "PERS zonedata big:=[FALSE,80,120,120,12,120,12];\nbig.pzone_tcp:=200;\n"
                                 "MoveAbsJ home,v100,big,tool0;";
    QVERIFY(!postCalled("rapid")->read(assigned, programOf("irb120")).hasValue());
  }

 private:
  static void addColumns() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("statement");
  }

  // The statement in the second line, a motion in the third.
  static std::string withMotion(const QByteArray& post, const QByteArray& statement) {
    const std::string text = statement.toStdString();
    if (post == "rapid") return kHome + ("\n" + text) + "\nMoveAbsJ home,vmax,fine,tool0;\n";
    if (post == "krl") return "DEF p()\n" + text + "\nPTP {A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0}\nEND\n";
    if (post == "fanuc")
      return "/MN\n" + text +
             "\n 3:J P[1] 50% FINE ;\n/POS\nP[1]{\n GP1:\n UF : 0, UT : 1,\n J1= 0 deg, J2= 0 deg, J3= 0 deg,\n J4= 0 "
             "deg, J5= 0 deg, J6= 0 deg\n};\n/END\n";
    return "# a program\n" + text + "\nmovej([0,0,0,0,0,0])\n";
  }
};

HANDWHEEL_TEST(ProgramReadersTest)
#include "ProgramReadersTest.moc"
