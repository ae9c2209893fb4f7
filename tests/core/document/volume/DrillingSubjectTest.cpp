// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DrillingSubject.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseKind.h"
#include "document/exercise/StartedWork.h"
#include "document/exercise/Submission.h"
#include "document/volume/exercise/DrilledHolePicture.h"
#include "document/volume/exercise/DrillingMeasurements.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/VolumeToSurface.h"

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

using namespace handwheel;
using namespace handwheel::test;
using Json = nlohmann::json;

namespace {

const ExerciseKind& drillingKind() {
  static const ExerciseKind kind([] {
    std::vector<std::unique_ptr<ExerciseSubject>> subjects;
    subjects.push_back(std::make_unique<DrillingSubject>());
    return subjects;
  }());
  return kind;
}

// A plate of 5 mm, its top at z = 0; below it a ball with its top at -9.
Json plateDescription() {
  TriangleSoup plate = cube(1.0);
  for (Vec3& p : plate.points) p = Vec3(14.0 * (p.x() - 0.5), 14.0 * (p.y() - 0.5), 5.0 * (p.z() - 1.0));
  Json json = Json::parse(R"({
    "subject": "drilling", "title": "Plate", "author": "Ada", "text": "Drill.",
    "task": {"entry": [0, 0, 0], "direction": [0, 0, -2], "tolerance": 0.5, "drill": "ball:4", "spindle_speed": 1200,
             "feed": 2, "material": "porcine-bone", "forbidden": [[0, 0, -20, 11]]},
    "criteria": [
      {"id": "in", "name": "Not in", "figure": "forbidden", "upper": 0, "points": 4, "decisive": true},
      {"id": "plunge", "name": "Plunge", "figure": "plunge", "upper": 2, "points": 3, "slack": 2},
      {"id": "path", "name": "Path", "figure": "deviation", "upper": 0.5, "points": 2},
      {"id": "through", "name": "Through", "figure": "breakthrough", "upper": 4, "points": 1}],
    "steps": []})");
  json["task"]["stock"] = *stockOf(volumeOfSurface(plate, 0.25)->volume).json();
  return json;
}

std::shared_ptr<const ExerciseSnapshot> plate() {
  static const auto made = [] {
    const Result<SnapshotPointer> read = drillingKind().fromDescription(plateDescription(), {});
    if (!read) qFatal("the description is not taken");
    return std::static_pointer_cast<const ExerciseSnapshot>(*read);
  }();
  return made;
}

// At 2 mm/s until the tip is at this depth.
Json holeTo(double depth, double beside = 0.0) {
  return Json{{"holes", {{{"points", {{0, -1, beside}, {(depth + 1) / 2, depth, beside}}}}}}};
}

SnapshotPointer workOf(const Json& holes) {
  Result<SnapshotPointer> made = plate()->subject->makeWork(*plate()->task, holes, {});
  if (!made) qFatal("the holes are not taken");
  return *made;
}

Marking marked(const SnapshotPointer& work) {
  return markWork(*plate(), *work, Attempt{"Bob", {}, {}, 60.0, {}, {}});
}

double figureOf(const Marking& marking, const char* id) {
  const Mark* const mark = marking.find(id);
  return mark->value.value_or(std::nan(""));
}

// The pixels of each colour in the picture of a work.
std::map<QRgb, double> pixelsOf(const SnapshotPointer& work) {
  const ReportDetails details = plate()->subject->details(*plate()->task, *work, {});
  if (details.pictures.size() != 1) qFatal("there is not one picture");
  const QImage& picture = details.pictures.front().image;
  std::map<QRgb, double> count;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) ++count[picture.pixel(x, y)];
  return count;
}

}  // namespace

class DrillingSubjectTest : public QObject {
  Q_OBJECT

 private slots:
  // The figures are those of the described path: 5 mm at 2 mm/s, and the part beyond.
  void figuresOfAHole() {
    const Marking good = marked(workOf(holeTo(6.5, 0.3)));
    QVERIFY(std::abs(figureOf(good, "plunge") - 1.5) < 0.02);
    QVERIFY(std::abs(figureOf(good, "path") - 0.3) < 1e-5);
    QVERIFY(std::abs(figureOf(good, "through") - 2.5) < 0.1);
    QCOMPARE(figureOf(good, "in"), 0.0);
    QCOMPARE(good.points, 10.0);
    const Marking deep = marked(workOf(holeTo(8.0)));  // 1 beyond of a slack of 2
    QVERIFY(std::abs(deep.find("plunge")->points - 1.5) < 0.03);
  }

  // Entering the forbidden region gives no points at all, with a reason.
  void intoTheForbiddenRegion() {
    const Marking failed = marked(workOf(holeTo(9.5)));
    QVERIFY(std::abs(figureOf(failed, "in") - 0.5) < 0.01);
    QCOMPARE(failed.points, 0.0);
    QCOMPARE(failed.of, 10.0);
    QCOMPARE(failed.find("path")->reason.inEnglish(), std::string("no points, because “Not in” was not met"));
  }

  // A try that went into the region and was taken back costs the mark of that region and no others, unless the
  // exercise says otherwise. What is there now is marked as ever.
  void failedTriesThatWereTakenBack() {
    const SnapshotPointer good = workOf(holeTo(6.5, 0.3)), bad = workOf(holeTo(9.5));
    const auto& deep = static_cast<const VolumeSnapshot&>(*bad);
    const auto afterFailure = [&](const SnapshotPointer& left) {
      auto work = std::make_shared<VolumeSnapshot>(static_cast<const VolumeSnapshot&>(*left));
      TriedHoles tried = withHole({}, {}, *deep.holes.front(), 0.5);  // and undone
      if (!work->holes.empty()) tried = withHole(std::move(tried), {}, *work->holes.front(), 0.0);
      work->tried = std::make_shared<const TriedHoles>(std::move(tried));
      return work;
    };
    const auto markedBy = [&](const Json& rule, const SnapshotPointer& work) {
      ExerciseSnapshot scheme = *plate();
      Json task = scheme.subject->toJson(*scheme.task);
      if (!rule.is_null()) task["failed_tries"] = rule;
      std::vector<Error> damage;
      scheme.task = scheme.subject->fromJson(task, damage);
      if (!damage.empty()) qFatal("the rule is not taken");
      return markWork(scheme, *work, Attempt());
    };
    const auto second = afterFailure(good);
    QVERIFY(plate()->subject->triesOf(*second) == std::optional<std::size_t>(2));
    const Marking marking = markedBy({}, second);
    QVERIFY(marking.find("in")->verdict == Verdict::TooLarge);
    QCOMPARE(figureOf(marking, "in"), 0.5);
    QCOMPARE(marking.find("in")->remark.inEnglish(),
             std::string("Tries that entered it and were taken back: 1 of 2, by 0.5 mm at most."));
    QCOMPARE(marking.points, 6.0);  // 10 points minus the 4 of the region
    QCOMPARE(markedBy("fail_the_work", second).points, 0.0);
    const Marking listed = markedBy("are_listed", second);
    QCOMPARE(listed.points, 10.0);
    QCOMPARE(listed.find("in")->remark.text, marking.find("in")->remark.text);

    // A final hole in the region fails the work, regardless of the tries before.
    QCOMPARE(markedBy({}, afterFailure(bad)).points, 0.0);
    const ReportDetails details = plate()->subject->details(*plate()->task, *second, {});
    QCOMPARE(details.events.front().text.inEnglish(),
             std::string("Try 1 entered the forbidden region by 0.5 mm, and was taken back."));
    // The try was before this work, which has its own time.
    QVERIFY(!details.events.front().seconds);
    QVERIFY(details.events.size() > 1 && details.events[1].seconds.value_or(-1.0) >= 0.0);
    QCOMPARE(details.figures.back().value, 2.0);
    const auto none = afterFailure(plate()->subject->start(*plate()->task));
    QCOMPARE(markedBy({}, none).points, 0.0);  // nothing is drilled
  }

  // Nothing drilled, not through, another drill, or a volume that something else has changed: it says so.
  void whatIsNotMeasured() {
    const SnapshotPointer none = plate()->subject->start(*plate()->task);
    QCOMPARE(marked(none).find("plunge")->remark.inEnglish(), std::string("Nothing was drilled."));
    QCOMPARE(marked(none).points, 0.0);
    const Marking blind = marked(workOf(holeTo(3.0)));
    QCOMPARE(blind.find("plunge")->remark.inEnglish(), std::string("The drill did not come through."));
    QCOMPARE(blind.points, 6.0);
    auto changed = std::make_shared<VolumeSnapshot>(static_cast<const VolumeSnapshot&>(*workOf(holeTo(6.5))));
    const DrillingTask& task = static_cast<const DrillingTask&>(*plate()->task);
    drill(changed->volume, task.tool, {{4.0, 4.0, 0.0}, {4.0, 4.0, -1.0}});
    QCOMPARE(marked(changed).find("plunge")->remark.inEnglish(),
             std::string("The volume was changed by something else than the drill."));
    auto other = std::make_shared<VolumeSnapshot>(static_cast<const VolumeSnapshot&>(*workOf(holeTo(6.5))));
    auto hole = std::make_shared<DrillRecord>(*other->holes.front());
    hole->setup.material.energy *= 0.5;
    other->holes = {hole};
    QCOMPARE(marked(other).find("plunge")->remark.inEnglish(),
             std::string("Another drill, speed or material was used."));
  }

  // Handed in, saved and opened, it is marked the same to the last bit.
  void savedWorkIsMarkedTheSame() {
    const SnapshotPointer work = workOf(holeTo(7.2, 0.2));
    const Attempt attempt{"Bob", "2026-11-23T08:15:00Z", {}, 60.0, {}, {}};
    const Result<ExerciseSnapshot> submitted = handedIn(*plate(), work, attempt);
    QVERIFY(submitted.hasValue());
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("work.handwheel").toStdString();
    const DocumentFile file = DocumentKinds::blank(drillingKind()).file;
    QVERIFY(saveDocument(drillingKind(), file, *submitted, path).hasValue());

    std::vector<std::unique_ptr<DocumentKind>> kinds;
    std::vector<std::unique_ptr<ExerciseSubject>> subjects;
    subjects.push_back(std::make_unique<DrillingSubject>());
    kinds.push_back(std::make_unique<ExerciseKind>(std::move(subjects)));
    const DocumentKinds known(std::move(kinds));
    const Result<OpenedFile> opened = known.open(path, {});
    QVERIFY(opened.hasValue());
    QVERIFY(opened->file.damage.empty());
    const auto& submission = static_cast<const ExerciseSnapshot&>(*opened->content);
    const Result<SubmissionRow> row = markSubmission(*plate(), submission, "work.handwheel");
    QVERIFY(row.hasValue());
    const Marking before = marked(work);
    for (const Mark& mark : row->marking.marks) QCOMPARE(mark.value, before.find(mark.criterion)->value);
    QVERIFY(row->marking.points > 0.0);

    // The report has its curves: thrust and torque with their references, depth and heat, and the breakthrough in each.
    const ReportDetails details = plate()->subject->details(*plate()->task, *submission.work, {});
    QCOMPARE(details.curves.size(), std::size_t{4});
    for (const ReportCurve& curve : details.curves) {
      QCOMPARE(curve.series.back().name, std::string("Breakthrough"));
      QVERIFY(std::abs(curve.series.back().points.front().first - 3.0) < 0.02);
    }
    QVERIFY(std::any_of(details.events.begin(), details.events.end(),
                        [](const ReportEvent& e) { return e.text.inEnglish().find("Breakthrough") == 0; }));
  }

  // The picture is to scale. The plate is 14 mm by 5; the ball of 4 mm, its tip at 6.5, takes 2 · 2 · 4.5 mm² of it and
  // what is above the bottom of the ball's lower half: 2 ∫₀^½ √(4 − s²) ds. Lines hide some of that.
  void pictureOfAHole() {
    constexpr double kEnd = 0.994785;  // mm², ∫₀^½ √(4 − s²) ds
    constexpr double kHole = 18.0 + 2.0 * kEnd;
    auto straight = pixelsOf(workOf(holeTo(6.5)));
    const double drilled = straight[HoleColours::kDrilled], left = straight[HoleColours::kLeft];
    QVERIFY2(std::abs(drilled / (drilled + left) - kHole / 70.0) < 0.03, QByteArray::number(drilled / left));
    QVERIFY(straight[HoleColours::kBeside] < 1e-3 * drilled);
    QVERIFY(straight[HoleColours::kForbidden] > 0.0 && straight[HoleColours::kLeftForbidden] == 0.0);
    QVERIFY(straight[HoleColours::kPlanned] > 0.0 && straight[HoleColours::kPath] > 0.0);

    // 1.5 mm beside a path within 0.5 mm: what is further than 2.5 mm from the line is red, 1 mm of the hole's 4.
    auto beside = pixelsOf(workOf(holeTo(6.5, 1.5)));
    const double red = beside[HoleColours::kBeside];
    QVERIFY2(std::abs(red / (red + beside[HoleColours::kDrilled]) - (4.5 + kEnd - 0.5) / kHole) < 0.03,
             QByteArray::number(red));

    auto untouched = pixelsOf(plate()->subject->start(*plate()->task));
    QVERIFY(untouched[HoleColours::kLeft] > 0.0 && untouched[HoleColours::kPlanned] > 0.0);
    QCOMPARE(untouched[HoleColours::kDrilled] + untouched[HoleColours::kBeside] + untouched[HoleColours::kPath], 0.0);
  }

  // The peaks that a report tells are those of its curves.
  void peaksOfAHole() {
    const ReportDetails details = plate()->subject->details(*plate()->task, *workOf(holeTo(6.5)), {});
    QCOMPARE(details.figures.size(), std::size_t{4});
    QCOMPARE(details.figures[3].figure, std::string("tries"));
    QCOMPARE(details.figures[3].value, 1.0);
    const auto curve = [&](std::size_t i) { return details.curves[i == 2 ? 3 : i].series.front().points; };
    const std::vector<MeasurementType> types = plate()->subject->figures();
    for (const ReportMeasurement& each : details.figures) QVERIFY(measurementType(types, each.figure) != nullptr);
    for (std::size_t i = 0; i < 3; ++i) {
      double largest = 0.0;
      for (const auto& point : curve(i)) largest = std::max(largest, point.second);
      QCOMPARE(details.figures[i].value, largest);
    }
    QVERIFY(plate()->subject->details(*plate()->task, *plate()->subject->start(*plate()->task), {}).figures.empty());
  }

  // The reference is parallel to ours: deep in the material, its thrust and torque are those of the balance of energy.
  void referenceAgreesDeepInside() {
    const ReportDetails details = plate()->subject->details(*plate()->task, *workOf(holeTo(6.5)), {});
    for (std::size_t i = 0; i < 2; ++i) {
      const auto at = [&](std::size_t series, double time) {
        const auto& points = details.curves[i].series[series].points;
        double sum = 0.0;
        int count = 0;
        for (const auto& p : points)
          if (std::abs(p.first - time) < 0.3) {
            sum += p.second;
            ++count;
          }
        return sum / count;
      };
      QVERIFY(std::abs(at(0, 2.2) / at(1, 2.2) - 1.0) < 0.05);
    }
  }

  // Each property is what the task has then, and comes back from files; what is impossible is refused.
  void propertiesOfTheTask() {
    const ExerciseSubject& subject = *plate()->subject;
    TaskPointer task = plate()->task;
    const auto set = [&](const char* id, const PropertyValue& value) {
      const Result<TaskPointer> changed = subject.withProperty(*task, id, value);
      if (changed) task = *changed;
      return changed.hasValue();
    };
    QVERIFY(set("entry", std::string("1; 2.5; -3")));
    QVERIFY(set("direction", std::string("0; 3; 4")));
    QVERIFY(set("forbidden", std::string("0; 0; 0; 5 | 1; 2; 3; 4")));
    QVERIFY(set("drill", std::string("twist:3.2")));
    QVERIFY(set("tolerance", 0.7));
    QVERIFY(set("failed_tries", 2.0));
    for (const auto& [id, wrong] :
         std::initializer_list<std::pair<const char*, PropertyValue>>{{"entry", std::string("1; 2")},
                                                                      {"entry", std::string("a; b; c")},
                                                                      {"direction", std::string("0; 0; 0")},
                                                                      {"forbidden", std::string("0; 0; 0; -1")},
                                                                      {"drill", std::string("laser:3")},
                                                                      {"tolerance", -1.0},
                                                                      {"material", 1e9},
                                                                      {"failed_tries", 3.0},
                                                                      {"nothing", 1.0}})
      QVERIFY2(!set(id, wrong), id);
    std::vector<Error> damage;
    const TaskPointer read = subject.fromJson(subject.toJson(*task), damage);
    QVERIFY(damage.empty());
    const DrillPlan& plan = static_cast<const DrillingTask&>(*read).plan;
    QCOMPARE(plan.entry, Vec3(1.0, 2.5, -3.0));
    QVERIFY((plan.direction - Vec3(0.0, 0.6, 0.8)).norm() < 1e-12);
    QCOMPARE(plan.forbidden.size(), std::size_t{2});
    QCOMPARE(plan.tolerance, 0.7);
    QVERIFY(static_cast<const DrillingTask&>(*read).failedTries == FailedTries::AreListed);
    QCOMPARE(static_cast<const DrillingTask&>(*read).tool.diameter, 3.2);
    QCOMPARE(static_cast<const DrillingTask&>(*read).volume().material(),
             static_cast<const DrillingTask&>(*plate()->task).volume().material());
  }

  // A hole becomes the planned path; another volume becomes the stock.
  void targetAndStockOfATeacher() {
    const Result<TaskPointer> taken = plate()->subject->withTarget(*plate()->task, *workOf(holeTo(6.5, 1.0)));
    QVERIFY(taken.hasValue());
    const DrillPlan& plan = static_cast<const DrillingTask&>(**taken).plan;
    QVERIFY(std::abs(plan.entry.z()) < 0.02 && std::abs(plan.entry.head<2>().norm() - 1.0) < 1e-5);
    QVERIFY((plan.direction + Vec3::UnitZ()).norm() < 1e-6);
    const Result<TaskPointer> none =
        plate()->subject->withTarget(*plate()->task, *plate()->subject->start(*plate()->task));
    QVERIFY(!none && none.error().code == ExerciseError::NothingDrilled);

    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("ball.handwheel").toStdString();
    VolumeSnapshot ball;
    ball.volume = ballOfVoxels(8.0, 0.5);
    const VolumeKind kind;
    QVERIFY(saveDocument(kind, DocumentKinds::blank(kind).file, ball, path).hasValue());
    const auto imported = plate()->subject->withImportedTarget(*plate()->task, path, {}, {});
    QVERIFY(imported.hasValue());
    QCOMPARE(static_cast<const DrillingTask&>(*imported->task).volume().material(), ball.volume.material());
    QVERIFY(!plate()->subject->checkWork(*imported->task, *workOf(holeTo(6.5))));
  }

  // A wall of two voxels over 200 is shown as it is, whole: in larger voxels it could be torn.
  void thinStockIsShownWhole() {
    TriangleSoup plate = cube(1.0);
    for (Vec3& p : plate.points) p = Vec3(50.0 * p.x(), 50.0 * p.y(), 0.5 * p.z());
    const SparseVolume volume = volumeOfSurface(plate, 0.25)->volume;
    const TriangleSoup shown = *stockOf(volume).shown(), whole = surfaceOf(volume);
    QCOMPARE(shown.points, whole.points);
    QVERIFY(shown.triangles == whole.triangles);
    const Result<DrillingStock> read = stockFrom(*stockOf(volume).json());
    QVERIFY(read.hasValue());
    QCOMPARE(read->shown()->points, whole.points);
  }

  // The displayed surface of a stock is made once for all copies and threads.
  void shownStockIsMadeOnce() {
    const DrillingStock stock = stockOf(ballOfVoxels(8.0, 0.5)), copy = stock;
    std::shared_ptr<const TriangleSoup> first, second;
    std::thread other([&] { first = stock.shown(); });
    second = copy.shown();
    other.join();
    QVERIFY(first && !first->triangles.empty());
    QCOMPARE(second, first);
    QCOMPARE(stock.shown(), first);
    QVERIFY(stockFrom(*stock.json())->shown() != first);
  }

  // The document in which a student works contains all that the drill needs.
  void assignedTask() {
    const auto task = assignedDrilling(assignmentOf(*plate(), Attempt()));
    QVERIFY(task != nullptr);
    QCOMPARE(task->plan.tolerance, 0.5);
    QCOMPARE(task->material, std::string("porcine-bone"));
    QVERIFY(!assignedDrilling({}));
  }

  void hostileDescriptions() {
    for (const char* const holes :
         {"null", "[]", R"({"holes": 3})", R"({"holes": [[0, 1]]})", R"({"holes": [{"points": [[1, 0], [0, 0]]}]})",
          R"({"holes": [{"points": [[0, 1e9]]}]})", R"({"holes": [{"points": [["a", 1]]}]})"})
      QVERIFY2(!plate()->subject->makeWork(*plate()->task, Json::parse(holes), {}), holes);
    for (const char* const task : {R"({"stock": {"voxel": 1, "origin": [0, 0, 0], "data": "////AAAA"}})",
                                   R"({"stock": 5})", R"({"entry": [0, 0]})", R"({"direction": [0, 0, 0]})",
                                   R"({"forbidden": [[1, 2, 3]]})", R"({"tolerance": "x"})", R"({"drill": "ball"})",
                                   R"({"material": "cheese"})", R"({"failed_tries": "never"})", "[]"}) {
      std::vector<Error> damage;
      plate()->subject->fromJson(Json::parse(task), damage);
      QVERIFY2(!damage.empty(), task);
    }
  }
};

HANDWHEEL_TEST(DrillingSubjectTest)
#include "DrillingSubjectTest.moc"
