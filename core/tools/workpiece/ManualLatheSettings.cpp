// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of ManualLatheTool: how the lathe is set up.
#include "machining/force/CuttingFeel.h"
#include "tools/ToolProperty.h"
#include "tools/workpiece/ManualLatheTool.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace handwheel {

namespace {

constexpr Limits kAngles{-90.0, 90.0};      // degrees
constexpr Limits kLengths{0.0, 1e4};        // mm
constexpr Limits kBacklashes{0.0, 2.0};     // mm
constexpr Limits kDepthLimits{0.0, 100.0};  // mm
constexpr Limits kWears{0.0, CuttingFeel::kMostWear};
constexpr Limits kPowers{0.0, 100.0};    // kW
constexpr Limits kTorques{0.0, 1000.0};  // N·m

// The settings that are facts of the machine. Those of an exercise are the teacher's.
bool isOfMachine(std::string_view id) {
  constexpr std::array<std::string_view, 6> kOfMachine{"power", "torque", "wear", "backlash", "grip", "grips_inside"};
  return std::find(kOfMachine.begin(), kOfMachine.end(), id) != kOfMachine.end();
}

// Returns the id of the drill that is put into the tailstock first: the usual one, or else the first one that may be
// mounted; empty: none may.
std::string firstDrill(const LatheSetup& lathe, const LatheTools& tools) {
  constexpr const char* kUsual = "drill-10";
  if (isAllowed(lathe, kUsual)) return kUsual;
  const auto isDrill = [&](const auto& tool) {
    return tool->kind == LatheToolKind::Drill && isAllowed(lathe, tool->id);
  };
  const auto found = std::find_if(tools.begin(), tools.end(), isDrill);
  return found == tools.end() ? std::string() : (*found)->id;
}

void setBacklash(LatheSetup& lathe, double backlash) {
  for (LatheDial& dial : lathe.dials) dial.backlash = backlash;
}

}  // namespace

std::vector<Property> ManualLatheTool::settings() const {
  const LatheSetup lathe = setup();
  std::vector<Property> all = {
      switchSetting("shows_diameter", QT_TRANSLATE_NOOP("Property", "Read-out in diameter"), lathe.showsDiameter),
      switchSetting("chips", QT_TRANSLATE_NOOP("Property", "Chips are shown"), m_showsChips),
      numberSetting("depth_limit", QT_TRANSLATE_NOOP("Property", "Depth limit (0: none)"), lathe.depthLimit,
                    Quantity::Length, kDepthLimits),
      numberSetting("power", QT_TRANSLATE_NOOP("Property", "Motor power, kW (0: no limit)"), lathe.spindle.power,
                    Quantity::Number, kPowers),
      numberSetting("torque", QT_TRANSLATE_NOOP("Property", "Spindle torque, N·m (0: no limit)"), lathe.spindle.torque,
                    Quantity::Number, kTorques),
      numberSetting("wear", QT_TRANSLATE_NOOP("Property", "Flank wear of the tools"), lathe.wear, Quantity::Length,
                    kWears),
      numberSetting("compound_angle",
                    QT_TRANSLATE_NOOP("Property", "Compound slide angle, ° (+: thicker away from the chuck)"),
                    lathe.compoundAngle, Quantity::Number, kAngles),
      numberSetting("backlash", QT_TRANSLATE_NOOP("Property", "Backlash"), lathe.dials[1].backlash, Quantity::Length,
                    kBacklashes),
      numberSetting("grip", QT_TRANSLATE_NOOP("Property", "Length in the jaws"), lathe.chuck.grip, Quantity::Length,
                    kLengths),
      switchSetting("grips_inside", QT_TRANSLATE_NOOP("Property", "Jaws grip inside"), lathe.chuck.gripsInside),
      choiceSetting("fitting", QT_TRANSLATE_NOOP("Property", "In the tailstock"),
                    static_cast<int>(lathe.tailstock.fitting),
                    {QT_TRANSLATE_NOOP("Property", "Nothing"), QT_TRANSLATE_NOOP("Property", "Centre"),
                     QT_TRANSLATE_NOOP("Property", "Drill")}),
      numberSetting("tailstock", QT_TRANSLATE_NOOP("Property", "Tailstock at Z"), lathe.tailstock.position,
                    Quantity::Length, kLengths)};
  for (Property& each : all)
    if (m_document.file().assigned && isOfMachine(each.id)) each.editable = false;
  return all;
}

void ManualLatheTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (id == "chips") {
    assignSwitch(m_showsChips, value);
    return;
  }
  if (m_document.file().assigned && isOfMachine(id)) return;
  LatheSetup lathe = setup();
  double backlash = lathe.dials[1].backlash;
  bool isSet = false;
  if (id == "shows_diameter") isSet = assignSwitch(lathe.showsDiameter, value);
  if (id == "depth_limit") isSet = assignNumber(lathe.depthLimit, value, kDepthLimits);
  if (id == "power") isSet = assignNumber(lathe.spindle.power, value, kPowers);
  if (id == "torque") isSet = assignNumber(lathe.spindle.torque, value, kTorques);
  if (id == "wear") isSet = assignNumber(lathe.wear, value, kWears);
  if (id == "compound_angle") isSet = assignNumber(lathe.compoundAngle, value, kAngles);
  if (id == "backlash") isSet = assignNumber(backlash, value, kBacklashes);
  if (id == "grip") isSet = assignNumber(lathe.chuck.grip, value, kLengths);
  if (id == "grips_inside") isSet = assignSwitch(lathe.chuck.gripsInside, value);
  if (id == "fitting") isSet = assignChoice(lathe.tailstock.fitting, value, 3);
  if (id == "tailstock") isSet = assignNumber(lathe.tailstock.position, value, kLengths);
  if (!isSet) return;
  if (id == "backlash") setBacklash(lathe, backlash);
  if (lathe.tailstock.fitting == LatheFitting::Drill && lathe.tailstock.drill.empty()) {
    lathe.tailstock.drill = firstDrill(lathe, m_tools);
    if (lathe.tailstock.drill.empty()) return;  // the exercise allows none
  }
  setUp(lathe, QCoreApplication::translate("Tool", "Set up the lathe"));
}

}  // namespace handwheel
