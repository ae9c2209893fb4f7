// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What ManualLatheTool does by keys, and how it is undone.
#include "tools/workpiece/ManualLatheTool.h"

#include <QCoreApplication>
#include <utility>

namespace handwheel {

namespace {

using LatheKind = LatheCommand::Kind;

// A key that moves a slide, by some divisions of its dial or as long as it is held. Keys with the same hint share one
// in the hint bar.
struct SlideKey {
  const char* action;
  LatheAxis axis;
  double divisions;  // for the power traverse only the sign counts
  const char* hint;
  bool isRapid = false;
};
constexpr const char* kCarriageHint = QT_TRANSLATE_NOOP("Tool", "move the carriage");
constexpr const char* kCrossHint = QT_TRANSLATE_NOOP("Tool", "move the cross slide");
constexpr const char* kCompoundHint = QT_TRANSLATE_NOOP("Tool", "move the compound slide");
constexpr const char* kFarHint = QT_TRANSLATE_NOOP("Tool", "by ten divisions");
constexpr const char* kFineHint = QT_TRANSLATE_NOOP("Tool", "by a tenth of a division");
constexpr const char* kRapidHint = QT_TRANSLATE_NOOP("Tool", "rapid traverse while held");
constexpr SlideKey kSlideKeys[] = {{"carriage-left", LatheAxis::Carriage, -1.0, kCarriageHint},
                                   {"carriage-right", LatheAxis::Carriage, 1.0, kCarriageHint},
                                   {"cross-in", LatheAxis::Cross, -1.0, kCrossHint},
                                   {"cross-out", LatheAxis::Cross, 1.0, kCrossHint},
                                   {"carriage-far-left", LatheAxis::Carriage, -10.0, kFarHint},
                                   {"carriage-far-right", LatheAxis::Carriage, 10.0, kFarHint},
                                   {"cross-far-in", LatheAxis::Cross, -10.0, kFarHint},
                                   {"cross-far-out", LatheAxis::Cross, 10.0, kFarHint},
                                   {"carriage-fine-left", LatheAxis::Carriage, -0.1, kFineHint},
                                   {"carriage-fine-right", LatheAxis::Carriage, 0.1, kFineHint},
                                   {"cross-fine-in", LatheAxis::Cross, -0.1, kFineHint},
                                   {"cross-fine-out", LatheAxis::Cross, 0.1, kFineHint},
                                   {"carriage-rapid-left", LatheAxis::Carriage, -1.0, kRapidHint, true},
                                   {"carriage-rapid-right", LatheAxis::Carriage, 1.0, kRapidHint, true},
                                   {"cross-rapid-in", LatheAxis::Cross, -1.0, kRapidHint, true},
                                   {"cross-rapid-out", LatheAxis::Cross, 1.0, kRapidHint, true},
                                   {"compound-in", LatheAxis::Compound, -1.0, kCompoundHint},
                                   {"compound-out", LatheAxis::Compound, 1.0, kCompoundHint}};

}  // namespace

std::span<const ToolKey> ManualLatheTool::keys() {
  static const ToolKey kKeys[] = {
      {"carriage-left", "Left", QT_TRANSLATE_NOOP("Tool", "carriage to the chuck")},
      {"carriage-right", "Right", QT_TRANSLATE_NOOP("Tool", "carriage away")},
      {"carriage-far-left", "Shift+Left", QT_TRANSLATE_NOOP("Tool", "carriage by ten divisions to the chuck")},
      {"carriage-far-right", "Shift+Right", QT_TRANSLATE_NOOP("Tool", "carriage by ten divisions away")},
      {"carriage-fine-left", "Ctrl+Left", QT_TRANSLATE_NOOP("Tool", "carriage by a tenth of a division to the chuck")},
      {"carriage-fine-right", "Ctrl+Right", QT_TRANSLATE_NOOP("Tool", "carriage by a tenth of a division away")},
      {"carriage-rapid-left", "Alt+Left", QT_TRANSLATE_NOOP("Tool", "carriage rapidly to the chuck, while held")},
      {"carriage-rapid-right", "Alt+Right", QT_TRANSLATE_NOOP("Tool", "carriage rapidly away, while held")},
      {"cross-in", "Up", QT_TRANSLATE_NOOP("Tool", "cross slide in")},
      {"cross-out", "Down", QT_TRANSLATE_NOOP("Tool", "cross slide out")},
      {"cross-far-in", "Shift+Up", QT_TRANSLATE_NOOP("Tool", "cross slide by ten divisions in")},
      {"cross-far-out", "Shift+Down", QT_TRANSLATE_NOOP("Tool", "cross slide by ten divisions out")},
      {"cross-fine-in", "Ctrl+Up", QT_TRANSLATE_NOOP("Tool", "cross slide by a tenth of a division in")},
      {"cross-fine-out", "Ctrl+Down", QT_TRANSLATE_NOOP("Tool", "cross slide by a tenth of a division out")},
      {"cross-rapid-in", "Alt+Up", QT_TRANSLATE_NOOP("Tool", "cross slide rapidly in, while held")},
      {"cross-rapid-out", "Alt+Down", QT_TRANSLATE_NOOP("Tool", "cross slide rapidly out, while held")},
      {"compound-in", "PgUp", QT_TRANSLATE_NOOP("Tool", "compound slide in")},
      {"compound-out", "PgDown", QT_TRANSLATE_NOOP("Tool", "compound slide out")},
      {"spindle", "Space", QT_TRANSLATE_NOOP("Tool", "start or stop the spindle")},
      {"next-tool", "Shift+T", QT_TRANSLATE_NOOP("Tool", "turn the tool post")},
      {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "stop the lathe")}};
  return kKeys;
}

void ManualLatheTool::turn(LatheAxis axis, double divisions) {
  const double by = divisions * setup().dials[static_cast<std::size_t>(axis)].perDivision;
  command({LatheKind::Turn, axis, by});
}

ToolReply ManualLatheTool::perform(std::string_view action) {
  const auto now = moment();
  for (const SlideKey& key : kSlideKeys) {
    if (action != key.action) continue;
    m_isRapid = m_isRapid || key.isRapid;
    if (key.isRapid)
      command({LatheKind::Rapid, key.axis, key.divisions});
    else
      turn(key.axis, key.divisions);
    return ToolReply::Used;
  }
  if (action == "spindle") {
    command({LatheKind::Spindle, LatheAxis::Carriage, now->machine.direction == 0 ? 1.0 : 0.0});
    return ToolReply::Used;
  }
  if (action == "next-tool") {
    const std::size_t count = setup().stations.size();
    command({LatheKind::Tool, LatheAxis::Carriage, static_cast<double>((now->machine.tool + 1) % count)});
    return ToolReply::Used;
  }
  if (action != "revert") return ToolReply::Ignored;
  stop();
  return ToolReply::Used;
}

void ManualLatheTool::stop() {
  for (const LatheCommand& stop : {LatheCommand{LatheKind::Spindle}, LatheCommand{LatheKind::Feed},
                                   LatheCommand{LatheKind::HalfNut}, LatheCommand{LatheKind::Release}})
    command(stop);
  m_isRapid = true;  // by a button of the panel it may be, too
  stopRapids();
  m_isDragging = false;
  endPass(true);
}

void ManualLatheTool::stopRapids() {
  if (!std::exchange(m_isRapid, false)) return;
  for (std::size_t i = 0; i < kLatheAxes; ++i) command({LatheKind::Rapid, static_cast<LatheAxis>(i), 0.0});
}

// The pass that is being cut is ended, so that it is the last step. With nothing to undo it stops the lathe.
ToolReply ManualLatheTool::undo() {
  if (!isLive()) return ToolReply::Ignored;
  m_isDragging = false;
  endPass(true);
  if (!m_document.history()->canUndo()) stop();
  return m_document.history()->canUndo() ? ToolReply::Ignored : ToolReply::Used;
}

std::vector<ToolAction> ManualLatheTool::actions() const {
  std::vector<ToolAction> all{{"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "move the tool")}};
  for (const char* const action : {"spindle", "next-tool"}) all.push_back(actionOf(keys(), action));
  all.push_back(actionOf(keys(), "revert", isLive()));
  for (const SlideKey& key : kSlideKeys) {  // the panel has their wheels
    all.push_back(actionOf(keys(), key.action, true, key.hint));
    all.back().isKeyOnly = true;
  }
  return all;
}

}  // namespace handwheel
