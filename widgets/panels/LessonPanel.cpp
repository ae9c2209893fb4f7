// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LessonPanel.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr int kLeastList = 96;             // pixels, where many steps have little room
constexpr double kLongestTime = 359999.0;  // s: below 100 hours

QLabel* lessonLabel(const char* name, const char* look, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QString::fromLatin1(name));
  label->setTextFormat(Qt::PlainText);  // exercises come from anywhere
  label->setWordWrap(true);
  if (look) label->setProperty(look, true);
  return label;
}

void setLook(QLabel* label, const char* look, bool isOn) {
  if (label->property(look).toBool() == isOn) return;
  label->setProperty(look, isOn);
  label->style()->unpolish(label);  // the style sheet reads the property
  label->style()->polish(label);
}

}  // namespace

LessonPanel::LessonPanel(QWidget* parent)
    : QWidget(parent),
      m_title(lessonLabel("lessonTitle", "strong", this)),
      m_progress(lessonLabel("lessonProgress", "muted", this)),
      m_time(lessonLabel("lessonTime", "muted", this)),
      m_list(new QListWidget(this)),
      m_text(lessonLabel("lessonText", nullptr, this)),
      m_hintCard(new QFrame(this)),
      m_hint(lessonLabel("lessonHint", nullptr, m_hintCard)),
      m_askHint(new QPushButton(tr("Show a hint"), this)),
      m_done(new QPushButton(tr("Done"), this)) {
  setObjectName(QStringLiteral("lessonPanel"));
  m_time->setWordWrap(false);
  m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_list->setObjectName(QStringLiteral("lessonSteps"));
  m_list->setAccessibleName(tr("Steps"));
  m_list->setWordWrap(true);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setSizeAdjustPolicy(QListWidget::AdjustToContents);
  m_list->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  m_list->setMinimumHeight(kLeastList);
  m_hintCard->setProperty("card", true);
  m_askHint->setObjectName(QStringLiteral("lessonAskHint"));
  m_done->setObjectName(QStringLiteral("lessonDone"));
  m_done->setProperty("primary", true);
  auto* inCard = new QVBoxLayout(m_hintCard);
  inCard->setContentsMargins(12, 8, 12, 8);
  inCard->addWidget(m_hint);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(m_progress, 1);
  row->addWidget(m_time);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addWidget(m_askHint);
  buttons->addStretch(1);
  buttons->addWidget(m_done);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(m_title);
  column->addLayout(row);
  column->addWidget(m_list);
  column->addWidget(m_text);
  column->addWidget(m_hintCard);
  column->addLayout(buttons);
  column->addStretch(1);
  connect(m_list, &QListWidget::currentRowChanged, this, &LessonPanel::showStep);
  connect(m_askHint, &QPushButton::clicked, this, &LessonPanel::showHint);
  connect(m_done, &QPushButton::clicked, this, [this] { emit stepDone(m_shown); });
  setLesson({}, {});
  setTime(0.0, 0.0);
}

void LessonPanel::setLesson(const QString& title, std::vector<LessonStep> steps) {
  m_steps = std::move(steps);
  for (LessonStep& step : m_steps)
    step.shownHints = std::clamp(step.shownHints, 0, static_cast<int>(step.hints.size()));
  m_shown = -1;
  m_title->setText(title);
  m_title->setVisible(!title.isEmpty());
  {
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const LessonStep& step : m_steps) m_list->addItem(step.title);
  }
  m_list->setVisible(!m_steps.empty());
  m_list->updateGeometry();
  showStates();
  m_list->setCurrentRow(current());
  showStep(m_list->currentRow());
}

// Returns the first open step; the last one if none is open.
int LessonPanel::current() const {
  const auto open = std::find_if(m_steps.begin(), m_steps.end(),
                                 [](const LessonStep& step) { return step.state == LessonStep::State::Open; });
  return static_cast<int>(open - m_steps.begin()) - (open == m_steps.end() ? 1 : 0);
}

// A user who looks at the current step goes on with the lesson.
void LessonPanel::setStepState(std::size_t step, LessonStep::State state) {
  if (step >= m_steps.size() || m_steps[step].state == state) return;
  const bool goesOn = m_shown == current();
  m_steps[step].state = state;
  showStates();
  if (goesOn) m_list->setCurrentRow(current());
  showStep(m_list->currentRow());
}

void LessonPanel::showStates() {
  const ThemeColours& colours = themeColours(currentTheme());
  int done = 0;
  for (std::size_t i = 0; i < m_steps.size(); ++i) {
    const LessonStep::State state = m_steps[i].state;
    QListWidgetItem* item = m_list->item(static_cast<int>(i));
    done += state != LessonStep::State::Open;
    const QString text = m_steps[i].title;
    switch (state) {
      case LessonStep::State::Open:
        item->setIcon(icon(QStringLiteral("next"), static_cast<int>(i) == current() ? colours.accent : colours.muted));
        item->setData(Qt::AccessibleTextRole, tr("%1, open").arg(text));
        break;
      case LessonStep::State::Done:
        item->setIcon(icon(QStringLiteral("ok"), colours.success));
        item->setData(Qt::AccessibleTextRole, tr("%1, done").arg(text));
        break;
      case LessonStep::State::Failed:
        item->setIcon(icon(QStringLiteral("error"), colours.error));
        item->setData(Qt::AccessibleTextRole, tr("%1, failed").arg(text));
        break;
    }
  }
  m_progress->setText(m_steps.empty() ? tr("No steps")
                                      : tr("%1 of %2 steps").arg(done).arg(static_cast<int>(m_steps.size())));
}

void LessonPanel::showStep(int step) {
  const bool isNew = std::exchange(m_shown, step) != step;
  const bool isStep = step >= 0 && step < static_cast<int>(m_steps.size());
  const LessonStep shown = isStep ? m_steps[static_cast<std::size_t>(step)] : LessonStep();
  const int hints = static_cast<int>(shown.hints.size());
  m_text->setText(shown.text);
  m_text->setVisible(!shown.text.isEmpty());
  m_hint->setText(shown.hints.mid(0, shown.shownHints).join(QLatin1Char('\n')));
  m_hintCard->setVisible(shown.shownHints > 0);
  m_askHint->setVisible(shown.shownHints < hints);
  m_askHint->setText(shown.shownHints == 0 ? tr("Show a hint") : tr("Show another hint"));
  m_done->setVisible(shown.byHand && shown.state == LessonStep::State::Open);
  if (isNew && isStep) emit stepShown(step);
}

bool LessonPanel::isHintShown() const {
  return !m_hintCard->isHidden();
}

void LessonPanel::showHint() {
  if (m_shown < 0) return;
  LessonStep& step = m_steps[static_cast<std::size_t>(m_shown)];
  if (step.shownHints >= static_cast<int>(step.hints.size())) return;
  const int count = ++step.shownHints;
  showStep(m_shown);
  emit hintShown(m_shown, count);
}

void LessonPanel::setTime(double elapsed, double allowed) {
  const bool isLimited = allowed > 0.0 && std::isfinite(allowed);
  const bool isOver = isLimited && elapsed > allowed;
  m_time->setText(isLimited ? tr("%1 of %2").arg(clockText(elapsed), clockText(allowed)) : clockText(elapsed));
  m_time->setToolTip(isOver ? tr("The time is over") : tr("Time since the beginning, in minutes and seconds"));
  m_time->setAccessibleName(QStringLiteral("%1: %2").arg(m_time->toolTip(), m_time->text()));
  setLook(m_time, "muted", !isOver);
  setLook(m_time, "bad", isOver);
}

void LessonPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) showStates();
  QWidget::changeEvent(event);
}

QString clockText(double seconds) {
  const int whole = std::isfinite(seconds) ? static_cast<int>(std::clamp(seconds, 0.0, kLongestTime)) : 0;
  const QString minutes = QString::number(whole / 60 % 60), rest = QString::number(whole % 60).rightJustified(2, u'0');
  if (whole < 3600) return QStringLiteral("%1:%2").arg(minutes, rest);
  return QStringLiteral("%1:%2:%3").arg(whole / 3600).arg(minutes.rightJustified(2, u'0'), rest);
}

}  // namespace handwheel
