// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace handwheel {

// A widget that shows a device's buttons as lamps, which are lit while held. The buttons are numbered from 1. If the
// hand at the device is simulated, a click on a lamp or the key of its number holds the button until the next click or
// key press.
class ButtonLamps : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kMost = 32;

  explicit ButtonLamps(QWidget* parent = nullptr);

  void setCount(int count);
  void showButtons(std::uint32_t held);  // bit n: button n + 1

  // Sets whether the user can press the buttons with this widget.
  void setLed(bool isLed);

  QString text() const;  // displayed text: "Held: 1, 3", or that no button is held

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

  QRect lampRect(int button) const;  // rectangle of the lamp of button number `button` + 1

 signals:
  void toggled(int button);  // emitted when the user wants to press or release button number `button` + 1

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  int lampSize() const;
  int perRow(int width) const;

  int m_count = 0;
  std::uint32_t m_held = 0;
  bool m_isLed = false;
};

}  // namespace handwheel
