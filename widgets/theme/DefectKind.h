// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

namespace handwheel {

// The kinds of mesh defects, in the order of the panel.
enum class DefectKind {
  Hole,
  KeptOpen,
  NonManifoldEdge,
  NonManifoldVertex,
  OneSided,
  InsideOut,
  // Single triangles that face the wrong side. Opening a file reverses them, so they exist only after that is undone.
  Inconsistent,
  NearVertex,
  Degenerate,
  Duplicate,
  SelfIntersection,
  Debris,
  Flipped,  // triangles that were reversed when the file was opened
};
inline constexpr int kDefectKinds = 13;

// Returns the colour of a kind of defect. It is the same in lists and in the viewport, in both themes. Hues are from
// the palette of Okabe and Ito, which people with colour blindness can distinguish; every use is accompanied by the
// icon.
QColor defectColour(DefectKind kind);

// Returns the name for icon() in Icons.h.
QString defectIconName(DefectKind kind);

}  // namespace handwheel
