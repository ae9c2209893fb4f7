// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

namespace handwheel {

// Returns true if there is enough memory to draw a mesh of this many faces. Compares the least that the
// graphics need with what the system and the limits of this process leave. It may still turn out to be too little.
bool isEnoughToDraw(std::size_t faces);

// Reports crashes for lack of memory as an error from now on. The graphics libraries do not check if an allocation
// succeeded. A crash of this program with no memory left becomes the sentence that there is not enough to draw the
// file, and the exit code of an error; a crash for another reason stays a crash. For programs that write nothing before
// they are done.
void reportCrashes(const std::filesystem::path& file);

}  // namespace handwheel
