// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/SubmissionsView.h"

#include "panels/ResultModel.h"
#include "panels/ResultTable.h"
#include "panels/time/TimeLinePanel.h"
#include "window/exercise/ReasonText.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QGridLayout>
#include <QItemSelectionModel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

namespace {

QString figureWord(const std::string& text) {
  return QCoreApplication::translate("Figure", text.c_str());
}

// Returns a time in the local time zone; sorted by time.
ResultCell timeCell(const std::string& utc) {
  const QDateTime at = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  if (!at.isValid()) return {QString::fromStdString(utc)};
  return {QLocale().toString(at.toLocalTime(), QLocale::ShortFormat), static_cast<double>(at.toSecsSinceEpoch())};
}

ResultCell cellOf(const Exercise& exercise, const SubmissionTable& table, std::size_t row, std::size_t column) {
  if (column == SubmissionTable::HandedIn) return timeCell(table.rows()[row].attempt.handedIn);
  ResultCell cell{QString::fromStdString(table.cell(row, column))};
  if (column == SubmissionTable::Made && !cell.text.isEmpty())
    cell.text = QCoreApplication::translate("SubmissionTable", cell.text.toUtf8().constData());
  bool isNumber = false;
  const double number = cell.text.toDouble(&isNumber);
  if (table.isNumber(column) && isNumber) cell.number = number;
  const SubmissionRow& shown = table.rows()[row];
  if (column == SubmissionTable::Student && (!shown.remarks.empty() || !shown.problem.empty())) {
    QStringList reasons;
    if (!shown.problem.empty()) reasons += QString::fromStdString(shown.problem);
    for (const std::string& remark : shown.remarks) reasons += QString::fromStdString(remark);
    cell.state = ResultCell::State::Bad;
    cell.reason = reasons.join(QLatin1Char('\n'));
  }
  if (column == SubmissionTable::Student && cell.text.isEmpty()) cell.text = QString::fromStdString(shown.file);
  if (column < SubmissionTable::FirstCriterion) return cell;
  const Mark* const mark = shown.marking.find(exercise.criteria[column - SubmissionTable::FirstCriterion].id);
  if (!mark) return cell;
  cell.state = mark->points == mark->of ? ResultCell::State::Good : ResultCell::State::Bad;
  cell.reason = reasonText(*mark);
  return cell;
}

// Returns the recording of one student's work over time.
TimeLineRecording recordingOf(const ReportedWork& work) {
  TimeLineRecording recording;
  const SubmissionRow& row = work.row;
  recording.name = QString::fromStdString(row.attempt.student.empty() ? row.file : row.attempt.student);
  recording.duration = work.details.seconds;
  for (const ReportCurve& curve : work.details.curves) {
    if (curve.xUnit != "s" || curve.series.empty()) continue;
    TimeLineCurve line{figureWord(curve.title), QString::fromStdString(curve.yUnit), {}};
    for (const auto& [x, y] : curve.series.front().points) line.points.emplace_back(x, y);
    recording.curves.push_back(std::move(line));
  }
  for (const ReportEvent& event : work.details.events)
    if (event.seconds)
      recording.markers.push_back({*event.seconds, exerciseText(event.text), TimeLineMarker::Severity::Error});
  return recording;
}

}  // namespace

SubmissionsView::SubmissionsView(QWidget* parent)
    : QWidget(parent), m_table(new ResultTable(this)), m_recordings(new TimeLinePanel(this)) {
  setObjectName(QStringLiteral("classView"));
  auto* column = new QVBoxLayout(this);
  auto* buttons = new QGridLayout;  // in pairs: the panel may be narrow
  const auto button = [&](const QString& text, const char* name) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(QString::fromLatin1(name));
    buttons->addWidget(made, buttons->count() / 2, buttons->count() % 2);
    return made;
  };
  QPushButton* mark = button(tr("&Mark…"), "markSubmissions");
  mark->setToolTip(tr("Mark files that students have handed in"));
  m_writeReport = button(tr("&Report…"), "classReport");
  m_writeTable = button(tr("&Table…"), "classTable");
  m_compare = button(tr("&Compare…"), "classCompare");
  m_compare->setToolTip(tr("Write a report of the two selected works side by side (Ctrl+click selects a second one)"));
  m_remove = button(tr("Remo&ve"), "classRemove");
  m_remove->setToolTip(tr("Remove the selected works from the class; their files stay"));
  m_table->setObjectName(QStringLiteral("classRows"));
  m_table->setAccessibleName(tr("Submissions"));
  column->addLayout(buttons);
  column->addWidget(m_table, 1);
  column->addWidget(m_recordings);
  connect(mark, &QPushButton::clicked, this, &SubmissionsView::markingRequested);
  connect(m_writeReport, &QPushButton::clicked, this, &SubmissionsView::reportRequested);
  connect(m_writeTable, &QPushButton::clicked, this, &SubmissionsView::tableRequested);
  connect(m_compare, &QPushButton::clicked, this, &SubmissionsView::comparisonRequested);
  connect(m_remove, &QPushButton::clicked, this, [this] { emit removalRequested(selected()); });
  connect(m_table, &ResultTable::rowActivated, this, &SubmissionsView::openRequested);
  connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SubmissionsView::showRecordings);
  setReport({});
}

void SubmissionsView::setReport(SubmissionsReport report) {
  m_report = std::move(report);
  SubmissionTable table(m_report.exercise);
  for (const ReportedWork& work : m_report.works) table.add(work.row);
  QStringList headings;
  for (std::size_t i = 0; i < table.columns(); ++i) {
    const std::string heading = table.heading(i);
    headings += i < SubmissionTable::FirstCriterion ? QCoreApplication::translate("SubmissionTable", heading.c_str())
                                                    : QString::fromStdString(heading);
  }
  std::vector<ResultModel::Row> rows(table.rows().size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t i = 0; i < table.columns(); ++i) rows[row].push_back(cellOf(m_report.exercise, table, row, i));
  }
  m_table->setTable(std::move(headings), std::move(rows));
  m_writeReport->setEnabled(!m_report.works.empty());
  m_writeTable->setEnabled(!m_report.works.empty());
  showRecordings();
}

SubmissionsReport SubmissionsView::shownReport() const {
  const auto* model = static_cast<const ResultModel*>(m_table->model());
  SubmissionsReport shown{m_report.exercise, m_report.figures, {}};
  for (int row = 0; row < model->rowCount(); ++row) shown.works.push_back(m_report.works[model->source(row)]);
  return shown;
}

std::vector<std::size_t> SubmissionsView::selected() const {
  const auto* model = static_cast<const ResultModel*>(m_table->model());
  std::vector<std::size_t> works;
  for (const QModelIndex& row : m_table->selectionModel()->selectedRows()) {
    const std::size_t source = model->source(row.row());
    if (source < m_report.works.size()) works.push_back(source);
  }
  return works;
}

std::vector<std::size_t> SubmissionsView::selectedMarked() const {
  std::vector<std::size_t> works = selected();
  std::erase_if(works, [&](std::size_t work) { return !m_report.works[work].row.problem.empty(); });
  return works;
}

SubmissionsReport SubmissionsView::comparedReport() const {
  SubmissionsReport compared{m_report.exercise, m_report.figures, {}};
  for (const std::size_t work : selectedMarked()) compared.works.push_back(m_report.works[work]);
  return compared;
}

void SubmissionsView::showRecordings() {
  std::vector<TimeLineRecording> recordings;
  const std::vector<std::size_t> marked = selectedMarked();
  for (const std::size_t work : marked)
    if (!m_report.works[work].isKept) recordings.push_back(recordingOf(m_report.works[work]));
  m_compare->setEnabled(marked.size() == 2);
  m_remove->setEnabled(!selected().empty());
  m_recordings->setVisible(!recordings.empty());
  m_recordings->setRecordings(std::move(recordings));
}

}  // namespace handwheel
