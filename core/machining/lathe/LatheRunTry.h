// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheRun.h"

namespace handwheel {

// A step as requested by levers and handwheels, before it is checked. It may still be refused.
struct LatheRun::Try {
  LatheMotion motion;
  std::shared_ptr<const LatheTool> tool;  // the tool that moved: a tool of the post, or the drill in the quill
  ProfilePoint from{0.0, 0.0}, to{0.0, 0.0};
  RemovedMaterial cut;
  double pushed = 0.0;     // mm, part of cut.depth by which a hand or the power traverse pushes the tool in
  bool isQuill = false;    // the quill moved
  bool isIndexed = false;  // the post was turned to another tool
  bool isPressed = false;  // an abrasive tool is pressed against the work
  std::optional<ThreadCut> thread;
  // A threading tool is at rest in its groove, or is drawn out of stationary work along its shoulder
  bool takesNothing = false;
  bool isRing = false;  // the nut was opened and the tool stayed in: the end of the groove is now a full circle
  // Returns true if the tool moves along the axis rather than across it.
  bool goesAlong() const { return std::abs(to.y() - from.y()) > std::abs(to.x() - from.x()); }
  bool hasMoved() const { return isQuill || isIndexed || isPressed || isRing || from != to; }
};

}  // namespace handwheel
