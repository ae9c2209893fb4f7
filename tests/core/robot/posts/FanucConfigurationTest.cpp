// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/FanucConfiguration.h"

#include "AnyProgram.h"
#include "TestClass.h"
#include "robot/posts/PostText.h"

#include <Eigen/SVD>
#include <QTest>
#include <algorithm>
#include <array>

using namespace handwheel;
using namespace handwheel::test;

namespace {

ArmValues fanucJointsOf(std::initializer_list<double> degrees) {
  return radiansOf(std::span(degrees.begin(), degrees.size()));
}

// A joint motion to the pose of these joint values, with the CONFIG that the post gives a line to it.
std::string fanucJointMotion(RobotProgram program, const ArmValues& joints) {
  program.motions = {{ProgramMotion::Kind::Linear, joints, 50.0, 0.0, {}}};
  std::string text = postCalled("fanuc")->write(program);
  const std::string line = ":L P[1] 50mm/sec";
  return text.replace(text.find(line), line.size(), ":J P[1] 50%");
}

std::string withConfiguration(std::string text, const std::string& configuration) {
  const std::size_t begin = text.find("CONFIG : '") + 10, end = text.find('\'', begin);
  return text.replace(begin, end - begin, configuration);
}

}  // namespace

// Tests the configuration at the end of a joint motion to a pose, by Fanuc's CONFIG.
class FanucConfigurationTest : public QObject {
  Q_OBJECT

 private slots:
  // Any joint values within the limits are written and read back. Not if the arm can hardly move: there the rounding of
  // the text makes the solutions ambiguous.
  void anyJoints() {
    const RobotProgram program = programOf("lrmate200id");
    QVERIFY(rc::check("joints of a way", [&] {
      ArmValues joints(program.arm.size());
      for (Eigen::Index i = 0; i < joints.size(); ++i) {
        const ArmJoint& joint = program.arm.joints()[static_cast<std::size_t>(i)];
        joints[i] = anyNumber(joint.lower, joint.upper);
        // At half a turn the number of turns is either one.
        RC_PRE(std::abs(std::remainder(std::abs(joints[i]) - M_PI, 2.0 * M_PI)) > 1e-3);
      }
      RC_PRE(program.arm.isWithinLimits(joints));  // also those of the coupled axis
      ArmJacobian jacobian;
      program.arm.tipPose(joints, jacobian);
      jacobian.topRows(3) *= 1e-3;  // m
      const Eigen::MatrixXd moves = jacobian;
      RC_PRE(Eigen::JacobiSVD<Eigen::MatrixXd>(moves).singularValues().minCoeff() > 0.003);
      const auto read = postCalled("fanuc")->read(fanucJointMotion(program, joints), program);
      RC_ASSERT(read.hasValue());
      const ParsedMotion& motion = read->front();
      RC_ASSERT(motion.kind == ProgramMotion::Kind::Joint && !motion.isConfigurationOpen && motion.joints);
      RC_ASSERT((*motion.joints - joints).cwiseAbs().maxCoeff() < 1e-4);
    }));
  }

  // The positions of an M-20iD/25 (data sheet: 75, 840, 215, 890 and 90 mm), and their joints as its controller shows
  // them, with J3 from the level. The third by hand: the elbow is 540 mm ahead of axis 2 and 643 above it, the wrist,
  // by a forearm of 890 and 215 mm at 60 degrees, 799 and 1521, which is behind that line: D. In the fifth the wrist is
  // behind axis 1.
  void positionsOfAController() {
    constexpr double kRight = 0.5 * M_PI;
    const std::vector<DhRow> table{{75, -kRight, 0, 0, 1},  {840, 0, 0, -kRight, 1}, {215, -kRight, 0, 0, -1},
                                   {0, kRight, 890, 0, -1}, {0, -kRight, 0, 0, -1},  {0, 0, 90, 0, -1}};
    RobotProgram program;
    program.arm = armOf(table);
    const struct {
      const char *configuration, *pose;
      std::array<double, 6> joints;
    } kKnown[] = {
        {"N U T, 0, 0, 0", "X = 965 mm, Y = 0 mm, Z = 965 mm, W = -180 deg, P = 0 deg, R = 0 deg", {0, 0, 0, 0, -90}},
        {"F U T, 0, 0, 0", "X = 965 mm, Y = 0 mm, Z = 1145 mm, W = 0 deg, P = 0 deg, R = -180 deg", {0, 0, 0, 0, 90}},
        {"N D T, 0, 0, 0",
         "X = 951.688 mm, Y = 0 mm, Z = 1476.74 mm, W = 180 deg, P = -60 deg, R = 0 deg",
         {0, 40, 60, 0, -90}},
        {"N U T, 0, 0, 0",
         "X = 1168.195 mm, Y = 0 mm, Z = -64.785 mm, W = -180 deg, P = 60 deg, R = 0 deg",
         {0, 40, -60, 0, -90}},
        {"N U B, 0, 0, 0",
         "X = -621.015 mm, Y = 0 mm, Z = 1318.185 mm, W = 180 deg, P = -80 deg, R = 0 deg",
         {0, -60, 80, 0, -90}},
        {"N U T, 0, 0, 0", "X = 0 mm, Y = 965 mm, Z = 965 mm, W = -180 deg, P = 0 deg, R = 90 deg", {90, 0, 0, 0, -90}},
    };
    for (const auto& known : kKnown) {
      const std::string text =
          std::string("/MN\n 1:J P[1] 10% FINE ;\n/POS\nP[1]{\n GP1:\n UF : 0, UT : 0, CONFIG : '") +
          known.configuration + "',\n " + known.pose + "\n};\n/END\n";
      const auto read = postCalled("fanuc")->read(text, program);
      QVERIFY2(read.hasValue() && (*read)[0].joints, text.c_str());
      ArmValues joints = *(*read)[0].joints;
      QCOMPARE(QByteArray::fromStdString(fanucConfigurationOf(program.arm, joints).text()),
               QByteArray(known.configuration));
      joints[2] -= joints[1];
      QVERIFY2((joints - radiansOf(known.joints)).cwiseAbs().maxCoeff() < 2e-5, text.c_str());
      program.motions = {{ProgramMotion::Kind::Joint, *(*read)[0].joints, 0.1, 0.0, {}}};
      const std::string written = postCalled("fanuc")->write(program);
      QVERIFY(std::abs(std::stod(written.substr(written.find("J3 = ") + 5)) - known.joints[2]) < 2e-3);
    }
  }

  // The other solution of the wrist, and a whole turn of axis 6, have a CONFIG of their own. A CONFIG without a
  // solution is refused with its line; without a CONFIG the solution is the nearest one, and that is reported.
  void otherConfigurations() {
    const RobotProgram program = programOf("lrmate200id");
    const ArmValues joints = fanucJointsOf({30, 20, 10, 80, 57, 20});
    const std::string text = fanucJointMotion(program, joints);
    QVERIFY2(text.find("CONFIG : 'F U T, 0, 0, 0'") != text.npos, text.c_str());
    const auto read = [&](const std::string& configuration) {
      return postCalled("fanuc")->read(withConfiguration(text, configuration), program);
    };
    const auto isAt = [&](const std::string& configuration, const ArmValues& wanted) {
      const auto found = read(configuration);
      return found.hasValue() && (*found)[0].joints && (*(*found)[0].joints - wanted).cwiseAbs().maxCoeff() < 1e-5;
    };
    QVERIFY(isAt("F U T, 0, 0, 0", joints));
    QVERIFY(isAt("N U T, 0, 0, 0", fanucJointsOf({30, 20, 10, -100, -57, -160})));
    QVERIFY(isAt("N U T, 0, 0, 1", fanucJointsOf({30, 20, 10, -100, -57, 200})));
    QVERIFY(isAt("F U T, 0, 0, -1", fanucJointsOf({30, 20, 10, 80, 57, -340})));
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(":J P[1]")), '\n');
    for (const char* const none : {"F U T, 1, 0, 0", "F U T, 0, 1, 0", "F U T, 0, 0, 9"}) {
      const auto refused = read(none);
      QVERIFY2(!refused.hasValue(), none);
      QCOMPARE(refused.error().position.value, static_cast<std::uint64_t>(line + 1));
    }
    for (const char* const odd : {"", "N U", "N U T", "N U T, 0, 0", "X U T, 0, 0, 0", "N U T, 0, 0, 1e9",
                                  "N U T, 0.5, 0, 0", "N U T, nan, 0, 0"}) {
      const auto open = read(odd);
      QVERIFY2(open.hasValue() && (*open)[0].isConfigurationOpen && (*open)[0].pose && !(*open)[0].joints, odd);
    }
    // A line keeps the configuration in which it begins.
    std::string lined = withConfiguration(text, "F U T, 0, 0, 0");
    lined.replace(lined.find(":J P[1] 50%"), 11, ":L P[1] 50mm/sec");
    const auto straight = postCalled("fanuc")->read(lined, program);
    QVERIFY(straight.hasValue() && (*straight)[0].pose && !(*straight)[0].isConfigurationOpen);
  }
};

HANDWHEEL_TEST(FanucConfigurationTest)
#include "FanucConfigurationTest.moc"
