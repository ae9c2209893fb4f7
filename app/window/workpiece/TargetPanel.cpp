// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/TargetPanel.h"

#include "controls/QuantityText.h"

#include <QAction>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kLegendWidth = 220, kLegendHeight = 12;  // pixels

// Returns a length to a micrometre, as a workshop reads it.
QString lengthText(double mm, LengthUnit unit, const QLocale& locale) {
  return quantityText(std::round(mm * 1e3) / 1e3, Quantity::Length, unit, locale);
}

QPixmap legendPicture(const ColourScale& scale) {
  QImage image(kLegendWidth, 1, QImage::Format_RGB32);
  for (int x = 0; x < kLegendWidth; ++x)
    image.setPixelColor(x, 0, scale.at(scale.range * (2.0 * x / (kLegendWidth - 1) - 1.0)));
  return QPixmap::fromImage(image.scaled(kLegendWidth, kLegendHeight));
}

}  // namespace

QString dimensionText(const ProfileFeature& f, double zero, LengthUnit unit, const QLocale& locale) {
  const auto length = [&](double mm) { return lengthText(mm, unit, locale); };
  QString text;
  if (f.kind == ProfileFeature::Kind::Cylinder) text = QStringLiteral("⌀ %1").arg(length(f.value));
  if (f.kind == ProfileFeature::Kind::Arc) text = QStringLiteral("R %1").arg(length(f.value));
  if (f.kind == ProfileFeature::Kind::Taper)
    text = QStringLiteral("∠ %1  ⌀ %2 … %3")
               .arg(quantityText(std::round(f.value * 1e6) / 1e6 + 0.0, Quantity::Angle, unit, locale),
                    length(2.0 * f.low.x()), length(2.0 * f.high.x()));
  if (f.kind == ProfileFeature::Kind::Curve)
    text = TargetPanel::tr("Curve ⌀ %1 … %2").arg(length(2.0 * f.low.x()), length(2.0 * f.high.x()));
  if (f.kind == ProfileFeature::Kind::FlatFace)
    return QStringLiteral("⟂ ⌀ %1 … %2  ·  Z %3")
        .arg(length(2.0 * f.low.x()), length(2.0 * f.high.x()), length(f.low.y() - zero));
  if (f.isInner) text = TargetPanel::tr("Bore %1").arg(text);
  return QStringLiteral("%1  ·  Z %2 … %3  ·  ↔ %4")
      .arg(text, length(f.low.y() - zero), length(f.high.y() - zero), length(f.length()));
}

namespace {

// One size a line; of a curved target the first ones.
QString sizesText(const std::vector<ProfileFeature>& wanted, double zero, LengthUnit unit, const QLocale& locale) {
  constexpr std::size_t kMost = 12;
  QStringList lines;
  for (std::size_t i = 0; i < std::min(wanted.size(), kMost); ++i)
    lines += dimensionText(wanted[i], zero, unit, locale);
  if (wanted.size() > kMost) lines += QStringLiteral("…");
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

TargetPanel::TargetPanel(const QList<QAction*>& actions, QWidget* parent)
    : QWidget(parent),
      m_target(new QLabel(this)),
      m_wanted(new QLabel(this)),
      m_over(new QLabel(this)),
      m_under(new QLabel(this)),
      m_legend(new QLabel(this)),
      m_ends(new QLabel(this)),
      m_dimensions(new QListWidget(this)) {
  setObjectName(QStringLiteral("targetPanel"));
  m_over->setObjectName(QStringLiteral("targetOver"));
  m_under->setObjectName(QStringLiteral("targetUnder"));
  m_dimensions->setObjectName(QStringLiteral("partDimensions"));
  m_dimensions->setAccessibleName(tr("Measured dimensions"));
  m_dimensions->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_wanted->setObjectName(QStringLiteral("targetSizes"));
  for (QLabel* label : {m_target, m_wanted, m_over, m_under}) label->setWordWrap(true);
  auto* heading = new QLabel(tr("Target"), this);
  auto* measured = new QLabel(tr("Dimensions"), this);
  for (QLabel* label : {heading, measured}) label->setProperty("strong", true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 12);
  column->setSpacing(8);
  column->addWidget(heading);
  for (QWidget* row : std::initializer_list<QWidget*>{m_target, m_wanted, m_over, m_under, m_legend, m_ends})
    column->addWidget(row);
  for (QAction* action : actions) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::StrongFocus);  // so that a field that is being edited is left
    column->addWidget(button);
  }
  column->addWidget(measured);
  column->addWidget(m_dimensions, 1);
  m_ends->setWordWrap(true);
  setLegend({}, {});
}

void TargetPanel::show(const PartMeasurement& measurement, const QString& target, LengthUnit unit) {
  const QLocale locale;
  const bool hasTarget = measurement.deviation.has_value();
  m_target->setText(hasTarget ? target : tr("No target: import one to compare the part with it."));
  for (QLabel* label : {m_wanted, m_over, m_under}) label->setVisible(hasTarget);
  if (hasTarget) {
    m_wanted->setText(sizesText(measurement.wanted, measurement.zero, unit, locale));
    const TargetDeviation& d = *measurement.deviation;
    m_over->setText(tr("Too large by up to %1").arg(lengthText(d.largestOver.distance, unit, locale)));
    m_under->setText(tr("Too small by up to %1").arg(lengthText(-d.largestUnder.distance, unit, locale)));
  }
  m_dimensions->clear();
  for (const ProfileFeature& feature : measurement.features)
    m_dimensions->addItem(dimensionText(feature, measurement.zero, unit, locale));
}

void TargetPanel::setLegend(const std::optional<ColourScale>& scale, const QString& ends) {
  for (QLabel* label : {m_legend, m_ends}) label->setVisible(scale.has_value());
  if (!scale) return;
  m_legend->setPixmap(legendPicture(*scale));
  m_ends->setText(ends);
  m_legend->setAccessibleName(ends);
}

QString TargetPanel::deviationLegend(double range, LengthUnit unit) {
  return tr("blue: %1 too small, red: %1 too large").arg(lengthText(range, unit, QLocale()));
}

}  // namespace handwheel
