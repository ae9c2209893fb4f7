// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseDocument.h"

#include "TestClass.h"
#include "TurningExercises.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseJson.h"
#include "document/exercise/ExerciseProperties.h"
#include "document/exercise/ExerciseRows.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const ExerciseKind& kindOfDocument() {
  static const ExerciseKind kKind(turningOnly());
  return kKind;
}

std::unique_ptr<ExerciseDocument> documentOf(SnapshotPointer content) {
  OpenedFile opened;
  opened.kind = &kindOfDocument();
  opened.content = std::move(content);
  return std::make_unique<ExerciseDocument>(std::move(opened));
}

std::unique_ptr<ExerciseDocument> shoulderDocument() {
  return documentOf(exerciseFrom(kindOfDocument(), shoulderDescription()));
}

}  // namespace

// A teacher changes an exercise by its properties, with undo; a student's copy stays as it is.
class ExerciseDocumentTest : public QObject {
  Q_OBJECT

 private slots:
  // Criteria measured on the target move with it, in the same undo step: 3 mm for facing instead of none, and a part
  // that is 3 mm further down gets the same measures.
  void placesMoveWithTheTarget() {
    const auto document = shoulderDocument();
    const auto positionsOf = [&](const char* id) { return document->exercise().exercise.find(id)->arguments; };
    QVERIFY(document->setProperty("facing_allowance", 3.0));
    QCOMPARE(positionsOf("d"), (std::vector{59.0, 96.0}));
    QCOMPARE(positionsOf("l"), (std::vector{17.0, 57.0, 5.0, 97.0}));  // radii stay
    QCOMPARE(positionsOf("ra"), (std::vector{59.0, 96.0}));
    QVERIFY(positionsOf("force").empty());
    QCOMPARE(document->history()->count(), 1);
    nlohmann::json passes = shoulderWork();
    for (nlohmann::json& pass : passes["passes"])
      for (nlohmann::json& point : pass["points"]) point[1] = point[1].get<double>() - 3.0;
    // Its face first, from the outside to the axis: the nose is at Z 97.
    const nlohmann::json facing = {
        {"nose_radius", 0.8}, {"feed", 0.2}, {"points", {{23.0, 97.8}, {0.0, 97.8}, {0.0, 104.0}}}};
    passes["passes"].insert(passes["passes"].begin(), facing);
    const ExerciseSnapshot& moved = document->exercise();
    const Marking marking = markWork(moved, *workFrom(moved, passes), {"Bob", {}, {}, 300.0, {}, {}});
    for (const char* id : {"d", "l", "ra"}) {
      const Mark& mark = *marking.find(id);
      QVERIFY2(mark.points == mark.of, (std::string(id) + ": " + mark.reason.inEnglish()).c_str());
    }
    document->history()->undo();
    QCOMPARE(positionsOf("d"), (std::vector{62.0, 99.0}));
    QCOMPARE(positionsOf("l"), (std::vector{17.0, 60.0, 5.0, 100.0}));
    // A change that does not move the target moves no position.
    QVERIFY(document->setProperty("length", 110.0));
    QCOMPARE(positionsOf("d"), (std::vector{62.0, 99.0}));
  }

  // Every property can be set to its own value, and to another, and undone.
  void everyPropertyIsSetAndUndone() {
    const auto document = shoulderDocument();
    const nlohmann::json before = ExerciseKind::description(document->exercise());
    std::size_t changed = 0;
    for (const Property& property : document->properties()) {
      QVERIFY2(document->setProperty(property.id, property.value), property.id.c_str());
      QVERIFY2(!document->history()->canUndo(), property.id.c_str());
      PropertyValue other = property.value;
      if (auto* number = std::get_if<double>(&other)) *number = *number > 0.0 ? 0.5 * *number : 1.0;
      if (auto* flag = std::get_if<bool>(&other)) *flag = !*flag;
      if (property.id.ends_with(".lower")) other = std::string("-3.5");
      if (property.id.ends_with(".upper")) other = std::string("1000.5");
      if (property.id.ends_with(".criteria")) other = std::string("40 ±0.2; ⌀30 h10");
      if (property.id.ends_with(".nominal")) other = std::string("50");
      if (property.id.ends_with(".tolerance")) {
        if (property.id != "criterion.d.tolerance") continue;  // aToleranceIsItsLimits
        other = std::string("h11");
      }
      if (other == property.value && std::holds_alternative<std::string>(other)) other = std::string("another text");
      if (!property.editable || property.id == "display_unit") continue;
      if (!property.choices.empty()) other = std::get<double>(property.value) == 0.0 ? 1.0 : 0.0;
      QVERIFY2(document->setProperty(property.id, other), property.id.c_str());
      const auto now = document->property(property.id);
      QVERIFY2(now && now->value == other, property.id.c_str());
      document->history()->undo();
      QVERIFY(ExerciseKind::description(document->exercise()) == before);
      document->history()->clear();
      ++changed;
    }
    QVERIFY(changed > 60);
  }

  // A drag is one undo step, however often the value changes meanwhile; a drag of another criterion is another step.
  void aDragIsOneStep() {
    const auto document = shoulderDocument();
    const auto dragTo = [&](const char* id, double position, DragPhase phase) {
      ExerciseSnapshot exercise = document->exercise();
      for (MarkingCriterion& c : exercise.exercise.criteria)
        if (c.id == id) c.arguments[0] = position;
      document->change("Move", std::move(exercise), id, phase);
    };
    const auto positionOf = [&](const char* id) { return document->exercise().exercise.find(id)->arguments[0]; };
    for (const double position : {63.0, 64.0, 65.0}) dragTo("d", position, DragPhase::Continues);
    dragTo("d", 66.0, DragPhase::Ends);
    QCOMPARE(document->history()->count(), 1);
    dragTo("d", 67.0, DragPhase::Continues);
    dragTo("ra", 70.0, DragPhase::Ends);
    QCOMPARE(document->history()->count(), 3);
    for (int i = 0; i < 2; ++i) document->history()->undo();
    QVERIFY(positionOf("d") == 66.0 && positionOf("ra") == 62.0);
    document->history()->undo();
    QCOMPARE(positionOf("d"), 62.0);
  }

  // The size of an undo step includes its texts, which are not shared.
  void whatAStepHolds() {
    ExerciseSnapshot exercise = shoulderDocument()->exercise();
    const std::size_t before = ExerciseEdit(exercise).bytes();
    exercise.exercise.text += std::string(10'000, 'x');
    exercise.exercise.steps.push_back({"Measure", std::string(5000, 'y'), {std::string(2000, 'z')}, {}});
    const std::size_t after = ExerciseEdit(exercise).bytes();
    QVERIFY(after >= before + 17'000 && after < before + 18'000);
  }

  // An unknown figure of a newer version is unchanged; its positions can be set as a list.
  void aFigureThatIsNotKnown() {
    nlohmann::json description = shoulderDescription();
    description["criteria"].push_back(
        {{"id", "new"}, {"figure", "waviness"}, {"arguments", {62.5, 99.0}}, {"upper", 1.0}});
    const auto document = documentOf(exerciseFrom(kindOfDocument(), description));
    QVERIFY(!document->property("criterion.new.figure")->problem.empty());
    QVERIFY(document->property("criterion.new.arguments")->value == PropertyValue(std::string("62.5; 99")));
    QVERIFY(document->setProperty("criterion.new.arguments", std::string(" 61;98.25 ")));
    QCOMPARE(document->exercise().exercise.find("new")->arguments, (std::vector{61.0, 98.25}));
    QVERIFY(!document->setProperty("criterion.new.arguments", std::string("61; wide")));
    QVERIFY(!document->setProperty("criterion.new.arguments", 61.0));
    QVERIFY(!document->setProperty("criterion.new.hidden", 1.0) && !document->setProperty("allowed_minutes", true));
    QCOMPARE(document->exercise().exercise.find("new")->figure, std::string("waviness"));
  }

  // Time and collisions are on no drawing: they have no nominal size.
  void sizesOfADrawingAlone() {
    const auto document = shoulderDocument();
    for (const char* each : {"d", "l", "ra"})
      QVERIFY2(document->property(std::string("criterion.") + each + ".nominal").has_value(), each);
    for (const char* each : {"crash", "force", "time"}) {
      const std::string criterion = std::string("criterion.") + each;
      QVERIFY2(!document->property(criterion + ".nominal") && !document->property(criterion + ".tolerance"), each);
      QVERIFY2(document->property(criterion + ".upper").has_value(), each);
    }
    QVERIFY(!document->setProperty("criterion.time.nominal", std::string("5")));
  }

  void whatIsRefused() {
    const auto document = shoulderDocument();
    const auto refuses = [&](const char* id, const PropertyValue& value) { return !document->setProperty(id, value); };
    QVERIFY(refuses("criterion.d.lower", std::string("31")));  // above the upper one
    QVERIFY(refuses("criterion.d.lower", std::string("x")));
    QVERIFY(refuses("criterion.d.lower", std::string("1; 2")));
    QVERIFY(refuses("criterion.d.points", -1.0));
    QVERIFY(refuses("criterion.d.points", std::nan("")));
    QVERIFY(refuses("criterion.d.points", std::string("3")));
    QVERIFY(refuses("criterion.d.figure", 99.0));
    QVERIFY(refuses("criterion.d.at1", std::string("75")));
    QVERIFY(refuses("criterion.d.at1", std::nan("")));
    QVERIFY(refuses("criterion.d.at3", 1.0));  // a diameter has two
    QVERIFY(refuses("criterion.none.points", 1.0));
    QVERIFY(refuses("step.1.criteria", std::string("none")));
    QVERIFY(refuses("step.9.title", std::string("x")));
    QVERIFY(refuses("title", std::string("\xff")));
    QVERIFY(refuses("title", std::string(100'000, 'x')));
    QVERIFY(refuses("allowed_minutes", -1.0));
    QVERIFY(refuses("diameter", 0.0));
    QVERIFY(refuses("material", 1000.0));
    QVERIFY(!document->history()->canUndo());
  }

  // A refusal names the field as the panel does.
  void refusalsNameTheField() {
    const auto document = shoulderDocument();
    const auto field = [&](const char* id, const PropertyValue& value) {
      const Status set = document->setProperty(id, value);
      return set ? std::string() : set.error().arguments.at(0);
    };
    QCOMPARE(field("criterion.d.nominal", std::string("x")), std::string("⌀30 h10, Nominal size (mm)"));
    QCOMPARE(field("criterion.d.tolerance", std::string("K7")), std::string("⌀30 h10, Tolerance on the drawing"));
    // If one of several marks is unknown, the error has that one, and the known ones.
    const Status unknown = document->setProperty("step.2.criteria", std::string("⌀30 h10; none; N8"));
    QVERIFY(!unknown && unknown.error().code == ExerciseError::MarkUnknown);
    QCOMPARE(unknown.error().arguments[0], std::string("2. Finish"));
    QCOMPARE(unknown.error().arguments[1], std::string("none"));
    QVERIFY(unknown.error().arguments[2].find("⌀30 h10; 40 ±0.2; N8") == 0);
    QCOMPARE(field("diameter", 0.0).find("diameter"), std::string::npos);
    // For a file: by the teacher's name, and by the id that the file has.
    MarkingCriterion c;
    c.id = "c2";
    c.lower = 2.0;
    c.upper = 1.0;
    Exercise exercise;
    exercise.criteria = {c};
    QCOMPARE(checkExercise(exercise).error().arguments.at(0), std::string("criterion c2"));
    exercise.criteria[0].name = "Length";
    QCOMPARE(checkExercise(exercise).error().arguments.at(0), std::string("criterion “Length” (c2)"));
  }

  // ISO 286-1: IT10 of 18 to 30 mm is 84 µm, IT7 21 µm, of 30 to 50 mm 25 µm.
  void aToleranceIsItsLimits() {
    const auto document = shoulderDocument();
    const auto limits = [&](const char* id) {
      const MarkingCriterion* c = document->exercise().exercise.find(id);
      return std::pair(c->lower.value_or(-1.0), c->upper.value_or(-1.0));
    };
    const auto isNear = [](std::pair<double, double> a, double lower, double upper) {
      return std::abs(a.first - lower) < 1e-9 && std::abs(a.second - upper) < 1e-9;
    };
    const auto sets = [&](const char* id, const char* text) {
      return document->setProperty(id, std::string(text)).hasValue();
    };
    QVERIFY(isNear(limits("d"), 29.916, 30.0));
    QVERIFY(sets("criterion.d.tolerance", "h7") && isNear(limits("d"), 29.979, 30.0));
    QVERIFY(sets("criterion.d.nominal", "40") && isNear(limits("d"), 39.975, 40.0));
    QVERIFY(sets("criterion.d.tolerance", "±0.2") && isNear(limits("d"), 39.8, 40.2));
    // Accepts signs of a keyboard; the drawing gets the proper sign.
    for (const char* const typed : {"+-0.3", "+/-0.3", "+- 0.3"}) {
      QVERIFY(sets("criterion.d.tolerance", typed) && isNear(limits("d"), 39.7, 40.3));
      QCOMPARE(std::get<std::string>(document->property("criterion.d.tolerance")->value), std::string("±0.3"));
      QVERIFY(sets("criterion.d.tolerance", "±0.2"));
    }
    QVERIFY(!sets("criterion.d.tolerance", "+-x") && !sets("criterion.d.tolerance", "+-"));
    QVERIFY(!sets("criterion.d.tolerance", "K7") && !sets("criterion.d.tolerance", "N7") &&
            !sets("criterion.d.tolerance", "h13") && isNear(limits("d"), 39.8, 40.2));
    // Accepts a size in front, as on the drawing, if it is the nominal size: h7 of 40 mm is 25 µm.
    for (const char* const written : {"40 h7", "⌀40 h7", "Ø 40h7"}) {
      QVERIFY(sets("criterion.d.tolerance", written) && isNear(limits("d"), 39.975, 40.0));
      QCOMPARE(document->exercise().exercise.find("d")->tolerance, std::string("h7"));
      QVERIFY(sets("criterion.d.tolerance", "±0.2"));
    }
    QVERIFY(!sets("criterion.d.tolerance", "28 h7") && isNear(limits("d"), 39.8, 40.2));
    QVERIFY(!sets("criterion.d.nominal", ""));  // the tolerance needs it
    QVERIFY(sets("criterion.d.lower", "39.9") && isNear(limits("d"), 39.9, 40.2));
    QVERIFY(document->exercise().exercise.find("d")->tolerance.empty());  // it is another one now
    QVERIFY(sets("criterion.ra.tolerance", "N7") && document->exercise().exercise.find("ra")->upper == 1.6);
    QVERIFY(!sets("criterion.ra.tolerance", "h7") && !sets("criterion.crash.tolerance", "h7"));
    // A new one: a teacher types the nominal size and the class.
    document->change(QStringLiteral("Add"),
                     withNewCriterion(document->exercise(), measurementTypes(*document->exercise().subject)[0]));
    QVERIFY(!sets("criterion.c1.tolerance", "h10"));
    QVERIFY(sets("criterion.c1.nominal", "25") && sets("criterion.c1.tolerance", "h10"));
    QVERIFY(isNear(limits("c1"), 24.916, 25.0));
    // Points without a limit are an oversight, and shown as one.
    document->change(QStringLiteral("Add"),
                     withNewCriterion(document->exercise(), measurementTypes(*document->exercise().subject)[0]));
    QVERIFY(!document->property("criterion.c2.points")->problem.empty());
    QVERIFY(document->property("criterion.c1.points")->problem.empty());
  }

  // The position of a measurement has a field for each number, labelled with its meaning; limits show their unit.
  void fieldsSayWhatTheyTake() {
    const auto document = shoulderDocument();
    QVERIFY(document->property("criterion.d.at1")->label.starts_with("From Z (on the drawing "));
    QVERIFY(document->property("criterion.d.at1")->quantity == Quantity::Length);
    QVERIFY(document->property("criterion.l.at4") && !document->property("criterion.l.at5"));
    QVERIFY(!document->property("criterion.crash.at1"));
    QCOMPARE(document->property("criterion.d.upper")->label, std::string("Upper limit (mm)"));
    // Times in minutes, as that of the task is: 600 s are 10 min.
    QCOMPARE(document->property("criterion.time.upper")->label, std::string("Upper limit (min)"));
    QVERIFY(document->property("criterion.time.upper")->value == PropertyValue(std::string("10")));
    QVERIFY(document->property("criterion.time.slack")->value == PropertyValue(10.0));
    QVERIFY(document->setProperty("criterion.time.upper", std::string("12.5")));
    QCOMPARE(*document->exercise().exercise.find("time")->upper, 750.0);
    QCOMPARE(document->property("criterion.crash.upper")->label, std::string("Upper limit"));
    QVERIFY(document->property("criterion.d.at2")->problem.empty());
    QVERIFY(document->setProperty("criterion.d.at2", 61.0));  // below the first: it says so, and can be mended
    QVERIFY(!document->property("criterion.d.at2")->problem.empty());
    QVERIFY(document->setProperty("criterion.d.at1", 50.0));
    QVERIFY(document->property("criterion.d.at2")->problem.empty());
    // A length is measured elsewhere than a diameter.
    QVERIFY(document->setProperty("criterion.d.figure", 2.0));
    QVERIFY(document->property("criterion.d.at4") && !document->property("criterion.d.at4")->problem.empty());
  }

  void rowsComeAndGo() {
    ExerciseSnapshot exercise = shoulderDocument()->exercise();
    const std::size_t before = exercise.exercise.criteria.size();
    exercise = withNewCriterion(exercise, measurementTypes(*exercise.subject)[0]);
    exercise = withNewStep(withNewCriterion(exercise, measurementTypes(*exercise.subject)[2]));
    QVERIFY(exercise.exercise.criteria.size() == before + 2 && checkExercise(exercise.exercise));
    QCOMPARE(exercise.exercise.criteria.back().arguments.size(), std::size_t{4});
    exercise = withoutCriterion(exercise, "d");
    QVERIFY(checkExercise(exercise.exercise) &&
            exercise.exercise.steps[1].criteria == std::vector<std::string>{"force"});
    const auto order = [](const ExerciseSnapshot& of) {
      std::string ids;
      for (const MarkingCriterion& c : of.exercise.criteria) ids += c.id + ' ';
      return ids;
    };
    const std::string ordered = order(exercise);
    QVERIFY(ordered.starts_with("l ra crash "));
    QVERIFY(order(withMovedCriterion(exercise, 1, true)).starts_with("ra l crash "));
    QVERIFY(order(withMovedCriterion(exercise, 1, false)).starts_with("l crash ra "));
    QCOMPARE(order(withMovedCriterion(exercise, 0, true)), ordered);
    QCOMPARE(order(withMovedCriterion(exercise, exercise.exercise.criteria.size() - 1, false)), ordered);
    QCOMPARE(withMovedStep(exercise, 0, false).exercise.steps[1].title, exercise.exercise.steps[0].title);
    exercise = withoutStep(withoutStep(exercise, 0), 7);
    QCOMPARE(exercise.exercise.steps.size(), std::size_t{2});

    const auto document = shoulderDocument();
    document->change(QStringLiteral("Add"), withNewStep(document->exercise()));
    QCOMPARE(document->exercise().exercise.steps.size(), std::size_t{3});
    document->history()->undo();
    QCOMPARE(document->exercise().exercise.steps.size(), std::size_t{2});
  }

  void aStudentsCopyStays() {
    const auto copy = documentOf(std::make_shared<const ExerciseSnapshot>(forStudents(shoulderDocument()->exercise())));
    for (const Property& property : exerciseProperties(copy->exercise())) {
      QVERIFY2(!property.editable, property.id.c_str());
      const auto edit = copy->propertyEdit(property.id, property.value);
      QVERIFY(!edit && edit.error().code == ExerciseError::Fixed);
    }
  }
};

HANDWHEEL_TEST(ExerciseDocumentTest)
#include "ExerciseDocumentTest.moc"
