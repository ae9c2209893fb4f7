// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/JobStatus.h"

#include <QWidget>
#include <vector>

class QToolButton;
class QVBoxLayout;

namespace handwheel {

class JobLine;

// A widget that shows the running jobs in the status bar. The first job is shown with name, progress and a cancel
// button; a button opens the list of the others.
class JobBar : public QWidget {
  Q_OBJECT

 public:
  explicit JobBar(QWidget* parent = nullptr);

  void setJobs(const std::vector<JobStatus>& jobs);

 signals:
  void cancelJobRequested(quint64 id);

 private:
  JobLine* addLine(QWidget* parent);
  void showOthers();

  JobLine* m_first;
  QToolButton* m_more;
  QWidget* m_others;
  QVBoxLayout* m_column;
  std::vector<JobLine*> m_lines;
  std::size_t m_count = 0;
  quint64 m_pressed = 0;  // the job whose cancel button was pressed
};

}  // namespace handwheel
