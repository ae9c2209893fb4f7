// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "theme/DefectKind.h"

#include <QString>

namespace handwheel {

// The name of a kind of defects: "Holes", "Non-manifold edges", …
QString defectKindName(DefectKind kind);
// What a kind is, how it is chosen, and what can be done about it.
QString defectKindHint(DefectKind kind);

}  // namespace handwheel
