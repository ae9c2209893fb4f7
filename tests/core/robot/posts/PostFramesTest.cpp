// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyProgram.h"
#include "TestClass.h"
#include "base/Units.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns motions that end in a line, in a named frame.
RobotProgram framedProgram(const char* robot) {
  RobotProgram program = programOf(robot);
  program.isBaseOfController = true;
  program.frameName = "fixture 1";
  program.motions = {{ProgramMotion::Kind::Joint, ArmValues::Constant(6, 0.5), 0.5, 0.0, {}},
                     {ProgramMotion::Kind::Linear, ArmValues::Constant(6, 0.6), 50.0, 0.0, {}}};
  return program;
}

std::string replacedOnce(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == text.npos) qFatal("not found: %s", what.c_str());
  return text.replace(at, what.size(), by);
}

Result<std::vector<ParsedMotion>> readAs(const char* post, const std::string& text) {
  return postCalled(post)->read(text, programOf("lrmate200id"));
}

}  // namespace

// Frames of a cell in the languages of controllers: written, read back, and compared.
class PostFramesTest : public QObject {
  Q_OBJECT

 private slots:
  void languages_data() {
    QTest::addColumn<QByteArray>("post");
    for (const char* post : {"rapid", "krl", "fanuc", "urscript", "csv", "json"})
      QTest::newRow(post) << QByteArray(post);
  }

  // Joint values are in no frame: the frame of positions is mentioned only if there are lines.
  void saidOfLinesOnly() {
    for (const char* post : {"rapid", "krl", "urscript"}) {
      RobotProgram program = framedProgram("irb120");
      QVERIFY(postCalled(post)->write(program).find("Places are in the frame") != std::string::npos);
      program.motions.pop_back();
      QVERIFY(postCalled(post)->write(program).find("Places are in the frame") == std::string::npos);
    }
  }

  // The line is read with the frame that it is in.
  void languages() {
    QFETCH(const QByteArray, post);
    const PostProcessor& language = *postCalled(post.toStdString());
    QVERIFY(rc::check("any frame", [&] {
      RobotProgram program = framedProgram("irb120");
      program.frame = Pose(Eigen::Translation3d(anyNumber(-2000, 2000), anyNumber(-2000, 2000), anyNumber(-900, 900)) *
                           Eigen::AngleAxisd(anyNumber(-3.1, 3.1), Vec3(1.0, anyNumber(-1, 1), 0.3).normalized()));
      const std::string text = language.write(program);
      RC_ASSERT(text.find("fixture") != text.npos);
      const auto read = language.read(text, program);
      RC_ASSERT(read.hasValue() && read->size() == 2u && (*read)[1].frame);
      RC_ASSERT(((*read)[1].frame->matrix() - program.frame.matrix()).cwiseAbs().maxCoeff() < 1e-4);
      const auto check = checkWritten(language, program, text);
      RC_ASSERT(check.hasValue() && check->distance <= 1e-3 && check->angle <= 1e-3);
    }));
  }

  // Correct positions in a wrong frame: shifted by 1 mm, and turned by 1°.
  void otherFrames_data() { languages_data(); }
  void otherFrames() {
    QFETCH(const QByteArray, post);
    const PostProcessor& language = *postCalled(post.toStdString());
    const RobotProgram program = framedProgram("irb120");
    RobotProgram beside = program, turned = program;
    beside.frame.translation().y() += 1.0;
    turned.frame = program.frame * Eigen::AngleAxisd(1.0 * kRadiansPerDegree, Vec3::UnitX());
    const auto shift = checkWritten(language, program, language.write(beside));
    QVERIFY(shift.hasValue() && shift->distance > 0.999);
    const auto turn = checkWritten(language, program, language.write(turned));
    QVERIFY(turn.hasValue() && turn->angle > 0.999);
  }

  // One frame, one name: that of the cell, for any path; a legal one, and no other frame's.
  void nameOfTheFrame() {
    const auto nameIn = [](RobotProgram program, const char* frame, std::vector<std::string> others = {}) {
      program.frameName = frame;
      program.otherFrames = std::move(others);
      const std::string text = postCalled("rapid")->write(program);
      const std::string before = "  PERS wobjdata ";
      const std::size_t begin = text.find(before) + before.size();
      const std::string name = text.substr(begin, text.find(":=", begin) - begin);
      return text.find("\\WObj:=" + name + ";") != text.npos ? name : std::string();
    };
    RobotProgram program = framedProgram("irb120"), other = program;
    other.name = "another path";
    QCOMPARE(nameIn(program, "fixture 1"), std::string("fixture_1"));
    QCOMPARE(nameIn(other, "fixture 1"), std::string("fixture_1"));
    QCOMPARE(nameIn(program, "9"), std::string("P9"));
    QCOMPARE(nameIn(program, ""), std::string("weld_seam_1_frame"));
    QCOMPARE(nameIn(program, "fixture 1", {"fixture 2"}), std::string("fixture_1"));
    const std::string first = nameIn(program, "fixture 1", {"Fixture_1"});
    const std::string second = nameIn(program, "Fixture_1", {"fixture 1"});
    QVERIFY(first.starts_with("fixture_1_") && second.starts_with("Fixture_1_"));
    QVERIFY(first.substr(10) != second.substr(10));
    // Words, data of every controller, and what the module has itself.
    for (const char* taken : {"main", "EndProc", "wobj0", "tool0", "fine", "z10", "v100", "weld seam 1",
                              "weld seam 1 tool", "weld_seam_1_module", "p_begin"}) {
      const std::string name = nameIn(program, taken);
      QVERIFY2(!name.empty() && name != identifierOf(taken, 60), taken);
    }
    // The procedure of another path has its name, so the frame has another one in the modules of both.
    RobotProgram besidePath = program, ofPath = program;
    besidePath.otherPaths = {"fixture 1"};
    ofPath.name = "fixture 1";
    QCOMPARE(nameIn(besidePath, "fixture 1"), std::string("wobj_fixture_1"));
    QCOMPARE(nameIn(ofPath, "fixture 1"), std::string("wobj_fixture_1"));
    QCOMPARE(nameIn(program, "wobj_tool0", {"tool0"}), std::string("wobj_tool0"));
    QCOMPARE(nameIn(program, "tool0", {"wobj_tool0"}), std::string("wobj_tool0_2"));
    QCOMPARE(nameIn(program, "tool0", {"wobj_tool0", "wobj tool0 2"}), std::string("wobj_tool0_3"));
    const std::string longest(200, 'x');
    QVERIFY(!nameIn(program, longest.c_str()).empty() && nameIn(program, longest.c_str()).size() <= 32);
    QVERIFY(nameIn(program, longest.c_str(), {std::string(201, 'x')}).size() <= 32);
    QVERIFY(postCalled("krl")->write(program).find("\n; $BASE is the frame fixture_1\n$BASE={X ") != std::string::npos);
    QVERIFY(postCalled("krl")->write(programOf("irb120")).find("is the frame") == std::string::npos);
  }

  // Two modules of one task must not both declare the frame: one names it only, and is read with that of the cell.
  void declaredElsewhere() {
    const PostProcessor& rapid = *postCalled("rapid");
    for (const char* frame : {"fixture 1", "weld seam 1"}) {  // also where the path is called so
      RobotProgram program = framedProgram("irb120");
      program.frameName = frame;
      program.declaresFrame = false;
      const std::string text = rapid.write(program);
      QVERIFY(text.find("\n  PERS wobjdata") == text.npos);
      QVERIFY(text.find("\n  ! PERS wobjdata ") != text.npos);
      const auto check = checkWritten(rapid, program, text);
      QVERIFY(check.hasValue() && check->distance <= 1e-3 && check->angle <= 1e-3 && check->isInFrame);
      RobotProgram without = programOf("irb120");
      QVERIFY(!rapid.read(text, without).hasValue());
      without.otherFrames = {"other", frame};
      without.knownFrames = {{"other", Pose::Identity()}, {frame, program.frame}};
      const auto read = rapid.read(text, without);
      QVERIFY(read.hasValue() && read->size() == 2 && (*read)[1].frame);
      QVERIFY((*read)[1].frame->isApprox(program.frame, 1e-12));
      // The data of a file come before those of the cell.
      const std::string own = "  PERS wobjdata " + (*read)[1].frameName +
                              ":=[FALSE,TRUE,\"\",[[1,2,3],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n  ! PERS wobjdata ";
      const auto changed = rapid.read(replacedOnce(text, "  ! PERS wobjdata ", own), without);
      QVERIFY(changed.hasValue() && (*changed)[1].frame);
      QVERIFY((*changed)[1].frame->translation().isApprox(Vec3(1.0, 2.0, 3.0), 1e-12));
    }
  }

  // A frame that a person has changed in the file displaces the robot by as much.
  void changedByHand() {
    RobotProgram program = framedProgram("irb120");
    program.frame = Pose(Eigen::Translation3d(400.0, 50.0, 290.0));
    const auto moved = [&](const char* post, const std::string& what, const std::string& by) {
      const PostProcessor& language = *postCalled(post);
      const auto read = language.read(replacedOnce(language.write(program), what, by), program);
      return read ? Vec3(program.frame * (*read)[1].pose->translation()) : Vec3(Vec3::Constant(1e9));
    };
    const Vec3 wanted = program.tipOf(program.motions[1]).translation();
    QVERIFY((moved("rapid", "\"\",[[400.00000,", "\"\",[[407.00000,") - wanted - Vec3(7, 0, 0)).norm() < 1e-3);
    QVERIFY((moved("krl", "$BASE={X 400.00000,", "$BASE={X 407.00000,") - wanted - Vec3(7, 0, 0)).norm() < 1e-3);
    QVERIFY((moved("fanuc", "PR[9,1]=400.00000", "PR[9,1]=407.00000") - wanted - Vec3(7, 0, 0)).norm() < 1e-3);
    QVERIFY(
        (moved("urscript", "frame_fixture_1 = p[0.400", "frame_fixture_1 = p[0.407") - wanted - Vec3(7, 0, 0)).norm() <
        1e-3);
  }

  // User frame 9 in the world, which is 330 mm above the foot of this arm. With all joints at 0 its flange is 465 mm
  // ahead, and 695 mm above the foot (drawing of B-83494EN/03): in the frame that is turned by 90° 365 mm along -y.
  void fanuc() {
    RobotProgram program = framedProgram("lrmate200id");
    program.tool = Pose::Identity();
    program.frame = Pose(Eigen::Translation3d(100.0, -50.0, 330.0) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitZ()));
    program.motions[1].joints = ArmValues::Zero(6);
    const std::string text = postCalled("fanuc")->write(program);
    std::size_t last = 0;
    for (const char* line : {"!Sets UFRAME[9], PR[9] to ;", "!fixture_1 ;", "PR[9]=LPOS-LPOS ;", "PR[9,1]=100.00000 ;",
                             "PR[9,2]=(-50.00000) ;", "PR[9,3]=0.00000 ;", "PR[9,4]=0.0000000 ;", "PR[9,5]=0.0000000 ;",
                             "PR[9,6]=90.0000000 ;", "UFRAME[9]=PR[9] ;", "UFRAME_NUM=9 ;", "UTOOL_NUM=1 ;"}) {
      const std::size_t at = text.find(line, last);
      QVERIFY2(at != text.npos, line);
      last = at;
    }
    QVERIFY(text.find("UFRAME_NUM=0") == text.npos && text.find("UF : 0") == text.npos);
    QVERIFY(text.find("UF : 9, UT : 1, CONFIG") != text.npos);
    QVERIFY(text.find("X = 50.00000 mm, Y = -365.00000 mm, Z = 365.00000 mm") != text.npos);
  }

  // Registers and frames that a program does not set itself are on the controller.
  void fanucRegisters() {
    const auto read = [](const std::string& before, const std::string& after = {}) {
      return readAs("fanuc", "/MN\n" + before + "\n:L P[1] 50mm/sec FINE ;\n" + after +
                                 "\n/POS\nP[1]{\n GP1:\n UF : 3, UT : 0,\n X = 1 mm, Y = 2 mm, Z = 3 mm,\n W = 0 deg, "
                                 "P = 0 deg, R = 0 deg\n};\n/END\n");
    };
    const std::string set = ":PR[4]=LPOS-LPOS ;\n:PR[4,2]=(-20.5) ;\n:PR[4,6]=90 ;\n:UFRAME[3]=PR[4] ;";
    const auto known = read(set);
    QVERIFY(known.hasValue());
    const RobotProgram program = programOf("lrmate200id");
    // The tool of the program is the flange, that of the cell 10, -5, 120 mm before it, turned by 0.3.
    const Pose flange = program.frame * *known->front().pose * program.tool.inverse(Eigen::Isometry);
    QVERIFY((flange.translation() - Vec3(-2.0, -19.5, 333.0)).norm() < 1e-9);
    QVERIFY(!read("").hasValue());
    for (const char* const unread :
         {":UFRAME[3]=PR[4] ;", ":PR[4]=LPOS-LPOS ;\n:UFRAME[3]=PR[5] ;", ":PR[4,1]=5 ;\n:UFRAME[3]=PR[4] ;",
          ":PR[4]=LPOS ;", ":PR[4]=LPOS-LPOS+PR[1] ;", ":PR[4]=LPOS-LPOS ;\n:PR[4,7]=1 ;",
          ":PR[4]=LPOS-LPOS ;\n:PR[4,1]=R[1] ;", ":PR[4]=LPOS-LPOS ;\n:PR[4,1]=(-5 ;",
          ":PR[4]=LPOS-LPOS ;\n:PR[4,1]=5+R[1] ;", ":PR[R[1]]=LPOS-LPOS ;"}) {
      const auto refused = read(unread);
      QVERIFY2(!refused.hasValue() && refused.error().code == PostError::StatementUnread, unread);
    }
    // A value set after a motion would have meant another position before.
    QVERIFY(read(set, ":PR[4]=LPOS-LPOS ;").error().code == PostError::StatementUnread);
  }

  // Only if the base is the controller's; otherwise the lines are by joint values as without a frame.
  void urScript() {
    RobotProgram program = framedProgram("ur5");
    program.frame = Pose(Eigen::Translation3d(400.0, 0.0, -10.0));
    const std::string known = postCalled("urscript")->write(program);
    QVERIFY(known.find("  frame_fixture_1 = p[0.400000000,0.000000000,-0.010000000,0.000000000,0.000000000,"
                       "0.000000000]\n") != known.npos);
    QVERIFY(known.find("  movel(pose_trans(frame_fixture_1,p[") != known.npos);
    program.isBaseOfController = false;
    const std::string unknown = postCalled("urscript")->write(program);
    QVERIFY(unknown.find("pose_trans") == unknown.npos && unknown.find("  movel([0.6") != unknown.npos);
    QVERIFY(unknown.find("base of the robot's description, not used here: p[0.400000000,") != unknown.npos);
  }

  // pose_trans(a, b) is a followed by b; a must be a pose in numbers that is given before.
  void urFrames() {
    const RobotProgram program = programOf("ur5");
    const auto read = [&](const std::string& before, const std::string& target) {
      return postCalled("urscript")->read(before + "\nmovel(" + target + ",a=1,v=0.1)\n", program);
    };
    const std::string table = "table = p[1,0,0,0,0,1.5707963267948966]";
    const auto known = read(table, "pose_trans(table, p[0.2,0,0.3,0,0,0])");
    QVERIFY(known.hasValue());
    QVERIFY(((program.frame * *known->front().pose).translation() - Vec3(1000, 200, 300)).norm() < 1e-6);
    QVERIFY((known->front().frame->translation() - Vec3(1000, 0, 0)).norm() < 1e-9);
    const std::string target = "pose_trans(table,p[0.2,0,0.3,0,0,0])";
    for (const std::string& before : std::initializer_list<std::string>{
             "", table + "\ntable = get_actual_tcp_pose()", table + "\ntable = [1,0,0,0,0,0]",
             "table = p[1,0,0,0,0,0+x]", "table = pose_trans(p[1,0,0,0,0,0],p[0,0,0,0,0,0])"}) {
      const auto refused = read(before, target);
      QVERIFY2(!refused.hasValue() && refused.error().code == PostError::StatementUnread, before.c_str());
    }
    for (const char* const odd : {"pose_trans(table)", "pose_trans(table,[0.2,0,0.3,0,0,0])", "pose_trans(table,other)",
                                  "pose_trans(pose_trans(table,table),p[0,0,0,0,0,0])", "pose_trans"})
      QVERIFY2(!read(table, odd).hasValue(), odd);
  }
};

HANDWHEEL_TEST(PostFramesTest)
#include "PostFramesTest.moc"
