// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "theme/DefectKind.h"

#include <QString>

namespace handwheel {

// Returns the name of a kind of defects: "Holes", "Non-manifold edges", …
QString defectKindName(DefectKind kind);
// Returns an explanation of a kind of defects, with its criterion and the remedies.
QString defectKindHint(DefectKind kind);

}  // namespace handwheel
