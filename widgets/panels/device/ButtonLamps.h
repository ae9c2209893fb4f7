// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace handwheel {

// Shows the buttons of a device as lamps, lit while held. They are numbered from 1. If the hand at the device is
// simulated, a click on a lamp holds the button until the next click; so does its number as a key.
class ButtonLamps : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kMost = 32;

  explicit ButtonLamps(QWidget* parent = nullptr);

  void setCount(int count);
  void showButtons(std::uint32_t held);  // bit n: button n + 1

  // Sets whether the user presses the buttons here.
  void setLed(bool isLed);

  QString text() const;  // "Held: 1, 3", or a text for none

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

  QRect lampRect(int button) const;  // lamp of button + 1

 signals:
  void toggled(int button);  // button + 1 is to be pressed, or released

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
