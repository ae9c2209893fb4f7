// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/FidelityChoice.h"

#include "fidelity/CurveFile.h"
#include "fidelity/MeasuredSettings.h"

#include <QFile>
#include <QSettings>

namespace handwheel {

namespace {
const auto kKey = QStringLiteral("fidelity");
}

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

std::vector<CurvePoint> FidelityChoice::curve(const std::string& id) const {
  QFile file(QStringLiteral(":/fidelity/") + QString::fromStdString(id) + QStringLiteral(".json"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const auto read = readCurveFile(m_registry.find(id)->setting, file.readAll().toStdString());
  return read ? curveOf(read->rows) : std::vector<CurvePoint>();
}

}  // namespace handwheel
