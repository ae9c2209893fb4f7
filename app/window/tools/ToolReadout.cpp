// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/tools/ToolReadout.h"

#include "controls/QuantityText.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

struct ToolReadoutWords {
  Q_DECLARE_TR_FUNCTIONS(ToolReadout)
};

constexpr QPoint kBesideCursor(18, 18);
constexpr double kShownSteps = 100.0;  // to a millimetre or a degree: digits that jitter help nobody

QString shown(double value, const Property& property, LengthUnit unit) {
  const double step = perShownUnit(property.quantity, unit) / kShownSteps;
  return quantityText(std::isfinite(value) ? std::round(value / step) * step : value, property.quantity, unit,
                      QLocale());
}

QString lineOf(const Property& property, LengthUnit unit) {
  const double value = std::get<double>(property.value);
  const QString name = property.translated ? QCoreApplication::translate("Property", property.label.c_str())
                                           : QString::fromStdString(property.label);
  const QString text = ToolReadoutWords::tr("%1: %2").arg(name, shown(value, property, unit));
  if (!std::isfinite(property.least) || !std::isfinite(property.largest)) return text;
  const bool isAtLimit = value <= property.least || value >= property.largest;
  const auto limit = [&](double each) { return quantityText(each, property.quantity, unit, QLocale()); };
  const QString limits = ToolReadoutWords::tr("%1 to %2").arg(limit(property.least), limit(property.largest));
  return isAtLimit ? ToolReadoutWords::tr("%1 – limit (%2)").arg(text, limits)
                   : ToolReadoutWords::tr("%1 (%2)").arg(text, limits);
}

// "⌀ 31.20 mm", "−1.20 mm"; of a unit that is larger, as many more digits.
QString figureText(const ToolLabel::Figure& figure, LengthUnit unit) {
  const double value = figure.value / millimetresPer(unit);
  const int digits = 2 + static_cast<int>(std::ceil(std::log10(millimetresPer(unit)) - 1e-9));
  const QString number = QLocale().toString(std::abs(value), 'f', digits);
  const bool isNegative = std::round(std::abs(value) * std::pow(10.0, digits)) > 0.0 && value < 0.0;
  const QString text =
      (isNegative ? QStringLiteral("−") : QString()) + number + QChar::Nbsp + unitSymbol(Quantity::Length, unit);
  return figure.prefix.empty() ? text : QString::fromStdString(figure.prefix) + QChar::Nbsp + text;
}

}  // namespace

ToolReadout::ToolReadout(QWidget* view) : QLabel(view) {
  setObjectName(QStringLiteral("toolReadout"));
  setTextFormat(Qt::PlainText);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  setForegroundRole(QPalette::ToolTipText);
  setMargin(4);
  hide();
}

// The view draws itself only when the model changes; what the label leaves of the last frame would stay until then.
void ToolReadout::hideEvent(QHideEvent* event) {
  QLabel::hideEvent(event);
  parentWidget()->update();
}

void ToolReadout::show(const std::vector<Property>& settings, LengthUnit unit, const QPoint& cursor) {
  QStringList lines;
  for (const Property& property : settings) {
    if (!property.editable && property.quantity != Quantity::Number && std::holds_alternative<double>(property.value))
      lines << lineOf(property, unit);
  }
  if (lines.isEmpty()) return hide();
  showText(lines.join(QLatin1Char('\n')), cursor);
}

void ToolReadout::show(const ToolLabel& label, LengthUnit unit, const QPoint& position) {
  QStringList figures;
  for (const ToolLabel::Figure& figure : label.figures) figures << figureText(figure, unit);
  showText(figures.join(QStringLiteral("  ")), position);
}

void ToolReadout::showText(const QString& text, const QPoint& position) {
  setText(text);
  adjustSize();
  const QPoint corner = position + kBesideCursor;
  const QSize room = parentWidget()->size() - size();
  move(std::clamp(corner.x(), 0, std::max(0, room.width())), std::clamp(corner.y(), 0, std::max(0, room.height())));
  QLabel::show();
  raise();
  parentWidget()->update();
}

}  // namespace handwheel
