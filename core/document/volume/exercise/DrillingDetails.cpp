// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DrillingDetails.h"

#include "base/Fingerprint.h"
#include "base/NumberText.h"
#include "document/volume/exercise/DrilledHolePicture.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// Largest number of points of a curve, about the resolution of a page. Of more moments, the largest value of each group
// is shown.
constexpr std::size_t kMostCurvePoints = 2'000;

ReportCurve::Series seriesOf(const char* name, const std::vector<DrillMoment>& moments, const auto& value) {
  ReportCurve::Series series{name, {}};
  const std::size_t step = moments.size() / kMostCurvePoints + 1;
  for (std::size_t first = 0; first < moments.size(); first += step) {
    const std::size_t end = std::min(first + step, moments.size());
    std::size_t largest = first;
    for (std::size_t i = first; i < end; ++i)
      if (value(moments[i]) > value(moments[largest])) largest = i;
    series.points.emplace_back(moments[largest].time, value(moments[largest]));
  }
  return series;
}

ReportCurve timeCurve(const char* title, const char* unit) {
  return {title, QT_TRANSLATE_NOOP("Figure", "Time"), "s", title, unit, {}};
}

// A line from the bottom of the plot to its top.
void addBreakthrough(ReportCurve& curve, const std::vector<DrillMoment>& moments) {
  const auto through = std::find_if(moments.begin(), moments.end(), [](const DrillMoment& m) { return m.isThrough; });
  if (through == moments.end()) return;
  double low = 0.0, high = 0.0;
  for (const ReportCurve::Series& series : curve.series)
    for (const auto& point : series.points) {
      low = std::min(low, point.second);
      high = std::max(high, point.second);
    }
  curve.series.push_back({QT_TRANSLATE_NOOP("Figure", "Breakthrough"), {{through->time, low}, {through->time, high}}});
}

// The reference laws of He 2008, (3-22) and (3-23), for a head entirely in the material: while the drill cuts, up to
// the breakthrough.
DrillLoad referenceAt(const DrillSetup& setup, const DrillMoment& moment) {
  if (!moment.isCutting || moment.isThrough) return {};
  return agreeingReference(setup.material, setup.tool, moment.feed, setup.spindle);
}

template <class IsNow>
void addEvent(ReportDetails& details, const std::vector<DrillMoment>& moments, IsNow isNow, const char* text,
              std::vector<std::string> arguments = {}) {
  const auto found = std::find_if(moments.begin(), moments.end(), isNow);
  if (found != moments.end()) details.events.push_back({found->time, {text, std::move(arguments)}});
}

// Adds a record of each second of a hole, as a copied hole may have been continued differently.
void addRecordedPieces(ReportDetails& details, const DrillRecord& hole) {
  constexpr std::size_t kPosesOfPiece = 1000;  // in one piece
  for (std::size_t first = 0; first < hole.poses.size(); first += kPosesOfPiece) {
    const std::size_t last = std::min(first + kPosesOfPiece, hole.poses.size()) - 1;
    Fingerprint mark;
    for (std::size_t i = first; i <= last; ++i) addTo(mark, hole.poses[i]);
    details.pieces.push_back({mark.value(), hole.poses[last].seconds() - hole.poses[first].seconds()});
  }
}

}  // namespace

ReportCurve thrustCurve(const DrillSetup& setup, const std::vector<DrillMoment>& moments) {
  ReportCurve curve = timeCurve(QT_TRANSLATE_NOOP("Figure", "Thrust"), "N");
  curve.series = {
      seriesOf(QT_TRANSLATE_NOOP("Figure", "Thrust"), moments, [](const DrillMoment& m) { return m.thrust; })};
  if (setup.tool.shape != DrillShape::Saw)
    curve.series.push_back(seriesOf(QT_TRANSLATE_NOOP("Figure", "Thrust reference (He 2008)"), moments,
                                    [&](const DrillMoment& m) { return referenceAt(setup, m).thrust; }));
  addBreakthrough(curve, moments);
  return curve;
}

ReportCurve torqueCurve(const DrillSetup& setup, const std::vector<DrillMoment>& moments) {
  ReportCurve curve = timeCurve(QT_TRANSLATE_NOOP("Figure", "Torque"), "N·mm");
  curve.series = {
      seriesOf(QT_TRANSLATE_NOOP("Figure", "Torque"), moments, [](const DrillMoment& m) { return m.torque; })};
  if (setup.tool.shape != DrillShape::Saw)
    curve.series.push_back(seriesOf(QT_TRANSLATE_NOOP("Figure", "Torque reference (He 2008)"), moments,
                                    [&](const DrillMoment& m) { return referenceAt(setup, m).torque; }));
  addBreakthrough(curve, moments);
  return curve;
}

ReportCurve depthCurve(const std::vector<DrillMoment>& moments) {
  ReportCurve curve = timeCurve(QT_TRANSLATE_NOOP("Figure", "Depth of the tip"), "mm");
  curve.series = {
      seriesOf(QT_TRANSLATE_NOOP("Figure", "Depth of the tip"), moments, [](const DrillMoment& m) { return m.depth; }),
      seriesOf(QT_TRANSLATE_NOOP("Figure", "Beside the path"), moments,
               [](const DrillMoment& m) { return m.isCutting ? m.deviation : 0.0; })};
  addBreakthrough(curve, moments);
  return curve;
}

ReportCurve heatCurve(const std::vector<DrillMoment>& moments) {
  ReportCurve curve = timeCurve(QT_TRANSLATE_NOOP("Figure", "Temperature rise (estimate)"), "K");
  curve.series = {seriesOf(QT_TRANSLATE_NOOP("Figure", "Temperature rise (estimate)"), moments,
                           [](const DrillMoment& m) { return m.temperature; })};
  addBreakthrough(curve, moments);
  return curve;
}

ReportDetails drillingDetails(const DrillingTask& task, const DrilledHoles& holes, const DrillReview& review,
                              Progress progress) {
  const std::vector<DrillMoment>& moments = review.moments;
  ReportDetails details;
  details.seconds = review.figures.end;
  if (const QImage picture = holePicture(task, holes, review, progress); !picture.isNull())
    details.pictures.push_back(
        {picture,
         {QT_TRANSLATE_NOOP("Note",
                            "The hole in section along the planned path. Grey: material that is left. Light blue: "
                            "drilled. Red: drilled beside the planned hole or in the forbidden region, which is pink. "
                            "Green: the planned path, with its tolerance. Black: the path of the tip.")}});
  for (const auto& hole : holes) addRecordedPieces(details, *hole);
  if (moments.empty()) return details;
  if (review.figures.contact)
    details.figures = {
        {"thrust", review.figures.thrust}, {"torque", review.figures.torque}, {"heat", review.figures.temperature}};
  const DrillSetup setup = task.setup();
  details.curves = {thrustCurve(setup, moments), torqueCurve(setup, moments), depthCurve(moments), heatCurve(moments)};
  addEvent(
      details, moments, [](const DrillMoment& m) { return m.isCutting; }, QT_TRANSLATE_NOOP("Note", "Contact."));
  addEvent(details, moments, [&](const DrillMoment& m) { return m.isCutting && m.deviation > task.plan.tolerance; },
           QT_TRANSLATE_NOOP("Note", "The drill left the planned path by more than %1 mm."),
           {roundedText(task.plan.tolerance, 3)});
  addEvent(
      details, moments, [](const DrillMoment& m) { return m.isThrough; },
      QT_TRANSLATE_NOOP("Note", "Breakthrough: the drill is through the inner surface."));
  addEvent(
      details, moments, [](const DrillMoment& m) { return m.forbidden > 0.0; },
      QT_TRANSLATE_NOOP("Note", "The drill entered the forbidden region."));
  std::stable_sort(details.events.begin(), details.events.end(),
                   [](const ReportEvent& one, const ReportEvent& other) { return one.seconds < other.seconds; });
  return details;
}

void addTries(ReportDetails& details, const DrillTries& tries) {
  if (tries.count == 0) return;
  details.figures.push_back({"tries", static_cast<double>(tries.count)});
  std::vector<ReportEvent> events;  // before the present work, which is the last try
  for (const FailedTry& failed : tries.failed)
    events.push_back({std::nullopt,
                      {QT_TRANSLATE_NOOP("Note", "Try %1 entered the forbidden region by %2 mm, and was taken back."),
                       {std::to_string(failed.number), roundedText(failed.forbidden, 3)}}});
  details.events.insert(details.events.begin(), events.begin(), events.end());
}

}  // namespace handwheel
