// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/FanucConfiguration.h"

#include "AnyProgram.h"
#include "TestClass.h"
#include "robot/posts/PostText.h"

#include <Eigen/SVD>
#include <QTest>
#include <algorithm>

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

  // The other solution of the wrist, and a whole turn of axis 6, have a CONFIG of their own. A CONFIG without a
  // solution is refused with its line; without a CONFIG the solution is the nearest one, and that is reported.
  void otherConfigurations() {
    const RobotProgram program = programOf("lrmate200id");
    const ArmValues joints = fanucJointsOf({30, 20, 10, 80, 57, 20});
    const std::string text = fanucJointMotion(program, joints);
    QVERIFY2(text.find("CONFIG : 'N U T, 0, 0, 0'") != text.npos, text.c_str());
    const auto read = [&](const std::string& configuration) {
      return postCalled("fanuc")->read(withConfiguration(text, configuration), program);
    };
    const auto isAt = [&](const std::string& configuration, const ArmValues& wanted) {
      const auto found = read(configuration);
      return found.hasValue() && (*found)[0].joints && (*(*found)[0].joints - wanted).cwiseAbs().maxCoeff() < 1e-5;
    };
    QVERIFY(isAt("N U T, 0, 0, 0", joints));
    QVERIFY(isAt("F U T, 0, 0, 0", fanucJointsOf({30, 20, 10, -100, -57, -160})));
    QVERIFY(isAt("F U T, 0, 0, 1", fanucJointsOf({30, 20, 10, -100, -57, 200})));
    QVERIFY(isAt("N U T, 0, 0, -1", fanucJointsOf({30, 20, 10, 80, 57, -340})));
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(":J P[1]")), '\n');
    for (const char* const none : {"N U T, 1, 0, 0", "N U T, 0, 1, 0", "N U T, 0, 0, 9"}) {
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
