// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "mesh/structure/TriangleSoup.h"

namespace handwheel {

// Writes triangles to the blobs "name/points/NNNN" (three numbers each, mm) and "name/triangles/NNNN" (three indices
// each). Returns their counts, {"points", "triangles"}. Number: float or double.
template <class Number>
nlohmann::json writeSoupBlobs(const TriangleSoup& soup, const std::string& name, Container& container);

// Reads triangles from blobs; the input may be arbitrary. Triangles are omitted if a corner is missing, not finite or
// beyond largestCoordinate (mm). lost: receives the number of omitted triangles.
template <class Number>
TriangleSoup readSoupBlobs(const nlohmann::json& counts, const std::string& name, const Container& container,
                           double largestCoordinate, std::uint64_t& lost);

}  // namespace handwheel
