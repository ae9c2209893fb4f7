// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

namespace handwheel {

// Whether drawing a mesh of so many faces can be begun at all: the least that the graphics take fits into what the
// system and the limits of this process leave. It may still turn out to be too little.
bool isEnoughToDraw(std::size_t faces);

// The graphics do not look whether they get the memory that they ask for. From now on a crash of this program where
// none is left becomes the sentence that there is not enough to draw the file, and the exit code of an error; one for
// another reason stays a crash. For programs that write nothing before they are done.
void tellCrashes(const std::filesystem::path& file);

}  // namespace handwheel
