// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "base/Units.h"
#include "mesh/measure/Deviation.h"

#include <QWidget>
#include <optional>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace handwheel {

class NumberField;
class PlotWidget;
struct MeshDeviation;

// The panel with statistics, histogram and actions of a deviation comparison.
class DeviationPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DeviationPanel(QWidget* parent = nullptr);

  // Shows a comparison. deviation: null while the comparison is running or after it was cancelled. status: the text
  // that describes this state.
  void show(const MeshDeviation* deviation, LengthUnit unit, const QString& status = {});
  // Returns the displayed distance under the pointer.
  QString reading() const;
  // Shows the distance of the surface point under the pointer from the surface that the mesh is compared with; none:
  // the pointer is not on the mesh.
  void setReading(const std::optional<double>& distance);

 signals:
  void positionChosen(const handwheel::DeviationExtremum& position);
  void rangeChosen(double range);  // mm
  void otherFileRequested();
  void reportRequested();
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
  QWidget* m_content;  // the widgets that need a result
  QPushButton* m_highest;
  QPushButton* m_lowest;
  std::vector<QLabel*> m_values;  // values of the other statistics
  NumberField* m_range;
  PlotWidget* m_histogram;
  QLabel* m_reading;
};

}  // namespace handwheel
