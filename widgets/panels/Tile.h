// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

class QLabel;

namespace handwheel {

// A large button with a picture, a title and a line of text.
class Tile : public QAbstractButton {
  Q_OBJECT

 public:
  Tile(const QString& iconName, const QString& title, const QString& text, QWidget* parent = nullptr);

  void setLine(const QString& text);
  // Sets a picture instead of the icon, cropped to this size (logical pixels). If the picture is null, the icon is
  // centred in this area.
  void setPicture(const QPixmap& picture, const QSize& size);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void drawIcon();

  QString m_iconName;
  bool m_hasPicture = false;
  QLabel* m_picture;
  QLabel* m_line;
};

}  // namespace handwheel
