// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/RevolvedGeometry.h"

#include "base/NumberText.h"
#include "nurbs/Tessellation.h"

namespace handwheel {

Result<std::shared_ptr<const RevolvedGeometry>> RevolvedGeometry::make(ProfileCurve profile, double chord) {
  if (!(chord >= kLeastChord && chord <= kLargestChord)) {
    return Error{ErrorCode::ValueOutOfRange,
                 {"chord", roundedText(chord), roundedText(kLeastChord), roundedText(kLargestChord)},
                 {},
                 {}};
  }
  return std::shared_ptr<const RevolvedGeometry>(new RevolvedGeometry(std::move(profile), chord));
}

std::size_t RevolvedGeometry::bytes() const {
  const ProfileNurbs& nurbs = m_profile.nurbs();
  return nurbs.poles.size() * sizeof(ProfilePoint) + (nurbs.weights.size() + nurbs.knots.size()) * sizeof(double) +
         m_profile.arcs().size_bytes();
}

std::shared_ptr<const TriangleSoup> RevolvedGeometry::makeSurface() const {
  TessellationOptions options;
  options.mostTriangles = kMostTriangles;
  options.chord = m_chord;
  while (options.chord <= TessellationOptions::kLargestChord) {
    Result<TriangleSoup> soup = tessellate(m_profile, options);
    if (soup) return std::make_shared<const TriangleSoup>(std::move(soup).value());
    if (soup.error().code != ErrorCode::ValueOutOfRange) break;
    options.chord *= 2.0;
  }
  return std::make_shared<const TriangleSoup>();
}

}  // namespace handwheel
