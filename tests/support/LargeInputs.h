// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

// Sizes of the inputs of long tests. `./check --only=large` sets HANDWHEEL_LARGE and runs the classes with the label
// large.
namespace handwheel::test {

inline bool withLargeInputs() {
  return qEnvironmentVariableIsSet("HANDWHEEL_LARGE");
}

// Returns the size for `./check`, or the larger size if HANDWHEEL_LARGE is set.
template <class Size>
Size sized(Size usual, Size large) {
  return withLargeInputs() ? large : usual;
}

}  // namespace handwheel::test
