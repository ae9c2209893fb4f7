// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/FidelityChoice.h"

#include "fidelity/CurveFile.h"
#include "fidelity/MeasuredSettings.h"

#include <QFile>
#include <QSettings>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

const auto kKey = QStringLiteral("fidelity");

std::vector<CurvePoint> readCurve(const FidelitySetting& setting) {
  QFile file(QStringLiteral(":/fidelity/") + QString::fromStdString(setting.id) + QStringLiteral(".json"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const auto read = readCurveFile(setting, file.readAll().toStdString());
  return read ? curveOf(read->rows) : std::vector<CurvePoint>();
}

// Linear where one of them is zero; infinite where one of them is.
double between(double a, double b, double share) {
  if (a > 0.0 && b > 0.0 && std::isfinite(a + b)) return a * std::pow(b / a, share);
  return (1.0 - share) * a + share * b;
}

}  // namespace

FidelityChoice::FidelityChoice(QObject* parent) : QObject(parent), m_registry(measuredSettings()) {
  const auto kept = readValues(m_registry, QSettings().value(kKey).toString().toStdString());
  if (kept) m_values = *kept;
}

double FidelityChoice::of(std::string_view id) const {
  return m_values.of(m_registry.find(id)->setting);
}

void FidelityChoice::use(const FidelityValues& values) {
  m_values = values;
  QSettings().setValue(kKey, QString::fromStdString(textOf(m_registry, m_values)));
  emit changed();
}

void FidelityChoice::set(const std::string& id, double value) {
  const FidelityRegistry::Entry* entry = m_registry.find(id);
  FidelityValues values = m_values;
  if (entry && values.set(entry->setting, value)) use(values);
}

const std::vector<CurvePoint>& FidelityChoice::curve(const std::string& id) const {
  const auto [at, isNew] = m_curves.try_emplace(id);
  if (isNew) at->second = readCurve(m_registry.find(id)->setting);
  return at->second;
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
  const double start = placeOf(setting, below.value);
  const double share = (placeOf(setting, value) - start) / (placeOf(setting, above->value) - start);
  return CurvePoint{value, between(below.error, above->error, share), between(below.cost, above->cost, share)};
}

}  // namespace handwheel
