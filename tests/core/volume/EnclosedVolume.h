// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ClosedSurface.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>

namespace handwheel::test {

// Fails unless a surface is closed and encloses the exact volume. The relative deviation must be less than `within`.
inline void compareVolume(const Result<SparseVolume>& made, double exact, double within) {
  QVERIFY(made.hasValue());
  const TriangleSoup surface = surfaceOf(*made);
  QVERIFY(isClosedManifold(surface));
  QVERIFY2(std::abs(enclosed(surface) / exact - 1.0) < within,
           qPrintable(QString("%1 for %2").arg(enclosed(surface)).arg(exact)));
}

}  // namespace handwheel::test
