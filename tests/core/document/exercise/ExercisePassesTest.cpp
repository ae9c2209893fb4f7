// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurningExercises.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/ProgramTrial.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "machining/TurningFidelity.h"
#include "machining/lathe/LatheJson.h"

#include <QtTest>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;
using Json = nlohmann::json;

namespace {

std::shared_ptr<const ExerciseSnapshot> shoulderTask() {
  static const ExerciseKind kKind(turningOnly());
  static const auto kExercise = exerciseFrom(kKind, shoulderDescription());
  return kExercise;
}

}  // namespace

// The passes of exercises: of their descriptions, and of programs that cut the work.
class ExercisePassesTest : public QObject {
  Q_OBJECT

 private slots:
  // A program counts each of its collisions once, whether the passes show it, as they do a rapid move, or not (a
  // spindle at rest). The wrong sense of the spindle is a warning.
  void collisionsOfAProgram_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<double>("points");  // out of four: two for each collision
    const QString begin = "G7 G21 G97 S600\n", end = "G0 X50\nM2\n";
    QTest::newRow("none") << begin + "M3\nG0 X36 Z2\nG1 Z-30 F120\n" + end << 4.0;
    QTest::newRow("reversed") << begin + "M4\nG0 X36 Z2\nG1 Z-30 F120\n" + end << 4.0;
    QTest::newRow("rapid") << begin + "M3\nG0 X36 Z2\nG0 Z-30\n" + end << 2.0;
    QTest::newRow("at rest") << begin + "G0 X36 Z2\nG1 Z-30 F120\n" + end << 2.0;
    QTest::newRow("chuck") << begin + "M3\nG0 X36 Z2\nG1 Z-90 F120\n" + end << 2.0;
    QTest::newRow("two") << begin + "G0 X36 Z2\nG1 Z-30 F120\nM3\nG0 Z-40\n" + end << 0.0;
  }
  void collisionsOfAProgram() {
    QFETCH(QString, program);
    QFETCH(double, points);
    WorkpieceSnapshot work =
        static_cast<const WorkpieceSnapshot&>(*shoulderTask()->subject->start(*shoulderTask()->task));
    const ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, work.stock, latheOf(work).chuck.grip, 0.8);
    const auto trial = ProgramTrial::run(work, program.toStdString(), setup, turnSpacingSetting().standard, {});
    QVERIFY(trial && trial.value()->part());
    work.part = trial.value()->part();
    addCrashes(work, trial.value()->crashes());
    const Marking marking = markWork(*shoulderTask(), work, {"Bob", {}, {}, 300.0, {}, {}});
    QCOMPARE(marking.find("crash")->points, points);
    const ReportDetails details = shoulderTask()->subject->details(*shoulderTask()->task, work, {});
    // One for each; that such cuts are too heavy as well is said beside.
    const auto isCollision = [](const ReportEvent& event) {
      return !event.text.text.starts_with("The cut was too heavy");
    };
    QCOMPARE(std::count_if(details.events.begin(), details.events.end(), isCollision),
             static_cast<std::ptrdiff_t>((4.0 - points) / 2.0));
  }

  // A tool of the manual lathe that was fed into the jaws is one collision: the lathe records it, and the passes show
  // the tool where the jaws stopped it. It is reported at its moment of the passes, whatever the clock of the machine
  // says.
  void oneCrashOfTheManualLatheCountsOnce() {
    WorkpieceSnapshot work =
        static_cast<const WorkpieceSnapshot&>(*shoulderTask()->subject->start(*shoulderTask()->task));
    TurningPass pass;
    pass.tool = toolNamed(shippedLatheTools(), "right-roughing");
    QVERIFY(pass.tool);
    pass.path = {{18.5, 102.0}, {18.5, 24.97}, {25.0, 24.97}, {25.0, 60.0}};  // the jaws end at Z 25
    pass.times = {0.0, 38.515, 45.0, 60.0};                                   // 0.2 mm in a turn at 600 r/min, first
    pass.speeds.assign(pass.path.size(), 600.0);
    work.part = withPass(work, pass, turnSpacingSetting().standard);
    QVERIFY(work.part->passes.size() == 1);
    LatheCollision struck;
    struck.struck = LathePart::Jaws;
    struck.position = {18.5, 24.94};
    struck.tool = pass.tool->id;
    struck.time = 165.9;
    struck.passes = 1.0;
    const auto collisions = [&](std::vector<LatheCollision> recorded) {
      work.crashes = std::make_shared<const std::vector<LatheCollision>>(std::move(recorded));
      return *markWork(*shoulderTask(), work, {"Bob", {}, {}, 300.0, {}, {}}).find("crash")->value;
    };
    LatheCollision elsewhere = struck, other = struck;
    elsewhere.position = {18.5, 60.0};
    other.tool = "parting-3";
    QCOMPARE(collisions({}), 1.0);
    QCOMPARE(collisions({elsewhere}), 2.0);
    QCOMPARE(collisions({other}), 2.0);
    QCOMPARE(collisions({struck, struck}), 2.0);  // it struck twice before it was drawn back
    QCOMPARE(collisions({struck}), 1.0);
    std::vector<double> reported;
    for (const ReportEvent& event : shoulderTask()->subject->details(*shoulderTask()->task, work, {}).events)
      if (!event.text.text.starts_with("The cut was too heavy")) reported.push_back(event.seconds.value());
    QCOMPARE(reported, std::vector<double>{38.515});
  }

  // Passes along all of the bar, a thousand times the samples that are cut again: refused before they are cut.
  void passesThatTakeTooLongAreRefused() {
    Json points = Json::array();
    const double samples = 100.0 / turnSpacingSetting().standard;
    for (int i = 0; i < static_cast<int>(2.0 * static_cast<double>(kMostCutAgain) / samples); ++i)
      points.push_back({25, i % 2 == 0 ? 0 : 100});
    const Json work = {{"passes", {{{"nose_radius", 0.8}, {"points", points}}}}};
    const auto made = shoulderTask()->subject->makeWork(*shoulderTask()->task, work, {});
    QVERIFY(!made && made.error().code == ErrorCode::ElementMalformed);
    for (const Json& point : {Json{1e300, 0}, Json{0, -1e9}}) {
      const Json far = {{"passes", {{{"nose_radius", 0.8}, {"points", {{25, 0}, point}}}}}};
      QVERIFY(!shoulderTask()->subject->makeWork(*shoulderTask()->task, far, {}));
    }
  }

  // Cut at once or one by one, the passes leave the same part and finish.
  void passesAtOnce() {
    const WorkpieceSnapshot bar =
        static_cast<const WorkpieceSnapshot&>(*shoulderTask()->subject->start(*shoulderTask()->task));
    const auto made = workFrom(*shoulderTask(), shoulderWork());
    const TurnedPart& at = *static_cast<const WorkpieceSnapshot&>(*made).part;
    WorkpieceSnapshot work = bar;
    for (const auto& pass : at.passes) work.part = withPass(work, *pass, turnSpacingSetting().standard);
    QVERIFY(at.passes.size() == 4 && work.part->passes.size() == 4);
    QVERIFY(work.part->profile == at.profile && work.part->finish == at.finish);
  }
};

HANDWHEEL_TEST(ExercisePassesTest)
#include "ExercisePassesTest.moc"
