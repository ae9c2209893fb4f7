// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/TargetPosition.h"

#include "base/NumberText.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSlack = 1e-3;  // mm

double freeEnd(const StockCylinder& stock) {
  return stock.position + stock.length;
}

Property lengthProperty(const char* id, const char* label, double value) {
  Property property;
  property.id = id;
  property.group = QT_TRANSLATE_NOOP("Property", "Target");
  property.label = label;
  property.value = value;
  property.quantity = Quantity::Length;
  property.editable = false;
  return property;
}

const char* problemOf(const TargetProfile& target, const StockCylinder& stock) {
  if (2.0 * target.largestRadius() > stock.diameter + kSlack)
    return QT_TRANSLATE_NOOP("Property", "the target is thicker than the bar");
  if (target.length() > stock.length + kSlack)
    return QT_TRANSLATE_NOOP("Property", "the target is longer than the bar");
  if (target.lowerEnd() < stock.position - kSlack)
    return QT_TRANSLATE_NOOP("Property", "the target goes beyond the chuck's end of the bar");
  if (target.upperEnd() > freeEnd(stock) + kSlack)
    return QT_TRANSLATE_NOOP("Property", "the target goes beyond the free end of the bar");
  return "";
}

}  // namespace

double allowanceOf(const TargetProfile& target, const StockCylinder& stock) {
  return freeEnd(stock) - target.upperEnd();
}

double usualAllowance(const TargetProfile& target, const StockCylinder& stock) {
  return std::clamp(stock.length - target.length(), 0.0, kUsualAllowance);
}

TargetProfile withAllowance(const TargetProfile& target, const StockCylinder& stock, double allowance) {
  const double move = allowanceOf(target, stock) - allowance;
  return move == 0.0 ? target : target.moved(move);
}

double programZero(const WorkpieceSnapshot& workpiece) {
  return freeEnd(workpiece.stock) - programAllowance(workpiece);
}

double shownZero(const WorkpieceSnapshot& workpiece, bool isOfExercise) {
  return isOfExercise ? programZero(workpiece) - workpiece.stock.position : 0.0;
}

double programAllowance(const WorkpieceSnapshot& workpiece) {
  return workpiece.target ? allowanceOf(workpiece.target->profile, workpiece.stock) : 0.0;
}

std::vector<Property> positionProperties(const TargetProfile& target, const StockCylinder& stock) {
  // Written as a person reads it: the ends of imported targets carry the rounding of their files.
  const auto shown = [](double mm) { return std::round(mm * 1e6) / 1e6 + 0.0; };
  Property allowance = lengthProperty(kAllowanceId, QT_TRANSLATE_NOOP("Property", "Left for facing at the free end"),
                                      shown(allowanceOf(target, stock)));
  allowance.editable = true;
  allowance.least = std::min(0.0, allowanceOf(target, stock));
  allowance.largest = std::max(stock.length, allowanceOf(target, stock));
  allowance.problem = problemOf(target, stock);
  return {
      std::move(allowance),
      lengthProperty("target_face", QT_TRANSLATE_NOOP("Property", "Finished face, zero of the drawing and programs, Z"),
                     shown(target.upperEnd())),
      lengthProperty("target_left", QT_TRANSLATE_NOOP("Property", "Left behind the part at the chuck's end"),
                     shown(target.lowerEnd() - stock.position))};
}

Note endsNote(const TargetProfile& target) {
  const auto diameter = [&](double z) {
    const auto extent = target.extentAt(z);
    return roundedText(extent ? std::round(2e3 * extent->outer) / 1e3 : 0.0, 6);
  };
  return {QT_TRANSLATE_NOOP("Note",
                            "The end of ⌀%1 mm is the free one, whose face is finished; the end of ⌀%2 mm is "
                            "towards the chuck."),
          {diameter(target.upperEnd()), diameter(target.lowerEnd())}};
}

Result<TargetProfile> withPosition(const TargetProfile& target, const StockCylinder& stock,
                                   const PropertyValue& value) {
  const auto* const number = std::get_if<double>(&value);
  if (!number) return Error{ErrorCode::ElementMalformed, {kAllowanceId, "a number was expected"}, {}, {}};
  const Property allowance = positionProperties(target, stock).front();
  if (!(*number >= allowance.least && *number <= allowance.largest))
    return Error{ErrorCode::ValueOutOfRange,
                 {kAllowanceId, shownText(*number), shownText(allowance.least), shownText(allowance.largest)},
                 {},
                 {}};
  return withAllowance(target, stock, *number);
}

}  // namespace handwheel
