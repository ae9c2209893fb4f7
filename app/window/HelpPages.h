// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace handwheel {

// Small windows that stay open beside the work.
void showKeys(QWidget& parent);
void showAbout(QWidget& parent);

}  // namespace handwheel
