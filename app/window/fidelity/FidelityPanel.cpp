// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/fidelity/FidelityPanel.h"

#include "controls/property/PropertyList.h"
#include "plot/PlotWidget.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/fidelity/FitText.h"

#include <QApplication>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace handwheel {

namespace {

constexpr const char* kPreset = "preset";
constexpr int kCurveHeight = 200;  // logical pixels
constexpr int kLeastList = 160;    // logical pixels: a few settings
constexpr int kSliderSteps = 100;
constexpr int kLeastWidth = 296;  // for the titles of the axes

QString translated(const std::string& text) {
  return QCoreApplication::translate("Fidelity", text.c_str());
}

// The presets in the order of the list: the defaults, those with a name, and Fit.
constexpr std::size_t kFit = kFidelityPresets.size() + 1;

int presetOf(const FidelityChoice& choice) {
  const FidelityRegistry& registry = choice.registry();
  const FidelityValues& values = choice.values();
  const auto same = [&](const FidelityValues& preset) {
    return std::all_of(registry.entries().begin(), registry.entries().end(),
                       [&](const auto& entry) { return preset.of(entry.setting) == values.of(entry.setting); });
  };
  if (same(FidelityValues())) return 0;
  for (std::size_t i = 0; i < kFidelityPresets.size(); ++i) {
    if (same(FidelityValues(kFidelityPresets[i]))) return static_cast<int>(i) + 1;
  }
  return static_cast<int>(choice.isFit() ? kFit : kFit + 1);
}

int stepsOf(const FidelitySetting& setting) {
  return setting.scale == FidelityScale::Choices ? static_cast<int>(setting.choices.size()) - 1 : kSliderSteps;
}

// In two digits: more would pretend a precision that nobody chose.
double valueAtStep(const FidelitySetting& setting, int step) {
  const double value = valueAt(setting, static_cast<double>(step) / stepsOf(setting));
  if (setting.scale == FidelityScale::Choices) return value;
  return std::clamp(QString::number(value, 'g', 2).toDouble(), setting.least, setting.largest);
}

// "CPU time of a fill: 3.2 ms"
QString lineOf(const FidelityMeasure& measure, double value) {
  const QString number = std::isfinite(value) ? QLocale().toString(value, 'g', 3) : QStringLiteral("∞");
  return QStringLiteral("%1: %2 %3").arg(translated(measure.name), number, translated(measure.unit));
}

// "Draft: 0.1, Balanced: 0.022, Exact: 0.0001"
QString presetsOf(const FidelitySetting& setting) {
  QStringList presets;
  for (FidelityPreset preset : kFidelityPresets) {
    const double value = setting.presetValue(preset);
    const QString shown =
        setting.choices.empty() ? QLocale().toString(value, 'g', 7) : translated(textOf(setting, value));
    const QString word = QCoreApplication::translate("Property", std::string(wordFor(preset)).c_str());
    presets << QStringLiteral("%1: %2").arg(word, shown);
  }
  return presets.join(QStringLiteral(", "));
}

Property propertyFor(const FidelitySetting& setting, double value) {
  Property property;
  property.id = setting.id;
  property.group = QT_TRANSLATE_NOOP("Property", "Settings");
  property.label = translated(setting.label).toStdString();
  property.translated = false;
  property.value = value;
  property.least = setting.least;
  property.largest = setting.largest;
  for (const std::string& word : setting.choices) property.choices.push_back(translated(word).toStdString());
  return property;
}

}  // namespace

FidelityPanel::FidelityPanel(FidelityChoice& choice, QWidget* parent)
    : SqueezedPage(parent),
      m_choice(choice),
      m_list(new PropertyList(this)),
      m_fit(new QLabel(this)),
      m_title(new QLabel(this)),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_prediction(new QLabel(this)),
      m_curve(new PlotWidget(this)),
      m_below(new QVBoxLayout),
      m_shown(choice.registry().entries().front().setting.id) {
  setObjectName(QStringLiteral("fidelityPanel"));
  setMinimumWidth(kLeastWidth);
  m_list->setMinimumHeight(kLeastList);
  m_fit->setObjectName(QStringLiteral("fidelityFit"));
  m_fit->setWordWrap(true);
  m_fit->setProperty("muted", true);
  m_title->setWordWrap(true);
  m_title->setProperty("strong", true);
  m_slider->setObjectName(QStringLiteral("fidelitySlider"));
  m_slider->setTracking(false);
  m_prediction->setObjectName(QStringLiteral("fidelityPrediction"));
  m_prediction->setWordWrap(true);
  m_curve->setObjectName(QStringLiteral("fidelityCurve"));
  m_curve->setFixedHeight(kCurveHeight);
  auto* detail = new QVBoxLayout;
  detail->setContentsMargins(12, 0, 12, 0);
  for (QWidget* part : std::initializer_list<QWidget*>{m_fit, m_title, m_slider, m_prediction}) detail->addWidget(part);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_list, 1);
  column->addLayout(detail);
  column->addWidget(m_curve);
  m_below->setContentsMargins(12, 8, 12, 12);
  column->addLayout(m_below);
  connect(m_list, &PropertyList::edited, this, [this](const std::string& id, const PropertyValue& value, bool) {
    if (const auto* number = std::get_if<double>(&value)) edit(id, *number);
  });
  const auto setting = [this]() -> const FidelitySetting& { return m_choice.registry().find(m_shown)->setting; };
  connect(m_slider, &QSlider::sliderMoved, this, [=, this](int step) { predict(valueAtStep(setting(), step)); });
  connect(m_slider, &QSlider::valueChanged, this,
          [=, this](int step) { m_choice.set(m_shown, valueAtStep(setting(), step)); });
  // Released at its old value, it changes nothing; shown later, as the slider moves to its position after this signal.
  connect(
      m_slider, &QSlider::sliderReleased, this, [this] { showSetting(m_shown); }, Qt::QueuedConnection);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
  connect(&m_choice, &FidelityChoice::changed, this, &FidelityPanel::refresh);
  connect(&m_choice, &FidelityChoice::curvesChanged, this, &FidelityPanel::refresh);
  refresh();
}

void FidelityPanel::addBelow(QWidget* widget) {
  m_below->addWidget(widget);
}

// The setting of the row that has the focus is shown below.
void FidelityPanel::follow(QWidget* focused) {
  const QString prefix = QStringLiteral("property/");
  for (QWidget* at = m_list->isAncestorOf(focused) ? focused : nullptr; at && at != m_list; at = at->parentWidget()) {
    if (!at->objectName().startsWith(prefix)) continue;
    const std::string id = at->objectName().mid(prefix.size()).toStdString();
    if (id != m_shown && m_choice.registry().find(id)) showSetting(id);
    return;
  }
}

void FidelityPanel::edit(const std::string& id, double value) {
  if (id != kPreset) {
    m_shown = id;
    return m_choice.set(id, value);
  }
  const auto index = static_cast<std::size_t>(value);
  if (index == 0) return m_choice.use(FidelityValues());
  if (index <= kFidelityPresets.size()) return m_choice.use(FidelityValues(kFidelityPresets[index - 1]));
  if (index == kFit) return m_choice.use(m_choice.fit().values);
  refresh();
}

void FidelityPanel::refresh() {
  Property preset;
  preset.id = kPreset;
  preset.group = QT_TRANSLATE_NOOP("Property", "Speed and accuracy");
  preset.label = QT_TRANSLATE_NOOP("Property", "Preset");
  preset.choices = {QT_TRANSLATE_NOOP("Property", "Default"),  QT_TRANSLATE_NOOP("Property", "Draft"),
                    QT_TRANSLATE_NOOP("Property", "Balanced"), QT_TRANSLATE_NOOP("Property", "Exact"),
                    QT_TRANSLATE_NOOP("Property", "Fit"),      QT_TRANSLATE_NOOP("Property", "Custom")};
  preset.least = 0;
  preset.largest = static_cast<double>(preset.choices.size()) - 1;
  preset.value = static_cast<double>(presetOf(m_choice));
  std::vector<Property> all{preset};
  for (const auto& entry : m_choice.registry().entries()) {
    all.push_back(propertyFor(entry.setting, m_choice.values().of(entry.setting)));
  }
  m_list->setProperties(all);
  m_fit->setVisible(m_choice.isFit());
  if (m_choice.isFit()) m_fit->setText(fitText(m_choice.fit(), locale()));
  showSetting(m_shown);
}

void FidelityPanel::showSetting(const std::string& id) {
  m_shown = id;
  const FidelitySetting& setting = m_choice.registry().find(id)->setting;
  const double value = m_choice.of(id);
  m_title->setText(translated(setting.label));
  m_slider->setAccessibleName(m_title->text());
  if (!m_slider->isSliderDown()) {
    const QSignalBlocker quiet(m_slider);
    m_slider->setRange(0, stepsOf(setting));
    m_slider->setPageStep(std::max(1, stepsOf(setting) / 10));
    m_slider->setValue(static_cast<int>(std::lround(scalePositionOf(setting, value) * stepsOf(setting))));
  }
  predict(value);
}

void FidelityPanel::predict(double value) {
  const FidelitySetting& setting = m_choice.registry().find(m_shown)->setting;
  const auto point = m_choice.predicted(m_shown, value);
  QStringList lines;
  if (point) lines << lineOf(setting.error, point->error) << lineOf(setting.cost, point->cost);
  lines << presetsOf(setting);
  m_prediction->setText(lines.join(QLatin1Char('\n')));
  m_curve->setPlot(plotOf(m_shown, value));
  m_curve->setAccessibleName(m_title->text());
}

Plot FidelityPanel::plotOf(const std::string& id, double value) const {
  const FidelitySetting& setting = m_choice.registry().find(id)->setting;
  Plot plot;
  plot.x = {translated(setting.cost.name), translated(setting.cost.unit), true};
  plot.y = {translated(setting.error.name), translated(setting.error.unit), true};
  plot.locale = QLocale();
  PlotSeries measured;
  measured.name = tr("Measured");
  for (const CurvePoint& point : m_choice.curve(id)) measured.points.emplace_back(point.cost, point.error);
  plot.series.push_back(std::move(measured));

  const auto now = m_choice.predicted(id, value);
  if (now) plot.marks.push_back({QPointF(now->cost, now->error), tr("now")});
  return plot;
}

}  // namespace handwheel
