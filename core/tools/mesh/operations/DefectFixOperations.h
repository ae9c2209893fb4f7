// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Returns the descriptions of the changes that repair one kind of defect (DefectFixes.h).
std::vector<Operation> defectFixOperations();

}  // namespace handwheel
