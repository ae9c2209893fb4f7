// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/DeviceCard.h"

#include "panels/device/DeviceText.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QComboBox>
#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

bool isSame(const DeviceInfo& a, const DeviceInfo& b) {
  return a.driver == b.driver && a.address == b.address;
}

QIcon iconOf(const DeviceInUse& view) {
  const ThemeColours& colours = themeColours(currentTheme());
  if (!view.chosen) return icon(QStringLiteral("info"), colours.muted);
  switch (view.status) {
    case DeviceStatus::Absent:
      return icon(QStringLiteral("info"), colours.muted);
    case DeviceStatus::Starting:
      return icon(QStringLiteral("spinner"), colours.accent);
    case DeviceStatus::NeedsHoming:
      return icon(QStringLiteral("warning"), colours.warning);
    case DeviceStatus::Ready:
      return icon(QStringLiteral("ok"), colours.success);
    case DeviceStatus::Failed:
      break;
  }
  return icon(QStringLiteral("error"), colours.error);
}

QString headlineOf(const DeviceInUse& view) {
  if (!view.chosen) return DeviceCard::tr("No device in use");
  const bool isOutside = view.isPointer && view.status == DeviceStatus::Absent;
  return isOutside ? DeviceCard::tr("The pointer is outside the view") : DeviceText::status(view.status);
}

QString detailOf(const DeviceInUse& view) {
  if (view.isPointer)
    return DeviceCard::tr(
        "Simulates at the mouse pointer what a device would feel. The mouse also points and rotates the view without "
        "this.");
  if (!view.chosen && !view.spaceMice.empty())
    return DeviceCard::tr("%1 moves the view. Choose it above only if it is to move the tip.")
        .arg(QString::fromStdString(view.spaceMice.front()));
  if (view.chosen) return DeviceText::advice(view.status, view.chosen->driver);
  return view.found.empty() ? DeviceCard::tr("Plug one in: it appears here by itself.")
                            : DeviceCard::tr("Choose one from the list above.");
}

}  // namespace

DeviceCard::DeviceCard(QWidget* parent)
    : QWidget(parent),
      m_choice(new QComboBox(this)),
      m_state(new QFrame(this)),
      m_icon(new QLabel(m_state)),
      m_headline(new QLabel(m_state)),
      m_detail(new QLabel(m_state)),
      m_notRealTime(new QToolButton(m_state)) {
  m_choice->setObjectName(QStringLiteral("deviceChoice"));
  m_choice->setAccessibleName(tr("Device"));
  m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_choice->setMinimumContentsLength(12);
  m_choice->addItem(tr("No device"));
  auto* rescan = new QToolButton(this);
  rescan->setObjectName(QStringLiteral("rescanDevices"));
  rescan->setIcon(icon(QStringLiteral("rescan")));
  rescan->setToolTip(tr("Look for devices again"));
  rescan->setAccessibleName(rescan->toolTip());
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(m_choice, 1);
  row->addWidget(rescan);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 0);
  column->setSpacing(8);
  column->addLayout(row);
  column->addWidget(stateFrame());
  connect(m_choice, &QComboBox::activated, this, &DeviceCard::choose);
  connect(rescan, &QToolButton::clicked, this, &DeviceCard::rescanRequested);
  connect(m_notRealTime, &QToolButton::clicked, this, &DeviceCard::realTimeAdviceRequested);
  showState();
}

QWidget* DeviceCard::stateFrame() {
  m_state->setObjectName(QStringLiteral("deviceState"));
  m_state->setProperty("card", true);
  m_headline->setObjectName(QStringLiteral("deviceHeadline"));
  m_headline->setProperty("strong", true);
  m_headline->setWordWrap(true);
  m_detail->setObjectName(QStringLiteral("deviceDetail"));
  m_detail->setProperty("muted", true);
  m_detail->setWordWrap(true);
  m_notRealTime->setObjectName(QStringLiteral("notRealTime"));
  m_notRealTime->setText(tr("Not in real time: what to do"));
  m_notRealTime->setToolTip(
      tr("Ticks are late when the computer is busy, and the stiffness is reduced to allow for that"));
  m_notRealTime->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_notRealTime->setFocusPolicy(Qt::TabFocus);
  m_notRealTime->hide();
  auto* grid = new QGridLayout(m_state);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  grid->addWidget(m_icon, 0, 0);
  grid->addWidget(m_headline, 0, 1);
  grid->addWidget(m_detail, 1, 1);
  grid->addWidget(m_notRealTime, 2, 1, Qt::AlignLeft);
  return m_state;
}

void DeviceCard::showDevice(const DeviceInUse& view) {
  m_view = view;
  fillList();
  showState();
}

void DeviceCard::showStatus(DeviceStatus status) {
  if (status == m_view.status) return;
  m_view.status = status;
  showState();
}

void DeviceCard::showLoop(const ServoLoopStatus& loop) {
  const bool isRefused = loop.realTime == RealTimeState::NotPermitted;
  if (std::exchange(m_isRealTimeRefused, isRefused) != isRefused) showState();
}

// Fills the list, which does not change while the devices are the same: it may be open.
void DeviceCard::fillList() {
  std::vector<DeviceInfo> listed = m_view.found;
  const auto isChosen = [this](const DeviceInfo& each) { return m_view.chosen && isSame(each, *m_view.chosen); };
  const bool isGone = m_view.chosen && std::none_of(listed.begin(), listed.end(), isChosen);
  if (isGone) {
    listed.push_back(*m_view.chosen);
    listed.back().name = tr("%1 (unplugged)").arg(QString::fromStdString(listed.back().name)).toStdString();
  }
  const auto isShown = [](const DeviceInfo& a, const DeviceInfo& b) { return isSame(a, b) && a.name == b.name; };
  if (!std::equal(listed.begin(), listed.end(), m_listed.begin(), m_listed.end(), isShown)) {
    m_listed = std::move(listed);
    while (m_choice->count() > 1) m_choice->removeItem(1);
    for (const DeviceInfo& each : m_listed) {
      m_choice->addItem(QString::fromStdString(each.name));
      const QString origin =
          QStringLiteral("%1, %2").arg(QString::fromStdString(each.driver), QString::fromStdString(each.address));
      m_choice->setItemData(m_choice->count() - 1, origin, Qt::ToolTipRole);
    }
  }
  const auto chosen = std::find_if(m_listed.begin(), m_listed.end(), isChosen);
  m_choice->setCurrentIndex(chosen == m_listed.end() ? 0 : static_cast<int>(chosen - m_listed.begin()) + 1);
}

void DeviceCard::choose(int row) {
  if (row <= 0) return emit deviceLeft();
  const DeviceInfo listing = m_listed[static_cast<std::size_t>(row) - 1];  // a copy: the list may change meanwhile
  emit deviceChosen(listing.driver, listing.address);
}

void DeviceCard::showState() {
  m_notRealTime->setVisible(m_isRealTimeRefused && m_view.chosen);
  m_notRealTime->setIcon(icon(QStringLiteral("warning"), themeColours(currentTheme()).warning));
  m_icon->setPixmap(iconOf(m_view).pixmap(QSize(20, 20), devicePixelRatioF()));
  m_headline->setText(headlineOf(m_view));
  m_detail->setText(detailOf(m_view));
  m_detail->setVisible(!m_detail->text().isEmpty());
  m_state->setAccessibleName(QStringLiteral("%1. %2").arg(m_headline->text(), m_detail->text()));
}

void DeviceCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) showState();
  QWidget::changeEvent(event);
}

}  // namespace handwheel
