// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseProperties.h"

#include "base/NumberText.h"
#include "base/Utf8.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ShippedExercises.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSecondsOfMinute = 60.0;
constexpr char kListSign = ';', kHintSign = '|';

Error malformed(const std::string& id, const char* what) {
  return {ErrorCode::ElementMalformed, {id, what}, {}, {}};
}

Property property(std::string id, std::string group, const char* label, PropertyValue value) {
  Property p;
  p.id = std::move(id);
  p.group = std::move(group);
  p.label = label;
  p.value = std::move(value);
  return p;
}

std::string joined(const std::vector<std::string>& words, char sign) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : std::string(1, sign) + " ") + word;
  return text;
}

std::string numbersText(const std::vector<double>& numbers) {
  std::vector<std::string> words;
  words.reserve(numbers.size());
  for (const double number : numbers) words.push_back(shortestText(number));
  return joined(words, kListSign);
}

std::vector<std::string> split(const std::string& text, char sign) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(sign, begin), text.size());
    std::string word = text.substr(begin, end - begin);
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    if (!word.empty()) words.push_back(std::move(word));
    begin = end + 1;
  }
  return words;
}

std::optional<std::vector<double>> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : split(text, kListSign)) {
    double number = 0.0;
    ErrorCode why;
    if (!parseDecimal(word, number, why) || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

// Returns the displayed unit of a figure in units of the file: the working time is displayed in minutes, as the allowed
// time is.
double shownUnit(const MeasurementType* type) {
  return type && type->id == "time" ? kSecondsOfMinute : 1.0;
}

std::string limitText(const std::optional<double>& limit, double unit) {
  return limit ? shortestText(*limit / unit) : std::string();
}

// A criterion in the words of the teacher; its id where these would not find it again.
std::string shownName(const Exercise& exercise, const std::string& id) {
  const MarkingCriterion* c = exercise.find(id);
  if (!c || c->name.empty() || c->name.find(kListSign) != std::string::npos || exercise.find(c->name)) return id;
  const auto isNamesake = [&](const MarkingCriterion& each) { return each.name == c->name; };
  const bool isUnique = std::count_if(exercise.criteria.begin(), exercise.criteria.end(), isNamesake) == 1;
  return isUnique && split(c->name, kListSign) == std::vector{c->name} ? c->name : id;
}

std::vector<std::string> shownNames(const Exercise& exercise, std::vector<std::string> ids) {
  for (std::string& id : ids) id = shownName(exercise, id);
  return ids;
}

// Returns the ids of criteria that are given by id or by name.
std::vector<std::string> idsOf(const Exercise& exercise, std::vector<std::string> names) {
  for (std::string& name : names) {
    const auto isMeant = [&](const MarkingCriterion& c) { return c.name == name; };
    const auto found = std::find_if(exercise.criteria.begin(), exercise.criteria.end(), isMeant);
    if (!exercise.find(name) && found != exercise.criteria.end()) name = found->id;
  }
  return names;
}

// "Lower limit (mm)". Units are the same in all languages.
std::string labelWithUnit(const char* label, const std::string& unit) {
  const QString words = QCoreApplication::translate("Property", label);
  if (unit.empty()) return words.toStdString();
  return QStringLiteral("%1 (%2)").arg(words, QString::fromStdString(unit)).toStdString();
}

std::string argumentId(std::size_t argument) {
  return "at" + std::to_string(argument + 1);
}

// The argument that a property is; none for other properties.
std::optional<std::size_t> argumentOf(const std::string& field) {
  for (std::size_t i = 0; i < Exercise::kMostArguments; ++i) {
    if (field == argumentId(i)) return i;
  }
  return std::nullopt;
}

// "From Z (on the drawing −20)": so a height counts on the drawing, in programs and on the read-out.
std::string labelOnDrawing(const std::string& label, double position) {
  constexpr double kShown = 1e6;  // steps per mm; smaller differences are rounding
  return QCoreApplication::translate("Property", QT_TRANSLATE_NOOP("Property", "%1 (on the drawing %2)"))
      .arg(QCoreApplication::translate("Property", label.c_str()),
           QString::fromStdString(shortestText(std::round(position * kShown) / kShown + 0.0)))
      .toStdString();
}

// Returns the positions at which a criterion is measured: a length for each argument of its figure. A problem is shown
// at the last one.
std::vector<Property> argumentProperties(const ExerciseSnapshot& exercise, const MarkingCriterion& c,
                                         const MeasurementType& type) {
  const std::optional<double> zero = exercise.subject->drawingZero(*exercise.task);
  std::vector<Property> all;
  for (std::size_t i = 0; i < type.arguments.size(); ++i) {
    const double at = i < c.arguments.size() ? c.arguments[i] : 0.0;
    all.push_back(property(argumentId(i), {}, type.arguments[i].c_str(), at));
    all.back().quantity = Quantity::Length;
    all.back().least = -Exercise::kLargestFigure;
    all.back().largest = Exercise::kLargestFigure;
    if (!zero || !type.arguments[i].ends_with('Z')) continue;
    all.back().label = labelOnDrawing(type.arguments[i], at - *zero);
    all.back().translated = false;
  }
  if (all.empty()) return all;
  all.back().problem = exercise.subject->positionProblem(c, *exercise.task);
  if (all.back().problem.empty()) all.back().problem = exercise.subject->conflict(c, exercise.exercise);
  return all;
}

std::vector<Property> criterionProperties(const ExerciseSnapshot& exercise, const MarkingCriterion& c,
                                          const std::vector<MeasurementType>& types) {
  const std::string prefix = criterionPrefix(c), group = c.name.empty() ? c.id : c.name;
  std::vector<Property> all;
  const auto add = [&](const char* id, const char* label, PropertyValue value) -> Property& {
    all.push_back(property(prefix + id, group, label, std::move(value)));
    all.back().groupTranslated = false;
    all.back().editable = !exercise.isForStudents;
    return all.back();
  };
  add("name", QT_TRANSLATE_NOOP("Property", "Name"), c.name);
  Property& figure = add("figure", QT_TRANSLATE_NOOP("Property", "Figure"), 0.0);
  const MeasurementType* type = measurementType(types, c.figure);
  for (const MeasurementType& each : types) figure.choices.push_back(each.label);
  if (type) {
    figure.value = static_cast<double>(type - types.data());
  } else {
    figure.problem = QT_TRANSLATE_NOOP("Property", "this figure is not known");
  }
  for (Property& argument : type ? argumentProperties(exercise, c, *type) : std::vector<Property>()) {
    Property& shown = add(argument.id.c_str(), "", argument.value);
    argument.id = shown.id;
    argument.group = shown.group;
    argument.groupTranslated = shown.groupTranslated;
    argument.editable = shown.editable;
    shown = std::move(argument);
  }
  if (!type) add("arguments", QT_TRANSLATE_NOOP("Property", "Measured at"), numbersText(c.arguments)).isNumbers = true;
  const double unit = shownUnit(type);
  const auto addNumber = [&](const char* id, const char* label, PropertyValue value) -> Property& {
    Property& made = add(id, label, std::move(value));
    made.label = labelWithUnit(label, unit != 1.0 ? "min" : type ? type->unit : std::string());
    made.translated = false;
    return made;
  };
  // A figure without a position on the drawing, such as time and collisions, has no size there.
  if (!type || !type->arguments.empty() || c.nominal || !c.tolerance.empty()) {
    addNumber("nominal", QT_TRANSLATE_NOOP("Property", "Nominal size"), limitText(c.nominal, unit)).isNumbers = true;
    add("tolerance", QT_TRANSLATE_NOOP("Property", "Tolerance on the drawing"), c.tolerance).isNumbers = true;
  }
  addNumber("lower", QT_TRANSLATE_NOOP("Property", "Lower limit"), limitText(c.lower, unit)).isNumbers = true;
  addNumber("upper", QT_TRANSLATE_NOOP("Property", "Upper limit"), limitText(c.upper, unit)).isNumbers = true;
  if (exercise.isForStudents) return all;
  Property& points = add("points", QT_TRANSLATE_NOOP("Property", "Points"), c.points);
  points.least = 0.0;
  points.largest = Exercise::kMostPoints;
  if (c.points > 0.0 && !c.hasLimit())
    points.problem = QT_TRANSLATE_NOOP("Property", "they cannot be scored without a limit");
  Property& slack = addNumber("slack", QT_TRANSLATE_NOOP("Property", "No points this far beyond"), c.slack / unit);
  slack.least = 0.0;
  slack.largest = Exercise::kLargestFigure;
  add("hidden", QT_TRANSLATE_NOOP("Property", "Hidden from students"), c.isHidden);
  add("decisive", QT_TRANSLATE_NOOP("Property", "No points at all if not met"), c.isDecisive);
  return all;
}

Status setLimit(std::optional<double>& limit, const std::string& id, const std::string& text, double unit) {
  const auto numbers = numbersIn(text);
  if (!numbers || numbers->size() > 1) return malformed(id, "a number was expected, or nothing");
  limit = numbers->empty() ? std::nullopt : std::optional(unit * numbers->front());
  return Done{};
}

// A limit that is set by hand is not that of a class any more.
Status setLimitByHand(MarkingCriterion& c, std::optional<double>& limit, const std::string& id, const std::string& text,
                      double unit) {
  const std::optional<double> before = limit;
  const Status set = setLimit(limit, id, text, unit);
  if (set && limit != before) c.tolerance.clear();
  return set;
}

// Another figure that is measured elsewhere needs to be given where.
void setFigure(MarkingCriterion& c, const MeasurementType& figure, const std::vector<MeasurementType>& types) {
  const MeasurementType* const before = measurementType(types, c.figure);
  if (!before || before->arguments != figure.arguments) c.arguments.assign(figure.arguments.size(), 0.0);
  c.figure = figure.id;
}

Status setField(MarkingCriterion& c, const std::string& field, const std::string& id, const PropertyValue& value,
                const std::vector<MeasurementType>& types) {
  const auto* text = std::get_if<std::string>(&value);
  const auto* number = std::get_if<double>(&value);
  const double unit = shownUnit(measurementType(types, c.figure));
  if (field == "hidden" || field == "decisive") {
    const auto* flag = std::get_if<bool>(&value);
    if (!flag) return malformed(id, "a switch was expected");
    (field == "hidden" ? c.isHidden : c.isDecisive) = *flag;
    return Done{};
  }
  if (field == "points" || field == "slack" || field == "figure") {
    if (!number) return malformed(id, "a number was expected");
    if (field == "points") c.points = *number;
    if (field == "slack") c.slack = unit * *number;
    if (field != "figure") return Done{};
    if (!(*number >= 0.0 && *number < static_cast<double>(types.size())))
      return malformed(id, "there is no such choice");
    setFigure(c, types[static_cast<std::size_t>(*number)], types);
    return Done{};
  }
  if (const auto argument = argumentOf(field)) {
    if (!number || !std::isfinite(*number)) return malformed(id, "a number was expected");
    c.arguments.resize(std::max(c.arguments.size(), *argument + 1));
    c.arguments[*argument] = *number;
    return Done{};
  }
  if (!text || !isUtf8(*text)) return malformed(id, "a text in UTF-8 was expected");
  if (field == "lower") return setLimitByHand(c, c.lower, id, *text, unit);
  if (field == "upper") return setLimitByHand(c, c.upper, id, *text, unit);
  if (field == "nominal") return setLimit(c.nominal, id, *text, unit);
  if (field == "name") c.name = *text;
  if (field == "tolerance") c.tolerance = *text;
  if (field == "arguments") {
    const auto numbers = numbersIn(*text);
    if (!numbers) return malformed(id, "numbers with “;” between them were expected");
    c.arguments = *numbers;
  }
  return Done{};
}

// Gives a tolerance to the criteria that share it. All of them have one then.
Status spreadTolerance(ExerciseSnapshot& exercise, const MarkingCriterion& c) {
  for (MarkingCriterion& other : exercise.exercise.criteria) {
    if (&other == &c || !exercise.subject->sharesTolerance(c, other)) continue;
    other.tolerance = c.tolerance;
    if (const Status applied = exercise.subject->applyTolerance(other); !applied) return applied;
  }
  return Done{};
}

// The limits follow the values that define the tolerance on the drawing.
Status setAndResolve(ExerciseSnapshot& exercise, MarkingCriterion& c, const std::string& field, const std::string& id,
                     const PropertyValue& value) {
  const Status set = setField(c, field, id, value, measurementTypes(*exercise.subject));
  const bool isOfTolerance = field == "tolerance" || field == "nominal" || field == "figure";
  if (!set || !isOfTolerance || c.tolerance.empty()) return set;
  const Status applied = exercise.subject->applyTolerance(c);
  if (applied) return spreadTolerance(exercise, c);
  if (field != "figure") return applied;
  c.tolerance.clear();  // another figure does not have this tolerance; the limits stay
  return Done{};
}

// The heights at which the criteria are measured, where these are on a target that has moved.
void moveArguments(ExerciseSnapshot& exercise, double move) {
  constexpr double kShares = 1e9;  // steps per mm; smaller differences are rounding
  if (move == 0.0) return;
  const std::vector<MeasurementType> types = measurementTypes(*exercise.subject);
  for (MarkingCriterion& c : exercise.exercise.criteria) {
    const MeasurementType* const type = measurementType(types, c.figure);
    for (std::size_t i = 0; type && i < std::min(c.arguments.size(), type->arguments.size()); ++i) {
      if (type->arguments[i].ends_with('Z')) c.arguments[i] = std::round((c.arguments[i] + move) * kShares) / kShares;
    }
  }
}

std::string headingOf(const Exercise& exercise, std::size_t step) {
  return std::to_string(step + 1) + ". " + exercise.steps[step].title;
}

Error markUnknown(const Exercise& exercise, std::size_t step, const std::string& name) {
  std::vector<std::string> ids;
  for (const MarkingCriterion& c : exercise.criteria) ids.push_back(c.id);
  Error error{ExerciseError::MarkUnknown, {headingOf(exercise, step), name}, {}, {}};
  if (!ids.empty()) error.arguments.push_back(joined(shownNames(exercise, std::move(ids)), kListSign));
  return error;
}

// Marks are named in the words that the user sees.
Status setStepField(ExerciseSnapshot& exercise, std::size_t row, const std::string& field, const std::string& id,
                    const PropertyValue& value) {
  const Exercise shown = inLanguage(exercise);
  ExerciseStep& step = exercise.exercise.steps[row];
  const auto* text = std::get_if<std::string>(&value);
  if (!text || !isUtf8(*text)) return malformed(id, "a text in UTF-8 was expected");
  if (field == "title") step.title = *text;
  if (field == "text") step.text = *text;
  if (field == "hints") step.hints = split(*text, kHintSign);
  if (field != "criteria") return Done{};
  step.criteria = idsOf(shown, split(*text, kListSign));
  for (const std::string& each : step.criteria)
    if (!shown.find(each)) return markUnknown(shown, row, each);
  return Done{};
}

Status setText(Exercise& exercise, const std::string& id, const PropertyValue& value) {
  if (id == "allowed_minutes") {
    const auto* minutes = std::get_if<double>(&value);
    if (!minutes) return malformed(id, "a number was expected");
    exercise.allowedSeconds = kSecondsOfMinute * *minutes;
    return Done{};
  }
  const auto* text = std::get_if<std::string>(&value);
  if (!text || !isUtf8(*text)) return malformed(id, "a text in UTF-8 was expected");
  (id == "title" ? exercise.title : id == "author" ? exercise.author : exercise.text) = *text;
  return Done{};
}

bool isText(const std::string& id) {
  return id == "title" || id == "author" || id == "text" || id == "allowed_minutes";
}

// Sets a property of the exercise itself; none: the property is one of the subject.
std::optional<Status> setOwn(ExerciseSnapshot& exercise, const std::string& id, const PropertyValue& value) {
  if (isText(id)) return setText(exercise.exercise, id, value);
  for (MarkingCriterion& c : exercise.exercise.criteria) {
    const std::string prefix = criterionPrefix(c);
    if (id.starts_with(prefix)) return setAndResolve(exercise, c, id.substr(prefix.size()), id, value);
  }
  for (std::size_t i = 0; i < exercise.exercise.steps.size(); ++i) {
    const std::string prefix = stepPrefix(i);
    if (id.starts_with(prefix)) return setStepField(exercise, i, id.substr(prefix.size()), id, value);
  }
  return std::nullopt;
}

}  // namespace

std::string criterionPrefix(const MarkingCriterion& criterion) {
  return "criterion." + criterion.id + ".";
}

std::string stepPrefix(std::size_t step) {
  return "step." + std::to_string(step + 1) + ".";
}

std::vector<Property> exerciseProperties(const ExerciseSnapshot& exercise) {
  const Exercise e = inLanguage(exercise);
  const std::string group = QT_TRANSLATE_NOOP("Property", "Exercise");
  std::vector<Property> all = {property("title", group, QT_TRANSLATE_NOOP("Property", "Title"), e.title),
                               property("author", group, QT_TRANSLATE_NOOP("Property", "Author"), e.author),
                               property("text", group, QT_TRANSLATE_NOOP("Property", "Task"), e.text),
                               property("allowed_minutes", group, QT_TRANSLATE_NOOP("Property", "Time (min)"),
                                        e.allowedSeconds / kSecondsOfMinute)};
  all.back().least = 0.0;
  all.back().largest = Exercise::kLongestTime / kSecondsOfMinute;
  for (Property& each : exercise.subject->properties(*exercise.task)) all.push_back(std::move(each));
  for (Property& each : all) each.editable = each.editable && !exercise.isForStudents;
  const std::vector<MeasurementType> types = measurementTypes(*exercise.subject);
  for (const MarkingCriterion& c : e.criteria) {
    for (Property& each : criterionProperties(exercise, c, types)) all.push_back(std::move(each));
  }
  for (std::size_t i = 0; i < e.steps.size(); ++i) {
    const ExerciseStep& step = e.steps[i];
    const std::string prefix = stepPrefix(i), heading = headingOf(e, i);
    for (auto&& [id, label, value] :
         {std::tuple{"title", QT_TRANSLATE_NOOP("Property", "Title"), step.title},
          std::tuple{"text", QT_TRANSLATE_NOOP("Property", "Text"), step.text},
          std::tuple{"hints", QT_TRANSLATE_NOOP("Property", "Hints"), joined(step.hints, kHintSign)},
          std::tuple{"criteria", QT_TRANSLATE_NOOP("Property", "Done when met"),
                     joined(shownNames(e, step.criteria), kListSign)}}) {
      all.push_back(property(prefix + id, heading, label, value));
      all.back().groupTranslated = false;
      all.back().editable = !exercise.isForStudents;
    }
  }
  return all;
}

Result<ExerciseSnapshot> withExerciseProperty(ExerciseSnapshot exercise, const std::string& id,
                                              const PropertyValue& value) {
  const std::optional<Status> set = setOwn(exercise, id, value);
  if (!set) {
    Result<TaskPointer> task = exercise.subject->withProperty(*exercise.task, id, value);
    if (!task) return task.error();
    moveArguments(exercise, exercise.subject->targetMove(*exercise.task, **task));
    exercise.task = std::move(task.value());
    return exercise;
  }
  if (!*set) return set->error();
  const Status checked = checkExercise(exercise.exercise);
  if (!checked) return checked.error();
  return exercise;
}

}  // namespace handwheel
