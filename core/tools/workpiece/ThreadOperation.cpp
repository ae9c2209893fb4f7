// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/ThreadOperation.h"

#include "machining/lathe/RemovedMaterial.h"
#include "machining/thread/ThreadGroove.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {

namespace {

constexpr double kFurthest = 1e5;  // mm

Parameter lengthParameter(const char* id, const char* label, double value, double least, double largest,
                          std::string meaning) {
  return {.property = {.id = id,
                       .group = {},
                       .label = label,
                       .value = value,
                       .quantity = Quantity::Length,
                       .least = least,
                       .largest = largest},
          .meaning = std::move(meaning),
          .word = "MM"};
}

Parameter threadFlag(const char* id, const char* label, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = label, .value = false}, .meaning = std::move(meaning)};
}

Parameter startsParameter() {
  Parameter starts = {.property = {.id = "starts",
                                   .group = {},
                                   .label = QT_TRANSLATE_NOOP("Property", "Starts"),
                                   .value = 1.0,
                                   .quantity = Quantity::Number,
                                   .least = 1.0,
                                   .largest = ThreadCut::kMostStarts},
                      .meaning = "Number of parallel grooves",
                      .word = "N"};
  starts.isWhole = true;
  return starts;
}

Error noThread(const char* what) {
  return {ErrorCode::ElementMalformed, {"thread", what}, {}, {}};
}

// The radius that the thread begins at; 0 where there is no surface.
double surfaceOf(const WorkpieceSnapshot& workpiece, TurningSide side, double from, double to) {
  if (!workpiece.part) return side == TurningSide::Outside ? 0.5 * workpiece.stock.diameter : 0.0;
  const TurnedProfile& profile = workpiece.part->profile;
  const TurnedProfile::Range range = samplesWithin(profile, from, to);
  double outer = 0.0, inner = kFurthest;
  for (std::size_t i = range.first; i < range.last; ++i) {
    outer = std::max(outer, profile.radius(i));
    inner = std::min(inner, profile.inner(i));
  }
  return side == TurningSide::Outside ? outer : range.isEmpty() ? 0.0 : inner;
}

}  // namespace

const Operation& threadOperation() {
  static const Operation operation = {
      .id = "thread",
      .title = QT_TRANSLATE_NOOP("Tool", "Thread"),
      .meaning = "Cut a thread between two heights",
      .parameters = {
          lengthParameter("from", QT_TRANSLATE_NOOP("Property", "From Z"), 0.0, -kFurthest, kFurthest,
                          "Lower end of the thread, in the coordinates of the document"),
          lengthParameter("to", QT_TRANSLATE_NOOP("Property", "To Z"), 0.0, -kFurthest, kFurthest,
                          "Upper end of the thread"),
          lengthParameter("pitch", QT_TRANSLATE_NOOP("Property", "Pitch"), 1.5, ThreadCut::kLeastPitch,
                          ThreadCut::kLargestPitch, "Distance from groove to groove"),
          lengthParameter("depth", QT_TRANSLATE_NOOP("Property", "Depth"), 0.0, 0.0, ThreadCut::kLargestPitch,
                          "Depth from the surface to the bottom of the groove; 0: that of ISO 68-1 for the pitch"),
          startsParameter(),
          threadFlag("left", QT_TRANSLATE_NOOP("Property", "Left-hand"), "Cut a left-hand thread"),
          threadFlag("inside", QT_TRANSLATE_NOOP("Property", "Inside"), "Cut the thread in the bore"),
      }};
  return operation;
}

// Outside the root is rounded with H/6, inside it is flat, P/8 (ISO 68-1, ISO 965-1).
Result<TurningPass> threadPass(const WorkpieceSnapshot& workpiece, const OperationValues& values) {
  const double base = workpiece.stock.position, length = workpiece.stock.length;
  const double from = values.number("from") - base, to = values.number("to") - base;
  const bool isInside = values.flag("inside");
  if (!(to > from)) return noThread("its upper end is not above the lower one");
  if (from > length || to < 0.0) return noThread("it is beside the part");
  TurningPass pass;
  ThreadCut cut;
  cut.pitch = values.number("pitch");
  cut.starts = static_cast<int>(values.whole("starts"));
  cut.isLeft = values.flag("left");
  cut.offset = to;
  if ((to - from) / cut.pitch > ThreadGroove::kMostTurns) return noThread("it has more than 500 grooves");
  pass.side = isInside ? TurningSide::Bore : TurningSide::Outside;
  const double surface = surfaceOf(workpiece, pass.side, from, to);
  if (!(surface > 0.0)) return noThread(isInside ? "there is no bore all along it" : "there is no surface");
  double depth = values.number("depth");
  if (isInside) {
    cut.flat = cut.pitch / 8.0;
    if (depth == 0.0) depth = isoMetricInnerDepth(cut.pitch);
  } else {
    if (depth == 0.0) depth = isoMetricDepth(cut.pitch);
    pass.noseRadius = isoMetricNose(cut.pitch);
  }
  if (isInside) pass.noseRadius = 0.0;
  const double bottom = isInside ? surface + depth : surface - depth + pass.noseRadius;
  if (!(bottom > pass.noseRadius)) return noThread("it is deeper than the part is thick");
  pass.path = {{bottom, to}, {bottom, from}};
  pass.times = {0.0, 0.0};
  pass.thread = cut;
  pass.isOfCommand = true;
  const std::vector<ThreadGroove> grooves = ThreadGroove::of(pass);
  const bool isCut = workpiece.part ? !grooves.empty() && grooves.front().touches(workpiece.part->profile) : !isInside;
  if (!isCut) return noThread("it touches nothing");
  return pass;
}

}  // namespace handwheel
