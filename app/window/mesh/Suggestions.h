// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/SuggestionCard.h"

class QAction;

namespace handwheel {

struct MeshTab;

// The actions that a suggestion of the next step may offer.
struct SuggestedActions {
  QAction* repairAll;
  QAction* undoRepair;
  QAction* removeDebris;
  QAction* oneByOne;
  QAction* thickenSheet;
  QAction* reverseBodies;
  QAction* resolveIntersections;
  QAction* uniteBodies;
  QAction* repairByVolume;
  QAction* showDefects;  // null: the defects are visible
  QAction* saveAs;
};

// Determines the most likely next step for the document.
Suggestion suggestionFor(const MeshTab& document, const SuggestedActions& actions);

}  // namespace handwheel
