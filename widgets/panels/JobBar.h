// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;

namespace handwheel {

// The running job in the status bar: name, progress, cancel.
class JobBar : public QWidget {
  Q_OBJECT

 public:
  explicit JobBar(QWidget* parent = nullptr);

  void showJob(const QString& name);
  void setProgress(double fraction);  // 0…1
  void hideJob();

 signals:
  void cancelRequested();

 private:
  QLabel* m_name;
  QProgressBar* m_progress;
};

}  // namespace handwheel
