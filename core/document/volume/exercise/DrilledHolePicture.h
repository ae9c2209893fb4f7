// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/exercise/DrillingTask.h"
#include "volume/drilling/DrillReview.h"

#include <QImage>

namespace handwheel {

// The colours in a picture of a hole.
struct HoleColours {
  static constexpr QRgb kAir = qRgb(0xff, 0xff, 0xff);
  static constexpr QRgb kLeft = qRgb(0xba, 0xbd, 0xb6);
  static constexpr QRgb kDrilled = qRgb(0xbf, 0xd7, 0xf0);
  // Material drilled outside the tolerance around the planned line, or in the forbidden region.
  static constexpr QRgb kBeside = qRgb(0xcc, 0x00, 0x00);
  static constexpr QRgb kForbidden = qRgb(0xf2, 0xc4, 0xc6);
  static constexpr QRgb kLeftForbidden = qRgb(0xb0, 0x90, 0x92);  // remaining material in the region
  static constexpr QRgb kPlanned = qRgb(0x33, 0x9e, 0x52);        // planned line, and dashes for its tolerance
  static constexpr QRgb kPath = qRgb(0x00, 0x00, 0x00);           // path of the tip
};

// Draws the drilled hole in a section along the planned path, to scale, with the path of the tip.
//
// The drill enters from above. The section contains the planned line and the position of the head that was farthest
// from the line while it was cutting. holes, review: the holes and the review of the same work. Returns a null image if
// cancelled. May be called on any thread; O(pixels · balls of the forbidden region + poses).
QImage holePicture(const DrillingTask& task, const DrilledHoles& holes, const DrillReview& review, Progress progress);

}  // namespace handwheel
