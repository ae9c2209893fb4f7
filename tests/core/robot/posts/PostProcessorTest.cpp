// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyProgram.h"
#include "TestClass.h"
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// Programs of controllers: what is written is read back as the same motions.
class PostProcessorTest : public QObject {
  Q_OBJECT

 private slots:
  void writtenAndRead_data() {
    QTest::addColumn<QByteArray>("robot");
    for (const char* id : {"irb120", "irb2400", "kr6r900", "lrmate200id", "ur5", "puma560"})
      QTest::newRow(id) << QByteArray(id);
  }
  void writtenAndRead() {
    QFETCH(const QByteArray, robot);
    for (const auto& post : posts()) {
      QVERIFY(rc::check(post->title(), [&] { checkAnyProgram(*post, robot.constData()); }));
    }
  }

  // Turns by exactly 0°, 90° and 180° about every axis and between: where quaternions and Euler angles go wrong.
  void specialTurns() {
    for (const auto& post : posts()) {
      for (const double angle : {0.0, 0.5 * M_PI, M_PI, -0.5 * M_PI}) {
        for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, -1, 0), Vec3(1, -2, 3)}) {
          RobotProgram program = programOf("irb120");
          program.frame = Pose::Identity();
          ProgramMotion motion;
          motion.kind = ProgramMotion::Kind::Linear;
          motion.speed = 100.0;
          motion.joints = ArmValues::Zero(6);
          // The tool turns the flange to the very orientation.
          program.tool = Pose::Identity();
          program.tool.linear() = program.arm.tipPose(motion.joints).linear().transpose() *
                                  Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
          program.motions = {motion};
          const auto check = checkWritten(*post, program, post->write(program));
          QVERIFY2(check.hasValue(), post->id());
          QVERIFY2(check->distance <= 1e-3 && check->angle <= 1e-3, post->id());
        }
      }
    }
  }

  // By the definition of each: turns about fixed x, y, z are turns about moving z, y, x.
  void eulerAngles() {
    QVERIFY(rc::check("there and back", [] {
      const Vec3 angles(anyNumber(-3.1, 3.1), anyNumber(-1.5, 1.5), anyNumber(-3.1, 3.1));
      RC_ASSERT((zyxAngles(fromZyx(angles)) - angles).norm() < 1e-9);
    }));
  }

  // A program that differs from the path is not written: a faster line, a wider zone. A narrower one is right.
  void differences() {
    RobotProgram program = programOf("irb120");
    program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Zero(6), 0.5, 0.0, {}},
                       {ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.1), 0.5, 10.0, {}},
                       {ProgramMotion::Kind::Linear, ArmValues::Constant(6, 0.2), 50.0, 0.0, {}}};
    const PostProcessor& rapid = *postCalled("rapid");
    const QString text = QString::fromStdString(rapid.write(program));
    const auto changed = [&](const char* from, const char* to) {
      QString other = text;
      if (!other.contains(from)) qFatal("the text has changed: %s", from);
      return checkWritten(rapid, program, other.replace(from, to).toStdString());
    };
    QVERIFY(changed("fine", "fine").hasValue());
    QVERIFY(changed("[FALSE,10.000,", "[FALSE,5.000,").hasValue());
    for (const auto& [from, to] :
         {std::pair("[50.00,500", "[250.00,500"), std::pair("[50.00,500", "[5.00,500"),
          std::pair("VelSet 50.00", "VelSet 100.00"), std::pair("[FALSE,10.000,", "[FALSE,20.000,"),
          std::pair("MoveL CalcRobT", "MoveJ CalcRobT")}) {
      const auto check = changed(from, to);
      QVERIFY2(!check.hasValue() && check.error().code == PostError::MotionDiffers, to);
    }
  }

  // Programs in the style of people.
  void programsByHand() {
    const RobotProgram program = programOf("irb120");
    const auto rapid = postCalled("rapid")->read(
        "MODULE m\n CONST jointtarget home:=[[0,10,20,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        " LOCAL CONST robtarget p10 := [[300,0,500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        " PROC main()\n  MoveAbsJ home,v100,fine,tool0; ! MoveL nothing\n  movel p10, v100, z10, tool0\\WObj:=wobj0;\n"
        " ENDPROC\nENDMODULE\n",
        program);
    QVERIFY(rapid.hasValue());
    QCOMPARE(rapid->size(), std::size_t{2});
    QVERIFY(std::abs((*rapid)[0].joints->coeff(2) - 20.0 * kRadiansPerDegree) < 1e-12);
    QCOMPARE((*rapid)[1].blend, 10.0);
    // tool0 is the flange, wobj0 the base.
    const Pose flange = program.frame * *(*rapid)[1].pose * program.tool.inverse(Eigen::Isometry);
    QVERIFY((flange.translation() - Vec3(300, 0, 500)).norm() < 1e-9);
    const auto script = postCalled("urscript")
                            ->read(
                                "def p():\n  movej([0, -1.57, 1.57, 0, 0, 0], a=1.2, v=0.25)\n  movel(p[0.3, 0.1, 0.2, "
                                "0, 3.14, 0], r=0.01)\nend\n",
                                programOf("ur5"));
    QVERIFY(script.hasValue());
    QCOMPARE(script->size(), std::size_t{2});
    QVERIFY(std::abs((*script)[1].blend - 10.0) < 1e-9);
  }

  void hostileTexts_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("code");
    const auto row = [](const char* post, const char* text, const char* code) {
      QTest::newRow(text) << QByteArray(post) << QByteArray(text) << QByteArray(code);
    };
    row("rapid", "MoveAbsJ home,v100,fine,tool0;", "ElementMalformed");
    row("rapid", "MoveL Offs(p10,0,0,10),v100,fine,tool0;", "ElementMalformed");
    row("rapid", "MoveL [[1,2,3],[0,0,0,0],[0,0,0,0],[9E9]],v100,fine,tool0;", "ElementMalformed");
    row("rapid", "MoveL [[1,2,3],[1,0", "ElementMalformed");
    row("rapid", "MoveC p1,p2,v100,fine,tool0;", "ElementMalformed");
    row("rapid", "MoveAbsJ [[1e999,0,0,0,0,0],[9E9]],v1,fine,t;", "ElementMalformed");
    row("krl", "PTP {A1 0,A2 0}", "ElementMalformed");
    row("krl", "PTP HOME", "ElementMalformed");
    row("krl", "CIRC {X 0},{X 1}", "PostStatementUnread");
    row("krl", "LIN {X 1,Y 2,Z 3,A 0,B 0", "ElementMalformed");
    row("fanuc", "/MN\n 1:J P[1] 10% FINE ;\n/POS\n/END", "ElementMalformed");
    row("fanuc", "/MN\n 1:J P[99999999999] 10% FINE ;", "ElementMalformed");
    row("fanuc", "/MN\n 1:C P[1] ;", "PostStatementUnread");
    row("fanuc", "/MN\n1:L P[1] 9mm/sec FINE;\n/POS\nP[1]{\nUF : 1,\nX = 1, Y = 1, Z = 1, W = 0, P = 0, R = 0\n};",
        "PostDataElsewhere");
    row("rapid", "MoveL CalcRobT(home,tool0),v100,fine,tool0;", "ElementMalformed");
    row("urscript", "movej([0,0,0])", "ElementMalformed");
    row("urscript", "movej(get_inverse_kin(p))", "ElementMalformed");
    row("urscript", "movec(p[0,0,0,0,0,0],p[0,0,0,0,0,0])", "PostStatementUnread");
    row("csv", "motion\n1,a,joint,1,0,1,2\n", "ElementMalformed");
    row("csv", "motion\nnot,a,number\n", "ElementMalformed");
    row("csv", "motion\n1,a,round,1,0,1,2\n", "ElementMalformed");
    row("rapid", "CONST jointtarget p1;", "ElementMalformed");
    row("rapid", "CONST robtarget p1:=p2;", "ElementMalformed");
    row("rapid", "MoveL CalcRobT[1],v100,fine,tool0;", "ElementMalformed");
    row("json", "{}", "ElementMalformed");
    row("json", R"({"motions": [{"q": [1]}]})", "ElementMalformed");
  }
  void hostileTexts() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, code);
    const auto read = postCalled(post.toStdString())->read(text.toStdString(), programOf("irb120"));
    QVERIFY(!read.hasValue());
    QCOMPARE(QByteArray(read.error().code->id), code);
  }

  void refusals() {
    RobotProgram program = programOf("irb120");
    program.motions.push_back({ProgramMotion::Kind::Joint, ArmValues::Constant(6, std::nan("")), 0.5, 0.0, {}});
    for (const auto& post : posts()) QVERIFY(!post->refusals(program).empty());
    // Four joints, one of them a slide.
    std::vector<DhRow> rows(4);
    rows[2].isPrismatic = true;
    program.arm = armOf(rows);
    program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Constant(4, 0.5), 0.5, 0.0, {}}};
    for (const auto& post : posts()) {
      const bool isTable = std::string(post->id()) == "csv" || std::string(post->id()) == "json";
      QCOMPARE(post->refusals(program).empty(), isTable);
      if (!isTable) continue;
      const auto check = checkWritten(*post, program, post->write(program));
      QVERIFY(check && check->distance < 1e-6);
    }
  }

  void programsTooLong() {
    RobotProgram program = programOf("irb120");
    const ProgramMotion motion{ProgramMotion::Kind::Joint, ArmValues::Zero(6), 0.5, 0.0, {}};
    program.motions.assign(PostProcessor::kMostMotions, motion);
    const std::string text(PostProcessor::kLargestText + 1, '\n');
    for (const auto& post : posts()) QVERIFY2(post->refusals(program).empty(), post->id());
    program.motions.push_back(motion);
    for (const auto& post : posts()) {
      const std::vector<Error> refusals = post->refusals(program);
      QVERIFY(refusals.size() == 1 && refusals[0].code == PostError::TooManyMotions);
      QCOMPARE(refusals[0].arguments, (std::vector<std::string>{"100001", "100000"}));
      QVERIFY2(post->read(text, program).error().code == ErrorCode::FileTooLarge, post->id());
    }
  }

  // The largest number of motions of a program, of an arm of eight joints, with long names, is read again in the format
  // that takes most room.
  void aLongProgramOfEightJointsCanBeRead() {
    RobotProgram program = programOf("irb120");
    program.arm = armOf(std::vector<DhRow>(8, {.a = 100.0, .alpha = 0.5, .lower = -3.0, .upper = 3.0}));
    constexpr std::size_t kMeasured = 100;
    program.motions.assign(kMeasured, {ProgramMotion::Kind::Linear, ArmValues::Constant(8, -1.0 / 7.0), 1000.0 / 7.0,
                                       10.0 / 7.0, std::string(100, 'n')});
    const std::string text = postCalled("json")->write(program);
    const std::string largest = text + std::string(text.size() * (PostProcessor::kMostMotions / kMeasured - 1), ' ');
    const auto read = postCalled("json")->read(largest, program);
    QVERIFY2(read && read->size() == kMeasured, QByteArray::number(quint64(largest.size())));
  }

  // A line that is faster than the controller allows; joint motions are shares, and always below.
  void linesTooFast() {
    RobotProgram program = programOf("irb120");
    for (const auto& [id, most] : {std::pair("rapid", 7000.0), std::pair("krl", 3000.0), std::pair("fanuc", 2000.0),
                                   std::pair("urscript", 5000.0)}) {
      const PostProcessor& post = *postCalled(id);
      program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Zero(6), 1.0, 0.0, {}},
                         {ProgramMotion::Kind::Linear, ArmValues::Constant(6, 0.1), most, 0.0, {}}};
      QVERIFY(post.refusals(program).empty());
      QVERIFY(checkWritten(post, program, post.write(program)).hasValue());
      program.motions[1].speed = most + 1.0;
      const std::vector<Error> refusals = post.refusals(program);
      QCOMPARE(refusals.size(), std::size_t{1});
      QVERIFY(refusals[0].code == PostError::TooFast);
      QCOMPARE(refusals[0].arguments[0], std::string("2"));
    }
    QVERIFY(postCalled("csv")->refusals(program).empty());
  }

  // Facts of the drawings: with all joints at 0 an IRB 120 looks ahead; turned over at the shoulder it is behind.
  void controllerConfigurations() {
    const SerialArm arm = armCalled("irb120");
    ArmValues values = ArmValues::Zero(6);
    values[4] = 0.5;
    QVERIFY(!controllerConfigurationOf(arm, values).isRear && !controllerConfigurationOf(arm, values).isElbowDown &&
            !controllerConfigurationOf(arm, values).isFlipped);
    values[4] = -0.5;
    QVERIFY(controllerConfigurationOf(arm, values).isFlipped);
    values[1] = -1.8;  // the lower arm leans back beyond the horizontal
    QVERIFY(controllerConfigurationOf(arm, values).isRear);
  }
};

HANDWHEEL_TEST(PostProcessorTest)
#include "PostProcessorTest.moc"
