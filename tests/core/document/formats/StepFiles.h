// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BuildPaths.h"
#include "document/FileBytes.h"
#include "document/formats/MeshFormat.h"

#include <QtGlobal>
#include <string>

// STEP files for tests, written by Open CASCADE.
namespace handwheel::test {

inline const char* const kStepFiles[] = {"box-inch.step", "line.step", "open-box-metre.step", "sphere.step",
                                         "two-drilled.step"};

inline std::string stepFile(const std::string& name) {
  const auto bytes = readFileBytes(test::sourcePath("tests/core/document/formats/fixtures/").toStdString() + name);
  if (!bytes) qFatal("there is no %s", name.c_str());
  return *bytes;
}

// Returns the text with the first occurrence of a part replaced.
inline std::string replaced(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  if (at == std::string::npos) qFatal("the file does not hold %s", before.c_str());
  return text.replace(at, before.size(), after);
}

}  // namespace handwheel::test
