// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurningExercises.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/exercise/TurningMeasurements.h"
#include "document/workpiece/exercise/TurningTask.h"
#include "machining/force/WorkMaterials.h"
#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheMachine.h"
#include "machining/lathe/LatheMounting.h"
#include "machining/measure/RoughnessGrade.h"
#include "machining/target/TargetDeviation.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <set>

using namespace handwheel;
using namespace handwheel::test;
using Json = nlohmann::json;

namespace {

const ExerciseKind& turningKind() {
  static const ExerciseKind kKind(turningOnly());
  return kKind;
}

std::shared_ptr<const ExerciseSnapshot> shoulder() {
  static const auto kExercise = exerciseFrom(turningKind(), shoulderDescription());
  return kExercise;
}

Marking marked(const Json& work, const Attempt& attempt = {"Bob", {}, {}, 300.0, {}, {}}) {
  return markWork(*shoulder(), *workFrom(*shoulder(), work), attempt);
}

// The criteria that did not get all of their points.
std::set<std::string> lostIn(const Marking& marking) {
  std::set<std::string> lost;
  for (const Mark& mark : marking.marks) {
    if (mark.points < mark.of) lost.insert(mark.criterion);
  }
  return lost;
}

using Names = std::set<std::string>;

}  // namespace

// Work on an exercise of turning is measured and marked.
class TurningExerciseTest : public QObject {
  Q_OBJECT

 private slots:
  void goodWorkGetsAllPoints() {
    const Marking marking = marked(shoulderWork());
    for (const Mark& mark : marking.marks)
      QVERIFY2(mark.points == mark.of, (mark.criterion + ": " + mark.reason.inEnglish()).c_str());
    QCOMPARE(marking.points, 25.0);
    QVERIFY(std::abs(*marking.find("d")->value - 29.95) < 1e-9);
    QVERIFY(std::abs(*marking.find("l")->value - 40.0) < 0.05);
    QVERIFY(std::abs(*marking.find("ra")->value - 1000.0 * 0.04 / (32 * 0.8)) < 1e-6);
  }

  // Each fault loses its own marks and no others.
  void eachFaultLosesItsMarks() {
    const Marking small = marked(shoulderWork(29.9));
    QCOMPARE(lostIn(small), Names{"d"});
    QVERIFY(std::abs(small.find("d")->points - 8.4) < 1e-9);  // 0.016 beyond, of 0.1
    QCOMPARE(lostIn(marked(shoulderWork(30.2))), Names{"d"});
    QCOMPARE(lostIn(marked(shoulderWork(29.95, 0.4))), Names{"ra"});
    QCOMPARE(lostIn(marked(shoulderWork(29.95, 0.2, 61.0))), Names{"l"});
    QCOMPARE(lostIn(marked(shoulderWork(29.95, 0.2, 60.0, 1))), Names{"force"});
    Json rammed = shoulderWork();
    rammed["passes"].push_back({{"nose_radius", 0.8}, {"feed", 0.5}, {"points", {{20.3, 50}, {20.3, 20}}}});
    const Marking crashed = marked(rammed);
    QCOMPARE(lostIn(crashed), Names{"crash"});
    QCOMPARE(crashed.find("crash")->points, 2.0);
    QCOMPARE(lostIn(marked(shoulderWork(), {"Bob", {}, {}, 900.0, {}, {}})), Names{"time"});
  }

  void nothingDone() {
    const Marking marking = marked({{"passes", Json::array()}});
    QCOMPARE(lostIn(marking), (Names{"d", "l", "ra", "crash", "force"}));  // no marks for care alone
    QVERIFY(marking.find("d")->verdict == Verdict::TooLarge);
    QVERIFY(marking.find("l")->verdict == Verdict::NotMeasured);
    QVERIFY(!marking.find("l")->remark.inEnglish().empty());
  }

  // A file whose part does not match its passes is detected.
  void aPartThatWasChangedInTheFile() {
    WorkpieceSnapshot forged = static_cast<const WorkpieceSnapshot&>(*workFrom(*shoulder(), shoulderWork(31.0)));
    const auto honest = workFrom(*shoulder(), shoulderWork());
    TurnedPart part = *forged.part;
    part.profile = static_cast<const WorkpieceSnapshot&>(*honest).part->profile;
    forged.part = std::make_shared<const TurnedPart>(part);
    const Marking marking = markWork(*shoulder(), forged, {});
    QCOMPARE(marking.points, 1.0);  // the time
    QVERIFY(marking.find("d")->remark.inEnglish().find("passes") != std::string::npos);
  }

  // The roughness is that which is kept along the part: one that is finer than its passes leave is found out; where an
  // older program kept none, it is that of the passes.
  void theFinishThatIsKept() {
    WorkpieceSnapshot work = static_cast<const WorkpieceSnapshot&>(*workFrom(*shoulder(), shoulderWork()));
    const double honest = *markWork(*shoulder(), work, {}).find("ra")->value;
    TurnedPart part = *work.part;
    part.finish = SurfaceFinish();
    work.part = std::make_shared<const TurnedPart>(part);
    QVERIFY(std::abs(*markWork(*shoulder(), work, {}).find("ra")->value - honest) < 1e-6);
    part.finish = SurfaceFinish(part.profile.size());
    for (std::size_t i = 0; i < part.profile.size(); ++i) part.finish.set(TurningSide::Outside, i, {0.1f, 0.1f, 0});
    work.part = std::make_shared<const TurnedPart>(part);
    const Marking forged = markWork(*shoulder(), work, {});
    QVERIFY(!forged.find("ra")->value && forged.find("ra")->points == 0.0);
    QVERIFY(forged.find("ra")->remark.inEnglish().find("passes") != std::string::npos);
  }

  // A shoulder that was fed too fast loses its mark for roughness, and paper gets it back.
  void paperMendsTheFinish() {
    WorkpieceSnapshot work = static_cast<const WorkpieceSnapshot&>(*workFrom(*shoulder(), shoulderWork(30.0, 0.4)));
    QVERIFY(lostIn(markWork(*shoulder(), work, {"Bob", {}, {}, 300.0, {}, {}})).contains("ra"));
    TurningPass pass;
    pass.tool = toolNamed(shippedLatheTools(), "paper-240");
    for (double z = 100.0; z >= 72.5; z -= 0.5) {
      pass.path.emplace_back(14.985, z);
      pass.times.push_back(static_cast<double>(pass.times.size()));
    }
    pass.speeds.assign(pass.path.size(), 600.0);
    work.part = withPass(work, pass, 0.05);
    const Marking marking = markWork(*shoulder(), work, {"Bob", {}, {}, 300.0, {}, {}});
    QVERIFY2(!lostIn(marking).contains("ra"), marking.find("ra")->reason.inEnglish().c_str());
  }

  void workOfAnotherBar() {
    Json other = shoulderDescription();
    other["task"]["diameter"] = 50;
    const auto exercise = exerciseFrom(turningKind(), other);
    QVERIFY(shoulder()->subject->checkWork(*shoulder()->task, *workFrom(*shoulder(), shoulderWork())));
    const Status refused =
        shoulder()->subject->checkWork(*shoulder()->task, *exercise->subject->start(*exercise->task));
    QVERIFY(!refused && refused.error().code == ExerciseError::OtherWork);
  }

  // Marking is the same every time, and by itself.
  void isDeterministic() {
    const auto work = workFrom(*shoulder(), shoulderWork(29.9, 0.35));
    const Marking first = markWork(*shoulder(), *work, {}), second = markWork(*shoulder(), *work, {});
    for (std::size_t i = 0; i < first.marks.size(); ++i) {
      QVERIFY(first.marks[i].value == second.marks[i].value && first.marks[i].points == second.marks[i].points);
      QVERIFY(first.marks[i].reason == second.marks[i].reason && first.marks[i].remark == second.marks[i].remark);
    }
  }

  // A teacher turns the target.
  void theTargetOfASolution() {
    const auto work = workFrom(*shoulder(), shoulderWork());
    const auto task = shoulder()->subject->withTarget(*shoulder()->task, *work);
    QVERIFY(task.hasValue());
    const TurningTask& turning = static_cast<const TurningTask&>(**task);
    const TurnedProfile& profile = static_cast<const WorkpieceSnapshot&>(*work).part->profile;
    QVERIFY(turning.target && deviationFrom(*turning.target, profile, 0.0).largest() < 0.01);
    QVERIFY(turning.target->segments().size() < 2'000);
  }

  // A groove through the bar: no outline of a target can say that. Bores from both ends it can.
  void aTargetIsOnePiece() {
    Json parted = shoulderWork();
    parted["passes"].push_back({{"nose_radius", 0.8}, {"feed", 0.1}, {"points", {{22, 80}, {0.0, 80}}}});
    QVERIFY(!shoulder()->subject->withTarget(*shoulder()->task, *workFrom(*shoulder(), parted)));
    Json bored = shoulderWork();
    for (const auto& [from, to] : {std::pair(101, 80), std::pair(-1, 20)})
      bored["passes"].push_back({{"nose_radius", 0.8}, {"side", "bore"}, {"points", {{4, from}, {4, to}, {0, to}}}});
    const auto work = workFrom(*shoulder(), bored);
    const auto task = shoulder()->subject->withTarget(*shoulder()->task, *work);
    QVERIFY(task.hasValue());
    const TurnedProfile& profile = static_cast<const WorkpieceSnapshot&>(*work).part->profile;
    QVERIFY(deviationFrom(*static_cast<const TurningTask&>(**task).target, profile, 0.0).largest() < 0.02);
  }

  // Submissions from before drills had a figure of their own are marked as new ones are.
  void drilledByAnOlderProgram_data() {
    QTest::addColumn<double>("feed");  // some are kept exactly in single precision, some are not
    for (const double feed : {0.1, 0.125, 0.15, 0.2, 0.35}) QTest::addRow("%g", feed) << feed;
  }
  void drilledByAnOlderProgram() {
    QFETCH(double, feed);
    Json drilled = shoulderWork();
    drilled["passes"].push_back(
        {{"nose_radius", 5}, {"side", "bore"}, {"feed", feed}, {"points", {{0, 110}, {0, 70}}}});
    const auto work = workFrom(*shoulder(), drilled);
    WorkpieceSnapshot old = static_cast<const WorkpieceSnapshot&>(*work);
    TurnedPart part = *old.part;
    std::size_t changed = 0;
    for (std::size_t i = 0; i < part.finish.size(); ++i) {
      FinishMark mark = part.finish.at(TurningSide::Bore, i);
      if (!mark.isKnown()) continue;
      mark.roughness = static_cast<float>(idealRoughness(mark.feed, 5.0));
      part.finish.set(TurningSide::Bore, i, mark);
      ++changed;
    }
    QVERIFY(changed > 100);
    old.part = std::make_shared<const TurnedPart>(part);
    const Attempt attempt{"Ada", {}, {}, 300.0, {}, {}};
    const Marking now = markWork(*shoulder(), *work, attempt), before = markWork(*shoulder(), old, attempt);
    QVERIFY(now.points > 10.0);
    QCOMPARE(before.points, now.points);
  }

  // The student uses the machine of the exercise.
  void theLatheOfTheTask() {
    const auto bar = std::static_pointer_cast<const WorkpieceSnapshot>(shoulder()->subject->start(*shoulder()->task));
    QVERIFY(bar->lathe && bar->lathe->isSound());
    QCOMPARE(bar->lathe->chuck.grip, 25.0);
    QCOMPARE(bar->lathe->chuck.diameter, 80.0);
    QCOMPARE(bar->lathe->spindle.power, 3.0);
    QCOMPARE(LatheMachine::initialState(*bar->lathe, bar->stock).setSpeed, 600.0);
    QCOMPARE(shoulder()->subject->conditions(*shoulder()->task).size(), std::size_t{5});
  }

  // A limit of 0 is none, and none is shown.
  void theLimitsOfTheTask() {
    const ExerciseSubject& subject = *shoulder()->subject;
    TaskPointer task = shoulder()->task;
    const std::size_t all = subject.conditions(*task).size();
    for (const char* const limit : {"force_limit", "power_limit"}) {
      const auto without = subject.withProperty(*task, limit, 0.0);
      QVERIFY(without.hasValue());
      task = *without;
    }
    const auto conditions = subject.conditions(*task);
    QCOMPARE(conditions.size(), all - 2);
    for (const ExerciseText& line : conditions)
      QVERIFY(!QString::fromStdString(line.text).contains("force") &&
              !QString::fromStdString(line.text).contains("power"));
  }

  // If it names tools of the lathe, these are in the post, and no others can be mounted.
  void theToolsOfTheTask() {
    Json description = shoulderDescription();
    description["task"]["tools"] =
        Json::array({Json{{"name", "roughing"}, {"nose_radius", 0.8}, {"tool", "right-roughing"}},
                     Json{{"name", "drill"}, {"nose_radius", 0.8}, {"tool", "drill-10"}}});
    const auto exercise = exerciseFrom(turningKind(), description);
    const auto bar = std::static_pointer_cast<const WorkpieceSnapshot>(exercise->subject->start(*exercise->task));
    QCOMPARE(bar->lathe->stations.size(), std::size_t{1});
    QCOMPARE(bar->lathe->stations[0].tool, std::string("right-roughing"));
    QVERIFY(isAllowed(*bar->lathe, "drill-10") && !isAllowed(*bar->lathe, "facing"));
    const auto again = latheSetupFrom(toJson(*bar->lathe));
    QVERIFY(again && *again == *bar->lathe);
    std::vector<Error> damage;
    const auto same = exercise->subject->fromJson(exercise->subject->toJson(*exercise->task), damage);
    QVERIFY(damage.empty());
    QVERIFY(static_cast<const TurningTask&>(*same).tools == static_cast<const TurningTask&>(*exercise->task).tools);
    description["task"]["tools"][0]["tool"] = "spoon";
    exercise->subject->fromJson(description["task"], damage);
    QCOMPARE(damage.size(), std::size_t{1});
  }

  // Crashes recorded by the lathe count besides those found in the passes.
  void crashesOfTheManualLathe() {
    WorkpieceSnapshot work = static_cast<const WorkpieceSnapshot&>(*workFrom(*shoulder(), shoulderWork()));
    LatheCollision crash;
    crash.cause = CrashCause::SpindleAtRest;
    crash.position = {20.0, 80.0};
    QVERIFY(addCrashes(work, std::vector{crash}));
    const Marking marking = markWork(*shoulder(), work, {"Bob", {}, {}, 300.0, {}, {}});
    QCOMPARE(lostIn(marking), Names{"crash"});
    QCOMPARE(marking.find("crash")->points, 2.0);  // one of two that cost all
    const ReportDetails details = shoulder()->subject->details(*shoulder()->task, work, {});
    QVERIFY(details.events.size() == 1 && details.events[0].text.inEnglish().find("at rest") != std::string::npos);
    QVERIFY(addCrashes(work, std::vector{crash}));
    QCOMPARE(markWork(*shoulder(), work, {"Bob", {}, {}, 300.0, {}, {}}).find("crash")->points, 0.0);
  }

  // Endless passes in the air, which prevent a review, must not hide a part that they did not cut.
  void tooMuchWorkIsNotMeasured() {
    WorkpieceSnapshot forged = static_cast<const WorkpieceSnapshot&>(*workFrom(*shoulder(), shoulderWork()));
    TurnedPart part = *forged.part;
    TurningPass air;
    air.noseRadius = 0.8;
    air.path.assign(4'000'000, {30.0, 0.0});
    for (std::size_t i = 0; i < air.path.size(); i += 2) air.path[i].y() = 100.0;
    air.times.assign(air.path.size(), 0.0);
    part.passes.push_back(std::make_shared<const TurningPass>(air));
    forged.part = std::make_shared<const TurnedPart>(part);
    const Marking marking = markWork(*shoulder(), forged, {});
    QVERIFY(marking.find("d")->verdict == Verdict::NotMeasured);
    QVERIFY(marking.find("d")->remark.inEnglish().find("too many passes") != std::string::npos);
  }

  // A wide chamfer at the end of the bar, where the radius falls: its angle has no sign until a limit is negative. The
  // range may run over its ends.
  void aChamferIsAnAngle() {
    const Json work = {
        {"passes", {{{"nose_radius", 0.8}, {"feed", 0.1}, {"points", {{15.0, 103.0}, {22.0628, 94.2}}}}}}};
    const auto marks = [&](double from, double to, double lower, double upper) {
      Json description = shoulderDescription();
      description["steps"] = Json::array();
      description["criteria"] = Json::array({Json{{"id", "c"},
                                                  {"figure", "taper"},
                                                  {"arguments", {from, to}},
                                                  {"lower", lower},
                                                  {"upper", upper},
                                                  {"points", 1}}});
      const auto exercise = exerciseFrom(turningKind(), description);
      return markWork(*exercise, *workFrom(*exercise, work), {});
    };
    // The tool goes 7.0628 mm outward over 8.8 mm. It is on the bar from Z 95.5 on.
    const double angle = std::atan2(7.0628, 8.8) * 180.0 / M_PI;
    QVERIFY(std::abs(*marks(96.5, 99.5, angle - 1, angle + 1).find("c")->value - angle) < 0.05);
    for (const auto& [from, to] : {std::pair(96.5, 99.5), std::pair(90.0, 100.0)}) {
      const Marking marking = marks(from, to, angle - 1, angle + 1);
      QVERIFY2(marking.points == 1.0, marking.find("c")->reason.inEnglish().c_str());
      QVERIFY(marks(from, to, -angle - 1, -angle + 1).points == 1.0);
      QVERIFY(marks(from, to, angle + 2, angle + 3).points == 0.0);
    }
    // The bar itself gives exactly 0, without rounding.
    QCOMPARE(*marks(30, 60, -1, 1).find("c")->value, 0.0);
  }

  // An excessive feed is not a collision, and the mark says so. The cut is so shallow that its force is within the
  // limit: 1500 · 0.3 · 2.5^0.78 · √1.49 = 1122 N.
  void aFeedTooHighIsNamed() {
    const Json work = {{"passes", {{{"nose_radius", 0.8}, {"feed", 2.5}, {"points", {{20.5, 103}, {20.5, 60}}}}}}};
    const auto snapshot = workFrom(*shoulder(), work);
    const Marking marking = markWork(*shoulder(), *snapshot, {});
    const std::string remark = marking.find("crash")->remark.inEnglish();
    QCOMPARE(*marking.find("crash")->value, 1.0);
    QVERIFY2(remark.find("2.5 mm per revolution where at most 1 is allowed; other collisions: 0") != std::string::npos,
             remark.c_str());
    const ReportDetails details = shoulder()->subject->details(*shoulder()->task, *snapshot, {});
    QCOMPARE(details.events.size(), std::size_t{1});
    QVERIFY(details.events[0].text.inEnglish().find("feed was too high") != std::string::npos);
  }

  // Positions of measurements are checked before anything is turned.
  void placesThatCannotBe() {
    const auto problem = [](const char* figure, std::vector<double> at) {
      MarkingCriterion c;
      c.figure = figure;
      c.arguments = std::move(at);
      return shoulder()->subject->positionProblem(c, *shoulder()->task);
    };
    QVERIFY(problem("diameter", {62, 99}).empty() && problem("length", {17, 60, 5, 100}).empty());
    QVERIFY(problem("crashes", {}).empty());
    for (const auto& at : std::vector<std::vector<double>>{{}, {75}, {99, 62}, {0, 0}, {-5, 50}, {50, 120}})
      QVERIFY(!problem("diameter", at).empty());
    for (const auto& at :
         std::vector<std::vector<double>>{{90, 120}, {17, 60, 25, 100}, {17, 60, 0, 100}, {17, 160, 5, 100}})
      QVERIFY(!problem("length", at).empty());
  }

  // The path of the tool is drawn where it went to cut: from the end of a pass no line leads to the next.
  void thePathHasGaps() {
    const auto work = workFrom(*shoulder(), shoulderWork());
    const std::size_t passes = static_cast<const WorkpieceSnapshot&>(*work).part->passes.size();
    const ReportDetails details = shoulder()->subject->details(*shoulder()->task, *work, {});
    const auto path = std::find_if(details.curves.begin(), details.curves.end(),
                                   [](const ReportCurve& each) { return each.title == "Path of the tool"; });
    QVERIFY(path != details.curves.end());
    const auto& points = path->series[0].points;
    QCOMPARE(std::count_if(points.begin(), points.end(), [](const auto& p) { return !std::isfinite(p.first); }),
             static_cast<std::ptrdiff_t>(passes - 1));
  }

  // Z is as on the drawing, and in the marks: the bar of 100 mm goes from the finished face to 100 mm below it.
  void plotsTellPlacesFromTheFinishedFace() {
    const auto work = workFrom(*shoulder(), shoulderWork());
    const ReportDetails details = shoulder()->subject->details(*shoulder()->task, *work, {});
    for (const ReportCurve& curve : details.curves) {
      if (curve.xUnit != "mm") continue;
      QCOMPARE(curve.x, std::string("Z from the finished face"));
      if (curve.title != "Profile") continue;
      for (const ReportCurve::Series& series : curve.series) {
        const auto [lowest, highest] = std::minmax_element(series.points.begin(), series.points.end());
        QVERIFY(std::abs(highest->first) < 1e-6 && lowest->first < -50.0 && lowest->first >= -100.0 - 1e-6);
      }
    }
  }

  // The student's bar has the target.
  void theBarHasTheTarget() {
    const auto bar = std::static_pointer_cast<const WorkpieceSnapshot>(shoulder()->subject->start(*shoulder()->task));
    QVERIFY(bar->target && bar->target->profile.largestRadius() == 20.0);
    QCOMPARE(bar->target->profile.upperEnd(), 100.0);
    QVERIFY(!static_cast<const WorkpieceSnapshot&>(
                 *turningKind().subjects()[0]->start(*turningKind().subjects()[0]->blankTask()))
                 .target);
  }

  // A teacher checks tools in a list: these are in the post, and nothing else changes.
  void toolsThatAreChecked() {
    const ExerciseSubject& subject = *shoulder()->subject;
    const std::vector<Property> properties = subject.properties(*shoulder()->task);
    std::size_t tools = 0;
    for (const Property& each : properties) tools += each.id.starts_with("tool.") && each.value == PropertyValue(false);
    QCOMPARE(tools, shippedLatheTools().size());
    const auto one = subject.withProperty(*shoulder()->task, "tool.right-roughing", true);
    QVERIFY(one.hasValue());
    const auto bar = std::static_pointer_cast<const WorkpieceSnapshot>(subject.start(**one));
    QCOMPARE(bar->lathe->allowed, std::vector<std::string>{"right-roughing"});
    QVERIFY(subject.conditions(**one).size() == subject.conditions(*shoulder()->task).size() + 1);
    QCOMPARE(subject.conditions(**one).back().text, std::string("Tool: %1, nose radius %2 mm"));
    const auto drill = subject.withProperty(*shoulder()->task, "tool.drill-10", true);
    QVERIFY(drill && subject.conditions(**drill).back().text == "Tool: %1");
    const auto none = subject.withProperty(**one, "tool.right-roughing", false);
    QVERIFY(none && subject.toJson(**none) == subject.toJson(*shoulder()->task));
    QVERIFY(!subject.withProperty(*shoulder()->task, "tool.spoon", true));
    QVERIFY(!subject.withProperty(*shoulder()->task, "tool.right-roughing", 1.0));
  }

  void everyFigureIsMeasuredOrSaysWhyNot() {
    Json description = shoulderDescription();
    Json criteria = Json::array();
    for (const MeasurementType& type : turningMeasurementTypes()) {
      std::vector<double> arguments;
      for (std::size_t i = 0; i < type.arguments.size(); ++i) arguments.push_back(i % 2 == 0 ? 10.0 : 90.0);
      criteria.push_back({{"id", type.id}, {"figure", type.id}, {"arguments", arguments}, {"upper", 1}, {"points", 1}});
      criteria.push_back({{"id", type.id + "-none"}, {"figure", type.id}, {"upper", 1}, {"points", 1}});
    }
    criteria.push_back({{"id", "odd"}, {"figure", "odd"}, {"upper", 1}, {"points", 1}});
    description["criteria"] = criteria;
    description["steps"] = Json::array();
    const auto exercise = exerciseFrom(turningKind(), description);
    for (const Json& work : {shoulderWork(), Json{{"passes", Json::array()}}}) {
      for (const Mark& mark : markWork(*exercise, *workFrom(*exercise, work), {}).marks)
        QVERIFY2(mark.value || !mark.remark.inEnglish().empty(), mark.criterion.c_str());
    }
  }

  void detailsForAReport() {
    const auto work = workFrom(*shoulder(), shoulderWork());
    const ReportDetails details = shoulder()->subject->details(*shoulder()->task, *work, {});
    // profile, path, finish, loads, and material left and cut too deep
    QCOMPARE(details.curves.size(), std::size_t{7});
    QVERIFY(std::any_of(details.curves.begin(), details.curves.end(), [](const auto& c) { return c.yUnit == "µm"; }));
    for (const ReportCurve& curve : details.curves) QVERIFY(!curve.series.empty() && !curve.series[0].points.empty());
    QVERIFY(details.events.empty() && details.seconds > 0.0);
    const ReportDetails none =
        shoulder()->subject->details(*shoulder()->task, *shoulder()->subject->start(*shoulder()->task), {});
    QCOMPARE(none.curves.size(), std::size_t{1});
    QVERIFY(none.pictures.size() == 1 && none.figures.empty());
  }

  // The bar of ⌀40 × 100 mm over its target, a shoulder of ⌀30 × 40 mm: to scale, and in the colours of material left,
  // right and cut too deep.
  void thePictureOfThePart() {
    const auto pictureOf = [](const SnapshotPointer& work) {
      return shoulder()->subject->details(*shoulder()->task, *work, {}).pictures.at(0).image;
    };
    enum { White, Grey, Blue, Red };
    const auto colour = [](QRgb p) {
      if (qBlue(p) > qRed(p) + 50) return Blue;
      if (qRed(p) > qBlue(p) + 50) return Red;
      return qRed(p) > 250 ? White : Grey;
    };
    const QImage bar = pictureOf(shoulder()->subject->start(*shoulder()->task));
    QRect box;
    for (int y = 0; y < bar.height(); ++y)
      for (int x = 0; x < bar.width(); ++x)
        if (colour(bar.pixel(x, y)) != White) box |= QRect(x, y, 1, 1);
    const double scale = box.width() / 100.0;
    QVERIFY(std::abs(box.height() - 40.0 * scale) < 4.0);  // pixels: lines are two wide
    const auto at = [&](const QImage& picture, double r, double z) {
      return int(colour(picture.pixel(box.left() + int(scale * z), (box.top() + box.bottom()) / 2 - int(scale * r))));
    };
    for (const double side : {1.0, -1.0}) {
      QCOMPARE(at(bar, side * 17.0, 80.0), int(Blue));
      QCOMPARE(at(bar, side * 17.0, 30.0), int(Grey));
      QCOMPARE(at(bar, side * 12.0, 80.0), int(Grey));
    }
    const QImage deep = pictureOf(workFrom(*shoulder(), shoulderWork(26.0)));
    QCOMPARE(at(deep, 17.0, 80.0), int(White));
    QCOMPARE(at(deep, 14.0, 80.0), int(Red));
    QCOMPARE(at(deep, 12.0, 80.0), int(Grey));
    QCOMPARE(at(deep, 17.0, 30.0), int(Grey));
    // The area of the red rectangles, on both sides of the axis: 2 mm by 40 mm, but for half of the line around them.
    int red = 0;
    for (int y = 0; y < deep.height(); ++y)
      for (int x = 0; x < deep.width(); ++x) red += colour(deep.pixel(x, y)) == Red ? 1 : 0;
    QVERIFY2(std::abs(red / (scale * scale) / 160.0 - 1.0) < 0.1, qPrintable(QString::number(red / (scale * scale))));
  }
};

HANDWHEEL_TEST(TurningExerciseTest)
#include "TurningExerciseTest.moc"
