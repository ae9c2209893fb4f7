// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "theme/DefectKind.h"

#include <array>

namespace handwheel {

namespace {

struct Look {
  QRgb colour;
  const char* icon;
};

constexpr std::array<Look, kDefectKinds> kLooks = {{
    {0xff2f93e0, "hole"},
    {0xff10a37f, "kept-open"},
    {0xffd246a0, "nonmanifold-edge"},
    {0xffd246a0, "nonmanifold-vertex"},
    {0xffe8850c, "one-sided"},
    {0xffe8850c, "inside-out"},
    {0xffe8850c, "flipped"},
    {0xff9b6be0, "near-vertices"},
    {0xffd9b400, "degenerate"},
    {0xffd9b400, "duplicate"},
    {0xffdb3a34, "self-intersection"},
    {0xff8a8f98, "debris"},
    {0xff10a37f, "flipped"},
}};

}  // namespace

QColor defectColour(DefectKind kind) {
  return QColor::fromRgb(kLooks[static_cast<std::size_t>(kind)].colour);
}

QString defectIconName(DefectKind kind) {
  return QString::fromLatin1(kLooks[static_cast<std::size_t>(kind)].icon);
}

}  // namespace handwheel
