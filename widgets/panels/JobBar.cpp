// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/JobBar.h"

#include "base/JobClock.h"
#include "theme/Icons.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>

namespace handwheel {

namespace {
constexpr int kSteps = 128;    // pixels of the bar
constexpr int kLongest = 240;  // pixels of a name

// Many names contain that of the document.
QString textOf(const JobStatus& job) {
  const bool isOfDocument = !job.document.isEmpty() && !job.name.contains(job.document);
  const QString name = isOfDocument ? JobBar::tr("%1 — %2").arg(job.name, job.document) : job.name;
  return job.isWaiting ? JobBar::tr("%1 (waiting)").arg(name) : name;
}
}  // namespace

// Name, progress and cancel of one job.
class JobLine : public QWidget {
 public:
  JobLine(const QString& suffix, QWidget* parent)
      : QWidget(parent),
        m_name(new QLabel(this)),
        m_time(new QLabel(this)),
        m_progress(new QProgressBar(this)),
        m_cancel(new QToolButton(this)) {
    m_name->setObjectName(QStringLiteral("jobName") + suffix);
    m_progress->setObjectName(QStringLiteral("jobProgress") + suffix);
    m_time->setObjectName(QStringLiteral("jobTime") + suffix);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(kSteps);
    m_cancel->setObjectName(QStringLiteral("jobCancel") + suffix);
    m_cancel->setIcon(icon(QStringLiteral("close")));
    m_cancel->setIconSize({12, 12});
    m_cancel->setToolTip(JobBar::tr("Cancel this job"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_name, 1);
    row->addWidget(m_time);
    row->addWidget(m_progress);
    row->addWidget(m_cancel);
  }

  QToolButton* cancel() const { return m_cancel; }
  quint64 id() const { return m_id; }

  void showJob(const JobStatus& job) {
    m_id = job.id;
    const QString name = textOf(job);
    if (name != m_name->toolTip()) showName(name);
    m_progress->setVisible(!job.isWaiting);
    showProgress(job.fraction);
    const QString elapsed = QString::fromStdString(elapsedText(job.seconds));
    const QString time = elapsed.isEmpty() ? elapsed : JobBar::tr("for %1").arg(elapsed);
    if (time != m_time->text()) m_time->setText(time);
  }

 private:
  void showName(const QString& name) {
    m_name->setText(m_name->fontMetrics().elidedText(name, Qt::ElideMiddle, kLongest));
    m_name->setToolTip(name);
    m_progress->setAccessibleName(name);
    m_cancel->setAccessibleName(JobBar::tr("Cancel “%1”").arg(name));
  }

  // QProgressBar would draw itself before it returns, and the 3D view with it; this asks for the next frame instead.
  void showProgress(double fraction) {
    const int step = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kSteps);
    const bool known = step > 0;
    if (known == (m_progress->maximum() > 0) && step == std::max(0, m_progress->value())) return;
    m_progress->setUpdatesEnabled(false);
    m_progress->setRange(0, known ? kSteps : 0);
    known ? m_progress->setValue(step) : m_progress->reset();
    m_progress->setUpdatesEnabled(true);
  }

  QLabel* m_name;
  QLabel* m_time;
  QProgressBar* m_progress;
  QToolButton* m_cancel;
  quint64 m_id = 0;
};

JobBar::JobBar(QWidget* parent)
    : QWidget(parent), m_more(new QToolButton(this)), m_others(new QFrame(this, Qt::Popup)) {
  setObjectName(QStringLiteral("jobBar"));
  m_first = addLine(this);
  m_more->setObjectName(QStringLiteral("jobMore"));
  m_more->setToolTip(tr("Show all jobs"));
  m_others->setObjectName(QStringLiteral("jobList"));
  m_others->setProperty("popup", true);
  m_others->setAccessibleName(tr("Jobs"));
  m_column = new QVBoxLayout(m_others);
  m_column->setContentsMargins(12, 8, 8, 8);
  m_column->setSpacing(4);
  connect(m_more, &QToolButton::clicked, this, &JobBar::showOthers);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 0, 8, 0);
  row->setSpacing(8);
  row->addWidget(m_first);
  row->addWidget(m_more);
  hide();
}

JobLine* JobBar::addLine(QWidget* parent) {
  const QString suffix = parent == this ? QString() : QStringLiteral("/%1").arg(m_lines.size());
  auto* line = new JobLine(suffix, parent);
  // Between press and release the line may have gone over to another job.
  connect(line->cancel(), &QToolButton::pressed, this, [this, line] { m_pressed = line->id(); });
  connect(line->cancel(), &QToolButton::clicked, this, [this] { emit cancelJobRequested(m_pressed); });
  return line;
}

void JobBar::setJobs(const std::vector<JobStatus>& jobs) {
  const bool isOtherSize = jobs.size() != m_count;
  m_count = jobs.size();
  if (!jobs.empty()) m_first->showJob(jobs.front());
  for (std::size_t i = m_lines.size(); i < jobs.size(); ++i) {
    m_lines.push_back(addLine(m_others));
    m_column->addWidget(m_lines.back());
  }
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    m_lines[i]->setVisible(i < jobs.size());
    if (i < jobs.size()) m_lines[i]->showJob(jobs[i]);
  }
  const auto others = static_cast<int>(jobs.size()) - 1;
  m_more->setVisible(others > 0);
  m_more->setText(tr("+%1").arg(others));
  m_more->setAccessibleName(tr("%n more job(s)", nullptr, others));
  if (others <= 0) m_others->hide();
  if (isOtherSize && m_others->isVisible()) showOthers();
  setVisible(!jobs.empty());
}

// Shows them above the bar, the right ends flush.
void JobBar::showOthers() {
  m_others->adjustSize();
  const QPoint corner = mapToGlobal(QPoint(width(), 0));
  m_others->move(corner.x() - m_others->width(), corner.y() - m_others->height() - 4);
  m_others->show();
}

}  // namespace handwheel
