// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// A size with its limits, mm. A side without a limit is free.
struct ToleratedSize {
  double nominal = 0.0;
  std::optional<double> lower = {}, upper = {};
};

// The limits of an ISO metric thread with a tolerance class (ISO 965-1).
//
// The root of an external thread is between those of a root radius of P/8 and of H/6. The standard has no tolerance of
// the pitch: its error counts in the pitch diameter, by the cotangent of half the angle between the flanks. The limits
// of the pitch are those of an error that takes half of the tolerance of the pitch diameter from groove to groove.
struct ThreadTolerance {
  std::string designation;  // "M10×1.5-6g"
  std::string grade;        // "6g"
  bool isInner = false;     // true: the thread of a nut
  ToleratedSize pitch, major, pitchDiameter, minor;
};

// Returns the limits of a thread by its designation, such as "M10x1.5-6g", "M10×1.25 - 5g6g" or "M20-6H"; without a
// pitch it has the coarse one of ISO 261. The grades are 3 to 9 for the pitch diameter and 4, 6, 8 (external) or 4 to 8
// (internal) for the crest, the positions e, f, g, h and G, H. Returns nothing for other texts, and for sizes without a
// tolerance in ISO 965-1.
std::optional<ThreadTolerance> threadTolerance(std::string_view designation);

// Returns the class at the begin of a text, such as "6g" of "6g major diameter"; empty: there is none.
std::string_view threadClassIn(std::string_view text);

// The diameters of a thread that its nominal sizes tell apart.
enum class ThreadDiameter { Major, Pitch, Minor };

// Returns the limits of the coarse thread of this class whose nominal diameter has this value to a micrometre. Returns
// nothing if there is no such thread.
std::optional<ThreadTolerance> coarseThreadWith(ThreadDiameter which, double nominal, std::string_view threadClass);

}  // namespace handwheel
