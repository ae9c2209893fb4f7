// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileFromStep.h"

#include "TestClass.h"
#include "machining/refit/SampledProfile.h"
#include "machining/target/TargetErrors.h"
#include "nurbs/StepWriter.h"

#include <Eigen/Geometry>

#include <QFile>
#include <QtTest>
#include <cstdio>
#include <random>
#include <regex>

using namespace handwheel;

namespace {

ErrorCode answerCode(std::string_view answer) {
  const auto read = profileFromStepAnswer(answer);
  return read ? ErrorCode() : read.error().code;
}

Result<ProfileFromStep> written(const ProfileCurve& curve) {
  return readProfileFromStep(writeStep(curve).value(), UnturnedFaces::Refuse);
}

// A STEP file whose points and directions are turned and then moved.
std::string elsewhere(const std::string& step, const Eigen::Matrix3d& turn, const Eigen::Vector3d& by) {
  static const std::regex kTriple(
      R"((CARTESIAN_POINT|DIRECTION)(\s*\(\s*'[^']*'\s*,\s*\()([^,()]+),([^,()]+),([^,()]+)\))");
  std::string text;
  auto from = step.cbegin();
  for (std::sregex_iterator each(step.begin(), step.end(), kTriple), end; each != end; ++each) {
    const std::smatch& found = *each;
    Eigen::Vector3d v = turn * Eigen::Vector3d(std::stod(found[3]), std::stod(found[4]), std::stod(found[5]));
    if (found[1] == "CARTESIAN_POINT") v += by;
    char numbers[120];
    std::snprintf(numbers, sizeof numbers, "%.16E,%.16E,%.16E)", v.x(), v.y(), v.z());
    text.append(from, found[0].first).append(found[1]).append(found[2]).append(numbers);
    from = found[0].second;
  }
  return text.append(from, step.cend());
}

std::string dataFile(const char* name) {
  QFile file(qEnvironmentVariable("HANDWHEEL_DATA") + QLatin1Char('/') + QLatin1String(name));
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

}  // namespace

class ProfileFromStepTest : public QObject {
  Q_OBJECT

 private slots:
  void answers() {
    const auto bar = profileFromStepAnswer("turned 0\nline 5 0 5 20\nline 0 0 5 0\nline 0 20 5 20\n");
    QVERIFY(bar.hasValue());
    QVERIFY(std::abs(bar->target.volume() - M_PI * 25.0 * 20.0) < 1e-9);
    const auto ball = profileFromStepAnswer("turned 2\narc 0 -5 5 0 0 5\n");
    QVERIFY(ball.hasValue());
    QCOMPARE(ball->ignoredFaces, std::size_t{2});
    QVERIFY(std::abs(ball->target.volume() - 4.0 / 3.0 * M_PI * 125.0) < 1e-9);
    QCOMPARE(answerCode("no-axis\n"), ErrorCode(TargetError::NoAxis));
    QCOMPARE(answerCode("solids 7\n"), ErrorCode(TargetError::NotOneSolid));
    QCOMPARE(answerCode("face 3 plane 1 2 3\n"), ErrorCode(TargetError::NotTurned));
    QCOMPARE(profileFromStepAnswer("face 3 \x1b[0m 1 2 3\n").error().arguments[1], std::string("surface"));
    for (const char* bad : {"", "x", "turned", "turned x", "turned 0 line 1 2 3", "turned 0 line 1 2 3 nan",
                            "turned 0 points 9999999999 1 1", "turned 0 points 1 1 1", "face", "face 1 plane 1 2",
                            "turned 0 line 1e9 0 1 1"})
      QCOMPARE(answerCode(bad), ErrorCode(ErrorCode::LibraryFailed));
  }

  void mutations() {
    const std::string sound = "turned 0\nline 5 0 5 20\narc 0 25 3 23 5 20\nline 0 0 5 0\npoints 3 0 20 3 20 5 20\n";
    std::mt19937 random(3);
    for (int i = 0; i < 5000; ++i) {
      std::string text = sound;
      for (int k = 0; k < 3; ++k) text[random() % text.size()] = "0123456789-. e\nal"[random() % 17];
      (void)profileFromStepAnswer(text);
    }
  }

  // Files of this program: B-spline surfaces, the axis z.
  void ofOurOwnFiles() {
    const auto shaft =
        written(ProfileCurve::polyline({{0, 3}, {10, 3}, {10, 20}, {15, 20}, {12, 40}, {0, 40}}).value());
    QVERIFY(shaft.hasValue());
    const auto expected =
        TargetProfile::make({{{10, 3}, {10, 20}, 0.0}, {{10, 20}, {15, 20}, 0.0}, {{15, 20}, {12, 40}, 0.0}});
    QVERIFY(std::abs(shaft->target.volume() / expected->volume() - 1.0) < 1e-6);
    QVERIFY(std::abs(shaft->target.distance({15, 20})) < 1e-6 && std::abs(shaft->target.lowerEnd() - 3.0) < 1e-6);
    const double w = std::sqrt(0.5);
    const ProfileNurbs half{2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, -5}, {5, -5}, {5, 0}, {5, 5}, {0, 5}}, {1, w, 1, w, 1}};
    const auto ball = written(ProfileCurve::make(half).value());
    QVERIFY(ball.hasValue());
    QVERIFY(std::abs(ball->target.volume() / (4.0 / 3.0 * M_PI * 125.0) - 1.0) < 1e-6);
  }

  // Wherever a part lies in its file, it is the same part.
  void anyAxisIsFound_data() {
    QTest::addColumn<double>("tilt");
    QTest::addColumn<double>("about");
    for (const auto& [tilt, about] : {std::pair(30.0, 40.0), std::pair(60.0, -130.0), std::pair(90.0, 0.0),
                                      std::pair(90.0, 90.0), std::pair(180.0, 15.0)})
      QTest::addRow("%g about %g", tilt, about) << tilt << about;
  }
  void anyAxisIsFound() {
    QFETCH(double, tilt);
    QFETCH(double, about);
    const auto shaft = ProfileCurve::polyline({{0, 3}, {10, 3}, {10, 20}, {15, 20}, {12, 40}, {0, 40}});
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(about * M_PI / 180.0, Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(tilt * M_PI / 180.0, Eigen::Vector3d::UnitX()))
                                     .toRotationMatrix();
    const Eigen::Vector3d by(100.0, -50.0, 20.0);
    const auto read = readProfileFromStep(elsewhere(writeStep(shaft.value()).value(), turn, by), UnturnedFaces::Refuse);
    QVERIFY(read.hasValue());
    const TargetProfile& part = read->target;
    const double volume = M_PI * (100.0 * 17.0 + 20.0 / 3.0 * (15.0 * 15.0 + 15.0 * 12.0 + 12.0 * 12.0));
    QVERIFY(std::abs(part.volume() / volume - 1.0) < 1e-6);
    QVERIFY(std::abs(part.length() - 37.0) < 1e-6 && std::abs(part.largestRadius() - 15.0) < 1e-6);
    // The axis does not determine the upper end.
    const bool isUp = std::abs(part.distance({10.0, part.lowerEnd() + 7.0})) < 1e-6;
    const auto placed = [&](double r, double z) {
      return ProfilePoint(r, isUp ? part.lowerEnd() + z - 3.0 : part.upperEnd() - z + 3.0);
    };
    for (const auto& [r, z] : {std::pair(10.0, 10.0), std::pair(15.0, 20.0), std::pair(13.5, 30.0)})
      QVERIFY(std::abs(part.distance(placed(r, z))) < 1e-6);
  }

  void notAStepFile() {
    QCOMPARE(readProfileFromStep("ISO-10303-21; nonsense", UnturnedFaces::Refuse).error().code,
             ErrorCode(ErrorCode::LibraryFailed));
    JobState state;
    state.cancelled = true;
    QCOMPARE(readProfileFromStep("ISO-10303-21;", UnturnedFaces::Refuse, Progress(state)).error().code,
             ErrorCode(ErrorCode::Cancelled));
  }

  void realFiles() {
    if (qEnvironmentVariableIsEmpty("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set");
    const auto code = [](const char* name) {
      const std::string bytes = dataFile(name);
      const auto read = readProfileFromStep(bytes, UnturnedFaces::Refuse);
      return read ? ErrorCode() : read.error().code;
    };
    QCOMPARE(code("lathe/trimesh-step/featuretype.STEP"), ErrorCode(TargetError::NotTurned));
    QCOMPARE(code("lathe/pythonocc-step/as1_pe_203.stp"), ErrorCode(TargetError::NotOneSolid));
  }
};

HANDWHEEL_TEST(ProfileFromStepTest)
#include "ProfileFromStepTest.moc"
