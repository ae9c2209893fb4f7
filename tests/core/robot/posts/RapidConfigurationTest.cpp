// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/RapidConfiguration.h"

#include "AnyProgram.h"
#include "TestClass.h"
#include "robot/arm/ClosedFormIk.h"
#include "robot/posts/PostText.h"

#include <Eigen/SVD>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

ArmValues rapidJointsOf(const QList<double>& degrees) {
  return radiansOf(std::span(degrees.data(), static_cast<std::size_t>(degrees.size())));
}

// Returns a joint motion to the pose of these joint values, with the confdata that the post gives a line to it.
std::string rapidMoveJ(RobotProgram program, const ArmValues& joints) {
  program.isBaseOfController = true;
  program.motions = {{ProgramMotion::Kind::Linear, joints, 50.0, 0.0, {}}};
  std::string text = postCalled("rapid")->write(program);
  return text.replace(text.find("MoveL"), 5, "MoveJ");
}

std::string textWith(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == text.npos ? std::string() : text.replace(at, from.size(), to);
}

}  // namespace

// Tests the configuration at the end of a joint motion to a robtarget, by ABB's definition of confdata.
class RapidConfigurationTest : public QObject {
  Q_OBJECT

 private slots:
  // An IRB 120 by its drawing: the wrist is 270 sin J2 + 70 sin (J2 + J3) + 302 cos (J2 + J3) mm ahead of axis 1, and
  // behind the lower arm for J3 < -atan (302 / 70) = -76.95 degrees. cf1, cf4 and cf6 are floor(angle / 90).
  void definition_data() {
    QTest::addColumn<QList<double>>("degrees");
    QTest::addColumn<QByteArray>("configuration");
    const auto row = [](QList<double> degrees, const char* configuration) {
      QTest::newRow(configuration) << std::move(degrees) << QByteArray(configuration);
    };
    row({10, 0, 0, -30, 40, 100}, "[0,-1,1,0]");            // 302 mm
    row({-10, 0, 0, 95, -40, -100}, "[-1,1,-2,1]");         // 302 mm
    row({100, 60, -100, -95, 30, 200}, "[1,-2,2,2]");       // 420 mm
    row({-100, 60, -100, 20, -30, -300}, "[-2,0,-4,3]");    // 420 mm
    row({20, -100, -30, 45, 60, 380}, "[0,0,4,4]");         // -514 mm
    row({20, -100, -30, 45, -60, -10}, "[0,0,-1,5]");       // -514 mm
    row({160, -60, -100, -150, 100, 85}, "[1,-2,0,6]");     // -541 mm
    row({-160, -60, -100, 150, -100, -95}, "[-2,1,-2,7]");  // -541 mm
  }
  void definition() {
    QFETCH(const QList<double>, degrees);
    QFETCH(const QByteArray, configuration);
    const RobotProgram program = programOf("irb120");
    const ArmValues joints = rapidJointsOf(degrees);
    QCOMPARE(rapidConfigurationOf(program.arm, joints).text(), configuration.toStdString());
    const std::string text = rapidMoveJ(program, joints);
    QVERIFY2(text.find("," + configuration.toStdString() + ",[9E9") != text.npos, text.c_str());
    const auto read = postCalled("rapid")->read(text, program);
    QVERIFY(read.hasValue());
    QVERIFY((*read)[0].kind == ProgramMotion::Kind::Joint && !(*read)[0].isConfigurationOpen);
    QVERIFY((*read)[0].joints && (*(*read)[0].joints - joints).cwiseAbs().maxCoeff() < 1e-5);
  }

  // Any joint values within the limits are written and read back, in any configuration. Not if the arm can hardly move:
  // there the rounding of the text makes the solutions ambiguous.
  void anyJoints_data() {
    QTest::addColumn<QByteArray>("robot");
    for (const LibraryRobot& robot : robotLibrary()) QTest::newRow(robot.id) << QByteArray(robot.id);
  }
  void anyJoints() {
    QFETCH(const QByteArray, robot);
    const RobotProgram program = programOf(robot.constData());
    const bool isUniversal = robot.startsWith("ur");
    QVERIFY(rc::check("joints of a way", [&] {
      const ArmValues joints = anyJointsOf(program.arm);
      // A linkage does not bend backwards, so that confdata do not tell it.
      RC_PRE(!program.arm.coupling() || program.arm.coupling()->factor < 0.0 || joints[2] > std::atan2(-755.0, 135.0));
      ArmJacobian jacobian;
      program.arm.tipPose(joints, jacobian);
      jacobian.topRows(3) *= 1e-3;  // m
      const Eigen::MatrixXd moves = jacobian;
      RC_PRE(Eigen::JacobiSVD<Eigen::MatrixXd>(moves).singularValues().minCoeff() > 0.003);
      const auto read = postCalled("rapid")->read(rapidMoveJ(program, joints), program);
      RC_ASSERT(read.hasValue());
      const ParsedMotion& motion = read->front();
      RC_ASSERT(motion.isConfigurationOpen == isUniversal);  // confdata distinguish the solutions of spherical wrists
      if (!isUniversal) RC_ASSERT((*motion.joints - joints).cwiseAbs().maxCoeff() < 1e-4);
    }));
  }

  // The parallel linkage of an IRB 2400: cfx is 0 and not used, also with the wrist behind axis 1 or axis 5 below 0. In
  // a frame of the cell lines are poses, after ConfL\Off. By hand for axes 2 and 3 at -60 and -30 degrees: the wrist is
  // 100 + 705 sin -60 + 755 cos 30 - 135 sin 30 = 75.8 mm ahead of axis 1; at -90 and -60 it is 344.4 mm behind it.
  void parallelLinkage() {
    RobotProgram program = programOf("irb2400");
    program.frameName = "table";
    const auto posture = [](double second, double third, double fifth) {
      return rapidJointsOf({20, second, third - second, -100, fifth, 30});
    };
    const Pose wrist = Pose(Eigen::Translation3d(0.0, 0.0, -85.0));
    const auto ahead = [&](const ArmValues& joints) {
      const Vec3 at = (program.arm.tipPose(joints) * wrist).translation();
      return at.x() * std::cos(joints[0]) + at.y() * std::sin(joints[0]);
    };
    QVERIFY(std::abs(ahead(posture(-60, -30, 40)) - 75.80) < 0.01);
    QVERIFY(std::abs(ahead(posture(-90, -60, -40)) + 344.41) < 0.01);
    for (const ArmValues& joints : {posture(-60, -30, 40), posture(-90, -60, -40), posture(30, 10, -50)}) {
      const std::string text = rapidMoveJ(program, joints);
      QVERIFY2(text.find(",[0,-2,0,0],[9E9") != text.npos, text.c_str());
      QVERIFY(text.find("ConfL\\Off") < text.find("MoveJ"));
      for (const char* const cfx : {"0", "4", "7"}) {
        const auto read = postCalled("rapid")->read(
            textWith(text, "[0,-2,0,0],[9E9", std::string("[0,-2,0,") + cfx + "],[9E9"), program);
        QVERIFY(read.hasValue() && (*read)[0].joints && !(*read)[0].isConfigurationOpen);
        QVERIFY((*(*read)[0].joints - joints).cwiseAbs().maxCoeff() < 1e-5);
      }
      const auto line = postCalled("rapid")->read(textWith(text, "MoveJ", "MoveL"), program);
      QVERIFY(line.hasValue() && (*line)[0].pose && !(*line)[0].endsIn);
    }
  }

  // All solutions for one pose have confdata of their own, and confdata without a solution are refused with their line.
  void otherConfigurations() {
    const RobotProgram program = programOf("irb120");
    const ArmValues joints = rapidJointsOf({30, 20, 10, 80, 57, 0});
    const std::string text = rapidMoveJ(program, joints);
    const auto read = [&](const std::string& configuration) {
      return postCalled("rapid")->read(textWith(text, "[0,0,0,0],[9E9", configuration + ",[9E9"), program);
    };
    // The other solution of the wrist: axis 5 to its other side, the axes 4 and 6 by half a turn.
    const auto flipped = read("[0,-2,2,1]");
    QVERIFY(flipped.hasValue());
    QVERIFY((*(*flipped)[0].joints - rapidJointsOf({30, 20, 10, -100, -57, 180})).cwiseAbs().maxCoeff() < 1e-5);
    const auto back = read("[0,-2,-2,1]");  // axis 6 at the end of its quarter turn, half a turn to the other side
    QVERIFY(back.hasValue());
    QVERIFY((*(*back)[0].joints - rapidJointsOf({30, 20, 10, -100, -57, -180})).cwiseAbs().maxCoeff() < 1e-5);
    QVERIFY(read("[0,0,4,0]").hasValue());  // with a whole turn of axis 6
    for (const char* const none : {"[0,0,0,1]", "[1,0,0,0]", "[0,1,0,0]", "[0,-2,1,0]", "[0,0,0,4]", "[0,0,8,0]"}) {
      const auto refused = read(none);
      QVERIFY2(!refused.hasValue(), none);
      const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("MoveJ")), '\n');
      QCOMPARE(refused.error().position.value, static_cast<std::uint64_t>(line + 1));
    }
  }

  // Without a configuration that counts the solution is the nearest to the arm's last configuration, and that is
  // reported.
  void openConfigurations() {
    const RobotProgram program = programOf("irb120");
    const std::string text = rapidMoveJ(program, rapidJointsOf({30, 20, 10, 80, 57, 0}));
    const auto isOpen = [&](const std::string& changed) {
      const auto read = postCalled("rapid")->read(changed, program);
      return read.hasValue() && (*read)[0].isConfigurationOpen && (*read)[0].pose && !(*read)[0].joints;
    };
    for (const char* const odd :
         {"[9E9,9E9,9E9,9E9]", "[0,0,0,8]", "[0,0,0,-1]", "[0,0.5,0,0]", "[1E30,0,0,0]", "[0,0,0,9E9]"})
      QVERIFY2(isOpen(textWith(text, "[0,0,0,0],[9E9", odd + std::string(",[9E9"))), odd);
    QVERIFY(isOpen(textWith(text, "    VelSet", "    ConfJ\\Off;\n    VelSet")));
    QVERIFY(isOpen(textWith(text, "    VelSet", "    confj \\ off;\n    VelSet")));
    QVERIFY(!isOpen(textWith(text, "    VelSet", "    ConfJ\\Off;\n    ConfJ\\On;\n    VelSet")));
    QVERIFY(!isOpen(textWith(text, "    VelSet", "    ConfL\\Off;\n    VelSet")));  // for lines
    // A line keeps the configuration in which it begins.
    const auto line = postCalled("rapid")->read(textWith(text, "MoveJ", "MoveL"), program);
    QVERIFY(line.hasValue() && (*line)[0].pose && !(*line)[0].isConfigurationOpen && !(*line)[0].endsIn);
    const std::string heeded = textWith(text, "ConfL\\Off", "ConfL\\On");
    const auto ending = postCalled("rapid")->read(textWith(heeded, "MoveJ", "MoveL"), program);
    QVERIFY(ending.hasValue() && (*ending)[0].pose && (*ending)[0].endsIn == (RapidConfiguration{{0, 0, 0}, 0}));
  }

  // With axes 4 and 6 in line only the sum of their angles is given by a pose; here it is 0.
  void inLine() {
    const SerialArm arm = armCalled("irb120");
    const auto closed = ClosedFormIk::of(arm);
    QVERIFY(closed.has_value());
    const ArmValues zero = ArmValues::Zero(6);
    const Pose tip = arm.tipPose(zero);
    const auto found = [&](const RapidConfiguration& wanted) { return jointsWith(wanted, arm, *closed, tip, zero); };
    const std::vector<RapidConfiguration> possible = {
        {{0, 0, 0}, 0}, {{0, 0, -1}, 0}, {{0, -1, 0}, 1}, {{0, 1, -2}, 0}, {{-1, -2, 1}, 0}};
    for (const RapidConfiguration& wanted : possible) {
      const auto values = found(wanted);
      QVERIFY2(values.has_value(), wanted.text().c_str());
      QVERIFY((arm.tipPose(*values).matrix() - tip.matrix()).cwiseAbs().maxCoeff() < 1e-4);
      for (const auto& [axis, quarter] : {std::pair(3, wanted.quarters[1]), std::pair(5, wanted.quarters[2])}) {
        QVERIFY((*values)[axis] >= 0.5 * M_PI * quarter - 2e-3);
        QVERIFY((*values)[axis] <= 0.5 * M_PI * (quarter + 1) + 2e-3);
      }
    }
    const std::vector<RapidConfiguration> impossible = {{{0, 1, 1}, 0}, {{0, 1, 0}, 0}, {{0, 0, 0}, 4}};
    for (const RapidConfiguration& wanted : impossible) QVERIFY2(!found(wanted), wanted.text().c_str());
  }

  // Controllers save poses with hundredths of a millimetre and six decimals of the quaternion. With axis 5 near 0 the
  // angles of the axes 4 and 6 come from this rounding, and such a pose is not refused.
  void rounded_data() {
    QTest::addColumn<QList<double>>("degrees");
    for (const double fifth : {0.0, 0.001, -0.001, 0.01, 0.03, 0.2, 1.0, -1.0, 10.0}) {
      for (const auto& [fourth, sixth] : {std::pair(0.0, 0.0), std::pair(40.0, -30.0), std::pair(-90.0, 90.0)})
        QTest::addRow("%g %g %g", fourth, fifth, sixth) << QList<double>{30, 20, 10, fourth, fifth, sixth};
    }
  }
  void rounded() {
    QFETCH(const QList<double>, degrees);
    RobotProgram program = programOf("irb120");
    program.tool = program.frame = Pose::Identity();
    const ArmValues joints = rapidJointsOf(degrees);
    const Pose tip = program.arm.tipPose(joints);
    const Eigen::Quaterniond turn(tip.linear());
    const auto listed = [](std::initializer_list<double> numbers, int decimals) {
      QStringList texts;
      for (const double number : numbers) texts += QString::number(number, 'f', decimals);
      return "[" + texts.join(QLatin1Char(',')).toStdString() + "]";
    };
    const RapidConfiguration wanted = rapidConfigurationOf(program.arm, joints);
    const std::string text = "PROC main()\nMoveJ [" +
                             listed({tip.translation().x(), tip.translation().y(), tip.translation().z()}, 2) + "," +
                             listed({turn.w(), turn.x(), turn.y(), turn.z()}, 6) + "," + wanted.text() +
                             ",[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\nENDPROC\n";
    const auto read = postCalled("rapid")->read(text, program);
    QVERIFY2(read.hasValue(), text.c_str());
    QVERIFY((*read)[0].joints.has_value());
    const ArmValues& values = *(*read)[0].joints;
    const Pose reached = program.arm.tipPose(values);
    QVERIFY((reached.translation() - tip.translation()).norm() < 0.05);
    QVERIFY(Eigen::AngleAxisd(Eigen::Matrix3d(tip.linear().transpose() * reached.linear())).angle() < 5e-4);
    QVERIFY((values.head(3) - joints.head(3)).cwiseAbs().maxCoeff() < 5e-4);
    QVERIFY(std::abs(values[4] - joints[4]) < 5e-4);
    // With axis 5 near 0, axes 4 and 6 turn against each other by the angle that rounding turns the hand, over its
    // sine. The hand turns by 1e-4 at most: 0.005 mm at the wrist and 5e-7 in the quaternion.
    const double free = std::min(0.5 * M_PI, 1e-4 / std::abs(std::sin(joints[4])));
    for (const auto& [axis, quarter] : {std::pair(3, wanted.quarters[1]), std::pair(5, wanted.quarters[2])}) {
      QVERIFY(values[axis] >= 0.5 * M_PI * quarter - free);
      QVERIFY(values[axis] <= 0.5 * M_PI * (quarter + 1) + free);
    }
  }

  void numbers() {
    const auto from = [](std::initializer_list<double> numbers) {
      return rapidConfigurationFrom(std::span(numbers.begin(), numbers.size()));
    };
    QVERIFY(from({1, -2, 3, 7}) == (RapidConfiguration{{1, -2, 3}, 7}));
    QVERIFY(!from({}) && !from({0, 0, 0}) && !from({0, 0, 0, 0, 0}));
    QVERIFY(!from({std::nan(""), 0, 0, 0}) && !from({0, 0, HUGE_VAL, 0}) && !from({0, -1e300, 0, 0}));
  }
};

HANDWHEEL_TEST(RapidConfigurationTest)
#include "RapidConfigurationTest.moc"
