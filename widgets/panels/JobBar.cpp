// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/JobBar.h"

#include "theme/Icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace handwheel {

namespace {
constexpr int kSteps = 128;  // pixels of the bar
}

JobBar::JobBar(QWidget* parent) : QWidget(parent), m_name(new QLabel(this)), m_progress(new QProgressBar(this)) {
  setObjectName(QStringLiteral("jobBar"));
  m_name->setObjectName(QStringLiteral("jobName"));
  m_progress->setObjectName(QStringLiteral("jobProgress"));
  m_progress->setTextVisible(false);
  m_progress->setFixedWidth(128);
  auto* cancel = new QToolButton(this);
  cancel->setObjectName(QStringLiteral("jobCancel"));
  cancel->setIcon(icon(QStringLiteral("close")));
  cancel->setIconSize({12, 12});
  cancel->setToolTip(tr("Cancel this job"));
  cancel->setAccessibleName(cancel->toolTip());
  connect(cancel, &QToolButton::clicked, this, &JobBar::cancelRequested);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 0, 8, 0);
  row->setSpacing(8);
  row->addWidget(m_name);
  row->addWidget(m_progress);
  row->addWidget(cancel);
  hide();
}

void JobBar::showJob(const QString& name) {
  m_name->setText(name);
  m_progress->setAccessibleName(name);
  m_progress->setRange(0, 0);  // unknown until the job says more
  m_progress->reset();
  show();
}

void JobBar::setProgress(double fraction) {
  const int step = static_cast<int>(fraction * kSteps);
  if (step <= 0 || step == m_progress->value()) return;
  // QProgressBar would draw itself before it returns, and the 3D view with it; this asks for the next frame instead.
  m_progress->setUpdatesEnabled(false);
  m_progress->setRange(0, kSteps);
  m_progress->setValue(step);
  m_progress->setUpdatesEnabled(true);
}

void JobBar::hideJob() {
  hide();
}

}  // namespace handwheel
