// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/machine/HandwheelDial.h"

#include "controls/NumberLineEdit.h"
#include "controls/QuantityText.h"
#include "controls/machine/DialPainting.h"
#include "theme/Theme.h"

#include <QApplication>
#include <QFontInfo>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace handwheel {

namespace {

constexpr double kTenths = 10.0;       // tenths of a division
constexpr double kShownSteps = 100.0;  // steps per division: a smaller change is not drawn
constexpr double kLongNumber = 1e9;    // from here on with an exponent
constexpr double kHub = 4.0;           // pixels: within them the pointer has no direction
constexpr double kMostTenths = 1e6;    // limit for one event
constexpr double kEndless = std::numeric_limits<double>::infinity();

// Returns the clockwise angle from the top; none at the centre.
std::optional<double> angleAt(const QPointF& offset) {
  if (std::hypot(offset.x(), offset.y()) < kHub) return std::nullopt;
  return std::atan2(offset.x(), -offset.y());
}

// Returns the same turn within half a revolution.
double withinHalfTurn(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

QFont boldOf(QFont font) {
  font.setBold(true);
  return font;
}

}  // namespace

HandwheelDial::HandwheelDial(QWidget* parent) : QWidget(parent), m_least(-kEndless), m_largest(kEndless) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setLabel(tr("Handwheel"));
  setToolTip(
      tr("Drag around the centre, or use the wheel or arrow keys: one division (Shift: ten, Ctrl: a tenth); Page Up "
         "and Down: one turn; Home or double click: set the dial to zero"));
  showCount();
}

void HandwheelDial::setValue(double mm) {
  m_count.setValue(mm);
  showCount();
}

void HandwheelDial::setDivisions(int perTurn, double mmPerDivision) {
  m_count.setDivisions(perTurn, mmPerDivision);
  m_rest = 0.0;
  update();
  showCount();
}

void HandwheelDial::setZero(double mm) {
  m_count.setZero(mm);
  update();
  showCount();
}

void HandwheelDial::setRange(double least, double largest) {
  const bool isSound = least <= largest;
  m_least = isSound ? least : -kEndless;
  m_largest = isSound ? largest : kEndless;
}

void HandwheelDial::setPrefix(const QString& prefix) {
  m_prefix = prefix;
  update();
  showCount();
}

void HandwheelDial::setLabel(const QString& label) {
  setAccessibleName(label);
}

void HandwheelDial::setMouseFirst() {
  m_isMouseFirst = true;
  setFocusPolicy(Qt::TabFocus);
}

QString HandwheelDial::numberText() const {
  const double reading = m_count.reading() == 0.0 ? 0.0 : m_count.reading();
  const int digits = std::clamp(static_cast<int>(std::ceil(1.0 - std::log10(m_count.mmPerDivision()) - 1e-9)), 0, 9);
  const QString number = std::abs(reading) < kLongNumber ? locale().toString(reading, 'f', digits)
                                                         : handwheel::numberText(reading, locale());
  return (m_prefix.isEmpty() ? QString() : m_prefix + QLatin1Char(' ')) + tr("%1 mm").arg(number);
}

QString HandwheelDial::readingText() const {
  const double turns = m_count.turns();
  if (std::abs(turns) >= kLongNumber) return tr("%1 div").arg(handwheel::numberText(m_count.divisions(), locale()));
  // Rounded down, so that a turn is never shown as full.
  const double rest = std::floor(m_count.restOfTurn() * kTenths + 1e-6) / kTenths;
  const QString divisions = tr("%1 div").arg(locale().toString(rest, 'f', 1));
  if (turns == 0.0) return divisions;
  const int whole = static_cast<int>(std::abs(turns));
  const QString sign = turns < 0.0 ? locale().negativeSign() : QString();
  return QStringLiteral("%1%2 + %3").arg(sign, tr("%n turn(s)", nullptr, whole), divisions);
}

QString HandwheelDial::text() const {
  return QStringLiteral("%1, %2").arg(numberText(), readingText());
}

QSize HandwheelDial::sizeHint() const {
  return {168, 168 + 2 * fontMetrics().height()};
}

QSize HandwheelDial::minimumSizeHint() const {
  return {112, 112 + 2 * fontMetrics().height()};
}

QRectF HandwheelDial::face() const {
  const double texts = 2.0 * fontMetrics().height();
  const double side = std::max(0.0, std::min<double>(width(), height() - texts));
  return {0.5 * (width() - side), 0.5 * (height() - texts - side), side, side};
}

QPointF HandwheelDial::centre() const {
  return face().center();
}

void HandwheelDial::turn(double divisions) {
  m_rest += divisions * kTenths;
  if (!std::isfinite(m_rest)) m_rest = 0.0;
  const double tenths = std::clamp(std::round(m_rest * 1e6) / 1e6, -kMostTenths, kMostTenths);
  const double whole = std::trunc(tenths);
  m_rest = tenths - whole;
  if (whole == 0.0) return;
  // At an end the wheel stops, and leaves it at once when it is turned back.
  const double low = std::min(m_least, value()), high = std::max(m_largest, value());
  const double wanted = std::clamp(m_count.after(whole), low, high);
  if (wanted == value() || !std::isfinite(wanted)) return;
  m_count.setValue(wanted);
  showCount();
  emit moved(wanted);
}

void HandwheelDial::zeroHere() {
  m_rest = 0.0;
  if (m_count.reading() == 0.0) return;
  m_count.setZero(value());
  update();
  showCount();
  emit zeroChanged(zero());
}

void HandwheelDial::showCount() {
  setAccessibleDescription(text());
  const double shown = std::round(m_count.divisions() * kShownSteps);
  if (std::exchange(m_shown, shown) != shown) update();
}

void HandwheelDial::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  m_isHeld = true;
  m_pressed = event->position();
  m_angle.reset();
}

// The wheel follows the pointer's direction from the centre. It starts only after some pixels, so that a double click
// does not turn it.
void HandwheelDial::mouseMoveEvent(QMouseEvent* event) {
  if (!m_isHeld) return QWidget::mouseMoveEvent(event);
  const QPointF moved = event->position() - m_pressed;
  if (!m_angle && moved.manhattanLength() < 0.5 * QApplication::startDragDistance()) return;
  if (!m_angle) m_angle = angleAt(m_pressed - centre());
  const std::optional<double> now = angleAt(event->position() - centre());
  if (!now) return;
  const double by = m_angle ? withinHalfTurn(*now - *m_angle) : 0.0;
  m_angle = now;
  turn(by / (2.0 * std::numbers::pi) * m_count.perTurn());
}

void HandwheelDial::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mouseReleaseEvent(event);
  m_isHeld = false;
  m_rest = 0.0;
}

void HandwheelDial::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) zeroHere();
}

void HandwheelDial::wheelEvent(QWheelEvent* event) {
  const double notches = wheelNotches(*event);
  if (!(hasFocus() || m_isMouseFirst) || notches == 0.0) return event->ignore();
  turn(notches * stepFactor(event->modifiers()));
  event->accept();
}

// Accepts its keys before actions of the window that have the same ones.
bool HandwheelDial::event(QEvent* event) {
  constexpr int kKeys[] = {Qt::Key_Up,     Qt::Key_Right,    Qt::Key_Down, Qt::Key_Left,
                           Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Home};
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys)) event->accept();
  }
  return QWidget::event(event);
}

void HandwheelDial::keyPressEvent(QKeyEvent* event) {
  const double step = stepFactor(event->modifiers());
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Right:
      return turn(step);
    case Qt::Key_Down:
    case Qt::Key_Left:
      return turn(-step);
    case Qt::Key_PageUp:
      return turn(m_count.perTurn());
    case Qt::Key_PageDown:
      return turn(-m_count.perTurn());
    case Qt::Key_Home:
      return zeroHere();
    default:
      return QWidget::keyPressEvent(event);
  }
}

void HandwheelDial::focusInEvent(QFocusEvent* event) {
  update();
  QWidget::focusInEvent(event);
}

void HandwheelDial::focusOutEvent(QFocusEvent* event) {
  m_isHeld = false;
  m_rest = 0.0;
  update();
  QWidget::focusOutEvent(event);
}

void HandwheelDial::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LocaleChange) showCount();
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) updateGeometry();
  QWidget::changeEvent(event);
}

void HandwheelDial::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColours& colours = themeColours(currentTheme());
  const QRectF square = face();
  painter.save();
  QFont small = font();
  small.setPointSizeF(std::max(5.0, 0.8 * QFontInfo(small).pointSizeF()));
  painter.setFont(small);
  paintDial(painter, square, m_count, colours, hasFocus());
  painter.restore();
  QRectF row(0.0, square.bottom(), width(), fontMetrics().height());
  painter.setFont(boldOf(font()));
  painter.setPen(isEnabled() ? colours.text : colours.muted);
  painter.drawText(row, Qt::AlignCenter, numberText());
  row.translate(0.0, row.height());
  painter.setFont(font());
  painter.setPen(colours.muted);
  painter.drawText(row, Qt::AlignCenter, fontMetrics().elidedText(readingText(), Qt::ElideRight, width()));
}

}  // namespace handwheel
