// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The subject without its targets, which are in TurningSubjectTarget.cpp.
#include "document/workpiece/exercise/TurningSubject.h"

#include "base/JsonText.h"
#include "base/NumberText.h"
#include "document/container/UnknownPart.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "document/workpiece/exercise/DescribedPasses.h"
#include "document/workpiece/exercise/DrawingTolerance.h"
#include "document/workpiece/exercise/ExerciseDrawing.h"
#include "document/workpiece/exercise/ExerciseThreads.h"
#include "document/workpiece/exercise/TargetSizes.h"
#include "document/workpiece/exercise/TurningDetails.h"
#include "document/workpiece/exercise/TurningMeasurements.h"
#include "document/workpiece/target/DrawingExport.h"
#include "machining/TurningFidelity.h"
#include "machining/force/WorkMaterials.h"
#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheMounting.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

const TurningTask& turningOf(const ExerciseTask& task) {
  return static_cast<const TurningTask&>(task);
}

const WorkpieceSnapshot& turnedOf(const Snapshot& work) {
  return static_cast<const WorkpieceSnapshot&>(work);
}

// If the exercise names tools of the manual lathe, these are in its post and no others can be mounted. The student
// mounts a drill.
void provideTools(LatheSetup& setup, const TurningTask& task) {
  for (const AllowedTool& tool : task.tools)
    if (!tool.tool.empty()) setup.allowed.push_back(tool.tool);
  if (setup.allowed.empty()) return;
  const LatheTools tools = shippedLatheTools();
  setup.stations.clear();
  const std::vector<std::string> allowed = setup.allowed;  // the setup is another after each tool
  for (const std::string& id : allowed) {
    const auto tool = toolNamed(tools, id);
    if (!tool || tool->kind == LatheToolKind::Drill || setup.stations.size() == LatheSetup::kMostSlots) continue;
    setup.stations.emplace_back();
    setup = mounted(setup, tools, setup.stations.size() - 1, id);
  }
  if (setup.stations.empty()) setup.stations.emplace_back();
}

// Returns the name of a tool in the language of the window: that of the lathe, or of a built-in exercise; else as the
// teacher wrote it.
std::string toolName(const AllowedTool& tool) {
  const auto mounted = tool.tool.empty() ? nullptr : toolNamed(shippedLatheTools(), tool.tool);
  if (!mounted) return QCoreApplication::translate("Exercise", tool.name.c_str()).toStdString();
  return QCoreApplication::translate("LatheTool", titleOf(mounted->kind)).toStdString() + " " + mounted->designation;
}

// A drill has none, whatever is said of it.
bool hasNose(const AllowedTool& tool) {
  const auto mounted = tool.tool.empty() ? nullptr : toolNamed(shippedLatheTools(), tool.tool);
  return !mounted || mounted->noseRadius > 0.0;
}

// The machine of the exercise: so it stands when the student begins.
LatheSetup setupOf(const TurningTask& task) {
  LatheSetup setup = defaultLatheSetup(task.stock);
  setup.chuck.grip = task.lathe.chuckHeight;
  if (task.lathe.chuckDiameter > 0.0) setup.chuck.diameter = std::max(task.lathe.chuckDiameter, task.stock.diameter);
  setup.spindle.speed = task.lathe.spindleSpeed;
  setup.spindle.largestSpeed = std::max(setup.spindle.largestSpeed, task.lathe.spindleSpeed);
  setup.spindle.power = task.powerLimit;
  setup.handFeed = std::min(setup.handFeed, task.lathe.largestFeed);
  provideTools(setup, task);
  return setup;
}

}  // namespace

std::string TurningSubject::title() const {
  return QT_TRANSLATE_NOOP("Figure", "Turning");
}

std::vector<MeasurementType> TurningSubject::figures() const {
  return turningMeasurementTypes();
}

bool TurningSubject::sharesTolerance(const MarkingCriterion& criterion, const MarkingCriterion& other) const {
  return sharesThreadTolerance(criterion, other);
}

Status TurningSubject::applyTolerance(MarkingCriterion& criterion) const {
  return applyDrawingTolerance(criterion);
}

std::optional<double> TurningSubject::drawingZero(const ExerciseTask& task) const {
  return turningOf(task).zero();
}

double TurningSubject::targetMove(const ExerciseTask& from, const ExerciseTask& to) const {
  const auto &before = turningOf(from).target, &after = turningOf(to).target;
  return before && after ? after->upperEnd() - before->upperEnd() : 0.0;
}

std::vector<MarkingCriterion> TurningSubject::targetSizes(const ExerciseTask& task) const {
  return sizesOfTarget(turningOf(task));
}

std::optional<double> TurningSubject::usualLimit(const std::string& figure, const ExerciseTask& task) const {
  if (figure == "crashes") return 0.0;
  if (figure != "force" && figure != "power") return std::nullopt;
  const double limit = figure == "force" ? turningOf(task).forceLimit : turningOf(task).powerLimit;
  return limit > 0.0 ? std::optional(limit) : std::nullopt;
}

std::string TurningSubject::positionProblem(const MarkingCriterion& criterion, const ExerciseTask& task) const {
  return handwheel::positionProblem(criterion, turningOf(task).stock);
}

std::string TurningSubject::conflict(const MarkingCriterion& criterion, const Exercise& exercise) const {
  return threadConflict(criterion, exercise);
}

TaskPointer TurningSubject::blankTask() const {
  return std::make_shared<const TurningTask>();
}

nlohmann::json TurningSubject::toJson(const ExerciseTask& task) const {
  return handwheel::toJson(turningOf(task));
}

TaskPointer TurningSubject::fromJson(const nlohmann::json& json, std::vector<Error>& damage) const {
  return std::make_shared<const TurningTask>(turningTaskFrom(json, damage));
}

// A target may be given as outer and inner points, and switches may be given with their default values.
nlohmann::json TurningSubject::unknownKeys(const nlohmann::json& json, const ExerciseTask& task) const {
  if (!json.is_object()) return nlohmann::json::object();
  nlohmann::json beyond = keysBeyond(json, toJson(task));
  for (const char* const known : {"programs", "commands"}) beyond.erase(known);
  const auto target = beyond.find("target");
  if (target == beyond.end() || !target->is_object()) return beyond;
  for (const char* const known : {"outer", "inner"}) target->erase(known);
  if (target->empty()) beyond.erase(target);
  return beyond;
}

std::vector<Property> TurningSubject::properties(const ExerciseTask& task) const {
  return propertiesOf(turningOf(task));
}

Result<TaskPointer> TurningSubject::withProperty(const ExerciseTask& task, const std::string& id,
                                                 const PropertyValue& value) const {
  Result<TurningTask> changed = withTaskProperty(turningOf(task), id, value);
  if (!changed) return changed.error();
  return TaskPointer(std::make_shared<const TurningTask>(std::move(changed.value())));
}

std::vector<ExerciseText> TurningSubject::conditions(const ExerciseTask& task) const {
  const TurningTask& turning = turningOf(task);
  std::vector<ExerciseText> lines = {
      {QT_TRANSLATE_NOOP("Note", "Bar ⌀%1 × %2 mm, held by the chuck over %3 mm"),
       {shownText(turning.stock.diameter), shownText(turning.stock.length), shownText(turning.lathe.chuckHeight)}},
      {QT_TRANSLATE_NOOP("Note", "Spindle %1 r/min, feed up to %2 mm per revolution"),
       {shownText(turning.lathe.spindleSpeed), shownText(turning.lathe.largestFeed)}}};
  if (turning.forceLimit > 0)
    lines.push_back({QT_TRANSLATE_NOOP("Note", "Resultant force up to %1 N"), {shownText(turning.forceLimit)}});
  if (turning.powerLimit > 0)
    lines.push_back({QT_TRANSLATE_NOOP("Note", "Motor power up to %1 kW"), {shownText(turning.powerLimit)}});
  if (!turning.areProgramsAllowed)
    lines.push_back({QT_TRANSLATE_NOOP("Note", "By hand: programs are not allowed"), {}});
  if (turning.areCommandsAllowed)
    lines.push_back({QT_TRANSLATE_NOOP("Note", "Commands that cut, such as Thread, are allowed"), {}});
  for (const AllowedTool& tool : turning.tools) {
    if (hasNose(tool))
      lines.push_back(
          {QT_TRANSLATE_NOOP("Note", "Tool: %1, nose radius %2 mm"), {toolName(tool), shownText(tool.noseRadius)}});
    else
      lines.push_back({QT_TRANSLATE_NOOP("Note", "Tool: %1"), {toolName(tool)}});
  }
  return lines;
}

SnapshotPointer TurningSubject::start(const ExerciseTask& task) const {
  const TurningTask& turning = turningOf(task);
  WorkpieceSnapshot bar;
  bar = withValue(std::move(bar), WorkpieceField::Diameter, turning.stock.diameter);
  bar = withValue(std::move(bar), WorkpieceField::Length, turning.stock.length);
  const WorkMaterials& materials = WorkMaterials::standard();
  if (const WorkMaterial* material = materials.find(turning.material)) bar.material = material->name;
  // The view and the panel show it and compare the part with it, as with an imported target.
  if (turning.target)
    bar.target = std::make_shared<const WorkpieceTarget>(WorkpieceTarget{*turning.target, std::string()});
  if (const LatheSetup setup = setupOf(turning); setup.isSound()) bar.lathe = std::make_shared<const LatheSetup>(setup);
  return std::make_shared<const WorkpieceSnapshot>(std::move(bar));
}

Status TurningSubject::checkWork(const ExerciseTask& task, const Snapshot& work) const {
  const StockCylinder &wanted = turningOf(task).stock, &given = turnedOf(work).stock;
  const auto text = [](const StockCylinder& s) {
    return "⌀" + shownText(s.diameter) + " × " + shownText(s.length) + " mm";
  };
  if (wanted.diameter == given.diameter && wanted.length == given.length) return Done{};
  return Error{ExerciseError::OtherWork, {"its bar is " + text(given) + ", not " + text(wanted)}, {}, {}};
}

WorkOrigin TurningSubject::originOf(const Snapshot& work) const {
  const WorkpieceSnapshot& workpiece = turnedOf(work);
  int origin = 0;
  for (const auto& pass : workpiece.part ? workpiece.part->passes : TurningPasses()) {
    const WorkOrigin of = pass->isOfCommand   ? WorkOrigin::Command
                          : pass->isOfProgram ? WorkOrigin::Program
                                              : WorkOrigin::Hand;
    origin |= static_cast<int>(of);
  }
  return static_cast<WorkOrigin>(origin);
}

bool TurningSubject::areProgramsAllowed(const ExerciseTask& task) const {
  return turningOf(task).areProgramsAllowed;
}

bool TurningSubject::areCommandsAllowed(const ExerciseTask& task) const {
  return turningOf(task).areCommandsAllowed;
}

Result<SnapshotPointer> TurningSubject::makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                                 Progress progress) const {
  const TurningTask& turning = turningOf(task);
  WorkpieceSnapshot work = turnedOf(*start(task));
  const double spacing = turnSpacingSetting().standard;
  Result<std::vector<TurningPass>> passes =
      describedPasses(description, turning.lathe.spindleSpeed, partOf(work, spacing).profile);
  if (!passes) return passes.error();
  if (!passes->empty()) {
    work.part = withPasses(work, std::move(passes.value()), spacing, progress);
    if (!work.part) return Error{ErrorCode::Cancelled, {}, {}, {}};
  }
  return SnapshotPointer(std::make_shared<const WorkpieceSnapshot>(std::move(work)));
}

nlohmann::json TurningSubject::describeWork(const ExerciseTask& task, const Snapshot& work) const {
  const TurningTask& turning = turningOf(task);
  const WorkpieceSnapshot& workpiece = turnedOf(work);
  if ((workpiece.crashes && !workpiece.crashes->empty()) || !checkWork(task, work)) return {};
  return passesDescription(workpiece.part ? workpiece.part->passes : TurningPasses(), turning.lathe.spindleSpeed);
}

std::vector<Measurement> TurningSubject::measure(const Exercise& exercise, const ExerciseTask& task,
                                                 const Snapshot& work, Progress progress) const {
  const MeasuredPart part(turningOf(task), turnedOf(work), progress.part(0.0, 0.8));
  std::vector<Measurement> figures;
  for (const MarkingCriterion& criterion : exercise.criteria) {
    if (measurementType(commonMeasurements(), criterion.figure)) continue;
    if (progress.cancelled()) break;
    figures.push_back(part.measure(criterion, progress.part(0.8, 1.0)));
  }
  rejectWrongPitches(exercise, figures);
  return figures;
}

ReportDetails TurningSubject::details(const ExerciseTask& task, const Snapshot& work, Progress progress) const {
  return turningDetails(turningOf(task), turnedOf(work), progress);
}

DisplayModel TurningSubject::display(const ExerciseTask& task) const {
  // mm, and shares of the bar: a large one is not to take longer
  constexpr double kSpacing = 0.1, kChord = 0.02, kMostRows = 2000.0, kOfDiameter = 5e-4;
  const TurningTask& turning = turningOf(task);
  TurnedProfile shape(turning.stock, std::max(kSpacing, turning.stock.length / kMostRows));
  for (std::size_t i = 0; turning.target && i < shape.size(); ++i) {
    const auto extent = turning.target->extentAt(shape.z(i));
    shape.limitOuter(i, extent ? extent->outer : 0.0);
    if (extent) shape.limitInner(i, extent->inner);
  }
  return displayOf(TurnedSurface(shape, std::max(kChord, kOfDiameter * turning.stock.diameter)), 0.0);
}

std::vector<FileFormat> TurningSubject::drawingFormats() const {
  return handwheel::drawingFormats();
}

Result<WrittenFile> TurningSubject::exportDrawing(const Exercise& exercise, const ExerciseTask& task,
                                                  const std::filesystem::path& path, Progress progress) const {
  const TurningTask& turning = turningOf(task);
  if (!turning.target) return Error{ExerciseError::WithoutTarget, {}, {}, path.string()};
  return handwheel::exportDrawing(*turning.target, drawingTitleOf(exercise, turning), path, progress);
}

}  // namespace handwheel
