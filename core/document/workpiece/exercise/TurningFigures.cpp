// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TurningFigures.h"

#include "base/NumberText.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "machining/TurningFidelity.h"
#include "machining/force/WorkMaterials.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// How far a face may be from where the drawing has it and still be that face, mm.
constexpr double kFaceReach = 3.0;
constexpr double kDegree = M_PI / 180.0;

AxisRange rangeOf(const MarkingCriterion& c) {
  return {c.arguments[0], c.arguments[1]};
}

Figure none(const MarkingCriterion& c, const char* why) {
  return {c.id, std::nullopt, {why}};
}

// Of two values the one that is further from the middle of the limits, or nearer to a limit that is alone.
double worse(const MarkingCriterion& c, double least, double largest) {
  if (c.lower && !c.upper) return least;
  if (c.upper && !c.lower) return largest;
  if (!c.lower) return 0.5 * (least + largest);
  const double middle = 0.5 * (*c.lower + *c.upper);
  return largest - middle >= middle - least ? largest : least;
}

Figure diameter(const MarkingCriterion& c, const TurnedProfile& profile, TurningSide side) {
  const auto reading = measureDiameter(profile, side, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no such surface along all of the range"));
  const double value = worse(c, reading->least, reading->largest);
  const double at = value == reading->least ? reading->leastAt : reading->largestAt;
  return {c.id, value, {QT_TRANSLATE_NOOP("Note", "at Z %1 mm"), {roundedText(at)}}};
}

Figure distance(const MarkingCriterion& c, const TurnedProfile& profile, TurningSide first) {
  const auto from = measureFace(profile, first, c.arguments[0], c.arguments[1], kFaceReach);
  const auto to = measureFace(profile, TurningSide::Outside, c.arguments[2], c.arguments[3], kFaceReach);
  if (!from) return none(c, QT_TRANSLATE_NOOP("Note", "the first face is missing"));
  if (!to) return none(c, QT_TRANSLATE_NOOP("Note", "the second face is missing"));
  return {c.id,
          std::abs(*to - *from),
          {QT_TRANSLATE_NOOP("Note", "between Z %1 and %2 mm"), {roundedText(*from), roundedText(*to)}}};
}

Figure arc(const MarkingCriterion& c, const TurnedProfile& profile, TurningSide side) {
  const auto reading = measureArc(profile, side, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no arc"));
  return {
      c.id,
      reading->radius,
      {QT_TRANSLATE_NOOP("Note", "the surface is within %1 mm of the circle"), {roundedText(reading->deviation, 3)}}};
}

Figure taper(const MarkingCriterion& c, const TurnedProfile& profile) {
  const auto reading = measureTaper(profile, TurningSide::Outside, rangeOf(c));
  if (!reading) return none(c, QT_TRANSLATE_NOOP("Note", "there is no such surface along all of the range"));
  return {c.id, reading->angle / kDegree, {}};
}

// The peak of one of the loads.
Figure peak(const MarkingCriterion& c, const std::vector<MeasuredPart::Load>& loads,
            double MeasuredPart::Load::*which) {
  if (loads.empty()) return {c.id, 0.0, {}};
  const auto largest =
      std::max_element(loads.begin(), loads.end(), [&](const auto& a, const auto& b) { return a.*which < b.*which; });
  return {c.id, (*largest).*which, {QT_TRANSLATE_NOOP("Note", "after %1 s"), {roundedText(largest->time, 4)}}};
}

}  // namespace

const std::vector<FigureType>& turningFigureTypes() {
  static const std::vector<FigureType> kTypes = [] {
    const std::string from = QT_TRANSLATE_NOOP("Figure", "from Z (mm)"), to = QT_TRANSLATE_NOOP("Figure", "to Z (mm)");
    const std::vector<std::string> range = {from, to};
    const std::string radius = QT_TRANSLATE_NOOP("Figure", "at radius (mm)"),
                      near = QT_TRANSLATE_NOOP("Figure", "near Z (mm)");
    const std::vector<std::string> faces = {radius, near, radius, near};
    return std::vector<FigureType>{
        {"diameter", QT_TRANSLATE_NOOP("Figure", "Diameter"), "mm", range},
        {"bore", QT_TRANSLATE_NOOP("Figure", "Diameter of a bore"), "mm", range},
        {"length", QT_TRANSLATE_NOOP("Figure", "Length between two faces"), "mm", faces},
        {"depth", QT_TRANSLATE_NOOP("Figure", "Depth of a bore to a face"), "mm", faces},
        {"arc", QT_TRANSLATE_NOOP("Figure", "Radius of an arc"), "mm", range},
        {"bore_arc", QT_TRANSLATE_NOOP("Figure", "Radius of an arc inside"), "mm", range},
        {"taper", QT_TRANSLATE_NOOP("Figure", "Angle of a taper to the axis"), "°", range},
        {"profile", QT_TRANSLATE_NOOP("Figure", "Largest deviation from the target"), "mm", range},
        {"roughness", QT_TRANSLATE_NOOP("Figure", "Roughness Ra"), "µm", range},
        {"bore_roughness", QT_TRANSLATE_NOOP("Figure", "Roughness Ra inside"), "µm", range},
        {"crashes", QT_TRANSLATE_NOOP("Figure", "Collisions"), ""},
        {"force", QT_TRANSLATE_NOOP("Figure", "Largest cutting force"), "N"},
        {"power", QT_TRANSLATE_NOOP("Figure", "Largest power"), "kW"},
        {"cutting_time", QT_TRANSLATE_NOOP("Figure", "Time of all passes"), "s"},
    };
  }();
  return kTypes;
}

MeasuredPart::MeasuredPart(const TurningTask& task, const WorkpieceSnapshot& workpiece, Progress progress)
    : m_task(task), m_profile(partOf(workpiece, turnSpacingSetting().standard).profile) {
  if (workpiece.part) {
    for (const auto& pass : workpiece.part->passes) m_passes.push_back(pass);
    m_crashes = workpiece.part->crashes;
  }
  const TurnedProfile bar = TurnedProfile::fromRadii(
      std::vector<double>(m_profile.size(), 0.5 * workpiece.stock.diameter), workpiece.stock.length);
  m_review = TurningReview::make(bar, m_passes, task.lathe, progress);
  m_isOfItsPasses = m_review && m_review->profile() == m_profile;
}

const std::vector<LatheCollision>& MeasuredPart::crashes() const {
  static const std::vector<LatheCollision> kNoCrashes;
  return m_crashes ? *m_crashes : kNoCrashes;
}

std::vector<MeasuredPart::Load> MeasuredPart::loads() const {
  std::vector<Load> loads;
  static const WorkMaterials kMaterials = WorkMaterials::standard();
  const WorkMaterial* material = kMaterials.find(m_task.material);
  if (!material || !m_review) return loads;
  const auto model = kienzleModel(*material, CuttingEdge());
  for (const CutMoment& moment : m_review->moments()) {
    const CutConditions cut{moment.depth, moment.feed, moment.speed};
    const CutForces forces = model->at(cut);
    loads.push_back({moment.time, forces.cutting, cuttingPower(forces, cut)});
  }
  return loads;
}

Figure MeasuredPart::measure(const MarkingCriterion& c, Progress progress) const {
  const FigureType* type = figureType(turningFigureTypes(), c.figure);
  if (!type) return none(c, QT_TRANSLATE_NOOP("Note", "this figure is not known"));
  if (c.arguments.size() < type->arguments.size())
    return none(c, QT_TRANSLATE_NOOP("Note", "the scheme does not say where to measure"));
  if (!m_review) return none(c, QT_TRANSLATE_NOOP("Note", "there are too many passes to measure it"));
  if (!m_isOfItsPasses) return none(c, QT_TRANSLATE_NOOP("Note", "the part is not what its recorded passes cut"));
  if (c.figure == "crashes" || c.figure == "force" || c.figure == "power" || c.figure == "cutting_time" ||
      c.figure == "roughness" || c.figure == "bore_roughness")
    return ofPasses(c);
  return ofShape(c, progress);
}

Figure MeasuredPart::ofPasses(const MarkingCriterion& c) const {
  if (m_passes.empty()) return none(c, QT_TRANSLATE_NOOP("Note", "nothing was cut"));
  if (c.figure == "crashes") return {c.id, static_cast<double>(m_review->crashes().size() + crashes().size()), {}};
  if (c.figure == "cutting_time") return {c.id, m_review->seconds(), {}};
  if (c.figure == "force") return peak(c, loads(), &Load::force);
  if (c.figure == "power") return peak(c, loads(), &Load::power);
  const TurningSide side = c.figure == "roughness" ? TurningSide::Outside : TurningSide::Bore;
  const auto finish = m_review->finish(side, rangeOf(c));
  if (!finish) return none(c, QT_TRANSLATE_NOOP("Note", "the surface was not cut along all of the range"));
  if (!std::isfinite(finish->roughness))
    return none(c, QT_TRANSLATE_NOOP("Note", "the tool that cut it has no nose radius"));
  return {c.id,
          finish->roughness,
          {QT_TRANSLATE_NOOP("Note", "up to %1 µm, at Z %2 mm"),
           {roundedText(finish->largest, 3), roundedText(finish->largestAt, 4)}}};
}

Figure MeasuredPart::ofShape(const MarkingCriterion& c, Progress progress) const {
  if (c.figure == "diameter") return diameter(c, m_profile, TurningSide::Outside);
  if (c.figure == "bore") return diameter(c, m_profile, TurningSide::Bore);
  if (c.figure == "length") return distance(c, m_profile, TurningSide::Outside);
  if (c.figure == "depth") return distance(c, m_profile, TurningSide::Bore);
  if (c.figure == "arc") return arc(c, m_profile, TurningSide::Outside);
  if (c.figure == "bore_arc") return arc(c, m_profile, TurningSide::Bore);
  if (c.figure == "taper") return taper(c, m_profile);
  if (!m_task.target) return none(c, QT_TRANSLATE_NOOP("Note", "the exercise has no target"));
  const ReferenceDeviation deviation = deviationFrom(*m_task.target, m_profile, rangeOf(c), progress);
  return {c.id,
          deviation.largest(),
          {QT_TRANSLATE_NOOP("Note", "%1 mm too much at Z %2 mm, %3 mm too little at Z %4 mm"),
           {roundedText(deviation.left, 3), roundedText(deviation.leftAt, 4), roundedText(deviation.gouged, 3),
            roundedText(deviation.gougedAt, 4)}}};
}

}  // namespace handwheel
