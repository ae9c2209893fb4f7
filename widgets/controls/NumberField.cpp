// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/NumberField.h"

#include "base/NumberText.h"
#include "controls/ExpressionText.h"
#include "controls/NumberLineEdit.h"
#include "controls/QuantityText.h"

#include <QEvent>
#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {

namespace {

constexpr int kPauseMs = 400;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Returns the usual step, in mm or radian.
double usualStep(Quantity quantity, LengthUnit unit) {
  switch (quantity) {
    case Quantity::Length:
      return unit == LengthUnit::Inch ? 2.54 : 1.0;
    case Quantity::Angle:
      return kRadiansPerDegree;
    case Quantity::Number:
      break;
  }
  return 1.0;
}

}  // namespace

NumberField::NumberField(QWidget* parent)
    : QWidget(parent),
      m_line(new NumberLineEdit(this)),
      m_problem(new QLabel(this)),
      m_least(-kInfinity),
      m_largest(kInfinity) {
  m_line->setObjectName(QStringLiteral("numberLine"));
  m_line->setAlignment(Qt::AlignRight);
  m_line->setInputMethodHints(Qt::ImhPreferLatin | Qt::ImhNoPredictiveText | Qt::ImhNoAutoUppercase);
  m_problem->setObjectName(QStringLiteral("numberProblem"));
  m_problem->setProperty("wrong", true);
  m_problem->setWordWrap(true);
  m_problem->hide();
  m_pause.setSingleShot(true);
  m_pause.setInterval(kPauseMs);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(m_line);
  column->addWidget(m_problem);
  connect(m_line, &NumberLineEdit::textEdited, this, &NumberField::type);
  connect(m_line, &NumberLineEdit::stepped, this, &NumberField::step);
  connect(m_line, &NumberLineEdit::stepsEnded, this, &NumberField::endSteps);
  connect(m_line, &NumberLineEdit::committed, this, &NumberField::commit);
  connect(m_line, &NumberLineEdit::reverted, this, &NumberField::revert);
  connect(&m_pause, &QTimer::timeout, this, &NumberField::endSteps);
  showMarks();
  showValue();
}

NumberField::~NumberField() {
  delete m_problem;
}

void NumberField::setProblemOver() {
  layout()->removeWidget(m_problem);
  m_problem->setAutoFillBackground(true);
  m_isProblemOver = true;
}

void NumberField::placeProblem() {
  constexpr int kLeastWidth = 200, kGap = 2;  // pixels
  QWidget* const top = window();
  if (m_problem->parentWidget() != top) m_problem->setParent(top);
  const int width = std::max(kLeastWidth, this->width());
  m_problem->resize(width, m_problem->heightForWidth(width));
  const QPoint below = m_line->mapTo(top, QPoint(0, m_line->height() + kGap));
  m_problem->move(std::max(0, std::min(below.x(), top->width() - width)),
                  std::max(0, std::min(below.y(), top->height() - m_problem->height())));
  m_problem->raise();
  m_problem->show();
}

void NumberField::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (m_isProblemOver && m_problem) m_problem->hide();
}

void NumberField::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (m_isProblemOver && !problem().isEmpty()) placeProblem();
}

void NumberField::setQuantity(Quantity quantity, LengthUnit unit) {
  if (quantity == m_quantity && unit == m_unit) return;
  m_quantity = quantity;
  m_unit = unit;
  showMarks();
  m_line->setModified(false);  // half a number in another unit means nothing
  showValue();
}

void NumberField::setRange(double least, double largest) {
  const bool sound = least <= largest;
  m_least = sound ? least : -kInfinity;
  m_largest = sound ? largest : kInfinity;
  describe();
  showValue();
}

void NumberField::setPrefix(const QString& prefix) {
  m_prefix = prefix;
  showMarks();
}

void NumberField::setLabel(const QString& label) {
  m_line->setAccessibleName(label);
}

void NumberField::setValue(double value) {
  if (value == m_value) return;
  m_value = value;
  // Refused text is out of date when the value has changed and nobody is typing any more.
  if (!m_line->hasFocus()) m_line->setModified(false);
  showValue();
}

QString NumberField::problem() const {
  return m_problem->text();
}

void NumberField::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LocaleChange) showValue();
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) showMarks();
  QWidget::changeEvent(event);
}

void NumberField::showMarks() {
  m_line->setMarks(m_prefix, unitSymbol(m_quantity, m_unit));
  describe();
}

QString NumberField::text() const {
  return quantityNumber(m_value, m_quantity, m_unit, locale());
}

void NumberField::showValue() {
  if (m_line->isModified()) return;
  if (m_line->text() != text()) {
    m_line->setText(text());
    // If there is no room for all of it, its first digits are visible: without them it would be another number.
    if (!m_line->hasFocus()) m_line->setCursorPosition(0);
  }
  showProblem(rangeProblem(m_value));
}

// Sets the accessible description, because screen readers do not see the unit in the margin.
void NumberField::describe() {
  const auto shown = [this](double value) { return quantityText(value, m_quantity, m_unit, locale()); };
  QStringList parts;
  if (const QString unit = unitSymbol(m_quantity, m_unit); !unit.isEmpty()) parts << tr("in %1").arg(unit);
  if (std::isfinite(m_least)) parts << tr("at least %1").arg(shown(m_least));
  if (std::isfinite(m_largest)) parts << tr("at most %1").arg(shown(m_largest));
  m_line->setAccessibleDescription(parts.join(QStringLiteral(", ")));
}

void NumberField::type() {
  showProblem({});
  const ExpressionField field{m_quantity, m_unit, locale().decimalPoint() == QLatin1String(",")};
  const ExpressionResult result = evaluateExpression(m_line->text().toStdString(), field);
  const double* const value = std::get_if<double>(&result);
  if (value && rangeProblem(*value).isEmpty()) emit valueTyped(*value);
}

void NumberField::commit() {
  if (m_line->text() == text()) return revert();
  const ExpressionField field{m_quantity, m_unit, locale().decimalPoint() == QLatin1String(",")};
  const ExpressionResult result = evaluateExpression(m_line->text().toStdString(), field);
  if (const auto* error = std::get_if<ExpressionError>(&result)) return showProblem(expressionProblem(*error));
  const double entered = std::get<double>(result);
  if (const QString problem = rangeProblem(entered); !problem.isEmpty()) return showProblem(problem);
  m_line->setModified(false);
  m_value = withinShownLimits(entered, m_least, m_largest).value_or(entered);
  showValue();
  emit valueEdited(m_value, false);
}

void NumberField::revert() {
  m_line->setModified(false);
  showValue();
  m_line->selectAll();
}

void NumberField::step(double steps) {
  if (m_line->isModified()) commit();
  if (m_line->isModified()) return;  // the text in the line has no value to step from
  const double value = std::clamp(m_value + steps * oneStep(), m_least, m_largest);
  if (value == m_value || !std::isfinite(value)) return;
  m_value = value;
  showValue();
  m_stepping = true;
  m_pause.start();
  emit valueEdited(m_value, true);
}

void NumberField::endSteps() {
  m_pause.stop();
  if (std::exchange(m_stepping, false)) emit valueEdited(m_value, false);
}

// Returns one unit, or the value's own power of ten if that is smaller.
double NumberField::oneStep() const {
  if (m_step > 0.0) return m_step;
  const double usual = usualStep(m_quantity, m_unit);
  const double size = std::abs(m_value) / usual * (1.0 + 1e-9);  // a value that should be a power of ten counts as one
  return size > 0.0 && size < 1.0 ? usual * std::pow(10.0, std::floor(std::log10(size))) : usual;
}

QString NumberField::rangeProblem(double value) const {
  if (withinShownLimits(value, m_least, m_largest)) return {};
  const auto shown = [this](double limit) { return quantityText(limit, m_quantity, m_unit, locale()); };
  if (value < m_least) return tr("Must be at least %1.").arg(shown(m_least));
  if (value > m_largest) return tr("Must be at most %1.").arg(shown(m_largest));
  return {};
}

void NumberField::showProblem(const QString& problem) {
  m_problem->setText(problem);
  if (m_isProblemOver && isVisible() && !problem.isEmpty())
    placeProblem();
  else
    m_problem->setVisible(!problem.isEmpty() && !m_isProblemOver);
  m_line->setToolTip(problem);
  if (m_line->property("wrong").toBool() == !problem.isEmpty()) return;
  m_line->setProperty("wrong", !problem.isEmpty());
  m_line->style()->unpolish(m_line);  // the style sheet reads the property
  m_line->style()->polish(m_line);
}

}  // namespace handwheel
