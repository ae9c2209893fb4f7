// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityFit.h"

#include <QLocale>

namespace handwheel {

// Describes the limits that the preset Fit meets and those that it exceeds. The text has a few sentences.
QString fitText(const FidelityFit& fit, const QLocale& locale);

}  // namespace handwheel
