// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TurningMeasurements.h"

#include "base/NumberText.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "machining/TurningFidelity.h"
#include "machining/force/WorkMaterials.h"
#include "machining/measure/CrashTimes.h"
#include "machining/measure/IsoTolerance.h"
#include "machining/measure/RoughnessGrade.h"
#include "machining/measure/TaperMeasure.h"
#include "machining/measure/ThreadMeasure.h"
#include "machining/target/TargetDeviation.h"
#include "machining/thread/ThreadTolerance.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

// Largest distance between a face and its position on the drawing, mm.
constexpr double kFaceReach = 3.0;
constexpr double kDegree = M_PI / 180.0;
constexpr int kGradeOfDrill = 11;  // the finest standard tolerance that a twist drill holds

// Returns a position without the rounding of the computation, which would be read as 2e-13.
std::string positionText(double z) {
  constexpr double kNoise = 1e-9;  // mm
  return roundedText(std::abs(z) < kNoise ? 0.0 : z, 4);
}

AxisRange rangeOf(const MarkingCriterion& c) {
  return {c.arguments[0], c.arguments[1]};
}

Measurement none(const MarkingCriterion& c, const char* why) {
  return {c.id, std::nullopt, {why}};
}

// Returns the value that is further from the middle of the limits, or worse for a single limit.
double worse(const MarkingCriterion& c, double least, double largest) {
  if (c.lower && !c.upper) return least;
  if (c.upper && !c.lower) return largest;
  if (!c.lower) return 0.5 * (least + largest);
  const double middle = 0.5 * (*c.lower + *c.upper);
  return largest - middle >= middle - least ? largest : least;
}

// zero: mm, Z that remarks count from, as the drawing and the read-out do.
Measurement diameter(const MarkingCriterion& c, const TurnedProfile& profile, TurningSide side, double zero) {
  const auto reading = measureDiameter(profile, side, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no such surface along the whole range"));
  const double value = worse(c, reading->least, reading->largest);
  const double at = value == reading->least ? reading->leastAt : reading->largestAt;
  return {c.id, value, {QT_TRANSLATE_NOOP("Note", "at Z %1 mm"), {measuredText(at - zero, "mm")}}};
}

Measurement distance(const MarkingCriterion& c, const TurnedProfile& profile, TurningSide first, double zero) {
  const auto from = measureFace(profile, first, c.arguments[0], c.arguments[1], kFaceReach);
  const auto to = measureFace(profile, TurningSide::Outside, c.arguments[2], c.arguments[3], kFaceReach);
  if (!from) return none(c, QT_TRANSLATE_NOOP("Note", "the first face is missing"));
  if (!to) return none(c, QT_TRANSLATE_NOOP("Note", "the second face is missing"));
  return {c.id,
          std::abs(*to - *from),
          {QT_TRANSLATE_NOOP("Note", "between Z %1 and %2 mm"),
           {measuredText(*from - zero, "mm"), measuredText(*to - zero, "mm")}}};
}

// Returns true if the surface of a target bulges away from its axis along a range; none if that cannot be told.
std::optional<bool> bulges(const TargetProfile& target, TurningSide side, AxisRange range) {
  const auto at = [&](double z) -> std::optional<double> {
    const auto extent = target.extentAt(z);
    if (!extent) return std::nullopt;
    return side == TurningSide::Outside ? extent->outer : extent->inner;
  };
  const auto low = at(range.from), middle = at(0.5 * (range.from + range.to)), high = at(range.to);
  if (!low || !middle || !high || *middle == 0.5 * (*low + *high)) return std::nullopt;
  return *middle > 0.5 * (*low + *high);
}

// The radius of the nearest circle, where the surface is one: within the width of its tolerance, and bulging as that
// of the target.
Measurement arc(const MarkingCriterion& c, const TurnedProfile& profile, TurningSide side,
                const std::optional<TargetProfile>& target) {
  const auto reading = measureArc(profile, side, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no arc"));
  if (c.lower && c.upper && reading->deviation > *c.upper - *c.lower)
    return {c.id,
            std::nullopt,
            {QT_TRANSLATE_NOOP("Note", "there is no arc: the surface is up to %1 mm from any circle"),
             {roundedText(reading->deviation, 3)}}};
  const auto middle = measureDiameter(profile, side, rangeOf(c));
  const auto wanted = target ? bulges(*target, side, rangeOf(c)) : std::nullopt;
  if (wanted && middle && *wanted != (reading->centre.x() < 0.5 * middle->mean))
    return none(c, QT_TRANSLATE_NOOP("Note", "the arc curves in the opposite direction"));
  return {
      c.id,
      reading->radius,
      {QT_TRANSLATE_NOOP("Note", "the surface is within %1 mm of the circle"), {roundedText(reading->deviation, 3)}}};
}

// A chamfer of 45° is one at either end of a part: the sign counts only if the teacher gives a negative limit.
Measurement taper(const MarkingCriterion& c, const TurnedProfile& profile, double zero) {
  constexpr double kShown = 1e6;  // steps per degree; smaller differences are rounding
  const auto reading = measureTaper(profile, TurningSide::Outside, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no such surface in the range"));
  const bool isSigned = c.lower.value_or(0.0) < 0.0 || c.upper.value_or(0.0) < 0.0;
  const double angle = std::round(kShown * reading->angle / kDegree) / kShown + 0.0;  // no -0
  return {c.id,
          isSigned ? angle : std::abs(angle),
          {QT_TRANSLATE_NOOP("Note", "between Z %1 and %2 mm"),
           {positionText(reading->range.from - zero), positionText(reading->range.to - zero)}}};
}

// Measures the fitted line at one end of the taper, since the part may have a broken edge there.
Measurement taperDiameter(const MarkingCriterion& c, const TurnedProfile& profile, double zero) {
  const auto reading = measureTaper(profile, TurningSide::Outside, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no such surface in the range"));
  const double middle = 0.5 * (reading->range.from + reading->range.to), at = c.arguments[2];
  return {c.id,
          2.0 * (reading->radius + std::tan(reading->angle) * (at - middle)),
          {QT_TRANSLATE_NOOP("Note", "at Z %1 mm"), {measuredText(at - zero, "mm")}}};
}

Measurement taperLength(const MarkingCriterion& c, const TurnedProfile& profile, double zero) {
  const auto reading = measureTaper(profile, TurningSide::Outside, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no such surface in the range"));
  return {c.id,
          reading->range.to - reading->range.from,
          {QT_TRANSLATE_NOOP("Note", "between Z %1 and %2 mm"),
           {positionText(reading->range.from - zero), positionText(reading->range.to - zero)}}};
}

double ThreadReading::*threadFigure(const std::string& figure) {
  if (figure == "thread_pitch") return &ThreadReading::pitch;
  if (figure == "major_diameter") return &ThreadReading::major;
  if (figure == "pitch_diameter") return &ThreadReading::pitchDiameter;
  if (figure == "minor_diameter") return &ThreadReading::minor;
  return nullptr;
}

Measurement wrongPitch(const MarkingCriterion& c, double pitch) {
  return {c.id,
          std::nullopt,
          {QT_TRANSLATE_NOOP("Note", "the pitch of %1 mm is not that of the thread"), {measuredText(pitch, "mm")}}};
}

// Measures the outside, or else the bore.
Measurement threadReading(const MarkingCriterion& c, const TurnedProfile& profile, const PartThreads* threads) {
  std::optional<ThreadReading> reading;
  if (threads) reading = measureThread(profile, *threads, TurningSide::Outside, rangeOf(c));
  if (threads && !reading) reading = measureThread(profile, *threads, TurningSide::Bore, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no thread along the range"));
  const auto asked = c.figure == "pitch_diameter" ? threadTolerance(c.tolerance) : std::nullopt;
  if (asked && (reading->pitch < asked->pitch.lower || reading->pitch > asked->pitch.upper))
    return wrongPitch(c, reading->pitch);
  return {c.id,
          (*reading).*threadFigure(c.figure),
          {QT_TRANSLATE_NOOP("Note", "%1 grooves, each within %2 mm of the pitch"),
           {std::to_string(reading->grooves), roundedText(reading->largestError, 3)}}};
}

// Returns the peak of one of the loads. limit: limit of the lathe, 0: none; tooHeavy: remark if it is exceeded.
Measurement peak(const MarkingCriterion& c, const std::vector<MeasuredPart::Load>& loads,
                 double MeasuredPart::Load::*which, double limit, const char* tooHeavy) {
  if (loads.empty()) return {c.id, 0.0, {}};
  const auto largest =
      std::max_element(loads.begin(), loads.end(), [&](const auto& a, const auto& b) { return a.*which < b.*which; });
  const std::string time = roundedText(largest->time, 4);
  if (limit > 0.0 && (*largest).*which > limit)
    return {c.id, (*largest).*which, {tooHeavy, {time, roundedText(limit, 4)}}};
  return {c.id, (*largest).*which, {QT_TRANSLATE_NOOP("Note", "after %1 s"), {time}}};
}

// Replaces marks by those of the passes where older programs kept others: the cusps of a round nose for a drill, and no
// feed where a pass began in the material.
SurfaceFinish withOlderMarksAsRepeated(SurfaceFinish kept, const SurfaceFinish& repeated) {
  constexpr double kSame = 1e-4;  // share: marks keep feed and roughness rounded to single precision
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const FinishMark again = repeated.at(side, i), mark = kept.at(side, i);
      if (!mark.isKnown() || !again.isKnown() || mark.pass != again.pass) continue;
      const double drilled = drilledRoughness(again.feed);
      const bool isDrilled = side == TurningSide::Bore && std::abs(again.roughness - drilled) <= kSame * drilled;
      const bool isBegin = mark.roughness == 0.0f && mark.feed == 0.0f;
      if (isDrilled || isBegin) kept.set(side, i, again);
    }
  }
  return kept;
}

// Returns true if the kept finish is that of the repeated passes. Another processor may round differently.
bool isRepeated(const SurfaceFinish& kept, const SurfaceFinish& repeated) {
  constexpr float kSame = 1e-3f;  // share
  for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const FinishMark mark = kept.at(side, i), again = repeated.at(side, i);
      if (!mark.isKnown() || mark.roughness == again.roughness) continue;
      if (!(std::abs(mark.roughness - again.roughness) <= kSame * again.roughness)) return false;
    }
  }
  return true;
}

bool isBeforeOnPath(const ProfilePoint& a, const ProfilePoint& b) {
  return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
}

// Returns true if the manual lathe recorded a collision of its tool with the jaws where the review finds it in them.
bool isSameInJaws(const LatheCollision& recorded, const CrashMoment& seen, const TurningPass& pass) {
  if (seen.what != CrashMoment::What::Chuck || recorded.tool != pass.tool->id) return false;
  if (recorded.struck != LathePart::Jaws && recorded.struck != LathePart::Chuck) return false;
  return std::any_of(pass.path.begin() + static_cast<std::ptrdiff_t>(seen.first),
                     pass.path.begin() + static_cast<std::ptrdiff_t>(seen.last) + 1,
                     [&](const ProfilePoint& p) { return (p - recorded.position).norm() <= kCrashReach; });
}

std::vector<CutLoad> loadsOf(const TurningTask& task, const TurningReview& review, TurningReview::Passes passes) {
  const WorkMaterial* material = WorkMaterials::standard().find(task.material);
  return material ? cutLoads(review, passes, *material) : std::vector<CutLoad>();
}

}  // namespace

Measurement measureShape(const TurningTask& task, const MarkingCriterion& c, const TurnedProfile& profile,
                         const PartThreads* threads, Progress progress) {
  const double zero = task.zero();
  if (c.figure == "diameter") return diameter(c, profile, TurningSide::Outside, zero);
  if (c.figure == "bore") return diameter(c, profile, TurningSide::Bore, zero);
  if (c.figure == "length") return distance(c, profile, TurningSide::Outside, zero);
  if (c.figure == "depth") return distance(c, profile, TurningSide::Bore, zero);
  if (c.figure == "arc") return arc(c, profile, TurningSide::Outside, task.target);
  if (c.figure == "bore_arc") return arc(c, profile, TurningSide::Bore, task.target);
  if (c.figure == "taper") return taper(c, profile, zero);
  if (c.figure == "taper_diameter") return taperDiameter(c, profile, zero);
  if (c.figure == "taper_length") return taperLength(c, profile, zero);
  if (threadFigure(c.figure)) return threadReading(c, profile, threads);
  if (!task.target) return none(c, QT_TRANSLATE_NOOP("Note", "the exercise has no target"));
  const TargetDeviation deviation = deviationFrom(*task.target, profile, 0.0, progress, rangeOf(c));
  const auto &over = deviation.largestOver, &under = deviation.largestUnder;
  return {c.id,
          deviation.largest(),
          {QT_TRANSLATE_NOOP("Note", "%1 mm too much at Z %2 mm, %3 mm too little at Z %4 mm"),
           {roundedText(over.distance, 3), positionText(over.at.y() - zero), roundedText(-under.distance, 3),
            positionText(under.at.y() - zero)}}};
}

void rejectWrongPitches(const Exercise& exercise, std::vector<Measurement>& figures) {
  const auto figureOf = [&](const MarkingCriterion& c) {
    return std::find_if(figures.begin(), figures.end(),
                        [&](const Measurement& each) { return each.criterion == c.id; });
  };
  for (const MarkingCriterion& pitch : exercise.criteria) {
    if (pitch.figure != "thread_pitch") continue;
    const auto measured = figureOf(pitch);
    if (measured == figures.end() || !measured->value || earnedShare(pitch, *measured->value) == 1.0) continue;
    for (const MarkingCriterion& c : exercise.criteria) {
      if (c.figure != "pitch_diameter" || c.arguments != pitch.arguments) continue;
      if (const auto found = figureOf(c); found != figures.end()) *found = wrongPitch(c, *measured->value);
    }
  }
}

std::optional<std::pair<double, double>> peakLoads(const TurningTask& task, const WorkpieceSnapshot& workpiece,
                                                   const TurnedPart* before, Progress progress) {
  const WorkMaterial* const material = WorkMaterials::standard().find(task.material);
  if (!material) return std::pair(0.0, 0.0);
  const auto peaks = loadPeaks(workpiece, before, *material, task.lathe, progress);
  return peaks ? std::optional(std::pair(peaks->force, peaks->power)) : std::nullopt;
}

std::string feedText(double feed) {
  return std::isfinite(feed) ? roundedText(feed, 3) : "∞";
}

const std::vector<MeasurementType>& turningMeasurementTypes() {
  static const std::vector<MeasurementType> kTypes = [] {
    const std::vector<std::string> range = {QT_TRANSLATE_NOOP("Property", "From Z"),
                                            QT_TRANSLATE_NOOP("Property", "To Z")};
    const std::vector<std::string> faces = {
        QT_TRANSLATE_NOOP("Property", "First face, at radius"), QT_TRANSLATE_NOOP("Property", "First face, near Z"),
        QT_TRANSLATE_NOOP("Property", "Second face, at radius"), QT_TRANSLATE_NOOP("Property", "Second face, near Z")};
    return std::vector<MeasurementType>{
        {"diameter", QT_TRANSLATE_NOOP("Figure", "Diameter"), "mm", range},
        {"bore", QT_TRANSLATE_NOOP("Figure", "Diameter of a bore"), "mm", range},
        {"length", QT_TRANSLATE_NOOP("Figure", "Length between two faces"), "mm", faces},
        {"depth", QT_TRANSLATE_NOOP("Figure", "Depth of a bore to a face"), "mm", faces},
        {"arc", QT_TRANSLATE_NOOP("Figure", "Radius of an arc"), "mm", range},
        {"bore_arc", QT_TRANSLATE_NOOP("Figure", "Radius of an arc inside"), "mm", range},
        {"taper", QT_TRANSLATE_NOOP("Figure", "Angle of a taper to the axis"), "°", range},
        {"taper_diameter",
         QT_TRANSLATE_NOOP("Figure", "Diameter at an end of a taper"),
         "mm",
         {QT_TRANSLATE_NOOP("Property", "From Z"), QT_TRANSLATE_NOOP("Property", "To Z"),
          QT_TRANSLATE_NOOP("Property", "End, at Z")}},
        {"taper_length", QT_TRANSLATE_NOOP("Figure", "Length of a taper"), "mm", range},
        {"profile", QT_TRANSLATE_NOOP("Figure", "Largest deviation from the target"), "mm", range},
        {"thread_pitch", QT_TRANSLATE_NOOP("Figure", "Pitch of a thread"), "mm", range},
        {"major_diameter", QT_TRANSLATE_NOOP("Figure", "Major diameter of a thread"), "mm", range},
        {"pitch_diameter", QT_TRANSLATE_NOOP("Figure", "Pitch diameter of a thread"), "mm", range},
        {"minor_diameter", QT_TRANSLATE_NOOP("Figure", "Minor diameter of a thread"), "mm", range},
        {"roughness", QT_TRANSLATE_NOOP("Figure", "Roughness Ra"), "µm", range},
        {"bore_roughness", QT_TRANSLATE_NOOP("Figure", "Roughness Ra inside"), "µm", range},
        {"crashes", QT_TRANSLATE_NOOP("Figure", "Collisions and feeds too high"), ""},
        {"force", QT_TRANSLATE_NOOP("Figure", "Largest resultant force"), "N"},
        {"power", QT_TRANSLATE_NOOP("Figure", "Largest motor power"), "kW"},
        {"cutting_time", QT_TRANSLATE_NOOP("Figure", "Time of all passes"), "s"},
    };
  }();
  return kTypes;
}

std::string positionProblem(const MarkingCriterion& c, const StockCylinder& bar) {
  const MeasurementType* type = measurementType(turningMeasurementTypes(), c.figure);
  if (!type || type->arguments.empty()) return {};
  if (c.arguments.size() < type->arguments.size())
    return QT_TRANSLATE_NOOP("Property", "the place to measure is missing");
  if (type->arguments.size() <= 3) {
    if (!(c.arguments[1] > c.arguments[0])) return QT_TRANSLATE_NOOP("Property", "“To Z” must be above “From Z”");
    const auto last = c.arguments.begin() + static_cast<std::ptrdiff_t>(type->arguments.size());
    const auto [least, largest] = std::minmax_element(c.arguments.begin(), last);
    if (*least < 0.0 || *largest > bar.length)
      return QT_TRANSLATE_NOOP("Property", "the range goes beyond the bar, which begins at Z 0");
    return {};
  }
  for (const std::size_t face : {0, 2}) {
    if (!(c.arguments[face] > 0.0 && c.arguments[face] <= 0.5 * bar.diameter))
      return QT_TRANSLATE_NOOP("Property", "the bar has no face at such a radius");
    if (!(c.arguments[face + 1] >= -kFaceReach && c.arguments[face + 1] <= bar.length + kFaceReach))
      return QT_TRANSLATE_NOOP("Property", "there is no face of the bar near such a Z");
  }
  return {};
}

MeasuredPart::MeasuredPart(const TurningTask& task, const WorkpieceSnapshot& workpiece, Progress progress)
    : m_task(task), m_profile(partOf(workpiece, turnSpacingSetting().standard).profile) {
  m_crashes = workpiece.crashes;
  if (workpiece.part) {
    for (const auto& pass : workpiece.part->passes) m_passes.push_back(pass);
    m_threads = workpiece.part->threads();
    m_finish = workpiece.part->finish;
  }
  m_review =
      TurningReview::make(TurnedProfile::barOf(workpiece.stock, m_profile.size()), m_passes, task.lathe, progress);
  if (m_review) m_finish = withOlderMarksAsRepeated(std::move(m_finish), m_review->finish());
  m_isOfItsPasses = m_review && m_review->profile() == m_profile && isRepeated(m_finish, m_review->finish());
  // The section in the file may be another one.
  if (m_isOfItsPasses) m_profile.setSection(m_review->profile().section());
}

std::optional<FinishReading> MeasuredPart::finish(TurningSide side, AxisRange range) const {
  if (const auto kept = readFinish(m_finish, m_profile, side, range)) return kept;
  return m_review ? readFinish(m_review->finish(), m_profile, side, range) : std::nullopt;
}

FinishMark MeasuredPart::finishAt(TurningSide side, std::size_t i) const {
  const FinishMark kept = m_finish.at(side, i);
  return kept.isKnown() || !m_review ? kept : m_review->finish().at(side, i);
}

const std::vector<LatheCollision>& MeasuredPart::crashes() const {
  static const std::vector<LatheCollision> kNoCrashes;
  return m_crashes ? *m_crashes : kNoCrashes;
}

// The crashes of a program are on the path of its pass, where the review finds most of them again. The manual lathe
// does not make a step that would crash: the review of its passes finds the tool in the jaws at a distance from the
// recorded crash.
std::vector<CrashMoment> MeasuredPart::unrecordedCrashes() const {
  std::vector<CrashMoment> left;
  std::vector<LatheCollision> open = crashes();
  std::vector<ProfilePoint> path;  // sorted path of the pass of a program with this number
  std::size_t number = m_passes.size();
  for (const CrashMoment& crash : m_review ? m_review->crashes() : std::vector<CrashMoment>()) {
    const TurningPass& pass = *m_passes[crash.pass];
    if (std::exchange(number, crash.pass) != crash.pass) {
      path = pass.tool ? std::vector<ProfilePoint>() : pass.path;
      std::sort(path.begin(), path.end(), isBeforeOnPath);
    }
    const auto recorded = std::find_if(open.begin(), open.end(), [&](const LatheCollision& each) {
      return pass.tool ? isSameInJaws(each, crash, pass)
                       : std::binary_search(path.begin(), path.end(), each.position, isBeforeOnPath);
    });
    if (recorded == open.end())
      left.push_back(crash);
    else
      open.erase(recorded);
  }
  return left;
}

std::vector<MeasuredPart::Load> MeasuredPart::loads() const {
  return m_review ? loadsOf(m_task, *m_review, m_passes) : std::vector<Load>();
}

Measurement MeasuredPart::measure(const MarkingCriterion& c, Progress progress) const {
  const MeasurementType* type = measurementType(turningMeasurementTypes(), c.figure);
  if (!type) return none(c, QT_TRANSLATE_NOOP("Note", "this figure is not known"));
  if (c.arguments.size() < type->arguments.size())
    return none(c, QT_TRANSLATE_NOOP("Note", "the marking scheme does not specify where to measure"));
  if (!m_review) return none(c, QT_TRANSLATE_NOOP("Note", "there are too many passes to measure it"));
  if (!m_isOfItsPasses) return none(c, QT_TRANSLATE_NOOP("Note", "the part does not match its recorded passes"));
  if (c.figure == "crashes" || c.figure == "force" || c.figure == "power" || c.figure == "cutting_time" ||
      c.figure == "roughness" || c.figure == "bore_roughness")
    return ofPasses(c);
  const Measurement measured = measureShape(m_task, c, m_profile, m_threads.get(), progress);
  if (c.figure != "bore" || !measured.value || !c.lower || !c.upper || !isDrilled(rangeOf(c))) return measured;
  const auto drilled = standardTolerance(*measured.value, kGradeOfDrill);
  if (!drilled || *c.upper - *c.lower >= *drilled) return measured;
  return {c.id,
          std::nullopt,
          {QT_TRANSLATE_NOOP("Note", "a twist drill leaves H11 to H12, here +%1 mm: bore or ream a finer hole"),
           {roundedText(*drilled, 3)}}};
}

// Returns true if a drill took the last material off somewhere in a range of the bore.
bool MeasuredPart::isDrilled(AxisRange range) const {
  const TurnedProfile::Range samples = samplesWithin(m_profile, range.from, range.to);
  for (std::size_t i = samples.first; i < samples.last; ++i) {
    const FinishMark mark = finishAt(TurningSide::Bore, i);
    if (!mark.isKnown() || mark.pass >= m_passes.size()) continue;
    const auto& tool = m_passes[mark.pass]->tool;
    if (tool && tool->kind == LatheToolKind::Drill) return true;
  }
  return false;
}

Measurement MeasuredPart::ofPasses(const MarkingCriterion& c) const {
  if (m_passes.empty()) return none(c, QT_TRANSLATE_NOOP("Note", "nothing was cut"));
  if (c.figure == "crashes") return collisions(c);
  if (c.figure == "cutting_time") return {c.id, m_review->seconds(), {}};
  if (c.figure == "force")
    return peak(c, loads(), &Load::force, m_task.forceLimit,
                QT_TRANSLATE_NOOP("Note", "after %1 s; too heavy a cut: the lathe takes %2 N"));
  if (c.figure == "power")
    return peak(c, loads(), &Load::power, m_task.powerLimit,
                QT_TRANSLATE_NOOP("Note", "after %1 s; too heavy a cut: the lathe has %2 kW"));
  const TurningSide side = c.figure == "roughness" ? TurningSide::Outside : TurningSide::Bore;
  const auto reading = finish(side, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "the surface was not cut along the whole range"));
  if (!std::isfinite(reading->roughness))
    return none(c,
                QT_TRANSLATE_NOOP("Note", "the tool that cut it has no nose radius, or the feed was larger than that"));
  return {c.id,
          reading->roughness,
          {QT_TRANSLATE_NOOP("Note", "up to %1 µm, at Z %2 mm"),
           {roundedText(reading->largest, 3), positionText(reading->largestAt - zero())}}};
}

// A feed that no tool survives counts as a collision, and is named as a feed.
Measurement MeasuredPart::collisions(const MarkingCriterion& c) const {
  const std::vector<CrashMoment> seen = unrecordedCrashes();
  const CrashMoment* fastest = nullptr;
  std::size_t fast = 0;
  for (const CrashMoment& crash : seen) {
    if (crash.what != CrashMoment::What::RapidInMaterial) continue;
    ++fast;
    if (!fastest || crash.feed > fastest->feed) fastest = &crash;
  }
  const std::size_t all = seen.size() + crashes().size();
  if (!fastest) return {c.id, static_cast<double>(all), {}};
  return {c.id,
          static_cast<double>(all),
          {QT_TRANSLATE_NOOP(
               "Note",
               "feed too high %1 times, up to %2 mm per revolution where at most %3 is allowed; other collisions: %4"),
           {std::to_string(fast), feedText(fastest->feed), roundedText(m_task.lathe.largestFeed, 3),
            std::to_string(all - fast)}}};
}

}  // namespace handwheel
