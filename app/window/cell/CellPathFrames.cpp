// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The actions for frames.
#include "document/cell/BodyCarriers.h"
#include "document/cell/RobotCellDocument.h"
#include "window/cell/CellPaths.h"
#include "window/documents/DocumentTab.h"

#include <algorithm>

namespace handwheel {

// The selected one, unless a robot carries it: its own tool is mostly what is selected then.
BodyPointer CellPaths::bodyForTargets() const {
  const BodyPointer selected = m_selected();
  return selected && carrierOf(*selected, cell().robot().model) == kNone ? selected : nullptr;
}

void CellPaths::storeFrame() {
  m_document->document.settle();  // the hand may lead the robot
  CellPlans changed = plans();
  const std::string preferred = tr("Frame %1").arg(changed.frames.size() + 1).toStdString();
  NamedFrame frame{.name = changed.frameNames().take(preferred)};
  const BodyPointer body = bodyForTargets();
  if (body) frame.body = body->id;
  frame = frameAt(std::move(frame), toolPose(cell().robot(), changed, seenJoints()), seenPlacement());
  const PlanTree::Entry entry{PlanTree::Entry::Kind::Frame, frame.name};
  const QString name = QString::fromStdString(frame.name);
  changed.frames.push_back(std::move(frame));
  const QString text =
      body ? tr("Store %1 on %2").arg(name, QString::fromStdString(body->name)) : tr("Store %1").arg(name);
  if (!commit(text, std::move(changed))) return;
  m_tree->select(entry);
  reportStored(
      *m_document, tr("%1 was stored").arg(name),
      body ? tr("It moves with %1.").arg(QString::fromStdString(body->name)) : tr("It is selected in the list."),
      entry);
}

// It stays on what carries it, and its targets move with it.
void CellPaths::setFrameHere(const std::string& name) {
  CellPlans changed = plans();
  const auto frame = std::find_if(changed.frames.begin(), changed.frames.end(),
                                  [&](const NamedFrame& each) { return each.name == name; });
  if (frame == changed.frames.end()) return;
  *frame = frameAt(*frame, toolPose(cell().robot(), changed, seenJoints()), seenPlacement());
  commit(tr("Set %1").arg(QString::fromStdString(name)), std::move(changed));
}

void CellPaths::workIn(const std::string& name) {
  CellPlans changed = plans();
  if (!changed.frame(name)) return;
  const bool isChosen = changed.workFrame == name;
  changed.workFrame = isChosen ? std::string() : name;
  const QString shown = QString::fromStdString(name);
  commit(isChosen ? tr("Work in no frame") : tr("Work in %1").arg(shown), std::move(changed));
}

// Returns the carrier of each frame, and marks the chosen one.
std::map<std::string, QString> CellPaths::frameRemarks() const {
  std::map<std::string, QString> remarks;
  for (const NamedFrame& frame : plans().frames) {
    const BodyPointer body = frame.body == 0 ? nullptr : cell().bodies().withId(frame.body);
    const std::string& carrier = body ? body->name : frame.link;
    QString text = !poseOfFrame(frame, cell().placement()) ? tr("what carried it was removed")
                   : carrier.empty()                       ? QString()
                                                           : tr("on %1").arg(QString::fromStdString(carrier));
    if (frame.name == plans().workFrame)
      text = text.isEmpty() ? tr("for coordinates and programs") : tr("%1; for coordinates and programs").arg(text);
    remarks[frame.name] = text;
  }
  return remarks;
}

}  // namespace handwheel
