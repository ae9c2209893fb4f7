// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ScrolledPanel.h"

#include <QEvent>
#include <QScrollBar>
#include <algorithm>

namespace handwheel {

namespace {
constexpr int kLeastWidth = 240, kLeastHeight = 96;  // pixels: a few lines
}

ScrolledPanel::ScrolledPanel(QWidget* panel, Directions directions, QWidget* parent)
    : QScrollArea(parent), m_directions(directions) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);  // its parts have it
  if (directions == Directions::Vertical) setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(panel->sizePolicy());
  setWidget(panel);
  panel->installEventFilter(this);
}

QSize ScrolledPanel::sizeHint() const {
  return widget()->sizeHint() +
         QSize(m_directions == Directions::Vertical ? verticalScrollBar()->sizeHint().width() : 0, 0);
}

QSize ScrolledPanel::minimumSizeHint() const {
  const QSize least = widget()->minimumSizeHint();
  const int bar = verticalScrollBar()->sizeHint().width();
  const int width = m_directions == Directions::Vertical ? least.width() + bar : std::min(kLeastWidth, least.width());
  return {width, std::min(kLeastHeight, least.height())};
}

// Rows that come and go change how much room the panel asks for.
bool ScrolledPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace handwheel
