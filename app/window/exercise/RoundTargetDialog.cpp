// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/RoundTargetDialog.h"

#include "controls/QuantityText.h"
#include "text/ErrorText.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

RoundTargetDialog::RoundTargetDialog(const ExerciseSubject& subject, TaskPointer task, QThreadPool& pool,
                                     QWidget* parent)
    : QDialog(parent),
      m_subject(subject),
      m_task(std::move(task)),
      m_values(roundTargetOperation()),
      m_list(new PropertyList(this)),
      m_remark(new QLabel(this)),
      m_jobs(JobRunner::Policy::Latest, pool) {
  setObjectName(QStringLiteral("roundTargetDialog"));
  setWindowTitle(tr("Round the target"));
  auto* layout = new QVBoxLayout(this);
  m_list->setMinimumSize(420, 120);
  layout->addWidget(m_list);
  m_remark->setWordWrap(true);
  m_remark->setObjectName(QStringLiteral("roundTargetRemark"));
  layout->addWidget(m_remark);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  m_round = buttons->addButton(tr("&Round"), QDialogButtonBox::AcceptRole);
  m_round->setObjectName(QStringLiteral("roundTarget"));
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &RoundTargetDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_list, &PropertyList::edited, this, [this](const std::string& id, const PropertyValue& value, bool) {
    const std::string problem = m_values.set(id, value);
    if (!problem.empty()) m_list->refuse(id, value, QString::fromStdString(problem));
    showValues();
  });
  showValues();
}

void RoundTargetDialog::showValues() {
  std::vector<Property> properties;
  for (const Parameter& parameter : roundTargetOperation().parameters) {
    properties.push_back(parameter.property);
    properties.back().value = *m_values.value(parameter.id());
  }
  m_list->setProperties(properties);
  m_rounded = nullptr;
  m_round->setEnabled(false);
  Job job;
  job.name = tr("Rounding the target");
  job.failed = [this](const Error& error) {
    if (error.code != ErrorCode::Cancelled) showRounded(error);
  };
  job.work = [this, &subject = m_subject, task = m_task, values = m_values](Progress) -> Job::Finish {
    return [this, rounded = withRoundedTarget(subject, *task, values)] { showRounded(rounded); };
  };
  m_jobs.start(std::move(job));
}

void RoundTargetDialog::showRounded(const Result<ExerciseSubject::RoundedTask>& rounded) {
  m_rounded = rounded ? rounded->task : nullptr;
  m_round->setEnabled(m_rounded != nullptr);
  if (!rounded) return m_remark->setText(errorSentence(rounded.error()));
  m_remark->setText(
      tr("A surface of the target changes by %1 at most.")
          .arg(quantityText(rounded->largestChange, Quantity::Length, LengthUnit::Millimetre, QLocale())));
}

void RoundTargetDialog::accept() {
  if (!m_rounded) return;
  emit chosen(m_rounded);
  QDialog::accept();
}

}  // namespace handwheel
