// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/RecordingsPage.h"

#include "panels/ActionButton.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kKey = Qt::UserRole;
constexpr double kMilliseconds = 1e3;     // ms per second
constexpr int kStep = 100, kPage = 1000;  // ms, steps of the slider by key

// Formats a time as "1:05.3".
QString clockText(double seconds, const QLocale& locale) {
  const auto tenths = static_cast<long long>(std::floor(10.0 * seconds));
  return QStringLiteral("%1:%2%3%4")
      .arg(tenths / 600)
      .arg(tenths / 10 % 60, 2, 10, QLatin1Char('0'))
      .arg(locale.decimalPoint())
      .arg(tenths % 10);
}

QToolButton* toolButton(QAction* action, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(action->objectName() + QStringLiteral("Button"));
  button->setDefaultAction(action);
  button->setAccessibleName(action->text().remove(QLatin1Char('&')));
  button->setIconSize({16, 16});
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

RecordingsPage::RecordingsPage(const Actions& actions, QWidget* parent)
    : QWidget(parent),
      m_recorded(new QLabel(this)),
      m_list(new QTableWidget(0, 2, this)),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_position(new QLabel(this)) {
  m_recorded->setObjectName(QStringLiteral("recordedText"));
  m_recorded->setProperty("muted", true);
  m_recorded->setWordWrap(true);
  m_list->setObjectName(QStringLiteral("recordingList"));
  m_list->setAccessibleName(tr("Recordings"));
  m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  m_list->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_list->setSelectionMode(QAbstractItemView::SingleSelection);
  m_list->setShowGrid(false);
  m_list->setTabKeyNavigation(false);
  m_list->verticalHeader()->hide();
  m_list->horizontalHeader()->hide();
  m_list->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_list->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  m_slider->setObjectName(QStringLiteral("recordingPosition"));
  m_slider->setAccessibleName(tr("Position in the recording"));
  m_slider->setSingleStep(kStep);
  m_slider->setPageStep(kPage);
  m_position->setObjectName(QStringLiteral("recordingTime"));
  m_position->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* record = new QHBoxLayout;
  record->setSpacing(8);
  record->addWidget(new ActionButton(actions.record, ActionButton::Rank::Primary, this));
  record->addWidget(m_recorded, 1);
  auto* playback = new QHBoxLayout;
  playback->setSpacing(4);
  playback->addWidget(toolButton(actions.play, this));
  playback->addWidget(toolButton(actions.leave, this));
  playback->addWidget(m_slider, 1);
  playback->addWidget(m_position);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(new ActionButton(actions.exportCsv, ActionButton::Rank::Ordinary, this));
  row->addStretch();
  row->addWidget(toolButton(actions.rename, this));
  row->addWidget(toolButton(actions.remove, this));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 12);
  column->setSpacing(8);
  column->addLayout(record);
  column->addWidget(m_list, 1);
  column->addLayout(playback);
  column->addLayout(row);
  connect(m_list, &QTableWidget::currentCellChanged, this, [this](int at) {
    if (at >= 0) emit chosen(m_list->item(at, 0)->data(kKey).toString());
  });
  connect(m_list, &QTableWidget::itemChanged, this, &RecordingsPage::take);
  connect(m_slider, &QSlider::valueChanged, this, [this](int value) { emit seekRequested(value / kMilliseconds); });
  showNotRecording();
  showPosition(0.0, 0.0);
}

void RecordingsPage::showRecordings(const std::vector<Row>& rows, const QString& chosen) {
  const QSignalBlocker quiet(m_list);
  if (rows != m_rows) {
    m_rows = rows;
    m_list->setRowCount(0);
    m_list->setRowCount(static_cast<int>(rows.size()));
    for (int i = 0; i < m_list->rowCount(); ++i) fill(i, rows[static_cast<std::size_t>(i)]);
  }
  m_list->setCurrentCell(rowOf(chosen), 0);
}

void RecordingsPage::fill(int at, const Row& row) {
  QString about = tr("%1, %Ln sample(s)", nullptr, static_cast<int>(row.ticks)).arg(clockText(row.duration, locale()));
  if (row.missing > 0) about += tr(", %Ln missing", nullptr, static_cast<int>(row.missing));
  auto* name = new QTableWidgetItem(row.name);
  auto* duration = new QTableWidgetItem(clockText(row.duration, locale()));
  name->setData(kKey, row.key);
  duration->setFlags(duration->flags() & ~Qt::ItemIsEditable);
  duration->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  for (QTableWidgetItem* item : {name, duration}) {
    item->setToolTip(about);
    item->setData(Qt::AccessibleDescriptionRole, about);
  }
  m_list->setItem(at, 0, name);
  m_list->setItem(at, 1, duration);
}

int RecordingsPage::rowOf(const QString& key) const {
  const auto row = std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& each) { return each.key == key; });
  return row == m_rows.end() ? -1 : static_cast<int>(row - m_rows.begin());
}

// Takes the edited name; an empty name is ignored.
void RecordingsPage::take(QTableWidgetItem* item) {
  const QString key = item->data(kKey).toString();
  const int at = item->column() == 0 ? rowOf(key) : -1;
  if (at < 0) return;
  const QString before = m_rows[static_cast<std::size_t>(at)].name, name = item->text().trimmed();
  if (item->text() == before) return;
  if (name.isEmpty() || name == before) {
    const QSignalBlocker quiet(m_list);
    item->setText(before);
  } else {
    emit renamed(key, name);
  }
}

void RecordingsPage::showRecorded(double seconds, std::size_t ticks) {
  m_recorded->setText(tr("%1, %Ln sample(s)", nullptr, static_cast<int>(ticks)).arg(clockText(seconds, locale())));
}

void RecordingsPage::showNotRecording() {
  m_recorded->setText(tr("Kept with the document."));
}

void RecordingsPage::showPosition(double seconds, double duration) {
  m_slider->setEnabled(duration > 0.0);
  m_position->setText(duration > 0.0
                          ? QStringLiteral("%1 / %2").arg(clockText(seconds, locale()), clockText(duration, locale()))
                          : QString());
  if (m_slider->isSliderDown()) return;  // the user drags it
  const QSignalBlocker quiet(m_slider);
  m_slider->setRange(0, static_cast<int>(std::lround(duration * kMilliseconds)));
  m_slider->setValue(static_cast<int>(std::lround(seconds * kMilliseconds)));
}

void RecordingsPage::editName(const QString& key) {
  if (const int at = rowOf(key); at >= 0) m_list->editItem(m_list->item(at, 0));
}

}  // namespace handwheel
