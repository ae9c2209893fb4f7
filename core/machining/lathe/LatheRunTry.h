// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheRun.h"

namespace handwheel {

// A step as requested by levers and handwheels, before it is checked. It may still be refused.
struct LatheRun::Try {
  LatheMotion motion;
  std::shared_ptr<const LatheTool> tool;  // the tool that moved, of the post or the drill in the quill
  ProfilePoint from{0.0, 0.0}, to{0.0, 0.0};
  RemovedMaterial cut;
  double pushed = 0.0;     // mm; like cut.depth, but only the part that a hand or the power traverse pushes the tool in
  bool isQuill = false;    // the quill moved
  bool isIndexed = false;  // the post was turned to another tool
  bool isPressed = false;  // an abrasive tool against the work
  std::optional<ThreadCut> thread;
  // A threading tool at rest in its groove, or one that is drawn out of stationary work along its shoulder.
  bool takesNothing = false;
  bool isRing = false;  // the half-nut was opened in a thread, and its end is now a ring
  bool hasMoved() const { return isQuill || isIndexed || isPressed || from != to; }
};

}  // namespace handwheel
