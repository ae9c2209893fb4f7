// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "theme/Icons.h"

#include "theme/Theme.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace handwheel {

namespace {

class LineIconEngine final : public QIconEngine {
 public:
  LineIconEngine(QString name, QColor colour) : m_name(std::move(name)), m_colour(std::move(colour)) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(m_name));
    if (file.open(QIODevice::ReadOnly)) m_drawing = file.readAll();
    Q_ASSERT(!m_drawing.isEmpty());
  }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const qreal ratio = painter->device()->devicePixelRatioF();
    painter->drawPixmap(rect, pixmap(rect.size() * ratio, mode, state));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    if (size.isEmpty()) return {};
    const QColor colour = colourFor(mode, state);
    const QString key = QStringLiteral("handwheel/%1/%2/%3x%4")
                            .arg(m_name, colour.name(QColor::HexArgb))
                            .arg(size.width())
                            .arg(size.height());
    QPixmap result;
    if (QPixmapCache::find(key, &result)) return result;
    result = QPixmap(size);
    result.fill(Qt::transparent);
    QPainter painter(&result);
    painter.setOpacity(colour.alphaF());
    QByteArray drawing = m_drawing;
    drawing.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer(drawing).render(&painter);
    QPixmapCache::insert(key, result);
    return result;
  }

  QIconEngine* clone() const override { return new LineIconEngine(*this); }

 private:
  QColor colourFor(QIcon::Mode mode, QIcon::State state) const {
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::WindowText);
    if (m_colour.isValid()) return m_colour;
    if (state == QIcon::On) return themeColours(currentTheme()).accent;
    return palette.color(QPalette::Active, QPalette::WindowText);
  }

  QString m_name;
  QColor m_colour;
  QByteArray m_drawing;
};

}  // namespace

QIcon icon(const QString& name) {
  return icon(name, QColor());
}

QIcon icon(const QString& name, const QColor& colour) {
  return QIcon(new LineIconEngine(name, colour));
}

}  // namespace handwheel
