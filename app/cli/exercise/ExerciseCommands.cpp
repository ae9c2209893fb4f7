// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exercise/ExerciseCommands.h"

#include "base/JsonText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/exercise/MarkCommand.h"
#include "document/FileBytes.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseRows.h"
#include "document/exercise/RoundTarget.h"
#include "document/exercise/StartedWork.h"
#include "document/exercise/Submission.h"
#include "text/NoteText.h"

#include <QtGlobal>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

namespace handwheel {

namespace {

constexpr double kSecondsOfMinute = 60.0;
constexpr double kMostMinutes = 10'000.0;                                         // within Exercise::kLongestTime
constexpr const char* kPurposes[] = {"student", "stock", "solution", "hand-in"};  // at most one of them is given

Parameter flag(const char* id, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = false}, .meaning = std::move(meaning)};
}

Parameter word(const char* id, const char* value, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = ""},
          .meaning = std::move(meaning),
          .word = value,
          .hasDefault = false};
}

Parameter withoutDefault(Parameter parameter) {
  parameter.hasDefault = false;
  return parameter;
}

bool isDescriptionName(const std::filesystem::path& path) {
  return path.extension() == ".json";
}

// A document to write: of the exercise kind, or of the kind that students work in.
struct Product {
  const DocumentKind* kind = nullptr;
  DocumentFile file;
  SnapshotPointer content;
};

std::shared_ptr<const ExerciseSnapshot> exerciseIn(const OpenedFile& opened) {
  return std::dynamic_pointer_cast<const ExerciseSnapshot>(opened.content);
}

// Replaces the target if requested, first from a file, then end for end, then in round sizes, and adds the criteria for
// it.
Result<std::shared_ptr<const ExerciseSnapshot>> withTarget(std::shared_ptr<const ExerciseSnapshot> exercise,
                                                           const OperationValues& values, Progress progress) {
  auto changed = std::make_shared<ExerciseSnapshot>(*exercise);
  if (values.isSet("import-target")) {
    auto imported = exercise->subject->withImportedTarget(*changed->task, values.text("import-target"),
                                                          values.given("facing"), progress);
    if (!imported) return imported.error();
    changed->task = std::move(imported->task);
    for (const Note& note : imported->notes) complain(noteText(note).toStdString());
    for (const Note& note : exercise->subject->fitNotes(*changed->task)) complain(noteText(note).toStdString());
    if (imported->lies) complain(noteText(*imported->lies).toStdString());
  }
  if (values.flag("turn-target")) {
    auto turned = exercise->subject->withTurnedTarget(*changed->task);
    if (!turned) return turned.error();
    changed->task = std::move(*turned);
  }
  if (values.flag("turn-target") || values.isSet("import-target")) {
    if (const auto ends = exercise->subject->endsNote(*changed->task)) complain(noteText(*ends).toStdString());
  }
  if (values.isSet("round-target")) {
    auto rounded = withRoundedTarget(*exercise->subject, *changed->task, values);
    if (!rounded) return rounded.error();
    changed->task = std::move(rounded->task);
  }
  if (changed->task != exercise->task) {
    if (const auto off = offTargetNote(*changed)) complain(noteText(*off).toStdString());
  }
  if (values.flag("mark-sizes")) {
    const std::vector<MarkingCriterion> sizes = unmarkedSizes(*changed);
    if (sizes.empty()) complain("No mark was added: all sizes of the target are marked, or it has none.");
    *changed = withCriteria(*changed, sizes);
  }
  return std::shared_ptr<const ExerciseSnapshot>(std::move(changed));
}

// Makes the product that the parameters select.
Result<Product> productOf(OpenedFile opened, const OperationValues& values, const DocumentKinds& kinds,
                          Progress progress) {
  const auto targeted = withTarget(exerciseIn(opened), values, progress.part(0.0, 0.2));
  if (!targeted) return targeted.error();
  const auto exercise = *targeted;
  const auto fresh = [](const DocumentKind& kind, SnapshotPointer content) {
    OpenedFile made = DocumentKinds::blank(kind);
    return Product{&kind, std::move(made.file), std::move(content)};
  };
  const DocumentKind& ofWork = *kinds.withId(exercise->subject->kind().id());
  if (values.flag("student"))
    return fresh(*opened.kind, std::make_shared<const ExerciseSnapshot>(forStudents(*exercise)));
  if (values.flag("stock")) {
    Product stock = fresh(ofWork, exercise->subject->start(*exercise->task));
    stock.file.assigned = assignmentOf(*exercise, exercise->attempt.value_or(Attempt()), opened.file.id);
    return stock;
  }
  if (values.flag("solution")) {
    if (!exercise->solution) return Error{ErrorCode::ReferenceMissing, {"model solution", {}, {}}, {}, {}};
    return fresh(ofWork, exercise->solution);
  }
  if (!values.isSet("hand-in")) return Product{opened.kind, std::move(opened.file), exercise};

  Result<OpenedFile> work = [&]() -> Result<OpenedFile> {
    const std::filesystem::path path = values.text("hand-in");
    if (!isDescriptionName(path)) return kinds.open(path, {}, progress);
    Result<std::string> text = readFileBytes(path);
    Result<nlohmann::json> json = text ? parseJson(*text, "work") : Result<nlohmann::json>(text.error());
    if (!json) return json.error();
    Result<SnapshotPointer> made = exercise->subject->makeWork(*exercise->task, *json, progress);
    if (!made) return made.error();
    OpenedFile described = DocumentKinds::blank(ofWork);
    described.content = std::move(made.value());
    return described;
  }();
  if (!work) return work.error();
  if (work->kind->id() != ofWork.id())
    return Error{ExerciseError::OtherWork, {"it is not a document of that kind"}, {}, values.text("hand-in")};
  Attempt attempt = exercise->attempt.value_or(Attempt());
  if (work->file.assigned) {  // time and hints, as the window has counted them
    const auto begun = exerciseOf(static_cast<const ExerciseKind&>(*opened.kind), work->file.assigned);
    if (begun && (*begun)->key == exercise->key) attempt = *(*begun)->attempt;
  }
  attempt.student = values.text("name");
  attempt.handedIn.clear();
  if (const auto minutes = values.given("minutes")) attempt.seconds = kSecondsOfMinute * *minutes;
  Result<ExerciseSnapshot> submission = handedIn(*exercise, work->content, std::move(attempt));
  if (!submission) return submission.error();
  Product product = fresh(*opened.kind, std::make_shared<const ExerciseSnapshot>(std::move(submission.value())));
  product.file.recordings = std::move(work->file.recordings);
  return product;
}

// Returns a problem of the arguments, or an empty string.
std::string problemOf(const Arguments& arguments, const OperationValues& values) {
  if (!arguments.has("output")) return "The option -o OUT is missing.";
  int purposes = 0;
  for (const char* const purpose : kPurposes) purposes += values.isSet(purpose) ? 1 : 0;
  for (const char* const change : {"import-target", "turn-target", "round-target", "mark-sizes"})
    if (purposes > 0 && values.isSet(change)) return "--" + std::string(change) + " is for the exercise itself.";
  if (values.isSet("facing") && !values.isSet("import-target")) return "--facing needs --import-target.";
  if (values.isSet("sharp-corners") && !values.isSet("round-target")) return "--sharp-corners needs --round-target.";
  if (purposes > 1) return "Give one of --student, --stock, --solution and --hand-in.";
  if (values.isSet("hand-in") && !values.isSet("name")) return "--hand-in needs the student's name: --name NAME.";
  return {};
}

int runExercise(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(exerciseOperation());
  if (const std::string problem = readOptions(arguments, values); !problem.empty())
    return failUsage(problem, exerciseOperation().id);
  if (const std::string problem = problemOf(arguments, values); !problem.empty())
    return failUsage(problem, exerciseOperation().id);
  const std::filesystem::path input = arguments.operands[0], output = arguments.valueOf("output");
  std::vector<std::filesystem::path> inputs;
  // A derived file must not replace its source; the exercise itself may be saved over its file.
  if (std::any_of(std::begin(kPurposes), std::end(kPurposes),
                  [&](const char* purpose) { return values.isSet(purpose); }))
    inputs.push_back(input);
  if (values.isSet("hand-in")) inputs.emplace_back(values.text("hand-in"));
  if (const std::string refusal = refusalToOverwrite(output, inputs); !refusal.empty()) return refuse(refusal);
  std::optional<Result<OpenedFile>> opened;
  runInterruptible("Reading", [&](CommandJob& job) { opened = kinds.open(input, {}, job.progress()); });
  if (!*opened) return fail(opened->error());
  const auto exercise = exerciseIn(opened->value());
  if (!exercise) return refuse(input.string() + " is not an exercise.");
  reportLosses(opened->value().file);
  if (const std::string refusal = refusalToReplace(output, opened->value().file); !refusal.empty())
    return refuse(refusal);

  std::optional<Result<Product>> product;
  std::optional<Result<WrittenFile>> written;
  runInterruptible("Writing", [&](CommandJob& job) {
    product = productOf(std::move(opened->value()), values, kinds, job.progress().part(0.0, 0.5));
    if (!*product) return;
    const Product& made = product->value();
    written = saveDocument(*made.kind, made.file, *made.content, output, job.progress().part(0.5, 1.0));
  });
  if (!*product) return fail(product->error());
  if (!*written) return fail(written->error());
  for (const Note& note : written->value().notes) complain(noteText(note).toStdString());
  return kExitDone;
}

}  // namespace

const Operation& exerciseOperation() {
  static const Operation kOperation = {
      .id = "exercise",
      .title = QT_TRANSLATE_NOOP("Tool", "Exercise"),
      .meaning = "Creates an exercise, copies of it for students, and files to hand in",
      .parameters = {
          flag("student", "Write a copy for students, without marking scheme and model solution"),
          flag("stock", "Write what a student begins with, as a document of its own"),
          flag("solution", "Write the model solution, as a document of its own"),
          word("hand-in", "WORK", "Write a file to hand in, with this work on the exercise"),
          word("name", "NAME", "The student who hands it in"),
          {.property = {.id = "minutes", .group = {}, .label = {}, .value = 0.0, .least = 0.0, .largest = kMostMinutes},
           .meaning = "Time that the student has worked; default: the time recorded in WORK",
           .word = "MIN",
           .hasDefault = false},
          word("import-target", "FILE", "Make what is in this DXF, SVG, STEP, mesh or workpiece the target"),
          {.property = {.id = "facing",
                        .group = {},
                        .label = {},
                        .value = 0.0,
                        .quantity = Quantity::Length,
                        .least = 0.0,
                        .largest = Exercise::kLargestFigure},
           .meaning = "With --import-target: allowance for facing at the free end of the bar; default: 1",
           .word = "MM",
           .hasDefault = false},
          flag("turn-target", "Turn the target end for end: the end at the chuck becomes the free one"),
          withoutDefault(*roundTargetOperation().find("round-target")),
          *roundTargetOperation().find("sharp-corners"),
          flag("mark-sizes",
               "Mark the sizes of the target that the marking scheme does not have, within ISO 2768-m, a point each"),
      }};
  return kOperation;
}

std::vector<Command> exerciseCommands() {
  CommandSpec spec = {
      exerciseOperation().id,
      "IN",
      "Creates an exercise from a description in JSON, copies of it for students, and files to hand in.\n"
      "IN is an exercise (.handwheel) or a description (.exercise.json); docs/exercises.md lists its keys.\n"
      "Without an option the exercise itself is written; to .exercise.json, its description.",
      {}};
  spec.options = optionsOf(exerciseOperation());
  spec.options.push_back({"output", 'o', "OUT", "The file to write"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {{std::move(spec), runExercise}, markCommand()};
}

}  // namespace handwheel
