// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyProgram.h"
#include "TestClass.h"
#include "base/Units.h"
#include "robot/posts/PostErrors.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr const char* kRapidData =
    "CONST robtarget p10:=[[300,0,500],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    "CONST robtarget p20:=[[350,50,500],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    "CONST robtarget p30:=[[400,0,500],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    "CONST robtarget pBack:=[[400,0,500],[0.70710678,0,0,-0.70710678],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]; "
    "CONST robtarget pTurned:=[[400,0,500],[0.70710678,0,0,0.70710678],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    "CONST num height:=50;\nVAR num changing:=50;\n";

std::string rapid(const std::string& statements) {
  return std::string("MODULE m\n") + kRapidData + "PROC main()\nConfL\\Off;\nConfJ\\Off;\n" + statements +
         "\nENDPROC\nENDMODULE\n";
}

std::string fanuc(const std::string& lines) {
  std::string text = "/PROG A\n/ATTR\n/MN\n" + lines + "/POS\n";
  for (const char* const number : {"1", "2", "3"})
    text += std::string("P[") + number +
            "]{\n GP1:\n UF : 0, UT : 1,\n J1= 0 deg, J2= 0 deg, J3= 0 deg,\n J4= 0 deg, J5= 30 deg, J6= 0 deg\n};\n";
  return text + "/END\n";
}

// Returns the pose of the flange at the end of a motion, in the base.
Pose flangeAt(const RobotProgram& program, const ParsedMotion& motion) {
  return motion.joints ? program.arm.tipPose(*motion.joints)
                       : Pose(program.frame * *motion.pose * program.tool.inverse(Eigen::Isometry));
}

std::string textsOf(const std::vector<ProgramLine>& lines) {
  std::string all;
  for (const ProgramLine& line : lines) all += line.text + (line.mayGrip ? "(!)|" : "|");
  return all;
}

struct RapidText {
  bool hasCalculation, hasRemark;
};
RapidText rapidTextOf(const RobotProgram& program) {
  const std::string text = postCalled("rapid")->write(program);
  return {text.find("CalcRobT") != text.npos, text.find("measure it, or test this") != text.npos};
}

}  // namespace

// Tests what statements of controllers mean, by their manuals and by hand calculation.
class ProgramMeaningTest : public QObject {
  Q_OBJECT

 private slots:
  // A speed that is no number of the program is not made up in silence: its line is named.
  void speedsThatAreNoNumbers() {
    const auto leftOut = [](const auto& read) {
      return read && !read->empty() ? read->front().leftOut : std::vector<std::size_t>{0};
    };
    const std::vector<std::size_t> none;
    const auto known = readBy("rapid", rapid("MoveL p10,v100,fine,tool0;"));
    QCOMPARE(leftOut(known), none);
    const auto unknown = readBy("rapid", rapid("MoveL p10,vUnknown,fine,tool0;"));
    QVERIFY(unknown.hasValue());
    QCOMPARE(leftOut(unknown), std::vector<std::size_t>{unknown->front().line});
    QCOMPARE(leftOut(readBy("fanuc", fanuc(" 1:J P[1] 50% FINE ;\n 2:L P[2] R[5]mm/sec FINE ;\n"))).size(),
             std::size_t{1});
    QCOMPARE(leftOut(readBy("fanuc", fanuc(" 1:J P[1] 50% FINE ;\n 2:L P[2] 5mm/sec FINE ;\n"))), none);
    const std::string ur = "movej([0,0,0,0,0,0],a=1,v=1)\nmovel(p[0.3,0.2,0.4,0,0,0],a=1,v=";
    QCOMPARE(leftOut(readBy("urscript", ur + "v_lin)\n")), std::vector<std::size_t>{2});
    QCOMPARE(leftOut(readBy("urscript", ur + "0.1)\n")), none);
    const std::string krl = "DEF p()\n$TOOL=$NULLFRAME\n$BASE=$NULLFRAME\n$VEL.CP=",
                      motion = "\nLIN {X 1,Y 2,Z 3,A 0,B 0,C 0}\nEND\n";
    QCOMPARE(leftOut(readBy("krl", krl + "vv" + motion)), std::vector<std::size_t>{5});
    QCOMPARE(leftOut(readBy("krl", krl + "0.1" + motion)), none);
  }

  // A controller stops where a position has another frame or tool than the selected one (INTP-252, INTP-253).
  void fanucSelections() {
    const std::string move = " 1:J P[1] 50% FINE ;\n";
    QVERIFY(readBy("fanuc", fanuc(" 1:UFRAME_NUM=0 ;\n 1:UTOOL_NUM=1 ;\n" + move)).hasValue());
    QVERIFY(!readBy("fanuc", fanuc(" 1:UFRAME_NUM=3 ;\n" + move)).hasValue());
    QVERIFY(!readBy("fanuc", fanuc(" 1:UTOOL_NUM=2 ;\n" + move)).hasValue());
    QVERIFY(readBy("fanuc", fanuc(" 1:UTOOL_NUM=R[1] ;\n" + move)).hasValue());
  }

  // FINE and CNT0 stop; CNT1 to CNT100 round the corner.
  void fanucRounding() {
    const auto read =
        readBy("fanuc", fanuc(" 1:J P[1] 50% FINE ;\n 2:J P[2] 50% CNT100 ACC80 ;\n 3:J P[3] 9% CNT0 ;\n"));
    QVERIFY(read.hasValue());
    QCOMPARE((*read)[0].corner, 0.0);
    QCOMPARE((*read)[1].corner, 100.0);
    QCOMPARE((*read)[2].corner, 0.0);
    for (const char* const wrong : {"CNT", "CNT R[1]", "CNT101", "CR10mm"})
      QVERIFY2(!readBy("fanuc", fanuc(std::string(" 1:J P[1] 50% ") + wrong + " ;\n")).hasValue(), wrong);
    const RobotProgram program = programWith(*read, "fanuc");
    const std::string text = postCalled("fanuc")->write(program);
    QVERIFY(text.find("P[2] 25% CNT100    ;") != text.npos);
    QVERIFY(text.find("P[3] 25% FINE    ;") != text.npos);
    QVERIFY(checkWritten(*postCalled("fanuc"), program, text).hasValue());
    // Others have no such word: they refuse it, and never stop there without being told to.
    for (const auto& post : posts()) QCOMPARE(post->refusals(program).empty(), post->id() == std::string_view("fanuc"));
    // A larger rounding than the proven one is not written.
    RobotProgram less = program;
    less.motions[1].corner = 50.0;
    QVERIFY(!checkWritten(*postCalled("fanuc"), less, text).hasValue());
  }

  // The duration takes precedence over the speed.
  void durations() {
    const auto read = readBy("rapid", rapid("MoveL p10,v100,fine,tool0;MoveL p20,v100\\T:=10,fine,tool0;\n"
                                            "MoveL p30,v100\\V:=50,fine,tool0;MoveJ p10,v500 \\T:=height,z10,tool0;"));
    QVERIFY(read.hasValue());
    QCOMPARE((*read)[0].seconds, 0.0);
    QCOMPARE((*read)[1].seconds, 10.0);
    QCOMPARE((*read)[2].seconds, 0.0);
    QCOMPARE(*(*read)[2].speed, 50.0);
    QCOMPARE((*read)[3].seconds, 50.0);
    for (const char* const time : {"changing", "0", "-1", "2*3"}) {
      const auto refused = readBy("rapid", rapid(std::string("MoveL p10,v100\\T:=") + time + ",fine,tool0;"));
      QVERIFY2(!refused.hasValue() && refused.error().position.value == 11, time);
    }
    QCOMPARE(readBy("urscript", "movej([0,0,0,0,0,0],a=1,v=1,t=3)")->front().seconds, 3.0);
    QCOMPARE(readBy("urscript", "movel([0,0,0,0,0,0],1.2,0.25,2.5)")->front().seconds, 2.5);
    QVERIFY(!readBy("urscript", "movel([0,0,0,0,0,0],t=when)").hasValue());
    const auto ls = readBy("fanuc", fanuc(" 1:J P[1] 50% FINE ;\n 2:J P[2] 2.5sec FINE ;\n 3:L P[3] 700msec FINE ;\n"));
    QCOMPARE((*ls)[1].seconds, 2.5);
    QCOMPARE((*ls)[2].seconds, 0.7);
    for (const char* const post : {"rapid", "urscript", "fanuc"}) {
      RobotProgram program = programWith(*ls, post);
      program.motions[2].kind = ProgramMotion::Kind::Linear;
      program.motions[2].speed = 100.0;
      const auto again = postCalled(post)->read(postCalled(post)->write(program), program);
      QVERIFY2(again.hasValue(), post);
      QCOMPARE((*again)[1].seconds, 2.5);
      QCOMPARE((*again)[2].seconds, 0.7);
    }
  }

  // Lines stay behind their motion and come back, in the order of the program, in the same language.
  void lines_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("first");
    QTest::addColumn<QByteArray>("second");
    QTest::newRow("rapid") << QByteArray("rapid")
                           << QByteArray(
                                  "MODULE m\n! of the shop\nVAR clock c1;\nCONST jointtarget "
                                  "j:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\nPROC main()\nClkStart c1;\n"
                                  "MoveAbsJ j,v100,fine,tool0; ! approach\nSet doGrip;\nWaitDI diClosed,1\n "
                                  "\\MaxTime:=2; MoveAbsJ j,v100,fine,tool0;\nlast;\nENDPROC\nPROC last()\n "
                                  "TPWrite \"done; !\"; count:=count+1;\nENDPROC\nENDMODULE\n")
                           << QByteArray("of the shop|VAR clock c1|ClkStart c1|")
                           << QByteArray("approach|Set doGrip(!)|WaitDI diClosed,1  \\MaxTime:=2|")
                           << QByteArray("TPWrite \"done; !\"|count:=count+1|");
    QTest::newRow("krl") << QByteArray("krl")
                         << QByteArray(
                                "DEF p()\nDECL INT n\n;of the shop\nBAS(#INITMOV,0)\nn=1\nPTP {A1 0,A2 -90,A3 "
                                "90,A4 0,A5 0,A6 0} ; approach\n$OUT[3]=TRUE\nWAIT FOR $IN[2]\nPTP {A1 0,A2 "
                                "-90,A3 90,A4 0,A5 0,A6 0}\nHALT\nEND\n")
                         << QByteArray("DECL INT n|of the shop|n=1|")
                         << QByteArray("approach|$OUT[3]=TRUE(!)|WAIT FOR $IN[2]|") << QByteArray("HALT|");
    QTest::newRow("fanuc") << QByteArray("fanuc")
                           << QByteArray(fanuc(" 1:  !of the shop ;\n 2:  UTOOL_NUM=1 ;\n 3:  R[1]=5 ;\n 4:J P[1] 50% "
                                               "FINE ;\n 5:  //J P[9] 50% FINE ;\n 6:  DO[1]=ON ;\n 7:  WAIT "
                                               "DI[2]=ON ;\n 8:J P[2] 50% FINE ;\n 9:  !the end ;\n")
                                             .c_str())
                           << QByteArray("of the shop|R[1]=5|")
                           << QByteArray("J P[9] 50% FINE|DO[1]=ON(!)|WAIT DI[2]=ON|") << QByteArray("the end|");
    QTest::newRow("urscript") << QByteArray("urscript")
                              << QByteArray(
                                     "# of the shop\ndef p():\n  q1 = [0,0,0,0,0,0]\n  n = 1\n  movej(q1) # "
                                     "approach\n  set_standard_digital_out(1, True)\n  sleep(0.5)\n  "
                                     "movej([0,0,0,0,0,1])\n  textmsg(\"# done\")\nend\np()\n")
                              << QByteArray("of the shop|q1 = [0,0,0,0,0,0]|n = 1|")
                              << QByteArray("approach|set_standard_digital_out(1, True)(!)|sleep(0.5)|")
                              << QByteArray("textmsg(\"# done\")|");
  }
  void lines() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, before);
    QFETCH(const QByteArray, first);
    QFETCH(const QByteArray, second);
    ReadMotions read = readBy(post.constData(), text.toStdString());
    for (int round = 0; round < 3; ++round) {
      QVERIFY2(read.hasValue(), read ? "" : read.error().arguments.front().c_str());
      QCOMPARE(read->size(), std::size_t{2});
      const auto sorted = [](const std::vector<ProgramLine>& lines, ProgramLine::Kind kind) {
        std::vector<ProgramLine> some;
        std::ranges::copy_if(lines, std::back_inserter(some), [&](const auto& line) { return line.kind == kind; });
        return textsOf(some);
      };
      if (round == 0) QCOMPARE(QByteArray::fromStdString(textsOf((*read)[0].before)), before);
      for (const auto kind : {ProgramLine::Kind::Statement, ProgramLine::Kind::Comment, ProgramLine::Kind::Declaration})
        QCOMPARE(sorted((*read)[0].before, kind),
                 sorted(readBy(post.constData(), text.toStdString())->front().before, kind));
      QVERIFY((*read)[1].before.empty());
      QCOMPARE(QByteArray::fromStdString(textsOf((*read)[0].lines)), first);
      QCOMPARE(QByteArray::fromStdString(textsOf((*read)[1].lines)), second);
      RobotProgram program = programWith(*read, post.constData());
      program.motions[0].name = "start";
      program.clearance = 0.5;
      QVERIFY(postCalled(post.toStdString())->refusals(program).empty());
      const std::string written = postCalled(post.toStdString())->write(program);
      read = readBy(post.constData(), written, program);
      if (read) QCOMPARE((*read)[0].name, std::string("start"));
    }
    // Another language refuses the statements, with the first one and the lines of all; comments alone it takes.
    const ReadMotions again = readBy(post.constData(), text.toStdString());
    RobotProgram program = programWith(*again, post.constData());
    for (const auto& other : posts()) {
      const std::vector<Error> refusals = other->refusals(program);
      if (other->id() == post.toStdString()) continue;
      QVERIFY(refusals.size() == 1 && refusals.front().code == PostError::LinesOfOther);
      QCOMPARE(refusals.front().arguments[2], std::string(postCalled(post.toStdString())->title()));
    }
    const auto isNoComment = [](const ProgramLine& line) { return line.kind != ProgramLine::Kind::Comment; };
    std::erase_if(program.head, isNoComment);
    for (ProgramMotion& motion : program.motions) std::erase_if(motion.lines, isNoComment);
    for (const auto& other : posts()) {
      QVERIFY(other->refusals(program).empty());
      QVERIFY2(other->write(program).find("of the shop") != std::string::npos, other->id());
      QVERIFY2(checkWritten(*other, program, other->write(program)).hasValue(), other->id());
    }
  }

  // Offs moves along the axes of the frame; RelTool along those of the tool, then turns about its x, new y, new z.
  void displacedTargets() {
    const RobotProgram program = programOf("irb120");
    const auto flange = [&](const std::string& target) {
      const auto read = readBy("rapid", rapid("MoveL " + target + ",v100,fine,tool0;"));
      return read ? std::optional<Pose>(flangeAt(program, read->front())) : std::nullopt;
    };
    const auto isAt = [&](const std::string& target, const Vec3& at) {
      const auto pose = flange(target);
      return pose && (pose->translation() - at).norm() < 1e-6;
    };
    QVERIFY(isAt("p10", {300, 0, 500}));
    QVERIFY(isAt("Offs(p10,0,0,50)", {300, 0, 550}));
    QVERIFY(isAt("Offs(p10, 10.5, -height, height)", {310.5, -50, 550}));
    QVERIFY(isAt("Offs(Offs(p10,1,2,3),1,2,3)", {302, 4, 506}));
    // The tool of pTurned is turned by 90° about z: its x is y of the frame.
    QVERIFY(isAt("Offs(pTurned,10,0,0)", {410, 0, 500}));
    QVERIFY(isAt("RelTool(pTurned,10,0,5)", {400, 10, 505}));
    // A turn about x by 90° takes the new y to z; then one about y by 90° takes the tool's z to that y's normal: by
    // Rx(90°) Ry(90°) the tool's z, (0,0,1), becomes Rx(90°)(1,0,0) = (1,0,0).
    const auto turned = flange("RelTool(p10,0,0,0\\Rx:=90\\Ry:=90)");
    QVERIFY(turned && (turned->linear().col(2) - Vec3::UnitX()).norm() < 1e-6);
    const auto alone = flange("RelTool(p10,0,0,0 \\Rz:=90)");
    QVERIFY(alone && (alone->linear().col(0) - Vec3::UnitY()).norm() < 1e-6);
    for (const char* const wrong : {"Offs(p10,0,0,changing)", "Offs(p10,0,0)", "Offs(p10,1,2,3\\Rx:=9)",
                                    "RelTool(p10,0,0,0\\Ra:=9)", "Offs(CRobT(),0,0,1)", "Offs(other,0,0,1)"})
      QVERIFY2(!flange(wrong), wrong);
  }

  // Half a circle of radius 50 mm about (350, 0, 500), from p10 over p20 to p30: every point is 50 mm from the middle,
  // and the lines between leave the circle by 0.01 mm at most.
  void arcs() {
    const RobotProgram program = programOf("irb120");
    const auto read = readBy("rapid", rapid("MoveL p10,v100,fine,tool0;\nMoveC p20,p30,v100\\T:=4,z5,tool0;"));
    QVERIFY2(read.hasValue(), read ? "" : read.error().arguments.back().c_str());
    QVERIFY(read->size() > 20);
    const Vec3 centre(350, 0, 500);
    double seconds = 0.0;
    Vec3 last(300, 0, 500);
    for (std::size_t i = 1; i < read->size(); ++i) {
      const Pose pose = flangeAt(program, (*read)[i]);
      const Vec3 at = pose.translation();
      QVERIFY(std::abs((at - centre).norm() - 50.0) < 1e-6);
      QVERIFY(std::abs(at.z() - 500.0) < 1e-6 && at.y() > -1e-6 && at.x() > last.x());
      QVERIFY(50.0 - (0.5 * (at + last) - centre).norm() <= 0.0101);
      QVERIFY(pose.linear().isIdentity(1e-6));
      QVERIFY((*read)[i].kind == ProgramMotion::Kind::Linear);
      seconds += (*read)[i].seconds;
      last = at;
    }
    QVERIFY((last - Vec3(400, 0, 500)).norm() < 1e-6);
    QVERIFY(std::abs(seconds - 4.0) < 1e-9);
    QCOMPARE(read->back().blend, 5.0);
    // In the middle of the arc the tool has made half of its turn by -90° about z. A turn by 90° is against the arc:
    // relative to the path the shorter turn is the other one, by -270° in all.
    const auto turning = readBy("rapid", rapid("MoveL p10,v100,fine,tool0;\nMoveC p20,pBack,v100,fine,tool0;"));
    QVERIFY(turning.hasValue());
    double nearest = 1e9, angle = 0.0;
    for (const ParsedMotion& each : *turning) {
      const Pose pose = flangeAt(program, each);
      if (std::abs(pose.translation().x() - 350.0) >= nearest) continue;
      nearest = std::abs(pose.translation().x() - 350.0);
      angle = std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)) / kRadiansPerDegree;
    }
    QVERIFY(std::abs(angle + 45.0) < 2.0);
    for (const char* const wrong :
         {"MoveC p20,p30,v100,fine,tool0;", "MoveL p10,v100,fine,tool0;\nMoveC p10,p30,v100,fine,tool0;",
          "MoveL p10,v100,fine,tool0;\nMoveC Offs(p10,50,0,0),p30,v100,fine,tool0;",
          "MoveL p10,v100,fine,tool0;\nMoveC p30,p20,v100,fine,tool0;",
          "MoveL p10,v100,fine,tool0;\nMoveC p20,pTurned,v100,fine,tool0;"})
      QVERIFY2(!readBy("rapid", rapid(wrong)).hasValue(), wrong);
  }

  // In a frame of the cell lines are places in it, also where the base may not be the controller's; a remark says so.
  void frameOfUnknownBase() {
    RobotProgram program = programOf("irb120");
    program.motions.resize(2);
    program.motions[0].joints = ArmValues::Constant(6, 0.3);
    program.motions[1].joints = ArmValues::Constant(6, 0.31);
    program.motions[1].kind = ProgramMotion::Kind::Linear;
    program.motions[1].speed = 50.0;
    const RapidText plain = rapidTextOf(program);
    QVERIFY(plain.hasCalculation && !plain.hasRemark);
    program.frameName = "jig";
    const RapidText inFrame = rapidTextOf(program);
    QVERIFY(!inFrame.hasCalculation && inFrame.hasRemark);
    program.isBaseOfController = true;
    QVERIFY(!rapidTextOf(program).hasRemark);
  }

  void headOfBackups() {
    const auto read = readBy("rapid", "%%%\n  VERSION:1\n  LANGUAGE:ENGLISH\n%%%\n\n" +
                                          rapid("MoveL p10,v100,fine,tool0;\nTriggL p10,v100,t1,fine,tool0;"));
    QVERIFY(!read.hasValue());
    QCOMPARE(read.error().position.value, std::uint64_t{17});
    QVERIFY(readBy("rapid", "%%%\n  VERSION:1\n  LANGUAGE:ENGLISH\n%%%\n\n" + rapid("MoveL p10,v100,fine,tool0;"))
                .hasValue());
  }

  void urVariables() {
    const RobotProgram program = programOf("ur5");
    const std::string head =
        "global q1 = [0.1,0.2,0.3,0.4,0.5,0.6]\np1 = p[0.3,0.1,0.5,0,0,1.5707963267948966]\n"
        "part = p[1,0,0,0,0,0]\n";
    const auto read = readBy("urscript", head + "movej(q1)\nmovel(p1, v=0.1)\nmovel(pose_trans(part, p1))\n", program);
    QVERIFY(read.hasValue());
    QCOMPARE((*read)[0].joints->coeff(5), 0.6);
    const auto at = [&](std::size_t i) { return Pose(program.frame * *(*read)[i].pose); };
    QVERIFY((at(1).translation() - Vec3(300, 100, 500)).norm() < 1e-9);
    QVERIFY((at(1).linear().col(0) - Vec3::UnitY()).norm() < 1e-9);
    QVERIFY((at(2).translation() - Vec3(1300, 100, 500)).norm() < 1e-9);
    QCOMPARE(*(*read)[1].speed, 100.0);
    for (const char* const wrong :
         {"movel(p2)", "movel(p1)\np1 = get_actual_tcp_pose()\nmovel(p1)", "movel(pose_trans(p2,p1))"})
      QVERIFY2(!readBy("urscript", head + wrong, program).hasValue(), wrong);
  }

  // Positions of KUKA's dialogues are in files of data; home is there, in the cell, or unknown.
  void krlData() {
    RobotProgram program = programOf("kr6r900");
    const std::string text = "DEF p()\nBAS(#INITMOV,0)\nPTP XHOME\nPTP XP1\nEND\n";
    QVERIFY(!readBy("krl", text, program).hasValue());
    QCOMPARE(readBy("krl", text, program).error().position.value, std::uint64_t{3});
    program.home = ArmValues::Constant(6, 0.25);
    QCOMPARE(readBy("krl", text, program).error().position.value, std::uint64_t{4});
    program.data = "DEFDAT p\nDECL E6AXIS XP1={A1 10.0,A2 -90.0,A3 90.0,A4 0.0,A5 20.0,A6 0.0,E1 0.0}\nENDDAT\n";
    const auto fromCell = readBy("krl", text, program);
    QVERIFY(fromCell.hasValue());
    QCOMPARE((*fromCell)[0].joints->coeff(0), 0.25);
    QVERIFY(std::abs((*fromCell)[1].joints->coeff(0) - 10.0 * kRadiansPerDegree) < 1e-12);
    // The controller's own value takes precedence.
    program.data += "DEFDAT $CONFIG PUBLIC\nE6AXIS XHOME={A1 5.0,A2 -90.0,A3 90.0,A4 0.0,A5 0.0,A6 0.0}\nENDDAT\n";
    const auto fromData = readBy("krl", text, program);
    QVERIFY(fromData.hasValue());
    QVERIFY(std::abs((*fromData)[0].joints->coeff(0) - 5.0 * kRadiansPerDegree) < 1e-12);
    QCOMPARE((*fromData)[1].name, std::string("XP1"));
    // Two values of one name are none, and one that the program changes is not read.
    program.data += "E6AXIS XP1={A1 1.0,A2 -90.0,A3 90.0,A4 0.0,A5 20.0,A6 0.0}\n";
    QVERIFY(!readBy("krl", text, program).hasValue());
    QVERIFY(!readBy("krl", "DEF p()\nXHOME.A1=9\nPTP XHOME\nEND\n", program).hasValue());
  }
};

HANDWHEEL_TEST(ProgramMeaningTest)
#include "ProgramMeaningTest.moc"
