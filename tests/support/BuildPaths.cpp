// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"

QString handwheel::test::sourcePath(const QString& path) {
  return QStringLiteral(HANDWHEEL_SOURCE_FOLDER "/") + path;
}

QString handwheel::test::buildPath(const QString& path) {
  return QStringLiteral(HANDWHEEL_BUILD_FOLDER "/") + path;
}
