// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Returns the multiple of a step that is nearest to a value. The step is 1, 2 or 5 times a power of ten, and at least
// `least`.
double snappedTo(double value, double least);

}  // namespace handwheel
