// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityCurve.h"
#include "base/FidelityRegistry.h"

#include <QObject>

namespace handwheel {

// What the user has chosen between speed and accuracy: a preset and single values. Kept in the settings; what works on
// documents reads it when it starts.
class FidelityChoice : public QObject {
  Q_OBJECT

 public:
  explicit FidelityChoice(QObject* parent = nullptr);

  const FidelityRegistry& registry() const { return m_registry; }
  const FidelityValues& values() const { return m_values; }
  double of(std::string_view id) const;  // of a registered setting

  void use(const FidelityValues& values);
  // Values out of range change nothing.
  void set(const std::string& id, double value);

  // As measured when the presets were derived; empty when it is not there.
  const std::vector<CurvePoint>& curve(const std::string& id) const;
  // What a value of a registered setting will err and cost by that curve: between two measured ones on the line that
  // joins them where the scales are logarithmic. None without a curve.
  std::optional<CurvePoint> predicted(const std::string& id, double value) const;

 signals:
  void changed();

 private:
  FidelityRegistry m_registry;
  mutable std::map<std::string, std::vector<CurvePoint>> m_curves;  // as far as they were asked for
  FidelityValues m_values;
};

}  // namespace handwheel
