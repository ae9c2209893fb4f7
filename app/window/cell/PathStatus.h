// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "window/cell/PathChecks.h"

#include <QLocale>

namespace handwheel {

// The verification state of a path as text: short, as a sentence, and in full. Never empty. Any thread.
struct PathStatus {
  QString text;     // Short enough for a column: "free, 12.3 mm, 14:05"
  QString summary;  // "free of collisions (14:05, clearance 12.3 mm)"
  QString details;  // Sentences, one per line
  // The collisions among these lines, in the order of stretchesOf().
  QStringList collisions;
  QString icon;  // Name of an icon; empty: none
  bool isFree = false;
};
PathStatus pathStatusOf(const PathChecks::State& state, const RobotPath& path, LengthUnit unit, const QLocale& locale);

// Returns the least clearance, as in "12.3 mm"; "> 1000 mm" if all distances are beyond the measured range.
QString clearanceText(double least, LengthUnit unit, const QLocale& locale);

// Returns the reasons why a path is out of date, one sentence each.
QStringList outdatedSentences(const OutdatedReasons& outdated);

// Returns the first of the unproven pairs, which may touch, and the number of others. No pairs: empty.
QString notCheckedText(const std::vector<std::pair<std::string, std::string>>& pairs);

// Returns the first collisions that were found, one text each.
QStringList collisionsOf(const PathFindings& found, LengthUnit unit, const QLocale& locale);
// Returns the same, and the number of further ones.
QStringList listedCollisions(const PathFindings& found, LengthUnit unit, const QLocale& locale);

// Returns the details as rich text, in which each collision is a link to its index, from 0.
QString linkedDetails(const PathStatus& status);

}  // namespace handwheel
