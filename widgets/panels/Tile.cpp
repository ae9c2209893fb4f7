// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Tile.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QVBoxLayout>

namespace handwheel {

Tile::Tile(const QString& iconName, const QString& title, const QString& text, QWidget* parent) : QFrame(parent) {
  setProperty("tile", true);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(title);
  setAccessibleDescription(text);
  setFixedWidth(264);
  auto* picture = new QLabel(this);
  picture->setPixmap(icon(iconName, themeColours(currentTheme()).accent).pixmap(QSize(36, 36), devicePixelRatioF()));
  auto* heading = new QLabel(title, this);
  heading->setProperty("strong", true);
  heading->setWordWrap(true);
  auto* line = new QLabel(text, this);
  line->setProperty("muted", true);
  line->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(8);
  column->addWidget(picture);
  column->addWidget(heading);
  column->addWidget(line);
  column->addStretch();
}

void Tile::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint())) emit clicked();
}

void Tile::keyPressEvent(QKeyEvent* event) {
  const bool press = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
  press ? emit clicked() : QFrame::keyPressEvent(event);
}

}  // namespace handwheel
