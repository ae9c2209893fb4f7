// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TurnedStep.h"

#include "TestClass.h"
#include "machining/refit/SampledProfile.h"
#include "machining/target/TargetErrors.h"
#include "nurbs/StepFile.h"

#include <QFile>
#include <QtTest>
#include <random>

using namespace handwheel;

namespace {

ErrorCode answerCode(std::string_view answer) {
  const auto read = turnedStepIn(answer);
  return read ? ErrorCode() : read.error().code;
}

Result<TurnedStep> written(const ProfileCurve& curve) {
  return readTurnedStep(writeStep(curve).value(), UnturnedFaces::Refuse);
}

std::string dataFile(const char* name) {
  QFile file(qEnvironmentVariable("HANDWHEEL_DATA") + QLatin1Char('/') + QLatin1String(name));
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

}  // namespace

class TurnedStepTest : public QObject {
  Q_OBJECT

 private slots:
  void answers() {
    const auto bar = turnedStepIn("turned 0\nline 5 0 5 20\nline 0 0 5 0\nline 0 20 5 20\n");
    QVERIFY(bar.hasValue());
    QVERIFY(std::abs(bar->target.volume() - M_PI * 25.0 * 20.0) < 1e-9);
    const auto ball = turnedStepIn("turned 2\narc 0 -5 5 0 0 5\n");
    QVERIFY(ball.hasValue());
    QCOMPARE(ball->ignoredFaces, std::size_t{2});
    QVERIFY(std::abs(ball->target.volume() - 4.0 / 3.0 * M_PI * 125.0) < 1e-9);
    QCOMPARE(answerCode("no-axis\n"), ErrorCode(TargetError::NoAxis));
    QCOMPARE(answerCode("solids 7\n"), ErrorCode(TargetError::NotOneSolid));
    QCOMPARE(answerCode("face 3 plane 1 2 3\n"), ErrorCode(TargetError::NotTurned));
    QCOMPARE(turnedStepIn("face 3 \x1b[0m 1 2 3\n").error().arguments[1], std::string("surface"));
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
      (void)turnedStepIn(text);
    }
  }

  // What this program writes itself: B-spline surfaces, the axis z.
  void ofOurOwnFiles() {
    const auto shaft =
        written(ProfileCurve::polyline({{0, 3}, {10, 3}, {10, 20}, {15, 20}, {12, 40}, {0, 40}}).value());
    QVERIFY(shaft.hasValue());
    const auto expected =
        TargetProfile::make({{{10, 3}, {10, 20}, 0.0}, {{10, 20}, {15, 20}, 0.0}, {{15, 20}, {12, 40}, 0.0}});
    QVERIFY(std::abs(shaft->target.volume() / expected->volume() - 1.0) < 1e-6);
    QVERIFY(std::abs(shaft->target.distance({15, 20})) < 1e-6 && std::abs(shaft->target.lowerEnd() - 3.0) < 1e-6);
    const double w = std::sqrt(0.5);
    const ProfileNet half{2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, -5}, {5, -5}, {5, 0}, {5, 5}, {0, 5}}, {1, w, 1, w, 1}};
    const auto ball = written(ProfileCurve::make(half).value());
    QVERIFY(ball.hasValue());
    QVERIFY(std::abs(ball->target.volume() / (4.0 / 3.0 * M_PI * 125.0) - 1.0) < 1e-6);
  }

  void notAStepFile() {
    QCOMPARE(readTurnedStep("ISO-10303-21; nonsense", UnturnedFaces::Refuse).error().code,
             ErrorCode(ErrorCode::LibraryFailed));
    JobState state;
    state.cancelled = true;
    QCOMPARE(readTurnedStep("ISO-10303-21;", UnturnedFaces::Refuse, Progress(state)).error().code,
             ErrorCode(ErrorCode::Cancelled));
  }

  void realFiles() {
    if (qEnvironmentVariableIsEmpty("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set");
    const auto code = [](const char* name) {
      const std::string bytes = dataFile(name);
      const auto read = readTurnedStep(bytes, UnturnedFaces::Refuse);
      return read ? ErrorCode() : read.error().code;
    };
    QCOMPARE(code("lathe/trimesh-step/featuretype.STEP"), ErrorCode(TargetError::NotTurned));
    QCOMPARE(code("lathe/pythonocc-step/as1_pe_203.stp"), ErrorCode(TargetError::NotOneSolid));
  }
};

HANDWHEEL_TEST(TurnedStepTest)
#include "TurnedStepTest.moc"
