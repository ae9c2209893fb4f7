// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/TimingPage.h"

#include "haptics/servo/ServoStatistics.h"
#include "panels/device/DeviceText.h"
#include "plot/PlotWidget.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

namespace {

constexpr int kTimingPlotHeight = 220;  // logical pixels

QString microseconds(const QLocale& locale, double seconds) {
  return TimingPage::tr("%1 µs").arg(locale.toString(seconds * 1e6, 'f', 0));
}

QString summaryOf(const TimingCounts& timing, const QLocale& locale) {
  if (timing.longest == 0.0) return TimingPage::tr("Nothing was measured yet.");
  const QString half = microseconds(locale, timing.median), most = microseconds(locale, timing.most);
  const QString longest = microseconds(locale, timing.longest - (timing.isOpen ? timing.binSeconds : 0.0));
  return timing.isOpen ? TimingPage::tr("Half within %1, 99 % within %2, some above %3").arg(half, most, longest)
                       : TimingPage::tr("Half within %1, 99 % within %2, all within %3").arg(half, most, longest);
}

}  // namespace

TimingPage::TimingPage(QWidget* parent)
    : QWidget(parent),
      m_warning(warning()),
      m_rate(new QLabel(this)),
      m_kind(new QComboBox(this)),
      m_plot(new PlotWidget(this)),
      m_summary(new QLabel(this)) {
  m_rate->setObjectName(QStringLiteral("servoRate"));
  m_rate->setWordWrap(true);
  m_kind->setObjectName(QStringLiteral("timingKind"));
  m_kind->setAccessibleName(tr("What is shown"));
  m_kind->addItems({tr("From tick to tick"), tr("How late a tick comes"), tr("Time spent in a tick")});
  m_plot->setObjectName(QStringLiteral("timingPlot"));
  m_plot->setMinimumHeight(kTimingPlotHeight);
  m_summary->setObjectName(QStringLiteral("timingSummary"));
  m_summary->setProperty("muted", true);
  m_summary->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 12);
  column->setSpacing(8);
  column->addWidget(m_warning);
  column->addWidget(m_rate);
  column->addWidget(m_kind);
  column->addWidget(m_plot, 1);
  column->addWidget(m_summary);
  connect(m_kind, &QComboBox::currentIndexChanged, this, &TimingPage::draw);
  showLoop({});
  draw();
}

QWidget* TimingPage::warning() {
  auto* frame = new QWidget(this);
  auto* advice = new QLabel(DeviceText::realTimeAdvice(), frame);
  advice->setObjectName(QStringLiteral("realTimeAdvice"));
  advice->setWordWrap(true);
  auto* command = new QLineEdit(DeviceText::realTimeCommand(), frame);
  command->setObjectName(QStringLiteral("realTimeCommand"));
  command->setAccessibleName(tr("Command"));
  command->setReadOnly(true);
  command->setCursorPosition(0);
  command->setToolTip(command->text());
  auto* copy = new QPushButton(tr("Copy"), frame);
  copy->setObjectName(QStringLiteral("copyCommand"));
  connect(copy, &QPushButton::clicked, this, [command] { QGuiApplication::clipboard()->setText(command->text()); });
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(command, 1);
  row->addWidget(copy);
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(0, 0, 0, 8);
  column->setSpacing(8);
  column->addWidget(advice);
  column->addLayout(row);
  frame->hide();
  return frame;
}

void TimingPage::showLoop(const ServoLoopStatus& loop) {
  m_warning->setVisible(loop.realTime == RealTimeState::NotPermitted);
  if (loop.realTime == RealTimeState::NotRunning) return m_rate->setText(tr("The servo loop is not running."));
  // Plural forms need whole numbers; the count of missed ticks may outgrow them.
  m_rate->setText(tr("%1 ticks a second, %2 missed so far")
                      .arg(locale().toString(loop.rate, 'f', 0), locale().toString(qulonglong(loop.missedTicks))));
}

void TimingPage::showTiming(const ServoStatistics& measure) {
  m_counts = {countsOf(measure.periods()), countsOf(measure.lateness()), countsOf(measure.delays())};
  if (m_plot->reading().isEmpty()) draw();
}

void TimingPage::clear() {
  m_counts = {};
  draw();
}

void TimingPage::draw() {
  const TimingCounts& timing = m_counts[static_cast<std::size_t>(m_kind->currentIndex())];
  m_plot->setPlot(timingPlot(timing, m_kind->currentText(), locale()));
  m_summary->setText(summaryOf(timing, locale()));
}

}  // namespace handwheel
