// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QToolButton;
class QVBoxLayout;

namespace handwheel {

class JobLine;

struct JobStatus {
  quint64 id = 0;
  QString name;
  double fraction = -1.0;  // 0…1; below zero: not known yet
};

// The running jobs in the status bar: the first with name, progress and cancel, the others behind a button.
class JobBar : public QWidget {
  Q_OBJECT

 public:
  explicit JobBar(QWidget* parent = nullptr);

  void setJobs(const std::vector<JobStatus>& jobs);

  // For a single job; its id is 0.
  void showJob(const QString& name);
  void setProgress(double fraction);
  void hideJob();

 signals:
  void cancelJobRequested(quint64 id);
  void cancelRequested();

 private:
  JobLine* addLine(QWidget* parent);
  void showOthers();

  JobLine* m_first;
  QToolButton* m_more;
  QWidget* m_others;
  QVBoxLayout* m_column;
  std::vector<JobLine*> m_lines;
  std::vector<JobStatus> m_jobs;
};

}  // namespace handwheel
