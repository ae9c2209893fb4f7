// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/fidelity/FidelityChoice.h"

#include "fidelity/MeasuredSettings.h"
#include "haptics/scene/TouchFidelity.h"

#include <QFile>
#include <QSettings>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

const auto kFidelityKey = QStringLiteral("fidelity");

// Returns the curve that comes with the program.
CurveFile shippedCurve(const FidelitySetting& setting) {
  QFile file(QStringLiteral(":/fidelity/") + QString::fromStdString(setting.id) + QStringLiteral(".json"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const auto read = readCurveFile(setting, file.readAll().toStdString());
  return read ? *read : CurveFile();
}

// Linear where one of them is zero; infinite where one of them is.
double between(double a, double b, double share) {
  if (a > 0.0 && b > 0.0 && std::isfinite(a + b)) return a * std::pow(b / a, share);
  return (1.0 - share) * a + share * b;
}

}  // namespace

FidelityChoice::FidelityChoice(QObject* parent) : QObject(parent), m_registry(measuredSettings()) {
  const auto kept = readValues(m_registry, QSettings().value(kFidelityKey).toString().toStdString());
  if (kept) m_values = *kept;
}

double FidelityChoice::of(std::string_view id) const {
  return m_values.of(m_registry.find(id)->setting);
}

void FidelityChoice::use(const FidelityValues& values) {
  m_values = values;
  QSettings().setValue(kFidelityKey, QString::fromStdString(textOf(m_registry, m_values)));
  emit changed();
}

void FidelityChoice::set(const std::string& id, double value) {
  const FidelityRegistry::Entry* entry = m_registry.find(id);
  FidelityValues values = m_values;
  if (entry && values.set(entry->setting, value)) use(values);
}

FidelityChoice::Known FidelityChoice::read(const FidelitySetting& setting) const {
  const auto own = m_calibration.curves.find(setting.id);
  Known known{own != m_calibration.curves.end() ? own->second : shippedCurve(setting), {}};
  known.curve = curveOf(known.file.rows);
  return known;
}

const FidelityChoice::Known& FidelityChoice::known(const std::string& id) const {
  const auto [at, isNew] = m_known.try_emplace(id);
  if (isNew) at->second = read(m_registry.find(id)->setting);
  return at->second;
}

void FidelityChoice::setCalibration(const Calibration& calibration) {
  m_calibration = calibration;
  m_known.clear();
  m_fit.reset();
  emit curvesChanged();
}

const FidelityFit& FidelityChoice::fit() const {
  if (m_fit) return *m_fit;
  std::vector<FitCandidate> candidates;
  const double longer = longerInUse(servoRateSetting().standard);
  for (const FidelityRegistry::Entry& entry : m_registry.entries()) {
    FitCandidate candidate = fitCandidate(entry.setting, known(entry.setting.id).file.rows);
    const bool isOfLoop = entry.setting.budget == FidelityBudget::Core || entry.setting.budget == FidelityBudget::Tick;
    for (CurvePoint& p : candidate.curve) p.cost *= isOfLoop ? longer : 1.0;
    candidates.push_back(std::move(candidate));
  }
  return m_fit.emplace(chooseWithinBudgets(candidates));
}

// Curves are read only for values that could be those.
bool FidelityChoice::isFit() const {
  return m_values.preset() == FidelityPreset::Balanced && !m_values.overrides().empty() && m_values == fit().values;
}

// Curves are measured with one tick upon the other: how much longer one takes when the loop sleeps in between. 1 where
// that was not measured.
double FidelityChoice::longerInUse(double rate) const {
  const auto& ticks = m_calibration.ticksInUse;
  const auto curve = predicted(servoRateSetting().id, rate);
  if (ticks.empty() || !curve || !(curve->cost > 0.0)) return 1.0;
  const auto above = ticks.lower_bound(rate);
  double tick = above == ticks.end() ? ticks.rbegin()->second : above->second;
  if (above != ticks.end() && above != ticks.begin()) {
    const auto below = std::prev(above);
    tick = between(below->second, above->second, std::log(rate / below->first) / std::log(above->first / below->first));
  }
  return tick * rate / curve->cost;
}

std::optional<double> FidelityChoice::predictedTick(double rate) const {
  const auto atRate = predicted(servoRateSetting().id, rate);
  if (!atRate) return std::nullopt;
  return longerInUse(rate) * atRate->cost / rate;
}

std::optional<CurvePoint> FidelityChoice::predicted(const std::string& id, double value) const {
  const std::vector<CurvePoint>& points = curve(id);
  if (points.empty()) return std::nullopt;
  const auto above = std::lower_bound(points.begin(), points.end(), value,
                                      [](const CurvePoint& point, double v) { return point.value < v; });
  if (above == points.end()) return CurvePoint{value, points.back().error, points.back().cost};
  if (above == points.begin() || above->value == value) return CurvePoint{value, above->error, above->cost};
  const CurvePoint& below = *(above - 1);
  const FidelitySetting& setting = m_registry.find(id)->setting;
  const double start = scalePositionOf(setting, below.value);
  const double share = (scalePositionOf(setting, value) - start) / (scalePositionOf(setting, above->value) - start);
  return CurvePoint{value, between(below.error, above->error, share), between(below.cost, above->cost, share)};
}

}  // namespace handwheel
