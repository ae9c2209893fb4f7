// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "mesh/repair/Repair.h"
#include "panels/defects/DefectList.h"

#include <QString>
#include <map>

namespace handwheel {

class LogModel;
struct MeshChange;
struct MeshTab;

// The effect of a change, in words.
struct ChangeSummary {
  QString line;                 // text for the log
  QString how;                  // text for the message, a list of phrases; may be empty
  bool isPartly = false;        // the change had an effect on only some of the sheets
  bool hasLostWalls = false;    // walls thinner than the voxels were lost
  bool isWorthMessage = false;  // the effect is shown as a message, not only in the log
};

// Summarises a change after it was committed. text: the name of the change, translated.
ChangeSummary changeSummaryOf(const MeshTab& document, const MeshChange& done, const QString& text);

// Returns a sentence for each patch of a repair that differs from its surroundings. names: the names of the loops
// before the repair, by id.
QStringList patchWarningsOf(const RepairReport& report, const std::map<int, QString>& names);

// Returns the effects of a repair that the numbers of defects before and after it do not show, one phrase for each.
QStringList doneBesides(RepairReport report, const std::map<DefectKind, std::size_t>& before,
                        const std::map<DefectKind, std::size_t>& after, LengthUnit unit);

// Adds the effects of a repair to the log, and a warning for each loop that needs one. names: the names of the loops
// before the repair, by id.
void logRepair(LogModel& log, const MeshTab& document, const RepairReport& report, const std::map<int, QString>& names,
               const QString& command);

}  // namespace handwheel
