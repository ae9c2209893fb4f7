// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/container/ZipReader.h"
#include "document/formats/MeshAssembly.h"

#include <map>

namespace handwheel {

// The archive of a 3MF file as an Open Packaging Conventions package (ECMA-376 part 2). Names of parts are
// case-insensitive. If a function returns false, reading must end, and the assembly has the reason.
class ThreeMfPackage {
 public:
  ThreeMfPackage(std::string_view archive, MeshAssembly& assembly, Progress progress);

  // Returns the total unpacked size of all model parts, as announced by the archive.
  std::uint64_t modelBytes() const;

  // Finds the part that the package's relationships name as the model. In a damaged file, finds the most likely part.
  bool findModel(std::string& name);

  // Reads the text of a part and checks that it is safe for Qt's XML reader. A damaged part is an error, or the
  // readable text before the damage if the assembly tolerates it.
  bool read(const std::string& name, std::string& text);

  // Returns the name of the archive's entry for a reference such as "/3D/Objects/a.model"; empty if there is no such
  // entry.
  std::string entryFor(std::string_view reference) const;

 private:
  bool readBytes(const std::string& name, std::string& bytes);

  ZipReader m_zip;
  MeshAssembly& m_assembly;
  Progress m_progress;                         // used for cancelling only
  std::map<std::string, std::string> m_names;  // entry names by their lower-case form
};

}  // namespace handwheel
