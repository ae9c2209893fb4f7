// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodyGeometry.h"

#include <array>
#include <optional>
#include <string>

namespace handwheel {

// The identifier of a body within its document, counted from 1. It is not used again in its document, unless what used
// it was undone.
using BodyId = std::uint32_t;

// How a body looks.
struct BodyLook {
  std::array<float, 3> colour{0.72f, 0.74f, 0.78f};  // sRGB, 0…1
  bool smooth = true;                                // shaded across edges that are not sharp
  bool operator==(const BodyLook&) const = default;
};

// What became of the file that a body is linked to.
enum class LinkState {
  Unchecked,
  Present,  // as it was when it was read
  Missing,
  Changed,
};

// The file that the shape of a body was read from, for reading it again. The document keeps the shape all the same.
struct BodyLink {
  std::string path;                        // absolute, UTF-8; where it was found last
  std::string relative;                    // to the folder of the document file that it was read from, if any
  std::string sha256;                      // of the file when it was read, in hexadecimal digits
  LinkState state = LinkState::Unchecked;  // when the document was opened; not saved
  bool operator==(const BodyLink&) const = default;
};

// One thing of a document that holds several: a shape at a place. A value; versions share the shape.
struct Body {
  BodyId id = 0;
  std::string name;  // UTF-8, unique in its document, not empty
  // What carries it, such as a link of a robot, by its name; empty: nothing, it stands in the world.
  std::string carrier = {};
  Pose pose = Pose::Identity();   // in the frame of its carrier, rigid (scene/RigidPose.h)
  GeometryPointer geometry = {};  // never null in a document
  BodyLook look = {};
  bool visible = true;
  std::optional<BodyLink> link = {};

  bool operator==(const Body& other) const;  // the same shape, not an equal one
  std::size_t bytes() const;                 // without the shape
};

using BodyPointer = std::shared_ptr<const Body>;

}  // namespace handwheel
