// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The former place of this header, for code that was written before it moved.
#include "base/JsonText.h"
