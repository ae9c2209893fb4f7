// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/FidelityPanel.h"

#include "controls/PropertyList.h"
#include "plot/PlotPainting.h"
#include "theme/Theme.h"
#include "window/FidelityChoice.h"

#include <QCoreApplication>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr const char* kPreset = "preset";
constexpr int kCurveHeight = 200;  // logical pixels
constexpr int kLeastWidth = 296;   // for the titles of the axes

QString translated(const std::string& text) {
  return QCoreApplication::translate("Fidelity", text.c_str());
}

// The presets in the order of the list; the first is the defaults.
int presetOf(const FidelityRegistry& registry, const FidelityValues& values) {
  const auto same = [&](const FidelityValues& preset) {
    return std::all_of(registry.entries().begin(), registry.entries().end(),
                       [&](const auto& entry) { return preset.of(entry.setting) == values.of(entry.setting); });
  };
  if (same(FidelityValues())) return 0;
  for (std::size_t i = 0; i < kFidelityPresets.size(); ++i) {
    if (same(FidelityValues(kFidelityPresets[i]))) return static_cast<int>(i) + 1;
  }
  return static_cast<int>(kFidelityPresets.size()) + 1;
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
  for (const std::string& word : setting.choices) property.choices.push_back(word);
  return property;
}

}  // namespace

class FidelityPanel::Curve : public QWidget {
 public:
  explicit Curve(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("fidelityCurve"));
    setFixedHeight(kCurveHeight);
  }
  void show(Plot plot) {
    m_plot = std::move(plot);
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    paintPlot(painter, rect(), m_plot, currentTheme());
  }

 private:
  Plot m_plot;
};

FidelityPanel::FidelityPanel(FidelityChoice& choice, QWidget* parent)
    : QWidget(parent),
      m_choice(choice),
      m_list(new PropertyList(this)),
      m_title(new QLabel(this)),
      m_curve(new Curve(this)),
      m_shown(choice.registry().entries().front().setting.id) {
  setObjectName(QStringLiteral("fidelityPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  setMinimumWidth(kLeastWidth);
  m_title->setWordWrap(true);
  m_title->setProperty("strong", true);
  m_title->setContentsMargins(12, 0, 12, 0);
  column->addWidget(m_list, 1);
  column->addWidget(m_title);
  column->addWidget(m_curve);
  connect(m_list, &PropertyList::edited, this, [this](const std::string& id, const PropertyValue& value, bool) {
    if (const auto* number = std::get_if<double>(&value)) edit(id, *number);
  });
  connect(&m_choice, &FidelityChoice::changed, this, &FidelityPanel::refresh);
  refresh();
}

void FidelityPanel::edit(const std::string& id, double value) {
  if (id != kPreset) {
    m_shown = id;
    return m_choice.set(id, value);
  }
  const auto index = static_cast<std::size_t>(value);
  if (index == 0) return m_choice.use(FidelityValues());
  if (index <= kFidelityPresets.size()) return m_choice.use(FidelityValues(kFidelityPresets[index - 1]));
  refresh();
}

void FidelityPanel::refresh() {
  Property preset;
  preset.id = kPreset;
  preset.group = QT_TRANSLATE_NOOP("Property", "Speed against accuracy");
  preset.label = QT_TRANSLATE_NOOP("Property", "Preset");
  preset.choices = {QT_TRANSLATE_NOOP("Property", "Default"), QT_TRANSLATE_NOOP("Property", "Draft"),
                    QT_TRANSLATE_NOOP("Property", "Balanced"), QT_TRANSLATE_NOOP("Property", "Exact"),
                    QT_TRANSLATE_NOOP("Property", "Own values")};
  preset.least = 0;
  preset.largest = static_cast<double>(preset.choices.size()) - 1;
  preset.value = static_cast<double>(presetOf(m_choice.registry(), m_choice.values()));
  std::vector<Property> all{preset};
  for (const auto& entry : m_choice.registry().entries()) {
    all.push_back(propertyFor(entry.setting, m_choice.values().of(entry.setting)));
  }
  m_list->setProperties(all);
  m_title->setText(translated(m_choice.registry().find(m_shown)->setting.label));
  m_curve->setAccessibleName(m_title->text());
  m_curve->show(plotOf(m_shown));
}

Plot FidelityPanel::plotOf(const std::string& id) const {
  const FidelitySetting& setting = m_choice.registry().find(id)->setting;
  Plot plot;
  plot.x = {translated(setting.cost.name), QString::fromStdString(setting.cost.unit), true};
  plot.y = {translated(setting.error.name), QString::fromStdString(setting.error.unit), true};
  plot.locale = QLocale();
  const std::vector<CurvePoint> curve = m_choice.curve(id);
  PlotSeries measured;
  measured.name = tr("Measured");
  for (const CurvePoint& point : curve) measured.points.emplace_back(point.cost, point.error);
  const double value = m_choice.of(id);
  const auto nearest = std::min_element(curve.begin(), curve.end(), [&](const CurvePoint& a, const CurvePoint& b) {
    return std::abs(placeOf(setting, a.value) - placeOf(setting, value)) <
           std::abs(placeOf(setting, b.value) - placeOf(setting, value));
  });
  if (nearest != curve.end()) plot.marks.push_back({QPointF(nearest->cost, nearest->error), tr("now")});
  plot.series.push_back(std::move(measured));
  return plot;
}

}  // namespace handwheel
