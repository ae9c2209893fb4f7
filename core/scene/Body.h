// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodyGeometry.h"

#include <array>
#include <optional>
#include <string>

namespace handwheel {

// The identifier of a body within its document, counted from 1. It is not used again in the document, unless its use
// was undone.
using BodyId = std::uint32_t;

// The appearance of a body.
struct BodyLook {
  std::array<float, 3> colour{0.72f, 0.74f, 0.78f};  // sRGB, 0…1
  bool smooth = true;                                // Shaded across edges that are not sharp
  bool operator==(const BodyLook&) const = default;
};

// The state of the file that a body is linked to.
enum class LinkState {
  Unchecked,
  Present,  // The file has not changed since it was read
  Missing,
  Changed,
};

// The file that the shape of a body was read from, for reading the shape again. The document also contains the shape.
struct BodyLink {
  std::string path;      // Last known path; absolute, UTF-8
  std::string relative;  // Path relative to the folder of the document file that the link was read from; empty: none
  std::string sha256;    // Digest of the file when it was read, in hexadecimal digits
  LinkState state = LinkState::Unchecked;  // State when the document was opened; not saved
  bool operator==(const BodyLink&) const = default;
};

// One object of a document that contains several objects: a shape with a pose. It is a value, whose versions share the
// shape.
struct Body {
  BodyId id = 0;
  std::string name;  // UTF-8, unique in its document, not empty
  // The name of the carrier, such as a link of a robot; empty: none, the body is fixed in the world.
  std::string carrier = {};
  Pose pose = Pose::Identity();   // Rigid (scene/RigidPose.h); in the frame of the carrier
  GeometryPointer geometry = {};  // Never null in a document
  BodyLook look = {};
  bool visible = true;
  std::optional<BodyLink> link = {};

  bool operator==(const Body& other) const;  // Compares the shape by address
  std::size_t bytes() const;                 // Memory without the shape
};

using BodyPointer = std::shared_ptr<const Body>;

}  // namespace handwheel
