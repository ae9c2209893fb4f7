// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "theme/Restyling.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QStyle>
#include <QTimerEvent>
#include <QWidget>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kStepMs = 4;  // far below a frame

// Makes the style sheet's style forget its data about the widget, and read its rules with the present palette.
void restyleOne(QWidget& widget) {
  widget.style()->polish(&widget);
  widget.update();
}

}  // namespace

Restyling::Restyling(QApplication& application) : QObject(&application), m_application(application) {}

void Restyling::restyle(QApplication& application) {
  auto* running = application.findChild<Restyling*>(QString(), Qt::FindDirectChildrenOnly);
  if (!running) running = new Restyling(application);
  running->start();
}

void Restyling::start() {
  m_hidden.clear();
  for (QWidget* widget : QApplication::allWidgets()) {
    if (widget->isVisible())
      restyleOne(*widget);
    else
      m_hidden.emplace_back(widget);
  }
  m_application.installEventFilter(this);
  m_idle.start(0, this);
}

bool Restyling::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Show) return false;
  const auto at = std::find(m_hidden.begin(), m_hidden.end(), watched);
  if (at == m_hidden.end()) return false;
  QWidget& widget = **at;
  m_hidden.erase(at);
  restyleOne(widget);
  return false;
}

void Restyling::timerEvent(QTimerEvent* event) {
  if (event->timerId() != m_idle.timerId()) return;
  QElapsedTimer time;
  for (time.start(); !m_hidden.empty() && !time.hasExpired(kStepMs);) {
    const QPointer<QWidget> widget = m_hidden.front();
    m_hidden.pop_front();
    if (widget) restyleOne(*widget);
  }
  if (!m_hidden.empty()) return;
  m_idle.stop();
  m_application.removeEventFilter(this);
}

}  // namespace handwheel
