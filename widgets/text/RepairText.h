// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "document/formats/MeshFormat.h"
#include "mesh/HoleFilling.h"
#include "mesh/Repair.h"

#include <QStringList>

namespace handwheel {

// How the user knows a fill method ("Fair"), and one sentence on when to choose it.
QString fillMethodName(FillMethod method);
QString fillMethodHint(FillMethod method);

// The word for the command line: --fill fair.
QString fillMethodWord(FillMethod method);

// Why a hole stayed open, as the end of a sentence: "every patch would cross the part".
QString fillFailureReason(FillFailure failure);

// "colours", "texture coordinates", …
QString lostAttributeName(LostAttribute attribute);

// What a repair did besides filling, one phrase per kind of change; empty when it did nothing.
QStringList repairSummary(const RepairReport& report);

// A length as the user reads it, with three significant digits: "31.2 mm", and at most two decimals, or four in units
// other than mm.
QString lengthText(double millimetres, LengthUnit unit);

}  // namespace handwheel
