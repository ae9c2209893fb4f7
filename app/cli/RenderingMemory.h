// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

namespace handwheel {

// Returns true if there is enough memory to draw a mesh of this many faces. Compares the least memory that the graphics
// need with the memory that the system and the limits of this process leave. Drawing may still run out of memory.
bool isEnoughToDraw(std::size_t faces);

// Reports crashes for lack of memory as an error from now on. The graphics libraries do not check if an allocation
// succeeded. If this program crashes with no memory left, it prints that there is not enough memory to draw the file,
// and ends with the exit code of an error. A crash for another reason stays a crash. Meant for programs that write
// nothing before they are done.
void reportCrashes(const std::filesystem::path& file);

}  // namespace handwheel
