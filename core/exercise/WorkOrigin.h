// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Origin of work, as far as its recording tells. Unknown: nothing was made, or the kind of work does not record it.
enum class WorkOrigin { Unknown, Hand, Program, Both };

}  // namespace handwheel
