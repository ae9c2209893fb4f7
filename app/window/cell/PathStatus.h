// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "window/cell/PathChecks.h"

#include <QLocale>

namespace handwheel {

// The verification state of a path as texts, which are never empty. pathStatusOf() may be called on any thread.
struct PathStatus {
  QString text;     // Short enough for a column: "free, 12.3 mm, 14:05"
  QString summary;  // One sentence: "free of collisions (14:05, clearance 12.3 mm)"
  QString details;  // Several sentences, one per line
  // The lines of `details` that describe collisions, in the order of stretchesOf().
  QStringList collisions;
  QString icon;  // Name of an icon; empty: none
  bool isFree = false;
};
PathStatus pathStatusOf(const PathChecks::State& state, const RobotPath& path, LengthUnit unit, const QLocale& locale);

// Returns a clearance as text: "12.3 mm", or "> 1000 mm" if all distances are beyond the measured range.
QString clearanceText(double least, LengthUnit unit, const QLocale& locale);

// Returns the reasons why a path is out of date, one sentence each.
QStringList outdatedSentences(const OutdatedReasons& outdated);

// Returns the first pairs that are not checked because they may touch, and the number of the remaining ones. The result
// is empty if there are no pairs.
QString notCheckedText(const std::vector<std::pair<std::string, std::string>>& pairs);

// Returns the first collisions that were found, one text each.
QStringList collisionsOf(const PathFindings& found, LengthUnit unit, const QLocale& locale);
// Returns the first collisions that were found, one text each, and the number of the remaining ones.
QStringList listedCollisions(const PathFindings& found, LengthUnit unit, const QLocale& locale);

// Returns the details as rich text, in which each collision is a link whose target is its index, from 0.
QString linkedDetails(const PathStatus& status);

}  // namespace handwheel
