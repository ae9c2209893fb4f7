// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/NextStepCard.h"

class QAction;

namespace handwheel {

struct OpenMesh;

struct NextStepActions {
  QAction* repairAll;
  QAction* removeDebris;
  QAction* oneByOne;
  QAction* giveBack;
  QAction* showDefects;  // null: they are in view
  QAction* saveAs;
};

// What the user of this document most likely wants next.
NextStep nextStepFor(const OpenMesh& document, const NextStepActions& actions);

}  // namespace handwheel
