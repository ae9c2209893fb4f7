// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace handwheel {

// The kinds of errors that the library reports. The sentence for each is in widgets/text/ErrorText.cpp, with the
// arguments named below. An argument is empty where it is not known. {what} is an English plural noun ("facets",
// "vertices", "faces", "bytes", "lines", ...).
enum class ErrorCode {
  Cancelled,
  OutOfMemory,
  FileMissing,     // no such file
  FileUnreadable,  // {system's reason}
  FileEmpty,
  FileTooLarge,         // {what, count, limit}
  FormatUnknown,        // {ending...} content and name match no format; these are read
  ExtensionUnknown,     // {extension, ending...} no writer for it; these are written
  HeaderMalformed,      // {what was expected}
  TextEncoding,         // {encoding} not readable as text
  TokenUnexpected,      // {expected, found}; nothing found: the line or the file ends here
  NumberMalformed,      // {found}
  NumberNotFinite,      // {found}
  IndexOutOfRange,      // {index as written in the file, number of vertices}
  VertexUnreadable,     // {index as written in the file} a face needs a vertex that could not be read
  PolygonTooSmall,      // {corners}
  PolygonTooComplex,    // {corners} cut into triangles as if it were convex
  DataTruncated,        // {what, expected, found} the file ends too early
  CountMismatch,        // {what, announced, found}
  TypeUnknown,          // {type}
  NoTriangles,          // the file holds no triangle
  WriteFailed,          // {system's reason}
  CheckFailed,          // {what} the written file does not read back as what was to be written
  ArchiveMalformed,     // {library's reason} not a ZIP archive, or one that cannot be read at all
  EntryMissing,         // {name} an entry that the archive should hold
  EntryDamaged,         // {name} an entry that cannot be unpacked, or not to what its checksum says
  VersionNewer,         // {version of the file, newest version known} written by a newer program
  KindUnknown,          // {kind} a kind of document that this program does not know
  ElementMalformed,     // {element, what is wrong with it} in XML or JSON
  ReferenceMissing,     // {what, name} a file or an element that another refers to
  ValueOutOfRange,      // {name, value, least, largest}
  Unsupported,          // {what} understood, but not something that this program does
  PluginVersion,        // {interface that it was made for, the program's}
  PluginBroken,         // {reason}
  DeviceUnreachable,    // {system's reason}
  DeviceNotResponding,  // {what it should have answered}
  StepMalformed,        // {what is wrong, as a clause in English} in a step of 'handwheel edit'
  LibraryFailed,        // {library, reason}
};

// A position in the input. The byte offset in binary files, the line (from 1) in text files.
struct InputPosition {
  enum class Kind { None, Byte, Line };
  Kind kind = Kind::None;
  std::uint64_t value = 0;

  static InputPosition byte(std::uint64_t offset) { return {Kind::Byte, offset}; }
  static InputPosition line(std::uint64_t number) { return {Kind::Line, number}; }
};

// An error with its code, arguments and position in the input.
struct Error {
  ErrorCode code = ErrorCode::Cancelled;
  std::vector<std::string> arguments;
  InputPosition place;
  std::string subject;  // the file concerned, as the user named it; empty where there is none
};

}  // namespace handwheel
