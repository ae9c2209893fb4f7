// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/exercise/MarkingReport.h"

#include <QWidget>

class QPushButton;

namespace handwheel {

class ResultTable;
class TimeLinePanel;

// The submissions of a class as a table that sorts by each column. The recordings of up to two selected submissions are
// shown on a time line.
class SubmissionsView : public QWidget {
  Q_OBJECT

 public:
  explicit SubmissionsView(QWidget* parent = nullptr);

  void setReport(SubmissionsReport report);
  // Returns the report with the works in the order of the table.
  SubmissionsReport shownReport() const;
  // Returns the report with only the selected works that were marked.
  SubmissionsReport comparedReport() const;

 signals:
  void markingRequested();
  void reportRequested();
  void comparisonRequested();
  void tableRequested();
  void openRequested(std::size_t work);  // index in the report
  void removalRequested(const std::vector<std::size_t>& works);

 private:
  void showRecordings();
  std::vector<std::size_t> selected() const;        // indices in the report
  std::vector<std::size_t> selectedMarked() const;  // indices of selected works that were marked

  SubmissionsReport m_report;
  ResultTable* m_table;
  QPushButton* m_writeReport;
  QPushButton* m_writeTable;
  QPushButton* m_compare;
  QPushButton* m_remove;
  TimeLinePanel* m_recordings;
};

}  // namespace handwheel
