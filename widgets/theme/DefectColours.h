// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

namespace handwheel {

// The kinds of defect as the user sees them, in the order in which the panel lists them.
enum class DefectKind {
  Hole,
  KeptOpen,
  NonManifoldEdge,
  NonManifoldVertex,
  OneSided,
  NearVertex,
  Flipped,
  Degenerate,
  Duplicate,
  SelfIntersection,
  Debris,
};
inline constexpr int kDefectKinds = 11;

// The colour of a defect, the same in lists and in the viewport, in both themes. Hues after Okabe and Ito's set, which
// people with colour blindness tell apart; every use is doubled by the icon.
QColor defectColour(DefectKind kind);

// The name for icon() in Icons.h.
QString defectIconName(DefectKind kind);

}  // namespace handwheel
