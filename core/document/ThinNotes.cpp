// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/ThinNotes.h"

#include "base/NumberText.h"

#include <QtGlobal>

namespace handwheel {
namespace {

Note noteOn(const ThinFigures& thin, const char* text) {
  std::string at =
      roundedText(thin.at.x(), 4) + ", " + roundedText(thin.at.y(), 4) + ", " + roundedText(thin.at.z(), 4);
  return {text,
          {roundedText(thin.below), roundedText(100.0 * thin.share, 3), roundedText(thin.area, 4),
           roundedText(thin.least, 3), std::move(at), roundedText(thin.changedArea, 4)}};
}

}  // namespace

std::vector<Note> notesOnThinParts(const ThinFigures& walls, const ThinFigures& gaps) {
  std::vector<Note> notes;
  if (walls.isChanged())
    notes.push_back(noteOn(
        walls, QT_TRANSLATE_NOOP("Note",
                                 "Material was lost: walls are thinner than two voxels (%1 mm) beside %2 % of the "
                                 "surface (%3 mm²), the thinnest %4 mm at (%5). Beside %6 mm² of it half of their "
                                 "thickness or more is gone. Voxels of half the thickness keep a wall.")));
  else if (walls.area > 0.0)
    notes.push_back(noteOn(
        walls, QT_TRANSLATE_NOOP("Note",
                                 "Walls are thinner than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the "
                                 "thinnest %4 mm at (%5): they are not exact. Voxels of half the thickness keep a "
                                 "wall.")));
  if (gaps.isChanged())
    notes.push_back(noteOn(
        gaps,
        QT_TRANSLATE_NOOP("Note",
                          "Gaps were filled: they are narrower than two voxels (%1 mm) beside %2 % of the surface "
                          "(%3 mm²), the narrowest %4 mm at (%5). Beside %6 mm² of it half of their width or "
                          "more is filled. Voxels of half the width keep a gap.")));
  else if (gaps.area > 0.0)
    notes.push_back(noteOn(
        gaps, QT_TRANSLATE_NOOP("Note",
                                "Gaps are narrower than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the "
                                "narrowest %4 mm at (%5): they are not exact. Voxels of half the width keep a gap.")));
  return notes;
}

}  // namespace handwheel
