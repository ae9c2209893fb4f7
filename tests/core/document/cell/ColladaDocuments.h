// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/ColladaReader.h"

#include <stdexcept>
#include <string>

// Builders of COLLADA documents.
namespace handwheel::test {

inline const std::string kTriangles =
    "<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles>";

// Returns the geometry "g" with these primitives. Its nine points have the x and y of a grid of 3 × 3 points with
// spacing 1; the z of point i is i / 10.
inline std::string geometry(const std::string& primitives = kTriangles) {
  std::string numbers;
  for (int i = 0; i < 9; ++i)
    numbers += std::to_string(i % 3) + " " + std::to_string(i / 3) + " 0." + std::to_string(i) + "\n";
  return "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' count='27'>" + numbers +
         "</float_array><technique_common><accessor source='#a' count='9' stride='3'><param name='X' type='float'/>"
         "<param name='Y' type='float'/><param name='Z' type='float'/></accessor></technique_common></source>"
         "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>" +
         primitives + "</mesh></geometry></library_geometries>";
}

inline std::string scene(const std::string& nodes = "<node><instance_geometry url='#g'/></node>") {
  return "<library_visual_scenes><visual_scene id='s'>" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>";
}

inline std::string document(const std::string& inside, const std::string& asset = "") {
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>" +
         asset + "</asset>" + inside + "</COLLADA>";
}

inline ColladaMesh readOrThrow(const std::string& bytes) {
  Result<ColladaMesh> mesh = readCollada(bytes);
  if (!mesh) throw std::runtime_error("not read: error " + std::string(mesh.error().code->id));
  return std::move(mesh).value();
}

inline Vec3 gridPoint(int i) {
  return {double(i % 3), double(i / 3), i / 10.0};
}

inline Vec3 areaVector(const TriangleSoup& soup) {
  Vec3 sum = Vec3::Zero();
  for (const Triangle& t : soup.triangles)
    sum += (soup.points[t[1]] - soup.points[t[0]]).cross(soup.points[t[2]] - soup.points[t[0]]) / 2;
  return sum;
}

}  // namespace handwheel::test
