// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Tile.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QStyleOption>
#include <QVBoxLayout>

namespace handwheel {

namespace {

constexpr QSize kTileIcon(36, 36);

// Returns the middle of the picture, scaled to fill the size.
QPixmap cut(const QPixmap& picture, const QSize& size, qreal ratio) {
  const QSize pixels = size * ratio;
  const QPixmap scaled = picture.scaled(pixels, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QPoint corner((scaled.width() - pixels.width()) / 2, (scaled.height() - pixels.height()) / 2);
  QPixmap result = scaled.copy(QRect(corner, pixels));
  result.setDevicePixelRatio(ratio);
  return result;
}

}  // namespace

Tile::Tile(const QString& iconName, const QString& title, const QString& text, QWidget* parent)
    : QAbstractButton(parent), m_iconName(iconName), m_picture(new QLabel(this)), m_line(new QLabel(this)) {
  setProperty("tile", true);
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(title);
  auto* heading = new QLabel(title, this);
  heading->setProperty("strong", true);
  heading->setWordWrap(true);
  m_line->setProperty("muted", true);
  m_line->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(8);
  column->addWidget(m_picture);
  column->addWidget(heading);
  column->addWidget(m_line);
  column->addStretch();
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setLine(text);
  drawIcon();
}

void Tile::setLine(const QString& text) {
  m_line->setText(text);
  m_line->setVisible(!text.isEmpty());
  setAccessibleDescription(text);
}

void Tile::setPicture(const QPixmap& picture, const QSize& size) {
  m_picture->setFixedSize(size);
  m_picture->setAlignment(Qt::AlignCenter);
  m_hasPicture = !picture.isNull();
  if (m_hasPicture) m_picture->setPixmap(cut(picture, size, devicePixelRatioF()));
}

void Tile::drawIcon() {
  if (m_hasPicture) return;
  const ThemeColours& colours = themeColours(currentTheme());
  const QColor colour = isEnabled() ? colours.accent : colours.muted;
  m_picture->setPixmap(handwheel::icon(m_iconName, colour).pixmap(kTileIcon, devicePixelRatioF()));
}

void Tile::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
  QAbstractButton::keyPressEvent(event);
}

// Draws only the frame, from the style sheet; the labels draw themselves.
void Tile::paintEvent(QPaintEvent*) {
  QStyleOption option;
  option.initFrom(this);
  QPainter painter(this);
  style()->drawPrimitive(QStyle::PE_Widget, &option, &painter, this);
}

void Tile::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::EnabledChange) drawIcon();
  QAbstractButton::changeEvent(event);
}

}  // namespace handwheel
