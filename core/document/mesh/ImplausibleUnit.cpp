// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/ImplausibleUnit.h"

#include "base/NumberText.h"

#include <QtGlobal>

namespace handwheel {

namespace {

// With three significant digits, and no exponent where that reads well.
std::string sizeText(double size) {
  double rounded = size;
  ErrorCode why;
  return parseDecimal(roundedText(size, 3), rounded, why) ? shownText(rounded) : std::string();
}

}  // namespace

bool isUnitImplausible(const DocumentFile& file, const Box& box) {
  if (file.hasUnit || box.isEmpty()) return false;
  const double size = box.sizes().maxCoeff();
  return size < kSmallestLikelySize || size > kLargestLikelySize;
}

Note implausibleUnit(const Box& box) {
  const Vec3 size = box.sizes();
  return {QT_TRANSLATE_NOOP("Note",
                            "The part measures %1 × %2 × %3 mm, if its numbers are millimetres: the file does not say "
                            "its unit."),
          {sizeText(size.x()), sizeText(size.y()), sizeText(size.z())}};
}

}  // namespace handwheel
