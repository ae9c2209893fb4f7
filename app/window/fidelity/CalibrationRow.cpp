// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/fidelity/CalibrationRow.h"

#include "window/fidelity/BenchmarkRunner.h"
#include "window/fidelity/FidelityChoice.h"

#include <QDate>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

namespace {

constexpr int kProgressSteps = 1000;

QString dateOf(const CurveFile& curve, const QLocale& locale) {
  const QDate date = QDate::fromString(QString::fromStdString(curve.date), Qt::ISODate);
  return locale.toString(date, QLocale::ShortFormat);
}

}  // namespace

CalibrationRow::CalibrationRow(FidelityChoice& choice, BenchmarkRunner& calibrator, QWidget* parent)
    : QWidget(parent),
      m_choice(choice),
      m_calibrator(calibrator),
      m_text(new QLabel(this)),
      m_progress(new QProgressBar(this)),
      m_button(new QPushButton(this)) {
  m_text->setObjectName(QStringLiteral("calibrationText"));
  m_text->setProperty("muted", true);
  m_text->setWordWrap(true);
  m_progress->setObjectName(QStringLiteral("calibrationProgress"));
  m_progress->setAccessibleName(tr("Measuring this machine"));
  m_progress->setTextVisible(false);
  m_progress->setRange(0, kProgressSteps);
  m_button->setObjectName(QStringLiteral("calibrateButton"));
  auto* row = new QHBoxLayout;
  row->addWidget(m_progress, 1);
  row->addStretch();
  row->addWidget(m_button);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_text);
  column->addLayout(row);
  connect(m_button, &QPushButton::clicked, this,
          [this] { m_calibrator.isRunning() ? m_calibrator.cancel() : m_calibrator.start(); });
  connect(&calibrator, &BenchmarkRunner::changed, this, &CalibrationRow::refresh);
  connect(&choice, &FidelityChoice::curvesChanged, this, &CalibrationRow::refresh);
  connect(&calibrator, &BenchmarkRunner::progressed, this,
          [this] { m_progress->setValue(static_cast<int>(m_calibrator.fraction() * kProgressSteps)); });
  refresh();
}

void CalibrationRow::refresh() {
  const bool isRunning = m_calibrator.isRunning();
  QStringList lines{isRunning ? tr("Measuring this machine: %1").arg(m_calibrator.present()) : origin()};
  if (!m_calibrator.problem().isEmpty()) lines << m_calibrator.problem();
  m_text->setText(lines.join(QLatin1Char('\n')));
  m_progress->setVisible(isRunning);
  m_progress->setValue(static_cast<int>(m_calibrator.fraction() * kProgressSteps));
  m_button->setText(isRunning ? tr("Cancel") : tr("Measure this machine"));
  m_button->setToolTip(isRunning ? QString() : tr("Takes about half a minute. You can go on working."));
}

QString CalibrationRow::origin() const {
  const auto entries = machineDependent(m_choice.registry());
  const auto& own = m_choice.calibration().curves;
  const CurveFile& first = m_choice.measurement(entries.front()->setting.id);
  if (own.empty())
    return tr("The curves were supplied with the program: %1, %2.")
        .arg(QString::fromStdString(first.machine), dateOf(first, locale()));
  if (own.size() == entries.size())
    return tr("The curves were measured on this machine, %1.").arg(dateOf(first, locale()));
  return tr("%1 of %2 curves were measured on this machine.").arg(own.size()).arg(entries.size());
}

}  // namespace handwheel
