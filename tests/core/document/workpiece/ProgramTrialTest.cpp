// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/ProgramTrial.h"

#include "TestClass.h"
#include "document/workpiece/PassesProgram.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceErrors.h"
#include "document/workpiece/target/TargetImport.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramErrors.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr double kSpacing = 0.05;  // mm

// 50 mm of a bar of 40 mm are turned to 36 mm. Back, it goes out before it goes right.
constexpr const char* kTurn =
    "G7 G21 G97 S600 M3\n"
    "G0 X36 Z2\n"
    "G1 Z-50 F120\n"
    "G0 X44\n"
    "G0 Z2\n"
    "M2\n";

WorkpieceSnapshot freshBar() {
  WorkpieceSnapshot workpiece;
  workpiece.stock = {40.0, 100.0, -100.0};
  workpiece.mesh = std::make_shared<const StockMesh>(workpiece.stock, workpiece.chord);
  return workpiece;
}

ProgramTrial::Pointer tried(const char* text, const WorkpieceSnapshot& workpiece, double nose = 0.0) {
  const ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, workpiece.stock, 20.0, nose);
  const auto trial = ProgramTrial::run(workpiece, text, setup, kSpacing);
  return trial ? *trial : nullptr;
}

double radiusAt(const TurnedProfile& profile, double z) {  // from the lower end
  return profile.radius(static_cast<std::size_t>(std::lround(z / profile.spacing())));
}

}  // namespace

// A program is tried on a workpiece, which stays as it is.
class ProgramTrialTest : public QObject {
  Q_OBJECT

 private slots:
  void aCylinder() {
    const WorkpieceSnapshot workpiece = freshBar();
    const auto trial = tried(kTurn, workpiece);
    QVERIFY(trial && trial->part() && !workpiece.part);
    const double ring = M_PI * (20.0 * 20.0 - 18.0 * 18.0);               // mm², of the section that goes
    QVERIFY(std::abs(trial->removed() - 50.0 * ring) < ring * kSpacing);  // one sample at the shoulder
    QCOMPARE(trial->collisionCount(), std::size_t(0));
    // 52 mm at 120 mm/min; the rapid moves take the rest.
    QVERIFY(trial->path().time > 26.0 && trial->path().time < 32.0);
    // The passes cut the same part again, bit for bit.
    TurnedProfile again(workpiece.stock, kSpacing);
    for (const auto& pass : trial->part()->passes) cut(again, *pass);
    QVERIFY(again == trial->part()->profile);
  }

  // With a target, program zero is its finished face: 3 mm behind the end of the bar. A program that turns a pin to Z 0
  // and more to Z -50 makes a shoulder 53 mm behind the end of the bar; the cut becomes a program that does the same.
  void zeroIsTheFinishedFace() {
    WorkpieceSnapshot workpiece = freshBar();
    const auto drawn =
        TargetProfile::make({{{0, 0}, {18, 0}, 0.0}, {{18, 0}, {18, 60}, 0.0}, {{18, 60}, {0, 60}, 0.0}});
    workpiece.target = placedTarget({*drawn, "x.dxf", {}}, workpiece.stock, 3.0);
    QVERIFY(std::abs(programZero(workpiece) + 3.0) < 1e-9);
    const ProgramSetup setup = programSetupFor(workpiece, {}, ProgramDialect::LinuxCnc, 0.0);
    const auto trial = ProgramTrial::run(
        workpiece, "G7 G21 G97 S600 M3\nG0 X2 Z5\nG1 Z0 F120\nG0 X44\nG0 Z5\nG0 X36\nG1 Z-50 F120\nG0 X44\nG0 Z5\nM2\n",
        setup, kSpacing);
    QVERIFY(trial && trial.value()->part());
    QCOMPARE(trial.value()->collisionCount(), std::size_t(0));
    const TurnedProfile& part = trial.value()->part()->profile;
    QCOMPARE(radiusAt(part, 99.0), 1.0);  // down to 97 mm
    QCOMPARE(radiusAt(part, 97.2), 1.0);
    QCOMPARE(radiusAt(part, 96.8), 18.0);
    QCOMPARE(radiusAt(part, 47.2), 18.0);
    QCOMPARE(radiusAt(part, 46.8), 20.0);
    workpiece.part = trial.value()->part();
    const auto written = passesProgram(workpiece, ProgramDialect::LinuxCnc, {});
    QVERIFY(written.hasValue());
    workpiece.part = nullptr;
    const auto again = ProgramTrial::run(workpiece, written->text, setup, kSpacing);
    QVERIFY(again && again.value()->part());
    const TurnedProfile& repeated = again.value()->part()->profile;
    for (std::size_t i = 0; i < part.size(); ++i) QVERIFY(std::abs(repeated.radius(i) - part.radius(i)) < 2e-3);
  }

  // The part at a position of the path: in the middle of the cut the tip is at z = -24, 76 mm above the lower end.
  void thePartUpToALine() {
    const WorkpieceSnapshot workpiece = freshBar();
    const auto trial = tried(kTurn, workpiece);
    QVERIFY(trial != nullptr);
    const ProgramPosition cutting = trial->steps().previous(trial->steps().afterLine(3));
    QCOMPARE(trial->steps().moveAt(cutting).line, 3u);
    const auto half = trial->at({cutting.done, 0.5});
    QVERIFY(half.has_value());
    QVERIFY(std::abs(radiusAt(half->profile, 77.0) - 18.0) < 1e-9 &&
            std::abs(radiusAt(half->profile, 75.0) - 20.0) < 1e-9);
    QVERIFY(trial->at({})->profile == TurnedProfile(workpiece.stock, kSpacing));
    QVERIFY(trial->at(trial->steps().end())->profile == trial->part()->profile);
  }

  // A path of many moves, of which few versions are kept: at each position the part is the result of the moves before
  // it.
  void everyPlaceOfALongPath() {
    std::string text = "G7 G21 S600 M3\nG0 X44 Z1\n";
    for (int i = 0; i < 350; ++i)
      text += "G1 X" + std::to_string(39.0 - 0.01 * i) + " Z" + std::to_string(-0.2 * i) + " F500\n";
    text += "M2\n";
    const auto trial = tried(text.c_str(), freshBar());
    QVERIFY(trial != nullptr);
    ProgramSimulation simulation(TurnedProfile(freshBar().stock, kSpacing), trial->path(), trial->setup());
    do {
      if (simulation.done() % 7 != 0) continue;
      QVERIFY(trial->at({simulation.done(), 0.0})->profile == simulation.part());
    } while (simulation.step());
  }

  // A retracting drill is still a drill, and a tool that leaves its thread cuts nothing: in the middle of the
  // retraction the part is unchanged.
  void halfTheWayBack_data() {
    QTest::addColumn<QString>("cuts");
    QTest::addColumn<double>("nose");
    QTest::addColumn<int>("line");
    QTest::newRow("a drill") << "G0 X0 Z2\nG1 Z-20 F100\nG0 Z2\nM2\n" << 5.0 << 4;
    QTest::newRow("a thread") << "G0 X44 Z5\nG0 X37\nG33 Z-20 K1.5\nG0 X44\nM2\n" << 0.2 << 5;
  }
  void halfTheWayBack() {
    QFETCH(QString, cuts);
    QFETCH(double, nose);
    QFETCH(int, line);
    const auto trial = tried(("G7 G21 G97 S600 M3\n" + cuts).toStdString().c_str(), freshBar(), nose);
    QVERIFY(trial && trial->collisionCount() == 0);
    const ProgramPosition leaving = trial->steps().previous(trial->steps().afterLine(static_cast<std::uint32_t>(line)));
    QCOMPARE(trial->steps().moveAt(leaving).line, static_cast<std::uint32_t>(line));
    const auto before = trial->at({leaving.done, 0.0}), half = trial->at({leaving.done, 0.5});
    QVERIFY(before && half && half->profile == before->profile);
    QVERIFY(before->profile == trial->part()->profile);
  }

  // Collisions of a program are recorded as by the manual lathe, at the points of its path.
  void collisionsAsCrashes_data() {
    QTest::addColumn<QString>("cuts");
    QTest::addColumn<int>("cause");
    QTest::addColumn<int>("struck");
    const auto row = [](const char* name, const char* cuts, CrashCause cause, LathePart struck) {
      QTest::newRow(name) << QString(cuts) << static_cast<int>(cause) << static_cast<int>(struck);
    };
    row("at rest", "M5\nG0 X36 Z2\nG1 Z-50 F120\n", CrashCause::SpindleAtRest, LathePart::Work);
    row("rapid", "M3\nG0 X36 Z2\nG0 Z-50\n", CrashCause::Rapid, LathePart::Work);
    row("chuck", "M3\nG0 X36 Z2\nG1 Z-85 F120\n", CrashCause::Contact, LathePart::Chuck);
  }
  void collisionsAsCrashes() {
    QFETCH(QString, cuts);
    QFETCH(int, cause);
    QFETCH(int, struck);
    const std::string text = ("G7 G21 G97 S600\n" + cuts + "G0 X44\nM2\n").toStdString();
    const auto trial = tried(text.c_str(), freshBar());
    QVERIFY(trial && trial->part());
    QCOMPARE(trial->crashes().size(), std::size_t{1});
    const LatheCollision crash = trial->crashes().front();
    QCOMPARE(static_cast<int>(crash.cause), cause);
    QCOMPARE(static_cast<int>(crash.struck), struck);
    const auto& path = trial->part()->passes.back()->path;
    QVERIFY(std::find(path.begin(), path.end(), crash.position) != path.end());
    // position of the first cut
    QVERIFY(crash.position.x() == 18.0 && crash.position.y() < 100.0 && crash.position.y() > 80.0);
    QVERIFY(crash.time > 0.0 && crash.time <= trial->path().time);
  }

  void whatCannotRunIsSaid() {
    const ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, freshBar().stock, 20.0, 0.0);
    const auto refused = ProgramTrial::run(freshBar(), "G68\n", setup, kSpacing);
    QVERIFY(!refused && refused.error().code == ProgramError::Refused);
    const auto beside = tried("G0 X60 Z2\nG1 Z-10 F100\nM2\n", freshBar());
    QVERIFY(beside && !beside->part() && beside->removed() == 0.0);
    JobState state;
    state.cancelled = true;
    const auto cancelled = ProgramTrial::run(freshBar(), kTurn, setup, kSpacing, Progress(state));
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
  }

  // The passes of a program, written as a program, make the same part.
  void passesAsAProgram() {
    WorkpieceSnapshot workpiece = freshBar();
    QVERIFY(passesProgram(workpiece, ProgramDialect::LinuxCnc, {}).error().code == WorkpieceError::NoPasses);
    workpiece.part = tried(kTurn, workpiece)->part();
    const auto program = passesProgram(workpiece, ProgramDialect::LinuxCnc, {});
    QVERIFY(bool(program));
    QCOMPARE(program->tools.size(), std::size_t{1});
    QCOMPARE(program->tools.at(1).noseRadius, 0.0);
    const auto again = tried(program->text.c_str(), freshBar());
    QVERIFY(again && again->part());
    const TurnedProfile &a = workpiece.part->profile, &b = again->part()->profile;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const bool isShoulder = std::abs(a.z(i) - 50.0) < 2.0 * kSpacing;
      QVERIFY2(isShoulder || std::abs(a.radius(i) - b.radius(i)) < 2e-3, qPrintable(QString::number(a.z(i))));
    }
  }

  // A pass that no program can repeat is left out by name, and the others are written: here 0.5 mm before and after
  // abrasive paper.
  void passesThatAreLeftOut() {
    WorkpieceSnapshot workpiece = freshBar();
    const auto along = [](double r, const char* tool) {
      TurningPass pass;
      pass.noseRadius = tool ? 0.0 : 0.4;
      if (tool) pass.tool = toolNamed(shippedLatheTools(), tool);
      pass.path = {{r + pass.noseRadius, 105.0}, {r + pass.noseRadius, 60.0}};
      pass.times = {0.0, 20.0};
      pass.speeds = {600.0, 600.0};
      return pass;
    };
    workpiece.part =
        withPasses(workpiece, {along(19.5, nullptr), along(19.4995, "paper-120"), along(19.0, nullptr)}, kSpacing);
    const auto program = passesProgram(workpiece, ProgramDialect::LinuxCnc, {});
    QVERIFY(program && program->leftOut.size() == 1);
    QVERIFY(program->leftOut[0].number == 2 && program->leftOut[0].reason == PassRefusal::Abrasive);
    QVERIFY2(program->text.find("(left out: Pass 2, P120: A file") != std::string::npos, program->text.c_str());
    ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, workpiece.stock, 20.0, 0.0);
    setup.tools = program->tools;
    const auto again = ProgramTrial::run(freshBar(), program->text, setup, kSpacing);
    QVERIFY(again && again.value()->part());
    QVERIFY(std::abs(radiusAt(again.value()->part()->profile, 80.0) - 19.0) < 1e-3);
    workpiece.part = withPasses(freshBar(), {along(19.9995, "paper-120")}, kSpacing);
    QVERIFY(passesProgram(workpiece, ProgramDialect::LinuxCnc, {}).error().code == WorkpieceError::OtherTools);
  }

  // Passes of a bore, too, with the tools that come with the program: a hole of 10 mm, 20 mm deep.
  void boredPassesAsAProgram() {
    WorkpieceSnapshot workpiece = freshBar();
    const auto drilled = tried("G7 G21 G97 S600 M3\nG0 X0 Z2\nG1 Z-20 F100\nG0 Z2\nM2\n", workpiece, 5.0);
    QVERIFY(drilled && drilled->part());
    workpiece.part = drilled->part();
    for (const ProgramDialect dialect : {ProgramDialect::LinuxCnc, ProgramDialect::Fanuc}) {
      const auto program = passesProgram(workpiece, dialect, {});
      QVERIFY(bool(program));
      ProgramSetup setup = usualSetup(dialect, workpiece.stock, 20.0, 0.0);
      setup.tools = program->tools;
      const auto again = ProgramTrial::run(freshBar(), program->text, setup, kSpacing);
      QVERIFY(again && again.value()->part());
      QCOMPARE(again.value()->collisionCount(), std::size_t(0));
      const TurnedProfile& part = again.value()->part()->profile;
      QVERIFY(std::abs(part.inner(static_cast<std::size_t>(std::lround(90.0 / kSpacing))) - 5.0) < 2e-3);
      QCOMPARE(part.inner(static_cast<std::size_t>(std::lround(79.9 / kSpacing))), 0.0);
    }
  }
};

HANDWHEEL_TEST(ProgramTrialTest)
#include "ProgramTrialTest.moc"
