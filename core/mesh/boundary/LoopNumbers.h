// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Assigns the displayed numbers of boundary loops, as in "Hole 3". Holes and outer boundaries of open sheets are
// counted separately, from 1, in the order of their ids, so the numbers agree in the window and on the command line.
class LoopNumbers {
 public:
  int peek(bool isSheetBoundary) const { return (isSheetBoundary ? m_sheetBoundaries : m_holes) + 1; }
  int take(bool isSheetBoundary) { return ++(isSheetBoundary ? m_sheetBoundaries : m_holes); }

 private:
  int m_holes = 0;
  int m_sheetBoundaries = 0;
};

}  // namespace handwheel
