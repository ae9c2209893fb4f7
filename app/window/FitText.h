// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelityFit.h"

#include <QLocale>

namespace handwheel {

// What the preset Fit keeps to, and what it could not: a few sentences.
QString fitText(const FidelityFit& fit, const QLocale& locale);

}  // namespace handwheel
