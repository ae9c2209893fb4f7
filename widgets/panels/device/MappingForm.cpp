// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/MappingForm.h"

#include "controls/property/PropertyList.h"

#include <QVBoxLayout>
#include <algorithm>
#include <bit>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::array<const char*, 3> kAxisIds{"right", "up", "near"};  // x, y, z of the view
constexpr double kLeastGain = 1e-4, kLargestGain = 1e4;
constexpr double kLargestDeadZone = 100.0;  // mm

Property number(const char* id, const char* group, const char* label, double value, double least, double largest) {
  Property property;
  property.id = id;
  property.group = group;
  property.label = label;
  property.value = value;
  property.least = least;
  property.largest = largest;
  return property;
}

Property length(Property property) {
  property.quantity = Quantity::Length;
  return property;
}

Property angle(Property property) {
  property.quantity = Quantity::Angle;
  return property;
}

Property choice(const char* id, const char* group, const char* label, int chosen, std::vector<std::string> choices) {
  Property property = number(id, group, label, chosen, 0.0, static_cast<double>(choices.size()) - 1.0);
  property.choices = std::move(choices);
  return property;
}

// Returns the index of an axis in X, -X, Y, -Y, Z, -Z.
int choiceOf(const DeviceAxis& axis) {
  return 2 * axis.axis + (axis.isInverted ? 1 : 0);
}

void addAxes(std::vector<Property>& properties, const WorkspaceMapping& mapping) {
  const auto group = QT_TRANSLATE_NOOP("Property", "Axes");
  const std::array<const char*, 3> labels{QT_TRANSLATE_NOOP("Property", "To the right"),
                                          QT_TRANSLATE_NOOP("Property", "Upwards"),
                                          QT_TRANSLATE_NOOP("Property", "Towards you")};
  const std::vector<std::string> choices{
      QT_TRANSLATE_NOOP("Property", "X of the device"), QT_TRANSLATE_NOOP("Property", "X, inverted"),
      QT_TRANSLATE_NOOP("Property", "Y of the device"), QT_TRANSLATE_NOOP("Property", "Y, inverted"),
      QT_TRANSLATE_NOOP("Property", "Z of the device"), QT_TRANSLATE_NOOP("Property", "Z, inverted")};
  for (std::size_t i = 0; i < 3; ++i) {
    properties.push_back(choice(kAxisIds[i], group, labels[i], choiceOf(mapping.axes[i]), choices));
  }
}

void addMotion(std::vector<Property>& properties, const WorkspaceMapping& m, const DeviceCapabilities& device) {
  const auto group = QT_TRANSLATE_NOOP("Property", "Motion");
  properties.push_back(number("scale", group, QT_TRANSLATE_NOOP("Property", "Scale (1 fills the view)"), m.scale,
                              kLeastGain, kLargestGain));
  if (device.outputs > 0) {
    properties.push_back(
        number("gain", group, QT_TRANSLATE_NOOP("Property", "Force gain"), m.forceGain, kLeastGain, kLargestGain));
  }
  properties.push_back(
      length(number("dead", group, QT_TRANSLATE_NOOP("Property", "Dead zone"), m.deadZone, 0.0, kLargestDeadZone)));
  if (device.inputs >= 6) {
    properties.push_back(angle(number("turnDead", group, QT_TRANSLATE_NOOP("Property", "Dead zone in rotation"),
                                      m.angularDeadZone, 0.0, 90.0 * kRadiansPerDegree)));
  }
  Property rate;
  rate.id = "rate";
  rate.group = group;
  rate.label = QT_TRANSLATE_NOOP("Property", "Rate control");
  rate.value = m.isRateControl;
  properties.push_back(rate);
  if (!m.isRateControl) return;
  properties.push_back(
      number("rateGain", group, QT_TRANSLATE_NOOP("Property", "mm/s per mm"), m.rateGain, kLeastGain, kLargestGain));
  if (device.inputs < 6) return;
  properties.push_back(number("turnGain", group, QT_TRANSLATE_NOOP("Property", "°/s per degree"), m.angularRateGain,
                              kLeastGain, kLargestGain));
}

// Adds the choice of none or a single button; another set of buttons, which only a file can hold, shows as its first.
void addClutch(std::vector<Property>& properties, const WorkspaceMapping& mapping, const DeviceCapabilities& device) {
  const int buttons = std::clamp(device.buttons, 0, 32);
  std::vector<std::string> choices{QT_TRANSLATE_NOOP("Property", "No button")};
  for (int i = 1; i <= buttons; ++i) choices.push_back(MappingForm::tr("Button %1").arg(i).toStdString());
  const int chosen = mapping.clutchButtons == 0 ? 0 : std::countr_zero(mapping.clutchButtons) + 1;
  properties.push_back(choice("clutch", QT_TRANSLATE_NOOP("Property", "Clutch: the tip stays while it is held"),
                              QT_TRANSLATE_NOOP("Property", "Clutch"), chosen, std::move(choices)));
}

void setAxis(WorkspaceMapping& mapping, std::size_t of, int choice) {
  if (choice < 0 || choice >= 6) return;
  const DeviceAxis wanted{choice / 2, choice % 2 == 1};
  const auto taken = std::find_if(mapping.axes.begin(), mapping.axes.end(),
                                  [&](const DeviceAxis& axis) { return axis.axis == wanted.axis; });
  if (taken != mapping.axes.end()) *taken = mapping.axes[of];
  mapping.axes[of] = wanted;
}

bool setNumber(WorkspaceMapping& m, const std::string& id, double value) {
  const std::pair<const char*, double*> gains[] = {
      {"scale", &m.scale}, {"gain", &m.forceGain}, {"rateGain", &m.rateGain}, {"turnGain", &m.angularRateGain}};
  for (const auto& [name, gain] : gains) {
    if (id != name) continue;
    *gain = std::clamp(value, kLeastGain, kLargestGain);
    return true;
  }
  if (id == "dead") m.deadZone = std::clamp(value, 0.0, kLargestDeadZone);
  if (id == "turnDead") m.angularDeadZone = std::clamp(value, 0.0, 90.0 * kRadiansPerDegree);
  return id == "dead" || id == "turnDead";
}

}  // namespace

std::vector<Property> mappingProperties(const WorkspaceMapping& mapping, const DeviceCapabilities& device) {
  std::vector<Property> properties;
  addAxes(properties, mapping);
  addMotion(properties, mapping, device);
  addClutch(properties, mapping, device);
  return properties;
}

WorkspaceMapping withProperty(WorkspaceMapping mapping, const std::string& id, const PropertyValue& value) {
  if (const bool* isOn = std::get_if<bool>(&value); isOn && id == "rate") mapping.isRateControl = *isOn;
  const double* given = std::get_if<double>(&value);
  if (!given || !std::isfinite(*given) || setNumber(mapping, id, *given)) return mapping;
  const auto index = static_cast<int>(std::clamp(*given, -1.0, 100.0));
  if (id == "clutch" && index >= 0 && index <= 32) mapping.clutchButtons = index == 0 ? 0u : 1u << (index - 1);
  const auto axis = std::find(kAxisIds.begin(), kAxisIds.end(), id);
  if (axis != kAxisIds.end()) setAxis(mapping, static_cast<std::size_t>(axis - kAxisIds.begin()), index);
  return mapping;
}

MappingForm::MappingForm(QWidget* parent) : QWidget(parent), m_list(new PropertyList(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_list);
  connect(m_list, &PropertyList::edited, this, [this](const std::string& id, const PropertyValue& value, bool) {
    m_mapping = withProperty(m_mapping, id, value);
    refresh();
    emit mappingChanged(m_mapping);
  });
  refresh();
}

void MappingForm::setDevice(const DeviceCapabilities& device) {
  m_device = device;
  refresh();
}

void MappingForm::setMapping(const WorkspaceMapping& mapping) {
  m_mapping = mapping;
  refresh();
}

void MappingForm::refresh() {
  m_list->setProperties(mappingProperties(m_mapping, m_device));
}

}  // namespace handwheel
