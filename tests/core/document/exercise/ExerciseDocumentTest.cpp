// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseDocument.h"

#include "TestClass.h"
#include "TurningExercises.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseJson.h"
#include "document/exercise/ExerciseProperties.h"

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
  // Every property can be set to what it is, and to another value, and undone.
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
      if (property.id.ends_with(".arguments")) other = std::string("1; 2.5");
      if (property.id.ends_with(".lower")) other = std::string("-3.5");
      if (property.id.ends_with(".upper")) other = std::string("1000.5");
      if (property.id.ends_with(".criteria")) other = std::string("l; d");
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
    QVERIFY(refuses("criterion.d.arguments", std::string("1; nan")));
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

  void rowsComeAndGo() {
    ExerciseSnapshot exercise = shoulderDocument()->exercise();
    const std::size_t before = exercise.exercise.criteria.size();
    exercise = withNewCriterion(exercise, figureTypes(*exercise.subject)[0]);
    exercise = withNewStep(withNewCriterion(exercise, figureTypes(*exercise.subject)[2]));
    QVERIFY(exercise.exercise.criteria.size() == before + 2 && checkExercise(exercise.exercise));
    QCOMPARE(exercise.exercise.criteria.back().arguments.size(), std::size_t{4});
    exercise = withoutCriterion(exercise, "d");
    QVERIFY(checkExercise(exercise.exercise) &&
            exercise.exercise.steps[1].criteria == std::vector<std::string>{"force"});
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
