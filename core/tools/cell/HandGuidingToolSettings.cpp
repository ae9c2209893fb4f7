// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/NumberText.h"
#include "document/cell/CellArms.h"
#include "tools/ToolProperty.h"
#include "tools/cell/HandGuidingState.h"
#include "tools/cell/path/PathCheck.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr Limits kScales{0.01, 100.0};
constexpr Limits kSnapDistances{0.0, 100.0};  // mm
constexpr Limits kGrasps{1.0, 100.0};         // mm

}  // namespace

std::vector<std::string> HandGuidingTool::pathNames() const {
  std::vector<std::string> names;
  for (const RobotPath& path : m_document.plans()->paths) {
    if (isSameArm(m_document.robot(), path.arm, m_document.plans()->arm)) names.push_back(path.name);
  }
  return names;
}

std::shared_ptr<const GuideCurve> HandGuidingTool::guide() const {
  return m_path.empty() || !m_services.guide ? nullptr : m_services.guide(m_path);
}

std::vector<Property> HandGuidingTool::settings() const {
  std::vector<Property> all{
      choiceSetting("way", QT_TRANSLATE_NOOP("Property", "The hand leads"), static_cast<int>(m_mode),
                    {QT_TRANSLATE_NOOP("Property", "The tool"), QT_TRANSLATE_NOOP("Property", "Joint by joint"),
                     QT_TRANSLATE_NOOP("Property", "Places of paths")}),
      numberSetting("scale", QT_TRANSLATE_NOOP("Property", "Tool to hand"), m_scale, Quantity::Number, kScales),
      switchSetting("turns", QT_TRANSLATE_NOOP("Property", "Turns with the hand"), m_turns)};
  for (Property& property : m_approach.properties()) all.push_back(std::move(property));
  const std::vector<std::string> names = pathNames();
  std::vector<std::string> choices{QT_TRANSLATE_NOOP("Property", "None")};
  choices.insert(choices.end(), names.begin(), names.end());
  const auto found = std::find(names.begin(), names.end(), m_path);
  const int index = found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
  all.push_back(choiceSetting("path", QT_TRANSLATE_NOOP("Property", "Path to follow"), index, std::move(choices)));
  all.push_back(numberSetting("snap", QT_TRANSLATE_NOOP("Property", "Attracted within"), m_snapDistance,
                              Quantity::Length, kSnapDistances));
  if (m_mode == Mode::Waypoints) {
    all.push_back(numberSetting("grasp", QT_TRANSLATE_NOOP("Property", "Place taken within"), m_grasp, Quantity::Length,
                                kGrasps));
  }
  addFigures(all);
  return all;
}

// Adds the cause that holds the robot back, and the best trial of each kind along the path.
void HandGuidingTool::addFigures(std::vector<Property>& all) const {
  if (m_guidance && m_guidance->hasMoved) {
    if (std::isfinite(m_guidance->felt.distance)) all.push_back(clearanceProperty(m_guidance->felt.distance));
    all.push_back(
        shownLength("behind", QT_TRANSLATE_NOOP("Property", "Distance behind the hand"), m_guidance->step.behind));
    if (m_guidance->step.isBlocked)
      all.back().problem = QT_TRANSLATE_NOOP("Property", "something is in the way");
    else if (m_guidance->step.isAtLimit && m_guidance->step.behind > 1.0)
      all.back().problem = QT_TRANSLATE_NOOP("Property", "a joint is at its limit");
    if (m_guidance->following && m_guidance->following->hasBegun()) {
      all.push_back(
          shownLength("deviation", QT_TRANSLATE_NOOP("Property", "Deviation"), m_guidance->following->deviation()));
    }
  }
  if (!m_services.trials || m_path.empty()) return;
  static constexpr const char* kHelps[] = {QT_TRANSLATE_NOOP("Property", "By eye"),
                                           QT_TRANSLATE_NOOP("Property", "With force"),
                                           QT_TRANSLATE_NOOP("Property", "With force and fixture")};
  for (int help = 0; help < 3; ++help) {
    const HandGuidingTrial* best = nullptr;
    for (const HandGuidingTrial& each : *m_services.trials) {
      if (each.path != m_path || static_cast<int>(each.help) != help || !each.figures.isComplete()) continue;
      if (!best || each.figures.rms < best->figures.rms) best = &each;
    }
    if (!best) continue;
    Property shown;
    shown.id = "try." + std::to_string(help);
    shown.group = QT_TRANSLATE_NOOP("Property", "Best of each kind (RMS, largest, time)");
    shown.label = kHelps[help];
    shown.value = roundedText(best->figures.rms, 3) + " mm, " + roundedText(best->figures.most, 3) + " mm, " +
                  roundedText(best->figures.seconds, 3) + " s";
    shown.isNumbers = true;
    shown.editable = false;
    all.push_back(shown);
  }
}

void HandGuidingTool::setSetting(std::string_view id, const PropertyValue& value) {
  m_near.reset();
  m_approach.set(id, value);
  if (id == "way") assignChoice(m_mode, value, 3);
  if (id == "scale") assignNumber(m_scale, value, kScales);
  if (id == "turns") assignSwitch(m_turns, value);
  if (id == "snap") assignNumber(m_snapDistance, value, kSnapDistances);
  if (id == "grasp") assignNumber(m_grasp, value, kGrasps);
  if (id != "path") return;
  std::size_t index = 0;
  const std::vector<std::string> names = pathNames();
  if (assignChoice(index, value, static_cast<int>(names.size()) + 1)) m_path = index == 0 ? "" : names[index - 1];
}

}  // namespace handwheel
