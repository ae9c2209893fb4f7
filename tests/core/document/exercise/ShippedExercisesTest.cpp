// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "TestClass.h"
#include "TurningExercises.h"
#include "base/JsonText.h"
#include "base/NumberText.h"
#include "document/FileBytes.h"
#include "document/exercise/ExerciseProperties.h"
#include "document/exercise/ExerciseRows.h"
#include "document/exercise/ShippedExercises.h"
#include "document/volume/exercise/DrillingSubject.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "document/workpiece/exercise/ExerciseDrawing.h"
#include "document/workpiece/exercise/TurningMeasurements.h"
#include "document/workpiece/exercise/TurningTask.h"

#include <QDir>
#include <QRegularExpression>
#include <QTranslator>
#include <QtTest>
#include <algorithm>
#include <set>

using namespace handwheel;
using namespace handwheel::test;
using Json = nlohmann::json;

namespace {

using Names = std::set<std::string>;

Json descriptionIn(const QString& path) {
  const Result<std::string> text = readFileBytes(path.toStdString());
  Result<Json> json = text ? parseJson(*text, "exercise") : Result<Json>(text.error());
  return json ? *json : Json();
}

std::vector<std::unique_ptr<ExerciseSubject>> allSubjects() {
  std::vector<std::unique_ptr<ExerciseSubject>> subjects = turningOnly();
  subjects.push_back(std::make_unique<DrillingSubject>());
  return subjects;
}

Names lostMarks(const Marking& marking) {
  Names lost;
  for (const Mark& mark : marking.marks) {
    if (mark.points < mark.of) lost.insert(mark.criterion);
  }
  return lost;
}

// "Depth 39 ±0.5" is marked from 38.5 to 39.5.
bool isAsNamed(const MarkingCriterion& c) {
  static const QRegularExpression kNamed(QStringLiteral("([0-9.]+) ±([0-9.]+)$"));
  const QRegularExpressionMatch match = kNamed.match(QString::fromStdString(c.name));
  if (!match.hasMatch()) return true;
  const double nominal = match.captured(1).toDouble(), half = match.captured(2).toDouble();
  return c.lower && c.upper && std::abs(*c.lower - (nominal - half)) < 1e-9 &&
         std::abs(*c.upper - (nominal + half)) < 1e-9;
}

std::string reasons(const Marking& marking) {
  std::string text;
  for (const Mark& mark : marking.marks) {
    if (mark.points < mark.of)
      text += mark.criterion + ": " + mark.reason.inEnglish() + " (" + mark.remark.inEnglish() + ")\n";
  }
  return text;
}

}  // namespace

// The exercises that the program ships: the model solution gets all points, and each fault loses the marks that it is
// to lose, and no others.
class ShippedExercisesTest : public QObject {
  Q_OBJECT

 private slots:
  void each_data() {
    QTest::addColumn<QString>("path");
    const QDir folder(test::sourcePath("resources/samples/exercises"));
    const QStringList names = folder.entryList({"*.exercise.json"});
    QCOMPARE(names.size(), 10);
    for (const QString& name : names) QTest::addRow("%s", qPrintable(name)) << folder.filePath(name);
  }
  void each() {
    QFETCH(QString, path);
    Json description = descriptionIn(path);
    QVERIFY(description.is_object());
    description.erase("for_students");
    const ExerciseKind kind(allSubjects());
    const auto exercise = exerciseFrom(kind, description);
    QVERIFY(exercise->solution && exercise->exercise.points() > 0.0 && exercise->exercise.steps.size() >= 2);
    for (const MarkingCriterion& c : exercise->exercise.criteria) QVERIFY2(isAsNamed(c), c.name.c_str());
    for (const MarkingCriterion& c : exercise->exercise.criteria)
      QCOMPARE(exercise->subject->positionProblem(c, *exercise->task), std::string());
    const Attempt attempt{"Model", {}, {}, 600.0, {}, {}};
    const Marking solved = markWork(*exercise, *exercise->solution, attempt);
    QVERIFY2(lostMarks(solved).empty(), reasons(solved).c_str());
    QCOMPARE(solved.points, exercise->exercise.points());

    QVERIFY(description["faults"].size() >= 3);
    for (const Json& fault : description["faults"]) {
      const Marking marked =
          markWork(*exercise, *workFrom(*exercise, description["solution"].patch(fault["patch"])), attempt);
      const Names expected = fault["loses"].get<Names>();
      QVERIFY2(lostMarks(marked) == expected, (fault["name"].get<std::string>() + "\n" + reasons(marked)).c_str());
    }
  }

  // The sizes of a target are those of its model solution.
  void theirTargetsHaveSizes_data() { each_data(); }
  void theirTargetsHaveSizes() {
    QFETCH(QString, path);
    Json description = descriptionIn(path);
    description.erase("for_students");
    const ExerciseKind kind(allSubjects());
    ExerciseSnapshot exercise = *exerciseFrom(kind, description);
    exercise.exercise.criteria.clear();
    exercise.exercise.steps.clear();
    const std::vector<MarkingCriterion> sizes = unmarkedSizes(exercise);
    if (exercise.subject->id() != "turning" || !static_cast<const TurningTask&>(*exercise.task).target) {
      QVERIFY(sizes.empty());
      return;
    }
    QVERIFY(!sizes.empty());
    const ExerciseSnapshot marked = withCriteria(exercise, sizes);
    for (const MarkingCriterion& c : marked.exercise.criteria) {
      QVERIFY(c.lower && c.upper && c.nominal.has_value() == (c.figure != "profile") && !c.id.empty());
      QCOMPARE(exercise.subject->positionProblem(c, *exercise.task), std::string());
    }
    const Marking solved = markWork(marked, *exercise.solution, Attempt{"Model", {}, {}, 600.0, {}, {}});
    QVERIFY2(lostMarks(solved).empty(), reasons(solved).c_str());
    QVERIFY(unmarkedSizes(marked).empty());
  }

  // Each text of the files is one that is translated, and there is none beside them.
  void theirTextsAreTranslated() {
    std::set<std::string> inFiles;
    const auto add = [&](const std::string& text) {
      static const QRegularExpression kWord(QStringLiteral("[^\\W\\d_]{3,}"),
                                            QRegularExpression::UseUnicodePropertiesOption);
      if (kWord.match(QString::fromStdString(text)).hasMatch()) inFiles.insert(text);
    };
    const QDir folder(test::sourcePath("resources/samples/exercises"));
    for (const QString& name : folder.entryList({"*.exercise.json"})) {
      const Json json = descriptionIn(folder.filePath(name));
      QVERIFY(json["key"].get<std::string>().starts_with("handwheel-"));
      add(json["title"]);
      add(json["text"]);
      for (const Json& tool : json["task"].value("tools", Json::array())) add(tool["name"]);
      for (const Json& c : json["criteria"]) add(c["name"]);
      for (const Json& step : json["steps"]) {
        add(step["title"]);
        add(step["text"]);
        for (const Json& hint : step["hints"]) add(hint);
      }
    }
    std::set<std::string> listed;
    for (const char* text : shippedExerciseTexts()) listed.insert(text);
    QVERIFY(inFiles == listed);
  }

  // The task of boring tells that it needs a boring bar.
  void theTaskNamesTheToolsThatItNeeds() {
    const QDir folder(test::sourcePath("resources/samples/exercises"));
    for (const QString& name : folder.entryList({"*.exercise.json"})) {
      const Json json = descriptionIn(folder.filePath(name));
      const auto hasTool = [&](const char* wanted) {
        const Json tools = json["task"].value("tools", Json::array());
        return std::any_of(tools.begin(), tools.end(), [&](const Json& tool) { return tool["name"] == wanted; });
      };
      bool isBored = false, isThreaded = false;
      for (const Json& pass : json["solution"].value("passes", Json::array())) {
        isBored = isBored || pass.value("side", "") == "bore";
        isThreaded = isThreaded || pass.contains("thread");
      }
      QVERIFY2(hasTool("boring bar") == isBored && hasTool("threading tool of 60°") == isThreaded, qPrintable(name));
    }
  }

  // In another language built-in texts are translated; an exercise of one's own stays as it was written.
  void ownWordsStay() {
    struct Shouting : QTranslator {
      bool isEmpty() const override { return false; }
      QString translate(const char* context, const char* text, const char*, int) const override {
        return QLatin1String(context) == QLatin1String("Exercise") ? QString::fromUtf8(text).toUpper() : QString();
      }
    } translator;
    QCoreApplication::installTranslator(&translator);
    ExerciseSnapshot exercise;
    exercise.key = "handwheel-shaft";
    exercise.exercise.title = "Thread M20";
    exercise.exercise.steps = {{"Measure", "In my words.", {"Two or three passes are enough."}, {}}};
    Exercise shown = inLanguage(exercise);
    QCOMPARE(shown.title, std::string("THREAD M20"));
    QCOMPARE(shown.steps[0].title, std::string("MEASURE"));
    QCOMPARE(shown.steps[0].text, std::string("In my words."));
    QCOMPARE(shown.steps[0].hints[0], std::string("TWO OR THREE PASSES ARE ENOUGH."));
    // The fields of the editor are translated, and the tools among the conditions.
    const ExerciseKind kind(turningOnly());
    const auto shipped =
        exerciseFrom(kind, descriptionIn(test::sourcePath("resources/samples/exercises/shaft.exercise.json")));
    const auto fields = exerciseProperties(*shipped);
    QVERIFY(std::any_of(fields.begin(), fields.end(), [](const Property& p) {
      return p.id == "title" && p.value == PropertyValue(std::string("SHAFT WITH SHOULDERS"));
    }));
    bool hasTool = false;
    for (const ExerciseText& line : shipped->subject->conditions(*shipped->task))
      hasTool = hasTool || (!line.arguments.empty() && line.arguments.front() == "TURNING TOOL");
    QVERIFY(hasTool);
    exercise.key = newExerciseKey();
    QCOMPARE(inLanguage(exercise).title, std::string("Thread M20"));
    QCoreApplication::removeTranslator(&translator);
  }

  // The drawing of each target has the required sizes, and no overlapping texts.
  void drawings_data() { each_data(); }
  void drawings() {
    QFETCH(QString, path);
    const ExerciseKind kind(allSubjects());
    const auto exercise = exerciseFrom(kind, descriptionIn(path));
    if (exercise->subject->id() != "turning") return;
    const auto& task = static_cast<const TurningTask&>(*exercise->task);
    QVERIFY(task.target.has_value());
    const DrawingTitle title = drawingTitleOf(exercise->exercise, task);
    const Sheet sheet = drawingSheet(*task.target, title);
    std::set<std::string> texts;
    for (const Sheet::Text& text : sheet.texts) texts.insert(text.text);
    for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
      for (std::size_t k = i + 1; k < sheet.texts.size(); ++k) {
        const ProfileBox common = sheet.texts[i].box().intersection(sheet.texts[k].box());
        QVERIFY2(!(common.sizes().minCoeff() > 1e-9), (sheet.texts[i].text + " on " + sheet.texts[k].text).c_str());
      }
    }
    for (const MarkingCriterion& c : exercise->exercise.criteria) {
      if (c.figure == "roughness") QVERIFY(texts.contains("Ra 3.2"));  // N8
      if (c.figure == "major_diameter") QVERIFY(texts.contains("M20×2.5 – 6g"));
      const bool isCylinder = c.figure == "diameter" && c.arguments[1] - c.arguments[0] > 5.0;
      if (isCylinder || c.figure == "bore")
        QVERIFY2(texts.contains("Ø" + shownText(*c.nominal) + " " + c.tolerance), c.name.c_str());
    }
  }

  // The dimensions of each target, by hand from the sizes in tools/exercises: each size once, and no size that follows
  // from others. Z from the finished face, as the drawings have it.
  void theirDimensions_data() {
    QTest::addColumn<QStringList>("expected");
    const QString rough = QStringLiteral("Ra 3.2");  // N8
    // The ball ends in the finished face, which has its centre 18 behind it.
    QTest::newRow("ball") << QStringList{"Ø40", "Ø12 ±0.2", "SR18 ±0.1", "2×R1.2", "44", "74", rough};
    QTest::newRow("bush") << QStringList{"Ø50", "Ø44 h10", "Ø25 H10", "2×R1.2", "1×45°", "28 ±0.2", "30", "60", rough};
    // Both heads are 20 wide: the lower one ends 20 + 34 + 20 = 74 behind the finished face.
    QTest::newRow("dumb-bell") << QStringList{"Ø40", "Ø38 h11", "Ø38 h11", "Ø30", "Ø16 h11", "4×R1.2", "4× 2×45°",
                                              "20",  "34 ±0.2", "74",      "79",  "104",     rough};
    QTest::newRow("first-lesson") << QStringList{"Ø40", "Ø30 ±0.5", "R1.2", "30 ±1", "80", rough};
    QTest::newRow("first-lesson-teacher") << QStringList{"Ø40", "Ø30 ±0.5", "R1.2", "30 ±1", "80", rough};
    QTest::newRow("gourd") << QStringList{"Ø50", "Ø48",  "Ø24 ±0.2", "Ø34", "Ø8", "R20", "R10", "R15",
                                          "R3",  "R1.2", "21",       "36",  "60", "72",  "100", rough};
    QTest::newRow("shaft") << QStringList{"Ø40",     "Ø36 h10", "Ø28 h10", "Ø20 h10", "3×R1.2", "1×45°",
                                          "30 ±0.1", "30 ±0.1", "85",      "120",     rough};
    QTest::newRow("thread-m20") << QStringList{"Ø40", "Ø30 h11", "Ø16.4 ±0.2", "M20×2.5 – 6g", "3×R1.2", "2×45°",
                                               "34",  "40 ±0.2", "65",         "100",          rough};
    // Outside and inside the bowl has a ball and an arc of 65, which meet 16 below the rim.
    QTest::newRow("wine-glass") << QStringList{"Ø56",   "Ø8 ±0.2", "R15", "R10", "SR25",    "SR23",
                                               "2×R65", "16",      "76",  "78",  "39 ±0.5", rough};
  }
  void theirDimensions() {
    QFETCH(QStringList, expected);
    const QString path = test::sourcePath("resources/samples/exercises/%1.exercise.json").arg(QTest::currentDataTag());
    const auto exercise = exerciseFrom(ExerciseKind(allSubjects()), descriptionIn(path));
    const auto& task = static_cast<const TurningTask&>(*exercise->task);
    const Sheet sheet = dimensionSheet(*task.target, drawingTitleOf(exercise->exercise, task), {});
    QStringList texts;
    for (const Sheet::Text& text : sheet.texts) texts << QString::fromStdString(text.text);
    texts.sort();
    expected.sort();
    QCOMPARE(texts, expected);
  }

  // The ball of radius 18 is found as one in its target, on its drawing, and in the model solution.
  void theBallIsABall() {
    const ExerciseKind kind(turningOnly());
    const auto exercise =
        exerciseFrom(kind, descriptionIn(test::sourcePath("resources/samples/exercises/ball.exercise.json")));
    const auto& task = static_cast<const TurningTask&>(*exercise->task);
    const Sheet sheet = drawingSheet(*task.target, drawingTitleOf(exercise->exercise, task));
    QVERIFY(std::any_of(sheet.texts.begin(), sheet.texts.end(),
                        [](const Sheet::Text& text) { return text.text == "SR18 ±0.1"; }));
    const MeasuredPart solution(task, static_cast<const WorkpieceSnapshot&>(*exercise->solution), {});
    MarkingCriterion radius = *exercise->exercise.find("radius");
    QVERIFY(std::abs(*solution.measure(radius).value - 18.0) < 0.03);
    // The neck beside the ball is no ball, nor is the fillet below it, which is hollow.
    radius.arguments = {35.0, 50.0};
    QVERIFY(!solution.measure(radius).value);
  }

  // Gourd and glass are no circles: an arc is not marked where there is none within its tolerance.
  void freeFormsAreNoArcs() {
    const ExerciseKind kind(turningOnly());
    for (const auto& [file, from, to] : {std::tuple("gourd", 33.0, 95.0), std::tuple("wine-glass", 58.0, 105.0)}) {
      const auto exercise =
          exerciseFrom(kind, descriptionIn(test::sourcePath("resources/samples/exercises/%1.exercise.json").arg(file)));
      const auto& task = static_cast<const TurningTask&>(*exercise->task);
      const MeasuredPart solution(task, static_cast<const WorkpieceSnapshot&>(*exercise->solution), {});
      MarkingCriterion c{"arc", "", "arc", {from, to}};
      c.lower = 1.0;
      c.upper = 1.2;
      const Measurement figure = solution.measure(c);
      QVERIFY2(!figure.value && figure.remark.inEnglish().find("circle") != std::string::npos, file);
    }
  }

  // It is hollow: the wall is thin all around, and the stem is solid.
  void theGlassIsAGlass() {
    const ExerciseKind kind(turningOnly());
    const auto exercise =
        exerciseFrom(kind, descriptionIn(test::sourcePath("resources/samples/exercises/wine-glass.exercise.json")));
    const TurnedProfile& glass = static_cast<const WorkpieceSnapshot&>(*exercise->solution).part->profile;
    const auto at = [&](double z) { return static_cast<std::size_t>(z / glass.spacing() + 0.5); };
    for (double z = 84.0; z < 107.0; z += 1.0) {
      const double wall = glass.radius(at(z)) - glass.inner(at(z));
      QVERIFY2(wall > 1.5 && wall < 3.0, QByteArray::number(z));
      QVERIFY(glass.inner(at(z)) > 20.0);
    }
    QVERIFY(glass.inner(at(55.0)) == 0.0 && glass.radius(at(55.0)) < 4.2);
    QVERIFY(glass.radius(at(31.0)) > 25.0);
    // Its foot ends at Z 30: there it is parted off, and the bar behind it does not belong to the target.
    QCOMPARE(glass.pieces().size(), std::size_t{2});
    QVERIFY(glass.hasMaterial(at(30.1)) && !glass.hasMaterial(at(29.0)) && glass.hasMaterial(at(28.0)));
    QCOMPARE(static_cast<const TurningTask&>(*exercise->task).target->lowerEnd(), 30.0);
  }
};

HANDWHEEL_TEST(ShippedExercisesTest)
#include "ShippedExercisesTest.moc"
