// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace handwheel {

class BenchmarkRunner;
class FidelityChoice;

// Shows the origin of the measured curves and starts a calibration. The progress is shown while a calibration runs.
class CalibrationRow : public QWidget {
  Q_OBJECT

 public:
  CalibrationRow(FidelityChoice& choice, BenchmarkRunner& calibrator, QWidget* parent = nullptr);

 private:
  void refresh();
  QString origin() const;

  FidelityChoice& m_choice;
  BenchmarkRunner& m_calibrator;
  QLabel* m_text;
  QProgressBar* m_progress;
  QPushButton* m_button;
};

}  // namespace handwheel
