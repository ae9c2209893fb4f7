// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DrillingMeasurements.h"

#include "base/NumberText.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

bool isSame(const SparseVolume& one, const SparseVolume& other) {
  if (one.voxel() != other.voxel() || one.origin() != other.origin()) return false;
  std::size_t left = 0;
  bool isSame = true;
  one.forEach([&](const VoxelIndex& block, const SparseVolume::Content& content) {
    const SparseVolume::Content there = other.content(block);
    const bool hasSamples = content.block && there.block;
    isSame = isSame && (content == there || (hasSamples && content.block->depths == there.block->depths));
    ++left;
  });
  other.forEach([&](const VoxelIndex&, const SparseVolume::Content&) { --left; });
  return isSame && left == 0;
}

bool isSame(const DrillSetup& one, const DrillSetup& other) {
  return one.tool.shape == other.tool.shape && one.tool.diameter == other.tool.diameter &&
         one.tool.pointAngle == other.tool.pointAngle && one.tool.length == other.tool.length &&
         one.material.id == other.material.id && one.material.energy == other.material.energy &&
         one.material.tangential == other.material.tangential && std::abs(one.spindle - other.spindle) < 1e-9;
}

std::optional<double> valueIn(const DrillReview& review, const std::string& figure) {
  const DrillStatistics& f = review.figures;
  if (figure == "forbidden") return f.forbidden;
  if (!f.contact) return std::nullopt;
  if (figure == "deviation") return f.deviation;
  if (figure == "thrust") return f.thrust;
  if (figure == "torque") return f.torque;
  if (figure == "heat") return f.temperature;
  if (figure == "hole_time") return f.end - *f.contact;
  if (!f.breakthrough) return std::nullopt;
  if (figure == "breakthrough") return *f.breakthrough - *f.contact;
  if (figure == "plunge") return f.plunge;
  if (figure == "last_thrust") return review.lastThrust;
  return std::nullopt;
}

}  // namespace

const std::vector<MeasurementType>& drillingMeasurementTypes() {
  static const std::vector<MeasurementType> types = {
      {"deviation", QT_TRANSLATE_NOOP("Figure", "Deviation from the planned path"), "mm"},
      {"breakthrough", QT_TRANSLATE_NOOP("Figure", "Time from contact to breakthrough"), "s"},
      {"plunge", QT_TRANSLATE_NOOP("Figure", "Plunge beyond the inner surface"), "mm"},
      {"forbidden", QT_TRANSLATE_NOOP("Figure", "Depth in the forbidden region"), "mm"},
      {"thrust", QT_TRANSLATE_NOOP("Figure", "Largest thrust"), "N"},
      {"last_thrust", QT_TRANSLATE_NOOP("Figure", "Mean thrust in the last millimetre"), "N"},
      {"torque", QT_TRANSLATE_NOOP("Figure", "Largest torque"), "N·mm"},
      {"heat", QT_TRANSLATE_NOOP("Figure", "Temperature rise (estimate)"), "K"},
      {"hole_time", QT_TRANSLATE_NOOP("Figure", "Time of the hole"), "s"},
      {"tries", QT_TRANSLATE_NOOP("Figure", "Tries"), ""}};
  return types;
}

DrillTries triesOf(const VolumeSnapshot& work) {
  return triesOf(work.tried.get(), work.holes);
}

MeasuredDrilling::MeasuredDrilling(const DrillingTask& task, const VolumeSnapshot& work, Progress progress)
    : m_tries(triesOf(work)), m_rule(task.failedTries) {
  const DrillSetup setup = task.setup();
  m_isAsPrepared =
      std::all_of(work.holes.begin(), work.holes.end(), [&](const auto& hole) { return isSame(hole->setup, setup); });
  if (!m_isAsPrepared) return;  // holes with another drill are not replayed
  m_review = reviewDrilling(task.volume(), task.plan, work.holes, progress);
  if (!m_review) return;
  m_isOfItsHoles = isSame(m_review->left, work.volume);
}

// Empty: it can be measured.
ExerciseText MeasuredDrilling::problem(const std::string& figure) const {
  if (!m_isAsPrepared) return {QT_TRANSLATE_NOOP("Note", "Another drill, speed or material was used.")};
  if (!m_review) return {QT_TRANSLATE_NOOP("Note", "The measuring was cancelled.")};
  if (!m_isOfItsHoles) return {QT_TRANSLATE_NOOP("Note", "The volume was changed by something else than the drill.")};
  if (!m_review->figures.contact) return {QT_TRANSLATE_NOOP("Note", "Nothing was drilled.")};
  if (!valueOf(figure)) return {QT_TRANSLATE_NOOP("Note", "The drill did not come through.")};
  return {};
}

std::optional<double> MeasuredDrilling::valueOf(const std::string& figure) const {
  return figure == "tries" ? std::optional(static_cast<double>(m_tries.count)) : valueIn(*m_review, figure);
}

// Adds the failed tries that entered the region. The present holes come first, as they may fail the work.
void MeasuredDrilling::addFailedTries(const MarkingCriterion& criterion, Measurement& figure) const {
  if (m_tries.failed.empty()) return;
  const double deepest =
      std::max_element(m_tries.failed.begin(), m_tries.failed.end(), [](const FailedTry& one, const FailedTry& other) {
        return one.forbidden < other.forbidden;
      })->forbidden;
  const ExerciseText remark = {
      QT_TRANSLATE_NOOP("Note", "Tries that entered it and were taken back: %1 of %2, by %3 mm at most."),
      {std::to_string(m_tries.failed.size()), std::to_string(m_tries.count), roundedText(deepest, 3)}};
  if (figure.remark.text.empty()) figure.remark = remark;
  if (m_rule == FailedTries::AreListed || deepest <= *figure.value || earnedShare(criterion, *figure.value) < 1.0)
    return;
  figure.value = deepest;
  figure.remark = remark;
  figure.isOfEarlierTry = m_rule == FailedTries::CostTheMark;
}

Measurement MeasuredDrilling::measure(const MarkingCriterion& criterion) const {
  Measurement figure{criterion.id, std::nullopt, problem(criterion.figure)};
  if (!figure.remark.text.empty()) return figure;
  figure.value = valueOf(criterion.figure);
  if (criterion.figure != "forbidden") return figure;
  if (*figure.value > 0.0) {
    const auto& moments = m_review->moments;
    const auto first =
        std::find_if(moments.begin(), moments.end(), [](const DrillMoment& m) { return m.forbidden > 0.0; });
    figure.remark = {QT_TRANSLATE_NOOP("Note", "It was entered %1 s after contact."),
                     {roundedText(first->time - *m_review->figures.contact, 3)}};
  }
  addFailedTries(criterion, figure);
  return figure;
}

}  // namespace handwheel
