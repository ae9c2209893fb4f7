// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/deviation/DeviationPanel.h"

#include "controls/NumberField.h"
#include "controls/QuantityText.h"
#include "plot/PlotWidget.h"
#include "window/mesh/deviation/MeshDeviation.h"

#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kHistogramHeight = 210;  // logical pixels
constexpr std::size_t kBins = 31;      // odd, so that one is about zero

QPushButton* zoomButton(const char* name, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(parent);
  button->setObjectName(QString::fromLatin1(name));
  button->setProperty("flat", true);
  button->setStyleSheet(QStringLiteral("text-align: left"));  // aligned with the values below it
  button->setToolTip(tip);
  return button;
}

}  // namespace

DeviationPanel::DeviationPanel(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_status(new QLabel(this)),
      m_content(new QWidget(this)),
      m_highest(zoomButton("deviationHighest", tr("Zoom to this place"), m_content)),
      m_lowest(zoomButton("deviationLowest", tr("Zoom to this place"), m_content)),
      m_range(new NumberField(m_content)),
      m_histogram(new PlotWidget(m_content)),
      m_reading(new QLabel(m_content)) {
  setObjectName(QStringLiteral("deviationPanel"));
  m_title->setProperty("strong", true);
  m_title->setWordWrap(true);
  m_title->setObjectName(QStringLiteral("deviationTitle"));
  m_status->setProperty("muted", true);
  m_status->setWordWrap(true);
  auto* close = new QPushButton(tr("Back to the defects"), this);
  close->setObjectName(QStringLiteral("deviationClose"));
  close->setToolTip(tr("Remove the colours"));
  auto* other = new QPushButton(tr("Compare with another file…"), this);
  other->setObjectName(QStringLiteral("deviationOther"));
  auto* content = new QVBoxLayout(m_content);
  content->setContentsMargins(0, 0, 0, 0);
  content->setSpacing(8);
  buildFigures(content);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 12);
  column->setSpacing(8);
  column->addWidget(m_title);
  column->addWidget(m_status);
  column->addWidget(m_content);
  column->addWidget(other);
  column->addWidget(close);
  column->addStretch();
  connect(close, &QPushButton::clicked, this, &DeviationPanel::closed);
  connect(other, &QPushButton::clicked, this, &DeviationPanel::otherFileRequested);
  connect(m_highest, &QPushButton::clicked, this, [this] { emit positionChosen(m_deviation->ofMesh().highest); });
  connect(m_lowest, &QPushButton::clicked, this, [this] { emit positionChosen(m_deviation->ofMesh().lowest); });
  connect(m_range, &NumberField::valueEdited, this, [this](double range) {
    if (!m_deviation) return;  // a field that is hidden commits what was typed into it
    emit rangeChosen(range);
    showHistogram();
  });
  show(nullptr, m_unit);
}

void DeviationPanel::buildFigures(QVBoxLayout* column) {
  auto* form = new QFormLayout;
  form->setVerticalSpacing(4);
  form->setFormAlignment(Qt::AlignLeft);
  form->addRow(tr("Highest"), m_highest);
  form->addRow(tr("Lowest"), m_lowest);
  for (const QString& name : {tr("Mean"), tr("RMS"), tr("90 % within"), tr("99 % within")}) {
    auto* value = new QLabel(m_content);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setContentsMargins(8, 0, 0, 0);
    form->addRow(name, value);
    m_values.push_back(value);
  }
  m_range->setObjectName(QStringLiteral("deviationRange"));
  m_range->setPrefix(QStringLiteral("±"));
  m_range->setLabel(tr("Colours up to"));
  form->addRow(tr("Colours up to"), m_range);
  m_reading->setObjectName(QStringLiteral("deviationReading"));
  m_reading->setContentsMargins(8, 0, 0, 0);
  form->addRow(tr("Under the pointer"), m_reading);
  m_histogram->setObjectName(QStringLiteral("deviationHistogram"));
  m_histogram->setFixedHeight(kHistogramHeight);
  auto* save = new QPushButton(tr("Save report…"), m_content);
  save->setObjectName(QStringLiteral("deviationReport"));
  connect(save, &QPushButton::clicked, this, &DeviationPanel::reportRequested);
  column->addLayout(form);
  column->addWidget(m_histogram);
  column->addWidget(save);
}

void DeviationPanel::show(const MeshDeviation* deviation, LengthUnit unit, const QString& status) {
  m_deviation = deviation;
  m_unit = unit;
  m_content->setVisible(deviation != nullptr);
  m_status->setVisible(!status.isEmpty());
  m_status->setText(status);
  m_title->setText(!deviation                  ? tr("Deviation")
                   : deviation->file.isEmpty() ? tr("Deviation from the mesh as it was opened")
                                               : tr("Deviation from %1").arg(QFileInfo(deviation->file).fileName()));
  if (!deviation) return;
  showFigures(*deviation);
  setReading(std::nullopt);
}

QString DeviationPanel::lengthText(double mm) const {
  // Four digits: more than a scan is worth only confuse. What is but rounding is nothing.
  const bool isSame = std::abs(mm) < 1e-9 * m_deviation->diagonal;
  const double shown = isSame ? 0.0 : QString::number(mm, 'g', 4).toDouble();
  const QString text = quantityText(std::abs(shown), Quantity::Length, m_unit, QLocale());
  return (shown > 0.0 ? QStringLiteral("+") : shown < 0.0 ? QStringLiteral("−") : QString()) + text;
}

void DeviationPanel::showFigures(const MeshDeviation& deviation) {
  const SurfaceDeviation& d = deviation.ofMesh();
  m_highest->setText(lengthText(d.highest.distance));
  m_lowest->setText(lengthText(d.lowest.distance));
  const std::array<double, 4> values{d.mean, d.rms, d.percentiles[1], d.percentiles[3]};
  for (std::size_t i = 0; i < values.size(); ++i) {
    QString text = lengthText(values[i]);
    if (i > 0 && text.startsWith(QLatin1Char('+'))) text.remove(0, 1);  // no sign where there is none
    m_values[i]->setText(text);
  }
  m_range->setQuantity(Quantity::Length, m_unit);
  m_range->setRange(1e-9 * deviation.scale.range, 1e9 * deviation.scale.range);
  m_range->setValue(deviation.scale.range);
  showHistogram();
}

// The shares span so many decades that only a logarithm shows the few that are far off beside all that are not.
void DeviationPanel::showHistogram() {
  const ColourScale& scale = m_deviation->scale;
  const std::vector<double> shares = sharesWithin(m_deviation->ofMesh(), scale.range, kBins);
  const double perShown = perShownUnit(Quantity::Length, m_unit);
  Plot plot;
  plot.x = {tr("Distance"), unitSymbol(Quantity::Length, m_unit)};
  plot.x.shown = {-scale.range / perShown, scale.range / perShown};
  plot.y = {tr("Share of the area"), QStringLiteral("%"), true};
  plot.locale = QLocale();
  PlotSeries bars;
  bars.name = tr("Area");
  bars.barWidth = 2.0 * scale.range / kBins / perShown;
  for (std::size_t i = 0; i < kBins; ++i) {
    if (!(shares[i] > 0.0)) continue;
    const double value = scale.range * (2.0 * (static_cast<double>(i) + 0.5) / kBins - 1.0);
    bars.points.emplace_back(value / perShown, 100.0 * shares[i]);
    bars.bars.push_back(scale.at(value));
  }
  plot.series.push_back(std::move(bars));
  m_histogram->setPlot(std::move(plot));
  m_histogram->setAccessibleName(tr("Histogram of the deviation"));
}

void DeviationPanel::setReading(const std::optional<double>& distance) {
  m_reading->setText(distance ? lengthText(*distance) : QStringLiteral("—"));
}

QString DeviationPanel::reading() const {
  return m_reading->text();
}

void DeviationPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange && m_deviation) showFigures(*m_deviation);
}

}  // namespace handwheel
