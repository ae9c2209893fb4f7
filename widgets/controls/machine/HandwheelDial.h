// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/machine/DialCount.h"

#include <QString>
#include <QWidget>
#include <optional>

namespace handwheel {

// A handwheel with a graduated dial, like those of a machine tool's slides. Turning it clockwise increases the value.
// The user drags the wheel around its centre. While the dial has the focus, a notch of the mouse wheel or an arrow key
// turns it by one division (Shift: ten, Ctrl: a tenth), and Page Up and Page Down by a full turn. Home or a double
// click sets the zero of the dial to the present value, like the ring of a real slide. The owner may answer moved() by
// setting another value; further turning counts from this value. Values are in mm. All calls must be made on the window
// thread.
class HandwheelDial : public QWidget {
  Q_OBJECT

 public:
  explicit HandwheelDial(QWidget* parent = nullptr);

  // Sets the position of the slide, without a signal. A value that is not finite changes nothing.
  void setValue(double mm);
  // Sets 1 to 1000 divisions per turn. A division that is not finite or not above zero changes nothing.
  void setDivisions(int perTurn, double mmPerDivision);
  // Sets the value at which the dial shows zero.
  void setZero(double mm);
  void setRange(double least, double largest);  // range of the value for turning by hand; none when least > largest
  void setPrefix(const QString& prefix);        // before the number: "⌀", "R"
  void setLabel(const QString& label);          // accessible name: "Cross slide"
  // Makes the mouse independent of the focus: a click does not give the dial the focus, and the mouse wheel turns it
  // without focus. For windows in which the keys have another use and nothing scrolls.
  void setMouseFirst();

  double value() const { return m_count.value(); }
  double zero() const { return m_count.zero(); }
  QString numberText() const;   // the displayed value: "⌀ 12.350 mm"
  QString readingText() const;  // "2 turns + 47.0 div"
  QString text() const;         // displayed value and reading

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

  // Returns the centre of the wheel, logical pixels.
  QPointF centre() const;

 signals:
  void moved(double mm);        // emitted when the user turned the dial to this value
  void zeroChanged(double mm);  // emitted when the user set the zero

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QRectF face() const;
  void turn(double divisions);
  void zeroHere();
  void showCount();

  DialCount m_count;
  double m_least;
  double m_largest;
  double m_rest = 0.0;  // divisions turned, less than a tenth
  double m_shown = 0.0;
  QString m_prefix;
  QPointF m_pressed;
  bool m_isHeld = false;
  bool m_isMouseFirst = false;
  std::optional<double> m_angle;  // angle of the mouse pointer while it drags the wheel, rad; none: no dragging
};

}  // namespace handwheel
