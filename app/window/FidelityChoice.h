// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityFit.h"
#include "fidelity/Calibration.h"

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

  // As measured on this machine, else as when the presets were derived; empty when it is not there.
  const std::vector<CurvePoint>& curve(const std::string& id) const { return known(id).curve; }
  // Where and when that was.
  const CurveFile& measurement(const std::string& id) const { return known(id).file; }
  // What a value of a registered setting will err and cost by that curve: between two measured ones on the line that
  // joins them where the scales are logarithmic. None without a curve.
  std::optional<CurvePoint> predicted(const std::string& id, double value) const;

  // us: what a tick of a loop takes at so many Hz while a surface is touched. None without curves.
  std::optional<double> predictedTick(double rate) const;

  // What was measured on this machine takes the place of the curves that come with the program.
  const Calibration& calibration() const { return m_calibration; }
  void setCalibration(const Calibration& calibration);

  // The preset Fit, by the curves as they are now. Cheap but for the first time.
  const FidelityFit& fit() const;
  bool isFit() const;  // these are the values

 signals:
  void changed();
  void curvesChanged();

 private:
  struct Known {
    CurveFile file;
    std::vector<CurvePoint> curve;
  };
  const Known& known(const std::string& id) const;
  Known read(const FidelitySetting& setting) const;
  double longerInUse(double rate) const;

  FidelityRegistry m_registry;
  Calibration m_calibration;
  mutable std::map<std::string, Known> m_known;  // as far as it was asked for
  mutable std::optional<FidelityFit> m_fit;
  FidelityValues m_values;
};

}  // namespace handwheel
