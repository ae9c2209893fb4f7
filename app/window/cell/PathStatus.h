// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "window/cell/PathChecks.h"

#include <QLocale>

namespace handwheel {

// The verification state of a path as text: short, as a sentence, and in full. Never empty. Any thread.
struct PathStatus {
  QString text;     // short enough for a column: "free, 12.3 mm, 14:05"
  QString summary;  // "free of collisions (14:05, clearance 12.3 mm)"
  QString details;  // sentences, a line each
  // Those of these lines that are collisions, in the order of stretchesOf().
  QStringList collisions;
  QString icon;  // its name; empty: none
  bool isFree = false;
};
PathStatus pathStatusOf(const PathChecks::State& state, const RobotPath& path, LengthUnit unit, const QLocale& locale);

// "12.3 mm": the least clearance that was found; "> 1000 mm" where everything is further away than is measured.
QString clearanceText(double least, LengthUnit unit, const QLocale& locale);

// Why a path does not lead to what it was planned for any more, a sentence each.
QStringList outdatedSentences(const OutdatedReasons& outdated);

// Pairs that may touch, of which nothing is proven: the first of them, and how many more there are. None: empty.
QString notCheckedText(const std::vector<std::pair<std::string, std::string>>& pairs);

// The first collisions that were found, a text each.
QStringList collisionsOf(const PathFindings& found, LengthUnit unit, const QLocale& locale);
// The same, and how many more there are.
QStringList listedCollisions(const PathFindings& found, LengthUnit unit, const QLocale& locale);

// The details as rich text, in which each collision is a link to its number, from 0.
QString linkedDetails(const PathStatus& status);

}  // namespace handwheel
