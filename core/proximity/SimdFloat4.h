// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace handwheel {

// Compares four floats at once: bit k is set if a[k] <= b[k]. The portable loop takes several times as long as the SSE
// instructions.
inline unsigned atMost(const Eigen::Array4f& a, const Eigen::Array4f& b) {
#ifdef __SSE__
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(_mm_load_ps(a.data()), _mm_load_ps(b.data()))));
#else
  unsigned bits = 0;
  for (int k = 0; k < 4; ++k) bits |= static_cast<unsigned>(a[k] <= b[k]) << k;
  return bits;
#endif
}

}  // namespace handwheel
