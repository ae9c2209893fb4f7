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

// What a change has done, in words.
struct ChangeSummary {
  QString line;                 // for the log
  QString how;                  // for the message, a list of phrases; may be empty
  bool isPartly = false;        // it had its effect on some of the sheets only
  bool hasLostWalls = false;    // which were thinner than the voxels
  bool isWorthMessage = false;  // it is worth a message
};

// text: the name of the change, translated. After it was committed.
ChangeSummary changeSummaryOf(const MeshTab& document, const MeshChange& done, const QString& text);

// A sentence for each patch of a repair that is unlike its surroundings. names: of the loops that there were, by id.
QStringList patchWarningsOf(const RepairReport& report, const std::map<int, QString>& names);

// What a repair did that the counts of defects before and after it do not tell, a phrase each.
QStringList doneBesides(RepairReport report, const std::map<DefectKind, std::size_t>& before,
                        const std::map<DefectKind, std::size_t>& after, LengthUnit unit);

// Adds what a repair has done, and a warning for each loop that needs one. names: of the loops that there were, by id.
void logRepair(LogModel& log, const MeshTab& document, const RepairReport& report, const std::map<int, QString>& names,
               const QString& command);

}  // namespace handwheel
