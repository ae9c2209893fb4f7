// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseKind.h"

#include "TestClass.h"
#include "TurningExercises.h"
#include "document/Container.h"
#include "document/container/UnknownPart.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseJson.h"
#include "document/exercise/ExerciseProperties.h"
#include "document/exercise/ExerciseRows.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <rapidcheck.h>

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <map>

using namespace handwheel;
using namespace handwheel::test;
using Json = nlohmann::json;

namespace {

const ExerciseKind& kindUnderTest() {
  static const ExerciseKind kKind(turningOnly());
  return kKind;
}

std::shared_ptr<const ExerciseSnapshot> savedAndLoaded(const ExerciseSnapshot& exercise, std::vector<Error>& damage) {
  Container container;
  kindUnderTest().save(exercise, container);
  const auto bytes = writeContainer(container, Compression::Fast);
  if (!bytes) return nullptr;
  const auto read = readContainer(*bytes);
  if (!read) return nullptr;
  const auto loaded = kindUnderTest().load(read->container, damage, {});
  return loaded ? std::static_pointer_cast<const ExerciseSnapshot>(loaded.value()) : nullptr;
}

Container savedAs(const ExerciseSnapshot& exercise) {
  Container container;
  kindUnderTest().save(exercise, container);
  return container;
}

bool isSame(const Container& a, const Container& b) {
  return *a.manifest == *b.manifest && a.blobs == b.blobs;
}

std::string anyText() {
  static const char* const kTexts[] = {"", "⌀20", "\"a\"; b", "line\nline", "Größe", "a|b"};
  return kTexts[*rc::gen::inRange<std::size_t>(0, std::size(kTexts))];
}

double anyNumber() {
  return *rc::gen::inRange(-1'000'000, 1'000'001) / 1024.0;
}

Exercise anyExercise() {
  Exercise exercise;
  exercise.title = anyText();
  exercise.text = anyText();
  exercise.allowedSeconds = std::abs(anyNumber());
  const int criteria = *rc::gen::inRange(0, 6), steps = *rc::gen::inRange(0, 4);
  for (int i = 0; i < criteria; ++i) {
    MarkingCriterion c;
    c.id = "c" + std::to_string(i);
    c.name = anyText();
    c.figure = *rc::gen::element<std::string>("diameter", "time", "force", "unheard-of");
    for (int k = *rc::gen::inRange(0, 5); k > 0; --k) c.arguments.push_back(anyNumber());
    if (*rc::gen::arbitrary<bool>()) c.nominal = anyNumber();
    if (*rc::gen::arbitrary<bool>()) c.lower = anyNumber();
    if (*rc::gen::arbitrary<bool>()) c.upper = c.lower.value_or(0.0) + std::abs(anyNumber());
    c.tolerance = c.lower || c.upper ? anyText() : "";
    c.points = std::abs(anyNumber());
    c.slack = std::abs(anyNumber());
    c.isHidden = *rc::gen::arbitrary<bool>();
    c.isDecisive = *rc::gen::arbitrary<bool>();
    exercise.criteria.push_back(c);
  }
  for (int i = 0; i < steps; ++i) {
    ExerciseStep step{anyText(), anyText(), {anyText(), anyText()}, {}};
    if (criteria > 0) step.criteria.push_back("c" + std::to_string(*rc::gen::inRange(0, criteria)));
    exercise.steps.push_back(step);
  }
  return exercise;
}

Json exportedJson(const ExerciseSnapshot& exercise) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("exported.exercise.json");
  if (!kindUnderTest().exportTo(exercise, path.toStdString(), {})) return {};
  QFile file(path);
  return file.open(QFile::ReadOnly) ? Json::parse(file.readAll().toStdString()) : Json();
}

// Adds unknown keys to some of the objects of a description.
Json withUnknownKeys(Json json) {
  const auto add = [](Json& object) {
    static const Json kValues[] = {7, "text", Json::array({1, {{"a", nullptr}}}), Json::object({{"b", true}}), nullptr};
    for (int k = *rc::gen::inRange(0, 3); k > 0; --k)
      object["x-" + std::to_string(k)] = kValues[*rc::gen::inRange<std::size_t>(0, std::size(kValues))];
  };
  add(json);
  add(json["task"]);
  add(json["task"]["target"]);
  for (Json& tool : json["task"]["tools"]) add(tool);
  for (Json& row : json["criteria"]) add(row);
  for (Json& row : json["steps"]) add(row);
  return json;
}

// The path of each such key with its value.
std::map<std::string, Json> unknownOf(const Json& json, const std::string& at = {}) {
  std::map<std::string, Json> all;
  for (const auto& [key, value] : json.items()) {
    const std::string path = at + "/" + key;
    if (key.starts_with("x-"))
      all[path] = value;
    else if (value.is_structured())
      all.merge(unknownOf(value, path));
  }
  return all;
}

}  // namespace

// Exercises in files: whole ones come back the same, damaged ones as far as they can.
class ExerciseKindTest : public QObject {
  Q_OBJECT

 private slots:
  // A description is a file like any other: written, recognised, and imported as the same exercise.
  void descriptionsAreFiles() {
    const ExerciseKind& kind = kindUnderTest();
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("shoulder.exercise.json").toStdString();
    const auto exercise = exerciseFrom(kind, shoulderDescription());
    QVERIFY(kind.exportTo(*exercise, path, {}).hasValue());
    const auto opened = kind.import(path, {}, {});
    QVERIFY(opened.hasValue() && opened->kind == &kind && opened->file.damage.empty());
    QVERIFY(isSame(savedAs(static_cast<const ExerciseSnapshot&>(*opened->content)), savedAs(*exercise)));
    OpenedFile copy = *opened;
    QCOMPARE(kind.make(std::move(copy))->snapshot(), opened->content);

    QVERIFY(kind.recognises(R"({"subject": "turning"})", "a.exercise.json"));
    QVERIFY(!kind.recognises(R"({"subject": "turning"})", "a.json") && !kind.recognises("{}", "a.exercise.json"));
    const std::filesystem::path damaged = folder.filePath("damaged.exercise.json").toStdString();
    QCOMPARE(kind.import(damaged, {}, {}).error().code, ErrorCode::FileMissing);
    QFile file(damaged);
    QVERIFY(file.open(QFile::WriteOnly) && file.write("{\"subject\": ") > 0);
    file.close();
    const Error error = kind.import(damaged, {}, {}).error();
    QVERIFY(error.code == ErrorCode::ElementMalformed && error.subject == damaged.string());
  }

  // Each format that is offered can be written, but for a PDF without a window; no other is.
  void drawingsOfTheTarget() {
    const ExerciseKind& kind = kindUnderTest();
    const QTemporaryDir folder;
    const auto exercise = exerciseFrom(kind, shoulderDescription());
    std::vector<std::string> written;
    for (const FileFormat& format : kind.formats()) {
      QVERIFY(format.writes);
      for (const std::string& ending : format.endings) {
        const std::filesystem::path path = folder.filePath("drawing").toStdString() + ending;
        if (kind.exportTo(*exercise, path, {})) written.push_back(ending);
        QCOMPARE(std::filesystem::exists(path), ending != ".pdf");
      }
    }
    std::sort(written.begin(), written.end());
    QCOMPARE(written, (std::vector<std::string>{".dxf", ".exercise.json", ".svg"}));
  }

  void comesBackTheSame() {
    QVERIFY(rc::check("what is saved is loaded", [] {
      ExerciseSnapshot exercise = *exerciseFrom(kindUnderTest(), shoulderDescription());
      exercise.exercise = anyExercise();
      exercise.isForStudents = *rc::gen::arbitrary<bool>();
      if (*rc::gen::arbitrary<bool>())
        exercise.attempt = Attempt{anyText(), "2026-01-01T00:00:00Z", "", 12.5, {0, 2}, {true, false}};
      std::vector<Error> damage;
      const auto loaded = savedAndLoaded(exercise, damage);
      RC_ASSERT(loaded && damage.empty());
      RC_ASSERT(toJson(loaded->exercise) == toJson(exercise.exercise));
      RC_ASSERT(loaded->attempt == exercise.attempt && loaded->isForStudents == exercise.isForStudents);
      RC_ASSERT(loaded->key == exercise.key);
      RC_ASSERT(isSame(savedAs(*loaded), savedAs(exercise)));
    }));
  }

  void solutionAndWorkAreDocumentsWithin() {
    Json description = shoulderDescription();
    description["solution"] = shoulderWork();
    ExerciseSnapshot exercise = *exerciseFrom(kindUnderTest(), description);
    exercise.work = workFrom(exercise, shoulderWork(31.0, 0.2, 60.0, 2));
    std::vector<Error> damage;
    const auto loaded = savedAndLoaded(exercise, damage);
    QVERIFY(loaded && damage.empty() && loaded->solution && loaded->work);
    const auto profileIn = [](const SnapshotPointer& work) {
      return static_cast<const WorkpieceSnapshot&>(*work).part->profile;
    };
    QVERIFY(profileIn(loaded->solution) == profileIn(exercise.solution));
    QVERIFY(profileIn(loaded->work) == profileIn(exercise.work));
    QVERIFY(!(profileIn(loaded->work) == profileIn(loaded->solution)));
    // A blob that is lost costs the part, not the exercise: passes give it back.
    Container container = savedAs(exercise);
    container.blobs.erase("exercise/work/workpiece/radii/0000");
    const auto mended = kindUnderTest().load(container, damage, {});
    QVERIFY(mended && !damage.empty());
    QVERIFY(profileIn(static_cast<const ExerciseSnapshot&>(**mended).work) == profileIn(exercise.work));
  }

  // Nothing of the answers is in the bytes of a student's copy.
  void aStudentsCopyHasNoAnswers() {
    Json description = shoulderDescription();
    description["solution"] = shoulderWork();
    const ExerciseSnapshot copy = forStudents(*exerciseFrom(kindUnderTest(), description));
    const Container container = savedAs(copy);
    QVERIFY(container.blobs.empty());
    const Json& document = (*container.manifest)["document"];
    QVERIFY(document["solution"].is_null() && document["work"].is_null() && document["for_students"].get<bool>());
    for (const Json& c : document["criteria"]) {
      QVERIFY(c["points"] == 0.0 && c["slack"] == 0.0 && c["hidden"] == false);
      QVERIFY(c["id"] != "force");
    }
    QVERIFY(hasNoAnswers(copy.exercise));
  }

  void damagedFiles() {
    const Container whole = savedAs(*exerciseFrom(kindUnderTest(), shoulderDescription()));
    const auto damageOf = [&](const Json& patch) {
      Container container = whole;
      (*container.manifest)["document"].merge_patch(patch);
      std::vector<Error> damage;
      const auto loaded = kindUnderTest().load(container, damage, {});
      if (!loaded) return std::size_t{0};
      // It is saved and loaded without loss.
      std::vector<Error> none;
      const auto again = savedAndLoaded(static_cast<const ExerciseSnapshot&>(**loaded), none);
      return again && none.empty() ? damage.size() : std::size_t{0};
    };
    QVERIFY(damageOf({{"task", 3}}) > 0);
    QVERIFY(damageOf({{"task", {{"diameter", -1}}}}) > 0);
    QVERIFY(damageOf({{"task", {{"diameter", "x"}}}}) > 0);
    QVERIFY(damageOf({{"task", {{"material", "kryptonite"}}}}) > 0);
    QVERIFY(damageOf({{"task", {{"target", {{"outer", {1, 2}}}}}}}) > 0);
    QVERIFY(damageOf({{"task", {{"tools", {3, {{"nose_radius", -1}}}}}}}) > 0);
    QVERIFY(damageOf({{"criteria", {3, Json::object()}}}) > 0);
    QVERIFY(damageOf({{"criteria", Json::array({{{"id", "a b"}}})}}) > 0);
    QVERIFY(damageOf({{"steps", Json::array({{{"criteria", {"none"}}}})}}) > 0);
    QVERIFY(damageOf({{"allowed_seconds", -5}}) > 0);
    QVERIFY(damageOf({{"attempt", {{"seconds", -5}}}}) > 0);
    QVERIFY(damageOf({{"work", 7}}) > 0);
    QVERIFY(damageOf({{"key", std::string(1000, 'x')}}) > 0);
    // A number of rows that no teacher writes.
    QVERIFY(damageOf({{"steps", Json::array()}, {"criteria", std::vector<Json>(100'000, {{"id", "a"}})}}) > 0);

    std::vector<Error> damage;
    Container other = whole;
    (*other.manifest)["document"]["subject"] = "knitting";
    const auto unknown = kindUnderTest().load(other, damage, {});
    QVERIFY(!unknown && unknown.error().code == ExerciseError::SubjectUnknown);
    other.manifest->erase("document");
    QVERIFY(!kindUnderTest().load(other, damage, {}));
  }

  void descriptions() {
    Json description = shoulderDescription();
    const auto exercise = exerciseFrom(kindUnderTest(), description);
    QCOMPARE(exercise->exercise.points(), 25.0);
    const MarkingCriterion& d = exercise->exercise.criteria[0];
    QVERIFY(d.upper == 30.0 && std::abs(*d.lower - 29.916) < 1e-12);  // h10 of 30 mm
    QCOMPARE(exercise->exercise.criteria[2].upper.value(), 3.2);      // N8
    QVERIFY(!exercise->key.empty());
    QVERIFY(!kindUnderTest().fromDescription(Json(), {}));
    QVERIFY(!kindUnderTest().fromDescription({{"subject", "turning"}}, {}));  // no task
    description["criteria"][0]["points"] = -1;
    QVERIFY(!kindUnderTest().fromDescription(description, {}));
    description = shoulderDescription();
    description["solution"] = {{"passes", {{{"points", {{1, "x"}}}}}}};
    QVERIFY(!kindUnderTest().fromDescription(description, {}));
    // A written description can be read again.
    const Json written = ExerciseKind::description(*exercise);
    QVERIFY(toJson(exerciseFrom(kindUnderTest(), written)->exercise) == toJson(exercise->exercise));
    // A description without a key gets the key of the submissions for it; a copy for students stays one.
    QCOMPARE(exerciseFrom(kindUnderTest(), shoulderDescription())->key, exercise->key);
    const auto copy = exerciseFrom(kindUnderTest(), ExerciseKind::description(forStudents(*exercise)));
    QVERIFY(copy->isForStudents && copy->key == exercise->key);
    Json other = shoulderDescription();
    other["task"]["diameter"] = 41;
    QVERIFY(exerciseFrom(kindUnderTest(), other)->key != exercise->key);
  }

  // Saving a description that was opened loses neither its model solution, nor unknown keys.
  void aDescriptionIsSavedWhereItCameFrom() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("shoulder.exercise.json").toStdString();
    Json description = shoulderDescription();
    description["solution"] = shoulderWork();
    description["solution"]["passes"].push_back({{"nose_radius", 0.4},
                                                 {"feed", 0.07},
                                                 {"points", {{16, 103}, {15, 90}}},
                                                 {"thread", {{"pitch", 2.5}, {"starts", 2u}, {"hand", "left"}}}});
    description["faults"] = {{"loses", "d"}};
    const auto before = exerciseFrom(kindUnderTest(), description);
    const auto written = kindUnderTest().exportTo(*before, path, {});
    QVERIFY(written && written->notes.empty());
    QFile file(QString::fromStdString(path.string()));
    QVERIFY(file.open(QFile::ReadOnly));
    const Json read = Json::parse(file.readAll().toStdString());
    QVERIFY(read["faults"] == description["faults"]);
    QVERIFY2(read["solution"] == description["solution"], read["solution"].dump().c_str());
    // From a container it is described again.
    Json& given = description["solution"]["passes"];
    for (Json& pass : given)
      if (!pass.contains("side")) pass["side"] = "outside";
    std::vector<Error> damage;
    const auto stored = savedAndLoaded(*before, damage);
    QVERIFY(stored && damage.empty());
    const Json anew = exportedJson(*stored);
    QVERIFY2(anew["solution"]["passes"] == given, anew["solution"].dump().c_str());
    const auto opened = kindUnderTest().import(path, {}, {});
    QVERIFY(opened);
    const auto& after = static_cast<const ExerciseSnapshot&>(*opened->content);
    QVERIFY(after.solution && after.key == before->key);
    QVERIFY(!forStudents(after).others);
    // Work by hand is no list of passes at one feed: the file does without, and says so.
    ExerciseSnapshot byHand = *before;
    WorkpieceSnapshot work = static_cast<const WorkpieceSnapshot&>(*before->solution);
    TurnedPart part = *work.part;
    TurningPass slower = *part.passes.front();
    slower.times[1] *= 1.5;
    part.passes.push_back(std::make_shared<const TurningPass>(slower));
    work.part = std::make_shared<const TurnedPart>(part);
    byHand.solution = std::make_shared<const WorkpieceSnapshot>(work);
    const auto lossy = kindUnderTest().exportTo(byHand, path, {});
    QVERIFY(lossy && lossy->notes.size() == 1 && lossy->notes.front().isLoss);
    QVERIFY(lossy->isExport && !written->isExport);
  }

  // Unknown keys at any level are there again after an autosave, edits of other fields and Save.
  void nothingUnknownIsLost() {
    QVERIFY(rc::check("unknown keys come back", [] {
      const Json given = withUnknownKeys(shoulderDescription());
      ExerciseSnapshot exercise = *exerciseFrom(kindUnderTest(), given);
      if (*rc::gen::arbitrary<bool>()) {
        std::vector<Error> damage;
        const auto loaded = savedAndLoaded(exercise, damage);
        RC_ASSERT(loaded && damage.empty());
        exercise = *loaded;
      }
      if (*rc::gen::arbitrary<bool>()) exercise = withExerciseProperty(exercise, "criterion.d.points", 7.0).value();
      const Json written = exportedJson(exercise);
      RC_ASSERT(unknownOf(written) == unknownOf(given));
      // Rows that move take theirs along, and students get none.
      const Json moved = exportedJson(withMovedCriterion(exercise, 0, false));
      RC_ASSERT(unknownOf(moved["criteria"][1]) == unknownOf(given["criteria"][0]));
      const auto ofStudents = unknownOf(exportedJson(forStudents(exercise)));
      RC_ASSERT(std::all_of(ofStudents.begin(), ofStudents.end(),
                            [](const auto& each) { return each.first.starts_with("/task/tools/"); }));
    }));
  }

  // A class that is not known must not become full marks for everybody.
  void tolerancesThatAreNotKnown() {
    const auto isTaken = [](const Json& criterion) {
      Json description = shoulderDescription();
      description["criteria"][0].merge_patch(criterion);
      return kindUnderTest().fromDescription(description, {}).hasValue();
    };
    QVERIFY(isTaken({{"tolerance", "h9"}}));
    for (const char* unknown : {"K7", "r6", "IT4", "h13", "N7", "±x", "±-1"})
      QVERIFY2(!isTaken({{"tolerance", unknown}}), unknown);
    QVERIFY(!isTaken({{"nominal", 130}, {"arguments", {62, 99}}}));  // beyond the tables
    QVERIFY(!isTaken({{"tolerance", ""}}));                          // points without a limit
    QVERIFY(isTaken({{"tolerance", ""}, {"points", 0}}));
    QVERIFY(!isTaken({{"figure", "roughness"}, {"tolerance", "h7"}}));
    QVERIFY(isTaken({{"figure", "roughness"}, {"tolerance", "N7"}}));
    // In a container it is damage.
    Container container = savedAs(*exerciseFrom(kindUnderTest(), shoulderDescription()));
    Json& d = (*container.manifest)["document"]["criteria"][0];
    d["tolerance"] = "K7";
    d["lower"] = d["upper"] = nullptr;
    std::vector<Error> damage;
    QVERIFY(kindUnderTest().load(container, damage, {}) && damage.size() == 1);
  }

  void blankOnesAreSaved() {
    const auto blank = std::static_pointer_cast<const ExerciseSnapshot>(kindUnderTest().blank());
    std::vector<Error> damage;
    QVERIFY(savedAndLoaded(*blank, damage) && damage.empty());
    QVERIFY(!kindUnderTest().display(*blank).parts.empty());
    QVERIFY(kindUnderTest().describe(*blank)["points"] == 0.0);
  }
};

HANDWHEEL_TEST(ExerciseKindTest)
#include "ExerciseKindTest.moc"
