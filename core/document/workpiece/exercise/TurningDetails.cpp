// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TurningDetails.h"

#include "base/Fingerprint.h"
#include "base/NumberText.h"
#include "document/workpiece/exercise/TurningMeasurements.h"
#include "document/workpiece/target/SectionPicture.h"
#include "machining/measure/CrashTimes.h"
#include "machining/target/TargetDeviation.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

// A side of a part as a line; the bore only where there is one.
std::vector<ProfilePoint> lineOf(const TurnedProfile& profile, TurningSide side) {
  std::vector<ProfilePoint> line;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double r = side == TurningSide::Outside ? profile.radius(i) : profile.inner(i);
    if (profile.hasMaterial(i) && (side == TurningSide::Outside || r > 0.0)) line.emplace_back(r, profile.z(i));
  }
  return line;
}

// Returns the line with the fewest points that stay within the tolerance, in r.
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
  ReportCurve curve{QT_TRANSLATE_NOOP("Figure", "Profile"), {}, {}, QT_TRANSLATE_NOOP("Figure", "Radius"), "mm", {}};
  constexpr double kSeen = 0.01;  // mm
  curve.series.push_back(
      seriesOf(QT_TRANSLATE_NOOP("Figure", "Part"), chainThinned(lineOf(profile, TurningSide::Outside), kSeen)));
  if (profile.isBored())
    curve.series.push_back(
        seriesOf(QT_TRANSLATE_NOOP("Figure", "Bore"), chainThinned(lineOf(profile, TurningSide::Bore), kSeen)));
  if (!task.target) return curve;
  curve.series.push_back(seriesOf(QT_TRANSLATE_NOOP("Figure", "Target"), halfSectionOf(*task.target)));
  return curve;
}

// Returns true if the tool only travels to point i of a pass: too fast for any cut.
bool isRapid(const TurningPass& pass, std::size_t i, const ReviewedLathe& lathe) {
  constexpr double kRapidFeed = 10.0;  // mm per turn
  const double seconds = pass.times[i] - pass.times[i - 1];
  const double speed = i < pass.speeds.size() ? pass.speeds[i] : lathe.spindleSpeed;
  return seconds > 0.0 && (pass.path[i] - pass.path[i - 1]).norm() > kRapidFeed * seconds * speed / 60.0;
}

// Returns the path of the tool while it cut. Between passes and over rapid moves there are gaps, points that are not
// numbers.
ReportCurve pathCurve(const TurningTask& task, const WorkpieceSnapshot& workpiece) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t kMostPoints = 4'000;
  ReportCurve curve{QT_TRANSLATE_NOOP("Figure", "Path of the tool"), {},   {},
                    QT_TRANSLATE_NOOP("Figure", "Radius"),           "mm", {}};
  std::size_t count = 0;
  for (const auto& pass : workpiece.part->passes) count += pass->path.size();
  const std::size_t step = count / kMostPoints + 1;
  ReportCurve::Series path{QT_TRANSLATE_NOOP("Figure", "Centre of the nose"), {}};
  for (const auto& pass : workpiece.part->passes) {
    if (!path.points.empty()) path.points.emplace_back(kGap, kGap);
    for (std::size_t i = 0; i < pass->path.size(); ++i) {
      const bool isAfterRapid = i > 0 && isRapid(*pass, i, task.lathe);
      if (isAfterRapid && std::isfinite(path.points.back().first)) path.points.emplace_back(kGap, kGap);
      const bool isKept = i % step == 0 || i + 1 == pass->path.size() || isAfterRapid;
      if (isKept) path.points.emplace_back(pass->path[i].y(), pass->path[i].x());
    }
  }
  curve.series.push_back(std::move(path));
  return curve;
}

ReportPicture pictureOf(const TurningTask& task, const TurnedProfile& profile) {
  if (!task.target) return {sectionPicture(profile, {}), {QT_TRANSLATE_NOOP("Note", "The part in section.")}};
  return {
      sectionPicture(profile, halfSectionOf(*task.target)),
      {QT_TRANSLATE_NOOP("Note",
                         "The part in section, with the outline of the target. Blue: material left over the target. "
                         "Red: cut too deep. The bar behind the part is grey.")}};
}

ReportCurve loadCurve(const char* title, const char* unit, const std::vector<MeasuredPart::Load>& loads,
                      double MeasuredPart::Load::*which) {
  ReportCurve curve{title, QT_TRANSLATE_NOOP("Figure", "Time"), "s", title, unit, {}};
  ReportCurve::Series series{title, {}};
  for (const MeasuredPart::Load& load : loads) series.points.emplace_back(load.time, load.*which);
  curve.series.push_back(std::move(series));
  return curve;
}

// Adds the deviation of the part from its target over the time of the work. The bar is that of the work.
void addDeviations(ReportDetails& details, const TurningTask& task, const WorkpieceSnapshot& work, Progress progress) {
  constexpr int kMoments = 40;
  const TurnedProfile bar = TurnedProfile::barOf(work.stock, work.part->profile.size());
  const auto replay = PassesReplay::make(bar, work.part->passes, progress.part(0.0, 0.5));
  if (!replay) return;
  const AxisRange range = rangeOfTarget(*task.target, bar, 0.0, task.lathe.chuckHeight);
  const DeviationTrack track = deviationTrack(*replay, *task.target, 0.0, range, kMoments, progress.part(0.5, 1.0));
  const auto add = [&](const char* title, const DeviationTrack::Curve& points) {
    details.curves.push_back({title, QT_TRANSLATE_NOOP("Figure", "Time"), "s", title, "mm", {{title, points}}});
  };
  add(QT_TRANSLATE_NOOP("Figure", "Material left over the target"), track.left);
  add(QT_TRANSLATE_NOOP("Figure", "Cut too deep"), track.deep);
}

// zero: mm, zero of reported Z.
ReportEvent eventOf(const CrashMoment& crash, const ReviewedLathe& lathe, double zero) {
  std::vector<std::string> arguments = {roundedText(crash.position.y() - zero, 4),
                                        roundedText(2.0 * crash.position.x(), 4)};
  if (crash.what == CrashMoment::What::Chuck)
    return {crash.time, {QT_TRANSLATE_NOOP("Note", "The tool hit the chuck at Z %1 mm, ⌀%2 mm."), arguments}};
  arguments.insert(arguments.end(), {feedText(crash.feed), roundedText(lathe.largestFeed, 3)});
  return {crash.time,
          {QT_TRANSLATE_NOOP(
               "Note", "The feed was too high at Z %1 mm, ⌀%2 mm: %3 mm per revolution, where at most %4 is allowed."),
           arguments}};
}

// The roughness along the part. Of neighbours that are too many to draw the roughest is shown.
ReportCurve finishCurve(const MeasuredPart& part) {
  constexpr std::size_t kMostPoints = 1'000;
  ReportCurve curve{QT_TRANSLATE_NOOP("Figure", "Roughness"), {}, {}, "Ra", "µm", {}};
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

// Returns the event in the judgement of the lathe itself, in the order of the causes. seconds: on the clock of the
// curves.
ReportEvent eventOf(const LatheCollision& crash, double seconds, double zero) {
  static constexpr std::array<const char*, 6> kTexts = {
      QT_TRANSLATE_NOOP("Note", "Parts of the lathe collided at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The rapid traverse ran into the work at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The tool was fed into the work at rest at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The spindle turned the wrong way at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The cut was deeper than the cutting edge is long at Z %1 mm, ⌀%2 mm."),
      QT_TRANSLATE_NOOP("Note", "The motor could not turn the spindle at Z %1 mm, ⌀%2 mm.")};
  const std::vector<std::string> arguments = {roundedText(crash.position.y() - zero, 4),
                                              roundedText(2.0 * crash.position.x(), 4)};
  return {seconds, {kTexts[static_cast<std::size_t>(crash.cause)], arguments}};
}

// Adds the heaviest cut, and an event if it exceeds the lathe. limit: limit of the lathe; 0: none.
void addPeak(ReportDetails& details, const char* figure, const std::vector<MeasuredPart::Load>& loads,
             double MeasuredPart::Load::*which, double limit, const char* text, int digits) {
  const auto largest =
      std::max_element(loads.begin(), loads.end(), [&](const auto& a, const auto& b) { return a.*which < b.*which; });
  if (largest == loads.end()) return;
  details.figures.push_back({figure, (*largest).*which});
  if (!(limit > 0.0 && (*largest).*which > limit)) return;
  details.events.push_back({largest->time, {text, {roundedText((*largest).*which, digits), roundedText(limit, 4)}}});
}

// Shifts a curve over the height above the lower end of the bar to the zero of the drawing, as all positions are given.
ReportCurve alongAxis(ReportCurve curve, const TurningTask& task) {
  curve.x = task.target ? QT_TRANSLATE_NOOP("Figure", "Z from the finished face")
                        : QT_TRANSLATE_NOOP("Figure", "Z from the free end of the bar");
  curve.xUnit = "mm";
  for (ReportCurve::Series& series : curve.series)
    for (auto& point : series.points) point.first -= task.zero();
  return curve;
}

// Identifies a pass by its path, so that it is found at any index. The points of an arc do not tell its bulge. Passes
// without arcs and edges, as hands make them, keep the marks of earlier versions.
RecordedPiece recordedPieceOf(const TurningPass& pass) {
  Fingerprint mark;
  for (const ProfilePoint& p : pass.path) mark.add(p.x()), mark.add(p.y());
  for (const double time : pass.times) mark.add(time);
  for (const TurningPass::Arc& arc : pass.arcs) {
    mark.add(std::uint64_t{arc.first});
    mark.add(std::uint64_t{arc.last});
    mark.add(arc.bulge);
  }
  if (!pass.edges.isZero()) mark.add(pass.edges.x()), mark.add(pass.edges.y());
  return {mark.value(), pass.times.empty() ? 0.0 : pass.times.back(), !pass.isOfProgram && !pass.isOfCommand};
}

}  // namespace

ReportDetails turningDetails(const TurningTask& task, const WorkpieceSnapshot& work, Progress progress) {
  const MeasuredPart part(task, work, progress);
  ReportDetails details;
  details.pictures.push_back(pictureOf(task, part.profile()));
  details.curves.push_back(alongAxis(shapeCurve(task, part.profile()), task));
  if (!work.part || !part.review()) return details;
  for (const auto& pass : work.part->passes) details.pieces.push_back(recordedPieceOf(*pass));
  details.curves.push_back(alongAxis(pathCurve(task, work), task));
  if (ReportCurve finish = finishCurve(part); !finish.series.empty())
    details.curves.push_back(alongAxis(std::move(finish), task));
  const std::vector<MeasuredPart::Load> loads = part.loads();
  details.curves.push_back(
      loadCurve(QT_TRANSLATE_NOOP("Figure", "Resultant force"), "N", loads, &MeasuredPart::Load::force));
  details.curves.push_back(
      loadCurve(QT_TRANSLATE_NOOP("Figure", "Motor power"), "kW", loads, &MeasuredPart::Load::power));
  if (task.target) addDeviations(details, task, work, progress);
  for (const CrashMoment& crash : part.unrecordedCrashes())
    details.events.push_back(eventOf(crash, task.lathe, part.zero()));
  const std::vector<double> struck = crashSeconds(work.part->passes, part.crashes());
  for (std::size_t i = 0; i < struck.size(); ++i)
    details.events.push_back(eventOf(part.crashes()[i], struck[i], part.zero()));
  addPeak(details, "force", loads, &MeasuredPart::Load::force, task.forceLimit,
          QT_TRANSLATE_NOOP("Note", "The cut was too heavy: a resultant force of %1 N, where the lathe takes %2 N."),
          4);
  addPeak(details, "power", loads, &MeasuredPart::Load::power, task.powerLimit,
          QT_TRANSLATE_NOOP("Note", "The cut was too heavy: a motor power of %1 kW, where the lathe has %2 kW."), 3);
  details.seconds = part.review()->seconds();
  return details;
}

}  // namespace handwheel
