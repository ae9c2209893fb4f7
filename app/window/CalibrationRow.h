// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace handwheel {

class Calibrator;
class FidelityChoice;

// Says where the curves were measured, measures them on this machine, and shows how far that is.
class CalibrationRow : public QWidget {
  Q_OBJECT

 public:
  CalibrationRow(FidelityChoice& choice, Calibrator& calibrator, QWidget* parent = nullptr);

 private:
  void refresh();
  QString origin() const;

  FidelityChoice& m_choice;
  Calibrator& m_calibrator;
  QLabel* m_text;
  QProgressBar* m_progress;
  QPushButton* m_button;
};

}  // namespace handwheel
