// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

namespace handwheel {

// Asks whether voxels may use this number of bytes. start: the function that is called at once if no consent is needed
// (needsConsent()), otherwise when the user agrees.
void askForMemory(QWidget* window, double bytes, std::function<void()> start);

// Returns the memory needed and available as text: "about 120 MB of 6,100 MB available".
QString memoryText(double bytes);

}  // namespace handwheel
