// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TurningSubject.h"

#include "base/JsonText.h"
#include "base/NumberText.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/workpiece/DrawingExport.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "document/workpiece/exercise/DrawingTolerance.h"
#include "document/workpiece/exercise/ExerciseDrawing.h"
#include "document/workpiece/exercise/TurningFigures.h"
#include "machining/TurningFidelity.h"
#include "machining/force/WorkMaterials.h"
#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheMounting.h"
#include "machining/refit/SampledProfile.h"

#include <QtGlobal>
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

Error malformedPass(const char* what) {
  return {ErrorCode::ElementMalformed, {"passes", what}, {}, {}};
}

// That of a pass, sharp or as round as its nose; the first groove begins at the first point.
Result<ThreadCut> threadFrom(const nlohmann::json& json, const TurningPass& pass) {
  ThreadCut thread;
  if (!json.is_object() || !json.contains("pitch") || !json["pitch"].is_number())
    return malformedPass("a thread needs a pitch");
  thread.pitch = json["pitch"].get<double>();
  if (const auto starts = json.find("starts"); starts != json.end() && starts->is_number_unsigned())
    thread.starts = static_cast<int>(std::min<std::uint64_t>(starts->get<std::uint64_t>(), 1'000));
  thread.isLeft = stringAt(json, "hand") == "left";
  if (const auto flat = json.find("flat"); flat != json.end() && flat->is_number()) thread.flat = flat->get<double>();
  thread.offset = pass.path.front().y();
  if (!thread.isSound()) return malformedPass("a thread is impossible");
  return thread;
}

// A pass at a constant feed; of a thread its lead is the feed.
Result<TurningPass> passFrom(const nlohmann::json& json, double spindleSpeed) {
  if (!json.is_object()) return malformedPass("an object was expected");
  const auto number = [&](const char* key, double otherwise) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number() ? found->get<double>() : otherwise;
  };
  TurningPass pass;
  pass.noseRadius = number("nose_radius", AllowedTool().noseRadius);
  if (!(pass.noseRadius >= TurningPass::kLeastNose && pass.noseRadius <= TurningPass::kLargestNose))
    return malformedPass("a nose radius is impossible");
  pass.side = stringAt(json, "side") == "bore" ? TurningSide::Bore : TurningSide::Outside;
  const double feed = number("feed", 0.1), mmPerSecond = feed * spindleSpeed / 60.0;
  if (!(feed > 0.0 && mmPerSecond > 0.0)) return malformedPass("feed and spindle speed must be above 0");
  const auto points = json.find("points");
  if (points == json.end() || !points->is_array() || points->empty() || points->size() > TurningPass::kMostPoints)
    return malformedPass("points were expected");
  for (const nlohmann::json& each : *points) {
    if (!each.is_array() || each.size() != 2 || !each[0].is_number() || !each[1].is_number())
      return malformedPass("points of two numbers each were expected");
    const ProfilePoint p(each[0].get<double>(), each[1].get<double>());
    const double seconds = pass.path.empty() ? 0.0 : (p - pass.path.back()).norm() / mmPerSecond;
    pass.times.push_back(pass.times.empty() ? 0.0 : pass.times.back() + seconds);
    pass.path.push_back(p);
  }
  pass.speeds.assign(pass.path.size(), spindleSpeed);
  if (const auto given = json.find("thread"); given != json.end()) {
    const Result<ThreadCut> thread = threadFrom(*given, pass);
    if (!thread) return thread.error();
    pass.thread = *thread;
  }
  return pass;
}

// A side of a part as a line; the bore only where there is one.
std::vector<ProfilePoint> lineOf(const TurnedProfile& profile, TurningSide side) {
  std::vector<ProfilePoint> line;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double r = side == TurningSide::Outside ? profile.radius(i) : profile.inner(i);
    if (profile.hasMaterial(i) && (side == TurningSide::Outside || r > 0.0)) line.emplace_back(r, profile.z(i));
  }
  return line;
}

// The outline of a target, arcs as lines.
std::vector<ProfilePoint> lineOf(const TargetProfile& target) {
  constexpr int kOfArc = 32;
  std::vector<ProfilePoint> line{target.segments().front().from};
  for (const ProfileSegment& s : target.segments()) {
    const int pieces = s.isArc() ? kOfArc : 1;
    for (int k = 1; k <= pieces; ++k) line.push_back(s.at(static_cast<double>(k) / pieces));
  }
  return line;
}

// With as few of the points as stay within the tolerance of the line, in r.
std::vector<ProfilePoint> chainThinned(const std::vector<ProfilePoint>& line, double tolerance) {
  std::vector<ProfilePoint> kept;
  std::size_t from = 0;
  const auto isStraight = [&](std::size_t to) {
    for (std::size_t k = from + 1; k < to; ++k) {
      const double t = (line[k].y() - line[from].y()) / (line[to].y() - line[from].y());
      if (std::abs(std::lerp(line[from].x(), line[to].x(), t) - line[k].x()) > tolerance) return false;
    }
    return true;
  };
  constexpr std::size_t kLongest = 512;  // points, so that the search is short
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i != 0 && i + 1 != line.size() && i + 1 - from < kLongest && isStraight(i + 1)) continue;
    kept.push_back(line[i]);
    from = i;
  }
  return kept;
}

ReportCurve::Series seriesOf(const char* name, const std::vector<ProfilePoint>& line) {
  ReportCurve::Series series{name, {}};
  for (const ProfilePoint& p : line) series.points.emplace_back(p.y(), p.x());
  return series;
}

ReportCurve shapeCurve(const TurningTask& task, const TurnedProfile& profile) {
  ReportCurve curve{QT_TRANSLATE_NOOP("Figure", "Profile"), "Z", "mm", QT_TRANSLATE_NOOP("Figure", "Radius"), "mm", {}};
  constexpr double kSeen = 0.01;  // mm
  curve.series.push_back(
      seriesOf(QT_TRANSLATE_NOOP("Figure", "Part"), chainThinned(lineOf(profile, TurningSide::Outside), kSeen)));
  if (profile.isBored())
    curve.series.push_back(
        seriesOf(QT_TRANSLATE_NOOP("Figure", "Bore"), chainThinned(lineOf(profile, TurningSide::Bore), kSeen)));
  if (!task.target) return curve;
  curve.series.push_back(seriesOf(QT_TRANSLATE_NOOP("Figure", "Target"), lineOf(*task.target)));
  return curve;
}

ReportCurve pathCurve(const WorkpieceSnapshot& workpiece) {
  constexpr std::size_t kMostPoints = 4'000;
  ReportCurve curve{QT_TRANSLATE_NOOP("Figure", "Path of the tool"), "Z",  "mm",
                    QT_TRANSLATE_NOOP("Figure", "Radius"),           "mm", {}};
  std::size_t count = 0;
  for (const auto& pass : workpiece.part->passes) count += pass->path.size();
  const std::size_t step = count / kMostPoints + 1;
  ReportCurve::Series path{QT_TRANSLATE_NOOP("Figure", "Centre of the nose"), {}};
  for (const auto& pass : workpiece.part->passes) {
    for (std::size_t i = 0; i < pass->path.size(); ++i) {
      const bool isKept = i % step == 0 || i + 1 == pass->path.size();
      if (isKept) path.points.emplace_back(pass->path[i].y(), pass->path[i].x());
    }
  }
  curve.series.push_back(std::move(path));
  return curve;
}

ReportCurve loadCurve(const char* title, const char* unit, const std::vector<MeasuredPart::Load>& loads,
                      double MeasuredPart::Load::*which) {
  ReportCurve curve{title, QT_TRANSLATE_NOOP("Figure", "Time"), "s", title, unit, {}};
  ReportCurve::Series series{title, {}};
  for (const MeasuredPart::Load& load : loads) series.points.emplace_back(load.time, load.*which);
  curve.series.push_back(std::move(series));
  return curve;
}

ReportEvent eventOf(const CrashMoment& crash) {
  const std::vector<std::string> place = {roundedText(crash.place.y(), 4), roundedText(2.0 * crash.place.x(), 4)};
  if (crash.what == CrashMoment::What::Chuck)
    return {crash.time, {QT_TRANSLATE_NOOP("Note", "The tool hit the chuck at Z %1 mm, ⌀%2 mm."), place}};
  return {crash.time, {QT_TRANSLATE_NOOP("Note", "The tool was rammed into the material at Z %1 mm, ⌀%2 mm."), place}};
}

// The roughness along the part. Of neighbours that are too many to draw the roughest is shown.
ReportCurve finishCurve(const MeasuredPart& part) {
  constexpr std::size_t kMostPoints = 1'000;
  ReportCurve curve{QT_TRANSLATE_NOOP("Figure", "Roughness"), "Z", "mm", "Ra", "µm", {}};
  const TurnedProfile& profile = part.profile();
  const std::size_t stride = profile.size() / kMostPoints + 1;
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    ReportCurve::Series series{
        side == TurningSide::Outside ? QT_TRANSLATE_NOOP("Figure", "Part") : QT_TRANSLATE_NOOP("Figure", "Bore"), {}};
    for (std::size_t first = 0; first < profile.size(); first += stride) {
      float roughest = FinishMark::kUnknown;
      for (std::size_t i = first; i < std::min(first + stride, profile.size()); ++i) {
        const FinishMark mark = part.finishAt(side, i);
        const bool isSurface = profile.hasMaterial(i) && (side == TurningSide::Outside || profile.inner(i) > 0.0);
        if (isSurface && mark.isKnown() && std::isfinite(mark.roughness)) roughest = std::max(roughest, mark.roughness);
      }
      if (roughest >= 0.0f) series.points.emplace_back(profile.z(first), roughest);
    }
    if (!series.points.empty()) curve.series.push_back(std::move(series));
  }
  return curve;
}

// By the judgement of the lathe itself, in the order of the causes.
ReportEvent eventOf(const LatheCollision& crash) {
  static constexpr std::array<const char*, 6> kTexts = {
      QT_TRANSLATE_NOOP("Note", "Parts of the lathe met at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The rapid traverse ran into the work at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The edge was pushed into work at rest at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The spindle turned the wrong way at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The cut was deeper than the edge is high at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The motor could not turn the spindle at Z %1 mm, ⌀%2 mm.")};
  const std::vector<std::string> place = {roundedText(crash.place.y(), 4), roundedText(2.0 * crash.place.x(), 4)};
  return {crash.time, {kTexts[static_cast<std::size_t>(crash.cause)], place}};
}

// Where the exercise names tools of the manual lathe, these are in its post and no others can be mounted. A drill is
// mounted by the student.
void provideTools(LatheSetup& setup, const TurningTask& task) {
  for (const AllowedTool& tool : task.tools)
    if (!tool.tool.empty()) setup.allowed.push_back(tool.tool);
  if (setup.allowed.empty()) return;
  const LatheTools tools = shippedLatheTools();
  setup.stations.clear();
  for (const std::string& id : setup.allowed) {
    const auto tool = toolNamed(tools, id);
    if (!tool || tool->kind == LatheToolKind::Drill || setup.stations.size() == LatheSetup::kMostSlots) continue;
    setup.stations.emplace_back();
    setup = mounted(setup, tools, setup.stations.size() - 1, id);
  }
  if (setup.stations.empty()) setup.stations.emplace_back();
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

std::vector<FigureType> TurningSubject::figures() const {
  return turningFigureTypes();
}

Status TurningSubject::applyTolerance(MarkingCriterion& criterion) const {
  return applyDrawingTolerance(criterion);
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
       {shownText(turning.lathe.spindleSpeed), shownText(turning.lathe.largestFeed)}},
      {QT_TRANSLATE_NOOP("Note", "Force up to %1 N, power up to %2 kW"),
       {shownText(turning.forceLimit), shownText(turning.powerLimit)}}};
  for (const AllowedTool& tool : turning.tools)
    lines.push_back(
        {QT_TRANSLATE_NOOP("Note", "Tool: %1, nose radius %2 mm"), {tool.name, shownText(tool.noseRadius)}});
  return lines;
}

SnapshotPointer TurningSubject::start(const ExerciseTask& task) const {
  const TurningTask& turning = turningOf(task);
  WorkpieceSnapshot bar;
  bar = withValue(std::move(bar), WorkpieceField::Diameter, turning.stock.diameter);
  bar = withValue(std::move(bar), WorkpieceField::Length, turning.stock.length);
  const WorkMaterials& materials = WorkMaterials::standard();
  if (const WorkMaterial* material = materials.find(turning.material)) bar.material = material->name;
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

Result<SnapshotPointer> TurningSubject::makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                                 Progress progress) const {
  const TurningTask& turning = turningOf(task);
  const auto passes = description.is_object() ? description.find("passes") : description.end();
  if (passes == description.end() || !passes->is_array()) return malformedPass("a list was expected");
  WorkpieceSnapshot work = turnedOf(*start(task));
  for (std::size_t i = 0; i < passes->size(); ++i) {
    Result<TurningPass> pass = passFrom((*passes)[i], turning.lathe.spindleSpeed);
    if (!pass) return pass.error();
    const double share = 1.0 / static_cast<double>(passes->size()), done = share * static_cast<double>(i);
    work.part =
        withPass(work, std::move(pass.value()), turnSpacingSetting().standard, progress.part(done, done + share));
    if (!work.part) return Error{ErrorCode::Cancelled, {}, {}, {}};
  }
  return SnapshotPointer(std::make_shared<const WorkpieceSnapshot>(std::move(work)));
}

Result<TaskPointer> TurningSubject::withTarget(const ExerciseTask& task, const Snapshot& work) const {
  constexpr double kTolerance = 2e-3;  // mm
  const WorkpieceSnapshot& workpiece = turnedOf(work);
  const TurnedProfile profile = partOf(workpiece, turnSpacingSetting().standard).profile;
  if (profile.pieces() > 1)
    return Error{ErrorCode::ElementMalformed, {"target", "the part is in several pieces"}, {}, {}};
  Result<TargetProfile> target = sectionOf(profile, kTolerance);
  if (!target) return target.error();
  TurningTask changed = turningOf(task);
  changed.target = std::move(target.value());
  return TaskPointer(std::make_shared<const TurningTask>(std::move(changed)));
}

std::vector<Figure> TurningSubject::measure(const Exercise& exercise, const ExerciseTask& task, const Snapshot& work,
                                            Progress progress) const {
  const MeasuredPart part(turningOf(task), turnedOf(work), progress.part(0.0, 0.8));
  std::vector<Figure> figures;
  for (const MarkingCriterion& criterion : exercise.criteria) {
    if (figureType(commonFigures(), criterion.figure)) continue;
    if (progress.cancelled()) break;
    figures.push_back(part.measure(criterion, progress.part(0.8, 1.0)));
  }
  return figures;
}

ReportDetails TurningSubject::details(const ExerciseTask& task, const Snapshot& work, Progress progress) const {
  const WorkpieceSnapshot& workpiece = turnedOf(work);
  const MeasuredPart part(turningOf(task), workpiece, progress);
  ReportDetails details;
  details.curves.push_back(shapeCurve(turningOf(task), part.profile()));
  if (!workpiece.part || !part.review()) return details;
  details.curves.push_back(pathCurve(workpiece));
  if (ReportCurve finish = finishCurve(part); !finish.series.empty()) details.curves.push_back(std::move(finish));
  const std::vector<MeasuredPart::Load> loads = part.loads();
  details.curves.push_back(
      loadCurve(QT_TRANSLATE_NOOP("Figure", "Cutting force"), "N", loads, &MeasuredPart::Load::force));
  details.curves.push_back(loadCurve(QT_TRANSLATE_NOOP("Figure", "Power"), "kW", loads, &MeasuredPart::Load::power));
  for (const CrashMoment& crash : part.review()->crashes()) details.events.push_back(eventOf(crash));
  for (const LatheCollision& crash : part.crashes()) details.events.push_back(eventOf(crash));
  details.seconds = part.review()->seconds();
  return details;
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
