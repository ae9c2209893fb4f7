// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The targets of exercises of turning: from work, from a file, in round sizes.
#include "base/NumberText.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/workpiece/exercise/TurningMeasurements.h"
#include "document/workpiece/exercise/TurningSubject.h"
#include "document/workpiece/target/SectionPicture.h"
#include "document/workpiece/target/TargetImport.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/TurningFidelity.h"
#include "machining/refit/SampledProfile.h"
#include "machining/section/SectionOutline.h"
#include "machining/target/RoundedTarget.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace handwheel {

namespace {

TaskPointer withTarget(const ExerciseTask& task, TargetProfile target) {
  TurningTask changed = static_cast<const TurningTask&>(task);
  changed.target = std::move(target);
  return std::make_shared<const TurningTask>(std::move(changed));
}

Note noteOnPosition(const TargetProfile& target, const StockCylinder& stock) {
  const auto text = [](double mm) { return roundedText(std::round(mm * 1e3) / 1e3 + 0.0, 7); };
  return {QT_TRANSLATE_NOOP("Note",
                            "The finished face, zero of the drawing and of programs, is %1 mm behind the free end of "
                            "the bar, at Z %2 mm; %3 mm of the bar are left behind the part at the chuck's end."),
          {text(allowanceOf(target, stock)), text(target.upperEnd()), text(target.lowerEnd() - stock.position)}};
}

}  // namespace

Result<TaskPointer> TurningSubject::withTarget(const ExerciseTask& task, const Snapshot& work) const {
  constexpr double kTolerance = 2e-3;  // mm
  const auto& workpiece = static_cast<const WorkpieceSnapshot&>(work);
  if (!workpiece.part || workpiece.part->passes.empty()) return Error{ExerciseError::NothingTurned, {}, {}, {}};
  const TurnedSection& section = workpiece.part->section();
  if (section.pieces().size() > 1)
    return Error{ErrorCode::ElementMalformed, {"target", "the part is in several pieces"}, {}, {}};
  Result<TargetProfile> target = outlineOf(section, kTolerance, 0.0);
  if (!target) return target.error();
  return handwheel::withTarget(task, std::move(target.value()));
}

std::vector<std::string> TurningSubject::criteriaOffTarget(const Exercise& exercise, const ExerciseTask& task) const {
  constexpr double kLength = 0.02, kDegrees = 0.5;  // mm, degrees: how well the samples give the target
  constexpr std::array<std::string_view, 9> kOfShape = {"diameter", "bore",  "length",         "depth",       "arc",
                                                        "bore_arc", "taper", "taper_diameter", "taper_length"};
  const auto& turning = static_cast<const TurningTask&>(task);
  std::vector<std::string> off;
  if (!turning.target) return off;
  TurnedProfile shape(turning.stock, turnSpacingSetting().standard);
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const auto extent = turning.target->extentAt(shape.z(i));
    shape.limitOuter(i, extent ? extent->outer : 0.0);
    if (extent) shape.limitInner(i, extent->inner);
  }
  for (MarkingCriterion c : exercise.criteria) {
    const bool isOfShape = std::find(kOfShape.begin(), kOfShape.end(), c.figure) != kOfShape.end();
    const MeasurementType* const type = measurementType(turningMeasurementTypes(), c.figure);
    if (!isOfShape || !c.hasLimit() || c.arguments.size() < type->arguments.size()) continue;
    const double room = c.figure == "taper" ? kDegrees : kLength;
    if (c.lower) *c.lower -= room;
    if (c.upper) *c.upper += room;
    const Measurement measured = measureShape(turning, c, shape, nullptr);
    const bool isMet =
        measured.value && (!c.lower || *measured.value >= *c.lower) && (!c.upper || *measured.value <= *c.upper);
    if (!isMet) off.push_back(c.id);
  }
  return off;
}

std::vector<Note> TurningSubject::fitNotes(const ExerciseTask& task) const {
  constexpr double kSlack = 1e-3;  // mm
  const auto& turning = static_cast<const TurningTask&>(task);
  if (!turning.target) return {};
  const TargetProfile& target = *turning.target;
  const StockCylinder& stock = turning.stock;
  const double diameter = 2.0 * target.largestRadius();
  if (diameter <= stock.diameter + kSlack && target.lowerEnd() >= stock.position - kSlack) return {};
  return {{QT_TRANSLATE_NOOP("Note",
                             "The target, ⌀%1 × %2 mm, does not fit into the bar of ⌀%3 × %4 mm. Set the bar "
                             "to a larger size, then what is left for facing."),
           {roundedText(diameter, 6), roundedText(target.length(), 6), roundedText(stock.diameter, 6),
            roundedText(stock.length, 6)}}};
}

std::optional<Note> TurningSubject::endsNote(const ExerciseTask& task) const {
  const auto& target = static_cast<const TurningTask&>(task).target;
  return target ? std::optional(handwheel::endsNote(*target)) : std::nullopt;
}

QImage TurningSubject::targetPicture(const ExerciseTask& task) const {
  const auto& turning = static_cast<const TurningTask&>(task);
  return turning.target ? targetInBar(turning.stock, *turning.target) : QImage();
}

Result<TaskPointer> TurningSubject::withTurnedTarget(const ExerciseTask& task) const {
  const auto& target = static_cast<const TurningTask&>(task).target;
  if (!target) return Error{ExerciseError::WithoutTarget, {}, {}, {}};
  return handwheel::withTarget(task, target->turnedEndForEnd());
}

std::vector<std::string> TurningSubject::targetEndings() const {
  return handwheel::targetEndings();
}

Result<ExerciseSubject::ImportedTask> TurningSubject::withImportedTarget(const ExerciseTask& task,
                                                                         const std::filesystem::path& path,
                                                                         std::optional<double> facing,
                                                                         Progress progress) const {
  Result<ImportedTarget> imported = importTarget(path, UnturnedFaces::Refuse, progress);
  if (!imported) return imported.error();
  const StockCylinder& stock = static_cast<const TurningTask&>(task).stock;
  if (facing && !(*facing <= stock.length))
    return Error{ErrorCode::ValueOutOfRange,
                 {kAllowanceId, shownText(*facing), "0", shownText(stock.length)},
                 {},
                 path.string()};
  const TargetProfile target = placedTarget(*imported, stock, facing)->profile;
  return ImportedTask{handwheel::withTarget(task, target), imported->notes, "Target", noteOnPosition(target, stock)};
}

Result<ExerciseSubject::RoundedTask> TurningSubject::withRoundedTarget(const ExerciseTask& task, double step,
                                                                       double largestFillet) const {
  const auto& before = static_cast<const TurningTask&>(task).target;
  if (!before) return Error{ExerciseError::WithoutTarget, {}, {}, {}};
  Result<TargetProfile> target = rounded(*before, {step, largestFillet});
  if (!target) return target.error();
  const double change = largestDistance(*before, *target);
  return RoundedTask{handwheel::withTarget(task, std::move(target.value())), change};
}

}  // namespace handwheel
