// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityFit.h"
#include "fidelity/Calibration.h"

#include <QObject>

namespace handwheel {

// The user's choice between speed and accuracy: a preset and single values. It is stored in the settings; jobs read it
// when they start.
class FidelityChoice : public QObject {
  Q_OBJECT

 public:
  explicit FidelityChoice(QObject* parent = nullptr);

  const FidelityRegistry& registry() const { return m_registry; }
  const FidelityValues& values() const { return m_values; }
  double of(std::string_view id) const;  // value of a registered setting

  void use(const FidelityValues& values);
  // Sets a value. A value that is out of range is ignored.
  void set(const std::string& id, double value);

  // The measured curve of a setting. It was measured on this machine, or else on the one from which the presets were
  // derived; empty: there is no curve.
  const std::vector<CurvePoint>& curve(const std::string& id) const { return known(id).curve; }
  // The stored measurement of a setting, with its machine and date.
  const CurveFile& measurement(const std::string& id) const { return known(id).file; }
  // Returns the error and cost of a value of a registered setting, predicted by curve(). Interpolates linearly on
  // logarithmic scales between measured points. Returns nothing if there is no curve.
  std::optional<CurvePoint> predicted(const std::string& id, double value) const;

  // Returns the predicted duration (us) of a tick in contact for a loop of this rate (Hz). Returns nothing if there are
  // no curves.
  std::optional<double> predictedTick(double rate) const;

  // The measurements on this machine, which replace the curves that come with the program.
  const Calibration& calibration() const { return m_calibration; }
  void setCalibration(const Calibration& calibration);

  // Returns the preset Fit according to the present curves. The result is cached until the curves change.
  const FidelityFit& fit() const;
  bool isFit() const;  // returns true if the present values are those of Fit

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
  mutable std::map<std::string, Known> m_known;  // filled on demand
  mutable std::optional<FidelityFit> m_fit;
  FidelityValues m_values;
};

}  // namespace handwheel
