// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/SimulationBanner.h"

#include "panels/MessageBar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

namespace handwheel {

namespace {
constexpr int kFromTop = 8;  // pixels
}

SimulationBanner::SimulationBanner(QWidget* view)
    : QFrame(view),
      m_text(new QLabel(tr("Simulated – not cut yet"), this)),
      m_cut(new QPushButton(tr("&Cut the work"), this)),
      m_messages(view->window()->findChild<MessageBar*>()) {
  setObjectName(QStringLiteral("simulationBanner"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setToolTip(tr("The view shows what the program would cut. The document, and what is saved, is the part before it."));
  m_text->setProperty("strong", true);
  m_cut->setObjectName(QStringLiteral("simulationCut"));
  auto* leave = new QPushButton(tr("Show the part as it is"), this);
  leave->setObjectName(QStringLiteral("simulationLeave"));
  leave->setToolTip(tr("Leave the simulation; the program stays as it is"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 4, 8, 4);
  for (QWidget* each : std::initializer_list<QWidget*>{m_text, m_cut, leave}) row->addWidget(each);
  connect(m_cut, &QPushButton::clicked, this, &SimulationBanner::cutRequested);
  connect(leave, &QPushButton::clicked, this, &SimulationBanner::leaveRequested);
  view->installEventFilter(this);
  if (m_messages) m_messages->installEventFilter(this);
  hide();
}

void SimulationBanner::showFor(bool isCuttable, const QString& why) {
  m_cut->setEnabled(isCuttable);
  m_cut->setToolTip(why);
  show();
  reposition();
}

bool SimulationBanner::eventFilter(QObject* watched, QEvent* event) {
  const bool isPlaced = event->type() == QEvent::Resize || event->type() == QEvent::Move ||
                        event->type() == QEvent::Show || event->type() == QEvent::Hide;
  if (isPlaced && (watched == parent() || watched == m_messages) && isVisible()) reposition();
  return QFrame::eventFilter(watched, event);
}

// The view draws itself only when something in it changes.
void SimulationBanner::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  parentWidget()->update();
}

void SimulationBanner::reposition() {
  adjustSize();
  int top = kFromTop;
  if (m_messages && m_messages->isVisible()) {
    const QPoint below = m_messages->mapToGlobal(QPoint(0, m_messages->height()));
    top += std::max(0, parentWidget()->mapFromGlobal(below).y());
  }
  move(std::max(0, (parentWidget()->width() - width()) / 2), top);
  raise();
  parentWidget()->update();
}

}  // namespace handwheel
