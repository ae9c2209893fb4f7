// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

#include "base/Units.h"
#include "mesh/Deviation.h"

#include <QWidget>
#include <optional>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace handwheel {

class NumberField;
class PlotWidget;
struct MeshDeviation;

// The figures of a comparison with their histogram, and what can be done with it.
class DeviationPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DeviationPanel(QWidget* parent = nullptr);

  // Null while the comparison is under way or was given up: status says so.
  void show(const MeshDeviation* deviation, LengthUnit unit, const QString& status = {});
  // As it is shown.
  QString reading() const;
  // What the surface under the pointer is away from the scan; none: it does not point at it.
  void setReading(const std::optional<double>& distance);

 signals:
  void placeChosen(const handwheel::DeviationPlace& place);
  void rangeChosen(double range);  // mm
  void otherFileWanted();
  void reportWanted();
  void closed();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void buildFigures(QVBoxLayout* column);
  void showFigures(const MeshDeviation& deviation);
  void showHistogram();
  QString lengthText(double mm) const;

  const MeshDeviation* m_deviation = nullptr;
  LengthUnit m_unit = LengthUnit::Millimetre;
  QLabel* m_title;
  QLabel* m_status;
  QWidget* m_content;  // all that needs a result
  QPushButton* m_highest;
  QPushButton* m_lowest;
  std::vector<QLabel*> m_values;  // of the other figures
  NumberField* m_range;
  PlotWidget* m_histogram;
  QLabel* m_reading;
};

}  // namespace handwheel
