// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyProgram.h"
#include "TestClass.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"

#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

// The rules of the languages of controllers, word by word.
class PostLanguagesTest : public QObject {
  Q_OBJECT

 private slots:
  void cutNames() {
    QCOMPARE(identifierOf("Process 2", 8), std::string("Proces_2"));
    QCOMPARE(identifierOf("Process 12", 8), std::string("Proce_12"));
    QCOMPARE(identifierOf("weld", 8), std::string("weld"));
    const std::string left = identifierOf("weld seam left", 8), right = identifierOf("weld seam right", 8);
    QVERIFY(left != right);
    QVERIFY(left.size() <= 8 && right.size() <= 8 && left.starts_with("weld"));
    QVERIFY(rc::check("at most so long, a letter first", [] {
      const std::size_t longest = *rc::gen::inRange<std::size_t>(8, 40);
      const std::string name = identifierOf(*rc::gen::arbitrary<std::string>(), longest);
      RC_ASSERT(!name.empty() && name.size() <= longest);
      RC_ASSERT((name[0] >= 'a' && name[0] <= 'z') || (name[0] >= 'A' && name[0] <= 'Z'));
    }));
  }

  // A path may have any name: no program has the name of a word of its language.
  void wordsOfTheLanguageAreNoNames() {
    RobotProgram program = programOf("ur5");
    program.motions.push_back({ProgramMotion::Kind::Joint, ArmValues::Zero(6), 0.5, 0.0, {}});
    const auto begins = [&](const char* post, const char* name, const char* expected) {
      program.name = name;
      const std::string text = postCalled(post)->write(program);
      return text.find(expected) != text.npos;
    };
    QVERIFY(begins("krl", "Loop", "\nDEF Loop_path()\n"));
    QVERIFY(begins("krl", "PTP", "\nDEF PTP_path()\n"));
    QVERIFY(begins("krl", "looping", "\nDEF looping()\n"));
    QVERIFY(begins("urscript", "end", "\ndef end_path():\n") && begins("urscript", "end", "\nend_path()\n"));
    QVERIFY(begins("urscript", "movej", "def movej_path():\n"));
    QVERIFY(begins("urscript", "ending", "def ending():\n"));
    QVERIFY(begins("rapid", "EndProc", "PROC EndProc_path()\n"));
  }

  // The rules of the languages, word by word.
  void rapidText() {
    RobotProgram program = programOf("irb120");
    program.motions.push_back({ProgramMotion::Kind::Joint, ArmValues::Zero(6), 0.5, 0.0, {}});
    program.motions.push_back({ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.1), 0.5, 10.0, {}});
    const std::string text = postCalled("rapid")->write(program);
    QVERIFY(text.starts_with("MODULE weld_seam_1_module\n"));
    QVERIFY(text.ends_with("ENDMODULE\n"));
    QVERIFY(text.find("MoveAbsJ [[0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000],"
                      "[9E9,9E9,9E9,9E9,9E9,9E9]]\\NoEOffs,vmax,fine,weld_seam_1_tool\\WObj:=weld_seam_1_frame;") !=
            text.npos);
    QVERIFY(text.find("[FALSE,10.000,") != text.npos);
    QVERIFY(text.find("VelSet 50.00,5000;") != text.npos);
    QVERIFY(text.find("PROC weld_seam_1()") != text.npos);
    QVERIFY(text.find("! To run it: weld_seam_1;") != text.npos);  // called without parentheses
    QVERIFY(text.find("main") == text.npos);
    QVERIFY(text.find("VelSet 100,5000;\n    ConfL\\On;\n  ENDPROC") != text.npos);
    program.motions.resize(1001, program.motions.back());
    const std::string longer = postCalled("rapid")->write(program);
    QVERIFY(longer.find("    weld_seam_1_2;\n") != text.npos);
    QVERIFY(longer.find("LOCAL PROC weld_seam_1_2()") != text.npos);
    QVERIFY(checkWritten(*postCalled("rapid"), program, longer).hasValue());
  }

  // All global names of two modules in one task are different, in any case of letters, and have 32 characters at most.
  void rapidModulesSideBySide() {
    std::set<std::string> names;
    for (const char* path : {"the seam on the left side of the part, tacked",
                             "the seam on the left side of the part, whole", "Path 1", "path 2", "test"}) {
      RobotProgram program = programOf("irb120");
      program.name = path;
      program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Zero(6), 0.5, 0.0, "start"},
                         {ProgramMotion::Kind::Joint, ArmValues::Zero(6), 0.5, 0.0, "Start"}};
      const std::string written = postCalled("rapid")->write(program);
      int count = 0;
      for (const QString& line : QString::fromStdString(written).split('\n')) {
        static const QRegularExpression kDeclared("^ *(LOCAL )?(?:MODULE|PROC|(?:PERS|CONST) [a-z]+) ([A-Za-z]\\w*)");
        const QRegularExpressionMatch match = kDeclared.match(line);
        if (!match.hasMatch()) continue;
        QVERIFY2(match.captured(2).size() <= 32, qPrintable(line));
        const bool isLocal = !match.captured(1).isEmpty();
        const std::string name = match.captured(2).toLower().toStdString() + (isLocal ? program.name : "");
        QVERIFY2(names.insert(name).second, qPrintable(line));
        ++count;
      }
      QCOMPARE(count, 6);                                    // module, procedure, tool, frame, two waypoints
      QVERIFY(written.find("PROC test()") == written.npos);  // a word of the language
    }
  }

  // Named waypoints are data that can be touched up. A line by a pose is right only if the base is the controller's.
  void rapidTargets() {
    RobotProgram program = programOf("irb120");
    program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.1), 0.5, 0.0, "approach"},
                       {ProgramMotion::Kind::Linear, ArmValues::Constant(6, 0.2), 50.0, 0.0, "seam begin"}};
    const std::string unknown = postCalled("rapid")->write(program);
    QVERIFY(unknown.find("LOCAL CONST jointtarget p_approach:=[[5.7295780,") != unknown.npos);
    QVERIFY(unknown.find("MoveAbsJ p_approach\\NoEOffs,vmax,") != unknown.npos);
    QVERIFY(
        unknown.find("MoveL CalcRobT(p_seam_begin,weld_seam_1_tool\\WObj:=weld_seam_1_frame),[50.00,500,5000,1000],") !=
        unknown.npos);
    const auto read = postCalled("rapid")->read(unknown, program);
    QVERIFY(read.hasValue() && (*read)[1].joints && (*read)[1].kind == ProgramMotion::Kind::Linear);
    program.isBaseOfController = true;
    const std::string known = postCalled("rapid")->write(program);
    QVERIFY(known.find("LOCAL CONST robtarget p_seam_begin:=[[") != known.npos);
    QVERIFY(known.find("MoveL p_seam_begin,[50.00,") != known.npos);
    QVERIFY(known.find("simplified shapes") == known.npos);
    program.hasPlainShapes = true;
    for (const char* post : {"rapid", "krl", "fanuc", "urscript"})
      QVERIFY2(postCalled(post)->write(program).find("simplified shapes") != known.npos, post);
  }

  // S and T by their definition. The wrist is 25 + 455 cos A2 + 420 cos (A2 + A3) + 35 sin (A2 + A3) mm before axis 1:
  // bit 0 of S where that is negative. It is in line with the lower arm for A3 = atan (35 / 420) = 4.76°: bit 1 beyond.
  // Bit 2, and bit i - 1 of T: A5, Ai below 0. "S 2,T 35" and "S 6,T 50" are what taught programs are full of.
  void krlStatus_data() {
    QTest::addColumn<QList<double>>("degrees");
    QTest::addColumn<QByteArray>("status");
    const auto row = [](QList<double> degrees, const char* status) {
      QTest::newRow(status) << std::move(degrees) << QByteArray(status);
    };
    row({0, -90, 90, 0, 30, 0}, "S 'B010',T 'B000010'");           // 445 mm
    row({-20, -80, 100, 0, 45, -30}, "S 'B010',T 'B100011'");      // 511 mm
    row({10, -70, 90, 20, -40, -60}, "S 'B110',T 'B110010'");      // 587 mm
    row({40, -120, 20, 0, 15, 0}, "S 'B011',T 'B000010'");         // -310 mm
    row({-150, -120, -100, 5, -15, 7}, "S 'B101',T 'B010111'");    // -502 mm
    row({0, -45, 4.5, -10, 20, 300}, "S 'B000',T 'B001010'");      // 643 mm
    row({0, -45, 5.0, -10, 20, -300}, "S 'B010',T 'B101010'");     // 646 mm
    row({0, 30, -100, 170, 110, 0}, "S 'B000',T 'B000100'");       // 530 mm
    row({165, -180, -10, -184, -119, 0}, "S 'B101',T 'B011110'");  // -838 mm
  }
  void krlStatus() {
    QFETCH(const QList<double>, degrees);
    QFETCH(const QByteArray, status);
    RobotProgram program = programOf("kr6r900");
    const ArmValues joints = radiansOf(std::span(degrees.data(), static_cast<std::size_t>(degrees.size())));
    program.motions = {{ProgramMotion::Kind::Linear, joints, 50.0, 0.0, {}}};
    std::string text = postCalled("krl")->write(program);
    QVERIFY2(text.find("," + status.toStdString() + "}") != text.npos, text.c_str());
    // A joint motion to the same frame has the configuration of S and T, and no other.
    const auto read = [&](const std::string& bits) {
      std::string ptp = text;
      ptp.replace(ptp.find("LIN {"), 3, "PTP");
      ptp.replace(ptp.find(status.toStdString()), static_cast<std::size_t>(status.size()), bits);
      return postCalled("krl")->read(ptp, program);
    };
    const auto same = read(status.toStdString());
    QVERIFY(same.hasValue());
    QVERIFY((*same)[0].joints && (*(*same)[0].joints - joints).cwiseAbs().maxCoeff() < 1e-5);
    // By S alone whole turns are as near as possible to the last joint values, which are 0.
    const auto byStatus = read(status.left(8).toStdString());
    QVERIFY(byStatus.hasValue());
    const ArmValues near = *(*byStatus)[0].joints;
    QVERIFY(std::abs(near[5]) <= M_PI + 1e-9 && std::abs(std::remainder(near[5] - joints[5], 2.0 * M_PI)) < 1e-5);
    // Without them it is a frame.
    const auto frame = read("E1 0");
    QVERIFY(frame.hasValue() && !(*frame)[0].joints && (*frame)[0].pose);
  }

  // S and T as numbers and in hexadecimal; a combination without a solution of the robot is refused with its line.
  void krlStatusRead() {
    const RobotProgram program = programOf("kr6r900");
    const auto read = [&](const std::string& bits) {
      return postCalled("krl")->read(
          "$TOOL=$NULLFRAME\n$BASE=$NULLFRAME\nPTP {X 525,Y 0,Z 890,A 0,B 120,C 0," + bits + "}", program);
    };
    QVERIFY(read("S 2,T 2").hasValue());
    for (const char* const other : {"S 'H2',T 'H2'", "s 'b010', t 'b000010'", "S 2"}) {
      QVERIFY2(read(other).hasValue(), other);
      QVERIFY((*(*read(other))[0].joints - *(*read("S 2,T 2"))[0].joints).norm() < 1e-12);
    }
    for (const char* const none : {"S 2,T 0", "S 1,T 2", "S 5", "T 'B000001'"}) {
      const auto refused = read(none);
      QVERIFY2(!refused.hasValue(), none);
      QCOMPARE(refused.error().position.value, std::uint64_t{3});
    }
    for (const char* const odd : {"S 'X'", "S -1", "T 'B2'", "S 1e99", "S '"}) (void)read(odd);  // no crash
  }

  // With axis 5 near 0 the turns of the axes 4 and 6 come from the rounding of the file; their sum, here 10 degrees, is
  // known.
  void krlStatusInLine() {
    RobotProgram program = programOf("kr6r900");
    program.tool = program.frame = Pose::Identity();
    const std::vector<double> degrees = {20, -80, 100, 40, 0.0005, -30};
    const ArmValues joints = radiansOf(degrees);
    program.motions = {{ProgramMotion::Kind::Linear, joints, 50.0, 0.0, {}}};
    std::string text = postCalled("krl")->write(program);
    text.replace(text.find("LIN {"), 3, "PTP");
    const std::size_t begin = text.find("S 'B"), end = text.find('}', begin);
    const Pose tip = program.arm.tipPose(joints);
    // T: axis 2 below 0, and of the axes 4 and 6 either, both or none.
    for (const char* const bits : {"000010", "100010", "001010"}) {
      std::string ptp = text;
      ptp.replace(begin, end - begin, "S 'B010',T 'B" + std::string(bits) + "'");
      const auto read = postCalled("krl")->read(ptp, program);
      QVERIFY2(read.hasValue(), bits);
      const ArmValues& values = *(*read)[0].joints;
      QVERIFY((program.arm.tipPose(values).matrix() - tip.matrix()).cwiseAbs().maxCoeff() < 0.05);
      QVERIFY(std::abs(std::remainder(values[3] + values[5] - M_PI / 18.0, 2.0 * M_PI)) < 1e-3);
      for (const int axis : {3, 5}) {
        const bool isBelow = bits[5 - axis] == '1';
        QVERIFY2((isBelow ? -values[axis] : values[axis]) > -2e-4, bits);
      }
    }
  }

  // J3 of the controller is J3 of the model less J2.
  void fanucCoupling() {
    RobotProgram program = programOf("lrmate200id");
    ArmValues joints = ArmValues::Zero(6);
    joints[1] = 10.0 * kRadiansPerDegree;
    joints[2] = 30.0 * kRadiansPerDegree;
    program.motions.push_back({ProgramMotion::Kind::Joint, joints, 0.5, 0.0, {}});
    const std::string text = postCalled("fanuc")->write(program);
    QVERIFY(text.find("J2 = 10.000000 deg, J3 = 20.000000 deg") != text.npos);
    QVERIFY(text.find("LINE_COUNT\t= 7;") != text.npos);  // four remarks, two numbers, a motion
    QVERIFY(text.find("7:J P[1] 50% FINE") != text.npos);
    QVERIFY(text.find("/PROG  WELD_S_1\n") != text.npos);
  }

  // Both values of the third axis have limits: that of the arm, and that of the controller (-140.43 to 280 degrees).
  void fanucLimits() {
    RobotProgram program = programOf("lrmate200id");
    const auto isRefusedAt = [&](double second, double third) {
      ArmValues joints = ArmValues::Zero(6);
      joints[1] = second * kRadiansPerDegree;
      joints[2] = third * kRadiansPerDegree;
      program.motions = {{ProgramMotion::Kind::Joint, joints, 0.5, 0.0, {}}};
      return !postCalled("fanuc")->refusals(program).empty();
    };
    QVERIFY(!isRefusedAt(90, -50));   // -140 from the level
    QVERIFY(isRefusedAt(90, -51));    // -141
    QVERIFY(!isRefusedAt(-80, 200));  // 280
    QVERIFY(isRefusedAt(-81, 200));   // 281
  }

  // The linkage of the IRB 2400 keeps its upper arm level while axis 2 moves: with axis 3 at 0 the flange stays level.
  // By hand for axes 2 and 3 at 30 and 0 degrees: 100 + 705 sin 30 + 755 + 85 ahead, and 615 + 705 cos 30 + 135 above.
  void parallelLinkage() {
    RobotProgram program = programOf("irb2400");
    ArmValues joints = ArmValues::Zero(6);
    joints[1] = 30.0 * kRadiansPerDegree;
    joints[2] = -30.0 * kRadiansPerDegree;
    program.motions = {{ProgramMotion::Kind::Joint, joints, 0.5, 0.0, {}}};
    const Vec3 flange = program.arm.tipPose(joints).translation();
    QVERIFY((flange - Vec3(1292.5, 0.0, 615.0 + 705.0 * std::cos(M_PI / 6.0) + 135.0)).norm() < 1e-9);
    const std::string text = postCalled("rapid")->write(program);
    QVERIFY2(text.find("MoveAbsJ [[0.0000000,30.0000000,0.0000000,") != text.npos, text.c_str());
    const auto read = postCalled("rapid")->read(text, program);
    QVERIFY(read.hasValue() && (*(*read)[0].joints - joints).cwiseAbs().maxCoeff() < 1e-8);
    QVERIFY(postCalled("rapid")->refusals(program).empty());
    // -60 to 65 degrees are of the axis as the controller has it.
    program.motions[0].joints[2] = 36.0 * kRadiansPerDegree;
    QVERIFY(postCalled("rapid")->refusals(program).at(0).code == PostError::ThirdBeyond);
    // A description for ROS has no coupling.
    program.motions[0].joints = joints;
    program.arm = program.arm.withCoupling(std::nullopt);
    program.robot = "abb_irb2400";
    QVERIFY(postCalled("rapid")->refusals(program).at(0).code == PostError::LinkageUnknown);
    for (const char* const serial : {"abb_irb2600", "abb_irb6640", "abb_irb4600", "irb120"}) {
      program.robot = serial;
      QVERIFY(postCalled("rapid")->refusals(program).empty());
    }
  }

  // The world of the LR Mate is 330 mm above its foot: with all joints at 0 the flange is 50 + 335 + 80 mm ahead, and
  // 330 + 35 mm above axis 2 (drawing of B-83494EN/03).
  void fanucWorldFrame() {
    RobotProgram program = programOf("lrmate200id");
    program.tool = program.frame = Pose::Identity();
    program.motions = {{ProgramMotion::Kind::Linear, ArmValues::Zero(6), 50.0, 0.0, "seam"}};
    const std::string text = postCalled("fanuc")->write(program);
    QVERIFY(text.find("X = 465.00000 mm, Y = 0.00000 mm, Z = 365.00000 mm") != text.npos);
    QVERIFY(text.find("L P[1:seam] 50mm/sec FINE") != text.npos);
    QVERIFY(text.find("P[1:\"seam\"]{\n   GP1:\n   UF : 0, UT : 1,") != text.npos);
    for (const char* line : {":  UFRAME_NUM=0 ;", ":  UTOOL_NUM=1 ;", "!X 0.000 Y 0.000 ;"})
      QVERIFY2(text.find(line) != text.npos, line);
    const auto read = postCalled("fanuc")->read(text, program);
    QVERIFY(read.hasValue());
    QVERIFY(((*read)[0].pose->translation() - Vec3(465, 0, 695)).norm() < 1e-4);
  }

  // Zones of neighbours that would overlap are made smaller; the last motion has none.
  void urZonesDoNotOverlap() {
    RobotProgram program = programOf("ur5");
    for (int i = 0; i < 4; ++i) {
      ArmValues joints = ArmValues::Constant(6, 0.5);
      joints[0] = 0.01 * i;
      program.motions.push_back({ProgramMotion::Kind::Joint, joints, 0.5, 100.0, {}});
    }
    const auto read = postCalled("urscript")->read(postCalled("urscript")->write(program), program);
    QVERIFY(read.hasValue());
    QCOMPARE(read->front().blend, 0.0);
    QCOMPARE(read->back().blend, 0.0);
    const auto at = [&](std::size_t i) { return Vec3(program.tipOf(program.motions[i]).translation()); };
    QVERIFY((*read)[1].blend + (*read)[2].blend < (at(2) - at(1)).norm());
    QVERIFY((*read)[1].blend > 0.0);
  }

  // The controller computes the pose from the joints by its own kinematics, for any base of a description.
  void urLinesByJoints() {
    RobotProgram program = programOf("ur5");
    program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.5), 0.5, 0.0, "start"},
                       {ProgramMotion::Kind::Linear, ArmValues::Constant(6, 0.6), 50.0, 0.0, {}}};
    const std::string text = postCalled("urscript")->write(program);
    QVERIFY(text.find("  # start\n  movej([") != text.npos);
    QVERIFY(text.find("  movel([0.600000000,0.600000000,0.600000000,0.600000000,0.600000000,0.600000000],"
                      "a=0.2000000,v=0.0500000,r=0.000000)\nend\n") != text.npos);
    QVERIFY(text.ends_with("\nweld_seam_1()\n"));
    QVERIFY(text.find("set_payload(1.000)") != text.npos);
    QVERIFY(text.find("\n  set_payload") == text.npos);  // in a comment: the load of the installation counts
  }

  // Unproven properties are stated in comments, which move nothing.
  void whatWasNotProven_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("sign");  // sign at the beginning of its comments
    for (const auto& [post, sign] :
         {std::pair("rapid", "!"), std::pair("krl", ";"), std::pair("fanuc", "!"), std::pair("urscript", "#"),
          std::pair("csv", "#"), std::pair("json", "\"remarks\"")})
      QTest::addRow("%s", post) << QByteArray(post) << QByteArray(sign);
  }
  void whatWasNotProven() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, sign);
    RobotProgram program = programOf("lrmate200id");
    program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.1), 0.5, 0.0, {}}};
    program.remarks = {"Outdated: the part a_block_with_a_name_longer_than_pendants_show has moved."};
    const std::string text = postCalled(post.toStdString())->write(program);
    // All of the remark, line by line, for any line breaks in it.
    QString said;
    for (const QString& line : QString::fromStdString(text).split('\n')) {
      const qsizetype at = line.indexOf(sign);
      if (at >= 0) said += line.mid(at + sign.size()).remove(' ').remove(';');
      if (post == "fanuc" && at >= 0) QVERIFY2(line.mid(at).size() <= 25 + 2, qPrintable(line));  // and its end, " ;"
      if (post == "json") said += line.trimmed().remove(' ').remove('"');
    }
    QVERIFY2(said.contains("Outdated:thepart"), text.c_str());
    QVERIFY2(said.contains("a_block_with_a_name_longer_than_pendants_show"), text.c_str());
    const auto check = checkWritten(*postCalled(post.toStdString()), program, text);
    QVERIFY(check.hasValue());
    QCOMPARE(check->motions, std::size_t{1});
  }

  // The clearance that was proven, and where the proof begins, are at the head of programs whose motions are proven.
  void whatWasProven() {
    for (const char* const post : {"rapid", "krl", "fanuc", "urscript"}) {
      RobotProgram program = programOf("lrmate200id");
      program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.1), 0.5, 0.0, {}}};
      const std::string before = postCalled(post)->write(program);
      QVERIFY2(before.find("Clearance") == before.npos, before.c_str());
      program.clearance = 2.5;
      const std::string text = postCalled(post)->write(program);
      QVERIFY2(text.find("Clearance kept: 2.5") != text.npos, text.c_str());
      QVERIFY2(text.find("first") != text.npos && text.find("not checked") != text.npos, text.c_str());
      QVERIFY(!keptClearance(before) && keptClearance(text) == 2.5);
      const auto check = checkWritten(*postCalled(post), program, text);
      QVERIFY(check.hasValue());
      QCOMPARE(check->motions, std::size_t{1});
    }
  }

  // Only a comment of its own defines the clearance, and only with a value that a path can have.
  void whatIsNoProof() {
    for (const char* const text :
         {"", "Clearance kept: 2 mm.", "TPWrite \"! Clearance kept: 2 mm.\";", "! was: Clearance kept: 2 mm.",
          "! Clearance kept: ", "! Clearance kept: -1 mm.", "! Clearance kept: nan mm.", "! Clearance kept: inf mm.",
          "! Clearance kept: 1e9 mm.", "! Clearance kept: 2mm."})
      QVERIFY2(!keptClearance(text), text);
    QVERIFY(keptClearance("! Clearance kept: much\r\n! Clearance kept: 0 mm.\r\n! Clearance kept: 3 mm.") == 0.0);
    QVERIFY(keptClearance("   4:  !Clearance kept: 0.25 ;") == 0.25);
  }

  // Speeds as the manuals of the languages define them.
  void speeds_data() {
    QTest::addColumn<QByteArray>("post");
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("motion");
    QTest::addColumn<double>("speed");  // mm/s, share; 0: none
    QTest::addColumn<double>("toolSpeed");
    const auto row = [](const char* post, const char* before, const char* motion, double speed,
                        double toolSpeed = 0.0) {
      QTest::addRow("%s %s %s", post, before, motion)
          << QByteArray(post) << QByteArray(before) << QByteArray(motion) << speed << toolSpeed;
    };
    row("rapid", "", "MoveL $P,v100,z10,tool0;", 100.0);
    row("rapid", "", "MoveL $P,vmax,z10,tool0;", 0.0);
    row("rapid", "", "MoveL $P,[25,500,5000,1000],fine,tool0;", 25.0);
    row("rapid", "LOCAL CONST speeddata vSeam:=[50,500,5000,1000];", "MoveL $P, VSEAM ,fine,tool0;", 50.0);
    row("rapid", "CONST speeddata v100:=[50,500,5000,1000];", "MoveL $P,v100,fine,tool0;", 50.0);
    row("rapid", "VelSet 50,800;", "MoveL $P,v100,fine,tool0;", 50.0);
    row("rapid", "VelSet nShare,800;", "MoveL $P,v100,fine,tool0;", 0.0);
    row("rapid", "VelSet 50,800;", "MoveL $P,v2000,fine,tool0;", 800.0);
    row("rapid", "", "MoveL $P,v100\\V:=40,fine,tool0;", 40.0);
    row("rapid", "", "MoveL CalcRobT([[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],tool0\\WObj:=wobj0),v20,fine,tool0;",
        20.0);
    row("rapid", "VelSet 40,5000;", "MoveAbsJ $J,vmax,fine,tool0;", 0.4);
    row("rapid", "VelSet 50,5000;", "MoveAbsJ $J\\NoEOffs,v200,fine,tool0;", 0.0, 100.0);
    row("krl", "$VEL.CP=0.05", "LIN $K", 50.0);
    row("krl", "BAS(#VEL_CP,2)", "LIN $K", 2000.0);
    row("krl", "$VEL_AXIS[1]=20", "LIN $K", 0.0);
    row("krl", "BAS(#VEL_PTP,30)", "PTP $A", 0.3);
    row("krl", "$VEL_AXIS[I]=60", "PTP $A", 0.6);
    row("krl", "BAS(#VEL_PTP,30)\n$VEL_AXIS[2]=10", "PTP $A", 0.1);
    row("krl", "$VEL.CP=0.05", "PTP $A", 0.0);
    row("fanuc", "", "1:J P[1] 50% FINE ;", 0.5);
    row("fanuc", "", "1:L P[1:weld] 100mm/sec CNT50 ;", 100.0);
    row("fanuc", "", "1:L P[1] 60cm/min FINE ;", 10.0);
    row("fanuc", "", "1:L P[1] 60.0inch/min FINE ;", 25.4);
    row("fanuc", "", "1:L P[1] 3.0sec FINE ;", 0.0);
    row("fanuc", "", "1:J P[1] 3.0sec FINE ;", 0.0);
    row("urscript", "", "movel(p[0.1,0.2,0.3,0,0,0], a=1.2, v=0.05, r=0.01)", 50.0);
    row("urscript", "", "movel([0,0,0,0,0,0],1.2,0.05)", 50.0);
    row("urscript", "", "movel([0,0,0,0,0,0],a=1.2,v=0.05,t=2)", 0.0);
    row("urscript", "", "movel([0,0,0,0,0,0],1.2,0.05,2)", 0.0);
    row("urscript", "", "movep(p[0.1,0.2,0.3,0,0,0],1.2,0.05,0.01)", 50.0);
    row("urscript", "", "movej([0,0,0,0,0,0],v=1.5707963267948966)", 0.5);  // relative to 180°/s
    row("urscript", "", "movej([0,0,0,0,0,0])", 0.0);
  }
  void speeds() {
    QFETCH(const QByteArray, post);
    QFETCH(const QByteArray, before);
    QFETCH(QByteArray, motion);
    QFETCH(const double, speed);
    QFETCH(const double, toolSpeed);
    motion.replace("$P", "[[300,0,500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    motion.replace("$J", "[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    motion.replace("$K", "{X 300,Y 0,Z 500,A 0,B 90,C 0}");
    motion.replace("$A", "{A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0}");
    QByteArray text = before + "\n" + motion + "\n";
    if (post == "fanuc")
      text = "/MN\n" + text + "/POS\nP[1]{\n GP1:\n UF : 0, UT : 1,\n J1= 0 deg, J2= 0 deg, J3= 0 deg,\n" +
             " J4= 0 deg, J5= 0 deg, J6= 0 deg\n};\n/END\n";
    const auto read = postCalled(post.toStdString())->read(text.toStdString(), programOf("ur5"));
    QVERIFY(read.hasValue());
    QCOMPARE(read->size(), std::size_t{1});
    QCOMPARE((*read)[0].speed.value_or(0.0), speed);
    QCOMPARE((*read)[0].toolSpeed.value_or(0.0), toolSpeed);
  }
};

HANDWHEEL_TEST(PostLanguagesTest)
#include "PostLanguagesTest.moc"
