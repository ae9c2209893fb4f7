// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ProcessPathSettings.h"

#include "document/cell/CellArms.h"
#include "tools/OperationSettings.h"
#include "tools/ToolProperty.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {

namespace {

constexpr const char* kShownSettings[] = {"along",    "length",   "reverse", "lead",  "tilt",      "spin",     "free",
                                          "standoff", "approach", "speed",   "blend", "tolerance", "clearance"};

}  // namespace

std::vector<std::string> processEnds(const CellRobot& robot, const CellPlans& plans) {
  std::vector<std::string> names;
  for (const NamedConfiguration& each : plans.configurations) {
    if (isSameArm(robot, each.arm, plans.arm)) names.push_back(each.name);
  }
  return names;
}

std::vector<Property> processPathSettings(const OperationValues& values, const std::vector<std::string>& ends) {
  std::vector<Property> all;
  for (const char* const id : kShownSettings) all.push_back(settingOf(values, id));
  for (const char* const end : {"from", "to"}) {
    std::vector<std::string> choices{QT_TRANSLATE_NOOP("Property", "nowhere else"),
                                     QT_TRANSLATE_NOOP("Property", "Current position of the robot")};
    choices.insert(choices.end(), ends.begin(), ends.end());
    const std::string chosen = values.isSet(end) ? values.text(end) : std::string();
    const auto found = std::find(ends.begin(), ends.end(), chosen);
    const int index = chosen == "here" ? 1 : found == ends.end() ? 0 : static_cast<int>(found - ends.begin()) + 2;
    const char* const label = std::string_view(end) == "from" ? QT_TRANSLATE_NOOP("Property", "Comes from")
                                                              : QT_TRANSLATE_NOOP("Property", "Goes to");
    all.push_back(choiceSetting(end, label, index, std::move(choices)));
  }
  return all;
}

std::vector<Property> settingsOfStoredPath(const OperationValues& values, const std::vector<std::string>& ends) {
  std::vector<Property> all = processPathSettings(values, ends);
  std::erase_if(all, [](const Property& each) { return each.id == "along"; });
  for (Property& each : all) each.group = QT_TRANSLATE_NOOP("Property", "Process of the path");
  return all;
}

void takeProcessSetting(OperationValues& values, const std::vector<std::string>& ends, std::string_view id,
                        const PropertyValue& value) {
  const auto* const number = std::get_if<double>(&value);
  const bool isEnd = id == "from" || id == "to";
  if (!isEnd || !number) {
    takeSetting(values, id, value);
    return;
  }
  const auto index = static_cast<std::size_t>(std::max(0.0, *number));
  if (index == 0 || index >= ends.size() + 2)
    values.reset(id);
  else
    values.setValid(id, index == 1 ? "here" : ends[index - 2]);
}

}  // namespace handwheel
