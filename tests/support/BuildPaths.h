// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// Absolute paths of files that tests need. They are compiled into BuildPaths.cpp alone, so that the objects of the
// tests are the same in each checkout and are found in the compiler's cache.
namespace handwheel::test {

QString sourcePath(const QString& path);  // absolute path of a file in the checkout
QString buildPath(const QString& path);   // absolute path of a file in the build folder

inline QString programPath() {
  return buildPath("bin/handwheel");
}

}  // namespace handwheel::test
