// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/DrawingTolerance.h"

#include "base/NumberText.h"
#include "machining/measure/IsoTolerance.h"
#include "machining/measure/RoughnessGrade.h"
#include "machining/thread/ThreadTolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace handwheel {

namespace {

constexpr std::array<std::string_view, 8> kSizes = {"diameter", "bore",     "length",         "depth",
                                                    "arc",      "bore_arc", "taper_diameter", "taper_length"};
constexpr std::array<std::string_view, 2> kRoughness = {"roughness", "bore_roughness"};

Error malformedTolerance(const MarkingCriterion& c, const char* what) {
  return {ErrorCode::ElementMalformed, {namedInErrors(c), what}, {}, {}};
}

bool isOneOf(std::span<const std::string_view> figures, const MarkingCriterion& c) {
  return std::find(figures.begin(), figures.end(), c.figure) != figures.end();
}

// "±0.2": as much on both sides of the nominal value; also as keyboards without the sign have it, "+-0.2" and "+/-0.2",
// which becomes that. None for other texts.
std::optional<double> symmetricTolerance(std::string& text) {
  for (const std::string_view sign : {"±", "+-", "+/-"}) {
    if (!text.starts_with(sign)) continue;
    std::string_view number = std::string_view(text).substr(sign.size());
    while (number.starts_with(' ')) number.remove_prefix(1);
    double half = 0.0;
    ErrorCode why;
    if (!parseDecimal(number, half, why) || !std::isfinite(half) || half < 0.0) return std::nullopt;
    text = "±" + std::string(number);
    return half;
  }
  return std::nullopt;
}

// A figure of a thread with its limits in the tolerance of the thread.
struct ThreadFigure {
  std::string_view figure;
  ToleratedSize ThreadTolerance::*size;
  std::optional<ThreadDiameter> diameter;  // none: the pitch
};
constexpr std::array<ThreadFigure, 4> kThreadFigures = {
    {{"thread_pitch", &ThreadTolerance::pitch, std::nullopt},
     {"major_diameter", &ThreadTolerance::major, ThreadDiameter::Major},
     {"pitch_diameter", &ThreadTolerance::pitchDiameter, ThreadDiameter::Pitch},
     {"minor_diameter", &ThreadTolerance::minor, ThreadDiameter::Minor}}};

const ThreadFigure* threadFigureOf(const MarkingCriterion& c) {
  const auto found = std::find_if(kThreadFigures.begin(), kThreadFigures.end(),
                                  [&](const ThreadFigure& each) { return each.figure == c.figure; });
  return found == kThreadFigures.end() ? nullptr : &*found;
}

// "M20×2.5-6g" says all; a class alone is that of the coarse thread with the nominal size.
Status applyThreadTolerance(MarkingCriterion& c, const ThreadFigure& figure) {
  std::optional<ThreadTolerance> thread = threadTolerance(c.tolerance);
  const std::string_view alone = threadClassIn(c.tolerance);
  if (!thread && !alone.empty() && c.nominal && figure.diameter)
    thread = coarseThreadWith(*figure.diameter, *c.nominal, alone);
  if (!thread && !alone.empty())
    return malformedTolerance(c, "its class needs the thread in front of it, as in M20x2.5-6g");
  if (!thread) return malformedTolerance(c, "its tolerance is not that of a thread, as M20x2.5-6g or M20-6H");
  c.tolerance = thread->designation;
  c.nominal = ((*thread).*figure.size).nominal;
  c.lower = ((*thread).*figure.size).lower;
  c.upper = ((*thread).*figure.size).upper;
  return Done{};
}

// "10": not where the tolerance lies.
bool isGradeAlone(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

// "⌀28 h9", as it stands on a drawing: the size in front, which is taken off the text. None: there is none.
std::optional<double> sizeInFront(std::string& text) {
  std::string_view rest = text;
  for (const std::string_view sign : {"⌀", "Ø", "ø", " "})
    while (rest.starts_with(sign)) rest.remove_prefix(sign.size());
  const std::size_t digits = std::min(rest.find_first_not_of("0123456789."), rest.size());
  double size = 0.0;
  ErrorCode why;
  if (digits == 0 || digits == rest.size() || !parseDecimal(rest.substr(0, digits), size, why)) return std::nullopt;
  rest.remove_prefix(digits);
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  text = std::string(rest);
  return size;
}

}  // namespace

std::optional<double> drawnSizeOf(const MarkingCriterion& criterion) {
  if (criterion.nominal) return criterion.nominal;
  if (criterion.lower && criterion.upper) return 0.5 * (*criterion.lower + *criterion.upper);
  return std::nullopt;
}

bool isOfThread(const MarkingCriterion& criterion) {
  return threadFigureOf(criterion) != nullptr;
}

bool sharesThreadTolerance(const MarkingCriterion& criterion, const MarkingCriterion& other) {
  return threadFigureOf(criterion) && threadFigureOf(other) && criterion.arguments == other.arguments &&
         threadTolerance(criterion.tolerance);
}

Status applyDrawingTolerance(MarkingCriterion& c) {
  const ThreadFigure* const thread = threadFigureOf(c);
  if (const auto size = thread ? std::nullopt : sizeInFront(c.tolerance)) {  // "6g" is no size
    if (c.nominal && *c.nominal != *size)
      return malformedTolerance(c, "the size in front of its tolerance is not the nominal size");
    c.nominal = *size;
  }
  if (const auto half = symmetricTolerance(c.tolerance)) {
    if (!c.nominal) return malformedTolerance(c, "its tolerance needs the nominal size");
    c.lower = *c.nominal - *half;
    c.upper = *c.nominal + *half;
    return Done{};
  }
  if (thread) return applyThreadTolerance(c, *thread);
  if (isOneOf(kRoughness, c)) {
    const auto ra = roughnessOf(c.tolerance);
    if (!ra) return malformedTolerance(c, "its tolerance is not a roughness grade, N1 to N12");
    c.lower.reset();
    c.upper = *ra;
    return Done{};
  }
  if (!isOneOf(kSizes, c)) return malformedTolerance(c, "its figure takes limits, not a tolerance class");
  if (!c.nominal) return malformedTolerance(c, "its tolerance needs the nominal size");
  const auto deviations = isoDeviations(*c.nominal, c.tolerance);
  if (!deviations && isGradeAlone(c.tolerance))
    return malformedTolerance(c, "its tolerance class has no letter; give one, as in h10, H10 or js10");
  if (!deviations) return malformedTolerance(c, "its tolerance class is not known for this size; give limits instead");
  c.lower = *c.nominal + deviations->lower;
  c.upper = *c.nominal + deviations->upper;
  return Done{};
}

}  // namespace handwheel
