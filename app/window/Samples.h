// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFileInfo;

namespace handwheel {

// A document that is shipped with the program; empty when it is missing.
QString samplePath(const QString& name);

bool isSample(const QFileInfo& file);

}  // namespace handwheel
