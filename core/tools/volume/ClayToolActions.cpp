// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/LayerSteps.h"
#include "tools/ToolProperty.h"
#include "tools/volume/ClayOperation.h"
#include "tools/volume/ClayTool.h"

#include <QCoreApplication>
#include <array>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kRadiusStep = 1.25;  // from one size to the next by key
constexpr Limits kShares{0.01, 1.0};  // strength
constexpr Limits kFalloffs{0.0, 1.0};
constexpr Limits kResistances{1e-3, 10.0};  // N·s/mm
constexpr Limits kTurns{-M_PI, M_PI};

constexpr ToolKey kKeys[] = {
    {"smaller", "[", QT_TRANSLATE_NOOP("Tool", "smaller brush")},
    {"larger", "]", QT_TRANSLATE_NOOP("Tool", "larger brush")},
    {"add", "Shift+A", QT_TRANSLATE_NOOP("Tool", "add clay")},
    {"carve", "Shift+E", QT_TRANSLATE_NOOP("Tool", "carve")},
    {"smooth", "Shift+O", QT_TRANSLATE_NOOP("Tool", "smooth")},
    {"move", "Shift+G", QT_TRANSLATE_NOOP("Tool", "move clay along")},
    {"mask", "Shift+M", QT_TRANSLATE_NOOP("Tool", "mask clay")},
    {"invertMask", "Ctrl+I", QT_TRANSLATE_NOOP("Tool", "invert the mask")},
    {"clearMask", "Ctrl+D", QT_TRANSLATE_NOOP("Tool", "clear the mask")},
    {"loadStamp", "Shift+L", QT_TRANSLATE_NOOP("Tool", "load a stamp")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "discard the stroke")},
};

// In the order of ClayPressure.
constexpr std::array<const char*, 4> kPressureNames = {
    QT_TRANSLATE_NOOP("Property", "Nothing"), QT_TRANSLATE_NOOP("Property", "Strength"),
    QT_TRANSLATE_NOOP("Property", "Radius"), QT_TRANSLATE_NOOP("Property", "Both")};

}  // namespace

Limits ClayTool::radiusLimits() const {
  return clayRadii(m_document.volume()->volume);
}

std::span<const ToolKey> ClayTool::keys() {
  return kKeys;
}

void ClayTool::invertMask() {
  const VolumeSnapshot& now = *m_document.volume();
  ClayMask mask = now.mask && now.mask->fits(now.volume) ? *now.mask : ClayMask(now.volume);
  mask.invert();
  setMask(QT_TRANSLATE_NOOP("Tool", "Invert the mask"),
          mask.isFree() ? nullptr : std::make_shared<const ClayMask>(std::move(mask)));
}

// One undo step, which holds the previous mask.
void ClayTool::setMask(const char* text, std::shared_ptr<const ClayMask> mask) {
  const auto& before = m_document.volume();
  const std::size_t blocks = before->mask ? before->mask->values().blockCount() : 0;
  auto after = std::make_shared<VolumeSnapshot>(*before);
  after->mask = std::move(mask);
  m_document.commit(QCoreApplication::translate("Tool", text), std::make_unique<VolumeEdit>(std::move(after), blocks));
}

ToolReply ClayTool::perform(std::string_view action) {
  if (action == "revert") {
    if (!m_gesture.isOn()) return ToolReply::Ignored;
    restart();
  } else if (action == "smaller" || action == "larger") {
    setSetting("radius", PropertyValue(m_brush.radius * (action == "larger" ? kRadiusStep : 1.0 / kRadiusStep)));
  } else if (action == "add") {
    setSetting("action", PropertyValue(static_cast<double>(ClayAction::Add)));
  } else if (action == "carve") {
    setSetting("action", PropertyValue(static_cast<double>(ClayAction::Carve)));
  } else if (action == "smooth") {
    setSetting("action", PropertyValue(static_cast<double>(ClayAction::Smooth)));
  } else if (action == "move") {
    setSetting("action", PropertyValue(static_cast<double>(ClayAction::Move)));
  } else if (action == "mask") {
    setSetting("action", PropertyValue(static_cast<double>(ClayAction::Mask)));
  } else if (action == "loadStamp" && m_stamps.load) {
    m_stamps.load();
  } else if (action == "invertMask" || action == "clearMask") {
    settle();
    if (m_gesture.isOn() || (action == "clearMask" && !m_document.volume()->mask)) return ToolReply::Ignored;
    if (action == "invertMask") {
      invertMask();
    } else {
      setMask(QT_TRANSLATE_NOOP("Tool", "Clear the mask"), nullptr);
    }
  } else {
    return ToolReply::Ignored;
  }
  reportUpdated();
  return ToolReply::Used;
}

std::vector<ToolAction> ClayTool::actions() const {
  const bool isIdle = !m_gesture.isOn();
  ToolAction clear = actionOf(kKeys, "clearMask", isIdle && m_document.volume()->mask);
  if (!m_document.volume()->mask) clear.reason = QT_TRANSLATE_NOOP("Tool", "nothing is masked");
  ToolAction shape{"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "shape the clay")};
  ToolAction smooth{"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"), QT_TRANSLATE_NOOP("Tool", "smooth")};
  ToolAction opposite{"", QT_TRANSLATE_NOOP("ToolInput", "Ctrl+drag"), QT_TRANSLATE_NOOP("Tool", "opposite direction")};
  const auto offer = [this](ToolAction& action, const Modifiers& modifiers) {
    const char* const why = obstacle(brushFor(modifiers));
    action.enabled = !why;
    if (why) action.reason = why;
  };
  offer(shape, {});
  offer(smooth, {.shift = true});
  offer(opposite, {.control = true});
  return {shape,
          smooth,
          opposite,
          actionOf(kKeys, "smaller", isIdle),
          actionOf(kKeys, "larger", isIdle),
          actionOf(kKeys, "add", isIdle),
          actionOf(kKeys, "carve", isIdle),
          actionOf(kKeys, "smooth", isIdle),
          actionOf(kKeys, "move", isIdle),
          actionOf(kKeys, "mask", isIdle),
          actionOf(kKeys, "invertMask", isIdle),
          clear,
          actionOf(kKeys, "loadStamp", isIdle && m_stamps.load),
          actionOf(kKeys, "revert", !isIdle)};
}

std::vector<Property> ClayTool::settings() const {
  const bool isShape = m_brush.action == ClayAction::Add || m_brush.action == ClayAction::Carve;
  std::vector<Property> all{
      choiceSetting("action", QT_TRANSLATE_NOOP("Property", "Action"), static_cast<int>(m_brush.action),
                    {clayActionNames().begin(), clayActionNames().end()}),
      numberSetting("radius", QT_TRANSLATE_NOOP("Property", "Brush radius"), m_brush.radius, Quantity::Length,
                    radiusLimits())};
  if (m_brush.action != ClayAction::Move && m_brush.action != ClayAction::Mask) {
    all.push_back(numberSetting("strength",
                                isShape && !m_brush.stamp ? QT_TRANSLATE_NOOP("Property", "Depth (mouse)")
                                                          : QT_TRANSLATE_NOOP("Property", "Strength"),
                                m_brush.strength, Quantity::Number, kShares));
    all.back().continuous = true;
  }
  if (!isShape) {
    all.push_back(numberSetting("falloff", QT_TRANSLATE_NOOP("Property", "Falloff"), m_brush.falloff, Quantity::Number,
                                kFalloffs));
    all.back().continuous = true;
  }
  if (isShape) {
    all.push_back(choiceSetting("stamp", QT_TRANSLATE_NOOP("Property", "Stamp"), static_cast<int>(m_stamp),
                                m_stamps.stamps->names()));
    if (m_brush.stamp)
      all.push_back(
          numberSetting("turn", QT_TRANSLATE_NOOP("Property", "Turned by"), m_brush.turn, Quantity::Angle, kTurns));
  }
  all.push_back(choiceSetting("pressure", QT_TRANSLATE_NOOP("Property", "Pressure changes"),
                              static_cast<int>(m_brush.pressure), {kPressureNames.begin(), kPressureNames.end()}));
  all.push_back(switchSetting("mirror_x", QT_TRANSLATE_NOOP("Property", "Mirror across X"), m_brush.isMirrored[0]));
  all.push_back(switchSetting("mirror_y", QT_TRANSLATE_NOOP("Property", "Mirror across Y"), m_brush.isMirrored[1]));
  all.push_back(switchSetting("mirror_z", QT_TRANSLATE_NOOP("Property", "Mirror across Z"), m_brush.isMirrored[2]));
  all.push_back(numberSetting("resistance", QT_TRANSLATE_NOOP("Property", "Resistance (N·s/mm)"), m_resistance,
                              Quantity::Number, kResistances));
  return all;
}

void ClayTool::setSetting(std::string_view id, const PropertyValue& value) {
  bool isBrush = false;
  if (id == "action") isBrush = assignChoice(m_brush.action, value, static_cast<int>(clayActionNames().size()));
  if (id == "radius") isBrush = assignNumber(m_brush.radius, value, radiusLimits());
  if (id == "strength") isBrush = assignNumber(m_brush.strength, value, kShares);
  if (id == "pressure") isBrush = assignChoice(m_brush.pressure, value, static_cast<int>(kPressureNames.size()));
  if (id == "turn") isBrush = assignNumber(m_brush.turn, value, kTurns);
  if (id == "stamp" && assignChoice(m_stamp, value, static_cast<int>(m_stamps.stamps->count()))) {
    m_brush.stamp = m_stamps.stamps->at(m_stamp);
    isBrush = true;
  }
  if (id == "falloff") isBrush = assignNumber(m_brush.falloff, value, kFalloffs);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (id == std::string("mirror_") + "xyz"[axis]) isBrush = assignSwitch(m_brush.isMirrored[axis], value);
  if (id == "resistance") assignNumber(m_resistance, value, kResistances);
  if (!isBrush) return;
  settle();
  restart();
}

}  // namespace handwheel
