// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace handwheel {

// A large scan of a head, from the package occt-misc. headSections() divides it along y into four sections of 77 mm.
inline constexpr const char* kHeadScan = "/usr/share/opencascade/data/stl/head.stl";

// Returns the first sections of the scan as binary STL. Triangles that reach beyond these sections are omitted, so the
// surface is open at the end of the last section. Four sections are the whole scan.
inline QByteArray headSections(int sections) {
  QFile file(kHeadScan);
  if (!file.open(QIODevice::ReadOnly)) qFatal("cannot read the scan");
  const QByteArray all = file.readAll();
  constexpr qsizetype kHeader = 80, kStart = kHeader + 4, kTriangle = 50;
  QByteArray kept = all.left(kStart);
  std::uint32_t triangles = 0;
  for (qsizetype at = kStart; at + kTriangle <= all.size(); at += kTriangle) {
    std::array<float, 12> numbers{};  // a normal and three corners
    std::memcpy(numbers.data(), all.constData() + at, sizeof numbers);
    if (std::max({numbers[4], numbers[7], numbers[10]}) >= 77.0f * static_cast<float>(sections)) continue;
    kept.append(all.constData() + at, kTriangle);
    ++triangles;
  }
  std::memcpy(kept.data() + kHeader, &triangles, sizeof triangles);
  return kept;
}

}  // namespace handwheel
